// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EIGENSTRUCTURE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EIGENSTRUCTURE_H

#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The eigenvectors of the subdivision of a face with one extraordinary vertex, in closed form.
///
/// On the vertex and its 2n neighbours the subdivision commutes with the rotation by a sector, and it is self-adjoint
/// in the inner product whose weights are those of the limit position, n^2 : 4 : 1. So its left eigenvectors are the
/// right ones times these weights, and the right ones are found frequency by frequency. At the frequency k > 0, with h
/// = cos(pi k / n) and u one of h +- sqrt(h^2 + 4), they are e_i = u cos(2 pi k i / n), f_i = 4 cos(pi k (2i + 1) / n)
/// and the same with sines; the eigenvalue is (u / 4)^2. At the frequency 0 they are 1 and two of Stam's.
///
/// The outer vertices follow from the values, slopes and second differences across the spokes 0 and 1, which the
/// subdivision keeps apart: that makes (lambda I - S12) y = S11 x triangular. Its pivot 8 lambda - 1 vanishes at a
/// quarter of the full circle, which valences divisible by 4 have as a frequency, but there it cancels: no case is
/// singular.
/// \tparam FT a floating point type
template <typename FT>
class Catmull_clark_eigenvectors {
  static_assert(std::is_floating_point<FT>::value, "eigenvalues are not rational");

public:
  /// An eigenvalue with its right and its left eigenvector, whose product is 1.
  struct Mode {
    FT eigenvalue;
    std::vector<FT> right, left;
  };

  /// computes all modes: the constant first, then the two that span the tangent plane. Time and space O(n^2).
  explicit Catmull_clark_eigenvectors(const Catmull_clark_subdivision<FT>& rules)
    : m_rules(rules),
      m_limit_weights(rules.limit_weights())
  {
    m_modes.reserve(m_limit_weights.size());
    add_constant();
    for (int frequency = 1; 2 * frequency <= rules.valence(); ++frequency)
      add_frequency(frequency);
    const FT n(rules.valence());
    const FT larger = (3 * n - 7 + std::sqrt((5 * n - 30) * n + 49)) / (8 * n);
    add_rotation_invariant(larger);
    add_rotation_invariant((n - 3) / (16 * n * larger));
    for (int order = 0; order < 3; ++order)
      for (int spoke = 0; spoke < 2; ++spoke)
        add_outer(order, spoke);
    add_corner();
  }

  const std::vector<Mode>& modes() const { return m_modes; }

private:
  /// The value, slope and second difference across a spoke, each up to a factor.
  using Moments = std::array<FT, 3>;

  /// The weights of the three moments at the vertices clockwise of a spoke, on it and counter-clockwise of it.
  static constexpr int moment_weights[3][3] = {{1, 4, 1}, {-1, 0, 1}, {1, -2, 1}};
  /// The inverses of the eigenvalues of the moments beyond a spoke.
  static constexpr int outer_factors[3] = {8, 16, 32};

  static Moments moments(const FT& clockwise, const FT& middle, const FT& counter_clockwise)
  {
    return {clockwise + 4 * middle + counter_clockwise, counter_clockwise - clockwise,
            (counter_clockwise - middle) - (middle - clockwise)};
  }

  /// The outer vertices beyond the spoke 0 or 1: clockwise, on it and counter-clockwise.
  std::array<int, 3> outer_of(const int spoke) const
  {
    if (spoke == 0)
      return {m_rules.outer(0), m_rules.outer(1), m_rules.outer(2)};
    return {m_rules.outer(4), m_rules.outer(5), m_rules.outer(6)};
  }

  void set_outer(std::vector<FT>& x, const int spoke, const Moments& m) const
  {
    const std::array<int, 3> index = outer_of(spoke);
    x[index[0]] = (m[0] + 2 * m[2]) / 6 - m[1] / 2;
    x[index[1]] = (m[0] - m[2]) / 6;
    x[index[2]] = (m[0] + 2 * m[2]) / 6 + m[1] / 2;
  }

  /// The moments that the step yields beyond a spoke, from the vertices of the ring only, each times its outer factor.
  Moments inflow(const std::vector<FT>& x, const int spoke) const
  {
    const Moments near = moments(x[m_rules.spoke(spoke - 1)], x[0], x[m_rules.spoke(spoke + 1)]);
    const Moments far = moments(x[m_rules.diagonal(spoke - 1)], x[m_rules.spoke(spoke)], x[m_rules.diagonal(spoke)]);
    return {near[0] + 6 * far[0], near[1] + 6 * far[1], near[2] + 6 * far[2]};
  }

