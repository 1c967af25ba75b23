// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_POINT_SEARCH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_POINT_SEARCH_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/Surface_jet.h>
#include <CGAL/T_splines/Spline/internal/Squared_distance_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The sides of a patch beyond which the surface ends or has a kink: there the distance may be smallest without being
/// stationary. A set of bits: s = 0, s = 1, t = 0, t = 1.
using Patch_sides = unsigned char;

/// Finds the point closest to a given one, patch by patch; it knows what was found so far.
///
/// Where a plane keeps the control points of a patch away, the patch is skipped: N - W p is in their convex hull
/// whatever the weights are. On a part of a patch, the squared distance form F is looked at. (1) Where its coefficients
/// exceed 0, nothing is closer. (2) Where it is monotone in a parameter, no point is stationary; a closest point lies
/// on a side where the surface ends, or not in this part. This holds because the surface is C1 across the other sides.
/// (3) Where it is convex, Newton's method with bounds finds its one minimum. Else the part is halved. Around a minimum
/// with a positive Hessian (3) applies to all parts that are small enough, so that the parts are few.
///
/// Three candidates are kept. The closest stationary point is the result. An extraordinary vertex, or other points,
/// such as corners of patches and minima on the sides of parts, only bound its distance; they become the result if no
/// stationary point is as close, up to round-off. The last ones do so only at minima with a singular Hessian.
template <typename Kernel>
class Closest_point_search {
public:
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Vector_3 = typename Kernel::Vector_3;
  using Patch = Bezier_patch_3<Kernel>;

  /// Which patch: the meaning is the caller's.
  struct Patch_id {
    std::size_t item = 0;
    int level = 0, part = 0;
  };

  struct Foot {
    FT squared_distance = std::numeric_limits<FT>::infinity();
    FT s = FT(0), t = FT(0);
    Point_3 point; ///< in the coordinates of the patch
    Patch_id patch;
  };

  /// \param noise a bound of the round-off in coordinates of points
  explicit Closest_point_search(const FT noise) : m_noise(noise) {}

  FT noise() const { return m_noise; }

  /// What is at least as far, squared, need not be visited.
  FT squared_radius() const { return (std::min)(m_stationary.squared_distance, m_inflated_bound); }

  const Foot& result() const
  {
    return m_stationary.squared_distance <= m_inflated_bound ? m_stationary
           : m_vertex.squared_distance <= m_inflated_bound   ? m_vertex
                                                             : m_bound;
  }

  /// Takes an extraordinary vertex into account.
  void offer_vertex(const Foot& foot)
  {
    if (foot.squared_distance < m_vertex.squared_distance)
      m_vertex = foot;
    offer(foot, false);
  }

  /// Takes the points of a patch into account.
  void visit(const Patch_id& id, const Patch& patch, const Point_3& p, const Patch_sides sides)
  {
    set_patch(id, patch, p, sides);
    if (is_beyond_plane())
      return;
    if (m_has_equal_weights) {
      Form form = make_form(std::isfinite(squared_radius()) ? squared_radius() : FT(0));
      offer_corners(form);
      visit_part(form, whole);
      return;
    }
    if (!std::isfinite(squared_radius()))
      descend(whole, FT(0.5), FT(0.5));
    // With weights that differ, the form of one distance does not tell much about smaller ones.
    constexpr int largest_number_of_passes = 32;
    for (m_number_of_passes = largest_number_of_passes; m_number_of_passes > 0; --m_number_of_passes) {
      const FT before = squared_radius();
      Form form = make_form(before);
      if (is_excluded(form.minimum()))
        return;
      const std::pair<FT, FT> place = form.place_of_minimum();
      descend(whole, place.first, place.second);
      if (!is_outdated())
        visit_part(form, whole);
      if (!(squared_radius() < before * (FT(1) - FT(64) * epsilon)))
        return;
    }
  }

