// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_H
#define CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_H

#include <CGAL/T_splines/Solver/support/Hermitian_rows.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A group of unknowns for each unknown of the next coarser grid.
template <typename Scalar>
struct Aggregates {
  std::vector<int> aggregate; ///< per unknown: its group, or -1 if it is coupled to none
  std::vector<Scalar> unit;   ///< per unknown: of absolute value 1; where all are parallel, the function is smooth
  int number = 0;
};

/// groups each unknown with those around it that it is strongly coupled with (Vanek, Mandel, Brezina, Algebraic multigrid by
/// smoothed aggregation for second and fourth order elliptic problems, 1996).
///
/// An entry counts as strong if it is at least `threshold` times as large as the largest ones in its row and in its column.
template <typename Scalar>
class Aggregation {
  static constexpr int none = -1;

public:
  Aggregation(const Hermitian_rows<Scalar>& matrix, const double threshold)
    : m_matrix(matrix),
      m_threshold(threshold),
      m_largest(matrix.size(), 0.)
  {
    for (int i = 0; i < matrix.size(); ++i)
      for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k)
        m_largest[i] = (std::max)(m_largest[i], magnitude(matrix.entry[k].value));
  }

  bool is_strong(const int i, const typename Hermitian_rows<Scalar>::Entry& entry) const
  {
    const double size = magnitude(entry.value);
    return size > 0 && size >= m_threshold * (std::max)(m_largest[i], m_largest[entry.column]);
  }

  Aggregates<Scalar> aggregates() const
  {
    const int n = m_matrix.size();
    Aggregates<Scalar> result;
    result.aggregate.assign(n, none);
    result.unit.assign(n, Scalar(1));
    for (int i = 0; i < n; ++i)
      if (result.aggregate[i] == none && all_strong_are_free(i, result))
        gather(i, result);
    join_neighbors(result);
    for (int i = 0; i < n; ++i)
      if (result.aggregate[i] == none && m_largest[i] > 0)
        gather(i, result);
    return result;
  }

private:
  bool all_strong_are_free(const int i, const Aggregates<Scalar>& result) const
  {
    bool has_strong = false;
    for (std::size_t k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k) {
      if (!is_strong(i, m_matrix.entry[k]))
        continue;
      has_strong = true;
      if (result.aggregate[m_matrix.entry[k].column] != none)
        return false;
    }
    return has_strong;
  }

  // A new group of i and those strongly coupled with it that have none.
  void gather(const int i, Aggregates<Scalar>& result) const
  {
    result.aggregate[i] = result.number;
    for (std::size_t k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k) {
      const auto& entry = m_matrix.entry[k];
      if (result.aggregate[entry.column] != none || !is_strong(i, entry))
        continue;
      result.aggregate[entry.column] = result.number;
      result.unit[entry.column] = carried(conjugate(entry.value), result.unit[i]);
    }
    ++result.number;
  }

  // Those left over go to the group that they are coupled with most strongly.
  void join_neighbors(Aggregates<Scalar>& result) const
  {
    constexpr double margin = 1 + 1e-6; // round-off must not decide between equals
    std::vector<std::pair<int, std::size_t>> joining;
    for (int i = 0; i < m_matrix.size(); ++i) {
      if (result.aggregate[i] != none)
        continue;
      const std::size_t end = m_matrix.begin[i + 1];
      std::size_t best = end;
      for (std::size_t k = m_matrix.begin[i]; k < end; ++k) {
        const auto& entry = m_matrix.entry[k];
        if (result.aggregate[entry.column] != none && is_strong(i, entry) &&
            (best == end || magnitude(entry.value) > margin * magnitude(m_matrix.entry[best].value)))
          best = k;
      }
      if (best != end)
        joining.emplace_back(i, best);
    }
    for (const auto& [i, k] : joining) {
      result.aggregate[i] = result.aggregate[m_matrix.entry[k].column];
      result.unit[i] = carried(m_matrix.entry[k].value, result.unit[m_matrix.entry[k].column]);
    }
  }

  // The value that makes the energy of an entry smallest, given that at the other end.
  static Scalar carried(const Scalar& value, const Scalar& from)
  {
    const Scalar result = product(value, from);
    return result * (-1 / magnitude(result));
  }

  const Hermitian_rows<Scalar>& m_matrix;
  double m_threshold;
  std::vector<double> m_largest; // per row: the largest entry off the diagonal
};

