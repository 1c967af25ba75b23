// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a triangle mesh to a T-spline surface. evaluate_t_spline reads the result.
//
//   first_surface [MESH]

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <string>

namespace T = CGAL::T_splines;

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> mesh;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  const auto reading = T::read_triangle_mesh(file, mesh);
  T::T_spline<> spline; // a T-mesh with control points and weights
  const auto report = T::approximate_by_T_spline(mesh, spline, T::parameters::tolerance(0.01));
  std::cerr << file << ": " << (reading ? describe(report, mesh) : describe(reading)) << "\n";
  if (!report || T::write_t_mesh("first_surface.ply", spline))
    return 1;
  std::cout << spline.surface().position(*spline.graph().faces().begin(), 0, 0) << "\n"; // face, u, v
}
