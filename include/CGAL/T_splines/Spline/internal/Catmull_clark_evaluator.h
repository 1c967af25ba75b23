// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EVALUATOR_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EVALUATOR_H

#include <CGAL/T_splines/Spline/internal/Catmull_clark_eigenstructure.h>
#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>
#include <CGAL/T_splines/Spline/internal/Homogeneous_vector.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The Catmull-Clark limit surface by repeated subdivision, with the interface of `Catmull_clark_eigenstructure`, for
/// number types without eigenvectors: with an exact type, the surface is exact.
///
/// An evaluation at a distance of 2^-k from the extraordinary vertex takes k subdivisions.
/// \tparam FT a model of `Field` and `RealEmbeddable`
template <typename FT_>
class Catmull_clark_by_subdivision {
public:
  using FT = FT_;
  using Vector_4 = std::array<FT, 4>;
  using Derivatives = std::array<Vector_4, 6>;
  using Scalar_derivatives = std::array<FT, 6>;

  explicit Catmull_clark_by_subdivision(const int valence) : m_rules(valence) {}

  int valence() const { return m_rules.valence(); }
  int number_of_controls() const { return m_rules.number_of_controls(); }

  std::vector<Vector_4> project(const std::vector<Vector_4>& controls) const { return controls; }

  void evaluate(const std::vector<Vector_4>& controls, const FT& s, const FT& t, int /*order*/, Derivatives& out) const
  {
    // Without the limit position, which has no derivatives, these keep their relative accuracy longer.
    const std::vector<FT> weights = m_rules.limit_weights();
    Row limit{{FT(0), FT(0), FT(0), FT(0)}};
    for (std::size_t i = 0; i < controls.size(); ++i)
      limit = limit + Row{controls[i]} * weights[i];
    std::vector<Row> rows;
    for (const Vector_4& c : controls)
      rows.push_back(Row{c} + limit * FT(-1));
    const Jet jet = this->jet(std::move(rows), s, t);
    for (int i = 0; i < 6; ++i)
      out[i] = jet[i].values;
    out[0] = (jet[0] + limit).values;
  }

  void basis(const FT& s, const FT& t, const int order, std::vector<Scalar_derivatives>& out) const
  {
    const int size = number_of_controls();
    out.assign(size, Scalar_derivatives{});
    for (int first = 0; first < size; first += 4) { // four basis functions at a time
      std::vector<Vector_4> controls(size, Vector_4{FT(0), FT(0), FT(0), FT(0)});
      for (int c = 0; c < 4 && first + c < size; ++c)
        controls[first + c][c] = FT(1);
      Derivatives d;
      evaluate(controls, s, t, order, d);
      for (int c = 0; c < 4 && first + c < size; ++c)
        for (int i = 0; i < 6; ++i)
          out[first + c][i] = d[i][c];
    }
  }

  /// As `Catmull_clark_eigenstructure::tangents()`, with weights in double precision; zero at a vertex of valence 1,
  /// where there is no tangent plane.
  std::array<Vector_4, 2> tangents(const std::vector<Vector_4>& controls) const
  {
    if (valence() == 1)
      return {Vector_4{FT(0), FT(0), FT(0), FT(0)}, Vector_4{FT(0), FT(0), FT(0), FT(0)}};
    const auto weights = Catmull_clark_subdivision<double>(valence()).tangent_weights();
    const Vector_4 zero{FT(0), FT(0), FT(0), FT(0)};
    std::array<Vector_4, 2> result{zero, zero};
    for (std::size_t i = 0; i < controls.size(); ++i)
      for (int c = 0; c < 4; ++c) {
        result[0][c] += FT(weights.first[i]) * controls[i][c];
        result[1][c] += FT(weights.second[i]) * controls[i][c];
      }
    return result;
  }

private:
  using Row = Homogeneous_vector<FT>;
  using Jet = std::array<Row, 6>;

  // \pre the limit position of the controls is zero
  Jet jet(std::vector<Row> controls, FT s, FT t) const
  {
    const FT half = FT(1) / FT(2), zero(0);
    const Row none{{zero, zero, zero, zero}};
    Jet result{none, none, none, none, none, none};
    if (s == zero && t == zero)
      return result;
    FT scale(2);
    while (s < half && t < half) {
      controls = m_rules.subdivided(controls);
      s *= FT(2);
      t *= FT(2);
      scale *= FT(2);
    }
    const int part = s < half ? 2 : t < half ? 0 : 1;
    controls = m_rules.part_controls(std::move(controls), 1, part);
    const FT x = part == 2 ? FT(FT(2) * s) : FT(FT(2) * s - FT(1)),
             y = part == 0 ? FT(FT(2) * t) : FT(FT(2) * t - FT(1));
    const std::array<std::array<int, 2>, 6> orders{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    for (int d = 0; d < 6; ++d) {
      const std::array<FT, 4> b = uniform_cubic_segments(x, orders[d][0]), c = uniform_cubic_segments(y, orders[d][1]);
      FT factor(1);
      for (int k = 0; k < orders[d][0] + orders[d][1]; ++k)
        factor *= scale;
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
          result[d] = result[d] + controls[4 * j + i] * FT(b[i] * c[j] * factor);
    }
    return result;
  }

  Catmull_clark_subdivision<FT> m_rules;
};

/// The Catmull-Clark limit surface in floating point: by eigenvectors if the valence is at least 3, else by
/// subdivision.
template <typename FT_>
class Catmull_clark_by_eigenvectors {
public:
  using FT = FT_;
  using Vector_4 = std::array<FT, 4>;
  using Derivatives = std::array<Vector_4, 6>;
  using Scalar_derivatives = std::array<FT, 6>;

  explicit Catmull_clark_by_eigenvectors(const int valence) : m_subdivision(valence)
  {
    if (valence >= 3)
      m_eigenstructure.emplace(valence);
  }

  int valence() const { return m_subdivision.valence(); }
  int number_of_controls() const { return m_subdivision.number_of_controls(); }

  std::vector<Vector_4> project(const std::vector<Vector_4>& controls) const
  {
    return m_eigenstructure ? m_eigenstructure->project(controls) : controls;
  }

  void evaluate(const std::vector<Vector_4>& coefficients, const FT s, const FT t, const int order,
                Derivatives& out) const
  {
    if (m_eigenstructure)
      m_eigenstructure->evaluate(coefficients, s, t, order, out);
    else
      m_subdivision.evaluate(coefficients, s, t, order, out);
  }

  void basis(const FT s, const FT t, const int order, std::vector<Scalar_derivatives>& out) const
  {
    if (m_eigenstructure)
      m_eigenstructure->basis(s, t, order, out);
    else
      m_subdivision.basis(s, t, order, out);
  }

  std::array<Vector_4, 2> tangents(const std::vector<Vector_4>& coefficients) const
  {
    return m_eigenstructure ? m_eigenstructure->tangents(coefficients) : m_subdivision.tangents(coefficients);
  }

private:
  Catmull_clark_by_subdivision<FT> m_subdivision;
  std::optional<Catmull_clark_eigenstructure<FT>> m_eigenstructure;
};

/// How the faces at extraordinary vertices are evaluated in a number type.
template <typename FT>
using Catmull_clark_evaluator =
    std::conditional_t<std::is_same<FT, double>::value || std::is_same<FT, long double>::value,
                       Catmull_clark_by_eigenvectors<FT>, Catmull_clark_by_subdivision<FT>>;

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_EVALUATOR_H
