// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CHORD_ERRORS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CHORD_ERRORS_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Spline/internal/Bezier_part.h>
#include <CGAL/T_splines/Spline/internal/Parameter_correction.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How far a surface is, at most, from triangles of three of its points: by bounds of its second derivatives where the
/// three are in one face, or in faces that are next to each other and have no extraordinary vertex. There the T-mesh is
/// developed into the frame of one of the faces, as far as the bounding box of the three places reaches.
template <typename FT>
class Chord_errors {
  using Arrays = T_mesh_arrays<FT>;
  using Place = Indexed_place<FT>;
  using Point = std::pair<FT, FT>;

public:
  explicit Chord_errors(const Arrays& t_mesh)
    : m_t_mesh(t_mesh),
      m_bounds(t_mesh.number_of_faces(), Derivative_bounds{0, 0, 0, 0, 0}),
      m_has_cap(t_mesh.number_of_faces(), false)
  {
  }

  /// Takes a patch into account. \param b with respect to u and v of the face
  void add_patch(const int face, const Derivative_bounds& b, const bool is_cap)
  {
    Derivative_bounds& bounds = m_bounds[face];
    bounds.ss = (std::max)(bounds.ss, b.ss);
    bounds.st = (std::max)(bounds.st, b.st);
    bounds.tt = (std::max)(bounds.tt, b.tt);
    m_has_cap[face] = m_has_cap[face] || is_cap;
  }

  /// The error; infinite where nothing is known.
  double operator()(const std::array<Place, 3>& places) const
  {
    if (places[0].face == places[1].face && places[0].face == places[2].face)
      return m_bounds[places[0].face].chord_error(range({places[0].u, places[1].u, places[2].u}),
                                                  range({places[0].v, places[1].v, places[2].v}));
    for (int base = 0; base < 3; ++base) {
      std::array<Point, 3> points;
      bool is_developed = true;
      for (int i = 0; i < 3 && is_developed; ++i)
        is_developed = develop(places[base].face, places[i], points[i]);
      if (is_developed)
        return error_in_box(places, base, points);
    }
    return infinite;
  }

private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  struct Box {
    FT u_begin, u_end, v_begin, v_end;
  };

  // A face and its place in the frame of another one.
  struct Copy {
    int face;
    Similarity_2<FT> to_base;
  };

  static double range(const std::array<FT, 3>& x)
  {
    return CGAL::to_double(FT((std::max)({x[0], x[1], x[2]}) - (std::min)({x[0], x[1], x[2]})));
  }

  // The coordinates of a place in the frame of a face, if that is its own or a neighbour.
  bool develop(const int face, const Place& place, Point& result) const
  {
    if (place.face == face) {
      result = {place.u, place.v};
      return true;
    }
    const int first = m_t_mesh.first_of_side(face, 0);
    int h = first;
    do {
      const int o = Arrays::opposite(h);
      if (!m_t_mesh.is_border(o) && m_t_mesh.face(o) == place.face) {
        result = m_t_mesh.transition(o)(place.u, place.v);
        return true;
      }
      h = m_t_mesh.next(h);
    } while (h != first);
    return false;
  }

  static Box box_of(const std::array<Point, 3>& p)
  {
    return {(std::min)({p[0].first, p[1].first, p[2].first}), (std::max)({p[0].first, p[1].first, p[2].first}),
            (std::min)({p[0].second, p[1].second, p[2].second}), (std::max)({p[0].second, p[1].second, p[2].second})};
  }

  static Box image(const Similarity_2<FT>& map, const Box& box)
  {
    const Point a = map(box.u_begin, box.v_begin), b = map(box.u_end, box.v_end);
    return {(std::min)(a.first, b.first), (std::max)(a.first, b.first), (std::min)(a.second, b.second),
            (std::max)(a.second, b.second)};
  }

