// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_ALIGNED_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_ALIGNED_FIELD_H

#include <CGAL/T_splines/Cross_field/internal/Border_guide.h>
#include <CGAL/T_splines/Cross_field/internal/Feature_detection.h>
#include <CGAL/T_splines/Cross_field/internal/Low_vertex_repair.h>
#include <CGAL/T_splines/Cross_field/internal/Smooth_field_computation.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_sectors.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The computation behind `compute_feature_aligned_cross_field()`, in index arrays.
///
/// A field that is pinned to the features makes, in a sector between two of them, the number of quarter turns next to its
/// angle, or whatever its crosses make of it: none in a sharp corner. Such a sector gets a quarter turn from elsewhere. Where it is
/// narrower than `narrow`, or where no quarter turn is left, one of its two features goes soft instead, the one
/// that is weaker by its angle times its length, and the field is computed anew.
class Feature_aligned_field {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// A feature that the field does not follow, and where it would have left a sector without a quarter turn.
  struct Soft_edge {
    int edge, vertex;
  };

  /// \param are_corners_given whether those of `guide` are to be met in any case, not only where the crosses turn so
  /// \param options of the field; which edges are constrained is changed by `compute()`
  /// \param is_feature per edge; none on the border
  /// \param narrow_sector the angle below which sectors do not get quarter turns from elsewhere
  /// \param progress it must outlive this
  Feature_aligned_field(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                        const Mesh_components& components, const Border_guide& guide, const bool are_corners_given,
                        Smooth_field_options& options, const std::vector<char>& is_feature, const double narrow_sector,
                        Progress& progress)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_components(components),
      m_guide(guide),
      m_are_corners_given(are_corners_given),
      m_options(options),
      m_is_feature(is_feature),
      m_edge_turn(edge_turns(mesh, geometry)),
      m_narrow_sector(narrow_sector),
      m_progress(progress)
  {
  }

  /// computes the field. \return `false` if the progress is interrupted.
  bool compute()
  {
    for (bool is_final = false; !is_final;) {
      ++m_number_of_rounds;
      constrain_edges();
      // How many rounds there will be is not known: each but the first gets half of what is left of the progress.
      const double begin = 1 - std::ldexp(1., 1 - m_number_of_rounds), end = 1 - std::ldexp(1., -m_number_of_rounds);
      const Progress::Part part(m_progress, begin, end);
      Smooth_field_computation computation(m_mesh, m_geometry, m_options, m_progress);
      if (!computation.compute_unrepaired(m_components))
        return false;
      m_angle = computation.angles();
      m_energy = computation.energy();
      const Vertex_sectors sectors(m_mesh, m_is_feature);
      const bool has_softened =
          m_number_of_rounds < most_rounds_for_narrow_sectors && soften(sectors, low_sectors(sectors), true);
      is_final = !has_softened && repair(sectors, computation.is_face_fixed());
      if (m_progress.is_interrupted())
        return false;
    }
    return true;
  }

  const std::vector<double>& angles() const { return m_angle; }        ///< of the cross, per face
  const std::vector<double>& rotations() const { return m_rotation; }  ///< of the cross, per edge
  const std::vector<char>& is_feature() const { return m_is_feature; } ///< per edge: those that the field follows
  const std::vector<Soft_edge>& soft_edges() const { return m_soft_edges; }
  int number_of_rounds() const { return m_number_of_rounds; }
  int number_of_repaired_sectors() const { return m_number_of_repaired; }
  double energy() const { return m_energy; }

  /// The quarter turns of the sectors, numbered as in `Vertex_sectors`, between the features that are left.
  std::vector<int> sector_turns() const
  {
    std::vector<int> result;
    const Vertex_sectors sectors(m_mesh, m_is_feature);
    for (const double turns : sectors.quarter_turns(m_geometry.m_corner_angle, m_rotation, border_crosses()))
      result.push_back(static_cast<int>(std::lround(turns)));
    return result;
  }

private:
  // Of the quarter turns of a sector from its angle: a corner of 270 degrees with two of them would fold in a spline that is
  // sharp there. Where less is demanded, maps of parts with many features are often no longer possible.
  static constexpr double largest_difference_of_turns = 0.75;

