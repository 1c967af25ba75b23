// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H

#include <CGAL/T_splines/Spline/T_spline_tessellation.h>
#include <CGAL/T_splines/Spline/Tessellation_resolution.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Face_tessellation.h>
#include <CGAL/T_splines/Spline/internal/T_mesh_divisions.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// Asks for twice as many parts where a triangle is turned away from the surface, on its side of creases, at all of its
/// corners. This happens where lines curve within the surface, so that the sides of long and narrow triangles do not follow
/// them closely enough.
/// \return whether there is such a place
template <typename CompiledTSpline>
bool refine_at_turned_triangles(const CompiledTSpline& surface,
                                const Face_tessellation<typename CompiledTSpline::FT>& faces,
                                std::vector<Division_rectangle>& rectangles)
{
  constexpr double smallest_cosine = 0.7; // about 45 degrees: where triangles are small, only those turn so far
  auto places = faces.places();
  places.insert(places.end(), faces.crease_places().begin(), faces.crease_places().end());
  std::vector<typename CompiledTSpline::Jet> jets;
  jets.reserve(places.size());
  for (const auto& place : places)
    jets.push_back(surface.jet(surface.indexing().face(place.face), place.u, place.v));
  const auto is_turned = [](const auto& of_triangle, const auto& of_surface) {
    const double cosine = CGAL::to_double(of_triangle * of_surface); // times a positive number
    return cosine < 0 ||
           cosine * cosine < smallest_cosine * smallest_cosine *
                                 CGAL::to_double(of_triangle.squared_length() * of_surface.squared_length());
  };
  std::vector<std::array<bool, 2>> is_refined(surface.indexing().number_of_faces(), {false, false});
  bool result = false;
  const auto triangles = split_at_creases(faces.triangles(), faces.crease_corners(), faces.places().size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<std::size_t, 3>& t = triangles[i];
    const auto a = jets[t[1]].position - jets[t[0]].position, b = jets[t[2]].position - jets[t[0]].position;
    const auto normal = CGAL::cross_product(a, b);
    if (!std::all_of(t.begin(), t.end(), [&](const std::size_t c) { return is_turned(normal, jets[c].normal()); }))
      continue;
    result = true;
    const auto longer = a.squared_length() < b.squared_length() ? b : a;
    for (const std::size_t c : t)
      if (places[c].face == faces.faces()[i]) { // others are in another frame
        const auto u = longer * jets[c].du, v = longer * jets[c].dv;
        const bool is_along_u = u * u * jets[c].dv.squared_length() > v * v * jets[c].du.squared_length();
        is_refined[faces.faces()[i]][is_along_u ? 0 : 1] = true;
      }
  }
  for (Division_rectangle& rectangle : rectangles)
    for (int k = 0; k < 2; ++k)
      rectangle.density[k] *= is_refined[rectangle.face][k] ? 2 : 1;
  return result;
}