  void set_corner(Mode& mode) const
  {
    std::vector<FT>& x = mode.right;
    const FT even = x[0] + x[outer_of(0)[1]] + x[outer_of(1)[1]];
    const FT odd = x[m_rules.spoke(0)] + x[m_rules.spoke(1)] + x[outer_of(0)[2]] + x[outer_of(1)[0]];
    x[m_rules.outer(3)] = (even + 6 * odd + 36 * x[m_rules.diagonal(0)]) / (64 * mode.eigenvalue - 1);
  }

  /// adds a mode whose right eigenvector is known but at the corner, and whose left one vanishes at the outer vertices.
  void add_ring_mode(Mode&& mode)
  {
    set_corner(mode);
    FT square(0);
    for (int i = 0; i < m_rules.outer(0); ++i)
      square += m_limit_weights[i] * mode.right[i] * mode.right[i];
    const FT norm = std::sqrt(square);
    for (FT& x : mode.right)
      x /= norm;
    mode.left.assign(mode.right.size(), FT(0));
    for (int i = 0; i < m_rules.outer(0); ++i)
      mode.left[i] = m_limit_weights[i] * mode.right[i];
    m_modes.push_back(std::move(mode));
  }

  void add_constant() { m_modes.push_back({FT(1), std::vector<FT>(m_limit_weights.size(), FT(1)), m_limit_weights}); }

  void add_rotation_invariant(const FT& eigenvalue)
  {
    Mode mode{eigenvalue, std::vector<FT>(m_limit_weights.size(), FT(0)), {}};
    mode.right[0] = (16 * eigenvalue - 12) * eigenvalue + 1;
    for (int i = 0; i < m_rules.valence(); ++i) {
      mode.right[m_rules.spoke(i)] = 6 * eigenvalue - 1;
      mode.right[m_rules.diagonal(i)] = 4 * eigenvalue + 1;
    }
    for (int spoke = 0; spoke < 2; ++spoke) {
      const Moments b = inflow(mode.right, spoke);
      set_outer(mode.right, spoke, {b[0] / (8 * eigenvalue - 1), FT(0), b[2] / (32 * eigenvalue - 1)});
    }
    add_ring_mode(std::move(mode));
  }

  /// adds the four modes of a frequency, the larger eigenvalue first; half way round the circle there are only two.
  void add_frequency(const int frequency)
  {
    const FT h = cosine_of_pi_times<FT>(frequency, m_rules.valence());
    const FT u = h + std::sqrt(h * h + 4);
    const bool is_alternating = 2 * frequency == m_rules.valence();
    for (const FT& root : {u, -4 / u}) {
      add_wave(frequency, root, cosine_of_pi_times<FT>);
      add_wave(frequency, root, sine_of_pi_times<FT>);
      if (is_alternating)
        break; // the cosines are 0 on the diagonals and the sines on the spokes
    }
  }

  template <typename Wave>
  void add_wave(const std::int64_t frequency, const FT& u, const Wave& wave)
  {
    const int n = m_rules.valence();
    Mode mode{u * u / 16, std::vector<FT>(m_limit_weights.size(), FT(0)), {}};
    for (int i = 0; i < n; ++i) {
      mode.right[m_rules.spoke(i)] = u * wave(2 * frequency * i, n);
      mode.right[m_rules.diagonal(i)] = 4 * wave(frequency * (2 * i + 1), n);
    }
    for (int spoke = 0; spoke < 2; ++spoke) {
      const Moments b = inflow(mode.right, spoke);
      // The value is b[0] / (8 lambda - 1), where b[0] = (u^2 - 2) (u^2 + 40) / u times the wave at the spoke.
      const FT value = 2 * (u * u + 40) / u * wave(2 * frequency * spoke, n);
      set_outer(mode.right, spoke, {value, b[1] / (u * u - 1), b[2] / (2 * u * u - 1)});
    }
    add_ring_mode(std::move(mode));
  }

  /// adds a mode that is 0 on the ring: a single moment beyond one spoke.
  void add_outer(const int order, const int spoke)
  {
    Mode mode{FT(1) / outer_factors[order], std::vector<FT>(m_limit_weights.size(), FT(0)), {}};
    mode.left = mode.right;
    Moments moment{FT(0), FT(0), FT(0)};
    moment[order] = FT(1);
    set_outer(mode.right, spoke, moment);
    set_corner(mode);
    for (int i = 0; i < 3; ++i)
      mode.left[outer_of(spoke)[i]] = FT(moment_weights[order][i]);
    subtract_modes(mode.left);
    m_modes.push_back(std::move(mode));
  }

