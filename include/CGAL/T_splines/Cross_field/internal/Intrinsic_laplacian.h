// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The cotangent Laplacian L of the intrinsic Delaunay triangulation of a surface, and closed 1-forms on it. On a border
/// it has the natural conditions: no flow leaves the surface.
///
/// A 1-form has one value per edge, that of the even halfedge; the odd one has the negative value.
class Intrinsic_laplacian {
  static constexpr int null = Triangulation_connectivity::null;

public:
  using Sparse_form = std::vector<std::pair<int, double>>; ///< edges and values

  /// \param strips strips of triangles on `mesh`, closed or from border to border, whose crossing forms are carried over to the Delaunay triangulation
  /// \param progress if it is interrupted, the triangulation need not be Delaunay
  Intrinsic_laplacian(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                      const Mesh_components& components, const std::vector<std::vector<int>>& strips,
                      Progress& progress)
    : m_forms(strips.size()),
      m_row(mesh.number_of_vertices(), 0)
  {
    m_surface.m_mesh = mesh;
    m_surface.m_length = geometry.m_edge_length;
    std::vector<Sparse_form> on_edge(mesh.number_of_edges()); // forms and values
    for (std::size_t l = 0; l < strips.size(); ++l)
      for (const int h : strips[l])
        add_value(on_edge[edge_of(h)], static_cast<int>(l), is_along_edge(h) ? 1 : -1);
    const auto carry_over = [&](const int h, const int h1, const int /*h2*/, const int /*g1*/, const int g2) {
      on_edge[edge_of(h)].clear();
      for (const int side : {g2, h1})
        for (const auto& [form, value] : on_edge[edge_of(side)])
          add_value(on_edge[edge_of(h)], form, is_along_edge(side) ? value : -value);
    };
    flip_to_delaunay(m_surface, carry_over, progress);
    progress.go_on();
    for (std::size_t e = 0; e < on_edge.size(); ++e)
      for (const auto& [form, value] : on_edge[e])
        m_forms[form].emplace_back(static_cast<int>(e), value);
    // Not negative but for round-off; zeros might tear vertices off.
    constexpr double least_weight = 1e-10;
    for (int e = 0; e < mesh.number_of_edges(); ++e) {
      double weight = 0;
      for (const int h : halfedges_of_edge(e))
        if (m_surface.m_mesh.face(h) != null)
          weight += 0.5 * m_surface.cotangent_opposite(h);
      m_weight.push_back((std::max)(weight, least_weight));
    }
    for (const int f : components.first_face)
      m_row[mesh.target(mesh.halfedge_of_face(f))] = null;
    int size = 0;
    for (int& row : m_row)
      if (row != null)
        row = size++;
    progress.go_on();
    assemble(size);
    progress.go_on();
  }

  /// The crossing forms: closed 1-forms that are 1 on the halfedges of a strip, or what flips make of that.
  const std::vector<Sparse_form>& forms() const { return m_forms; }

  /// L without the rows and columns of one vertex per component: positive definite.
  const Symmetric_sparse_matrix<double>& matrix() const { return m_matrix; }

  /// The row of a vertex in `matrix()`; `Triangulation_connectivity::null` for the vertices left out.
  int row(const int v) const { return m_row[v]; }

  /// The scalar product of 1-forms, with the weights of L.
  double product(const Sparse_form& a, const std::vector<double>& b) const
  {
    double sum = 0;
    for (const auto& [e, value] : a)
      sum += m_weight[e] * value * b[e];
    return sum;
  }

  /// calls `add(v, flow)` for the flow of a 1-form out of the vertices: -L u for the differential of a function u.
  template <typename Add>
  void for_each_flow(const Sparse_form& form, const Add& add) const
  {
    for (const auto& [e, value] : form) {
      add(m_surface.m_mesh.source(halfedge_of_edge(e)), m_weight[e] * value);
      add(m_surface.m_mesh.target(halfedge_of_edge(e)), -m_weight[e] * value);
    }
  }

  /// computes the sum of a 1-form and the differential of a function, given per vertex.
  std::vector<double> with_differential(const Sparse_form& form, const std::vector<double>& function) const
  {
    std::vector<double> result(m_weight.size());
    for (std::size_t e = 0; e < result.size(); ++e)
      result[e] = function[m_surface.m_mesh.target(halfedge_of_edge(static_cast<int>(e)))] -
                  function[m_surface.m_mesh.source(halfedge_of_edge(static_cast<int>(e)))];
    for (const auto& [e, value] : form)
      result[e] += value;
    return result;
  }

private:
  struct Entry {
    int column, row;
    double value;
  };

  static void add_value(Sparse_form& on_edge, const int form, const double value)
  {
    const auto entry = std::find_if(on_edge.begin(), on_edge.end(), [form](const auto& e) { return e.first == form; });
    if (entry == on_edge.end())
      on_edge.emplace_back(form, value);
    else if (entry->second + value != 0)
      entry->second += value;
    else
      on_edge.erase(entry);
  }

  void assemble(const int size)
  {
    std::vector<double> diagonal(size, 0.);
    std::vector<Entry> entries;
    entries.reserve(m_weight.size());
    for (std::size_t e = 0; e < m_weight.size(); ++e) {
      const int h = halfedge_of_edge(static_cast<int>(e));
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
  std::vector<Sparse_form> m_forms;
  std::vector<int> m_row;       // per vertex
  std::vector<double> m_weight; // per edge
  Symmetric_sparse_matrix<double> m_matrix;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_INTRINSIC_LAPLACIAN_H
