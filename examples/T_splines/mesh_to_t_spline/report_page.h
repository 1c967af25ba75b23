// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_REPORT_PAGE_H
#define MESH_TO_T_SPLINE_REPORT_PAGE_H

#include "Surface_drawing.h"
#include "Surface_t_mesh.h"
#include "report_page_files.h" // made by CMake from the folder page

#include <CGAL/T_splines/IO/internal/Json_writer.h>
#include <CGAL/T_splines/IO/internal/base64.h>
#include <CGAL/T_splines/IO/internal/Uv_vertex_table.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

using CGAL::T_splines::internal::base64_of_array;

/// The mesh as the page wants it: see `readMesh()` in page/geometry.js.
struct Page_mesh {
  std::vector<float> positions;
  std::vector<double> uv;
  std::vector<std::uint32_t> uv_vertices, triangles;
  std::vector<std::uint8_t> edge_flags;
};

/// Positions on the page are moved and scaled so that the bounding box of the mesh is centred at 0 and has the diagonal
/// 2.
class Page_frame {
public:
  explicit Page_frame(const CGAL::Bbox_3& box)
  {
    for (std::size_t d = 0; d < 3; ++d) {
      const int i = static_cast<int>(d);
      m_middle[d] = box.min(i) + (box.max(i) - box.min(i)) / 2;
      m_diagonal = std::hypot(m_diagonal, box.max(i) - box.min(i));
    }
  }

  /// The middle of the bounding box, and the length of its diagonal, before scaling.
  const std::array<double, 3>& middle() const { return m_middle; }
  double diagonal() const { return m_diagonal; }

  /// Appends the coordinates of `point` on the page.
  template <typename Point_3>
  void append(const Point_3& point, std::vector<float>& positions) const
  {
    for (std::size_t d = 0; d < 3; ++d)
      positions.push_back(static_cast<float>(2 * (point[static_cast<int>(d)] - m_middle[d]) / m_diagonal));
  }

  template <typename Point_3>
  std::vector<float> positions(const std::vector<Point_3>& points) const
  {
    std::vector<float> result;
    result.reserve(3 * points.size());
    for (const Point_3& point : points)
      append(point, result);
    return result;
  }

private:
  std::array<double, 3> m_middle = {};
  double m_diagonal = 0;
};

inline std::string frame_as_json(const Page_frame& frame)
{
  CGAL::T_splines::internal::Json_writer json;
  json.begin_object().array_member("middle", frame.middle()).member("diagonal", frame.diagonal()).end_object();
  return json.text();
}

template <typename Mesh, typename VertexPointMap>
Page_frame page_frame(const Mesh& mesh, const VertexPointMap vertex_point_map)
{
  CGAL::Bbox_3 box;
  for (const auto v : CGAL::make_range(vertices(mesh)))
    box += get(vertex_point_map, v).bbox();
  return Page_frame(box);
}

/// \param is_input_edge edge -> bool: lies on an edge of the input
/// \param is_cut edge -> bool
template <typename FaceGraph, typename VertexPointMap, typename HalfedgeUVMap, typename IsInputEdge, typename IsCut>
Page_mesh page_mesh(const FaceGraph& mesh, const VertexPointMap vertex_point_map, const HalfedgeUVMap uv_map,
                    const Page_frame& frame, const IsInputEdge& is_input_edge, const IsCut& is_cut)
{
  const CGAL::T_splines::internal::Mesh_indexing<FaceGraph> indexing(mesh);
  const CGAL::T_splines::internal::Uv_vertex_table table(indexing, uv_map);
  Page_mesh result;
  for (int v = 0; v < indexing.number_of_vertices(); ++v)
    frame.append(get(vertex_point_map, indexing.vertex(v)), result.positions);
  for (std::size_t i = 0; i < table.size(); ++i) {
    result.uv.insert(result.uv.end(), table.uv(i).begin(), table.uv(i).end());
    result.uv_vertices.push_back(static_cast<std::uint32_t>(table.vertex(i)));
  }
  for (int f = 0; f < indexing.number_of_faces(); ++f) {
    auto h = halfedge(indexing.face(f), mesh);
    unsigned int flags = 0;
    for (unsigned int i = 0; i < 3; ++i, h = next(h, mesh)) {
      result.triangles.push_back(static_cast<std::uint32_t>(table.of_halfedge(indexing.halfedge_index(h))));
      const auto opposite_side = edge(prev(h, mesh), mesh); // from the next corner to the one after it
      flags |= (is_input_edge(opposite_side) ? 1u : 0u) << i | (is_cut(opposite_side) ? 8u : 0u) << i;
    }
    result.edge_flags.push_back(static_cast<std::uint8_t>(flags));
  }
  return result;
}

