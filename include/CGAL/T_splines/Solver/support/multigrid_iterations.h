// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_ITERATIONS_H
#define CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_ITERATIONS_H

#include <CGAL/T_splines/Solver/support/Hermitian_rows.h>
#include <CGAL/T_splines/Solver/support/Multigrid.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// solves (a A + D) x = b by conjugate gradients, where A is the matrix of `multigrid`, which preconditions, and D >= 0 a
/// diagonal matrix.
/// \param x on entry a first guess
/// \param tolerance for the residual relative to b, both in the norm of the preconditioner
/// \param progress asked before each iteration; if it is interrupted, x is what has been reached
/// \return the number of iterations
template <typename Scalar>
int solve_with_multigrid(Multigrid<Scalar>& multigrid, const double a, const std::vector<double>& d,
                         const std::vector<Scalar>& b, std::vector<Scalar>& x, const double tolerance,
                         const int maximum_number_of_iterations, Progress& progress)
{
  const std::size_t n = b.size();
  std::vector<Scalar> r(n), z(n), p(n), q(n);
  const auto multiply = [&](const std::vector<Scalar>& from, std::vector<Scalar>& to) {
    multigrid.matrix(0).multiply(from, to);
    for (std::size_t i = 0; i < n; ++i)
      to[i] = a * to[i] + d[i] * from[i];
  };
  multigrid.cycle(b, z);
  const double goal = tolerance * tolerance * dot(b, z);
  multiply(x, q);
  for (std::size_t i = 0; i < n; ++i)
    r[i] = b[i] - q[i];
  double previous = 0;
  int iteration = 0;
  for (; iteration < maximum_number_of_iterations && progress.go_on_after(n); ++iteration) {
    multigrid.cycle(r, z);
    const double r_z = dot(r, z);
    if (!(r_z > goal))
      break;
    const double beta = iteration == 0 ? 0. : r_z / previous;
    previous = r_z;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = z[i] + beta * p[i];
    multiply(p, q);
    const double curvature = dot(p, q);
    if (!(curvature > 0))
      break;
    add(x, r_z / curvature, p);
    add(r, -r_z / curvature, q);
  }
  return iteration;
}

/// An eigenvector of the smallest eigenvalue of a symmetric matrix of at most three rows, by Jacobi's rotations.
inline std::array<double, 3> smallest_eigenvector_of(std::array<std::array<double, 3>, 3> matrix, const int size)
{
  std::array<std::array<double, 3>, 3> vector = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  for (int sweep = 0; sweep < 20; ++sweep) {
    for (int i = 0; i < size; ++i) {
      for (int j = i + 1; j < size; ++j) {
        const double angle = 0.5 * std::atan2(2 * matrix[i][j], matrix[j][j] - matrix[i][i]);
        const double c = std::cos(angle), s = std::sin(angle);
        const auto rotate = [c, s](double& x, double& y) {
          const double first = c * x - s * y;
          y = s * x + c * y;
          x = first;
        };
        for (int k = 0; k < size; ++k)
          rotate(matrix[i][k], matrix[j][k]);
        for (int k = 0; k < size; ++k)
          rotate(matrix[k][i], matrix[k][j]);
        for (int k = 0; k < size; ++k)
          rotate(vector[i][k], vector[j][k]);
      }
    }
  }
  int smallest = 0;
  for (int i = 1; i < size; ++i)
    if (matrix[i][i] < matrix[smallest][smallest])
      smallest = i;
  return vector[smallest];
}

/// Rayleigh and Ritz's method on the span of the iterate, the preconditioned residual and the last step (Knyazev, Toward the
/// optimal preconditioned eigensolver, 2001), on one level of a multigrid.
template <typename Scalar>
class Eigenvector_iteration {
  using Vector = std::vector<Scalar>;

public:
  /// \param mass the diagonal of M, positive, on level `level`
  /// \param x a first guess, not zero
  Eigenvector_iteration(Multigrid<Scalar>& multigrid, const int level, const std::vector<double>& mass, Vector x)
    : m_multigrid(multigrid),
      m_level(level),
      m_mass(mass)
  {
    m_basis[0].vector = std::move(x);
    multigrid.matrix(level).multiply(m_basis[0].vector, m_basis[0].image);
    normalize(m_basis[0]);
  }

  /// \return by how much the eigenvalue fell.
  double step()
  {
    const std::size_t n = m_mass.size();
    const double before = eigenvalue();
    m_residual.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      m_residual[i] = m_basis[0].image[i] - before * m_mass[i] * m_basis[0].vector[i];
    Direction& correction = m_basis[1];
    m_multigrid.cycle(m_residual, correction.vector, m_level);
    m_multigrid.matrix(m_level).multiply(correction.vector, correction.image);
    int size = 1;
    if (make_orthonormal(correction, 1))
      size = 2;
    if (size == 2 && m_has_last_step && make_orthonormal(m_basis[2], 2))
      size = 3;
    if (size == 1)
      return 0;
    combine(size);
    return before - eigenvalue();
  }

