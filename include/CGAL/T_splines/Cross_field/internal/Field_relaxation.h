// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_RELAXATION_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_RELAXATION_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/support/factorize.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Turns the crosses of a field such that it becomes smooth while its rotations keep their numbers of turns around all
/// vertices and loops.
///
/// It minimizes sum_e w_e (r_e + psi_f - psi_g)^2 + m sum_f a_f psi_f^2 over the angles psi by which the crosses turn: the first
/// part is the Dirichlet energy of the field, linear since the numbers are given (Crane, Desbrun, Schroeder, Trivial
/// connections on discrete surfaces, 2010), the second one keeps it near what it was.
class Field_relaxation {
  static constexpr int fixed = -1;

public:
  /// \param rotation per edge, as `field_rotations()` has them, but of any size
  /// \param is_fixed per face: its cross does not turn
  /// \param nearness m times the area of the mesh: parts of the surface larger than the square root of area / nearness stay as
  ///   they are
  Field_relaxation(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                   std::vector<double> rotation, const std::vector<char>& is_fixed, const double nearness)
    : m_mesh(mesh),
      m_rotation(std::move(rotation)),
      m_unknown(mesh.number_of_faces(), fixed),
      m_weight(dual_edge_lengths(mesh, geometry))
  {
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      m_weight[e] = is_inner(e) ? geometry.m_edge_length[e] / m_weight[e] : 0;
    for (int f = 0; f < mesh.number_of_faces(); ++f)
      if (is_fixed[f] == 0) {
        m_unknown[f] = static_cast<int>(m_faces.size());
        m_faces.push_back(f);
      }
    // Where nothing holds it, the field may be turned as a whole: this keeps the system definite.
    constexpr double smallest = 1e-8;
    const double area = std::accumulate(geometry.m_area.begin(), geometry.m_area.end(), 0.);
    for (const int f : m_faces)
      m_anchor.push_back((std::max)(nearness, smallest) * geometry.m_area[f] / area);
  }

  /// Turns the crosses. \param angle per face, in its frame
  /// \return whether the solver did it
  template <typename SolverTraits>
  bool relax(SolverTraits& solver, Progress& progress, std::vector<double>& angle)
  {
    if (m_faces.empty())
      return true;
    const Symmetric_sparse_matrix<double> matrix = this->matrix();
    std::vector<double> psi;
    if (!analyze_and_factorize(solver, matrix, progress) || !solver.solve(right_hand_side(), psi))
      return false;
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      angle[m_faces[i]] += psi[i];
    const auto turn = [&](const int h) {
      const int i = m_unknown[m_mesh.face(h)];
      return i == fixed ? 0. : psi[i];
    };
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (is_inner(e)) {
        const auto [h, g] = halfedges_of_edge(e);
        m_rotation[e] += turn(h) - turn(g);
      }
    return true;
  }

  /// The rotations, after `relax()` those of the new field.
  const std::vector<double>& rotation() const { return m_rotation; }

private:
  bool is_inner(const int e) const
  {
    const auto [h, g] = halfedges_of_edge(e);
    return m_mesh.face(h) != m_mesh.null && m_mesh.face(g) != m_mesh.null;
  }

  /// Calls `visit(h)` for the three halfedges of a face that have a face on the other side.
  template <typename Visit>
  void for_each_side(const int f, const Visit& visit) const
  {
    int h = m_mesh.halfedge_of_face(f);
    for (int i = 0; i < 3; ++i, h = m_mesh.next(h))
      if (m_mesh.face(opposite(h)) != m_mesh.null)
        visit(h);
  }

  Symmetric_sparse_matrix<double> matrix() const
  {
    Symmetric_sparse_matrix<double> result;
    std::vector<std::pair<int, double>> below; // row, value
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      double diagonal = m_anchor[i];
      below.clear();
      for_each_side(m_faces[i], [&](const int h) {
        const double w = m_weight[edge_of(h)];
        const int j = m_unknown[m_mesh.face(opposite(h))];
        diagonal += w;
        if (j > static_cast<int>(i))
          below.emplace_back(j, -w);
      });
      std::sort(below.begin(), below.end());
      result.row.push_back(static_cast<int>(i));
      result.value.push_back(diagonal);
      for (const auto& [row, value] : below) {
        if (result.row.back() == row) { // two faces with two common edges
          result.value.back() += value;
          continue;
        }
        result.row.push_back(row);
        result.value.push_back(value);
      }
      result.column_begin.push_back(static_cast<int>(result.row.size()));
    }
    return result;
  }

  std::vector<double> right_hand_side() const
  {
    std::vector<double> result(m_faces.size(), 0.);
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      for_each_side(m_faces[i], [&](const int h) {
        const double r = is_along_edge(h) ? m_rotation[edge_of(h)] : -m_rotation[edge_of(h)];
        result[i] -= m_weight[edge_of(h)] * r;
      });
    return result;
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<double> m_rotation; // per edge
  std::vector<int> m_unknown;     // per face
  std::vector<int> m_faces;       // per unknown
  std::vector<double> m_weight;   // per edge
  std::vector<double> m_anchor;   // per unknown
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_RELAXATION_H