  /// Takes the local minimum into account to which Newton's method descends from (s, t) of a patch.
  void descend(const Patch_id& id, const Patch& patch, const Point_3& p, const Patch_sides sides, const FT s,
               const FT t)
  {
    set_patch(id, patch, p, sides);
    descend(whole, s, t);
  }

private:
  using Form = Squared_distance_form<FT>;
  static constexpr FT epsilon = std::numeric_limits<FT>::epsilon();

  struct Rectangle {
    FT s_begin, s_end, t_begin, t_end;
    FT width() const { return s_end - s_begin; }
    FT height() const { return t_end - t_begin; }
  };

  static constexpr Rectangle whole{FT(0), FT(1), FT(0), FT(1)};

  // A place of the current patch and what Newton's method needs there.
  struct State {
    FT s, t;
    Surface_jet<Kernel> jet;
    Vector_3 difference;
    FT squared_distance;
    FT gs, gt; // half of the gradient
  };

  // Takes a point of the surface into account.
  void offer(const Foot& foot, const bool is_stationary)
  {
    if (is_stationary && foot.squared_distance < m_stationary.squared_distance)
      m_stationary = foot;
    if (foot.squared_distance < m_bound.squared_distance) {
      m_bound = foot;
      m_inflated_bound = foot.squared_distance + noise_of_square(foot.squared_distance);
    }
  }

  FT noise_of_square(const FT squared_distance) const
  {
    return m_noise * (FT(2) * std::sqrt(squared_distance) + m_noise);
  }

  void set_patch(const Patch_id& id, const Patch& patch, const Point_3& p, const Patch_sides sides)
  {
    m_id = id;
    m_patch = &patch;
    m_p = p;
    m_sides = sides;
    const auto& c = patch.homogeneous_control_points();
    const FT w = c[0][3];
    FT smallest = w, largest = w;
    m_scale = m_size = FT(0);
    for (int k = 0; k < 16; ++k) {
      m_weights[k] = c[k][3];
      smallest = (std::min)(smallest, c[k][3]);
      largest = (std::max)(largest, c[k][3]);
      const FT x = c[k][0] - c[k][3] * p.x(), y = c[k][1] - c[k][3] * p.y(), z = c[k][2] - c[k][3] * p.z();
      m_differences[0][k] = x;
      m_differences[1][k] = y;
      m_differences[2][k] = z;
      m_scale = (std::max)(m_scale, x * x + y * y + z * z);
      m_size = (std::max)({m_size, std::abs(c[k][0]), std::abs(c[k][1]), std::abs(c[k][2])});
    }
    m_has_equal_weights = smallest > FT(0) && largest - smallest <= FT(16) * epsilon * largest;
    m_size /= std::abs(w);
    for (int axis = 0; axis < 2; ++axis)
      m_weight_slope[axis] = m_has_equal_weights ? FT(0) : weight_slope(axis, smallest);
    m_largest_weight = (std::max)(smallest * smallest, largest * largest);
    m_smallest_weight = smallest > FT(0) ? smallest * smallest : FT(0);
  }

  // A bound of |W' / W|.
  FT weight_slope(const int axis, const FT smallest) const
  {
    if (!(smallest > FT(0)))
      return std::numeric_limits<FT>::infinity();
    const int step = axis == 0 ? 1 : 4;
    FT largest(0);
    for (int k = 0; k < 16; ++k)
      if ((axis == 0 ? k % 4 : k / 4) < 3)
        largest = (std::max)(largest, std::abs(m_weights[k + step] - m_weights[k]));
    return FT(3) * largest / smallest;
  }

