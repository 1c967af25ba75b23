// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_MESH_H
#define CGAL_T_SPLINES_IO_WRITE_T_MESH_H

#include <CGAL/T_splines/IO/internal/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ios>
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
template <typename FaceGraph, typename HalfedgeCornerMap>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor
first_halfedge_of_bottom(const typename boost::graph_traits<FaceGraph>::face_descriptor f, const FaceGraph& t_mesh,
                         const HalfedgeCornerMap corners)
{
  const auto start = halfedge(f, t_mesh);
  auto h = start;
  do {
    if (get(corners, prev(h, t_mesh)))
      return h;
    h = prev(h, t_mesh);
  } while (h != start);
  return start;
}

/// A T-mesh as the file numbers it.
template <typename FaceGraph>
class T_mesh_numbering {
  using Traits = boost::graph_traits<FaceGraph>;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using vertex_descriptor = typename Traits::vertex_descriptor;

public:
  template <typename HalfedgeCornerMap>
  T_mesh_numbering(const FaceGraph& t_mesh, const HalfedgeCornerMap corners)
    : m_vertex_number(get(CGAL::dynamic_vertex_property_t<std::size_t>(), t_mesh)),
      m_halfedge_number(get(CGAL::dynamic_halfedge_property_t<std::size_t>(), t_mesh))
  {
    std::size_t v = 0, h = 0;
    for (const vertex_descriptor vertex : CGAL::make_range(vertices(t_mesh)))
      put(m_vertex_number, vertex, v++);
    for (const auto face : CGAL::make_range(faces(t_mesh))) {
      m_first_halfedges.push_back(first_halfedge_of_bottom(face, t_mesh, corners));
      for (const halfedge_descriptor g : CGAL::halfedges_around_face(m_first_halfedges.back(), t_mesh))
        put(m_halfedge_number, g, h++);
    }
  }

  const std::vector<halfedge_descriptor>& first_halfedges() const { return m_first_halfedges; }
  std::size_t vertex_number(const vertex_descriptor v) const { return get(m_vertex_number, v); }
  std::size_t halfedge_number(const halfedge_descriptor h) const { return get(m_halfedge_number, h); }

private:
  typename boost::property_map<FaceGraph, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type m_vertex_number;
  typename boost::property_map<FaceGraph, CGAL::dynamic_halfedge_property_t<std::size_t>>::const_type m_halfedge_number;
  std::vector<halfedge_descriptor> m_first_halfedges;
};

template <typename Writer>
void format_t_mesh_header(Writer& writer, const std::size_t number_of_vertices, const std::size_t number_of_faces)
{
  writer << "ply\nformat ascii 1.0\ncomment T-mesh with halfedge knots\nelement vertex " << number_of_vertices
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty double w\nelement face "
         << number_of_faces
         << "\nproperty list int int vertex_indices\nproperty list int double halfedge_knots\n"
            "property list int uchar corner\nproperty list int int opposite\nend_header\n";
}

/// Hands the text of the file to `sink`, a function object that takes a `std::string_view`, piece by piece.
template <typename Sink, typename FaceGraph, typename HalfedgeKnotMap, typename HalfedgeCornerMap,
          typename VertexPointMap, typename VertexWeightMap>
void format_t_mesh(Sink& sink, const FaceGraph& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                   const VertexPointMap vertex_point_map, const VertexWeightMap vertex_weight_map)
{
  const T_mesh_numbering<FaceGraph> numbering(t_mesh, corners);
  Text_writer<Sink> writer(sink);
  const auto vertex_range = vertices(t_mesh);
  format_t_mesh_header(writer, static_cast<std::size_t>(std::distance(vertex_range.first, vertex_range.second)),
                       numbering.first_halfedges().size());
  for (const auto v : CGAL::make_range(vertex_range)) {
    const auto& p = get(vertex_point_map, v);
    writer << CGAL::to_double(p.x()) << " " << CGAL::to_double(p.y()) << " " << CGAL::to_double(p.z()) << " "
           << CGAL::to_double(get(vertex_weight_map, v)) << "\n";
  }
  for (const auto first : numbering.first_halfedges()) {
    const auto halfedges = CGAL::halfedges_around_face(first, t_mesh);
    const std::size_t n = static_cast<std::size_t>(std::distance(halfedges.begin(), halfedges.end()));
    writer << n;
    for (const auto h : halfedges)
      writer << " " << numbering.vertex_number(source(h, t_mesh));
    writer << " " << n;
    for (const auto h : halfedges)
      writer << " " << CGAL::to_double(get(knots, h));
    writer << " " << n;
    for (const auto h : halfedges)
      writer << (get(corners, prev(h, t_mesh)) ? " 1" : " 0");
    writer << " " << n;
    for (const auto h : halfedges) {
      const auto g = opposite(h, t_mesh);
      if (is_border(g, t_mesh))
        writer << " -1";
      else
        writer << " " << numbering.halfedge_number(g);
    }
    writer << "\n";
  }
}

template <typename Sink, typename FaceGraph, typename HalfedgeKnotMap, typename HalfedgeCornerMap,
          typename NamedParameters>
void format_t_mesh(Sink& sink, const FaceGraph& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                   const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  format_t_mesh(sink, t_mesh, knots, corners,
                choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                 get_const_property_map(CGAL::vertex_point, t_mesh)),
                choose_parameter(get_parameter(np, np_tags::vertex_weight_map),
                                 CGAL::Constant_property_map<vertex_descriptor, double>(1.)));
}

} // namespace internal

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
/// Every number is written in the shortest way that reads back as the same double, so a T-mesh in doubles comes back
/// bit by bit. Knots of another number type are rounded to doubles (`CGAL::to_double()`), each by itself: intervals
/// that are equal stay so, but sums that were equal need not, and the T-mesh that is read is admissible up to
/// round-off only.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam HalfedgeKnotMap a model of `ReadablePropertyMap`, halfedge -> positive finite number: its interval on its
///   own face
/// \tparam HalfedgeCornerMap a model of `ReadablePropertyMap`, halfedge -> bool: its face turns at its *target*
/// \param out receives the file
/// \param t_mesh, knots, corners the T-mesh; neither map is read on border halfedges
/// \param np optional: `vertex_point_map`: the control points; `vertex_weight_map` (vertex -> positive number): their
///   weights, 1 by default
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear.
template <typename FaceGraph, typename HalfedgeKnotMap, typename HalfedgeCornerMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_t_mesh(std::ostream& out, const FaceGraph& t_mesh, const HalfedgeKnotMap knots,
                             const HalfedgeCornerMap corners,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto sink = [&out](const std::string_view text) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  };
  internal::format_t_mesh(sink, t_mesh, knots, corners, np);
  return out.good() ? std::error_code() : std::make_error_code(std::io_errc::stream);
}

/// writes a T-mesh with halfedge knots to a PLY file.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left
/// behind and a file that was there stays as it was. Everything else is as with a stream.
///
/// \param filename where to write; a file that is there is replaced
/// \param t_mesh, knots, corners, np see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear.
template <typename FaceGraph, typename HalfedgeKnotMap, typename HalfedgeCornerMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_t_mesh(const std::string& filename, const FaceGraph& t_mesh, const HalfedgeKnotMap knots,
                             const HalfedgeCornerMap corners,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Atomic_file file(filename);
  const auto sink = [&file](const std::string_view text) { file.write(text); };
  internal::format_t_mesh(sink, t_mesh, knots, corners, np);
  file.finish() && file.commit();
  return std::error_code(file.error(), std::generic_category());
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_MESH_H