/// The data of the page by the names in page.html.
using Page_data = std::map<std::string_view, std::function<std::string()>>;

/// Adds the data of the surface: see `readSpline()` in page/spline.js.
/// \pre `frame` and `surface` outlive `data`.
inline void add_surface_data(Page_data& data, const Page_frame& frame, const Surface_drawing& surface)
{
  data["spline_points"] = [&] { return base64_of_array(frame.positions(surface.points)); };
  data["spline_normals"] = [&] { return base64_of_array(packed_directions(surface.normals)); };
  data["spline_curvature"] = [&] {
    return base64_of_array(std::vector<float>(surface.mean_curvature.begin(), surface.mean_curvature.end()));
  };
  data["spline_deviation"] = [&] {
    return base64_of_array(std::vector<float>(surface.deviation.begin(), surface.deviation.end()));
  };
  data["spline_triangles"] = [&] { return base64_of_array(surface.triangles); };
  data["net_points"] = [&] { return base64_of_array(frame.positions(surface.net_points)); };
  data["net_sizes"] = [&] { return base64_of_array(surface.net_sizes); };
  data["edge_points"] = [&] { return base64_of_array(frame.positions(surface.edge_points)); };
  data["edge_sizes"] = [&] { return base64_of_array(surface.edge_sizes); };
  data["extraordinary_points"] = [&] { return base64_of_array(frame.positions(surface.extraordinary_points)); };
}

/// Hands the page to `sink`, a function object that takes a `std::string_view`: the template with the files of the
/// folder page and the data in the places that are marked by `@name@`.
/// \param traced, regular the T-mesh before and after regularization; empty where there is none
/// \param surface empty if there is none
template <typename Sink>
void write_report_page(Sink& sink, const std::string& report_as_json, const Page_frame& frame, const Page_mesh& mesh,
                       const T_mesh_drawing& traced, const T_mesh_drawing& regular, const Surface_drawing& surface)
{
  Page_data data = {{"report", [&] { return report_as_json; }},
                    {"frame", [&] { return frame_as_json(frame); }},
                    {"positions", [&] { return base64_of_array(mesh.positions); }},
                    {"uv", [&] { return base64_of_array(mesh.uv); }},
                    {"uv_vertices", [&] { return base64_of_array(mesh.uv_vertices); }},
                    {"triangles", [&] { return base64_of_array(mesh.triangles); }},
                    {"edge_flags", [&] { return base64_of_array(mesh.edge_flags); }},
                    {"traced_points", [&] { return base64_of_array(frame.positions(traced.points)); }},
                    {"traced_sizes", [&] { return base64_of_array(traced.sizes); }},
                    {"traced_joints", [&] { return base64_of_array(frame.positions(traced.t_joints)); }},
                    {"regular_points", [&] { return base64_of_array(frame.positions(regular.points)); }},
                    {"regular_sizes", [&] { return base64_of_array(regular.sizes); }},
                    {"regular_joints", [&] { return base64_of_array(frame.positions(regular.t_joints)); }}};
  add_surface_data(data, frame, surface);
  std::string_view rest = report_page_file("page.html");
  for (std::size_t begin = rest.find('@'); begin != std::string_view::npos; begin = rest.find('@')) {
    const std::size_t end = rest.find('@', begin + 1);
    const std::string_view name = rest.substr(begin + 1, end - begin - 1);
    sink(rest.substr(0, begin));
    const auto position = data.find(name);
    if (position != data.end())
      sink(std::string_view(position->second()));
    else
      sink(report_page_file(name));
    rest.remove_prefix(end + 1);
  }
  sink(rest);
}

#endif // MESH_TO_T_SPLINE_REPORT_PAGE_H
