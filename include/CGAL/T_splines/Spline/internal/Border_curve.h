// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_BORDER_CURVE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_BORDER_CURVE_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/closest_of_triangle.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A rational cubic curve, or a part of one.
struct Cubic_arc {
  using Point_3 = Triangle_set::Point_3;
  using Homogeneous = std::array<double, 4>;

  std::array<Homogeneous, 4> controls; ///< (w x, w y, w z, w)
  std::size_t curve;                   ///< the number of the whole curve
  double begin = 0, end = 1;           ///< the parameters in that

  static Point_3 point(const Homogeneous& h) { return Point_3(h[0] / h[3], h[1] / h[3], h[2] / h[3]); }
  Point_3 source() const { return point(controls[0]); }
  Point_3 target() const { return point(controls[3]); }
  bool has_positive_weights() const
  {
    return std::all_of(controls.begin(), controls.end(), [](const Homogeneous& h) { return h[3] > 0; });
  }

  /// That of the control polygon: the arc is not longer. That of the chord if weights are not positive.
  double length() const
  {
    if (!has_positive_weights())
      return std::sqrt(CGAL::squared_distance(source(), target()));
    double result = 0;
    for (int i = 0; i < 3; ++i)
      result += std::sqrt(CGAL::squared_distance(point(controls[i]), point(controls[i + 1])));
    return result;
  }

  /// No point of the arc is farther from its chord, and no point of the chord farther from the arc: the arc lies in the
  /// convex hull of its control points, and some point of it is projected to each one of the chord. Infinite unless all
  /// weights are positive.
  double sagitta() const
  {
    if (!has_positive_weights())
      return std::numeric_limits<double>::infinity();
    const Point_3 a = source(), b = target();
    double largest = 0;
    for (const int i : {1, 2}) {
      const Point_3 p = point(controls[i]);
      largest = (std::max)(largest, CGAL::squared_distance(p, closest_of_segment(p, a, b)));
    }
    return std::sqrt(largest);
  }

  /// De Casteljau's algorithm at the middle.
  std::array<Cubic_arc, 2> halves() const
  {
    std::array<Cubic_arc, 2> result{*this, *this};
    result[0].end = result[1].begin = begin + (end - begin) / 2;
    for (int k = 3; k >= 0; --k) {
      result[0].controls[3 - k] = result[1].controls[0];
      for (int i = 0; i < k; ++i)
        for (int x = 0; x < 4; ++x)
          result[1].controls[i][x] = (result[1].controls[i][x] + result[1].controls[i + 1][x]) / 2;
    }
    return result;
  }
};

/// The part of the border of a T-spline surface along one patch: an isoline of the patch, so a rational cubic curve.
struct Border_curve {
  int halfedge, face, side; ///< the halfedge of the face
  double begin, end;        ///< distances from where the side begins
  Cubic_arc arc;
};

/// The part of a curve between two parameters.
inline Cubic_arc restricted(const Cubic_arc& arc, const double begin, const double end)
{
  Cubic_arc result = arc;
  for (int k = 0; k < 4; ++k) {
    std::array<Cubic_arc::Homogeneous, 4> c = arc.controls;
    for (int level = 1; level <= 3; ++level) {
      const double x = level <= k ? end : begin; // the blossom at k times `end` and 3 - k times `begin`
      for (int i = 0; i + level < 4; ++i)
        for (int j = 0; j < 4; ++j)
          c[i][j] = (1 - x) * c[i][j] + x * c[i + 1][j];
    }
    result.controls[k] = c[0];
  }
  return result;
}

/// The curve along side `side` of a patch, counter-clockwise.
template <typename Patch>
Cubic_arc side_of_patch(const Patch& patch, const int side, const std::size_t number)
{
  Cubic_arc arc;
  arc.curve = number;
  for (int k = 0; k < 4; ++k) {
    const int along = side < 2 ? k : 3 - k, across = side == 1 || side == 2 ? 3 : 0;
    const auto& h =
        side % 2 == 0 ? patch.homogeneous_control_point(along, across) : patch.homogeneous_control_point(across, along);
    for (int x = 0; x < 4; ++x)
      arc.controls[k][x] = CGAL::to_double(h[x]);
  }
  return arc;
}

