// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_WALKER_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_WALKER_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Lines_in_faces.h>
#include <CGAL/T_splines/Tracing/internal/Number_pool.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Walks given lengths along the isolines of a seamless map.
///
/// A walker stands at a point and looks along an isoline: at a vertex it looks along a ray of its star, elsewhere along
/// a direction in the chart of a face whose closure has the point. It carries a unit of length with it.
template <typename FT, typename TracingTraits>
class Isoline_walker {
  using Layout = Seamless_layout<FT>;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Lines = Lines_in_faces<FT, TracingTraits>;
  using Gate = typename Lines::Gate;
  using Number = Enclosed_number<FT>;

public:
  using Point_3 = std::array<double, 3>;
  static constexpr int none = -1;

  struct Stand {
    int star = none, slot = none;      ///< at a vertex
    int face = none, direction = none; ///< elsewhere
    std::array<FT, 2> point = {};      ///< elsewhere: in the chart of the face
    FT unit = FT(1);                   ///< the length of the unit in the chart of the ray or of the face
  };

  /// \param points of the vertices
  Isoline_walker(const Layout& layout, const std::vector<Point_3>& points, const TracingTraits& traits)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_lines(layout, traits),
      m_stars(layout, traits),
      m_points(layout, points)
  {
  }

  /// A walker at a point of the closure of a face; at a vertex, it looks along the ray that comes first, clockwise, from
  /// the corner of the face and that has the direction in its chart.
  Stand stand_in_face(const int face, const std::array<FT, 2>& point, const int direction, const FT& unit)
  {
    int h = m_mesh.halfedge_of_face(face);
    for (int i = 0; i < 3; ++i, h = m_mesh.next(h))
      if (m_layout.coordinate(h, 0).value() == point[0] && m_layout.coordinate(h, 1).value() == point[1])
        return stand_in_corner(m_mesh.next(h), direction, unit);
    Stand stand;
    stand.face = face;
    stand.direction = direction;
    stand.point = point;
    stand.unit = unit;
    return stand;
  }

  /// Turns counter-clockwise, or clockwise if the number is negative. The unit goes from chart to chart.
  void turn(Stand& stand, const int quarter_turns) const
  {
    if (stand.star == none) {
      stand.direction = turned(stand.direction, quarter_turns);
      return;
    }
    const int n = m_stars.star(stand.star).number_of_rays;
    for (int i = 0; i < quarter_turns; ++i) {
      stand.slot = (stand.slot + 1) % n;
      m_stars.for_each_scale_clockwise(stand.star, stand.slot, [&](const FT& scale) { stand.unit /= scale; });
    }
    for (int i = 0; i > quarter_turns; --i) {
      m_stars.for_each_scale_clockwise(stand.star, stand.slot, [&](const FT& scale) { stand.unit *= scale; });
      stand.slot = m_stars.next_slot_clockwise(stand.star, stand.slot);
    }
  }

  Point_3 point(const Stand& stand) const
  {
    if (stand.star != none)
      return m_points.of_vertex(m_stars.star(stand.star).vertex);
    Number_pool<FT> numbers;
    return m_points.in_face(stand.face, numbers.store(stand.point[0]), numbers.store(stand.point[1]));
  }

  /// The vertex where the walker stands, or none.
  int vertex(const Stand& stand) const { return stand.star == none ? none : m_stars.star(stand.star).vertex; }

  /// Walks, and turns around at the end.
  /// \param length in the walker's units
  /// \param polyline the points passed are appended, without the first and with the last one
  /// \return false if the way leads beyond a cone or a border
  bool walk(Stand& stand, const FT& length, std::vector<Point_3>& polyline)
  {
    Number_pool<FT> numbers;
    Step step;
    set_out(stand, numbers, step, length * stand.unit);
    while (true) {
      const Gate exit = m_lines.exit_of(step.face, step.direction, step.line, step.entry);
      if (exit.kind == Gate::Kind::INSIDE)
        return false;
      if (exit.kind == Gate::Kind::EDGE) {
        if (!m_lines.is_beyond_gate(exit, step.direction, step.line, step.end)) {
          arrive_in_face(stand, step);
          polyline.push_back(point(stand));
          return true;
        }
        polyline.push_back(
            m_points.on_edge(exit.halfedge, m_points.parameter_on_edge(exit.halfedge, step.line, step.direction)));
        if (m_mesh.face(opposite(exit.halfedge)) == none)
          return false;
        cross(exit.halfedge, numbers, step);
        continue;
      }
      const Number at_vertex = m_layout.coordinate(exit.halfedge, axis_along(step.direction));
      if (m_lines.is_ahead(step.direction, step.end, at_vertex)) {
        arrive_in_face(stand, step);
        polyline.push_back(point(stand));
        return true;
      }
      const FT end = step.end.value(), here = at_vertex.value();
      const FT units = (is_forward(step.direction) ? FT(end - here) : FT(here - end)) / step.unit;
      if (!arrive_at_vertex(stand, step, exit.halfedge))
        return false;
      polyline.push_back(point(stand));
      if (units == FT(0))
        return true;
      if (!is_regular(stand))
        return false;
      turn_around(stand);
      set_out(stand, numbers, step, units * stand.unit);
    }
  }

private:
  /// A line in a face, from where it comes in to the end of the way.
  struct Step {
    int face = none, direction = 0;
    Number line, end; ///< the constant coordinate; the other coordinate of the end
    Gate entry = {Gate::Kind::INSIDE, none, {}};
    FT unit = FT(1);
  };