  void add_corner()
  {
    Mode mode{FT(1) / 64, std::vector<FT>(m_limit_weights.size(), FT(0)), {}};
    mode.right[m_rules.outer(3)] = FT(1);
    mode.left = mode.right;
    subtract_modes(mode.left);
    m_modes.push_back(std::move(mode));
  }

  /// subtracts from `left` its products with the modes so far, so that it is 0 on their right eigenvectors.
  void subtract_modes(std::vector<FT>& left) const
  {
    const std::vector<FT> given = left;
    for (const Mode& mode : m_modes) {
      const FT product = std::inner_product(given.begin(), given.end(), mode.right.begin(), FT(0));
      for (std::size_t i = 0; i < given.size(); ++i)
        left[i] -= product * mode.left[i];
    }
  }

  const Catmull_clark_subdivision<FT>& m_rules; ///< not used after the construction
  std::vector<FT> m_limit_weights;
  std::vector<Mode> m_modes;
};

/// Evaluates the limit surface of Catmull and Clark in a quad face with one extraordinary vertex, at any point of the
/// face and with relative accuracy also of the derivatives (Stam, 1998).
///
/// Faces, controls and parts are as in `Catmull_clark_subdivision`. One object serves all faces with a valence, from
/// any number of threads. Controls are vectors with four entries, for example homogeneous; the entries are treated
/// alike.
/// \tparam FT `double` or `long double`
template <typename FT_ = double>
class Catmull_clark_eigenstructure {
  static_assert(std::is_floating_point<FT_>::value && std::numeric_limits<FT_>::max_exponent >= 1024,
                "the scales of second derivatives need the exponents of double");

public:
  using FT = FT_;
  using Vector_4 = std::array<FT, 4>;
  using Derivatives = std::array<Vector_4, 6>;  ///< the value, d/ds, d/dt, d2/ds2, d2/dsdt and d2/dt2
  using Scalar_derivatives = std::array<FT, 6>; ///< the same of a scalar function

  /// computes the eigenstructure and the images of the eigenvectors in the parts. Time and space O(n^2).
  /// \param valence n >= 3
  explicit Catmull_clark_eigenstructure(const int valence) : m_valence(valence)
  {
    CGAL_precondition(valence >= 3);
    const Catmull_clark_subdivision<Real> rules(valence);
    const Catmull_clark_eigenvectors<Real> eigenvectors(rules);
    const Real subdominant = eigenvectors.modes()[1].eigenvalue;
    m_growth = FT(2 * subdominant);
    m_growth_error = FT((2 * subdominant - m_growth) / m_growth);
    for (const auto& mode : eigenvectors.modes()) {
      m_eigenvalues.push_back(FT(mode.eigenvalue));
      m_ratios.push_back(FT(mode.eigenvalue / subdominant));
      m_right.insert(m_right.end(), mode.right.begin(), mode.right.end());
      m_left.insert(m_left.end(), mode.left.begin(), mode.left.end());
      for (int part = 0; part < whole_face; ++part)
        m_images[part].push_back(image(rules.part(part), mode.right));
      if (is_regular())
        m_images[whole_face].push_back(image(rows_of_face(rules), mode.right));
    }
    CGAL_assertion(m_eigenvalues.size() == static_cast<std::size_t>(number_of_controls()));
  }

  int valence() const { return m_valence; }
  int number_of_controls() const { return 2 * m_valence + 8; } ///< K, also the number of modes

  /// returns the eigenvalues of the modes: 1, twice the subdominant one, and the others without order.
  const std::vector<FT>& eigenvalues() const { return m_eigenvalues; }

  /// returns the entry of the right eigenvector of a mode at a control.
  FT right_eigenvector(const int mode, const int control) const
  {
    return m_right[mode * number_of_controls() + control];
  }
  /// returns the entry of the left eigenvector of a mode at a control; these are inverse to the right ones.
  FT left_eigenvector(const int mode, const int control) const { return m_left[mode * number_of_controls() + control]; }

