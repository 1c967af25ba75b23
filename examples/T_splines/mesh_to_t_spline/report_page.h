// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_REPORT_PAGE_H
#define MESH_TO_T_SPLINE_REPORT_PAGE_H

#include "Approximation.h"
#include "Json_writer.h"
#include "Surface_drawing.h"
#include "T_mesh_drawing.h"
#include "report_page_files.h" // made by CMake from the folder page

#include <CGAL/T_splines/IO/base64.h>

#include <CGAL/Bbox_3.h>

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

using CGAL::T_splines::base64_of_array;

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
  Json_writer json;
  json.begin_object().array_member("middle", frame.middle()).member("diagonal", frame.diagonal()).end_object();
  return json.text();
}

/// Numbers the pairs of a vertex and one of its uv: the vertices of the surface after it has been cut open along its
/// seams.
class Uv_vertices {
public:
  explicit Uv_vertices(const Mapped& mapped) : m_mapped(mapped), m_of_vertex(mapped.mesh().number_of_vertices()) {}

  /// The number of the pair at the target of `h` on its face; if it is new, it is appended to `page`.
  std::uint32_t operator()(const Halfedge h, Page_mesh& page)
  {
    const Vertex v = m_mapped.mesh().target(h);
    const Kernel::Point_2& uv = m_mapped.uv()[h];
    for (const std::uint32_t i : m_of_vertex[v])
      if (page.uv[2 * i] == uv.x() && page.uv[2 * i + 1] == uv.y())
        return i;
    m_of_vertex[v].push_back(static_cast<std::uint32_t>(page.uv_vertices.size()));
    page.uv.insert(page.uv.end(), {uv.x(), uv.y()});
    page.uv_vertices.push_back(v);
    return m_of_vertex[v].back();
  }

private:
  const Mapped& m_mapped;
  std::vector<std::vector<std::uint32_t>> m_of_vertex;
};

/// \param is_input_edge edge -> bool: lies on an edge of the input
template <typename IsInputEdge>
Page_mesh page_mesh(const Mapped& mapped, const Page_frame& frame, const IsInputEdge& is_input_edge)
{
  const Mesh& mesh = mapped.mesh();
  Uv_vertices uv_vertices(mapped);
  Page_mesh result;
  for (const Vertex v : mesh.vertices())
    frame.append(mesh.point(v), result.positions);
  for (const Face f : mesh.faces()) {
    Halfedge h = mesh.halfedge(f);
    unsigned int flags = 0;
    for (unsigned int i = 0; i < 3; ++i, h = mesh.next(h)) {
      result.triangles.push_back(uv_vertices(h, result));
      const Edge opposite_side = mesh.edge(mesh.prev(h)); // from the next corner to the one after it
      flags |= (is_input_edge(opposite_side) ? 1u : 0u) << i | (mapped.cut()[opposite_side] ? 8u : 0u) << i;
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
  data["border_points"] = [&] { return base64_of_array(frame.positions(surface.border_points)); };
  data["border_sizes"] = [&] { return base64_of_array(surface.border_sizes); };
  data["crease_points"] = [&] { return base64_of_array(frame.positions(surface.crease_points)); };
  data["crease_sizes"] = [&] { return base64_of_array(surface.crease_sizes); };
  data["corner_points"] = [&] { return base64_of_array(frame.positions(surface.corner_points)); };
  data["corner_turns"] = [&] { return base64_of_array(surface.corner_turns); };
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
