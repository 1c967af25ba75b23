// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H

#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Whether distances were measured, and if not, why.
enum class T_spline_deviation_status {
  MEASURED,              ///< the distances are known
  NO_FACES,              ///< the mesh has no face
  NOT_TRIANGULATED,      ///< `face` is not a triangle
  VERTEX_NOT_FINITE,     ///< a coordinate of `vertex` is not a number, or greater than 1e70
  SURFACE_NOT_FINITE,    ///< the same for a point of the surface
  SURFACE_WITHOUT_FACES, ///< the T-mesh has no face
  INTERRUPTED            ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_deviation_status status)
{
  switch (status) {
  case T_spline_deviation_status::MEASURED: return "the distances are measured";
  case T_spline_deviation_status::NO_FACES: return "the mesh has no face";
  case T_spline_deviation_status::NOT_TRIANGULATED: return "a face of the mesh is not a triangle";
  case T_spline_deviation_status::VERTEX_NOT_FINITE: return "a vertex has a coordinate that is not finite or too large";
  case T_spline_deviation_status::SURFACE_NOT_FINITE:
    return "the surface has points that are not finite or too far away";
  case T_spline_deviation_status::SURFACE_WITHOUT_FACES: return "the T-mesh of the surface has no face";
  case T_spline_deviation_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// The distances of the points of one surface, or of its border, from another.
struct One_way_deviation {
  double rms = 0;         ///< root of the mean of the squared distances, weighted by area; of borders, by length
  double maximum = 0;     ///< the largest distance found
  double upper_bound = 0; ///< no distance is larger: proven
  double extent = 0;      ///< the longest side of the bounding box of the mesh: that of the cube which encloses it
  CGAL::Simple_cartesian<double>::Point_3 farthest_point = {0, 0, 0}; ///< the point with the largest distance found
  CGAL::Simple_cartesian<double>::Point_3 closest_point = {0, 0, 0};  ///< the point of the other surface closest to it
  double share_within_tolerance = 1; ///< of the area or length, the share with distances of at most the tolerance
  double share_within_half = 1;      ///< and of at most half of it
  std::size_t number_of_samples = 0; ///< at how many points distances were measured for the mean

  /// returns the root mean square by the longest side of the box.
  double relative_rms() const { return relative(rms); }
  /// returns the maximum by the longest side of the box.
  double relative_maximum() const { return relative(maximum); }
  /// returns the proven bound by the longest side of the box.
  double relative_upper_bound() const { return relative(upper_bound); }

private:
  double relative(const double distance) const { return extent > 0 ? distance / extent : 0; }
};

/// \ingroup PkgTSplinesSpline
/// Where something was found: a place of the T-spline surface, and the face of the mesh next to it.
/// \tparam Graph the T-mesh, a model of `FaceGraph`
/// \tparam TriangleMesh the mesh, a model of `FaceGraph`
template <typename Graph, typename TriangleMesh>
struct Deviation_place {
  T_mesh_place<Graph, double> place; ///< of the T-spline surface
  /// The face of the mesh next to it.
  typename boost::graph_traits<TriangleMesh>::face_descriptor mesh_face =
      boost::graph_traits<TriangleMesh>::null_face();
};

/// \ingroup PkgTSplinesSpline
/// Where something was found on a curve, the border or a crease: a place of the T-spline surface, and the edge of the mesh
/// next to it.
/// \tparam Graph the T-mesh, a model of `FaceGraph`
/// \tparam TriangleMesh the mesh, a model of `FaceGraph`
template <typename Graph, typename TriangleMesh>
struct Curve_place {
  T_mesh_place<Graph, double> place; ///< of the T-spline surface
  /// The halfedge of the mesh next to it; on the border, a border halfedge.
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor mesh_halfedge =
      boost::graph_traits<TriangleMesh>::null_halfedge();
};

/// \ingroup PkgTSplinesSpline
/// The distances between curves of a surface, its border or its creases, and those of a mesh, both ways: between a point of
/// the one and the closest point of the other. Means are weighted by length.
template <typename Graph, typename TriangleMesh>
struct Curve_deviation {
  One_way_deviation mesh_to_surface; ///< of the points of the mesh's curves from those of the surface
  One_way_deviation surface_to_mesh; ///< of the points of the surface's curves from those of the mesh
  Curve_place<Graph, TriangleMesh> mesh_to_surface_place; ///< of the largest distance
  Curve_place<Graph, TriangleMesh> surface_to_mesh_place; ///< of the largest distance
  /// Of the surface: border vertices of the T-mesh with an extended valence other than 2; or where creases end.
  std::size_t number_of_corners = 0;
  /// Of a corner of the surface from the vertex of the mesh's curves closest to it.
  double largest_corner_distance = 0;

  /// returns the Hausdorff distance of the two sets of curves, as found.
  double maximum() const { return (std::max)(mesh_to_surface.maximum, surface_to_mesh.maximum); }
  /// returns a proven bound of the Hausdorff distance.
  double upper_bound() const { return (std::max)(mesh_to_surface.upper_bound, surface_to_mesh.upper_bound); }
  /// returns the larger one of the two root mean squares.
  double rms() const { return (std::max)(mesh_to_surface.rms, surface_to_mesh.rms); }
};

/// \ingroup PkgTSplinesSpline
/// The normals of a surface compared with those of a mesh at the closest points. Where a closest point lies on an edge
/// or at a vertex, the triangle with the smallest angle counts.
///
/// Where that is a right angle or more, the surface has a fold, unless the angle with a triangle within the tolerance
/// is less: there the mesh itself turns over within the tolerance, as at thin walls, sharp edges and where it meets
/// itself, and the place is doubtful.
template <typename Graph, typename TriangleMesh>
struct Normal_deviation {
  double largest_angle = 0;                                  ///< in radians: the largest angle found
  CGAL::Simple_cartesian<double>::Point_3 point = {0, 0, 0}; ///< of the surface, with that angle
  Deviation_place<Graph, TriangleMesh> place;                ///< where that is
  std::size_t number_of_patches = 0;                         ///< the Bezier patches
  std::size_t number_of_folded_patches = 0;                  ///< those where a fold was found
  std::size_t number_of_doubtful_patches = 0;                ///< others with a doubtful place
  std::size_t number_of_certified_patches = 0; ///< those for which bounds of the normals prove that there is neither
};

/// \ingroup PkgTSplinesSpline
/// What `measure_T_spline_deviation()` found. Members that `status` does not mention have no meaning.
/// \tparam Graph the T-mesh, a model of `FaceGraph`
/// \tparam TriangleMesh the mesh, a model of `FaceGraph`
template <typename Graph, typename TriangleMesh>
struct T_spline_deviation_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  T_spline_deviation_status status = T_spline_deviation_status::MEASURED; ///< whether the distances are known
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();      ///< the vertex that `status` is about
  typename Traits::face_descriptor face = Traits::null_face();            ///< the face that `status` is about
  One_way_deviation mesh_to_surface;                          ///< of the points of the mesh from the surface
  One_way_deviation surface_to_mesh;                          ///< of the points of the surface from the mesh
  Deviation_place<Graph, TriangleMesh> mesh_to_surface_place; ///< of the largest distance
  Deviation_place<Graph, TriangleMesh> surface_to_mesh_place; ///< of the largest distance
  Normal_deviation<Graph, TriangleMesh> normals;              ///< the angles between the normals
  /// Between the borders; none unless both have one.
  std::optional<Curve_deviation<Graph, TriangleMesh>> free_edge;
  /// Between the creases of the surface and the constrained edges of the mesh; none unless both have some.
  std::optional<Curve_deviation<Graph, TriangleMesh>> crease;
  double tolerance = (std::numeric_limits<double>::infinity)(); ///< that was given, as a length

  /// returns the Hausdorff distance, as found.
  double maximum() const { return (std::max)(mesh_to_surface.maximum, surface_to_mesh.maximum); }

  /// returns a proven bound of the Hausdorff distance.
  double upper_bound() const { return (std::max)(mesh_to_surface.upper_bound, surface_to_mesh.upper_bound); }

  /// returns the largest distance found between borders and between creases.
  double maximum_of_curves() const
  {
    return (std::max)(free_edge ? free_edge->maximum() : 0, crease ? crease->maximum() : 0);
  }

  /// returns whether no distance was found that exceeds the tolerance, neither between the surfaces nor between their
  /// borders nor between creases.
  bool within_tolerance() const { return maximum() <= tolerance && maximum_of_curves() <= tolerance; }

  /// returns whether there are folds. Doubtful places do not count.
  bool has_folds() const { return normals.number_of_folded_patches > 0; }

  /// returns whether `status` tells of success.
  bool success() const { return status == T_spline_deviation_status::MEASURED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the mesh.
template <typename Graph, typename TriangleMesh>
std::string describe(const T_spline_deviation_report<Graph, TriangleMesh>& report, const TriangleMesh& mesh)
{
  return message(report.status) + internal::numbered_elements(mesh, report.vertex, report.face);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H
