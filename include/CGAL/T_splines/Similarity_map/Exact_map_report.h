// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_EXACT_MAP_REPORT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_EXACT_MAP_REPORT_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// How `make_exactly_seamless()` ended.
enum class Exact_map_status {
  EXACT,                  ///< the map is exactly seamless and its triangles are exactly positively oriented
  INVALID_MESH,           ///< the connectivity is refused: `mesh` names the element
  MAP_OF_OTHER_MESH,      ///< the map was made on another mesh, or before this one was changed; it is left as it was
  NON_FINITE_UV,          ///< the coordinates of `halfedge` are infinite or not a number
  FLIPPED_TRIANGLES,      ///< of `faces`, none is positively oriented in the plane, and at least one negatively
  DEGENERATE_TRIANGLES,   ///< `faces` have area zero in the plane, exactly
  CONE_ANGLE,             ///< the angle around `vertex` is off a multiple of a right angle by `deviation` (radians)
  TRANSITION_ROTATION,    ///< the rotation across `halfedge` is no quarter turn, or not that of its branch
  TRANSITION_NOT_SIMILAR, ///< across `halfedge` the coordinates do not change by the similarity of its branch
  SCALE_PRODUCT,          ///< the scale factors around `vertex` do not multiply to 1
  BORDER_NOT_ALIGNED,     ///< the border edge of `halfedge` is not parallel to an axis
  CONSTRAINED_EDGE_NOT_ALIGNED, ///< the edge of `halfedge`, which is to lie on an isoline, is not parallel to an axis
  ORIENTATION_LOST,             ///< with exact transitions, `faces` are not positively oriented
  INTERRUPTED                   ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSimilarityMap
/// returns one sentence that explains `status`.
inline const char* message(const Exact_map_status status)
{
  switch (status) {
  case Exact_map_status::EXACT: return "the map is exactly seamless";
  case Exact_map_status::INVALID_MESH: return "the mesh is not a triangle mesh with manifold vertices";
  case Exact_map_status::MAP_OF_OTHER_MESH:
    return "the map to write was made on another mesh, or before the mesh was changed; make a new one";
  case Exact_map_status::NON_FINITE_UV: return "a coordinate of the map is infinite or not a number";
  case Exact_map_status::FLIPPED_TRIANGLES: return "the map has triangles that are not positively oriented";
  case Exact_map_status::DEGENERATE_TRIANGLES: return "the map has triangles of area zero";
  case Exact_map_status::CONE_ANGLE: return "the angle around a vertex is no multiple of a right angle";
  case Exact_map_status::TRANSITION_ROTATION: return "the rotation across a seam is no multiple of a right angle";
  case Exact_map_status::TRANSITION_NOT_SIMILAR: return "the transition across a seam is no similarity";
  case Exact_map_status::SCALE_PRODUCT: return "the scale factors around a vertex do not multiply to one";
  case Exact_map_status::BORDER_NOT_ALIGNED: return "a border edge is not parallel to an axis";
  case Exact_map_status::CONSTRAINED_EDGE_NOT_ALIGNED:
    return "an edge that is to lie on an isoline is not parallel to an axis of the map";
  case Exact_map_status::ORIENTATION_LOST: return "exact transitions are not possible without flipping a triangle";
  case Exact_map_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSimilarityMap
/// What `make_exactly_seamless()` did and how it ended. Descriptors that `status` does not mention are null.
/// \tparam TriangleMesh a model of `HalfedgeGraph`.
template <typename TriangleMesh>
struct Exact_map_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  Exact_map_status status = Exact_map_status::INVALID_MESH; ///< how it ended

  Triangle_mesh_report<TriangleMesh> mesh; ///< INVALID_MESH: what is wrong with its connectivity
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();       ///< the vertex that `status` is about
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< the halfedge that `status` is about
  std::vector<typename Traits::face_descriptor> faces;                     ///< in the order of the mesh

  /// By how much the element that `status` names is off, in the unit that `status` says. For a transition, relative to
  /// the largest coordinate on its branch. If the map is exact, the largest deviation of a corner from the transition
  /// fitted to its branch.
  double deviation = 0;

  int number_of_cut_edges = 0;          ///< edges whose two charts differ
  int number_of_branches = 0;           ///< paths of cut edges with one transition
  int number_of_cones = 0;              ///< vertices whose quarter turns are not 4, on the border not 2
  int number_of_determined_corners = 0; ///< pairs of a vertex and a chart whose coordinates are not doubles
  bool is_isometric = true;             ///< all scale factors are exactly 1
  int scale_bits = 0;                   ///< precision of the free scale factors that are not 1; 0 if there is none
  double largest_displacement = 0;      ///< of a corner, by the longest side of its triangle

  int number_of_joined_lines = 0;     ///< isolines that connect two cones, or corners of the border, exactly
  int number_of_lines_left_apart = 0; ///< those that do so up to round-off only: scale factors, or triangles that would
                                      ///< turn over, do not allow more
  double largest_gap = 0; ///< from a joined line to its cone before, by the longest side of the triangle there

  /// returns whether `status` tells of success.
  bool success() const { return status == Exact_map_status::EXACT; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

namespace internal {

/// The number of faces, and the numbers of the first ones, counted from 0.
template <typename TriangleMesh>
std::string faces_in_words(const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& listed,
                           const TriangleMesh& mesh)
{
  constexpr std::size_t longest = 24; // of the list
  std::ostringstream text;
  text << listed.size() << (listed.size() == 1 ? " face," : " faces,");
  std::size_t number = 0, i = 0;
  for (const auto f : CGAL::make_range(faces(mesh))) { // both are in the order of the mesh
    if (i == (std::min)(listed.size(), longest))
      break;
    if (f == listed[i]) {
      text << " " << number;
      ++i;
    }
    ++number;
  }
  text << (listed.size() > longest ? " ...; counted from 0" : "; counted from 0");
  return text.str();
}

} // namespace internal

/// \ingroup PkgTSplinesSimilarityMap
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the mesh.
template <typename TriangleMesh>
std::string describe(const Exact_map_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  if (report.status == Exact_map_status::INVALID_MESH)
    return describe(report.mesh, mesh);
  if (report.success())
    return message(report.status);
  std::ostringstream text;
  text << message(report.status);
  if (!report.faces.empty())
    text << ": " << internal::faces_in_words(report.faces, mesh);
  if (report.vertex != Traits::null_vertex())
    text << ": " << internal::vertex_in_words(report.vertex, mesh) << ", counted from 0";
  if (report.halfedge != Traits::null_halfedge())
    text << ": " << internal::edge_in_words(report.halfedge, mesh) << " of "
         << internal::face_in_words(face(report.halfedge, mesh), mesh) << ", counted from 0";
  if (report.deviation > 0 && report.faces.empty())
    text << " (off by " << report.deviation << ")";
  return text.str();
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_EXACT_MAP_REPORT_H
