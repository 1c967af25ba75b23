// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H
#define CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H

#include <CGAL/T_splines/Spline/T_spline_self_intersection_report.h>
#include <CGAL/T_splines/Spline/internal/Mesh_intersections.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// What `check_T_spline_self_intersections()` does, the number of intersections of the mesh apart.
/// \param of_mesh returns the `Mesh_intersections`; it is only called where the surface passes through itself
/// \param progress if it is interrupted, the status says so, and no faces are written
template <typename Surface, typename OfMesh, typename OutputIterator>
T_spline_self_intersection_report find_new_self_intersections(const Surface& surface, const int resolution,
                                                              const OfMesh& of_mesh, const double tolerance,
                                                              OutputIterator faces, Progress& progress)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tessellation = CGAL::Surface_mesh<Kernel::Point_3>;
  T_spline_self_intersection_report report;
  const auto is_interrupted = [&] {
    if (!progress.go_on())
      report.status = T_spline_self_intersection_status::INTERRUPTED;
    return progress.is_interrupted();
  };
  const auto domain =
      tessellate_parameter_domain(surface, resolution, CGAL::parameters::visitor(Part_visitor(progress)));
  if (is_interrupted())
    return report;
  Tessellation tessellation;
  add_tessellation(surface, domain, tessellation, CGAL::parameters::default_values(), progress);
  if (is_interrupted())
    return report;
  const auto pairs = intersecting_faces(tessellation, tessellation.points(), progress);
  if (is_interrupted())
    return report;

  report.number_of_triangles = tessellation.number_of_faces();
  report.number_of_intersections = pairs.size();
  std::vector<int> found;
  const auto corners = [&](const auto f) { return corners_of(f, tessellation, tessellation.points()); };
  // A triangle may be in many pairs.
  std::vector<std::optional<bool>> is_near_mesh(tessellation.number_of_faces());
  const auto is_near = [&](const auto f) {
    std::optional<bool>& result = is_near_mesh[f];
    if (!result)
      result = of_mesh().is_near(corners(f), tolerance);
    return *result;
  };
  for (const auto& pair : pairs) {
    if (!progress.go_on_after(100)) {
      report.status = T_spline_self_intersection_status::INTERRUPTED;
      return report;
    }
    if (is_near(pair.first) && is_near(pair.second))
      continue;
    if (report.number_of_new_intersections++ == 0) {
      const auto a = corners(pair.first);
      report.place = CGAL::centroid(a[0], a[1], a[2]);
    }
    for (const auto f : {pair.first, pair.second})
      found.push_back(surface.indexing().face_index(domain.faces[f]));
  }
  if (is_interrupted()) // of_mesh() may have been
    return report;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const int f : found)
    *faces++ = surface.indexing().face(f);
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// checks where a T-spline surface passes through itself: the triangles of its tessellation, by exact predicates; and
/// whether the mesh that it approximates does so there.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`, with which this is faster
/// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` whose faces are triangles
/// \tparam OutputIterator takes faces of the T-mesh
/// \param surface \pre it is valid
/// \param mesh what the surface approximates
/// \param faces receives the faces of the T-mesh whose triangles intersect others where the mesh does not, each once
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///     \cgalParamExtra{Points of any kernel, rounded to doubles.}
///   \cgalParamNEnd
///   \cgalParamNBegin{tessellation_resolution}
///     \cgalParamDescription{as for `tessellate_T_spline()`, at least 2}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`default_tessellation_resolution`, 8}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{triangles of the surface that are not farther from triangles of the mesh that intersect are
///       where the mesh intersects; by the longest side of the bounding box of the mesh}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: n log^3 n for n triangles and few intersections.
template <typename Surface, typename TriangleMesh, typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_self_intersection_report
check_T_spline_self_intersections(const Surface& surface, const TriangleMesh& mesh, OutputIterator faces,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  const int resolution =
      choose_parameter(get_parameter(np, np_tags::tessellation_resolution), default_tessellation_resolution);
  const double tolerance = choose_parameter(get_parameter(np, np_tags::tolerance), 0.);
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("self-intersections");
  progress.go_on();
  const internal::Mesh_intersections of_mesh(mesh, point_map, progress);
  internal::Axis_parallel_box<double> box;
  for (const auto v : CGAL::make_range(vertices(mesh)))
    box.extend(internal::point_in_doubles(get(point_map, v)));
  progress.progress(0.5);
  const internal::Progress::Part part(progress, 0.5, 1);
  auto report = internal::find_new_self_intersections(
      surface, resolution, [&]() -> const internal::Mesh_intersections& { return of_mesh; }, tolerance* box.extent(),
      faces, progress);
  report.number_of_mesh_intersections = of_mesh.number_of_pairs();
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H
