// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_SAMPLE_T_MESH_H
#define CGAL_T_SPLINES_TRACING_SAMPLE_T_MESH_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Face_triangles.h>
#include <CGAL/T_splines/Tracing/internal/Triangle_samples.h>
#include <CGAL/T_splines/internal/Closest_rectangle.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/internal/mesh_components.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The samples of the triangles of a mesh.
template <typename FT, typename Graph>
class T_mesh_sampling {
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  using Face_index_map = typename boost::property_map<Graph, CGAL::dynamic_face_property_t<int>>::const_type;
  using Point = std::array<double, 3>;

public:
  /// \param points of the vertices of the map's mesh
  T_mesh_sampling(const Seamless_layout<FT>& layout, const std::vector<Point>& points, const Graph& graph)
    : m_mesh(layout.mesh()),
      m_points(points),
      m_face_index(get(CGAL::dynamic_face_property_t<int>(), graph)),
      m_triangles(layout)
  {
  }

  /// Places the T-mesh. \param progress if it is interrupted, no samples may be taken
  template <typename TriangleMesh, typename Coordinates, typename FaceAnchorMap>
  void place_faces(const Mesh_indexing<TriangleMesh>& indexing, const Coordinates& coordinates,
                   const FaceAnchorMap anchors, Progress& progress)
  {
    for (const Face f : CGAL::make_range(faces(coordinates.t_mesh().graph()))) {
      put(m_face_index, f, static_cast<int>(m_faces.size()));
      m_faces.push_back(f);
      m_sizes.push_back({{CGAL::to_double(coordinates.width(f)), CGAL::to_double(coordinates.height(f))}});
      const auto& anchor = get(anchors, f);
      m_triangles.add_face(indexing.face_index(anchor.triangle), anchor.to_face, m_sizes.back()[0], m_sizes.back()[1],
                           progress);
      if (progress.is_interrupted())
        return;
    }
    m_triangles.complete();
  }

  /// Chooses the points inside of the triangles; vertices get their weights.
  /// \param progress if it is interrupted, points and weights are missing
  template <typename Sample>
  void sample_triangles(const std::size_t number_of_samples, std::vector<Sample>& inner, Progress& progress)
  {
    const Mesh_components components = mesh_components(m_mesh);
    std::vector<Triangle_samples> chosen = samples_of_components(components, static_cast<double>(number_of_samples));
    m_weights.assign(m_points.size(), 0);
    for (int t = 0; t < m_mesh.number_of_faces(); ++t) {
      const double area_of_triangle = area(t);
      const auto& points = chosen[components.of_face[t]].points(squared_lengths(t), area_of_triangle);
      if (!progress.go_on_after(4 + 5 * points.size()))
        return;
      const double weight = area_of_triangle / static_cast<double>(3 + points.size());
      for (const int v : corners(t))
        m_weights[v] += weight;
      for (const auto& barycentric : points)
        inner.push_back(sample<Sample>(t, barycentric, weight));
    }
  }

  double weight_of_vertex(const int v) const { return m_weights[v]; }

  /// A place in the closed rectangle of its face, in numbers of another type.
  template <typename NT, typename Place>
  T_mesh_place<Graph, NT> converted_place(const Place& place) const
  {
    const std::array<double, 2>& size = m_sizes[get(m_face_index, place.face)];
    T_mesh_place<Graph, NT> result{place.face, converted_number<NT>(place.u), converted_number<NT>(place.v)};
    clamp_to_rectangle(result.u, result.v, NT(size[0]), NT(size[1]));
    return result;
  }

private:
  /// The components share half of the samples equally, if they do not have as many by their area.
  std::vector<Triangle_samples> samples_of_components(const Mesh_components& components, const double number) const
  {
    std::vector<double> areas(components.size(), 0);
    for (int t = 0; t < m_mesh.number_of_faces(); ++t)
      areas[components.of_face[t]] += area(t);
    const double total = std::accumulate(areas.begin(), areas.end(), 0.);
    const double least = number / (2 * static_cast<double>(components.size()));
    std::vector<Triangle_samples> result;
    for (const double area : areas)
      result.emplace_back(std::sqrt((std::min)(total / number, area / least)));
    return result;
  }

  std::array<int, 3> corners(const int t) const
  {
    const int h = m_mesh.halfedge_of_face(t), g = m_mesh.next(h);
    return {{m_mesh.target(h), m_mesh.target(g), m_mesh.target(m_mesh.next(g))}};
  }