/// Algebraic multigrid by smoothed aggregation, for the energies of functions and of sections on triangle meshes: a cycle
/// costs as much as some products with the matrix, and is nearly as good as its inverse.
///
/// \tparam Scalar `double` or `std::complex<double>`
template <typename Scalar>
class Multigrid {
  using Rows = Hermitian_rows<Scalar>;
  using Vector = std::vector<Scalar>;

public:
  /// \param matrix positive definite
  /// \param progress if it is interrupted, levels are missing, and cycles are nothing worth
  Multigrid(Rows matrix, Progress& progress)
  {
    m_levels.emplace_back();
    m_levels.back().matrix = std::move(matrix);
    while (m_levels.back().matrix.size() > size_of_coarsest && progress.go_on() && add_level(progress))
      ;
    factorize_coarsest();
  }

  int number_of_levels() const { return static_cast<int>(m_levels.size()); }

  /// The matrix on level `l`; on level 0 it is the one given.
  const Rows& matrix(const int l) const { return m_levels[l].matrix; }

  /// approximates the solution z of A z = r on level `l`: one cycle, symmetric and positive definite.
  void cycle(const Vector& r, Vector& z, const int l = 0)
  {
    if (l + 1 == number_of_levels()) {
      solve_coarsest(r, z);
      return;
    }
    Level& level = m_levels[l];
    sweep_forward(level.matrix, r, z, level.residual);
    restrict_to_coarser(level, level.residual, level.coarse_residual);
    cycle(level.coarse_residual, level.coarse_correction, l + 1);
    prolongate(l, level.coarse_correction, z);
    sweep_backward(level.matrix, r, z);
  }

  /// adds a vector on level `l` + 1, carried over to level `l`, to `z`.
  void prolongate(const int l, const Vector& coarse, Vector& z) const
  {
    const Rectangle& p = m_levels[l].prolongation;
    for (std::size_t i = 0; i < z.size(); ++i)
      for (std::size_t k = p.begin[i]; k < p.begin[i + 1]; ++k)
        z[i] += product(p.entry[k].value, coarse[p.entry[k].column]);
  }

  /// distributes masses of level `l` to level `l` + 1.
  std::vector<double> coarser_masses(const int l, const std::vector<double>& mass) const
  {
    const Rectangle& p = m_levels[l].prolongation;
    std::vector<double> result(m_levels[l + 1].matrix.size(), 0.);
    for (std::size_t i = 0; i < mass.size(); ++i)
      for (std::size_t k = p.begin[i]; k < p.begin[i + 1]; ++k)
        result[p.entry[k].column] += mass[i] * magnitude(p.entry[k].value);
    return result;
  }

private:
  static constexpr int size_of_coarsest = 100;
  using Entry = typename Rows::Entry;

  struct Rectangle {
    std::vector<std::size_t> begin = {0};
    std::vector<Entry> entry;
  };

  struct Level {
    Rows matrix;
    Rectangle prolongation; // from the next level
    int coarse_size = 0;
    Vector residual, coarse_residual, coarse_correction;
  };

  bool add_level(Progress& progress)
  {
    constexpr double thresholds[] = {0.25, 0.}; // of couplings that count as strong; if few are, all
    for (const double threshold : thresholds) {
      const Rows& matrix = m_levels.back().matrix;
      const Aggregation<Scalar> aggregation(matrix, threshold);
      const Aggregates<Scalar> aggregates = aggregation.aggregates();
      if (2 * aggregates.number > matrix.size() && threshold > 0)
        continue; // too many that are coupled strongly with none
      if (aggregates.number == 0)
        return false; // a diagonal matrix
      if (!progress.go_on())
        return false;
      m_levels.back().prolongation = smoothed(matrix, aggregation, aggregates);
      m_levels.back().coarse_size = aggregates.number;
      if (!progress.go_on())
        return false;
      Rows coarse = coarser_matrix(matrix, m_levels.back().prolongation, aggregates.number, progress);
      m_levels.emplace_back();
      m_levels.back().matrix = std::move(coarse);
      return true;
    }
    return false;
  }

