// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_PAPER_METHOD_H
#define T_SPLINES_BENCHMARK_PAPER_METHOD_H

#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/internal/Metric_computation.h>
#include <CGAL/T_splines/Similarity_map/internal/Newton_system.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/Similarity_map/internal/first_degeneracy.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

/// The algorithm of [CZ17] section 7.3 as it stands in the paper: the baseline of the benchmarks.
///
/// Each iteration solves for the 1-form xi, one unknown per edge: equation (6) for every vertex but one and for 2g loops, equation (7) for
/// every face but one (one of each per component), by a sparse LU factorization. The step ends at the first degeneracy, where the longest edges
/// of degenerate triangles are flipped (7.3.1). It is not damped.
///
/// Angles, curvatures, the flips and the rerouting of the loops are the library's: only the method differs. Three things are done
/// better than one would have to, so that the comparison is fair: the curvatures that go into (6) are projected to sum zero,
/// without which the vertex left out collects all round-off and 1e-12 is not reached; columns are assembled without
/// sorting triplets; and the ordering (COLAMD) is kept while no edge is flipped.
class Paper_method {
  using Connectivity = CGAL::T_splines::internal::Triangulation_connectivity;
  using Structure = CGAL::T_splines::internal::Similarity_structure<double>;
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = Connectivity::Index;

public:
  enum class End { CONVERGED, FLOOR, BLOCKED, ITERATION_LIMIT, SOLVER_FAILED, FLIP_LIMIT };

  struct Report {
    End end = End::ITERATION_LIMIT;
    int iterations = 0;
    std::size_t flips = 0, delaunay_flips = 0;
    double residual = 0; ///< the smallest
    double seconds = 0;  ///< CPU time until the smallest residual
  };

  /// \param delaunay whether the triangulation is made intrinsically Delaunay first and after each step (7.3.1, Remark)
  Paper_method(const CGAL::T_splines::internal::Metric_input& input, const bool delaunay)
    : m_start(cpu_seconds()),
      m_delaunay(delaunay),
      m_system(input),
      m_component(input.component_of_vertex)
  {
    CGAL::T_splines::internal::Metric_computation<double> computation(input, false);
    m_structure = std::move(computation.structure);
    set_rows();
  }

  Report run(const double tolerance, const int number_of_iterations)
  {
    m_report.residual = std::numeric_limits<double>::infinity();
    if (m_delaunay && !flip_all_to_delaunay(m_report.delaunay_flips))
      m_report.end = End::FLIP_LIMIT;
    else
      m_report.end = iterate(tolerance, number_of_iterations);
    return m_report;
  }

private:
  static constexpr int no_row = -1;

  End iterate(const double tolerance, const int number_of_iterations)
  {
    int blocked = 0, without_progress = 0;
    while (true) {
      m_system.evaluate(m_structure, m_progress);
      const double residual = m_system.residual();
      without_progress = residual < 0.9 * m_report.residual ? 0 : without_progress + 1;
      if (residual < m_report.residual) {
        m_report.residual = residual;
        m_report.seconds = cpu_seconds() - m_start;
      }
      if (residual <= tolerance)
        return End::CONVERGED;
      if (m_report.residual < 1e-8 && without_progress > 2)
        return End::FLOOR;
      if (m_report.iterations == number_of_iterations)
        return End::ITERATION_LIMIT;
      if (!solve())
        return End::SOLVER_FAILED;
      const double time = step();
      if (m_delaunay && !flip_all_to_delaunay(m_report.flips))
        return End::FLIP_LIMIT;
      blocked = time < 1e-12 ? blocked + 1 : 0;
      if (blocked > 20)
        return End::BLOCKED;
      ++m_report.iterations;
    }
  }

  // The rows: vertices and loops in the order of Newton_system::right_hand_side(), then faces.
  void set_rows()
  {
    const Connectivity& mesh = m_structure.mesh;
    m_vertex_row.assign(mesh.number_of_vertices(), no_row);
    m_face_row.assign(mesh.number_of_faces(), no_row);
    const std::size_t components = 1 + *std::max_element(m_component.begin(), m_component.end());
    int rows = 0;
    std::vector<char> is_started(components, 0);
    for (Index v = 0; v < mesh.number_of_vertices(); ++v)
      if (std::exchange(is_started[m_component[v]], 1))
        m_vertex_row[v] = rows++;
    m_first_loop_row = rows;
    rows += m_structure.loops.number_of_loops();
    is_started.assign(components, 0);
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      if (std::exchange(is_started[m_component[mesh.target(mesh.halfedge_of_face(f))]], 1))
        m_face_row[f] = rows++;
  }

