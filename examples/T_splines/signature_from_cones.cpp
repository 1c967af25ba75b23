// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the holonomy signature of a mesh from cones and prints its loops; then changes the number of a loop by hand.
//
//   signature_from_cones [MESH [FILE.cones]]
//
// Without a file, the first vertex becomes a cone that carries all the curvature of a connected mesh.

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Signature = CGAL::T_splines::Holonomy_signature<Mesh>;
using Report = CGAL::T_splines::Holonomy_signature_report<Mesh>;

bool is_admissible(const Report& report, const Mesh& mesh)
{
  if (!report.success())
    std::cerr << describe(report, mesh) << "\n";
  return report.success();
}

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  const auto reading = CGAL::T_splines::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }

  std::vector<Signature::Cone> cones;
  if (argc > 2) {
    const auto file = CGAL::T_splines::read_cones(argv[2], mesh, cones);
    if (!file.success()) {
      std::cerr << argv[2] << ": " << describe(file) << "\n";
      return EXIT_FAILURE;
    }
  }
  else {
    // Gauss and Bonnet: 4 - k sums up to four times the Euler characteristic.
    const int characteristic =
        static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
    cones.emplace_back(*vertices(mesh).begin(), 4 - 4 * characteristic);
  }

  Signature signature;
  if (!is_admissible(CGAL::T_splines::holonomy_signature_of_cones(mesh, cones, signature), mesh))
    return EXIT_FAILURE;
  std::cout << signature.cones().size() << " cones\n";
  for (const Signature::Loop& loop : signature.loops())
    std::cout << "loop of " << loop.halfedges.size() << " triangles, " << loop.quarter_turns << " quarter turns\n";

  // A signature is a value: numbers may be changed by hand, and are judged when all is said.
  if (!signature.loops().empty())
    signature.set_loop_quarter_turns(0, signature.loops()[0].quarter_turns + 1);
  return is_admissible(CGAL::T_splines::check_holonomy_signature(mesh, signature), mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
