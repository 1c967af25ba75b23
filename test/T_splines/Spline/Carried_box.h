// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_CARRIED_BOX_H
#define T_SPLINES_TEST_SPLINE_CARRIED_BOX_H

#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/Tracing/carry_surface.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>

namespace spline_tests {

/// The surface of the cube [-1, 1]^3, n x n squares on each side, or a square alone: bent in space, and with the
/// T-mesh of its sides. Its map is known: each side lies in a chart of its own.
struct Carried_box {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using FT = CGAL::Exact_rational;

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv =
      mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  CGAL::T_splines::T_mesh<Kernel::Point_3, FT> t_mesh;
  CGAL::T_splines::Carried_surface<Mesh> surface;

  /// \param bend where a point of the cube goes
  template <typename Bend>
  Carried_box(const int n, const Bend& bend, const int number_of_sides = 6)
  {
    // Per side: normal, u and v direction, as axis and sign.
    for (int side = 0; side < number_of_sides; ++side) {
      const int axis = side / 2, sign = side % 2 == 0 ? 1 : -1;
      const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](const int a, const int b) {
            std::array<int, 3> p;
            p[axis] = sign * n;
            p[u_axis] = sign * (2 * a - n);
            p[v_axis] = 2 * b - n;
            return p;
          };
          add_triangle(corner, {{{i, j}, {i + 1, j}, {i + 1, j + 1}}}, n, bend);
          add_triangle(corner, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}}, n, bend);
        }
    }
    CGAL::T_splines::Seamless_map<Mesh, FT> map(mesh);
    REQUIRE(CGAL::T_splines::make_exactly_seamless(mesh, uv, map).success());
    const auto anchors =
        t_mesh.graph().add_property_map<Mesh::Face_index, CGAL::T_splines::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
    REQUIRE(CGAL::T_splines::trace_motorcycle_graph(map, t_mesh, CGAL::T_splines::parameters::face_anchor_map(anchors))
                .success());
    surface = CGAL::T_splines::carry_surface(map, t_mesh, anchors);
  }
  Carried_box(const Carried_box&) = delete;

private:
  template <typename Corner, typename Bend>
  void add_triangle(const Corner& corner, const std::array<std::array<int, 2>, 3>& places, const int n,
                    const Bend& bend)
  {
    std::array<Mesh::Vertex_index, 3> v;
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 3> p = corner(places[k][0], places[k][1]);
      const auto inserted = m_vertices.emplace(p, Mesh::Vertex_index());
      if (inserted.second)
        inserted.first->second = mesh.add_vertex(bend(Kernel::Point_3(p[0], p[1], p[2]), n));
      v[k] = inserted.first->second;
    }
    const Mesh::Face_index f = mesh.add_face(v[0], v[1], v[2]);
    REQUIRE(f != Mesh::null_face());
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      for (int k = 0; k < 3; ++k)
        if (mesh.target(h) == v[k])
          uv[h] = Kernel::Point_2(places[k][0], places[k][1]);
  }

  std::map<std::array<int, 3>, Mesh::Vertex_index> m_vertices;
};

/// From the cube towards a sphere of radius 1, with bumps.
inline Carried_box::Kernel::Point_3 bumpy(const Carried_box::Kernel::Point_3& p, const int n)
{
  const double x = p.x() / n, y = p.y() / n, z = p.z() / n;
  const double r = (1 + 0.1 * std::sin(4 * x) * std::cos(3 * y + z)) / std::sqrt(x * x + y * y + z * z);
  return {r * x, r * y, r * z};
}

/// A box as it is, 5 times as wide as it is high.
inline Carried_box::Kernel::Point_3 plate(const Carried_box::Kernel::Point_3& p, const int n)
{
  return {p.x() / n, p.y() / n, p.z() / (5. * n)};
}

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_CARRIED_BOX_H