/// Triangulates the faces of a surface's T-mesh by a resolution.
/// \param progress if it is interrupted, triangles are missing
template <typename Surface>
Face_tessellation<typename Surface::FT> tessellate_faces(const Surface& surface,
                                                         const Tessellation_resolution& resolution, Progress& progress)
{
  using Tessellation = Face_tessellation<typename Surface::FT>;
  const auto& t_mesh = surface.t_mesh_arrays();
  if (!resolution.is_adaptive()) {
    const int least = Tessellation::has_tip(t_mesh) ? 3 : 2;
    return Tessellation(t_mesh, even_divisions(t_mesh, (std::max)(resolution.number_of_parts(), least)), progress);
  }
  constexpr int most_rounds = 4;
  const auto& compiled = as_compiled(surface, progress);
  std::vector<Division_rectangle> rectangles = division_rectangles(compiled, resolution.distance());
  for (int round = 1;; ++round) {
    Tessellation result(t_mesh,
                        adaptive_divisions(t_mesh, rectangles, Tessellation_resolution::least_parts,
                                           Tessellation_resolution::most_parts),
                        progress);
    if (round == most_rounds || !progress.go_on() || !refine_at_turned_triangles(compiled, result, rectangles))
      return result;
  }
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// triangulates the parameter domain of a T-spline surface without cracks: triangles on both sides of an edge share its
/// points, T-joints included. At creases it tells the places on either side, too.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \param surface \pre it is valid
/// \param resolution how finely: an `int` n >= 2, or `Tessellation_resolution::within()` a distance
/// \param np optional named parameters: `CGAL::parameters::visitor`: a model of `ProgressVisitor`. If it stops the work, the
///        result is empty
/// \return places and triangles; evaluate the surface there: `surface.positions(tessellation.places, ...)`.
///
/// Complexity: linear in the size of the result.
template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_tessellation<typename Surface::Graph, typename Surface::FT>
tessellate_parameter_domain(const Surface& surface, const Tessellation_resolution& resolution,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("tessellation");
  T_spline_tessellation<typename Surface::Graph, typename Surface::FT> result;
  if (!progress.go_on())
    return result;
  const auto faces = internal::tessellate_faces(surface, resolution, progress);
  progress.progress(0.7);
  if (!progress.go_on())
    return result;
  const auto places_of = [&](const auto& places) {
    std::vector<T_mesh_place<typename Surface::Graph, typename Surface::FT>> of_graph;
    of_graph.reserve(places.size());
    for (const auto& place : places)
      of_graph.push_back({surface.indexing().face(place.face), place.u, place.v});
    return of_graph;
  };
  result.places = places_of(faces.places());
  result.crease_places = places_of(faces.crease_places());
  for (const auto& c : faces.crease_corners())
    result.crease_corners.push_back({c.triangle, c.corner, c.place});
  result.triangles = faces.triangles();
  result.faces.reserve(faces.faces().size());
  for (const int f : faces.faces())
    result.faces.push_back(surface.indexing().face(f));
  return result;
}

/// \ingroup PkgTSplinesSpline
/// How `tessellate_T_spline()` ended.
enum class T_spline_tessellation_status {
  TESSELLATED,      ///< the mesh has the triangles
  OUTPUT_NOT_EMPTY, ///< the mesh that is to receive them is not empty; it is left as it is
  INTERRUPTED       ///< the visitor asked to stop; the mesh is empty
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_tessellation_status status)
{
  switch (status) {
  case T_spline_tessellation_status::TESSELLATED: return "the surface was tessellated";
  case T_spline_tessellation_status::OUTPUT_NOT_EMPTY: return "the mesh that is to receive the triangles is not empty";
  case T_spline_tessellation_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// What `tessellate_T_spline()` did.
struct T_spline_tessellation_report {
  T_spline_tessellation_status status = T_spline_tessellation_status::TESSELLATED; ///< how it ended

  /// returns whether `status` tells of success.
  bool success() const { return status == T_spline_tessellation_status::TESSELLATED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, and what can be done about it.
inline std::string describe(const T_spline_tessellation_report& report)
{
  const std::string text = message(report.status);
  return report.status == T_spline_tessellation_status::OUTPUT_NOT_EMPTY ? text + "; give a new one" : text;
}

namespace internal {

/// Takes all elements out of a graph. Its property maps stay.
template <typename Graph>
void remove_all_elements(Graph& graph)
{
  const auto all_faces = faces(graph);
  const auto all_edges = edges(graph);
  const auto all_vertices = vertices(graph);
  using Traits = boost::graph_traits<Graph>;
  for (const auto f : std::vector<typename Traits::face_descriptor>(all_faces.begin(), all_faces.end()))
    remove_face(f, graph);
  for (const auto e : std::vector<typename Traits::edge_descriptor>(all_edges.begin(), all_edges.end()))
    remove_edge(e, graph);
  for (const auto v : std::vector<typename Traits::vertex_descriptor>(all_vertices.begin(), all_vertices.end()))
    remove_vertex(v, graph);
}

/// Gives each corner of the triangles the unit normal of the surface in the triangle's own face.
/// \param vertices of `mesh`, by the numbers of places
/// \return false if `progress` is interrupted
template <typename Surface, typename Tessellation, typename TriangleMesh, typename HalfedgeNormalMap>
bool put_normals_of_corners(const Surface& surface, const Tessellation& tessellation, const TriangleMesh& mesh,
                            const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
                            const HalfedgeNormalMap normal_map, Progress& progress)
{
  constexpr std::size_t work = 10; // for a normal
  std::vector<typename Surface::Vector_3> normals;
  normals.reserve(tessellation.places.size() + tessellation.crease_places.size());
  for (const auto* const places : {&tessellation.places, &tessellation.crease_places})
    for (const auto& place : *places) {
      normals.push_back(surface.unit_normal(place.face, place.u, place.v));
      if (!progress.go_on_after(work))
        return false;
    }
  const auto corners = tessellation.triangles_split_at_creases();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::array<std::size_t, 3>& t = tessellation.triangles[i];
    auto h = halfedge(vertices[t[2]], vertices[t[0]], mesh).first;
    for (const std::size_t corner : corners[i]) {
      put(normal_map, h, normals[corner]);
      h = next(h, mesh);
    }
  }
  return true;
}

/// What `tessellate_T_spline()` does with the parameter domain tessellated. Vertices and faces are added in the order of
/// the places and the triangles.
/// \return false if `progress` is interrupted; then the mesh is empty again
template <typename Surface, typename TriangleMesh, typename NamedParameters>
bool add_tessellation(const Surface& surface,
                      const T_spline_tessellation<typename Surface::Graph, typename Surface::FT>& tessellation,
                      TriangleMesh& mesh, const NamedParameters& np, Progress& progress)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map =
      choose_parameter(get_parameter(np, np_tags::output_vertex_point_map), get_property_map(CGAL::vertex_point, mesh));
  const auto normal_map = get_parameter(np, CGAL::internal_np::vertex_normal_map);
  const auto corner_normal_map = get_parameter(np, np_tags::halfedge_normal_map);
  const auto place_map = get_parameter(np, np_tags::vertex_place_map);
  using Point_3 = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;

  constexpr std::size_t work = 10; // for a vertex or face
  const auto& places = tessellation.places;
  std::vector<Point_3> points;
  points.reserve(places.size());
  for (const auto& place : places) {
    const auto p = surface.position(place.face, place.u, place.v);
    points.emplace_back(p.x(), p.y(), p.z());
    if (!progress.go_on_after(work))
      return false;
  }
  progress.progress(0.5);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  vertices.reserve(places.size());
  using Size = typename boost::graph_traits<TriangleMesh>::faces_size_type;
  reserve(mesh, static_cast<Size>(places.size()), static_cast<Size>(places.size() + tessellation.triangles.size()),
          static_cast<Size>(tessellation.triangles.size()));
  for (std::size_t i = 0; i < places.size() && progress.go_on_after(work); ++i) {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), points[i]);
    if constexpr (!is_missing<decltype(normal_map)>)
      put(normal_map, vertices.back(), surface.unit_normal(places[i].face, places[i].u, places[i].v));
    if constexpr (!is_missing<decltype(place_map)>)
      put(place_map, vertices.back(), places[i]);
  }
  for (const std::array<std::size_t, 3>& t : tessellation.triangles) {
    if (!progress.go_on_after(work)) {
      internal::remove_all_elements(mesh);
      return false;
    }
    CGAL::Euler::add_face(std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 3>{vertices[t[0]],
                                                                                                       vertices[t[1]],
                                                                                                       vertices[t[2]]},
                          mesh);
  }
  if constexpr (!is_missing<decltype(corner_normal_map)>)
    if (!put_normals_of_corners(surface, tessellation, mesh, vertices, corner_normal_map, progress)) {
      internal::remove_all_elements(mesh);
      return false;
    }
  progress.progress(1);
  return true;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// tessellates a T-spline surface into a triangle mesh without cracks, as `tessellate_parameter_domain()` divides it.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \param surface \pre it is valid
/// \param resolution how finely: an `int` n >= 2, or `Tessellation_resolution::within()` a distance
/// \param mesh receives the triangles; it must be empty, without removed elements, too
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the points of `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_normal_map}
///     \cgalParamDescription{receives the unit normals of the surface; at creases, which have one on each side, that of one
///       of the sides}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Vector_3`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_normal_map}
///     \cgalParamDescription{receives the unit normals of the surface at the corners of the triangles: of a halfedge, at its
///       target, on the side of creases where its triangle is; nothing for halfedges of the border}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       `%Vector_3`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_place_map}
///     \cgalParamDescription{receives where the vertices lie on the surface}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `T_mesh_place<Graph, FT>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended
/// Complexity: linear in the size of the result, for a `T_spline_surface` times the number of basis functions of a
/// face.
template <typename Surface, typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_tessellation_report tessellate_T_spline(const Surface& surface, const Tessellation_resolution& resolution,
                                                 TriangleMesh& mesh,
                                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  T_spline_tessellation_report report;
  if (!internal::is_output_graph(mesh)) {
    report.status = T_spline_tessellation_status::OUTPUT_NOT_EMPTY;
    return report;
  }
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("tessellation");
  const auto domain = [&] {
    const internal::Progress::Part part(progress, 0, 0.3);
    return tessellate_parameter_domain(surface, resolution,
                                       CGAL::parameters::visitor(internal::Part_visitor(progress)));
  }();
  const internal::Progress::Part part(progress, 0.3, 1);
  if (!progress.go_on() || !internal::add_tessellation(surface, domain, mesh, np, progress))
    report.status = T_spline_tessellation_status::INTERRUPTED;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H
