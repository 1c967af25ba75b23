// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_MESH_H
#define CGAL_T_SPLINES_IO_WRITE_T_MESH_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/IO/internal/own_weights.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The first halfedge of the bottom side of a T-mesh face, the side of `halfedge(f)`: it begins at the origin of the
/// face's frame. On a face without corners it is `halfedge(f)`.
template <typename TMesh>
typename TMesh::halfedge_descriptor first_halfedge_of_bottom(const typename TMesh::face_descriptor f,
                                                             const TMesh& t_mesh)
{
  const auto& graph = t_mesh.graph();
  const auto start = halfedge(f, graph);
  auto h = start;
  do {
    if (t_mesh.is_corner(prev(h, graph)))
      return h;
    h = prev(h, graph);
  } while (h != start);
  return start;
}

/// A T-mesh as the file numbers it.
/// \tparam TMesh a `T_mesh_view`
template <typename TMesh>
class T_mesh_numbering {
  using Graph = typename TMesh::Graph;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using vertex_descriptor = typename TMesh::vertex_descriptor;

public:
  explicit T_mesh_numbering(const TMesh& t_mesh)
    : m_vertex_number(get(CGAL::dynamic_vertex_property_t<std::size_t>(), t_mesh.graph())),
      m_halfedge_number(get(CGAL::dynamic_halfedge_property_t<std::size_t>(), t_mesh.graph()))
  {
    std::size_t v = 0, h = 0;
    for (const vertex_descriptor vertex : CGAL::make_range(vertices(t_mesh.graph())))
      put(m_vertex_number, vertex, v++);
    for (const auto face : CGAL::make_range(faces(t_mesh.graph()))) {
      m_first_halfedges.push_back(first_halfedge_of_bottom(face, t_mesh));
      for (const halfedge_descriptor g : CGAL::halfedges_around_face(m_first_halfedges.back(), t_mesh.graph()))
        put(m_halfedge_number, g, h++);
    }
  }

  const std::vector<halfedge_descriptor>& first_halfedges() const { return m_first_halfedges; }
  std::size_t vertex_number(const vertex_descriptor v) const { return get(m_vertex_number, v); }
  std::size_t halfedge_number(const halfedge_descriptor h) const { return get(m_halfedge_number, h); }

private:
  typename boost::property_map<Graph, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type m_vertex_number;
  typename boost::property_map<Graph, CGAL::dynamic_halfedge_property_t<std::size_t>>::const_type m_halfedge_number;
  std::vector<halfedge_descriptor> m_first_halfedges;
};

/// Whether an edge is a crease, which those of the border are not. \tparam TMesh a `T_mesh_view`
template <typename TMesh>
bool is_crease_inside(const typename TMesh::halfedge_descriptor h, const TMesh& t_mesh)
{
  return t_mesh.is_crease(h) && !is_border(opposite(h, t_mesh.graph()), t_mesh.graph());
}

/// \param longest_list decides of what type the lengths of the lists are: some programs read only those of one byte
inline void format_t_mesh_header(Text_writer& writer, const std::size_t number_of_vertices,
                                 const std::size_t number_of_faces, const std::size_t longest_list,
                                 const bool has_creases)
{
  const std::string_view list = longest_list < 256 ? "\nproperty list uchar " : "\nproperty list int ";
  writer << "ply\nformat ascii 1.0\ncomment T-mesh with halfedge knots\nelement vertex " << number_of_vertices
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty double w\nelement face "
         << number_of_faces << list << "int vertex_indices" << list << "double halfedge_knots" << list << "uchar corner"
         << list << "int opposite";
  if (has_creases)
    writer << list << "uchar crease";
  writer << "\nend_header\n";
}