  // Then narrow sectors get quarter turns, too. One round or two are usual.
  static constexpr int most_rounds_for_narrow_sectors = 20;

  void constrain_edges()
  {
    for (int e = 0; e < m_mesh.number_of_edges(); ++e) {
      const auto [h, g] = halfedges_of_edge(e);
      m_options.is_edge_constrained[e] = m_is_feature[e] || m_mesh.face(h) == null || m_mesh.face(g) == null;
    }
  }

  std::vector<double> border_crosses() const
  {
    int worst = 0;
    double largest = 0;
    return internal::border_crosses(m_mesh, m_geometry, m_guide, angles_to_halfedges(m_mesh, m_geometry, m_angle),
                                    worst, largest);
  }

  // The sectors next to features in which the field makes no quarter turn, if rotations are the closest ones.
  std::vector<int> low_sectors(const Vertex_sectors& sectors) const
  {
    const std::vector<double> rotation = field_rotations(m_mesh, angles_to_halfedges(m_mesh, m_geometry, m_angle));
    const std::vector<double> turns = sectors.quarter_turns(m_geometry.m_corner_angle, rotation, border_crosses());
    std::vector<int> result;
    for (int s = 0; s < sectors.size(); ++s)
      if (sectors.has_bounds(s) && !sectors.is_between_borders(s) && std::lround(turns[s]) < 1)
        result.push_back(s);
    return result;
  }

  // Of the features at both ends of each of some sectors, the weaker one goes soft. \return whether there was one.
  bool soften(const Vertex_sectors& sectors, const std::vector<int>& low, const bool only_narrow_ones)
  {
    const std::vector<double> angles = sectors.angles(m_geometry.m_corner_angle);
    bool is_changed = false;
    for (const int s : low) {
      if (only_narrow_ones && angles[s] >= m_narrow_sector)
        continue;
      int weaker = null;
      for (const int h : {sectors.first(s), sectors.last(s)})
        if (is_feature_of(h) && (weaker == null || strength(edge_of(h)) < strength(weaker)))
          weaker = edge_of(h);
      if (weaker == null || !m_is_feature[weaker])
        continue;
      m_is_feature[weaker] = 0;
      m_soft_edges.push_back({weaker, sectors.vertex(s)});
      is_changed = true;
    }
    return is_changed;
  }

  bool is_feature_of(const int h) const { return m_mesh.face(h) != null && m_mesh.face(opposite(h)) != null; }
  double strength(const int e) const { return m_edge_turn[e] * m_geometry.m_edge_length[e]; }

  // \return whether all sectors have quarter turns; if not, features went soft.
  bool repair(const Vertex_sectors& sectors, const std::vector<char>& is_face_fixed)
  {
    Low_vertex_repair repair(m_mesh, m_geometry, sectors, border_crosses(), Low_vertex_repair::Fixed_crosses::STAY,
                             is_face_fixed, m_angle, m_progress);
    m_number_of_repaired = repair.repair() + repair.meet_angles(largest_difference_of_turns);
    if (m_are_corners_given)
      repair.meet_corners(m_guide.quarter_turns());
    m_rotation = repair.rotations();
    if (!m_progress.go_on())
      return false;
    std::vector<int> low;
    for (int s = 0; s < sectors.size(); ++s)
      if (sectors.has_bounds(s) && !sectors.is_between_borders(s) && repair.turns()[s] < 1)
        low.push_back(s);
    return !soften(sectors, low, false);
  }

  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const Mesh_components& m_components;
  const Border_guide& m_guide;
  const bool m_are_corners_given;
  Smooth_field_options& m_options;
  std::vector<char> m_is_feature;  // per edge
  std::vector<double> m_edge_turn; // per edge
  const double m_narrow_sector;
  Progress& m_progress;
  std::vector<double> m_angle;    // per face
  std::vector<double> m_rotation; // per edge
  std::vector<Soft_edge> m_soft_edges;
  int m_number_of_rounds = 0, m_number_of_repaired = 0;
  double m_energy = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_ALIGNED_FIELD_H
