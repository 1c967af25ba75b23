// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FITTING_SYSTEM_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FITTING_SYSTEM_H

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>
#include <CGAL/T_splines/Solver/support/Interruptible_preconditioner.h>
#include <CGAL/T_splines/Solver/support/factorize.h>
#include <CGAL/T_splines/Spline/internal/Face_functions.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/Spline/internal/Thin_plate_energy.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A sample in indices: a place in a face, a point, a weight.
template <typename FT>
struct Fitting_sample {
  int face;
  FT u, v;
  std::array<FT, 3> point;
  FT weight;
};

/// The areas of the faces of a T-mesh on a surface, by the weights of the samples in them. A face with few samples,
/// whose weights may stand for much more than the face, takes the area of a parameter unit from its neighbours. Linear
/// time.
template <typename FT>
std::vector<FT> face_areas(const T_mesh_arrays<FT>& t_mesh, const std::vector<Fitting_sample<FT>>& samples)
{
  std::vector<FT> areas(t_mesh.number_of_faces(), FT(0));
  std::vector<int> number(t_mesh.number_of_faces(), 0);
  for (const Fitting_sample<FT>& sample : samples) {
    areas[sample.face] += sample.weight;
    number[sample.face] += sample.weight > FT(0) ? 1 : 0;
  }
  const int enough = (std::min)(4, *std::max_element(number.begin(), number.end()));
  std::vector<int> queue;
  for (int f = 0; f < t_mesh.number_of_faces(); ++f) {
    if (number[f] >= enough)
      queue.push_back(f);
    else
      areas[f] = FT(0);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int f = queue[i];
    const FT unit = areas[f] / (t_mesh.width(f) * t_mesh.height(f));
    const int first = t_mesh.first_of_side(f, 0);
    int h = first;
    do {
      const int o = T_mesh_arrays<FT>::opposite(h);
      if (!t_mesh.is_border(o) && !(areas[t_mesh.face(o)] > FT(0))) {
        const int g = t_mesh.face(o);
        areas[g] = unit / (t_mesh.ratio(h) * t_mesh.ratio(h)) * t_mesh.width(g) * t_mesh.height(g);
        queue.push_back(g);
      }
      h = t_mesh.next(h);
    } while (h != first);
  }
  return areas;
}

/// The normal equations of a fit: the matrix and the right-hand sides of E_dist + E_fair ([He06] equation (3)), both for
/// euclidean control points.
template <typename FT>
class Fitting_system {
  using Basis = T_spline_basis<FT>;
  using Matrix = Symmetric_sparse_matrix<FT>;
  using Dense = Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic>;

public:
  /// \param basis must outlive the system
  /// \param weights of the vertices, likewise
  /// \param progress likewise; if it is interrupted, the numbers mean nothing
  Fitting_system(const Basis& basis, const std::vector<FT>& weights, Progress& progress)
    : m_basis(basis),
      m_progress(progress),
      m_functions(basis, weights),
      m_number_of_vertices(static_cast<int>(weights.size()))
  {
    find_pattern();
  }

