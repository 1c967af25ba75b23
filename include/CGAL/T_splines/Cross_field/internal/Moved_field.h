// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_MOVED_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_MOVED_FIELD_H

#include <CGAL/T_splines/Cross_field/internal/Cone_paths.h>
#include <CGAL/T_splines/Cross_field/internal/Cone_reduction.h>
#include <CGAL/T_splines/Cross_field/internal/Cone_regions.h>
#include <CGAL/T_splines/Cross_field/internal/Field_relaxation.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/write_cross_field.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/Cross_field/support/matched_rotations.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether named parameters have a cross field.
template <typename NamedParameters>
inline constexpr bool has_cross_field_map = !is_missing<decltype(CGAL::parameters::get_parameter(
    std::declval<const NamedParameters&>(), np_tags::cross_field_map))>;

/// A cross field that is changed as its signature is: quarter turns move along paths between cones, and then the crosses
/// relax.
class Moved_field {
public:
  /// Takes the field of the named parameters.
  template <typename TriangleMesh, typename NamedParameters>
  Moved_field(const Signature_domain<TriangleMesh>& domain, const Cone_regions& regions, const NamedParameters& np)
    : m_mesh(domain.m_connectivity),
      m_geometry(domain.m_geometry),
      m_is_fixed(m_mesh.number_of_faces(), 0),
      m_nearness(
          CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, np_tags::curvature_alignment), 0.))
  {
    cross_angles(domain.m_indexing, m_mesh, m_geometry, CGAL::parameters::get_parameter(np, np_tags::cross_field_map),
                 m_given_angle);
    m_given_rotation =
        matched_rotations(domain.m_indexing, m_mesh, angles_to_halfedges(m_mesh, m_geometry, m_given_angle), np);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) != m_mesh.null &&
          (regions.is_constrained(edge_of(h)) || m_mesh.face(opposite(h)) == m_mesh.null))
        m_is_fixed[m_mesh.face(h)] = 1;
  }

  /// \return false if the solver fails, or `progress` is interrupted
  template <typename SolverTraits>
  bool compute(const std::vector<Cone_move>& moves, Cone_paths& paths, SolverTraits& solver, Progress& progress)
  {
    m_angle = m_given_angle;
    std::vector<double> rotation = m_given_rotation;
    for (const Cone_move& move : moves) {
      for (const int h : paths.path(move.from, move.to))
        rotation[edge_of(h)] += (is_along_edge(h) ? move.quarter_turns : -move.quarter_turns) * quarter_turn;
      if (progress.is_interrupted())
        return false;
    }
    Field_relaxation relaxation(m_mesh, m_geometry, std::move(rotation), m_is_fixed, m_nearness);
    const bool is_relaxed = relaxation.relax(solver, progress, m_angle);
    m_rotation = relaxation.rotation();
    return is_relaxed;
  }

  /// The edges across which the field turns by a quarter turn or more, and by more than it did: there is too little room for
  /// what was moved.
  std::vector<int> overturned_edges() const
  {
    std::vector<int> result;
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (std::abs(m_rotation[e]) >= (std::max)(quarter_turn, std::abs(m_given_rotation[e]) + summed_round_off))
        result.push_back(e);
    return result;
  }

  /// Writes the field, and its matchings if these are asked for.
  template <typename TriangleMesh, typename NamedParameters>
  void write(const Signature_domain<TriangleMesh>& domain, const NamedParameters& np) const
  {
    auto field = CGAL::parameters::get_parameter(np, np_tags::cross_field_map);
    write_cross_field(domain.m_indexing, m_mesh, m_geometry, m_angle, field);
    const auto matchings = CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map);
    if constexpr (!is_missing<decltype(matchings)>)
      write_matchings(domain.m_indexing, m_mesh, m_geometry, m_angle, m_rotation, matchings);
  }

private:
  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  std::vector<double> m_given_angle, m_angle;       // per face
  std::vector<double> m_given_rotation, m_rotation; // per edge
  std::vector<char> m_is_fixed;                     // per face
  double m_nearness;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_MOVED_FIELD_H