  // All faces that a box in the frame of a base face meets, developed; it must not meet one twice, and the places must
  // be where they were taken to be.
  double error_in_box(const std::array<Place, 3>& places, const int base, const std::array<Point, 3>& points) const
  {
    constexpr std::size_t largest_number = 12;
    const Box box = box_of(points);
    std::array<Copy, largest_number> copies;
    std::size_t size = 0;
    copies[size++] = {places[base].face, Similarity_2<FT>()};
    Derivative_bounds bounds{0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < size; ++i) {
      const Copy copy = copies[i];
      if (m_has_cap[copy.face])
        return infinite;
      add(copy, bounds);
      const Box local = image(copy.to_base.inverse(), box);
      const std::array<bool, 4> is_crossed{local.v_begin<FT(0), local.u_end> m_t_mesh.width(copy.face),
                                           local.v_end > m_t_mesh.height(copy.face), local.u_begin < FT(0)};
      for (int side = 0; side < 4; ++side)
        if (is_crossed[side] && !cross(copy, side, local, copies, size))
          return infinite;
    }
    for (int k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < size; ++i)
        if (copies[i].face == places[k].face &&
            !is_same(copies[i].to_base(places[k].u, places[k].v), points[k],
                     (std::max)(FT(box.u_end - box.u_begin), FT(box.v_end - box.v_begin))))
          return infinite;
    return bounds.chord_error(CGAL::to_double(FT(box.u_end - box.u_begin)),
                              CGAL::to_double(FT(box.v_end - box.v_begin)));
  }

  void add(const Copy& copy, Derivative_bounds& bounds) const
  {
    const Derivative_bounds& own = m_bounds[copy.face];
    const double scale = CGAL::to_double(copy.to_base.scale()), factor = 1 / (scale * scale);
    const bool is_turned = copy.to_base.quarter_turns() % 2 != 0;
    bounds.ss = (std::max)(bounds.ss, factor * (is_turned ? own.tt : own.ss));
    bounds.tt = (std::max)(bounds.tt, factor * (is_turned ? own.ss : own.tt));
    bounds.st = (std::max)(bounds.st, factor * own.st);
  }

  // Adds the faces beyond a side where the box is. \return whether they exist, and there are not too many
  template <typename Copies>
  bool cross(const Copy& copy, const int side, const Box& local, Copies& copies, std::size_t& size) const
  {
    const FT length = m_t_mesh.side_length(copy.face, side);
    FT begin = side % 2 == 0 ? local.u_begin : local.v_begin, end = side % 2 == 0 ? local.u_end : local.v_end;
    if (side >= 2)
      std::tie(begin, end) = std::make_pair(FT(length - end), FT(length - begin));
    for (int h = m_t_mesh.first_of_side(copy.face, side);; h = m_t_mesh.next(h)) {
      if (m_t_mesh.begin(h) <= end && m_t_mesh.end(h) >= begin) {
        const int o = Arrays::opposite(h);
        if (m_t_mesh.is_border(o))
          return false;
        const Copy next{m_t_mesh.face(o), compose(copy.to_base, m_t_mesh.transition(o))};
        const auto known = std::find_if(copies.begin(), copies.begin() + size,
                                        [&](const Copy& other) { return other.face == next.face; });
        if (known == copies.begin() + size) {
          if (size == copies.size())
            return false;
          copies[size++] = next;
        }
        else if (!is_same(known->to_base(FT(0), FT(0)), next.to_base(FT(0), FT(0)),
                          m_t_mesh.width(copy.face) * copy.to_base.scale()))
          return false;
      }
      if (m_t_mesh.is_corner(h))
        return true;
    }
  }

  static bool is_same(const Point& a, const Point& b, const FT& size)
  {
    const FT tolerance = FT(summed_round_off) * size;
    return CGAL::abs(FT(a.first - b.first)) <= tolerance && CGAL::abs(FT(a.second - b.second)) <= tolerance;
  }

  const Arrays& m_t_mesh;
  std::vector<Derivative_bounds> m_bounds; // per face; those of the second derivatives
  std::vector<bool> m_has_cap;             // per face
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CHORD_ERRORS_H
