// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a seamless map to a T-mesh of nearly square faces of a given size on the surface that can carry a T-spline:
// motorcycle graph, regularization, refinement, rings around extraordinary vertices.
//
//   regularize_t_mesh [MAP.obj [SIZE [T_MESH.ply]]]
//
// SIZE is the longest side that a face may have, by the longest side of the bounding box (0.1). The map is the one that
// the example seamless_similarity_map writes, if none is given; evaluate_t_spline shows the result.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <system_error>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FT = CGAL::Exact_rational;
using Samples = T::Carried_samples<Mesh, T::T_mesh_sample_of<Mesh, Kernel::Point_3>>;

int failure(const std::string& what, const std::string& message)
{
  std::cerr << what << ": " << message << "\n";
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  const std::string map_file = argc > 1 ? argv[1] : "seamless_similarity_map.obj";
  const double relative_size = argc > 2 ? std::atof(argv[2]) : 0.1;
  const std::string t_mesh_file = argc > 3 ? argv[3] : "regularize_t_mesh.ply";
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const T::Mesh_reading_report reading = T::read_map_obj(map_file, mesh, uv);
  if (!reading.success())
    return failure(map_file, describe(reading));
  T::Seamless_map<Mesh, FT> map(mesh);
  if (const auto report = T::make_exactly_seamless(mesh, uv, map); !report.success())
    return failure(map_file, describe(report, mesh));
  T::T_mesh<Kernel::Point_3, FT> t_mesh;
  const auto anchors = t_mesh.graph().add_property_map<Mesh::Face_index, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
  const auto places = mesh.add_property_map<Mesh::Vertex_index, T::T_mesh_place<Mesh, double>>("v:place").first;
  const auto graph = T::trace_motorcycle_graph(
      map, t_mesh, T::parameters::vertex_place_map(places, T::parameters::face_anchor_map(anchors)));
  if (!graph.success())
    return failure(map_file, describe(graph));

  // Two observers follow the changes: the roots hold the T-mesh to the surface, the samples of the surface travel with
  // the faces, whose size they measure.
  Samples samples;
  T::sample_T_mesh(map, t_mesh, anchors, places, std::back_inserter(samples));
  const T::T_mesh_coordinates coordinates(t_mesh);
  T::Surface_face_size face_size(coordinates, samples);
  const T::Carried_anchors<Mesh, Mesh, FT> roots(t_mesh.graph(), anchors);
  const auto with_observer = T::parameters::observer(T::T_mesh_observer_pair(roots, face_size.observer()));

  const auto regularization = T::regularize_T_mesh(t_mesh, with_observer);
  std::cout << describe(regularization) << "\n";
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double size = relative_size * std::max({box.x_span(), box.y_span(), box.z_span()});
  const auto refinement = T::refine_T_mesh(t_mesh, face_size, size, with_observer);
  if (!refinement.success())
    return failure("refinement", describe(refinement, t_mesh.graph()));
  std::cout << "refined to " << num_faces(t_mesh.graph()) << " faces\n";
  const auto compatibility = T::make_spline_compatible(t_mesh, with_observer);
  if (!compatibility.success())
    return failure("spline compatibility", describe(compatibility, t_mesh.graph()));
  std::cout << "spline compatible with " << num_faces(t_mesh.graph()) << " faces\n";

  // New vertices have no points yet. Walking along the edges of the T-mesh finds them.
  if (const auto placement = T::place_T_mesh(map, t_mesh, roots); !placement.success())
    return failure(map_file, describe(placement, t_mesh.graph()));
  if (const std::error_code error = T::write_t_mesh(t_mesh_file, t_mesh))
    return failure(t_mesh_file, error.message());
  return EXIT_SUCCESS;
}
