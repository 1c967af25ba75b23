// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CHECK_TRIANGLE_MESH_H
#define CGAL_T_SPLINES_CROSS_FIELD_CHECK_TRIANGLE_MESH_H

#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// What `check_triangle_mesh()` finds first.
enum class Triangle_mesh_status {
  VALID,               ///< everything that this package asks of a mesh holds
  EMPTY,               ///< the mesh has no face
  NOT_TRIANGULATED,    ///< `face` has not three edges
  NON_FINITE_POINT,    ///< a coordinate of `vertex` is infinite or not a number
  BORDER,              ///< `halfedge` has no face
  ISOLATED_VERTEX,     ///< `vertex` has no edge
  NON_MANIFOLD_VERTEX, ///< the faces at `vertex` form more than one fan, as where a border touches itself
  BORDER_OF_TWO_EDGES, ///< the border has a closed curve of two edges, `halfedge` and the next one, that coincide
  ZERO_LENGTH_EDGE,    ///< the two ends of `halfedge` coincide
  ZERO_AREA_FACE,      ///< the corners of `face` are collinear, exactly
  INTERRUPTED          ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Triangle_mesh_status status)
{
  switch (status) {
  case Triangle_mesh_status::VALID: return "the mesh is valid";
  case Triangle_mesh_status::EMPTY: return "the mesh has no face";
  case Triangle_mesh_status::NOT_TRIANGULATED: return "a face is not a triangle";
  case Triangle_mesh_status::NON_FINITE_POINT: return "a vertex has a coordinate that is infinite or not a number";
  case Triangle_mesh_status::BORDER: return "the mesh has a border";
  case Triangle_mesh_status::ISOLATED_VERTEX: return "a vertex has no edge";
  case Triangle_mesh_status::NON_MANIFOLD_VERTEX: return "the faces at a vertex form more than one fan";
  case Triangle_mesh_status::BORDER_OF_TWO_EDGES:
    return "a closed curve of the border has two edges only, which coincide";
  case Triangle_mesh_status::ZERO_LENGTH_EDGE: return "an edge has length zero";
  case Triangle_mesh_status::ZERO_AREA_FACE: return "a face has area zero";
  case Triangle_mesh_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// The result of `check_triangle_mesh()`: what is wrong, and where. Descriptors that `status` does not mention are null.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Triangle_mesh_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  Triangle_mesh_status status = Triangle_mesh_status::VALID;               ///< what is wrong
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();       ///< the vertex that `status` is about
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< the halfedge that `status` is about
  typename Traits::face_descriptor face = Traits::null_face();             ///< the face that `status` is about

  /// returns whether `status` tells of success.
  bool success() const { return status == Triangle_mesh_status::VALID; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says, which element has the defect, counted from 0, and what can be done about it. Complexity:
/// linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Triangle_mesh_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  using Status = Triangle_mesh_status;
  std::string text = message(report.status);
  switch (report.status) {
  case Status::VALID:
  case Status::INTERRUPTED: break;
  case Status::EMPTY: text += ": it needs at least one"; break;
  case Status::NOT_TRIANGULATED:
    text += ": " + internal::face_in_words(report.face, mesh) + ", counted from 0; triangulate the mesh first";
    break;
  case Status::NON_FINITE_POINT:
    text += ": " + internal::vertex_in_words(report.vertex, mesh) + ", counted from 0; correct it";
    break;
  case Status::BORDER:
    text += ": " + internal::edge_in_words(report.halfedge, mesh) + ", counted from 0; fill the holes first";
    break;
  case Status::ISOLATED_VERTEX:
    text += ": " + internal::vertex_in_words(report.vertex, mesh) + ", counted from 0; remove it";
    break;
  case Status::NON_MANIFOLD_VERTEX:
    text += ": " + internal::vertex_in_words(report.vertex, mesh) +
            ", counted from 0; make it one vertex for each fan " +
            "(CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices())";
    break;
  case Status::BORDER_OF_TWO_EDGES:
    text += ": " + internal::edge_in_words(report.halfedge, mesh) +
            ", counted from 0; make them one edge (CGAL::Polygon_mesh_processing::stitch_borders())";
    break;
  case Status::ZERO_LENGTH_EDGE:
    text += ": " + internal::edge_in_words(report.halfedge, mesh) + ", counted from 0; collapse it";
    break;
  case Status::ZERO_AREA_FACE:
    text += ": " + internal::face_in_words(report.face, mesh) +
            ", counted from 0; remove it by collapsing or flipping an edge of it";
    break;
  }
  return text;
}

namespace internal {

// Collinearity is decided exactly for points with floating-point coordinates, whatever their kernel, and by the
// kernel's own predicate otherwise.
template <typename GeomTraits, typename Point_3>
bool are_collinear(const GeomTraits& traits, const Point_3& p, const Point_3& q, const Point_3& r)
{
  if constexpr (std::is_floating_point_v<typename GeomTraits::FT>) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto convert = [](const Point_3& a) { return Kernel::Point_3(a.x(), a.y(), a.z()); };
    return Kernel().collinear_3_object()(convert(p), convert(q), convert(r));
  }
  else
    return traits.collinear_3_object()(p, q, r);
}

// The halfedges that are reached from one by going around its target.
template <typename TriangleMesh>
int size_of_fan(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& mesh)
{
  const auto fan = CGAL::halfedges_around_target(v, mesh);
  return static_cast<int>(std::distance(fan.begin(), fan.end()));
}

template <typename TriangleMesh>
Triangle_mesh_report<TriangleMesh> check_mesh_connectivity(const TriangleMesh& mesh, const bool is_border_allowed,
                                                           Progress& progress)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Vertex_counts = typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type;
  Triangle_mesh_report<TriangleMesh> report;
  const auto fail = [&report](const Triangle_mesh_status status) {
    report.status = status;
    return report;
  };
  if (faces(mesh).begin() == faces(mesh).end())
    return fail(Triangle_mesh_status::EMPTY);
  for (const typename Traits::face_descriptor f : faces(mesh)) {
    if (!progress.go_on_after(1))
      return fail(Triangle_mesh_status::INTERRUPTED);
    if (!CGAL::is_triangle(halfedge(f, mesh), mesh)) {
      report.face = f;
      return fail(Triangle_mesh_status::NOT_TRIANGULATED);
    }
  }
  const Vertex_counts degree = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const Vertex_counts border_degree = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) {
    put(degree, v, 0);
    put(border_degree, v, 0);
  }
  for (const typename Traits::halfedge_descriptor h : halfedges(mesh)) {
    if (!progress.go_on_after(1))
      return fail(Triangle_mesh_status::INTERRUPTED);
    const typename Traits::vertex_descriptor v = target(h, mesh);
    put(degree, v, get(degree, v) + 1);
    if (!is_border(h, mesh))
      continue;
    put(border_degree, v, get(border_degree, v) + 1);
    if (!is_border_allowed) {
      report.halfedge = h;
      return fail(Triangle_mesh_status::BORDER);
    }
    if (next(next(h, mesh), mesh) == h) {
      report.halfedge = h;
      return fail(Triangle_mesh_status::BORDER_OF_TWO_EDGES);
    }
  }
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) {
    if (!progress.go_on_after(2))
      return fail(Triangle_mesh_status::INTERRUPTED);
    const int degree_of_fan = get(degree, v) > 0 ? size_of_fan<TriangleMesh>(v, mesh) : 0;
    if (degree_of_fan == get(degree, v) && degree_of_fan > 0 && get(border_degree, v) <= 1)
      continue;
    report.vertex = v;
    return fail(degree_of_fan == 0 ? Triangle_mesh_status::ISOLATED_VERTEX : Triangle_mesh_status::NON_MANIFOLD_VERTEX);
  }
  return report;
}

