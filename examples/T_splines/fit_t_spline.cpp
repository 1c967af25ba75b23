// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a seamless map to a T-spline surface that approximates the mapped mesh within a tolerance.
//
//   fit_t_spline [MAP.obj [TOLERANCE [T_SPLINE.ply]]]
//
// TOLERANCE is a distance, by the longest side of the bounding box (0.005). The map is the one that the example
// seamless_similarity_map writes, if none is given; evaluate_t_spline and t_spline_deviation read the result.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <system_error>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int failure(const std::string& what, const std::string& message)
{
  std::cerr << what << ": " << message << "\n";
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  const std::string map_file = argc > 1 ? argv[1] : "seamless_similarity_map.obj";
  const double tolerance = argc > 2 ? std::atof(argv[2]) : T::default_tolerance;
  const std::string t_spline_file = argc > 3 ? argv[3] : "fit_t_spline.ply";
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const T::Mesh_reading_report reading = T::read_map_obj(map_file, mesh, uv);
  if (!reading.success())
    return failure(map_file, describe(reading));
  T::Seamless_map<Mesh> map(mesh);
  if (const auto report = T::make_exactly_seamless(mesh, uv, map); !report.success())
    return failure(map_file, describe(report, mesh));
  T::Surface_T_mesh<Mesh> placed; // the T-mesh, and the mesh on its faces
  if (const auto report = T::compute_T_mesh(map, placed); !report.success())
    return failure(map_file, describe(report));
  T::T_spline<> spline;
  const auto report = T::fit_adaptive_T_spline(placed.t_mesh(), placed.surface(), mesh, tolerance, spline);
  if (!report.success())
    return failure(map_file, describe(report, placed.t_mesh().graph()));
  for (const T::T_spline_fit_level& level : report.levels)
    std::cout << level.number_of_control_points << " control points: error " << level.error.relative_rms()
              << " (root mean square), " << level.error.relative_maximum() << " (largest)\n";
  std::cout << describe(report, placed.t_mesh().graph()) << "\n";
  if (const std::error_code error = T::write_t_mesh(t_spline_file, spline))
    return failure(t_spline_file, error.message());
  return EXIT_SUCCESS;
}
