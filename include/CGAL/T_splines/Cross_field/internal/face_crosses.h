// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FACE_CROSSES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FACE_CROSSES_H

#include <CGAL/T_splines/Cross_field/internal/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
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

/// Makes the turns around vertices positive: a seamless map needs at least one quarter turn.
///
/// At a sharp spike, with a total angle of less than pi/4, the smoothest cross does not turn at all. There the crosses of
/// the faces around the vertex are replaced by some that rotate evenly and make one quarter turn.
class Low_vertex_repair {
public:
  Low_vertex_repair(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                    const std::vector<char>& is_face_fixed, std::vector<double>& angle)
    : m_mesh(mesh), m_geometry(geometry), m_is_face_fixed(is_face_fixed), m_angle(angle), m_outgoing(mesh.outgoing_halfedges())
  {}

  /// repairs the vertices in the order of their indices. \return how many were repaired.
  int repair()
  {
    int number_repaired = 0;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_outgoing[v] != Triangulation_connectivity::null && turns(v) < 1 && repair(v))
        ++number_repaired;
    return number_repaired;
  }

private:
  static constexpr int number_of_candidates = 64;

  double relative_angle(const int h) const { return m_angle[m_mesh.face(h)] - m_geometry.direction(m_mesh, h); }

  // The quarter turns around `v`; regular for vertices on the border.
  int turns(const int v) const
  {
    double turning = 0;
    int h = m_outgoing[v];
    do {
      if (m_mesh.face(h) == Triangulation_connectivity::null ||
          m_mesh.face(m_mesh.opposite(h)) == Triangulation_connectivity::null)
        return 4;
      // As in field_rotations(), to the last bit: a tie must be broken in the same way.
      const int even = h & ~1;
      const double rotation = std::remainder(relative_angle(even) - relative_angle(even + 1), quarter_turn);
      turning += m_geometry.m_corner_angle[m_mesh.previous(h)] - (h == even ? rotation : -rotation);
      h = m_mesh.next_around_source(h);
    } while (h != m_outgoing[v]);
    return static_cast<int>(std::lround(turning / quarter_turn));
  }

  bool repair(const int v)
  {
    std::vector<int> ring; // outgoing halfedges, counter-clockwise
    double total = 0;
    for (int h = m_outgoing[v]; ring.empty() || h != m_outgoing[v]; h = m_mesh.next_around_source(h)) {
      if (m_is_face_fixed[m_mesh.face(h)])
        return false;
      ring.push_back(h);
      total += m_geometry.m_corner_angle[m_mesh.previous(h)];
    }
    const double rotation = (total - quarter_turn) / static_cast<double>(ring.size());
    if (std::abs(rotation) >= 0.5 * quarter_turn)
      return false;
    std::vector<double> before;
    for (const int h : ring)
      before.push_back(m_angle[m_mesh.face(h)]);
    const double first = before.front();
    int best = -1, best_defect = 0;
    for (int candidate = 0; candidate < number_of_candidates; ++candidate) {
      set_ring(ring, first + candidate * quarter_turn / number_of_candidates, rotation);
      int defect = 0;
      bool is_admissible = turns(v) == 1;
      for (const int h : ring) {
        const int k = turns(m_mesh.target(h));
        is_admissible = is_admissible && k >= 1;
        defect += std::abs(k - 4);
      }
      if (is_admissible && (best < 0 || defect < best_defect)) {
        best = candidate;
        best_defect = defect;
      }
    }
    if (best >= 0)
      set_ring(ring, first + best * quarter_turn / number_of_candidates, rotation);
    else
      for (std::size_t i = 0; i < ring.size(); ++i)
        m_angle[m_mesh.face(ring[i])] = before[i];
    return best >= 0;
  }

  // Crosses that rotate by the same angle from each face of the ring to the next.
  void set_ring(const std::vector<int>& ring, const double first, const double rotation)
  {
    m_angle[m_mesh.face(ring.front())] = first;
    for (std::size_t i = 1; i < ring.size(); ++i)
      m_angle[m_mesh.face(ring[i])] = m_geometry.direction(m_mesh, ring[i]) + CGAL_PI + rotation +
                                      relative_angle(m_mesh.opposite(ring[i]));
  }

  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const std::vector<char>& m_is_face_fixed;
  std::vector<double>& m_angle;
  std::vector<int> m_outgoing;
};

/// Counts the vertices around which a field on the faces does not make four quarter turns. The border does not count.
class Singularity_counter {
public:
  Singularity_counter(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
    : m_mesh(mesh), m_geometry(geometry), m_turning(mesh.number_of_vertices(), 0.)
  {}

  /// counts the singularities of one component. Complexity: linear in its size.
  int count(const std::vector<int>& faces, const std::vector<int>& vertices, const std::vector<double>& angle)
  {
    constexpr double border = std::numeric_limits<double>::infinity();
    for (const int v : vertices)
      m_turning[v] = 0;
    for (const int f : faces) {
      int h = m_mesh.halfedge_of_face(f);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h)) {
        m_turning[m_mesh.target(h)] += m_geometry.m_corner_angle[h];
        const int g = m_mesh.opposite(h);
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