  // One step of Jacobi's method, damped by the sums of the rows' absolute values, on the matrix without its weak entries.
  static Rectangle smoothed(const Rows& matrix, const Aggregation<Scalar>& aggregation,
                            const Aggregates<Scalar>& aggregates)
  {
    constexpr double damping = 4. / 3;
    Rectangle result;
    result.begin.reserve(matrix.size() + 1);
    for (int i = 0; i < matrix.size(); ++i) {
      const std::size_t first = result.entry.size();
      double diagonal = matrix.diagonal[i], sum = 0;
      for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k) {
        const double size = magnitude(matrix.entry[k].value);
        if (aggregation.is_strong(i, matrix.entry[k]))
          sum += size;
        else
          diagonal -= size;
      }
      diagonal = (std::max)(diagonal, 0.);
      const double factor = damping / (diagonal + sum);
      const auto add_entry = [&](const int j, const Scalar& value) {
        const int column = aggregates.aggregate[j];
        if (column < 0)
          return;
        const Scalar scaled = product(value, aggregates.unit[j]);
        for (std::size_t k = first; k < result.entry.size(); ++k) {
          if (result.entry[k].column == column) {
            result.entry[k].value += scaled;
            return;
          }
        }
        result.entry.push_back({column, scaled});
      };
      if (sum > 0) {
        add_entry(i, Scalar(1 - factor * diagonal));
        for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k)
          if (aggregation.is_strong(i, matrix.entry[k]))
            add_entry(matrix.entry[k].column, -factor * matrix.entry[k].value);
      }
      else
        add_entry(i, Scalar(1));
      result.begin.push_back(result.entry.size());
    }
    return result;
  }

  // P^H A P.
  static Rows coarser_matrix(const Rows& matrix, const Rectangle& p, const int size, Progress& progress)
  {
    const std::size_t n = matrix.size();
    std::vector<std::size_t> begin(size + 1, 0);
    for (const Entry& entry : p.entry)
      ++begin[entry.column + 1];
    for (int a = 0; a < size; ++a)
      begin[a + 1] += begin[a];
    std::vector<Entry> transposed(p.entry.size());
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = p.begin[i]; k < p.begin[i + 1]; ++k)
        transposed[end[p.entry[k].column]++] = {static_cast<int>(i), conjugate(p.entry[k].value)};
    Rows result;
    result.diagonal.assign(size, 0.);
    std::vector<int> place(size, -1); // in the row that is summed up
    std::vector<Entry> row;
    for (int a = 0; a < size; ++a) {
      progress.go_on_after(100);
      row.assign(1, Entry{a, Scalar(0)});
      place[a] = 0;
      const auto add_row = [&](const Scalar& factor, const int j) {
        for (std::size_t k = p.begin[j]; k < p.begin[j + 1]; ++k) {
          int& at = place[p.entry[k].column];
          if (at < 0) {
            at = static_cast<int>(row.size());
            row.push_back({p.entry[k].column, Scalar(0)});
          }
          row[at].value += product(factor, p.entry[k].value);
        }
      };
      for (std::size_t t = begin[a]; t < begin[a + 1]; ++t) {
        const int i = transposed[t].column;
        add_row(transposed[t].value * matrix.diagonal[i], i);
        for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k)
          add_row(product(transposed[t].value, matrix.entry[k].value), matrix.entry[k].column);
      }
      result.diagonal[a] = real_part(row.front().value);
      result.entry.insert(result.entry.end(), row.begin() + 1, row.end());
      result.begin.push_back(result.entry.size());
      for (const Entry& entry : row)
        place[entry.column] = -1;
    }
    result.sort_rows();
    return result;
  }

  // Gauss and Seidel's method from zero, and the residual that it leaves.
  static void sweep_forward(const Rows& matrix, const Vector& r, Vector& z, Vector& residual)
  {
    z.resize(r.size());
    residual.resize(r.size());
    for (int i = 0; i < matrix.size(); ++i) {
      Scalar sum = r[i];
      for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1] && matrix.entry[k].column < i; ++k)
        sum -= product(matrix.entry[k].value, z[matrix.entry[k].column]);
      z[i] = sum / matrix.diagonal[i];
    }
    for (int i = 0; i < matrix.size(); ++i) {
      Scalar sum(0);
      for (std::size_t k = matrix.begin[i + 1]; k > matrix.begin[i] && matrix.entry[k - 1].column > i; --k)
        sum -= product(matrix.entry[k - 1].value, z[matrix.entry[k - 1].column]);
      residual[i] = sum;
    }
  }

  static void sweep_backward(const Rows& matrix, const Vector& r, Vector& z)
  {
    for (int i = matrix.size() - 1; i >= 0; --i)
      z[i] = (r[i] - matrix.row_product(i, z)) / matrix.diagonal[i];
  }

  static void restrict_to_coarser(const Level& level, const Vector& fine, Vector& coarse)
  {
    const Rectangle& p = level.prolongation;
    coarse.assign(level.coarse_size, Scalar(0));
    for (std::size_t i = 0; i < fine.size(); ++i)
      for (std::size_t k = p.begin[i]; k < p.begin[i + 1]; ++k)
        coarse[p.entry[k].column] += product(conjugate(p.entry[k].value), fine[i]);
  }

  void factorize_coarsest()
  {
    const Rows& matrix = m_levels.back().matrix;
    const int n = matrix.size();
    m_factor.clear();
    if (n > size_of_coarsest)
      return;
    m_factor.assign(static_cast<std::size_t>(n) * n, Scalar(0));
    for (int i = 0; i < n; ++i) {
      m_factor[i * n + i] = matrix.diagonal[i];
      for (std::size_t k = matrix.begin[i]; k < matrix.begin[i + 1]; ++k)
        m_factor[i * n + matrix.entry[k].column] = matrix.entry[k].value;
    }
    constexpr double smallest_pivot = 1e-14; // by the diagonal: semidefinite matrices have pivots that should be 0
    for (int j = 0; j < n; ++j) {            // L L^H
      double pivot = real_part(m_factor[j * n + j]);
      for (int k = 0; k < j; ++k)
        pivot -= real_part(product(conjugate(m_factor[j * n + k]), m_factor[j * n + k]));
      pivot = std::sqrt((std::max)(pivot, smallest_pivot * matrix.diagonal[j]));
      m_factor[j * n + j] = pivot;
      for (int i = j + 1; i < n; ++i) {
        Scalar sum = m_factor[i * n + j];
        for (int k = 0; k < j; ++k)
          sum -= product(m_factor[i * n + k], conjugate(m_factor[j * n + k]));
        m_factor[i * n + j] = sum / pivot;
      }
    }
  }

  void solve_coarsest(const Vector& r, Vector& z) const
  {
    const Rows& matrix = m_levels.back().matrix;
    const int n = matrix.size();
    z = r;
    if (m_factor.empty()) { // the matrix is a diagonal one
      for (int i = 0; i < n; ++i)
        z[i] /= matrix.diagonal[i];
      return;
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < i; ++k)
        z[i] -= product(m_factor[i * n + k], z[k]);
      z[i] /= real_part(m_factor[i * n + i]);
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int k = i + 1; k < n; ++k)
        z[i] -= product(conjugate(m_factor[k * n + i]), z[k]);
      z[i] /= real_part(m_factor[i * n + i]);
    }
  }

  std::vector<Level> m_levels; // from fine to coarse
  Vector m_factor;             // of the matrix on the coarsest level
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_H