  bool is_regular(const Stand& stand) const
  {
    const auto& star = m_stars.star(stand.star);
    return star.is_on_border ? star.number_of_rays == 3 && stand.slot != 1 : star.number_of_rays == 4;
  }

  Stand stand_in_corner(int h, int direction, const FT& unit)
  {
    Stand stand;
    stand.star = m_stars.star_of_vertex(m_mesh.source(h));
    stand.unit = unit;
    while (true) {
      for (stand.slot = m_stars.star(stand.star).number_of_rays - 1; stand.slot >= 0; --stand.slot)
        if (m_stars.ray(stand.star, stand.slot).halfedge == h &&
            m_stars.ray(stand.star, stand.slot).direction == direction)
          return stand;
      direction = turned(direction, m_layout.rotation(h));
      if (m_layout.is_cut(edge_of(h)))
        stand.unit *= m_layout.transition(h).scale();
      h = m_mesh.next(opposite(h));
    }
  }

  /// \param length in the chart of the ray or face
  void set_out(const Stand& stand, Number_pool<FT>& numbers, Step& step, const FT& length)
  {
    step.unit = stand.unit;
    FT start;
    if (stand.star == none) {
      step.face = stand.face;
      step.direction = stand.direction;
      step.line = numbers.store(stand.point[axis_across(stand.direction)]);
      start = stand.point[axis_along(stand.direction)];
    }
    else {
      const int corner = m_stars.corner_of_ray(stand.star, stand.slot);
      step.face = m_mesh.face(corner);
      step.direction = m_stars.ray(stand.star, stand.slot).direction;
      step.line = m_layout.coordinate(corner, axis_across(step.direction));
      start = m_layout.coordinate(corner, axis_along(step.direction)).value();
    }
    step.end = numbers.store(is_forward(step.direction) ? FT(start + length) : FT(start - length));
    step.entry = {Gate::Kind::INSIDE, none, numbers.store(start)};
  }

  void cross(const int h, Number_pool<FT>& numbers, Step& step)
  {
    const auto [line, direction] = line_across_edge(m_layout, numbers, h, step.line, step.direction);
    if (m_layout.is_cut(edge_of(h))) {
      const Similarity_2<FT>& transition = m_layout.transition(h);
      step.end = numbers.store(transformed_coordinate(transition, step.direction, step.end.value()));
      step.unit *= transition.scale();
    }
    step.line = line;
    step.direction = direction;
    step.face = m_mesh.face(opposite(h));
    step.entry = {Gate::Kind::EDGE, opposite(h), {}};
  }

  void arrive_in_face(Stand& stand, const Step& step) const
  {
    stand.star = stand.slot = none;
    stand.face = step.face;
    stand.direction = turned(step.direction, 2);
    stand.unit = step.unit;
    stand.point[axis_along(step.direction)] = step.end.value();
    stand.point[axis_across(step.direction)] = step.line.value();
  }

  /// On the border, the way goes on along it.
  void turn_around(Stand& stand) const
  {
    turn(stand, m_stars.star(stand.star).is_on_border && stand.slot == 2 ? -2 : 2);
  }

  /// Stands at the target of h, which the line of a step in h's face reaches, and looks back.
  bool arrive_at_vertex(Stand& stand, const Step& step, const int h)
  {
    stand.star = m_stars.star_of_vertex(m_mesh.target(h));
    stand.face = stand.direction = none;
    stand.unit = step.unit;
    const int back = turned(step.direction, 2), out = m_mesh.next(h);
    for (stand.slot = 0; stand.slot < m_stars.star(stand.star).number_of_rays; ++stand.slot) {
      const Vertex_ray& ray = m_stars.ray(stand.star, stand.slot);
      if (ray.halfedge == out && ray.direction == back)
        return true;
      const int rotation = m_mesh.face(opposite(h)) == none ? 0 : m_layout.rotation(h);
      if (ray.halfedge == opposite(h) && ray.is_along && ray.direction == turned(back, rotation)) {
        if (m_layout.is_cut(edge_of(h)))
          stand.unit *= m_layout.transition(h).scale();
        return true;
      }
    }
    return false;
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  Lines m_lines;
  Stars m_stars;
  Chart_points<FT> m_points;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_WALKER_H
