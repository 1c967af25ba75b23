// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIELD_IN_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIELD_IN_MAP_H

#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The angle of a cross field in the charts of a map, per face: a real number, continuous across edges but for the
/// rotations of the field.
///
/// Map and field turn alike around all vertices and loops if and only if there is such a function. Along a tree of
/// faces it is defined by adding the rotations; on all other edges it must close. It is unique up to a number for each component,
/// of which the multiple of a quarter turn is chosen that makes the mean by area least.
class Field_in_map {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param angle per halfedge: of the cross in the face of the halfedge, relative to the halfedge
  /// \param rotation per edge: of the field, as `field_rotations()` has them
  /// \param area per face
  Field_in_map(const Triangulation_connectivity& mesh, const Mesh_components& components, const Uv_array& uv,
               const std::vector<double>& angle, const std::vector<double>& rotation, const std::vector<double>& area)
    : m_mesh(mesh),
      m_angle(mesh.number_of_faces(), 0.),
      m_deviation(mesh.number_of_halfedges(), 0.),
      m_mean(components.size(), 0.)
  {
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      read_face(f, uv, angle);
    std::vector<char> is_reached(mesh.number_of_faces(), 0);
    for (int c = 0; c < components.size(); ++c)
      lift(components.first_face[c], rotation, is_reached);
    subtract_quarter_turns(components, area);
  }

  /// The angle of the cross to the u-axis, in a face.
  double operator[](const Index f) const { return m_angle[f]; }

  /// The same, as the edge of `h` sees it: the angles of the face in the plane are not those in space.
  double at_halfedge(const Index h) const { return m_angle[m_mesh.face(h)] + m_deviation[h]; }

  /// The mean by area in a component.
  double mean(const int component) const { return m_mean[component]; }

  /// An edge on which the angles do not close, as a halfedge, and by how much; `null` if they do.
  std::pair<Index, double> first_jump() const { return m_jump; }

private:
  void read_face(const Index f, const Uv_array& uv, const std::vector<double>& angle)
  {
    const Index first = m_mesh.halfedge_of_face(f);
    double sum = 0, at_first = 0;
    Index h = first;
    for (int i = 0; i < 3; ++i, h = m_mesh.next(h)) {
      const std::array<double, 2>&p = uv[m_mesh.previous(h)], &q = uv[h];
      const double in_chart = std::atan2(q[1] - p[1], q[0] - p[0]) + angle[h];
      if (i == 0)
        at_first = in_chart;
      m_deviation[h] = std::remainder(in_chart - at_first, 2 * CGAL_PI);
      sum += m_deviation[h];
    }
    m_angle[f] = at_first + sum / 3;
    for (int i = 0; i < 3; ++i, h = m_mesh.next(h))
      m_deviation[h] -= sum / 3;
  }

  void lift(const Index first, const std::vector<double>& rotation, std::vector<char>& is_reached)
  {
    constexpr double largest_round_off = 1e-3; // of a sum over many faces; a jump is a quarter turn or more
    std::vector<Index> queue{first};
    is_reached[first] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      Index h = m_mesh.halfedge_of_face(queue[i]);
      for (int k = 0; k < 3; ++k, h = m_mesh.next(h)) {
        const Index g = opposite(h), other = m_mesh.face(g);
        if (other == m_mesh.null)
          continue;
        const double there =
            at_halfedge(h) - (is_along_edge(h) ? rotation[edge_of(h)] : -rotation[edge_of(h)]) - m_deviation[g];
        if (is_reached[other] == 0) {
          is_reached[other] = 1;
          m_angle[other] = there;
          queue.push_back(other);
        }
        else if (m_jump.first == m_mesh.null && !(std::abs(there - m_angle[other]) < largest_round_off))
          m_jump = {h, std::abs(there - m_angle[other])};
      }
    }
  }

  void subtract_quarter_turns(const Mesh_components& components, const std::vector<double>& area)
  {
    std::vector<double> sum(components.size(), 0.);
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      m_mean[components.of_face[f]] += area[f] * m_angle[f];
      sum[components.of_face[f]] += area[f];
    }
    std::vector<double> turns;
    for (int c = 0; c < components.size(); ++c) {
      m_mean[c] /= sum[c];
      turns.push_back(quarter_turn * std::round(m_mean[c] / quarter_turn));
      m_mean[c] -= turns.back();
    }
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      m_angle[f] -= turns[components.of_face[f]];
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<double> m_angle;     // per face
  std::vector<double> m_deviation; // per halfedge
  std::vector<double> m_mean;      // per component
  std::pair<Index, double> m_jump{Triangulation_connectivity::null, 0};
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIELD_IN_MAP_H