  /// computes the coefficients of the modes for given controls. Time O(K^2).
  ///
  /// Coefficient 0 is the limit position of the extraordinary vertex. The others depend on the differences of the
  /// controls only: they are exactly 0 if all controls are equal.
  std::vector<Vector_4> project(const std::vector<Vector_4>& controls) const
  {
    const std::size_t size = m_eigenvalues.size();
    CGAL_precondition(controls.size() == size);
    std::vector<Vector_4> coefficients(size, Vector_4{});
    for (std::size_t mode = 0; mode < size; ++mode)
      for (std::size_t control = 1; control < size; ++control)
        for (int c = 0; c < 4; ++c)
          coefficients[mode][c] += m_left[mode * size + control] * (controls[control][c] - controls[0][c]);
    for (int c = 0; c < 4; ++c)
      coefficients[0][c] += controls[0][c];
    return coefficients;
  }

  /// evaluates the surface at a point of the face, in time O(K): about 64 K multiplications, and no allocation.
  ///
  /// The relative accuracy of the derivatives does not depend on the distance to the extraordinary vertex; those beyond
  /// the range of `FT` become infinite. At the extraordinary vertex itself they are not defined, unless its valence is
  /// 4, and are set to 0; see `tangents()`.
  /// \param coefficients what `project()` returns for the controls
  /// \param s, t in [0, 1]
  /// \param order of the highest derivatives, 0, 1 or 2
  /// \param out entries of higher order are left as they are
  void evaluate(const std::vector<Vector_4>& coefficients, const FT s, const FT t, const int order,
                Derivatives& out) const
  {
    CGAL_precondition(coefficients.size() == m_eigenvalues.size());
    const Place place = this->place(s, t);
    std::array<Image, 4> patch{};
    if (!place.is_vertex)
      add_modes(coefficients, place, patch);
    const Centered_monomials<FT> monomials(place.x, place.y, order);
    const Scales scales = this->scales(place);
    for (int c = 0; c < 4; ++c) {
      Scalar_derivatives d = monomials.derivatives(patch[c]);
      scale(scales, order, d);
      out[0][c] = coefficients[0][c] + d[0];
      for (int i = 1; i < number_of_derivatives(order); ++i)
        out[i][c] = d[i];
    }
  }

  /// computes the basis functions of all controls at a point of the face, in time O(K^2).
  ///
  /// Up to rounding they are non-negative, and their sum is 1.
  /// \param s, t, order as for `evaluate()`
  /// \param out resized to K; nothing is allocated if it has that size. Derivatives of higher order are 0.
  void basis(const FT s, const FT t, const int order, std::vector<Scalar_derivatives>& out) const
  {
    const std::size_t size = m_eigenvalues.size();
    out.assign(size, Scalar_derivatives{});
    const Place place = this->place(s, t);
    if (!place.is_vertex) {
      const Centered_monomials<FT> monomials(place.x, place.y, order);
      for (std::size_t mode = 1; mode < size; ++mode) {
        const FT factor = power(m_ratios[mode], place.steps);
        Scalar_derivatives d = monomials.derivatives(m_images[place.part][mode]);
        for (FT& value : d)
          value *= factor;
        for (std::size_t control = 0; control < size; ++control)
          for (int i = 0; i < 6; ++i)
            out[control][i] += m_left[mode * size + control] * d[i];
      }
      const Scales scales = this->scales(place);
      for (Scalar_derivatives& d : out)
        scale(scales, order, d);
    }
    for (std::size_t control = 0; control < size; ++control)
      out[control][0] += m_left[control];
  }

  /// returns two vectors that span the tangent plane at the extraordinary vertex, unless they are linearly dependent.
  ///
  /// Their cross product, if it is not 0, has the direction of the limit of the cross product of d/ds with d/dt. If the
  /// controls are homogeneous, so are the vectors: derivatives of the homogeneous coordinates at `coefficients[0]`.
  std::array<Vector_4, 2> tangents(const std::vector<Vector_4>& coefficients) const
  {
    CGAL_precondition(coefficients.size() == m_eigenvalues.size());
    return {coefficients[1], coefficients[2]};
  }

private:
  using Real = long double;
  using Image = typename Centered_monomials<FT>::Coefficients; ///< of a function in a part
  using Rows = std::array<typename Catmull_clark_subdivision<Real>::Row, 16>;

  static constexpr int whole_face = Catmull_clark_subdivision<Real>::number_of_parts; ///< one more part: if n is 4

  /// The part that contains a point, and the local coordinates there.
  struct Place {
    bool is_vertex; ///< the extraordinary vertex is in no part
    int part;
    int steps;    ///< subdivisions before the part is cut out
    int exponent; ///< the side length of the part is 2^-exponent
    FT x, y;
  };

  /// Pairs of factors for the derivatives of the orders 0, 1, 2: one alone may overflow where the product with 0 is 0.
  using Scales = std::array<std::array<FT, 2>, 3>;

