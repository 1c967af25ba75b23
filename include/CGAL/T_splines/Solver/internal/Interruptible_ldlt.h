// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_INTERNAL_INTERRUPTIBLE_LDLT_H
#define CGAL_T_SPLINES_SOLVER_INTERNAL_INTERRUPTIBLE_LDLT_H

#ifdef CGAL_EIGEN3_ENABLED

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Eigen's LDL^T, with a numeric factorization that can be given up: a factorization is the longest piece of work of
/// many a computation, and Eigen's own does not look up from it.
///
/// It computes L by rows, as Eigen does, by the algorithm of T. A. Davis, "Algorithm 849: A concise sparse Cholesky
/// factorization package", ACM TOMS 31 (2005).
template <typename Matrix, int UpLo, typename Ordering>
class Interruptible_ldlt : public Eigen::SimplicialLDLT<Matrix, UpLo, Ordering> {
  using Base = Eigen::SimplicialLDLT<Matrix, UpLo, Ordering>;
  using FT = typename Base::Scalar;
  using Index = typename Base::StorageIndex;
  using Permuted = Eigen::SparseMatrix<FT, Eigen::ColMajor, Index>;

public:
  /// \param go_on is asked every few milliseconds, and may be empty
  /// \return false if a pivot is not positive, or `go_on` says no
  bool factorize(const Matrix& a, const std::function<bool()>& go_on)
  {
    Permuted permuted(a.rows(), a.cols());
    permuted.template selfadjointView<Eigen::Upper>() =
        a.template selfadjointView<static_cast<unsigned int>(UpLo)>().twistedBy(this->m_P);
    const Index n = static_cast<Index>(permuted.cols());
    Row_workspace workspace(n);
    this->m_diag.resize(n);
    this->m_info = Eigen::Success;
    std::size_t work = 0;
    for (Index k = 0; k < n && this->m_info == Eigen::Success; ++k) {
      work += find_row(permuted, k, workspace);
      work += compute_row(k, workspace);
      if (work > work_per_question) {
        work = 0;
        if (go_on && !go_on())
          this->m_info = Eigen::InvalidInput;
      }
    }
    this->m_factorizationIsOk = this->m_info == Eigen::Success;
    return this->m_factorizationIsOk;
  }

private:
  static constexpr std::size_t work_per_question = 1 << 22; // products

  struct Row_workspace {
    std::vector<FT> y;          // the row that is computed, 0 elsewhere
    std::vector<Index> visited; // the last row that reached a column
    std::vector<Index> path, pattern;
    std::vector<Index> count; // entries of each column so far
    Index begin = 0;          // of the columns of the row, in `pattern`

    explicit Row_workspace(const Index n)
      : y(static_cast<std::size_t>(n), FT(0)),
        visited(static_cast<std::size_t>(n), Index(-1)),
        path(static_cast<std::size_t>(n)),
        pattern(static_cast<std::size_t>(n)),
        count(static_cast<std::size_t>(n), Index(0))
    {
    }
  };

  // Scatters row k of the matrix and finds the columns of row k of L: those from which the elimination tree leads to k
  // over an entry of the matrix, children first.
  std::size_t find_row(const Permuted& permuted, const Index k, Row_workspace& workspace) const
  {
    const Index n = static_cast<Index>(permuted.cols());
    workspace.begin = n;
    workspace.visited[k] = k;
    for (typename Permuted::InnerIterator entry(permuted, k); entry; ++entry) {
      Index i = static_cast<Index>(entry.index());
      workspace.y[i] += entry.value();
      Index length = 0;
      for (; workspace.visited[i] != k; i = this->m_parent[i]) {
        workspace.path[length++] = i;
        workspace.visited[i] = k;
      }
      while (length > 0)
        workspace.pattern[--workspace.begin] = workspace.path[--length];
    }
    return static_cast<std::size_t>(n - workspace.begin);
  }

  // Solves a triangular system for row k, and appends its entries to the columns of L.
  std::size_t compute_row(const Index k, Row_workspace& workspace)
  {
    const Index n = static_cast<Index>(workspace.y.size());
    const Index* const column_begin = this->m_matrix.outerIndexPtr();
    Index* const row = this->m_matrix.innerIndexPtr();
    FT* const value = this->m_matrix.valuePtr();
    FT* const y = workspace.y.data();
    FT pivot = y[k] * this->m_shiftScale + this->m_shiftOffset;
    y[k] = FT(0);
    std::size_t work = 0;
    for (Index top = workspace.begin; top < n; ++top) {
      const Index j = workspace.pattern[top];
      const FT y_j = y[j];
      y[j] = FT(0);
      const Index end = column_begin[j] + workspace.count[j]++;
      for (Index p = column_begin[j]; p < end; ++p)
        y[row[p]] -= value[p] * y_j;
      row[end] = k;
      value[end] = y_j / this->m_diag[j];
      pivot -= value[end] * y_j;
      work += static_cast<std::size_t>(end - column_begin[j]);
    }
    this->m_diag[k] = pivot;
    if (!(pivot > FT(0)))
      this->m_info = Eigen::NumericalIssue;
    return work;
  }
};

/// What a solver of Eigen is replaced by: the interruptible LDL^T, or itself.
template <typename EigenSolver>
struct Interruptible_solver {
  using type = EigenSolver;
};

template <typename Matrix, int UpLo, typename Ordering>
struct Interruptible_solver<Eigen::SimplicialLDLT<Matrix, UpLo, Ordering>> {
  using type = Interruptible_ldlt<Matrix, UpLo, Ordering>;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_T_SPLINES_SOLVER_INTERNAL_INTERRUPTIBLE_LDLT_H