  Point vector(const int v, const int w) const
  {
    const Point &p = m_points[v], &q = m_points[w];
    return {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}};
  }

  double area(const int t) const
  {
    const std::array<int, 3> c = corners(t);
    const Point a = vector(c[0], c[1]), b = vector(c[0], c[2]);
    return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
  }

  std::array<double, 3> squared_lengths(const int t) const
  {
    const std::array<int, 3> c = corners(t);
    std::array<double, 3> result;
    for (int i = 0; i < 3; ++i) {
      const Point a = vector(c[(i + 1) % 3], c[(i + 2) % 3]);
      result[i] = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    }
    return result;
  }

  template <typename Sample>
  Sample sample(const int t, const std::array<double, 3>& barycentric, const double weight) const
  {
    using NT = typename Sample::FT;
    const std::array<int, 3> c = corners(t);
    Point p = {{0, 0, 0}};
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += barycentric[i] * m_points[c[i]][axis];
    const auto place = m_triangles.place(t, barycentric);
    CGAL_assertion(place.face >= 0);
    return {{m_faces[place.face], NT(place.u), NT(place.v)},
            typename Sample::Point_3(NT(p[0]), NT(p[1]), NT(p[2])),
            NT(weight)};
  }

  const Triangulation_connectivity& m_mesh;
  const std::vector<Point>& m_points;
  Face_index_map m_face_index;
  std::vector<Face> m_faces;
  std::vector<std::array<double, 2>> m_sizes; // of the faces
  Face_triangles<FT> m_triangles;
  std::vector<double> m_weights; // of the vertices
};

} // namespace internal

/// \ingroup PkgTSplinesTracing
/// finds points all over a surface, with their places in the motorcycle graph that was traced on it, and with weights:
/// what splines are fitted to.
///
/// First come the vertices of the mesh, in their order. Then come points inside of those triangles that are large:
/// where these are compact, neighboring points are about the square root of area / `number_of_samples` apart. They are
/// denser on components that would have less than `number_of_samples` / (2 * number of components) otherwise. Each
/// triangle shares its area equally among its corners and the points inside of it; so the weights add up to the area of
/// the surface. Each place is in the closed rectangle of its face. The same input gives the same samples.
///
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph`
/// \tparam FaceAnchorMap a readable map, face of the T-mesh -> `T_mesh_anchor<TriangleMesh, FT>`
/// \tparam VertexPlaceMap a readable map, vertex of the mapped mesh -> `T_mesh_place<Graph, NT>`
/// \tparam OutputIterator takes `T_mesh_sample_of<Graph, Point_3>`, with the type of the points of the mapped mesh: the samples
///         are in floating point numbers, whatever the mesh and the map are in
/// \param map the map on which the T-mesh was traced
/// \param t_mesh, anchors, vertex_places what `trace_motorcycle_graph()` made of it
/// \param out where the samples are written to
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of the mapped mesh}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of the mapped mesh for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_samples}
///     \cgalParamDescription{about how many samples a surface with few vertices gets}
///     \cgalParamType{a positive `std::size_t`}
///     \cgalParamDefault{20000, or the number of vertices if that is larger}
///     \cgalParamExtra{There are at most as many more as there are vertices, up to rounding, and half as many again if
///       there are several components.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `out` after the last sample. If the visitor stopped the work, there are no samples.
/// \pre neither the T-mesh nor its anchors have changed since it was traced
///
/// Complexity: linear in the size of the meshes, and, summed over all triangles, in the number of times that faces
/// meet the triangle, times the number of its points; quadratic in how often one face meets one triangle.
template <typename TriangleMesh, typename FT, typename TMesh, typename FaceAnchorMap, typename VertexPlaceMap,
          typename OutputIterator, typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator sample_T_mesh(const Seamless_map<TriangleMesh, FT>& map, const TMesh& t_mesh,
                             const FaceAnchorMap anchors, const VertexPlaceMap vertex_places, OutputIterator out,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, map.mesh()));
  using Point_3 = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  using Sample = T_mesh_sample_of<T_mesh_graph<TMesh>, Point_3>;
  using NT = typename Sample::FT;
  const auto& indexing = map.indexing();
  const std::size_t number_of_samples =
      choose_parameter(get_parameter(np, np_tags::number_of_samples),
                       (std::max)(std::size_t(20000), static_cast<std::size_t>(indexing.number_of_vertices())));
  CGAL_precondition_msg(number_of_samples > 0, "number_of_samples must be positive");
  const auto mapped_vertices = CGAL::make_range(vertices(map.mesh()));
  const auto face_of = [&](const auto v) { return get(vertex_places, v).face; };
  if (!internal::are_anchored(map, t_mesh.graph(), anchors) ||
      internal::first_foreign_face(t_mesh.graph(), mapped_vertices, face_of) <
          static_cast<std::size_t>(std::distance(mapped_vertices.begin(), mapped_vertices.end())))
    return out;
  const std::vector<std::array<double, 3>> points = internal::points_in_doubles(indexing, point_map);
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("sampling");
  internal::T_mesh_sampling<FT, T_mesh_graph<TMesh>> sampling(map.layout(), points, t_mesh.graph());
  sampling.place_faces(indexing, T_mesh_coordinates(t_mesh), anchors, progress);
  progress.progress(0.7);
  if (!progress.go_on())
    return out;
  std::vector<Sample> inner;
  sampling.sample_triangles(number_of_samples, inner, progress);
  progress.progress(0.9);
  if (!progress.go_on())
    return out;
  for (int v = 0; v < indexing.number_of_vertices(); ++v) {
    const auto vertex = indexing.vertex(v);
    const std::array<double, 3>& p = points[v];
    *out++ = Sample{sampling.template converted_place<NT>(get(vertex_places, vertex)),
                    typename Sample::Point_3(NT(p[0]), NT(p[1]), NT(p[2])), NT(sampling.weight_of_vertex(v))};
  }
  return std::copy(inner.begin(), inner.end(), out);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_SAMPLE_T_MESH_H
