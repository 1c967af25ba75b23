// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Merges cones of a smooth cross field, so that few are left: each costs a T-spline rings of control points.
//
//   few_cones [MESH [MAXIMUM [OUTPUT.cones]]]
//
// MAXIMUM is the number of cones allowed; without it, cones are merged as long as this distorts the map little.

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/IO/write_cones.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <system_error>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Signature = T::Holonomy_signature<Mesh>;

// How many cones there are of each number of quarter turns.
void print_cones(const std::string& title, const Signature& signature)
{
  std::map<int, int> count;
  for (const Signature::Cone& cone : signature.cones())
    ++count[cone.second];
  std::cout << title << ": " << signature.cones().size() << " cones";
  for (const auto& [quarter_turns, number] : count)
    std::cout << ", " << number << " of " << quarter_turns << " quarter turns";
  std::cout << "\n";
}

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  const std::string cones_file = argc > 3 ? argv[3] : "few_cones.cones";
  Mesh mesh;
  const T::Mesh_reading_report reading = T::read_triangle_mesh(mesh_file, mesh);
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
  print_cones("smooth cross field", signature);

  // The numbers of the loops follow the cones; the signature stays admissible. No field is needed for a map.
  const auto report = argc > 2
                          ? T::reduce_cones(mesh, signature, T::parameters::maximum_number_of_cones(std::atoi(argv[2])))
                          : T::reduce_cones(mesh, signature);
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  print_cones("reduced", signature);
  std::cout << report.number_of_splits << " splits, " << report.number_of_merges << " merges; the energy went from "
            << report.energy_before << " to " << report.energy << "\n";

  if (const std::error_code error = T::write_cones(cones_file, mesh, signature)) {
    std::cerr << cones_file << ": " << error.message() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