  double eigenvalue() const { return dot(m_basis[0].vector, m_basis[0].image); }
  const Vector& vector() const { return m_basis[0].vector; } ///< of length 1 with respect to M

private:
  struct Direction {
    Vector vector, image; // v and A v
  };

  double product_with_mass(const Vector& a, const Vector& b) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += m_mass[i] * real_part(product(conjugate(a[i]), b[i]));
    return sum;
  }

  bool normalize(Direction& direction) const
  {
    const double length = std::sqrt(product_with_mass(direction.vector, direction.vector));
    if (!(length > 0))
      return false;
    for (Vector* v : {&direction.vector, &direction.image})
      for (Scalar& entry : *v)
        entry /= length;
    return true;
  }

  // Against the first `size` vectors of the basis; a direction that hardly differs from their span is given up.
  bool make_orthonormal(Direction& direction, const int size) const
  {
    if (!normalize(direction))
      return false;
    constexpr double nothing = 1e-14; // of a squared norm: what is left is the round-off of the subtractions
    for (int pass = 0; pass < 2; ++pass) {
      double left = 1;
      for (int k = 0; k < size; ++k) {
        const double part = product_with_mass(m_basis[k].vector, direction.vector);
        add(direction.vector, -part, m_basis[k].vector);
        add(direction.image, -part, m_basis[k].image);
        left -= part * part;
      }
      if (!(left > nothing) || !normalize(direction))
        return false;
    }
    return true;
  }

  void combine(const int size)
  {
    std::array<std::array<double, 3>, 3> matrix = {};
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j)
        matrix[i][j] = matrix[j][i] = dot(m_basis[i].vector, m_basis[j].image);
    const std::array<double, 3> c = smallest_eigenvector_of(matrix, size);
    Direction& last = m_basis[2];
    last.vector.resize(m_mass.size());
    last.image.resize(m_mass.size());
    const auto advance = [&](Vector& x, const Vector& w, Vector& p) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        p[i] = size == 3 ? c[1] * w[i] + c[2] * p[i] : c[1] * w[i];
        x[i] = c[0] * x[i] + p[i];
      }
    };
    advance(m_basis[0].vector, m_basis[1].vector, last.vector);
    advance(m_basis[0].image, m_basis[1].image, last.image);
    m_has_last_step = true;
  }

  Multigrid<Scalar>& m_multigrid;
  int m_level;
  const std::vector<double>& m_mass;
  std::array<Direction, 3> m_basis; // the iterate, the preconditioned residual, the last step
  bool m_has_last_step = false;
  Vector m_residual;
};

/// computes an eigenvector of the smallest eigenvalue of A x = mu M x, from the coarsest level of a multigrid to the finest.
/// \param mass the diagonal of M, positive
/// \param seed of the first guess
/// \param x the eigenvector, with x^H M x = 1
/// \param progress asked before each step; if it is interrupted, neither x nor mu mean anything
/// \return mu. It is close to the smallest eigenvalue; where others are as close to that, so may be their eigenvectors in x.
template <typename Scalar>
double smallest_eigenvector(Multigrid<Scalar>& multigrid, const std::vector<double>& mass, const unsigned int seed,
                            std::vector<Scalar>& x, Progress& progress)
{
  constexpr int most_steps = 60, most_steps_on_coarse = 20;
  constexpr double tolerance = 1e-6; // relative, of the eigenvalue; the eigenvector then has about three digits
  std::vector<std::vector<double>> masses(1, mass);
  for (int l = 0; l + 1 < multigrid.number_of_levels(); ++l)
    masses.push_back(multigrid.coarser_masses(l, masses.back()));
  std::mt19937 random(seed);
  const auto random_number = [&random] { return static_cast<double>(random()) / 4294967296. - 0.5; };
  std::vector<Scalar> guess(masses.back().size());
  for (Scalar& entry : guess)
    entry = random_number();
  double eigenvalue = 0;
  for (int l = multigrid.number_of_levels() - 1; l >= 0; --l) {
    const bool is_coarsest = l + 1 == multigrid.number_of_levels(), is_finest = l == 0;
    Eigenvector_iteration<Scalar> iteration(multigrid, l, masses[l], guess);
    for (int step = 0; step < (is_coarsest || is_finest ? most_steps : most_steps_on_coarse); ++step)
      if (!progress.go_on_after(masses[l].size()) ||
          !(iteration.step() > (is_finest ? tolerance : 10 * tolerance) * iteration.eigenvalue()))
        break;
    eigenvalue = iteration.eigenvalue();
    if (is_finest)
      x = iteration.vector();
    else {
      guess.assign(masses[l - 1].size(), Scalar(0));
      multigrid.prolongate(l - 1, iteration.vector(), guess);
    }
  }
  return eigenvalue;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SUPPORT_MULTIGRID_ITERATIONS_H
