// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_ORIENTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_ORIENTATION_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The orientation of three points with double coordinates, exactly.
inline CGAL::Orientation uv_orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                                        const std::array<double, 2>& c)
{
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  const double determinant = left - right;
  // (3 + 16 epsilon) epsilon, epsilon = 2^-53 (Shewchuk 1997), and what underflow may add.
  constexpr double relative_error = 3.4e-16, underflow = 1e-300;
  const double bound = relative_error * (std::abs(left) + std::abs(right)) + underflow;
  if (determinant > bound)
    return CGAL::POSITIVE;
  if (determinant < -bound)
    return CGAL::NEGATIVE;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return CGAL::orientation(Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]), Kernel::Point_2(c[0], c[1]));
}

/// The faces with coordinates that are not finite, or that are not positively oriented. \param uv per halfedge
inline std::vector<int> faces_not_positive(const Triangulation_connectivity& mesh,
                                           const std::vector<std::array<double, 2>>& uv)
{
  std::vector<int> result;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const int h = mesh.halfedge_of_face(f), j = mesh.next(h), k = mesh.next(j);
    bool is_finite = true;
    for (const int corner : {h, j, k})
      is_finite = is_finite && std::isfinite(uv[corner][0]) && std::isfinite(uv[corner][1]);
    if (!is_finite || uv_orientation(uv[h], uv[j], uv[k]) != CGAL::POSITIVE)
      result.push_back(f);
  }
  return result;
}

/// The orientation in a layout of the face of `h`, exactly; for an inexact number type, of its corners as they are
/// stored.
template <typename FT>
CGAL::Orientation uv_orientation(const Seamless_layout<FT>& layout, const int h)
{
  const int j = layout.mesh().next(h), k = layout.mesh().next(j);
  if (layout.is_double(h) && layout.is_double(j) && layout.is_double(k))
    return uv_orientation(layout.uv(h), layout.uv(j), layout.uv(k));
  using Interval = CGAL::Interval_nt<>;
  const auto interval = [&layout](const int corner, const int axis) {
    const Enclosed_number<FT> x = layout.coordinate(corner, axis);
    return Interval(x.lower, x.upper);
  };
  const auto determinant = [&](const auto& at) {
    using Number = decltype(at(h, 0));
    const Number u = at(h, 0), v = at(h, 1);
    return Number(Number(Number(at(j, 0) - u) * Number(at(k, 1) - v)) -
                  Number(Number(at(j, 1) - v) * Number(at(k, 0) - u)));
  };
  const Interval filtered = determinant(interval);
  if (filtered.inf() > 0)
    return CGAL::POSITIVE;
  if (filtered.sup() < 0)
    return CGAL::NEGATIVE;
  const auto value = [&layout](const int corner, const int axis) -> FT {
    return layout.coordinate(corner, axis).value();
  };
  return CGAL::sign(determinant(value));
}

/// The sign of the difference of two coordinates, exactly.
template <typename FT>
CGAL::Sign compare(const Enclosed_number<FT>& a, const Enclosed_number<FT>& b)
{
  if (const auto order = filtered_comparison(a, b))
    return *order;
  return CGAL::sign(FT(a.value() - b.value()));
}

/// Where the halfedge `h` points to in the chart of its face: 0, 2, 4, 6 along +u, +v, -u, -v, odd numbers between.
template <typename FT>
int uv_octant(const Seamless_layout<FT>& layout, const int h)
{
  const int before = layout.mesh().previous(h);
  const auto sign = [&](const int axis) -> int {
    if (layout.is_double(h) && layout.is_double(before)) {
      const double x = layout.uv(h)[axis], y = layout.uv(before)[axis];
      return (x > y) - (x < y);
    }
    return compare(layout.coordinate(h, axis), layout.coordinate(before, axis));
  };
  constexpr int octant[3][3] = {{5, 4, 3}, {6, 0, 2}, {7, 0, 1}};
  return octant[sign(0) + 1][sign(1) + 1];
}

/// The same for corners in doubles.
inline int uv_octant(const std::array<double, 2>& from, const std::array<double, 2>& to)
{
  constexpr int octant[3][3] = {{5, 4, 3}, {6, 0, 2}, {7, 0, 1}};
  return octant[(to[0] > from[0]) - (to[0] < from[0]) + 1][(to[1] > from[1]) - (to[1] < from[1]) + 1];
}

/// Adds the angles of the corners of a face, times a sign, to those of its vertices: in quarter turns, as the number of
/// axes in the sectors of the corners.
/// \param octant function object: halfedge -> octant
template <typename Octant>
void add_quarter_turns(const Triangulation_connectivity& mesh, const int f, const Octant& octant, const int sign,
                       std::vector<int>& result)
{
  // Axes in the sector from one octant on, up to another but without it.
  const auto axes = [](const int from, const int to) { return (((to + 8 - from) & 7) + (from & 1 ? 0 : 1)) / 2; };
  const int h = mesh.halfedge_of_face(f), j = mesh.next(h), k = mesh.next(j);
  const int a = octant(h), b = octant(j), c = octant(k);
  result[mesh.target(h)] += sign * axes(b, (a + 4) & 7);
  result[mesh.target(j)] += sign * axes(c, (b + 4) & 7);
  result[mesh.target(k)] += sign * axes(a, (c + 4) & 7);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_ORIENTATION_H
