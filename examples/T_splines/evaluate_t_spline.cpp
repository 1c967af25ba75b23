// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Evaluates a T-spline surface from a file, of whatever origin: t_mesh.ply with control points, weights and halfedge
// knots.
//
//   evaluate_t_spline T_MESH.ply                    writes T_MESH.vtu (Bezier patches) and T_MESH.obj (triangles)
//   evaluate_t_spline T_MESH.ply FACE U V ...       prints point, unit normal and curvatures at places of the surface
//
// Faces are counted from 0; U and V are in units of the face's knots. Without arguments, the surface is a torus of 6 x
// 4 faces.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Graph = T::T_spline<Kernel>::Graph;
using Face = Graph::Face_index;

void make_torus(T::T_spline<Kernel>& spline)
{
  Graph& graph = spline.graph();
  const int m = 6, n = 4;
  const double tau = 2 * std::acos(-1.);
  std::vector<Graph::Vertex_index> v;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / m, b = tau * j / n, r = 3 + std::cos(b);
      v.push_back(graph.add_vertex(Kernel::Point_3(r * std::cos(a), r * std::sin(a), std::sin(b))));
    }
  const auto at = [&](const int i, const int j) { return v[n * (i % m) + j % n]; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      graph.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  for (const Graph::Halfedge_index h : graph.halfedges()) {
    put(spline.knots(), h, 1);
    put(spline.corners(), h, true);
  }
}

int main(int argc, char* argv[])
{
  T::T_spline<Kernel> spline;
  const std::string file = argc > 1 ? argv[1] : "evaluate_t_spline.ply";
  if (argc > 1) {
    const T::T_mesh_reading_report reading = T::read_t_mesh(file, spline);
    if (!reading.success()) {
      std::cerr << file << ": " << describe(reading) << "\n";
      return EXIT_FAILURE;
    }
  }
  else
    make_torus(spline);

  const Graph& graph = spline.graph();
  const auto surface = spline.surface();
  if (!surface.is_valid()) {
    std::cerr << file << ": " << describe(surface.report(), graph) << "\n";
    return EXIT_FAILURE;
  }
  for (int i = 2; i + 2 < argc; i += 3) {
    const Face f(static_cast<Graph::size_type>(std::atol(argv[i])));
    const double u = std::atof(argv[i + 1]), v = std::atof(argv[i + 2]);
    if (!graph.is_valid(f) || !(u >= 0 && u <= surface.width(f) && v >= 0 && v <= surface.height(f))) {
      std::cerr << "there is no point (" << argv[i + 1] << ", " << argv[i + 2] << ") of face " << argv[i] << "\n";
      return EXIT_FAILURE;
    }
    std::cout << "point " << surface.position(f, u, v) << "\nnormal " << surface.unit_normal(f, u, v) << "\n";
    if (const auto jet = surface.jet(f, u, v); jet.normal() != CGAL::NULL_VECTOR)
      std::cout << "gaussian curvature " << jet.curvatures().gaussian << "\nmean curvature " << jet.curvatures().mean
                << "\n";
  }
  if (argc > 2)
    return EXIT_SUCCESS;

  const auto patches = T::compile_T_spline(surface);
  std::cout << surface.number_of_control_points() << " control points, " << graph.number_of_faces() << " faces, "
            << patches.number_of_patches() << " Bezier patches\n";
  const std::string vtu = std::filesystem::path(file).replace_extension(".vtu").string(),
                    obj = std::filesystem::path(file).replace_extension(".obj").string();
  std::error_code error = T::write_t_spline_vtu(vtu, patches);
  if (!error)
    error = T::write_t_spline_obj(obj, patches, 8);
  if (error)
    std::cerr << vtu << ", " << obj << ": " << error.message() << "\n";
  return error ? EXIT_FAILURE : EXIT_SUCCESS;
}
