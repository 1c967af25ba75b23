// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the flat metric with cones alone, without a map, and checks its cone angles. A visitor shows the progress.
//
//   similarity_metric [MESH]

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Signature = T::Holonomy_signature<Mesh>;

struct Stage_printer : T::Progress_visitor {
  void begin_stage(const char* name) const { std::cout << name << "...\n"; }
};

// The cone angle at each vertex: the sum of the angles of the intrinsic triangles.
std::vector<double> cone_angles(const Mesh& mesh, const T::Similarity_metric<Mesh>& metric)
{
  std::vector<double> angle_sum(num_vertices(mesh), 0.);
  for (int f = 0; f < metric.number_of_faces(); ++f) {
    const std::array<double, 3> angles = metric.angles(f);
    int h = metric.halfedge(f);
    for (const double angle : angles) {
      angle_sum[metric.target(metric.next(h))] += angle; // opposite to h
      h = metric.next(h);
    }
  }
  return angle_sum;
}

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  const auto reading = T::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }
  const auto cross_field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  Signature signature;
  if (!T::compute_smooth_cross_field(mesh, cross_field).success() ||
      !T::holonomy_signature_of_cross_field(mesh, cross_field, signature).success()) {
    std::cerr << mesh_file << ": there is no signature\n";
    return EXIT_FAILURE;
  }

  T::Similarity_metric<Mesh> metric;
  const auto report = T::compute_similarity_metric(mesh, signature, metric, CGAL::parameters::visitor(Stage_printer()));
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  for (const double residual : report.residual_history)
    std::cout << "  residual " << residual << "\n";

  const std::vector<double> angle = cone_angles(mesh, metric);
  double largest = 0;
  for (const Vertex v : vertices(mesh))
    largest = std::max(largest, std::abs(angle[v] - signature.quarter_turns(v) * CGAL_PI / 2));
  std::cout << "cone angles deviate by at most " << largest << " radians; " << report.flips << " flips\n";
  constexpr double round_off = 1e-11;
  return largest < round_off ? EXIT_SUCCESS : EXIT_FAILURE;
}
