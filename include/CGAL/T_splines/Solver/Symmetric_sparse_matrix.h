// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SYMMETRIC_SPARSE_MATRIX_H
#define CGAL_T_SPLINES_SOLVER_SYMMETRIC_SPARSE_MATRIX_H

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSolver
/// A symmetric sparse matrix: its lower triangle, diagonal included, in compressed columns.
///
/// It is the language between the algorithms of this package and the models of `SparseSpdSolverTraits`. Within a
/// column the row indices increase strictly, and the first of them is the column's own.
/// \tparam FT a floating-point type.
template <typename FT_>
struct Symmetric_sparse_matrix {
  using FT = FT_; ///< number type of the entries

  std::vector<int> column_begin = {0}; ///< size + 1 entries: where each column starts in `row` and `value`
  std::vector<int> row;                ///< row index of each stored entry
  std::vector<FT> value;               ///< value of each stored entry

  /// returns the number of rows.
  int size() const { return static_cast<int>(column_begin.size()) - 1; }
  /// returns the number of stored entries.
  std::size_t number_of_entries() const { return row.size(); }

  /// computes y = A x. \pre x.size() == size(). Complexity: linear in the number of entries.
  void multiply(const std::vector<FT>& x, std::vector<FT>& y) const
  {
    const int n = size();
    CGAL_precondition(x.size() == static_cast<std::size_t>(n));
    y.assign(n, FT(0));
    for (int j = 0; j < n; ++j) {
      int entry = column_begin[j];
      const int end = column_begin[j + 1];
      const FT x_j = x[j];
      FT sum = value[entry] * x_j;
      for (++entry; entry < end; ++entry) {
        sum += value[entry] * x[row[entry]];
        y[row[entry]] += value[entry] * x_j;
      }
      y[j] += sum;
    }
  }
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SYMMETRIC_SPARSE_MATRIX_H
