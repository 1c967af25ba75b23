// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_DIVISIONS_OF_FACES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_DIVISIONS_OF_FACES_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/Tessellation_resolution.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The largest second differences of the control points of a patch along its normal, as derivatives with respect to its own
/// parameters in [0, 1], the mixed one divided among both: a triangle over a cell of the size a x b is about (first a^2 +
/// second b^2) / 8 away from the patch, where its weights are equal and its normal does not turn far. What second
/// derivatives have along the patch moves points within it.
template <typename Kernel>
std::array<double, 2> bending_of_patch(const Bezier_patch_3<Kernel>& patch)
{
  const auto p = [&](const int i, const int j) { return patch.control_point(i, j); };
  const auto normal =
      CGAL::cross_product((p(3, 0) - p(0, 0)) + (p(3, 3) - p(0, 3)), (p(0, 3) - p(0, 0)) + (p(3, 3) - p(3, 0)));
  const double length = std::sqrt(CGAL::to_double(normal.squared_length()));
  const auto size = [&](const auto& difference) {
    return length > 0 ? std::abs(CGAL::to_double(difference * normal)) / length
                      : std::sqrt(CGAL::to_double(difference.squared_length()));
  };
  double uu = 0, uv = 0, vv = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i < 2)
        uu = (std::max)(uu, 6 * size((p(i + 2, j) - p(i + 1, j)) - (p(i + 1, j) - p(i, j))));
      if (j < 2)
        vv = (std::max)(vv, 6 * size((p(i, j + 2) - p(i, j + 1)) - (p(i, j + 1) - p(i, j))));
      if (i < 3 && j < 3)
        uv = (std::max)(uv, 9 * size((p(i + 1, j + 1) - p(i, j + 1)) - (p(i + 1, j) - p(i, j))));
    }
  return {uu + uv, vv + uv};
}

/// Into how many parts the sides of each face are divided, those along u and those along v, by a resolution.
/// \param progress if it is interrupted, the numbers mean nothing
template <typename Surface>
std::vector<std::array<int, 2>> divisions_of_faces(const Surface& surface, const Tessellation_resolution& resolution,
                                                   Progress& progress)
{
  const std::size_t number_of_faces = surface.indexing().number_of_faces();
  if (!resolution.is_adaptive())
    return std::vector<std::array<int, 2>>(number_of_faces,
                                           {resolution.number_of_parts(), resolution.number_of_parts()});
  const auto& compiled = as_compiled(surface, progress);
  std::vector<std::array<int, 2>> result(number_of_faces,
                                         {Tessellation_resolution::least_parts, Tessellation_resolution::least_parts});
  for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
    const auto domain = compiled.domain(i);
    const std::array<double, 2> bending = bending_of_patch(compiled.patch(i));
    const std::array<double, 2> share = {
        CGAL::to_double(domain.u_end - domain.u_begin) / CGAL::to_double(compiled.width(domain.face)),
        CGAL::to_double(domain.v_end - domain.v_begin) / CGAL::to_double(compiled.height(domain.face))};
    for (int k = 0; k < 2; ++k) {
      const double parts = std::ceil(std::sqrt(bending[k] / (4 * resolution.distance())) / share[k]);
      int& n = result[compiled.indexing().face_index(domain.face)][k];
      n = (std::max)(n, static_cast<int>((std::min)(parts, double(Tessellation_resolution::most_parts))));
    }
  }
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_DIVISIONS_OF_FACES_H
