// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how far a T-spline surface and a mesh are from each other, in space, whatever the parametrization, and
// looks for folds and self-intersections of the surface.
//
//   t_spline_deviation [T_SPLINE.ply MESH]
//
// The surface is the one that the example fit_t_spline writes, if none is given.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

void print(const std::string& title, const T::One_way_deviation& deviation)
{
  std::cout << title << ": root mean square " << deviation.relative_rms() << ", largest "
            << deviation.relative_maximum() << " (certainly at most " << deviation.relative_upper_bound()
            << ") of the longest side of the bounding box, at (" << deviation.farthest_point << ")\n";
}

int main(int argc, char* argv[])
{
  const std::string spline_file = argc > 1 ? argv[1] : "fit_t_spline.ply";
  const std::string mesh_file = argc > 2 ? argv[2] : CGAL::data_file_path("meshes/eight.off");
  T::T_spline<Kernel> spline;
  Mesh mesh;
  const T::T_mesh_reading_report spline_reading = T::read_t_mesh(spline_file, spline);
  if (!spline_reading.success()) {
    std::cerr << spline_file << ": " << describe(spline_reading) << "\n";
    return EXIT_FAILURE;
  }
  const T::Mesh_reading_report mesh_reading = T::read_triangle_mesh(mesh_file, mesh);
  if (!mesh_reading.success()) {
    std::cerr << mesh_file << ": " << describe(mesh_reading) << "\n";
    return EXIT_FAILURE;
  }
  const auto surface = spline.surface();
  if (!surface.is_valid()) {
    std::cerr << spline_file << ": " << describe(surface.report(), spline.graph()) << "\n";
    return EXIT_FAILURE;
  }

  const auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  T::detect_features(mesh, is_feature);
  const auto report =
      T::measure_T_spline_deviation(T::compile_T_spline(surface), mesh,
                                    T::parameters::vertex_distance_map(distance).edge_is_constrained_map(is_feature));
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  print("mesh to surface", report.mesh_to_surface);
  print("surface to mesh", report.surface_to_mesh);
  if (report.free_edge) {
    print("border of the mesh to that of the surface", report.free_edge->mesh_to_surface);
    print("border of the surface to that of the mesh", report.free_edge->surface_to_mesh);
  }
  if (report.crease) {
    print("features of the mesh to creases of the surface", report.crease->mesh_to_surface);
    print("creases of the surface to features of the mesh", report.crease->surface_to_mesh);
  }
  std::cout << report.normals.number_of_folded_patches << " of " << report.normals.number_of_patches
            << " Bezier patches have a fold, " << report.normals.number_of_certified_patches
            << " certainly have none\n";
  const auto intersections = T::check_T_spline_self_intersections(surface, mesh, CGAL::Emptyset_iterator());
  std::cout << intersections.number_of_new_intersections
            << " pairs of triangles of the surface intersect where the mesh does not\n";
  std::vector<double> distances(distance.begin(), distance.end());
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  std::cout << "half of the vertices are within " << distances[distances.size() / 2] << "\n";

  // Other points are measured by a function object that is made once for the mesh.
  const T::Mesh_distance mesh_distance(mesh);
  std::size_t number = 0;
  for (const Mesh::Vertex_index v : vertices(spline.graph()))
    number += mesh_distance(spline.graph().point(v)) > report.maximum() ? 1 : 0;
  std::cout << number << " of " << spline.number_of_control_points()
            << " control points are farther from the mesh than the surface is anywhere\n";
  return EXIT_SUCCESS;
}
