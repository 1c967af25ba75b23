// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a smooth cross field of a triangle mesh and writes it as a .rawfield file.
//
//   smooth_cross_field [MESH [OUTPUT.rawfield [CURVATURE_ALIGNMENT]]]

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/IO/write_rawfield.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <system_error>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  const std::string field_file = argc > 2 ? argv[2] : "smooth_cross_field.rawfield";
  const double alignment = argc > 3 ? std::atof(argv[3]) : 0;

  Mesh mesh;
  const auto reading = CGAL::T_splines::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }

  // One of the four directions of the cross in each face.
  const auto cross_field = mesh.add_property_map<Face, Kernel::Vector_3>("f:cross").first;
  const auto report = CGAL::T_splines::compute_smooth_cross_field(
      mesh, cross_field, CGAL::T_splines::parameters::curvature_alignment(alignment));
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << num_faces(mesh) << " crosses, " << report.number_of_singularities << " singularities\n";

  if (const std::error_code error = CGAL::T_splines::write_rawfield(field_file, mesh, cross_field)) {
    std::cerr << field_file << ": " << error.message() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