  // Whether a plane between the point and the control points shows that the patch is not closer than what is known.
  bool is_beyond_plane() const
  {
    std::array<FT, 3> n{FT(0), FT(0), FT(0)};
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 16; ++k)
        n[c] += m_differences[c][k];
    FT minimum = std::numeric_limits<FT>::infinity();
    for (int k = 0; k < 16; ++k) {
      const FT x = n[0] * m_differences[0][k] + n[1] * m_differences[1][k] + n[2] * m_differences[2][k];
      minimum = x < minimum ? x : minimum;
    }
    const FT squared_radius = this->squared_radius() * m_largest_weight; // times W^2
    return minimum > FT(0) && minimum * minimum >= squared_radius * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  }

  void offer_corners(const Form& form)
  {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const FT w = m_weights[12 * j + 3 * i], value = form.corner(i, j) / (w * w) + m_subtracted;
        if (value < squared_radius()) {
          offer(foot_of(evaluate(FT(i), FT(j))), false);
        }
      }
  }

  // Whether nothing is closer than what is known, where the form is not less than `minimum`.
  bool is_excluded(const FT minimum) const
  {
    const FT known = squared_radius();
    if (!std::isfinite(known))
      return false;
    // The form of the known distance is not less than `minimum - increase`.
    const FT difference = known - m_subtracted,
             increase = difference * (difference > FT(0) ? m_largest_weight : m_smallest_weight);
    // Where all distances are almost the same, nothing gets better by more than round-off. But with a distance that is
    // small against the patch the round-off of its square is not small against it.
    const bool is_far = FT(4) * known * m_largest_weight >= m_scale && known == m_stationary.squared_distance;
    return minimum - increase >= (is_far ? -m_form_noise : m_form_noise);
  }

  Form make_form(const FT squared_distance)
  {
    m_subtracted = squared_distance;
    m_number_of_parts = 0;
    m_form_noise = FT(16) * epsilon * (m_scale + squared_distance * m_largest_weight);
    return Form(m_differences, m_weights, m_has_equal_weights, squared_distance);
  }

  // Whether it is better to begin anew with the smaller distance that has been found.
  bool is_outdated() const
  {
    constexpr double clearly_less = 0.999; // a form that is made anew costs more than a little waste
    return !m_has_equal_weights && m_number_of_passes > 1 && squared_radius() < m_subtracted * FT(clearly_less);
  }

  void visit_part(Form& form, Rectangle r)
  {
    if (is_outdated())
      return;
    ++m_number_of_parts;
    const FT minimum = form.minimum();
    if (is_excluded(minimum) || !has_stationary_points(minimum, form, r))
      return;
    constexpr int largest_number_of_parts = 1 << 14;
    const FT smallest_size = FT(1) / FT(1 << 12);
    const bool is_leaf = (std::max)(r.width(), r.height()) <= smallest_size ||
                         m_number_of_parts > largest_number_of_parts || is_constant(minimum, form.maximum());
    if (is_leaf || form.is_convex(r.width() == FT(0), r.height() == FT(0))) {
      const FT known = squared_radius();
      const std::pair<FT, FT> place = form.place_of_minimum();
      const FT squared_distance =
          descend(r, r.s_begin + place.first * r.width(), r.t_begin + place.second * r.height());
      if (is_leaf || m_has_equal_weights || squared_distance <= known + noise_of_square(known))
        return;
    }
    const int axis = r.width() >= r.height() ? 0 : 1;
    Form upper = form;
    form.split(axis, upper);
    Rectangle lower_rectangle = r, upper_rectangle = r;
    if (axis == 0)
      lower_rectangle.s_end = upper_rectangle.s_begin = (r.s_begin + r.s_end) / FT(2);
    else
      lower_rectangle.t_end = upper_rectangle.t_begin = (r.t_begin + r.t_end) / FT(2);
    if (upper.minimum() < form.minimum()) {
      visit_part(upper, upper_rectangle);
      visit_part(form, lower_rectangle);
    }
    else {
      visit_part(form, lower_rectangle);
      visit_part(upper, upper_rectangle);
    }
  }

  // Whether in a part where the form has these bounds the distance is the same everywhere, up to round-off.
  bool is_constant(const FT minimum, const FT maximum) const
  {
    const FT largest = (std::max)(maximum, FT(0)) + m_subtracted * m_largest_weight; // of |N - W p|^2
    return maximum - minimum <= (std::max)(m_form_noise, noise_of_square(largest));
  }

  // Whether a closest point may lie in a part, which then is shrunk to the side where it lies.
  //
  // It is one with F <= 0. There the derivative of F / W^2 has the sign of that of F, if this exceeds 2 |F W' / W|.
  bool has_stationary_points(const FT minimum, Form& form, Rectangle& r) const
  {
    for (int axis = 0; axis < 2; ++axis) {
      FT& begin = axis == 0 ? r.s_begin : r.t_begin;
      FT& end = axis == 0 ? r.s_end : r.t_end;
      if (begin == end)
        continue;
      const FT part_of_weight = (std::max)(-minimum, FT(0)) * m_weight_slope[axis] * (end - begin) / FT(3);
      const int direction = form.direction(axis, FT(4) * m_form_noise + part_of_weight);
      if (direction == 0)
        continue;
      const bool is_end = direction < 0;
      if ((is_end ? end != FT(1) : begin != FT(0)) || !is_marked(axis, is_end))
        return false;
      form.restrict_to_side(axis, is_end);
      (is_end ? begin : end) = is_end ? FT(1) : FT(0);
    }
    return true;
  }

  bool is_marked(const int axis, const bool is_end) const { return (m_sides >> (2 * axis + is_end)) % 2 != 0; }

  Foot foot_of(const State& x) const { return {x.squared_distance, x.s, x.t, x.jet.position, m_id}; }

  State evaluate(const FT s, const FT t) const
  {
    State state;
    state.s = s;
    state.t = t;
    state.jet = m_patch->jet(s, t);
    state.difference = state.jet.position - m_p;
    state.squared_distance = state.difference.squared_length();
    state.gs = state.jet.du * state.difference;
    state.gt = state.jet.dv * state.difference;
    return state;
  }

  // Newton's method for the squared distance in a rectangle. Returns the squared distance, after it was offered.
  FT descend(const Rectangle& r, const FT s, const FT t)
  {
    State state = evaluate(s, t);
    constexpr int largest_number_of_steps = 64;
    const FT last_step(1e-9); // it converges quadratically
    for (int i = 0; i < largest_number_of_steps; ++i) {
      std::pair<FT, FT> step = newton_step(state, r);
      FT size = (std::max)(std::abs(step.first), std::abs(step.second));
      if (!(size > FT(0)))
        break;
      bool is_closer = false;
      State next = state;
      // In small patches the distances differ less than by round-off; their gradients are more accurate.
      const FT largest = state.squared_distance + noise_of_square(state.squared_distance);
      for (; size > epsilon && !is_closer; size /= FT(2), step.first /= FT(2), step.second /= FT(2)) {
        next = evaluate(std::clamp(state.s + step.first, r.s_begin, r.s_end),
                        std::clamp(state.t + step.second, r.t_begin, r.t_end));
        is_closer = size <= last_step || next.squared_distance < largest;
        if (is_closer)
          break;
      }
      if (!is_closer)
        break;
      state = next;
      if (size <= last_step)
        break;
    }
    offer(foot_of(state), is_stationary(state));
    return state.squared_distance;
  }

  // A step that descends and does not leave the rectangle: Newton's, that of Gauss and Newton where the Hessian is not
  // positive, and along a bound where one is reached.
  static std::pair<FT, FT> newton_step(const State& x, const Rectangle& r)
  {
    const auto is_fixed = [](const FT value, const FT begin, const FT end, const FT g) {
      return (value <= begin && g >= FT(0)) || (value >= end && g <= FT(0));
    };
    const FT aa = x.jet.du.squared_length(), ab = x.jet.du * x.jet.dv, bb = x.jet.dv.squared_length();
    FT ss = aa + x.difference * x.jet.duu, st = ab + x.difference * x.jet.duv, tt = bb + x.difference * x.jet.dvv;
    const auto along = [](const FT g, const FT h, const FT gauss_newton) {
      constexpr double flat = 0.01; // a second derivative that is smaller leads far away, and may be negative next
      const FT divisor = h > FT(flat) * gauss_newton ? h : gauss_newton;
      return divisor > FT(0) ? -g / divisor : FT(0);
    };
    const auto bounded = [](const FT step, const FT value, const FT begin, const FT end) {
      return std::clamp(step, FT(begin - value), FT(end - value));
    };
    const bool s_is_fixed = is_fixed(x.s, r.s_begin, r.s_end, x.gs),
               t_is_fixed = is_fixed(x.t, r.t_begin, r.t_end, x.gt);
    if (s_is_fixed && t_is_fixed)
      return {FT(0), FT(0)};
    if (s_is_fixed)
      return {FT(0), bounded(along(x.gt, tt, bb), x.t, r.t_begin, r.t_end)};
    if (t_is_fixed)
      return {bounded(along(x.gs, ss, aa), x.s, r.s_begin, r.s_end), FT(0)};
    constexpr double nearly_singular = 1e-4;  // flat, squared
    constexpr double levenberg_factor = 1.01; // makes the form of Gauss and Newton definite
    if (!(ss > FT(0) && tt > FT(0) && ss * tt - st * st > FT(nearly_singular) * ss * tt)) {
      ss = aa * FT(levenberg_factor);
      st = ab;
      tt = bb * FT(levenberg_factor);
    }
    const FT determinant = ss * tt - st * st;
    if (!(determinant > FT(0)))
      return {bounded(along(x.gs, aa, aa), x.s, r.s_begin, r.s_end),
              bounded(along(x.gt, bb, bb), x.t, r.t_begin, r.t_end)};
    FT ds = (st * x.gt - tt * x.gs) / determinant, dt = (st * x.gs - ss * x.gt) / determinant;
    const FT bounded_ds = bounded(ds, x.s, r.s_begin, r.s_end), bounded_dt = bounded(dt, x.t, r.t_begin, r.t_end);
    if (bounded_ds != ds)
      return {bounded_ds, bounded(-(x.gt + st * bounded_ds) / tt, x.t, r.t_begin, r.t_end)};
    if (bounded_dt != dt)
      return {bounded(-(x.gs + st * bounded_dt) / ss, x.s, r.s_begin, r.s_end), bounded_dt};
    return {ds, dt};
  }

  // Whether the gradient is 0 up to round-off, or points inwards on a marked side.
  bool is_stationary(const State& x) const
  {
    const FT rest = FT(16) * epsilon * m_size * std::sqrt(x.squared_distance);
    const auto vanishes = [&](const int axis, const FT value, const FT g, const Vector_3& derivative) {
      if ((value == FT(0) && g > FT(0) && is_marked(axis, false)) ||
          (value == FT(1) && g < FT(0) && is_marked(axis, true)))
        return true;
      return std::abs(g) <= rest + m_noise * std::sqrt(derivative.squared_length());
    };
    return vanishes(0, x.s, x.gs, x.jet.du) && vanishes(1, x.t, x.gt, x.jet.dv);
  }

  FT m_noise;
  Foot m_stationary, m_vertex, m_bound;
  FT m_inflated_bound = std::numeric_limits<FT>::infinity();

  // The current patch.
  Patch_id m_id;
  const Patch* m_patch = nullptr;
  Point_3 m_p;
  Patch_sides m_sides = 0;
  std::array<typename Form::Cubic, 3> m_differences;
  typename Form::Cubic m_weights;
  bool m_has_equal_weights = false;
  std::array<FT, 2> m_weight_slope;       // bounds of the logarithmic derivatives of the weight
  FT m_smallest_weight, m_largest_weight; // bounds of the squared weight
  FT m_scale;                             // bound of the squared length of the differences
  FT m_size;                              // about the largest coordinate
  FT m_subtracted;                        // the squared distance of the form
  FT m_form_noise;                        // bound of the round-off in the form's coefficients
  int m_number_of_parts = 0;              // in this pass
  int m_number_of_passes = 0;             // that are left
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_POINT_SEARCH_H
