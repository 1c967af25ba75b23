// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Solver/support/Hermitian_rows.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

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
/// the edges, a Hermitian form.
class Connection_laplacian {
public:
  using Complex = std::complex<double>;
  using Rows = Hermitian_rows<Complex>;

  /// \param frames an intrinsically Delaunay triangulation
  /// \param vertices the vertices of the component
  /// \param halfedges the halfedges of even index of the component
  /// \param fixed per vertex of the whole mesh: its value if it is not free, 0 if it is
  /// \param progress if it is interrupted, entries are missing
  Connection_laplacian(const Vertex_frames& frames, const std::vector<int>& vertices, const std::vector<int>& halfedges,
                       const std::vector<Complex>& fixed, Progress& progress)
  {
    number_free_vertices(vertices, fixed);
    add_masses(frames, halfedges);
    std::vector<Rows::Lower_entry> entries;
    entries.reserve(halfedges.size());
    progress.go_on();
    for (const int h : halfedges)
      if (progress.go_on_after(10))
        add_edge(frames, h, fixed, entries);
    m_matrix = Rows::from_lower_triangle(m_diagonal, entries);
  }

  /// The free vertices, in the order of the rows.
  const std::vector<int>& free_vertices() const { return m_vertices; }
  const std::vector<double>& masses() const { return m_mass; } ///< per free vertex: a third of the areas around it
  double area() const { return m_area; }

  /// The right-hand side that the values of the fixed vertices make.
  const std::vector<Complex>& boundary_term() const { return m_boundary_term; }

  /// L + b M.
  Rows shifted(const double b) const
  {
    Rows result = m_matrix;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
      result.diagonal[i] += b * m_mass[i];
    return result;
  }

private:
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
    m_boundary_term.assign(m_vertices.size(), Complex(0));
  }

  void add_masses(const Vertex_frames& frames, const std::vector<int>& halfedges)
  {
    const Triangulation_connectivity& mesh = frames.m_mesh;
    for (const int even : halfedges) {
      for (const int h : {even, opposite(even)}) {
        if (mesh.face(h) == Triangulation_connectivity::null)
          continue;
        const double area = 0.5 * frames.m_length[edge_of(h)] * frames.m_length[edge_of(mesh.next(h))] *
                            std::sin(frames.corner_angle(h));
        m_area += area / 3;
        const int i = m_index[mesh.target(h) - m_first];
        if (i != Triangulation_connectivity::null)
          m_mass[i] += area / 3;
      }
    }
    // Where triangles are flat to working precision a vertex might have none.
    constexpr double least_share = 1e-10; // of the mean
    const double smallest = least_share * m_area / static_cast<double>((std::max)(std::size_t(1), m_mass.size()));
    for (double& mass : m_mass)
      mass = (std::max)(mass, smallest);
  }

  void add_edge(const Vertex_frames& frames, const int h, const std::vector<Complex>& fixed,
                std::vector<Rows::Lower_entry>& entries)
  {
    const Triangulation_connectivity& mesh = frames.m_mesh;
    double weight = 0;
    for (const int side : {h, opposite(h)})
      if (mesh.face(side) != Triangulation_connectivity::null)
        weight += 0.5 * frames.cotangent_opposite(side);
    weight = (std::max)(weight, 0.);
    const int v = mesh.source(h), w = mesh.target(h);
    const int i = m_index[v - m_first], j = m_index[w - m_first];
    // A vector of angle a at v is carried to w at the angle a - direction(h) + direction(opposite(h)) + pi.
    const Complex transport = std::polar(1., 4 * (frames.direction(opposite(h)) + CGAL_PI - frames.direction(h)));
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

  void add_boundary_term(const int i, const Complex value) { m_boundary_term[i] += value; }

  std::vector<int> m_vertices; // free vertices
  int m_first = 0;             // the smallest vertex of the component
  std::vector<int> m_index;    // per vertex from m_first on: its number among the free ones, or null
  std::vector<double> m_mass, m_diagonal;
  std::vector<Complex> m_boundary_term;
  double m_area = 0;
  Rows m_matrix;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONNECTION_LAPLACIAN_H