  // The equations (6) and (7): a column per edge.
  Matrix matrix() const
  {
    const Connectivity& mesh = m_structure.mesh;
    const std::vector<double>& angle = m_system.angles();
    const int n = mesh.number_of_edges();
    Matrix result(n, n);
    result.reserve(4 * static_cast<Eigen::Index>(n));
    std::vector<std::pair<int, double>> column;
    for (Index e = 0; e < n; ++e) {
      const double star = (1. / std::tan(angle[2 * e]) + 1. / std::tan(angle[2 * e + 1])) / 2;
      column = {{m_vertex_row[mesh.target(2 * e)], star},
                {m_vertex_row[mesh.target(2 * e + 1)], -star},
                {m_face_row[mesh.face(2 * e)], 1.},
                {m_face_row[mesh.face(2 * e + 1)], -1.}};
      m_structure.loops.for_each_passage(
          e, [&](const int loop, const int sign) { column.emplace_back(m_first_loop_row + loop, sign * star); });
      std::sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      result.startVec(e);
      for (std::size_t i = 0; i < column.size();) {
        const int row = column[i].first;
        double sum = 0;
        for (; i < column.size() && column[i].first == row; ++i)
          sum += column[i].second;
        if (row != no_row)
          result.insertBack(row, e) = sum;
      }
    }
    result.finalize();
    return result;
  }

  bool solve()
  {
    const Matrix a = matrix();
    const std::vector<double> vertices_and_loops = m_system.right_hand_side();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(a.rows());
    std::copy(vertices_and_loops.begin(), vertices_and_loops.end(), b.data());
    if (std::exchange(m_is_pattern_new, false))
      m_lu.analyzePattern(a);
    m_lu.factorize(a);
    if (m_lu.info() != Eigen::Success)
      return false;
    const Eigen::VectorXd xi = m_lu.solve(b);
    m_step.assign(xi.data(), xi.data() + xi.size());
    return xi.allFinite();
  }

  // moves to the first degeneracy and flips there. \return its time.
  double step()
  {
    const CGAL::T_splines::internal::First_degeneracy<double> degeneracy(m_structure, m_step);
    for (std::size_t e = 0; e < m_step.size(); ++e)
      m_structure.form[e] += degeneracy.time * m_step[e];
    std::unordered_set<Index> flipped; // two degenerate triangles may share their longest edge
    for (const Index h : degeneracy.triangles)
      if (m_structure.mesh.face(h) != m_structure.mesh.face(h ^ 1) && flipped.insert(h >> 1).second) {
        m_structure.flip_euclidean(h);
        ++m_report.flips;
        m_is_pattern_new = true;
      }
    return degeneracy.time;
  }

  bool flip_all_to_delaunay(std::size_t& count)
  {
    const std::size_t most_flips = 1000 + 100 * static_cast<std::size_t>(m_structure.mesh.number_of_edges());
    const std::size_t flips = CGAL::T_splines::internal::flip_all_to_delaunay(
        m_structure, most_flips, [this](const Index h) { m_structure.flip_euclidean(h); }, m_progress);
    count += flips;
    m_is_pattern_new = m_is_pattern_new || flips > 0;
    return flips <= most_flips;
  }

  double m_start;
  bool m_delaunay;
  Structure m_structure;
  CGAL::T_splines::internal::Newton_system<double> m_system;
  CGAL::T_splines::internal::Progress m_progress; // nobody is asked
  std::vector<int> m_component;                   // per vertex
  std::vector<int> m_vertex_row, m_face_row;
  int m_first_loop_row = 0;

  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> m_lu;
  bool m_is_pattern_new = true;
  std::vector<double> m_step; // change of xi of the halfedge 2e, per edge e
  Report m_report;
};

inline const char* message(const Paper_method::End end)
{
  switch (end) {
  case Paper_method::End::CONVERGED: return "converged";
  case Paper_method::End::FLOOR: return "floor of round-off";
  case Paper_method::End::BLOCKED: return "blocked: steps of length 0";
  case Paper_method::End::ITERATION_LIMIT: return "iteration limit";
  case Paper_method::End::SOLVER_FAILED: return "LU failed";
  case Paper_method::End::FLIP_LIMIT: return "flip limit";
  }
  return "";
}

#endif // T_SPLINES_BENCHMARK_PAPER_METHOD_H
