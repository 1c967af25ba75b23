// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a triangle mesh to a T-spline surface, step by step. evaluate_t_spline reads the result.
//
//   first_surface [MESH [TOLERANCE [T_SPLINE.ply]]]
//
// TOLERANCE is the largest distance allowed between mesh and surface, by the longest side of the bounding box (0.01).

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FT = CGAL::Exact_rational;

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  const double relative_tolerance = argc > 2 ? std::atof(argv[2]) : 0.01;
  const std::string t_spline_file = argc > 3 ? argv[3] : "first_surface.ply";

  // A map of the mesh, refined, to the plane: it follows a smooth cross field.
  Mesh mesh, refined;
  T::Holonomy_signature<Mesh> signature;
  const auto cross_field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  const auto uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if (!T::read_triangle_mesh(mesh_file, mesh).success() ||
      !T::compute_smooth_cross_field(mesh, cross_field).success() ||
      !T::holonomy_signature_of_cross_field(mesh, cross_field, signature).success() ||
      !T::reduce_cones(mesh, signature).success() ||
      !T::compute_seamless_similarity_map(mesh, signature, refined, uv).success()) {
    std::cerr << mesh_file << ": there is no map\n";
    return EXIT_FAILURE;
  }

  // A T-mesh whose edges are isolines of the map. The mesh stays on its faces, while these become squarer.
  T::Seamless_map<Mesh, FT> map(refined);
  T::T_mesh<Kernel::Point_3, FT> t_mesh;
  const auto anchors = t_mesh.graph().add_property_map<Mesh::Face_index, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
  if (!T::make_exactly_seamless(refined, uv, map).success() ||
      !T::trace_motorcycle_graph(map, t_mesh, T::parameters::face_anchor_map(anchors)).success()) {
    std::cerr << mesh_file << ": there is no T-mesh\n";
    return EXIT_FAILURE;
  }
  T::Carried_surface<Mesh> surface = T::carry_surface(map, t_mesh, anchors);
  T::regularize_T_mesh(t_mesh, CGAL::parameters::visitor(surface.visitor()));

  // A surface that is as close to the mesh as asked for.
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double tolerance = relative_tolerance * std::max({box.x_span(), box.y_span(), box.z_span()});
  T::T_spline<Kernel> spline;
  const auto report = T::fit_adaptive_T_spline(t_mesh, surface, tolerance, spline);
  std::cout << describe(report, t_mesh.graph()) << ", with " << spline.number_of_control_points()
            << " control points\n";
  return report.success() && !T::write_t_mesh(t_spline_file, spline) ? EXIT_SUCCESS : EXIT_FAILURE;
}