template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits>
Triangle_mesh_report<TriangleMesh> check_mesh_geometry(const TriangleMesh& mesh, const VertexPointMap& points,
                                                       const GeomTraits& traits, Progress& progress)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  Triangle_mesh_report<TriangleMesh> report;
  const auto fail = [&report](const Triangle_mesh_status status) {
    report.status = status;
    return report;
  };
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) {
    if (!progress.go_on_after(1))
      return fail(Triangle_mesh_status::INTERRUPTED);
    const auto& p = get(points, v);
    if (!std::isfinite(CGAL::to_double(p.x())) || !std::isfinite(CGAL::to_double(p.y())) ||
        !std::isfinite(CGAL::to_double(p.z()))) {
      report.vertex = v;
      return fail(Triangle_mesh_status::NON_FINITE_POINT);
    }
  }
  for (const typename Traits::edge_descriptor e : edges(mesh)) {
    if (!progress.go_on_after(1))
      return fail(Triangle_mesh_status::INTERRUPTED);
    if (get(points, source(e, mesh)) == get(points, target(e, mesh))) {
      report.halfedge = halfedge(e, mesh);
      return fail(Triangle_mesh_status::ZERO_LENGTH_EDGE);
    }
  }
  for (const typename Traits::face_descriptor f : faces(mesh)) {
    if (!progress.go_on_after(4))
      return fail(Triangle_mesh_status::INTERRUPTED);
    const typename Traits::halfedge_descriptor h = halfedge(f, mesh);
    if (are_collinear(traits, get(points, source(h, mesh)), get(points, target(h, mesh)),
                      get(points, target(next(h, mesh), mesh)))) {
      report.face = f;
      return fail(Triangle_mesh_status::ZERO_AREA_FACE);
    }
  }
  return report;
}

// What `check_triangle_mesh()` does; no stage is begun.
template <typename TriangleMesh, typename NamedParameters>
Triangle_mesh_report<TriangleMesh> triangle_mesh_report(const TriangleMesh& mesh, const NamedParameters& np,
                                                        Progress& progress)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using GeomTraits = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const auto traits = choose_parameter<GeomTraits>(get_parameter(np, CGAL::internal_np::geom_traits));
  const bool is_border_allowed = choose_parameter(get_parameter(np, np_tags::border_is_allowed), true);
  Triangle_mesh_report<TriangleMesh> report;
  if (!progress.go_on())
    report.status = Triangle_mesh_status::INTERRUPTED;
  else
    report = check_mesh_connectivity(mesh, is_border_allowed, progress);
  return report.success() ? check_mesh_geometry(mesh, points, traits, progress) : report;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// checks whether a mesh is what this package computes on: a triangle mesh whose vertices are manifold and whose
/// edges and faces are not degenerate. A border and several connected components are allowed.
///
/// The tests of the geometry are exact: they neither depend on the size of the mesh nor on its distance from the
/// origin. Connectivity is judged first.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a geometric traits class}
///     \cgalParamType{a model of `Kernel`}
///     \cgalParamDefault{the kernel of the points, a new object}
///   \cgalParamNEnd
///   \cgalParamNBegin{border_is_allowed}
///     \cgalParamDescription{whether a mesh with border is valid}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the first defect found, and the element that has it.
///
/// Complexity: linear.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Triangle_mesh_report<TriangleMesh> check_triangle_mesh(const TriangleMesh& mesh,
                                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("mesh check");
  return internal::triangle_mesh_report(mesh, np, progress);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_CHECK_TRIANGLE_MESH_H
