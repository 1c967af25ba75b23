// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The Dirichlet energy of sections of the fourth power of the tangent bundle, on the free vertices of one component.
///
/// With w the cotangent weights and u -> r u the parallel transport along an edge, the energy is the sum of w |u_j - r u_i|^2 over
/// the edges, a Hermitian form. As a real matrix it has two rows for each free vertex, of the real and the imaginary part.
class Connection_laplacian {
public:
  using Complex = std::complex<double>;

  /// \param frames an intrinsically Delaunay triangulation
  /// \param vertices the vertices of the component
  /// \param halfedges the halfedges of even index of the component
  /// \param fixed per vertex of the whole mesh: its value if it is not free, 0 if it is
  Connection_laplacian(const Vertex_frames& frames, const std::vector<int>& vertices,
                       const std::vector<int>& halfedges, const std::vector<Complex>& fixed)
  {
    number_free_vertices(vertices, fixed);
    add_masses(frames, halfedges);
    std::vector<Entry> entries;
    entries.reserve(halfedges.size());
    for (const int h : halfedges)
      add_edge(frames, h, fixed, entries);
    assemble(entries);
  }

  /// The free vertices; number i has the rows 2 i and 2 i + 1.
  const std::vector<int>& free_vertices() const { return m_vertices; }
  const std::vector<double>& masses() const { return m_mass; } ///< per free vertex: a third of the areas around it
  double area() const { return m_area; }

  /// The right-hand side that the values of the fixed vertices make.
  const std::vector<double>& boundary_term() const { return m_boundary_term; }

  /// computes a L + b M; the pattern is always the same.
  Symmetric_sparse_matrix<double> combination(const double a, const double b) const
  {
    Symmetric_sparse_matrix<double> result = m_matrix;
    for (double& value : result.value)
      value *= a;
    for (int i = 0; i < result.size(); ++i)
      result.value[result.column_begin[i]] += b * m_mass[i / 2];
    return result;
  }

private:
  struct Entry {
    int row, column; // of the lower triangle: row > column
    Complex value;
  };

  void number_free_vertices(const std::vector<int>& vertices, const std::vector<Complex>& fixed)
  {
    for (const int v : vertices)
      if (fixed[v] == Complex(0))
        m_vertices.push_back(v);
    m_first = vertices.empty() ? 0 : *std::min_element(vertices.begin(), vertices.end());
    const int last = vertices.empty() ? -1 : *std::max_element(vertices.begin(), vertices.end());
    m_index.assign(last - m_first + 1, Triangulation_connectivity::null);
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_index[m_vertices[i] - m_first] = static_cast<int>(i);
    m_mass.assign(m_vertices.size(), 0.);
    m_diagonal.assign(m_vertices.size(), 0.);
    m_boundary_term.assign(2 * m_vertices.size(), 0.);
  }

  void add_masses(const Vertex_frames& frames, const std::vector<int>& halfedges)
  {
    const Triangulation_connectivity& mesh = frames.m_mesh;
    for (const int even : halfedges) {
      for (const int h : {even, mesh.opposite(even)}) {
        if (mesh.face(h) == Triangulation_connectivity::null)
          continue;
        const double area = 0.5 * frames.m_length[mesh.edge(h)] * frames.m_length[mesh.edge(mesh.next(h))] *
                            std::sin(frames.corner_angle(h));
        m_area += area / 3;
        const int i = m_index[mesh.target(h) - m_first];
        if (i != Triangulation_connectivity::null)
          m_mass[i] += area / 3;
      }
    }
    // Where triangles are flat to working precision a vertex might have none.
    const double smallest = 1e-10 * m_area / static_cast<double>((std::max)(std::size_t(1), m_mass.size()));
    for (double& mass : m_mass)
      mass = (std::max)(mass, smallest);
  }

  void add_edge(const Vertex_frames& frames, const int h, const std::vector<Complex>& fixed,
                std::vector<Entry>& entries)
  {
    const Triangulation_connectivity& mesh = frames.m_mesh;
    double weight = 0;
    for (const int side : {h, mesh.opposite(h)})
      if (mesh.face(side) != Triangulation_connectivity::null)
        weight += 0.5 * frames.cotangent_opposite(side);
    weight = (std::max)(weight, 0.);
    const int v = mesh.source(h), w = mesh.target(h);
    const int i = m_index[v - m_first], j = m_index[w - m_first];
    // A vector of angle a at v is carried to w at the angle a - direction(h) + direction(opposite(h)) + pi.
    const Complex transport = std::polar(1., 4 * (frames.direction(mesh.opposite(h)) + CGAL_PI - frames.direction(h)));
    if (v == w) {
      if (i != Triangulation_connectivity::null)
        m_diagonal[i] += weight * std::norm(1. - transport);
      return;
    }
    if (i != Triangulation_connectivity::null)
      m_diagonal[i] += weight;
    if (j != Triangulation_connectivity::null)
      m_diagonal[j] += weight;
    if (i != Triangulation_connectivity::null && j != Triangulation_connectivity::null) {
      if (j > i)
        entries.push_back({j, i, -weight * transport});
      else
        entries.push_back({i, j, -weight * std::conj(transport)});
    }
    else if (i != Triangulation_connectivity::null)
      add_boundary_term(i, weight * std::conj(transport) * fixed[w]);
    else if (j != Triangulation_connectivity::null)
      add_boundary_term(j, weight * transport * fixed[v]);
  }

  void add_boundary_term(const int i, const Complex value)
  {
    m_boundary_term[2 * i] += value.real();
    m_boundary_term[2 * i + 1] += value.imag();
  }

  // An entry a + b i stands for the rows (a, -b) and (b, a).
  void assemble(std::vector<Entry>& entries)
  {
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.column != b.column ? a.column < b.column : a.row < b.row;
    });
    std::size_t number_of_entries = 0; // an intrinsic triangulation may have several edges between two vertices
    for (std::size_t k = 0; k < entries.size(); ++k) {
      if (number_of_entries > 0 && entries[number_of_entries - 1].row == entries[k].row &&
          entries[number_of_entries - 1].column == entries[k].column)
        entries[number_of_entries - 1].value += entries[k].value;
      else
        entries[number_of_entries++] = entries[k];
    }
    entries.resize(number_of_entries);
    const int n = static_cast<int>(m_vertices.size());
    m_matrix.row.reserve(4 * number_of_entries + 2 * n);
    m_matrix.value.reserve(4 * number_of_entries + 2 * n);
    std::size_t begin = 0;
    for (int column = 0; column < n; ++column) {
      std::size_t end = begin;
      while (end < entries.size() && entries[end].column == column)
        ++end;
      for (const int part : {0, 1}) {
        append(2 * column + part, m_diagonal[column]);
        for (std::size_t k = begin; k < end; ++k) {
          const Complex value = entries[k].value;
          append(2 * entries[k].row, part == 0 ? value.real() : -value.imag());
          append(2 * entries[k].row + 1, part == 0 ? value.imag() : value.real());
        }
        m_matrix.column_begin.push_back(static_cast<int>(m_matrix.row.size()));
      }
      begin = end;
    }
  }

  void append(const int row, const double value)
  {
    m_matrix.row.push_back(row);
    m_matrix.value.push_back(value);
  }

  std::vector<int> m_vertices;     // free vertices
  int m_first = 0;                 // the smallest vertex of the component
  std::vector<int> m_index;        // per vertex from m_first on: its number among the free ones, or null
  std::vector<double> m_mass, m_diagonal, m_boundary_term;
  double m_area = 0;
  Symmetric_sparse_matrix<double> m_matrix;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H
