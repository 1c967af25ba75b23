// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a seamless map, of whatever origin, to a T-mesh of nearly square faces of a given size on the surface: exact map,
// motorcycle graph, regularization, refinement.
//
//   motorcycle_graph MAP.obj [SIZE [T_MESH.ply]]
//
// SIZE is the longest side that a face may have, by the diagonal of the bounding box (0.05). Without arguments, the
// surface of a box is mapped, square by square.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <system_error>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using FT = CGAL::Exact_rational;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

template <typename Status>
int failure(const std::string& what, const Status status)
{
  std::cerr << what << ": " << message(status) << "\n";
  return EXIT_FAILURE;
}

/// The surface of a box of 3 x 2 x 2 unit squares, cut along all edges of the squares: each has a chart of its own.
void make_box(Mesh& mesh, const Uv_map uv)
{
  const int size[3] = {3, 2, 2};
  std::map<std::array<int, 3>, Mesh::Vertex_index> vertex;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, size[axis]})
      for (int i = 0; i < size[(axis + 1) % 3]; ++i)
        for (int j = 0; j < size[(axis + 2) % 3]; ++j) {
          std::array<Mesh::Vertex_index, 4> corner;
          const int du[4] = {0, 1, 1, 0}, dv[4] = {0, 0, 1, 1};
          for (int c = 0; c < 4; ++c) {
            const int k = side == 0 ? 3 - c : c; // outwards
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = i + du[k];
            p[(axis + 2) % 3] = j + dv[k];
            const auto found = vertex.find(p);
            corner[c] = found != vertex.end() ? found->second : mesh.add_vertex(Point_3(p[0], p[1], p[2]));
            vertex[p] = corner[c];
          }
          for (int t = 1; t < 3; ++t) {
            Mesh::Halfedge_index h = mesh.halfedge(mesh.add_face(corner[0], corner[t], corner[t + 1]));
            for (int n = 0; n < 3; ++n, h = mesh.next(h))
              for (const int c : {0, t, t + 1})
                if (mesh.target(h) == corner[c])
                  uv[h] = Kernel::Point_2(du[c], dv[c]);
          }
        }
}

int main(int argc, char* argv[])
{
  const double relative_size = argc > 2 ? std::atof(argv[2]) : 0.05;
  const std::string t_mesh_file = argc > 3 ? argv[3] : "motorcycle_graph.ply";
  Mesh mesh;
  const Uv_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if (argc > 1) {
    const T::Mesh_reading_report reading = T::read_map_obj(argv[1], mesh, uv);
    if (!reading.success()) {
      std::cerr << argv[1] << ": " << describe(reading) << "\n";
      return EXIT_FAILURE;
    }
  }
  else
    make_box(mesh, uv);

  T::Seamless_map<Mesh, FT> map(mesh);
  const auto exact_report = T::make_exactly_seamless(mesh, uv, map);
  if (!exact_report.success())
    return failure("exact map", exact_report.status);
  std::cout << exact_report.number_of_cones << " cones, " << exact_report.number_of_cut_edges << " cut edges, "
            << (exact_report.is_isometric ? "isometric" : "with scale factors") << "\n";

  // The T-mesh, with the places of all vertices of the mesh on it, and with what holds it to the surface.
  Mesh t_mesh;
  const auto knots = t_mesh.add_property_map<Mesh::Halfedge_index, FT>("h:knot").first;
  const auto corners = t_mesh.add_property_map<Mesh::Halfedge_index, bool>("h:corner").first;
  const auto anchors = t_mesh.add_property_map<Mesh::Face_index, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
  const auto places = mesh.add_property_map<Mesh::Vertex_index, T::T_mesh_place<Mesh, double>>("v:place").first;
  const auto graph_report = T::trace_motorcycle_graph(
      map, t_mesh, knots, corners, T::parameters::vertex_place_map(places, T::parameters::face_anchor_map(anchors)));
  if (!graph_report.success())
    return failure("motorcycle graph", graph_report.status);
  std::cout << graph_report.motorcycles << " motorcycles, " << num_faces(t_mesh) << " faces, " << graph_report.t_joints
            << " T-joints\n";
  if (const auto admissibility = T::is_admissible(t_mesh, knots, corners); !admissibility)
    return failure("knots", admissibility.status);

  // The vertices of the mesh travel with the faces: they measure the size of the faces on the surface.
  using Points = T::Carried_points<Mesh, double, Point_3>;
  using Coordinates = T::T_mesh_coordinates<Mesh, decltype(knots), decltype(corners)>;
  Points points;
  for (const Mesh::Vertex_index v : vertices(mesh))
    points.add(places[v].face, places[v].u, places[v].v, mesh.point(v));
  T::Surface_face_size<Mesh, decltype(knots), decltype(corners), Points> face_size(Coordinates(t_mesh, knots, corners),
                                                                                   points);
  const T::T_mesh_roots<Mesh, Mesh, FT> roots(t_mesh, anchors);
  const T::T_mesh_visitor_pair<T::T_mesh_roots<Mesh, Mesh, FT>, decltype(face_size.visitor())> visitor(
      roots, face_size.visitor());

  const auto regularization = T::regularize_T_mesh(t_mesh, knots, corners, CGAL::parameters::visitor(visitor));
  std::cout << "worst aspect ratio " << regularization.worst_aspect_before << ", regularized "
            << regularization.worst_aspect_after << " with " << regularization.faces_after << " faces\n";
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  const auto refinement =
      T::refine_T_mesh(t_mesh, knots, corners, face_size, relative_size * diagonal, CGAL::parameters::visitor(visitor));
  if (!refinement.success())
    return failure("refinement", refinement.status);
  std::cout << refinement.splits << " splits, " << num_faces(t_mesh) << " faces\n";

  // New vertices have no points yet. Walking along the edges of the T-mesh finds them.
  if (!T::place_T_mesh(map, t_mesh, knots, corners, roots)) {
    std::cerr << "the T-mesh has left the surface\n";
    return EXIT_FAILURE;
  }
  if (const std::error_code error = T::write_t_mesh(t_mesh_file, t_mesh, knots, corners)) {
    std::cerr << t_mesh_file << ": " << error.message() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
