// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_AXIS_PARALLEL_BOX_H
#define CGAL_T_SPLINES_INTERNAL_AXIS_PARALLEL_BOX_H

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// An axis-parallel box, empty at first.
template <typename FT>
struct Axis_parallel_box {
  std::array<FT, 3> low{(std::numeric_limits<FT>::max)(), (std::numeric_limits<FT>::max)(),
                        (std::numeric_limits<FT>::max)()};
  std::array<FT, 3> high{std::numeric_limits<FT>::lowest(), std::numeric_limits<FT>::lowest(),
                         std::numeric_limits<FT>::lowest()};

  void extend(const std::array<FT, 3>& p)
  {
    for (int k = 0; k < 3; ++k) {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  }

  /// \param p a point of a kernel
  template <typename Point_3>
  void extend(const Point_3& p)
  {
    extend({FT(p.x()), FT(p.y()), FT(p.z())});
  }

  FT middle(const int axis) const { return low[axis] / FT(2) + high[axis] / FT(2); }

  /// The length of the longest side; 0 if the box is empty.
  FT extent() const
  {
    return high[0] < low[0] ? FT(0) : (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }

  /// returns the squared distance of a point, 0 inside.
  FT squared_distance(const std::array<FT, 3>& p) const
  {
    FT result(0);
    for (int k = 0; k < 3; ++k) {
      const FT below = low[k] - p[k], above = p[k] - high[k], outside = below > above ? below : above;
      result += outside > FT(0) ? outside * outside : FT(0);
    }
    return result;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_AXIS_PARALLEL_BOX_H
