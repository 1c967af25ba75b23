// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H

#include <CGAL/T_splines/internal/element_numbers.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// Whether distances were measured, and if not, why.
enum class T_spline_deviation_status {
  MEASURED,             ///< the distances are known
  NO_FACES,             ///< the mesh has no face
  NOT_TRIANGULATED,     ///< `face` is not a triangle
  VERTEX_NOT_FINITE,    ///< a coordinate of `vertex` is not a number, or greater than 1e70
  SURFACE_NOT_FINITE,   ///< the same for a point of the surface
  SURFACE_WITHOUT_FACES ///< the T-mesh has no face
};

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
  }
  return "";
}

/// The distances of the points of one surface from another.
struct One_way_deviation {
  double rms = 0;     ///< root of the mean of the squared distances, weighted by area
  double maximum = 0; ///< the largest distance
  double extent = 0;  ///< the longest side of the bounding box of the mesh: that of the cube which encloses it
  CGAL::Simple_cartesian<double>::Point_3 farthest_point = {0, 0, 0}; ///< the point with the largest distance
  std::size_t number_of_samples = 0;                                  ///< at how many points distances were measured

  double relative_rms() const { return extent > 0 ? rms / extent : 0; }
  double relative_maximum() const { return extent > 0 ? maximum / extent : 0; }
};

/// What `measure_T_spline_deviation()` found. Members that `status` does not mention have no meaning.
/// \tparam TriangleMesh a model of `FaceGraph`
template <typename TriangleMesh>
struct T_spline_deviation_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  T_spline_deviation_status status = T_spline_deviation_status::MEASURED;
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();
  typename Traits::face_descriptor face = Traits::null_face();
  One_way_deviation mesh_to_surface; ///< of the points of the mesh from the surface
  One_way_deviation surface_to_mesh; ///< of the points of the surface from the mesh
  int resolution = 0;                ///< of the tessellation: the parts of the side of a face

  /// returns the Hausdorff distance, as sampled.
  double maximum() const
  {
    return mesh_to_surface.maximum < surface_to_mesh.maximum ? surface_to_mesh.maximum : mesh_to_surface.maximum;
  }

  bool success() const { return status == T_spline_deviation_status::MEASURED; }
  explicit operator bool() const { return success(); }
};

/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the mesh.
template <typename TriangleMesh>
std::string describe(const T_spline_deviation_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  return message(report.status) + internal::numbered_elements(mesh, report.vertex, report.face);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_DEVIATION_REPORT_H
