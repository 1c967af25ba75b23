// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_CLOSEST_RECTANGLE_H
#define CGAL_T_SPLINES_INTERNAL_CLOSEST_RECTANGLE_H

#include <algorithm>

namespace CGAL {
namespace T_splines {
namespace internal {

// Moves a point to the closest one of the closed rectangle [0, width] x [0, height].
template <typename NT>
void clamp_to_rectangle(NT& u, NT& v, const NT& width, const NT& height)
{
  const NT zero(0);
  u = (std::clamp)(u, zero, width);
  v = (std::clamp)(v, zero, height);
}

// How far x is outside of [0, size], relative to size. Not a number if x is none.
template <typename NT>
NT excess(const NT& x, const NT& size)
{
  if (x < NT(0))
    return NT(-x / size);
  return x <= size ? NT(0) : NT((x - size) / size);
}

// How far a point is outside of [0, width] x [0, height], relative to its sides.
template <typename NT>
NT excess(const NT& u, const NT& v, const NT& width, const NT& height)
{
  return (std::max)(excess(u, width), excess(v, height));
}

// Chooses among rectangles, in the frame of each of which a point has an image: the first one that contains it, closed
// as it is. Round-off may leave none; then it is the one that misses it by least.
template <typename NT>
class Closest_rectangle {
public:
  // Returns whether this rectangle is better than all before. (u, v) is the image of the point.
  bool offer(const NT& u, const NT& v, const NT& width, const NT& height)
  {
    if (contains_point())
      return false;
    const NT e = excess(u, v, width, height);
    if (m_is_chosen && !(e < m_excess))
      return false;
    m_is_chosen = true;
    m_excess = e;
    return true;
  }

  bool is_chosen() const { return m_is_chosen; }
  // Whether the one that is chosen does: no other will be.
  bool contains_point() const { return m_is_chosen && m_excess == NT(0); }

private:
  bool m_is_chosen = false;
  NT m_excess = NT(0);
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_CLOSEST_RECTANGLE_H