  /// Sets E_fair: the sum of the thin-plate energies of the faces, in the unit of length of the surface, in which the
  /// faces have these areas, each times the stiffness of the face.
  void set_fairness(const std::vector<FT>& face_areas, const std::vector<FT>& stiffness)
  {
    m_fairness.assign(m_matrix.row.size(), FT(0));
    Thin_plate_energy<FT> energy(m_basis);
    Dense scaled;
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(work_per_face); ++f) {
      m_functions.enter(f);
      scaled = energy.matrix(m_functions) * (stiffness[f] / face_areas[f]);
      add(scaled, m_fairness);
    }
  }

  /// Sets E_dist: the weighted sum of the squared distances at the samples.
  void set_samples(const std::vector<Fitting_sample<FT>>& samples)
  {
    m_distance.assign(m_matrix.row.size(), FT(0));
    m_order.resize(samples.size());
    std::iota(m_order.begin(), m_order.end(), 0);
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](const int i, const int j) { return samples[i].face < samples[j].face; });
    m_blocks.clear();
    for (std::size_t begin = 0, end = 0; begin < m_order.size(); begin = end) {
      const int face = samples[m_order[begin]].face;
      while (end < m_order.size() && samples[m_order[end]].face == face)
        ++end;
      m_functions.enter(face);
      add_block(samples, begin, end);
      if (!m_progress.go_on_after(work_per_face))
        return;
    }
    set_points(samples);
  }

  /// Sets the right-hand sides to other points of the samples of which the places and the weights are as they were.
  void set_points(const std::vector<Fitting_sample<FT>>& samples)
  {
    for (std::vector<FT>& side : m_right)
      side.assign(m_number_of_vertices, FT(0));
    for (const Block& block : m_blocks) {
      const Eigen::Index columns = block.functions.cols();
      m_points.resize(columns, 3);
      for (Eigen::Index c = 0; c < columns; ++c) {
        const Fitting_sample<FT>& sample = samples[m_order[block.begin + static_cast<std::size_t>(c)]];
        for (int k = 0; k < 3; ++k)
          m_points(c, k) = sample.weight * sample.point[k];
      }
      if (!m_progress.go_on_after(work_per_product))
        return;
      m_product.noalias() = block.functions * m_points;
      for (Eigen::Index r = 0; r < m_product.rows(); ++r)
        for (int k = 0; k < 3; ++k)
          m_right[k][block.vertices[r]] += m_product(r, k);
    }
  }

  /// The points of the surface with these control points at the places of the samples.
  void evaluate(const std::vector<std::array<FT, 3>>& control_points, std::vector<std::array<FT, 3>>& result)
  {
    result.resize(m_order.size());
    for (const Block& block : m_blocks) {
      m_points.resize(block.functions.rows(), 3);
      for (Eigen::Index r = 0; r < block.functions.rows(); ++r)
        for (int k = 0; k < 3; ++k)
          m_points(r, k) = control_points[block.vertices[r]][k];
      if (!m_progress.go_on_after(work_per_product))
        return;
      m_product.noalias() = block.functions.transpose() * m_points;
      for (Eigen::Index c = 0; c < m_product.rows(); ++c)
        for (int k = 0; k < 3; ++k)
          result[m_order[block.begin + static_cast<std::size_t>(c)]][k] = m_product(c, k);
    }
  }

  /// Solves for the control points by a factorization.
  /// \return false if the solver fails: the matrix is singular to working precision; or if the progress is interrupted
  template <typename SolverTraits>
  bool solve(SolverTraits& solver, std::vector<std::array<FT, 3>>& points)
  {
    set_matrix();
    find_scale();
    scale_matrix();
    const bool is_factorized =
        m_is_analyzed ? factorize(solver, m_matrix, m_progress) : analyze_and_factorize(solver, m_matrix, m_progress);
    m_is_analyzed = true;
    return is_factorized && solve_for_points(solver, points);
  }

  /// Solves for other points of the samples, with the last factorization.
  template <typename SolverTraits>
  bool solve_for_points(SolverTraits& solver, std::vector<std::array<FT, 3>>& points)
  {
    points.resize(m_number_of_vertices);
    for (int k = 0; k < 3; ++k) {
      if (!m_progress.go_on() || !solver.solve(scaled_right_hand_side(k), m_solution))
        return false;
      for (int v = 0; v < m_number_of_vertices; ++v)
        points[v][k] = m_solution[v] * m_scale[v];
    }
    return true;
  }

  /// Solves again, after a small change of the samples: by conjugate gradients from the given control points, with the
  /// last factorization as the preconditioner, or by a new one if this does not do.
  template <typename SolverTraits>
  bool solve_again(SolverTraits& solver, std::vector<std::array<FT, 3>>& points)
  {
    constexpr int largest_number_of_iterations = 40;
    constexpr FT tolerance = FT(1e-9); // of a change of control points that is small itself
    set_matrix();
    scale_matrix();
    for (int k = 0; k < 3; ++k) {
      std::vector<FT> right = scaled_right_hand_side(k), product;
      const FT norm = norm_of(right);
      m_solution.resize(m_number_of_vertices);
      for (int v = 0; v < m_number_of_vertices; ++v)
        m_solution[v] = points[v][k] / m_scale[v];
      m_matrix.multiply(m_solution, product);
      for (int v = 0; v < m_number_of_vertices; ++v)
        right[v] -= product[v];
      const FT rest = norm_of(right);
      if (rest <= tolerance * norm)
        continue;
      const int iterations = preconditioned_conjugate_gradients(
          m_matrix, Interruptible_preconditioner<SolverTraits>(solver, m_progress), right, m_solution,
          FT(tolerance * norm / rest), largest_number_of_iterations, m_workspace);
      if (m_progress.is_interrupted())
        return false;
      if (iterations == largest_number_of_iterations)
        return solve(solver, points);
      for (int v = 0; v < m_number_of_vertices; ++v)
        points[v][k] += m_solution[v] * m_scale[v];
    }
    return true;
  }

