// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_GUIDE_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_GUIDE_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How the border of a mesh guides a cross field: where it has corners, and which direction it has between them.
///
/// What counts is how the border turns within the surface: by pi minus the angle of the surface at a vertex. The noise of
/// a scanned rim, from vertex to vertex, is not to be followed: turns are summed up with weights that fall linearly
/// to zero over `reach` of the length of the curve to either side. Where that sum is largest, and larger than the corner angle,
/// there is a corner; its quarter turns are those next to the sum. What the border turns apart from its corners is spread
/// over the same reach: the direction of the border is that of its edge but for the difference of the two.
/// Neither depends on how many edges the border has.
class Border_guide {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// To either side, by the length of the curve.
  static constexpr double reach = 1. / 64;

  static constexpr int regular = 2;

  /// looks for the corners. \param corner_angle a border that turns less, in radians, has no corner there
  Border_guide(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry, const double corner_angle)
    : Border_guide(mesh, geometry)
  {
    for (const Curve& curve : m_curves)
      find_corners(curve, corner_angle);
    find_deviations();
  }

  /// takes the corners that are given. \param quarter_turns per vertex; what is inside does not matter
  Border_guide(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
               const std::vector<int>& quarter_turns)
    : Border_guide(mesh, geometry)
  {
    m_quarter_turns = quarter_turns;
    find_deviations();
  }

  /// Per vertex: the quarter turns of the angle of the surface, 2 inside and where there is no corner.
  const std::vector<int>& quarter_turns() const { return m_quarter_turns; }

  /// Per edge on the border: the angle, counter-clockwise, from the direction of its halfedge that has a face to the
  /// direction of the border. Not reduced to a quarter turn.
  const std::vector<double>& deviations() const { return m_deviation; }

private:
  // A curve with the surface on its left: the edge from vertex i to vertex i + 1 has number i.
  struct Curve {
    std::vector<Index> halfedges; // of the edges; they have faces
    std::vector<double> place;    // along the curve, of the vertices
    double length = 0;
  };

