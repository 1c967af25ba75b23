// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SUPPORT_HERMITIAN_ROWS_H
#define CGAL_T_SPLINES_SOLVER_SUPPORT_HERMITIAN_ROWS_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The arithmetic that real and complex matrices share. The product of complex numbers is written out: the operator
// of the standard library looks for NaNs.
inline double product(const double a, const double b)
{
  return a * b;
}
inline double conjugate(const double a)
{
  return a;
}
inline double real_part(const double a)
{
  return a;
}
inline double magnitude(const double a)
{
  return std::abs(a);
}
inline std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b)
{
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
inline std::complex<double> conjugate(const std::complex<double>& a)
{
  return std::conj(a);
}
inline double real_part(const std::complex<double>& a)
{
  return a.real();
}
inline double magnitude(const std::complex<double>& a)
{
  return std::sqrt(a.real() * a.real() + a.imag() * a.imag());
}

/// The real scalar product of vectors of real or complex numbers.
template <typename Scalar>
double dot(const std::vector<Scalar>& a, const std::vector<Scalar>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += real_part(product(conjugate(a[i]), b[i]));
  return sum;
}

/// a += factor b.
template <typename Scalar>
void add(std::vector<Scalar>& a, const double factor, const std::vector<Scalar>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
}

/// A sparse Hermitian matrix, row by row: the diagonal, and the entries off it, of both triangles, by increasing column.
/// \tparam Scalar `double` or `std::complex<double>`
template <typename Scalar>
struct Hermitian_rows {
  struct Entry {
    int column;
    Scalar value;
  };

  std::vector<std::size_t> begin = {0}; ///< size + 1 places: where each row starts in `entry`
  std::vector<Entry> entry;
  std::vector<double> diagonal;

  int size() const { return static_cast<int>(diagonal.size()); }

  /// The entries of row `i` off the diagonal times those of `x`, summed up.
  Scalar row_product(const int i, const std::vector<Scalar>& x) const
  {
    Scalar sum(0);
    for (std::size_t k = begin[i]; k < begin[i + 1]; ++k)
      sum += product(entry[k].value, x[entry[k].column]);
    return sum;
  }

  /// computes y = A x.
  void multiply(const std::vector<Scalar>& x, std::vector<Scalar>& y) const
  {
    CGAL_precondition(x.size() == diagonal.size());
    y.resize(x.size());
    for (int i = 0; i < size(); ++i)
      y[i] = diagonal[i] * x[i] + row_product(i, x);
  }

  struct Lower_entry {
    int row, column; ///< row > column
    Scalar value;
  };

  /// makes a matrix from its diagonal and the entries of its lower triangle, in any order; those at equal places are
  /// added.
  static Hermitian_rows from_lower_triangle(const std::vector<double>& diagonal,
                                            const std::vector<Lower_entry>& entries)
  {
    const std::size_t n = diagonal.size();
    Hermitian_rows unsorted;
    unsorted.diagonal = diagonal;
    unsorted.begin.assign(n + 1, 0);
    for (const Lower_entry& e : entries) {
      ++unsorted.begin[e.row + 1];
      ++unsorted.begin[e.column + 1];
    }
    for (std::size_t i = 0; i < n; ++i)
      unsorted.begin[i + 1] += unsorted.begin[i];
    unsorted.entry.resize(2 * entries.size());
    std::vector<std::size_t> end(unsorted.begin.begin(), unsorted.begin.end() - 1);
    for (const Lower_entry& e : entries) {
      unsorted.entry[end[e.row]++] = {e.column, e.value};
      unsorted.entry[end[e.column]++] = {e.row, conjugate(e.value)};
    }
    unsorted.sort_rows();
    return unsorted;
  }

  /// sorts the entries of each row by columns and adds those at equal places.
  void sort_rows()
  {
    std::size_t end = 0, first = 0;
    for (int i = 0; i < size(); ++i) {
      const std::size_t last = begin[i + 1], row_begin = end;
      std::sort(entry.begin() + static_cast<std::ptrdiff_t>(first), entry.begin() + static_cast<std::ptrdiff_t>(last),
                [](const Entry& a, const Entry& b) { return a.column < b.column; });
      for (std::size_t k = first; k < last; ++k) {
        if (end > row_begin && entry[end - 1].column == entry[k].column)
          entry[end - 1].value += entry[k].value;
        else
          entry[end++] = entry[k];
      }
      begin[i + 1] = end;
      first = last;
    }
    entry.resize(end);
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SUPPORT_HERMITIAN_ROWS_H
