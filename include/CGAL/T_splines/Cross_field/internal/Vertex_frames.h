// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_FRAMES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_FRAMES_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// An intrinsic triangulation of a surface with the tangent planes of its vertices (Knoeppel, Crane, Pinkall, Schroeder,
/// Globally optimal direction fields, 2013, section 3; with intrinsic flips as in Sharp, Soliman, Crane, Navigating intrinsic
/// triangulations, 2019).
///
/// The tangent plane of a vertex has polar angles that run from 0, along one outgoing edge, counter-clockwise through its corners.
/// Unscaled they add up to its total angle; times `m_scale` they add up to 2 pi at interior vertices.
struct Vertex_frames {
  Triangulation_connectivity m_mesh;
  std::vector<double> m_length; ///< per edge
  std::vector<double> m_polar;  ///< per halfedge: its unscaled polar angle at its source
  std::vector<double> m_total;  ///< per vertex: the sum of its corner angles
  std::vector<double> m_scale;  ///< per vertex: 2 pi / total in the interior, 1 on the border

  /// The angle of `h` in the tangent plane of its source.
  double direction(const int h) const { return m_polar[h] * m_scale[m_mesh.source(h)]; }

  /// The angle of the face of `h` at the target of `h`.
  double corner_angle(const int h) const
  {
    const double a = m_length[edge_of(h)], b = m_length[edge_of(m_mesh.next(h))],
                 c = m_length[edge_of(m_mesh.previous(h))];
    const double numerator = (c - (a - b)) * (c + (a - b)), denominator = ((a + b) - c) * ((a + b) + c);
    return 2 * std::atan2(std::sqrt((std::max)(0., numerator)), std::sqrt((std::max)(0., denominator)));
  }

  /// Cotangents are cut off here, so that sums of them stay finite.
  static constexpr double largest_cotangent = 1e8; // that of an angle whose square is the unit of rounding

  double cotangent_opposite(const int h) const
  {
    const double angle = corner_angle(m_mesh.next(h));
    const double cotangent = std::cos(angle) / (std::max)(std::sin(angle), 1. / largest_cotangent);
    return (std::min)((std::max)(cotangent, -largest_cotangent), largest_cotangent);
  }
};

/// The tangent planes of the vertices of a mesh, borders allowed.
inline Vertex_frames vertex_frames(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
{
  constexpr int null = Triangulation_connectivity::null;
  Vertex_frames frames;
  frames.m_mesh = mesh;
  frames.m_length = geometry.m_edge_length;
  frames.m_polar.assign(mesh.number_of_halfedges(), 0.);
  frames.m_total.assign(mesh.number_of_vertices(), 0.);
  frames.m_scale.assign(mesh.number_of_vertices(), 1.);
  const std::vector<int> outgoing = mesh.outgoing_halfedges();
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (outgoing[v] == null)
      continue;
    int first = outgoing[v];
    bool is_on_border = false;
    do { // clockwise, to the border if there is one
      is_on_border = mesh.face(opposite(first)) == null;
      if (!is_on_border)
        first = mesh.next(opposite(first));
    } while (!is_on_border && first != outgoing[v]);
    int h = first;
    do {
      frames.m_polar[h] = frames.m_total[v];
      if (mesh.face(h) == null)
        break;
      frames.m_total[v] += geometry.m_corner_angle[mesh.previous(h)];
      h = mesh.next_around_source(h);
    } while (h != first);
    if (!is_on_border && frames.m_total[v] > 0)
      frames.m_scale[v] = 2 * CGAL_PI / frames.m_total[v];
  }
  return frames;
}

/// flips the edges of `frames` until the triangulation is intrinsically Delaunay: all its cotangent weights are then not
/// negative up to round-off. Of the members, only connectivity and lengths are read and changed.
/// \param on_flip is called after each flip with the even halfedge of the edge, the two other halfedges of the face that
///        was on its left, in their order, and those of the face on its right
/// \param progress if it is interrupted, edges are left that are not Delaunay
template <typename OnFlip>
void flip_to_delaunay(Vertex_frames& frames, const OnFlip& on_flip, Progress& progress)
{
  Triangulation_connectivity& mesh = frames.m_mesh;
  constexpr int null = Triangulation_connectivity::null;
  // A bound on round-off: exact arithmetic would need none.
  constexpr double tolerance = 1e-10;
  std::size_t flips_left = 200 * static_cast<std::size_t>(mesh.number_of_edges());
  std::vector<int> queue(mesh.number_of_edges());
  std::vector<char> is_queued(mesh.number_of_edges(), 1);
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    queue[e] = e;
  while (!queue.empty() && flips_left > 0 && progress.go_on_after(4)) {
    const int e = queue.back();
    const auto [h, g] = halfedges_of_edge(e);
    queue.pop_back();
    is_queued[e] = 0;
    if (mesh.face(h) == null || mesh.face(g) == null || mesh.face(h) == mesh.face(g))
      continue;
    const int h1 = mesh.next(h), h2 = mesh.next(h1), g1 = mesh.next(g), g2 = mesh.next(g1);
    if (frames.corner_angle(h1) + frames.corner_angle(g1) <= CGAL_PI + tolerance)
      continue;
    // The other diagonal, by the law of cosines in a form without cancellation.
    const double b = frames.m_length[edge_of(h2)], c = frames.m_length[edge_of(g1)];
    const double sine = std::sin((frames.corner_angle(h2) + frames.corner_angle(g)) / 2);
    mesh.flip(h);
    --flips_left;
    frames.m_length[e] = std::sqrt((b - c) * (b - c) + 4 * b * c * sine * sine);
    on_flip(h, h1, h2, g1, g2);
    for (const int side : {h1, h2, g1, g2}) {
      if (!is_queued[edge_of(side)]) {
        is_queued[edge_of(side)] = 1;
        queue.push_back(edge_of(side));
      }
    }
  }
}

/// does `flip_to_delaunay()`; the polar angles of the edges follow.
inline void make_delaunay(Vertex_frames& frames, Progress& progress)
{
  const Triangulation_connectivity& mesh = frames.m_mesh;
  const auto place_after = [&frames, &mesh](const int flipped, const int clockwise_neighbor) {
    const double total = frames.m_total[mesh.source(flipped)];
    const double polar = frames.m_polar[clockwise_neighbor] + frames.corner_angle(mesh.previous(clockwise_neighbor));
    frames.m_polar[flipped] = polar >= total && frames.m_scale[mesh.source(flipped)] != 1 ? polar - total : polar;
  };
  flip_to_delaunay(
      frames,
      [&](const int h, const int /*h1*/, const int h2, const int /*g1*/, const int g2) {
        place_after(h, g2);
        place_after(opposite(h), h2);
      },
      progress);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_FRAMES_H