  Border_guide(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
    : m_mesh(mesh),
      m_quarter_turns(mesh.number_of_vertices(), regular),
      m_turn(mesh.number_of_vertices(), CGAL_PI),
      m_deviation(mesh.number_of_edges(), 0.)
  {
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      m_turn[mesh.target(h)] -= geometry.m_corner_angle[h];
    for (const std::vector<Index>& border : border_curves(mesh)) {
      Curve curve;
      for (auto h = border.rbegin(); h != border.rend(); ++h) {
        curve.halfedges.push_back(opposite(*h));
        curve.place.push_back(curve.length);
        curve.length += geometry.m_edge_length[edge_of(*h)];
      }
      m_curves.push_back(std::move(curve));
    }
  }

  Index vertex(const Curve& curve, const std::size_t i) const { return m_mesh.source(curve.halfedges[i]); }

  // Calls visit(j, weight) for the vertices j within reach of vertex i, itself among them.
  template <typename Visit>
  static void for_each_in_reach(const Curve& curve, const std::size_t i, const Visit& visit)
  {
    const std::size_t n = curve.halfedges.size();
    const double radius = reach * curve.length;
    visit(i, 1.);
    for (const bool is_ahead : {true, false}) {
      double distance = 0;
      for (std::size_t k = 1; k < n; ++k) {
        const std::size_t j = is_ahead ? (i + k) % n : (i + n - k) % n, before = is_ahead ? (j + n - 1) % n : j;
        const double next_place = before + 1 < n ? curve.place[before + 1] : curve.length;
        distance += next_place - curve.place[before];
        if (distance >= radius)
          break;
        visit(j, 1 - distance / radius);
      }
    }
  }

  // By how much the border turns near vertex i, apart from the corners that are known.
  double turn_near(const Curve& curve, const std::size_t i) const
  {
    double result = 0;
    for_each_in_reach(curve, i, [&](const std::size_t j, const double weight) {
      result += weight * turn_without_corner(vertex(curve, j));
    });
    return result;
  }

  double turn_without_corner(const Index v) const { return m_turn[v] - (regular - m_quarter_turns[v]) * (CGAL_PI / 2); }

  // The sharpest corner first: it takes its quarter turns from what is near it.
  void find_corners(const Curve& curve, const double corner_angle)
  {
    std::vector<double> turn(curve.halfedges.size());
    for (std::size_t i = 0; i < turn.size(); ++i)
      turn[i] = turn_near(curve, i);
    while (true) {
      const auto sharpest = std::max_element(turn.begin(), turn.end(),
                                             [](const double a, const double b) { return std::abs(a) < std::abs(b); });
      const std::size_t i = static_cast<std::size_t>(sharpest - turn.begin());
      const int quarters = static_cast<int>(std::lround(*sharpest / (CGAL_PI / 2)));
      int& k = m_quarter_turns[vertex(curve, i)];
      const int next = (std::max)(1, k - quarters);
      if (std::abs(*sharpest) <= corner_angle || next == k)
        return;
      k = next;
      for_each_in_reach(curve, i, [&](const std::size_t j, double) { turn[j] = turn_near(curve, j); });
    }
  }

  // Of a direction that turns by an eighth of a turn or more from edge to edge, nobody knows which way.
  static constexpr double largest_turn_at_vertex = 0.99 * CGAL_PI / 4, spread_turn_at_vertex = CGAL_PI / 6;

  // Where a sharp turn must not be a corner and its reach has too few vertices. The two edges of a face have one direction.
  void spread_over_vertices(const Curve& curve, const std::size_t i, const double turn,
                            std::vector<double>& spread) const
  {
    const std::size_t n = spread.size(), most_to_a_side = (n - 1) / 2;
    const bool is_in_one_face = m_mesh.face(curve.halfedges[i]) == m_mesh.face(curve.halfedges[(i + n - 1) % n]);
    const double wanted = std::ceil(std::abs(turn) / spread_turn_at_vertex);
    const double to_a_side = std::ceil((wanted - (is_in_one_face ? 0 : 1)) / 2);
    const std::size_t side = (std::min)(static_cast<std::size_t>(to_a_side), most_to_a_side);
    const double share = turn / static_cast<double>(2 * side + (is_in_one_face && side > 0 ? 0 : 1));
    for (std::size_t k = is_in_one_face && side > 0 ? 1 : 0; k <= side; ++k) {
      spread[(i + k) % n] += share;
      if (k > 0)
        spread[(i + n - k) % n] += share;
    }
  }

  void find_deviations()
  {
    for (const Curve& curve : m_curves) {
      const std::size_t n = curve.halfedges.size();
      std::vector<double> spread(n, 0.);
      for (std::size_t i = 0; i < n; ++i) {
        const double whole = turn_without_corner(vertex(curve, i));
        double total = 0;
        for_each_in_reach(curve, i, [&](std::size_t, const double weight) { total += weight; });
        const double turn = whole / total;
        if (std::abs(turn) > largest_turn_at_vertex)
          spread_over_vertices(curve, i, whole, spread);
        else
          for_each_in_reach(curve, i, [&](const std::size_t j, const double weight) { spread[j] += weight * turn; });
      }
      double deviation = 0, mean = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double end = i + 1 < n ? curve.place[i + 1] : curve.length;
        deviation += spread[i] - turn_without_corner(vertex(curve, i));
        m_deviation[edge_of(curve.halfedges[i])] = deviation;
        mean += deviation * (end - curve.place[i]) / curve.length;
      }
      for (const Index h : curve.halfedges)
        m_deviation[edge_of(h)] -= mean;
    }
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<Curve> m_curves;
  std::vector<int> m_quarter_turns; // per vertex
  std::vector<double> m_turn;       // per vertex
  std::vector<double> m_deviation;  // per edge
};

/// The guide of a mesh whose corners are those of the named parameter `corners`, or else where the border turns by more
/// than `corner_angle`. \pre `check_given_corners()` finds nothing
template <typename TriangleMesh, typename NamedParameters>
Border_guide border_guide(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                          const Triangle_geometry& geometry, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto corners = given_corners<TriangleMesh>(np);
  if (!corners) {
    const double degrees = choose_parameter(get_parameter(np, np_tags::corner_angle), default_corner_angle);
    return Border_guide(mesh, geometry, degrees * (CGAL_PI / 180));
  }
  std::vector<int> quarter_turns(indexing.number_of_vertices(), Border_guide::regular);
  for (const auto& [vertex, k] : *corners)
    quarter_turns[indexing.vertex_index(vertex)] = k;
  return Border_guide(mesh, geometry, quarter_turns);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_GUIDE_H
