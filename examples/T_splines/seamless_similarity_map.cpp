// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a mesh as a smooth cross field with few cones says and looks at what comes with the map: the cut, the
// transitions across it, and the place of every vertex on the input.
//
//   seamless_similarity_map [MESH [OUTPUT.obj]]

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <system_error>

namespace T = CGAL::T_splines;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Location = PMP::Face_location<Mesh, double>;
using Transition = T::Similarity_2<double>;

int failure(const std::string& file, const std::string& message)
{
  std::cerr << file << ": " << message << "\n";
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  const std::string map_file = argc > 2 ? argv[2] : "seamless_similarity_map.obj";
  Mesh mesh, refined;
  const T::Mesh_reading_report reading = T::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }

  const auto cross_field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  const auto field_report = T::compute_smooth_cross_field(mesh, cross_field);
  if (!field_report.success())
    return failure(mesh_file, describe(field_report, mesh));
  T::Holonomy_signature<Mesh> signature;
  const auto signature_report = T::holonomy_signature_of_cross_field(mesh, cross_field, signature);
  if (!signature_report.success())
    return failure(mesh_file, describe(signature_report, mesh));
  if (const auto cone_report = T::reduce_cones(mesh, signature); !cone_report.success())
    return failure(mesh_file, describe(cone_report, mesh));

  // The map lives on a refinement of the mesh. Only uv is asked for; the rest is optional.
  const auto uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto is_cut = refined.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto transition = refined.add_property_map<Mesh::Halfedge_index, Transition>("h:transition").first;
  const auto location = refined.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const auto report = T::compute_seamless_similarity_map(
      mesh, signature, refined, uv,
      T::parameters::edge_is_cut_map(
          is_cut, T::parameters::halfedge_transition_map(transition, T::parameters::vertex_location_map(location))));
  if (!report.success())
    return failure(mesh_file, describe(report, mesh));
  std::cout << num_faces(mesh) << " faces, refined to " << num_faces(refined) << "; residual " << report.residual
            << " after " << report.iterations << " iterations\n";

  // Across the cut, the transition takes the coordinates of one side to those of the other.
  double seam_error = 0;
  std::size_t number_of_cut_edges = 0;
  for (const Mesh::Edge_index e : edges(refined)) {
    const Mesh::Halfedge_index h = halfedge(e, refined), g = opposite(h, refined);
    const Kernel::Point_2 p = uv[prev(g, refined)], q = uv[g]; // the ends of e in the chart of the face of g
    const double error = CGAL::squared_distance(transition[h](uv[h]), p) / CGAL::squared_distance(p, q);
    seam_error = std::max(seam_error, std::sqrt(error));
    number_of_cut_edges += is_cut[e] ? 1 : 0;
  }
  std::cout << number_of_cut_edges << " cut edges; the transitions fit up to " << seam_error << " of an edge\n";

  // Barycentric coordinates in a face of the input: whatever lives on the input can be carried over.
  double distance = 0;
  for (const Mesh::Vertex_index v : vertices(refined))
    distance = std::max(distance, CGAL::squared_distance(refined.point(v), PMP::construct_point(location[v], mesh)));
  std::cout << "the vertices lie on the input up to " << std::sqrt(distance) << "\n";

  if (const std::error_code error = T::write_map_obj(map_file, refined, uv)) {
    std::cerr << map_file << ": " << error.message() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