  bool is_regular() const { return m_valence == 4; }

  static constexpr int number_of_derivatives(const int order) { return (order + 1) * (order + 2) / 2; }

  /// The whole face, which is polynomial if n is 4: with levels, second derivatives would lose digits at every step.
  static Rows rows_of_face(const Catmull_clark_subdivision<Real>& rules)
  {
    Rows rows;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        rows[4 * j + i] = {{rules.control_at(i - 1, j - 1), Real(1)}};
    return rows;
  }

  static Image image(const Rows& rows, const std::vector<Real>& right)
  {
    std::array<Real, 16> controls;
    for (int i = 0; i < 16; ++i)
      controls[i] = Catmull_clark_subdivision<Real>::combination(rows[i], right);
    const std::array<Real, 16> coefficients = Centered_monomials<Real>::coefficients(controls);
    Image result;
    std::transform(coefficients.begin(), coefficients.end(), result.begin(), [](const Real& x) { return FT(x); });
    return result;
  }

  Place place(const FT s, const FT t) const
  {
    CGAL_precondition(s >= 0 && s <= 1 && t >= 0 && t <= 1);
    if (is_regular())
      return {false, whole_face, 0, 0, s, t};
    if (s == 0 && t == 0)
      return {true, 0, 0, 0, s, t};
    int exponent;
    std::frexp((std::max)(s, t), &exponent);
    const int level = (std::max)(1, 1 - exponent); // the coordinate 1 belongs to level 1, too
    const FT x = std::ldexp(s, level), y = std::ldexp(t, level);
    const int part = y < 1 ? 0 : x < 1 ? 2 : 1;
    return {false, part, level - 1, level, part == 2 ? x : x - 1, part == 0 ? y : y - 1};
  }

  static FT power(FT base, int exponent)
  {
    FT result(1);
    for (; exponent != 0; exponent /= 2, base *= base)
      if (exponent % 2 != 0)
        result *= base;
    return result;
  }

  void add_modes(const std::vector<Vector_4>& coefficients, const Place& place, std::array<Image, 4>& patch) const
  {
    // In blocks, so that the coefficients at the level fit on the stack and the sums into registers.
    constexpr std::size_t block_size = 16;
    const std::vector<Image>& images = m_images[place.part];
    FT factor(1);
    for (std::size_t first = 1; first < images.size(); first += block_size) {
      const std::size_t size = (std::min)(block_size, images.size() - first);
      std::array<Vector_4, block_size> scaled;
      for (std::size_t i = 0; i < size; ++i) {
        if (m_ratios[first + i] != m_ratios[first + i - 1]) // most come in pairs
          factor = power(m_ratios[first + i], place.steps);
        for (int c = 0; c < 4; ++c)
          scaled[i][c] = factor * coefficients[first + i][c];
      }
      for (int c = 0; c < 4; ++c) {
        Image sum = patch[c];
        for (std::size_t i = 0; i < size; ++i)
          for (int j = 0; j < 16; ++j)
            sum[j] += images[first + i][j] * scaled[i][c];
        patch[c] = sum;
      }
    }
  }

  /// The factors by which the subdominant modes and their derivatives have changed since the first level.
  Scales scales(const Place& place) const
  {
    // The power of 2 lambda stays in the range of FT where the power of lambda does not.
    const FT growth = std::pow(m_growth, FT(place.steps)) * (1 + FT(place.steps) * m_growth_error);
    const int shift = place.exponent - place.steps, half = place.exponent / 2;
    return {{{growth, std::ldexp(FT(1), -place.steps)},
             {growth, std::ldexp(FT(1), shift)},
             {std::ldexp(growth, half), std::ldexp(FT(1), shift + place.exponent - half)}}};
  }

  static void scale(const Scales& scales, const int order, Scalar_derivatives& d)
  {
    for (int k = 0, i = 0; k <= order; ++k)
      for (int e = 0; e <= k; ++e, ++i)
        d[i] = d[i] * scales[k][0] * scales[k][1];
  }

  int m_valence;
  std::vector<FT> m_eigenvalues;
  std::vector<FT> m_ratios;                                ///< of the eigenvalues to the subdominant one
  FT m_growth;                                             ///< twice the subdominant eigenvalue
  FT m_growth_error;                                       ///< relative: what has been rounded off
  std::vector<FT> m_right, m_left;                         ///< one eigenvector after the other
  std::array<std::vector<Image>, whole_face + 1> m_images; ///< of the right eigenvectors, per part
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EIGENSTRUCTURE_H
