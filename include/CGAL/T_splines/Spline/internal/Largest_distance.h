// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_LARGEST_DISTANCE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_LARGEST_DISTANCE_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Branch and bound for the largest distance: parts of a surface in a queue, the one with the greatest bound first.
/// What cannot exceed the largest distance found by more than `certainty` is left out.
/// \tparam Part has a member `bound`: no point of the part is farther
template <typename Part>
class Largest_distance {
public:
  /// \param negligible distances that need not be told apart
  explicit Largest_distance(const double negligible) : m_negligible(negligible) {}

  double found() const { return m_found; }

  /// \return whether it is the largest
  bool offer(const double distance)
  {
    if (!(distance > m_found) && m_has_any)
      return false;
    m_has_any = true;
    m_found = distance;
    return true;
  }

  /// Whether parts with this bound are to be looked at.
  bool is_open(const double bound) const { return bound > limit(); }

  /// Puts a part into the queue, or leaves it out.
  void add(Part&& part)
  {
    if (is_open(part.bound)) {
      m_queue.push_back(std::move(part));
      std::push_heap(m_queue.begin(), m_queue.end(), is_less);
    }
    else
      leave_out(part.bound);
  }

  void leave_out(const double bound) { m_left_out = (std::max)(m_left_out, bound); }

  /// Whether a part is left in the queue that has to be looked at.
  bool has_open_part() const { return !m_queue.empty() && is_open(m_queue.front().bound); }

  /// \pre `has_open_part()`
  Part take()
  {
    std::pop_heap(m_queue.begin(), m_queue.end(), is_less);
    Part part = std::move(m_queue.back());
    m_queue.pop_back();
    return part;
  }

  /// No distance is larger.
  double upper_bound() const
  {
    const double of_queue = m_queue.empty() ? 0 : m_queue.front().bound;
    return (std::max)({m_found, m_left_out, of_queue});
  }

private:
  static constexpr double certainty = 1.01;

  static bool is_less(const Part& a, const Part& b) { return a.bound < b.bound; }

  double limit() const { return (std::max)(certainty * m_found, m_found + m_negligible); }

  double m_negligible;
  bool m_has_any = false;
  double m_found = 0, m_left_out = 0;
  std::vector<Part> m_queue;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_LARGEST_DISTANCE_H