private:
  static constexpr std::size_t work_per_face = 200, work_per_product = 20;

  void set_matrix()
  {
    for (std::size_t i = 0; i < m_matrix.value.size(); ++i)
      m_matrix.value[i] = m_distance[i] + (m_fairness.empty() ? FT(0) : m_fairness[i]);
  }

  // Faces are of very different sizes: with a diagonal of ones, a small pivot means dependence.
  void find_scale()
  {
    m_scale.resize(m_number_of_vertices);
    for (int v = 0; v < m_number_of_vertices; ++v) {
      const FT& diagonal = m_matrix.value[m_matrix.column_begin[v]];
      m_scale[v] = diagonal > FT(0) ? FT(1) / std::sqrt(diagonal) : FT(1);
    }
  }

  void scale_matrix()
  {
    for (int v = 0; v < m_number_of_vertices; ++v)
      for (int i = m_matrix.column_begin[v]; i < m_matrix.column_begin[v + 1]; ++i)
        m_matrix.value[i] *= m_scale[v] * m_scale[m_matrix.row[i]];
  }

  std::vector<FT> scaled_right_hand_side(const int k) const
  {
    std::vector<FT> result(m_number_of_vertices);
    for (int v = 0; v < m_number_of_vertices; ++v)
      result[v] = m_right[k][v] * m_scale[v];
    return result;
  }

  static FT norm_of(const std::vector<FT>& x)
  {
    return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), FT(0)));
  }

  void find_pattern()
  {
    std::vector<std::vector<int>> rows(m_number_of_vertices);
    for (int v = 0; v < m_number_of_vertices; ++v)
      rows[v].push_back(v);
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(10); ++f) {
      m_functions.enter(f);
      const std::vector<int>& vertices = m_functions.vertices();
      for (std::size_t j = 0; j < vertices.size(); ++j)
        rows[vertices[j]].insert(rows[vertices[j]].end(), vertices.begin() + static_cast<std::ptrdiff_t>(j),
                                 vertices.end());
    }
    for (std::vector<int>& column : rows) {
      std::sort(column.begin(), column.end());
      column.erase(std::unique(column.begin(), column.end()), column.end());
      m_matrix.row.insert(m_matrix.row.end(), column.begin(), column.end());
      m_matrix.column_begin.push_back(static_cast<int>(m_matrix.row.size()));
    }
    m_matrix.value.assign(m_matrix.row.size(), FT(0));
  }

  // Adds the lower triangle of a matrix of the functions of the present face.
  void add(const Dense& matrix, std::vector<FT>& values) const
  {
    const std::vector<int>& vertices = m_functions.vertices();
    const Eigen::Index n = static_cast<Eigen::Index>(vertices.size());
    for (Eigen::Index j = 0; j < n; ++j) {
      int entry = m_matrix.column_begin[vertices[j]];
      for (Eigen::Index i = j; i < n; ++i) {
        while (m_matrix.row[entry] != vertices[i])
          ++entry;
        values[entry] += matrix(i, j);
      }
    }
  }

  // The samples of a face: the values of its functions, a column for each sample.
  struct Block {
    std::size_t begin; ///< in m_order
    std::vector<int> vertices;
    Dense functions;
  };

  void add_block(const std::vector<Fitting_sample<FT>>& samples, const std::size_t begin, const std::size_t end)
  {
    m_blocks.push_back({begin, m_functions.vertices(), {}});
    Dense& functions = m_blocks.back().functions;
    const Eigen::Index n = static_cast<Eigen::Index>(m_functions.vertices().size());
    functions.resize(n, static_cast<Eigen::Index>(end - begin));
    m_rows.resize(n, functions.cols());
    for (std::size_t i = begin; i < end; ++i) {
      const Fitting_sample<FT>& sample = samples[m_order[i]];
      const FT root = std::sqrt(sample.weight);
      const auto& jets = m_functions.template evaluate<0>(sample.u, sample.v);
      const Eigen::Index column = static_cast<Eigen::Index>(i - begin);
      for (Eigen::Index r = 0; r < n; ++r) {
        functions(r, column) = jets[r][0];
        m_rows(r, column) = root * jets[r][0];
      }
    }
    m_square.setZero(n, n);
    m_square.template selfadjointView<Eigen::Lower>().rankUpdate(m_rows);
    add(m_square, m_distance);
  }

  const Basis& m_basis;
  Progress& m_progress;
  Face_functions<FT> m_functions;
  int m_number_of_vertices;
  Matrix m_matrix;
  std::vector<FT> m_distance, m_fairness; // the entries of the matrices of E_dist and E_fair
  std::vector<FT> m_scale;                // per vertex: of its row and column in m_matrix
  bool m_is_analyzed = false;
  std::vector<FT> m_solution;
  Conjugate_gradients_workspace<FT> m_workspace;
  std::array<std::vector<FT>, 3> m_right;
  std::vector<int> m_order; // the samples by faces
  std::vector<Block> m_blocks;
  Dense m_rows, m_square, m_points, m_product;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FITTING_SYSTEM_H
