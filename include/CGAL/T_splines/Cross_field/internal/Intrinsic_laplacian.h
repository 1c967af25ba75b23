// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H

#include <CGAL/T_splines/Cross_field/internal/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/internal/mesh_components.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The cotangent Laplacian L of the intrinsic Delaunay triangulation of a closed surface, and closed 1-forms on it.
///
/// A 1-form has one value per edge, that of the even halfedge; the odd one has the negative value.
class Intrinsic_laplacian {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param forms closed 1-forms on `mesh`, which are carried over to the Delaunay triangulation
  Intrinsic_laplacian(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                      const Mesh_components& components, std::vector<std::vector<double>> forms)
    : m_forms(std::move(forms)), m_row(mesh.number_of_vertices(), 0)
  {
    m_surface.m_mesh = mesh;
    m_surface.m_length = geometry.m_edge_length;
    flip_to_delaunay(m_surface, [this](const int h, const int h1, const int /*h2*/, const int /*g1*/, const int g2) {
      for (std::vector<double>& form : m_forms)
        form[h / 2] = value(form, g2) + value(form, h1);
    });
    // Not negative but for round-off; zeros might tear vertices off.
    for (int h = 0; h < mesh.number_of_halfedges(); h += 2)
      m_weight.push_back((std::max)(
        0.5 * (m_surface.cotangent_opposite(h) + m_surface.cotangent_opposite(mesh.opposite(h))), 1e-10));
    for (const int f : components.first_face)
      m_row[mesh.target(mesh.halfedge_of_face(f))] = null;
    int size = 0;
    for (int& row : m_row)
      if (row != null)
        row = size++;
    assemble(size);
  }

  const std::vector<std::vector<double>>& forms() const { return m_forms; }

  /// L without the rows and columns of one vertex per component: positive definite.
  const Symmetric_sparse_matrix<double>& matrix() const { return m_matrix; }

  /// The row of a vertex in `matrix()`; `Triangulation_connectivity::null` for the vertices left out.
  int row(const int v) const { return m_row[v]; }

  /// The scalar product of 1-forms, with the weights of L.
  double product(const std::vector<double>& a, const std::vector<double>& b) const
  {
    double sum = 0;
    for (std::size_t e = 0; e < a.size(); ++e)
      sum += m_weight[e] * a[e] * b[e];
    return sum;
  }

  /// The flow of a 1-form out of each vertex: -L u for the differential of a function u.
  std::vector<double> flow(const std::vector<double>& form) const
  {
    std::vector<double> result(m_row.size(), 0.);
    for (std::size_t e = 0; e < form.size(); ++e) {
      result[m_surface.m_mesh.source(2 * static_cast<int>(e))] += m_weight[e] * form[e];
      result[m_surface.m_mesh.target(2 * static_cast<int>(e))] -= m_weight[e] * form[e];
    }
    return result;
  }

  /// adds the differential of a function, given per vertex, to a 1-form.
  void add_differential(const std::vector<double>& function, std::vector<double>& form) const
  {
    for (std::size_t e = 0; e < form.size(); ++e)
      form[e] += function[m_surface.m_mesh.target(2 * static_cast<int>(e))] -
                 function[m_surface.m_mesh.source(2 * static_cast<int>(e))];
  }

private:
  struct Entry {
    int column, row;
    double value;
  };

  static double value(const std::vector<double>& form, const int h) { return h % 2 == 0 ? form[h / 2] : -form[h / 2]; }

  void assemble(const int size)
  {
    std::vector<double> diagonal(size, 0.);
    std::vector<Entry> entries;
    entries.reserve(m_weight.size());
    for (std::size_t e = 0; e < m_weight.size(); ++e) {
      const int h = 2 * static_cast<int>(e);
      const int i = m_row[m_surface.m_mesh.source(h)], j = m_row[m_surface.m_mesh.target(h)];
      if (m_surface.m_mesh.source(h) == m_surface.m_mesh.target(h))
        continue;
      for (const int row : {i, j})
        if (row != null)
          diagonal[row] += m_weight[e];
      if (i != null && j != null)
        entries.push_back({(std::min)(i, j), (std::max)(i, j), -m_weight[e]});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.column != b.column ? a.column < b.column : a.row < b.row;
    });
    std::size_t k = 0;
    for (int column = 0; column < size; ++column) {
      m_matrix.row.push_back(column);
      m_matrix.value.push_back(diagonal[column]);
      for (; k < entries.size() && entries[k].column == column; ++k) {
        if (m_matrix.row.back() == entries[k].row) // several edges may join two vertices
          m_matrix.value.back() += entries[k].value;
        else {
          m_matrix.row.push_back(entries[k].row);
          m_matrix.value.push_back(entries[k].value);
        }
      }
      m_matrix.column_begin.push_back(static_cast<int>(m_matrix.row.size()));
    }
  }

  Vertex_frames m_surface; // connectivity and lengths; there are no tangent planes
  std::vector<std::vector<double>> m_forms;
  std::vector<int> m_row;       // per vertex
  std::vector<double> m_weight; // per edge
  Symmetric_sparse_matrix<double> m_matrix;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H
