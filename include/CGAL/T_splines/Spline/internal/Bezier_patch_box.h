// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PATCH_BOX_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PATCH_BOX_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/internal/Box_tree.h>

#include <algorithm>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Finds boxes of patches.
///
/// A patch lies in the convex hull of its control points if the weights are positive. Those of a cap need not be; then
/// the patch is halved until they are, as they come to be where the denominator is positive. If even small parts have
/// weights that are not, the box is practically the whole space.
template <typename Kernel>
class Bezier_patch_box {
public:
  using FT = typename Kernel::FT;
  using Patch = Bezier_patch_3<Kernel>;
  using Box = Axis_parallel_box<FT>;

  static Box box(const Patch& patch)
  {
    constexpr int number_of_halvings = 12;
    Box result;
    extend(patch.homogeneous_control_points(), number_of_halvings, result);
    return result;
  }

private:
  using Controls = typename Patch::Controls;

  static void extend(const Controls& c, const int number_of_halvings, Box& box)
  {
    const bool has_hull = std::all_of(c.begin(), c.end(), [](const auto& h) { return h[3] > FT(0); });
    if (has_hull) {
      for (const auto& h : c)
        box.extend({h[0] / h[3], h[1] / h[3], h[2] / h[3]});
      return;
    }
    if (number_of_halvings == 0) {
      const FT large(1e100); // beyond all points, and its square is finite
      box.extend({-large, -large, -large});
      box.extend({large, large, large});
      return;
    }
    Controls lower = c, upper = c;
    halve(lower, upper, number_of_halvings % 2 == 0 ? 1 : 4);
    extend(lower, number_of_halvings - 1, box);
    extend(upper, number_of_halvings - 1, box);
  }

  // De Casteljau's algorithm at 1/2, along the control points whose numbers differ by `step`, 1 or 4.
  static void halve(Controls& lower, Controls& upper, const int step)
  {
    for (int j = 0; j < 4; ++j)
      for (int k = 3; k >= 0; --k) {
        const int first = j * (5 - step);
        upper[first + k * step] = lower[first + 3 * step];
        for (int i = 3; i >= 4 - k; --i)
          for (int x = 0; x < 4; ++x)
            lower[first + i * step][x] = (lower[first + i * step][x] + lower[first + (i - 1) * step][x]) / FT(2);
      }
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PATCH_BOX_H