/// \param t_mesh a `T_mesh_view`
template <typename TMesh, typename VertexPointMap, typename VertexWeightMap>
void format_t_mesh(Text_writer& writer, const TMesh& t_mesh, const VertexPointMap vertex_point_map,
                   const VertexWeightMap vertex_weight_map)
{
  const auto& graph = t_mesh.graph();
  const T_mesh_numbering<TMesh> numbering(t_mesh);
  const auto vertex_range = vertices(graph);
  const auto length_of_lists = [&graph](const auto first) {
    const auto halfedges = CGAL::halfedges_around_face(first, graph);
    return static_cast<std::size_t>(std::distance(halfedges.begin(), halfedges.end()));
  };
  std::size_t longest_list = 0;
  bool has_creases = false;
  for (const auto first : numbering.first_halfedges()) {
    longest_list = (std::max)(longest_list, length_of_lists(first));
    for (const auto h : CGAL::halfedges_around_face(first, graph))
      has_creases = has_creases || is_crease_inside(h, t_mesh);
  }
  format_t_mesh_header(writer, static_cast<std::size_t>(std::distance(vertex_range.first, vertex_range.second)),
                       numbering.first_halfedges().size(), longest_list, has_creases);
  for (const auto v : CGAL::make_range(vertex_range)) {
    writer.write_coordinates(get(vertex_point_map, v)) << " " << CGAL::to_double(get(vertex_weight_map, v)) << "\n";
  }
  for (const auto first : numbering.first_halfedges()) {
    const auto halfedges = CGAL::halfedges_around_face(first, graph);
    const std::size_t n = length_of_lists(first);
    writer << n;
    for (const auto h : halfedges)
      writer << " " << numbering.vertex_number(source(h, graph));
    writer << " " << n;
    for (const auto h : halfedges)
      writer << " " << CGAL::to_double(t_mesh.knot(h));
    writer << " " << n;
    for (const auto h : halfedges)
      writer << (t_mesh.is_corner(prev(h, graph)) ? " 1" : " 0");
    writer << " " << n;
    for (const auto h : halfedges) {
      const auto g = opposite(h, graph);
      if (is_border(g, graph))
        writer << " -1";
      else
        writer << " " << numbering.halfedge_number(g);
    }
    if (has_creases) {
      writer << " " << n;
      for (const auto h : halfedges)
        writer << (is_crease_inside(h, t_mesh) ? " 1" : " 0");
    }
    writer << "\n";
  }
}

template <typename TMesh, typename NamedParameters>
void format_t_mesh(Text_writer& writer, const TMesh& t_mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  format_t_mesh(writer, Const_T_mesh_view_of<TMesh>(t_mesh),
                choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                 get_const_property_map(CGAL::vertex_point, t_mesh.graph())),
                choose_parameter(get_parameter(np, np_tags::vertex_weight_map), own_weights(t_mesh)));
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a T-mesh with halfedge knots ([CZ17] section 4) to a stream, as a PLY file made of text that
/// `read_t_mesh()` reads; programs that know polygons but no T-meshes read its faces as polygons.
///
/// The file has, per vertex in the order of the graph, the doubles `x y z w`: the control point (euclidean, not
/// multiplied by the weight) and its weight. Per face, in the order of the graph, it has four lists of equal length:
/// - `vertex_indices` (int): the vertices, counter-clockwise, T-joints included. The first one is the origin of the
///   face's frame: the corner where the side that contains `halfedge(f)` begins. A vertex may occur twice;
/// - `halfedge_knots` (double): entry i is the knot interval of the halfedge from vertex i to vertex i + 1, in the
///   units of this face;
/// - `corner` (uchar): entry i is 1 if the face turns by a right angle at vertex i, else 0; four entries are 1;
/// - `opposite` (int): entry i names the opposite of the halfedge from vertex i to vertex i + 1, by its number when
///   the halfedges are counted from 0 over all faces in order; -1 at the border.
///
/// If the T-mesh has creases, there is a fifth list, `crease` (uchar): entry i is 1 if the edge from vertex i to
/// vertex i + 1 is a crease, in the lists of both of its faces, else 0; on the border it is 0.
///
/// The lengths of the lists are of the type `uchar`, or `int` if a face has more than 255 vertices.
///
/// Every number is written in the shortest way that reads back as the same double, so a T-mesh in doubles comes back
/// bit by bit. Knots of another number type are rounded to doubles (`CGAL::to_double()`), each by itself: intervals
/// that are equal stay so, but sums that were equal need not, and the T-mesh that is read is admissible up to
/// round-off only.
///
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph` and `HalfedgeListGraph`, a `T_spline` for
///   instance
/// \param out receives the file
/// \param t_mesh the T-mesh
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the control points}
///     \cgalParamType{a model of `ReadablePropertyMap`, vertex of the T-mesh -> `%Point_3`}
///     \cgalParamDefault{the map of the graph for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_weight_map}
///     \cgalParamDescription{the weights of the control points}
///     \cgalParamType{a model of `ReadablePropertyMap`, vertex of the T-mesh -> positive number}
///     \cgalParamDefault{that of a `T_spline`, 1 for others}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_t_mesh(std::ostream& out, const TMesh& t_mesh,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Text_writer writer(out);
  internal::format_t_mesh(writer, t_mesh, np);
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a T-mesh with halfedge knots to a PLY file.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left
/// behind and a file that was there stays as it was. Everything else is as with a stream.
///
/// \param filename where to write; a file that is there is replaced
/// \param t_mesh, np see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_t_mesh(const std::string& filename, const TMesh& t_mesh,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(filename, [&](std::ostream& out) { write_t_mesh(out, t_mesh, np); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_MESH_H