/// Which curves of a surface are meant.
enum class Curve_kind { BORDER, CREASE, BORDER_OR_CREASE };

/// The curves that are the border of a surface, or its creases: these come twice, from both sides.
/// \param surface a `Compiled_T_spline`
template <typename Compiled>
std::vector<Border_curve> border_curves(const Compiled& surface, const Curve_kind kind = Curve_kind::BORDER)
{
  const auto& t_mesh = surface.t_mesh_arrays();
  std::vector<Border_curve> curves;
  // Those along the part [begin, end] of a side, which a patch covers.
  const auto add = [&](const std::size_t patch, const int face, const int side, const double begin, const double end) {
    const double eps = same_point * CGAL::to_double(t_mesh.side_length(face, side));
    for (int h = t_mesh.first_of_side(face, side);; h = t_mesh.next(h)) {
      const double from = (std::max)(begin, CGAL::to_double(t_mesh.begin(h))),
                   to = (std::min)(end, CGAL::to_double(t_mesh.end(h)));
      const bool is_meant = t_mesh.is_border(t_mesh.opposite(h)) ? kind != Curve_kind::CREASE
                                                                 : t_mesh.is_crease(h) && kind != Curve_kind::BORDER;
      if (is_meant && to - from > eps) {
        Cubic_arc arc = side_of_patch(surface.patch(patch), side, curves.size());
        const bool is_whole = from - begin <= eps && end - to <= eps;
        if (!is_whole)
          arc = restricted(arc, (from - begin) / (end - begin), (to - begin) / (end - begin));
        curves.push_back({h, face, side, from, to, arc});
      }
      if (t_mesh.is_corner(h))
        break;
    }
  };
  for (std::size_t i = 0; i < surface.number_of_patches(); ++i) {
    const auto domain = surface.domain(i);
    const int face = surface.indexing().face_index(domain.face);
    const double width = CGAL::to_double(t_mesh.width(face)), height = CGAL::to_double(t_mesh.height(face));
    const std::array<double, 2> u{CGAL::to_double(domain.u_begin), CGAL::to_double(domain.u_end)},
        v{CGAL::to_double(domain.v_begin), CGAL::to_double(domain.v_end)};
    if (v[0] <= same_point * height)
      add(i, face, 0, u[0], u[1]);
    if (width - u[1] <= same_point * width)
      add(i, face, 1, v[0], v[1]);
    if (height - v[1] <= same_point * height)
      add(i, face, 2, width - u[1], width - u[0]);
    if (u[0] <= same_point * width)
      add(i, face, 3, height - v[1], height - v[0]);
  }
  return curves;
}

/// Divides curves into arcs that are nearly straight.
/// \param sagitta the largest one that is allowed; no curve is halved more than ten times, though
inline std::vector<Cubic_arc> flat_arcs(const std::vector<Border_curve>& curves, const double sagitta)
{
  constexpr double shortest = 1. / 1024;
  std::vector<Cubic_arc> result, stack;
  for (const Border_curve& curve : curves) {
    stack.push_back(curve.arc);
    while (!stack.empty()) {
      const Cubic_arc arc = stack.back();
      stack.pop_back();
      if (arc.end - arc.begin <= shortest || arc.sagitta() <= sagitta) {
        result.push_back(arc);
        continue;
      }
      const auto halves = arc.halves();
      stack.push_back(halves[1]); // the first one is next
      stack.push_back(halves[0]);
    }
  }
  return result;
}

/// The parameter and point of a flat arc that is closest to p, to round-off.
inline std::pair<double, Triangle_set::Point_3> closest_of_arc(const Triangle_set::Point_3& p, Cubic_arc arc)
{
  constexpr int number_of_halvings = 50;
  const auto distance = [&](const Cubic_arc& a) {
    return CGAL::squared_distance(p, closest_of_segment(p, a.source(), a.target()));
  };
  for (int i = 0; i < number_of_halvings; ++i) {
    const auto halves = arc.halves();
    arc = distance(halves[0]) <= distance(halves[1]) ? halves[0] : halves[1];
  }
  return {arc.begin, arc.source()};
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_BORDER_CURVE_H
