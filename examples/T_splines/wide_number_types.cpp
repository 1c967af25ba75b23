// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a similarity metric with 50 decimal digits.
//
//   wide_number_types [MESH]

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FT = boost::multiprecision::cpp_bin_float_50;

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
  T::Holonomy_signature<Mesh> signature;
  if (!T::compute_smooth_cross_field(mesh, cross_field).success() ||
      !T::holonomy_signature_of_cross_field(mesh, cross_field, signature).success()) {
    std::cerr << mesh_file << ": there is no signature\n";
    return EXIT_FAILURE;
  }

  // The mesh's coordinates stay doubles, taken as exact; linear systems are solved in double, residuals evaluated in FT.
  T::Similarity_metric<Mesh, FT> metric;
  const auto report = T::compute_similarity_metric(
      mesh, signature, metric, T::parameters::number_type(FT(), T::parameters::residual_tolerance(1e-40)));
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << "residual " << report.residual << " after " << report.iterations << " iterations, computed with "
            << report.mantissa_bits << " bits\n";
  std::cout.precision(std::numeric_limits<FT>::digits10);
  std::cout << "logarithm of the scale factor at the second vertex, relative to the first: "
            << metric.log_scale(1) - metric.log_scale(0) << "\n";
  return EXIT_SUCCESS;
}
