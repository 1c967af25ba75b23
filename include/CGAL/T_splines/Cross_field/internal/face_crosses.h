// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FACE_CROSSES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FACE_CROSSES_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The value of a field on vertices, given as fourth powers, at the barycenter of face `f`: the mean of its corners, each turned
/// with the middle of its corner. \param is_normalized whether the corners count alike, or by their lengths
inline std::complex<double> value_in_face(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                                          const Vertex_frames& frames, const std::vector<std::complex<double>>& field,
                                          const int f, const bool is_normalized)
{
  std::complex<double> sum(0);
  int h = mesh.halfedge_of_face(f);
  for (int corner = 0; corner < 3; ++corner, h = mesh.next(h)) {
    const int v = mesh.source(h);
    const double half_angle = 0.5 * geometry.m_corner_angle[mesh.previous(h)];
    const double turn = geometry.direction(mesh, h) + half_angle - frames.direction(h) - half_angle * frames.m_scale[v];
    const double length = is_normalized ? std::abs(field[v]) : 1.;
    if (length > 0)
      sum += field[v] / length * std::polar(1., 4 * turn);
  }
  return sum;
}

/// Counts the vertices around which a field on the faces does not make four quarter turns. The border does not count.
class Singularity_counter {
public:
  Singularity_counter(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_turning(mesh.number_of_vertices(), 0.)
  {
  }

  /// counts the singularities of one component. Complexity: linear in its size.
  /// \param progress if it is interrupted, the number means nothing
  int count(const std::vector<int>& faces, const std::vector<int>& vertices, const std::vector<double>& angle,
            Progress& progress)
  {
    constexpr double border = std::numeric_limits<double>::infinity();
    for (const int v : vertices)
      m_turning[v] = 0;
    for (const int f : faces) {
      if (!progress.go_on_after(5))
        return 0;
      int h = m_mesh.halfedge_of_face(f);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h)) {
        m_turning[m_mesh.target(h)] += m_geometry.m_corner_angle[h];
        const int g = opposite(h);
        if (m_mesh.face(g) == Triangulation_connectivity::null)
          m_turning[m_mesh.source(h)] = m_turning[m_mesh.target(h)] = border;
        else if (h < g) {
          const double rotation = std::remainder(angle[f] - m_geometry.direction(m_mesh, h) - angle[m_mesh.face(g)] +
                                                     m_geometry.direction(m_mesh, g),
                                                 quarter_turn);
          m_turning[m_mesh.source(h)] -= rotation;
          m_turning[m_mesh.target(h)] += rotation;
        }
      }
    }
    return static_cast<int>(std::count_if(vertices.begin(), vertices.end(), [this](const int v) {
      return m_turning[v] != border && std::lround(m_turning[v] / quarter_turn) != 4;
    }));
  }

private:
  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  std::vector<double> m_turning; // per vertex
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FACE_CROSSES_H
