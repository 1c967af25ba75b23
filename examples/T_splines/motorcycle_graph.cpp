// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a seamless map, of whatever origin, to a T-mesh with halfedge knots: exact map and motorcycle graph.
//
//   motorcycle_graph [MAP.obj [T_MESH.ply]]
//
// The map is the one that the example seamless_similarity_map writes, if none is given.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FT = CGAL::Exact_rational;

int failure(const std::string& what, const std::string& message)
{
  std::cerr << what << ": " << message << "\n";
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  const std::string map_file = argc > 1 ? argv[1] : "seamless_similarity_map.obj";
  const std::string t_mesh_file = argc > 2 ? argv[2] : "motorcycle_graph.ply";
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const T::Mesh_reading_report reading = T::read_map_obj(map_file, mesh, uv);
  if (!reading.success()) {
    std::cerr << map_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }

  // In the file, the map is seamless up to round-off.
  T::Seamless_map<Mesh, FT> map(mesh);
  const auto exact_report = T::make_exactly_seamless(mesh, uv, map);
  if (!exact_report.success())
    return failure(map_file, describe(exact_report, mesh));
  std::cout << exact_report.number_of_cones << " cones, " << exact_report.number_of_cut_edges << " cut edges, "
            << (exact_report.is_isometric ? "isometric" : "with scale factors") << "; uv moved by up to "
            << exact_report.largest_displacement << "\n";

  // The T-mesh, and where each vertex of the mesh lies on it.
  T::T_mesh<Kernel::Point_3, FT> t_mesh;
  const auto places = mesh.add_property_map<Mesh::Vertex_index, T::T_mesh_place<Mesh, double>>("v:place").first;
  const auto report = T::trace_motorcycle_graph(map, t_mesh, T::parameters::vertex_place_map(places));
  if (!report.success())
    return failure(map_file, describe(report));
  std::cout << report.motorcycles << " motorcycles, " << num_faces(t_mesh.graph()) << " faces, " << report.t_joints
            << " T-joints\n";
  std::vector<std::size_t> number(num_faces(t_mesh.graph()), 0);
  std::size_t most = 0;
  for (const Mesh::Vertex_index v : vertices(mesh))
    most = std::max(most, ++number[places[v].face]);
  std::cout << "up to " << most << " vertices of the mesh in a face\n";

  // On the two sides of an edge the knots may differ, by a factor; all in all they fit together, exactly.
  if (const auto admissibility = T::check_admissibility(t_mesh); !admissibility)
    return failure(map_file, describe(admissibility, t_mesh.graph()));
  if (const std::error_code error = T::write_t_mesh(t_mesh_file, t_mesh)) {
    std::cerr << t_mesh_file << ": " << error.message() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
