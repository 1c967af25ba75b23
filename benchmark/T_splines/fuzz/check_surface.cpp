// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The two-sided distance between a mesh and a T-spline surface, and the places where the surface turns over, measured
// from the files alone and without any code of the package but the names that differ between versions of CGAL.

#include "../Arguments.h"
#include "Bezier_patches.h"
#include "Random.h"

#include <CGAL/T_splines/internal/cgal_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using fuzz::Kernel;
using fuzz::Patch;
using fuzz::Patch_point;
using fuzz::Point;
using fuzz::Vector;
using Mesh = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::T_splines::internal::AABB_traits_for_3<Kernel, Primitive>>;

static const char usage[] =
    "usage: check_surface MESH T_SPLINE.vtu [--tolerance X] [--samples N] [--seed N]\n"
    "\n"
    "Measures the distance from the surface to the mesh and from the mesh to the surface at random places, by the\n"
    "longest side of the mesh's bounding box, and counts the places where the surface's normal is 90 degrees or more\n"
    "from that of every triangle of the mesh within the tolerance. Ends with 0 if both distances are within the\n"
    "tolerance and there is no such place, with 1 if not, with 2 if a file cannot be read.\n"
    "  --tolerance X  (default 0.005)\n"
    "  --samples N    about how many either way (default 60000)\n"
    "  --seed N       (default 1)\n";

/// The maximum of distances, and their root of the mean square over an area.
struct Distances {
  double sum = 0, area = 0, maximum = 0;
  void add(const double distance, const double area_of_sample)
  {
    sum += area_of_sample * distance * distance;
    area += area_of_sample;
    maximum = std::max(maximum, distance);
  }
  double rms() const { return std::sqrt(sum / area); }
};

/// A cube around a point; a sphere would leave out what is inside of it.
static Kernel::Iso_cuboid_3 cube_around(const Point& p, const double radius)
{
  const Vector diagonal(radius, radius, radius);
  return Kernel::Iso_cuboid_3(p - diagonal, p + diagonal);
}

/// The mesh, and how far places are from it.
class Mesh_side {
public:
  explicit Mesh_side(const Mesh& mesh)
    : m_mesh(mesh),
      m_tree(faces(mesh).begin(), faces(mesh).end(), mesh),
      m_normals(num_faces(mesh))
  {
    for (const Mesh::Face_index f : faces(mesh))
      m_normals[f] = PMP::compute_face_normal(f, mesh);
  }

  double distance(const Point& p) const { return std::sqrt(m_tree.squared_distance(p)); }

  /// returns whether a triangle about as near as the distance has a normal on the side of the given one.
  bool has_normal_near(const Point& p, const Vector& normal, const double distance) const
  {
    if (m_normals[m_tree.closest_point_and_primitive(p).second] * normal > 0)
      return true;
    std::vector<Mesh::Face_index> near;
    m_tree.all_intersected_primitives(cube_around(p, distance), std::back_inserter(near));
    return std::any_of(near.begin(), near.end(), [&](const auto f) { return m_normals[f] * normal > 0; });
  }

  /// calls a function with places and their areas: corners and midpoints of edges, of none, and places inside.
  template <typename Function>
  void for_each_sample(const std::size_t samples, fuzz::Random& random, const Function& function) const
  {
    for (const Mesh::Vertex_index v : vertices(m_mesh))
      function(m_mesh.point(v), 0);
    for (const Mesh::Edge_index e : edges(m_mesh))
      function(CGAL::midpoint(m_mesh.point(source(e, m_mesh)), m_mesh.point(target(e, m_mesh))), 0);
    const double share = static_cast<double>(samples) / PMP::area(m_mesh);
    for (const Mesh::Face_index f : faces(m_mesh)) {
      const Mesh::Halfedge_index h = halfedge(f, m_mesh);
      const Point& a = m_mesh.point(source(h, m_mesh));
      const Vector b = m_mesh.point(target(h, m_mesh)) - a, c = m_mesh.point(target(next(h, m_mesh), m_mesh)) - a;
      for (double n = share * PMP::face_area(f, m_mesh) + random.unit(); n >= 1; --n) {
        const double s = random.unit(), t = random.unit();
        function(s + t <= 1 ? a + s * b + t * c : a + (1 - s) * b + (1 - t) * c, 1 / share);
      }
    }
  }

private:
  const Mesh& m_mesh;
  Tree m_tree;
  std::vector<Vector> m_normals;
};

/// The surface, and how far places are from it: the nearest triangle of a tessellation is where Newton's method starts.
class Surface_side {
public:
  explicit Surface_side(const std::vector<Patch>& patches)
    : m_patches(patches),
      m_parts(std::clamp(static_cast<int>(std::sqrt(2e5 / static_cast<double>(patches.size()))), 2, 40))
  {
    const auto corner = [&](const Patch& patch, const int i, const int j) {
      return m_cells.add_vertex(patch(static_cast<double>(i) / m_parts, static_cast<double>(j) / m_parts).point);
    };
    for (const Patch& patch : patches)
      for (int i = 0; i < m_parts; ++i)
        for (int j = 0; j < m_parts; ++j) {
          const auto a = corner(patch, i, j), b = corner(patch, i + 1, j + 1);
          m_cells.add_face(a, corner(patch, i + 1, j), b);
          m_cells.add_face(a, b, corner(patch, i, j + 1));
        }
    m_tree.insert(faces(m_cells).begin(), faces(m_cells).end(), m_cells);
  }

  /// returns the distance, or an upper bound on it if that is not more than `enough`.
  double distance(const Point& p, const double enough) const
  {
    double distance = project_from(m_tree.closest_point_and_primitive(p).second, p);
    if (distance <= enough)
      return distance;
    // The foot may be on another patch, and where a patch turns over there are several: all that is as near is tried.
    std::vector<Mesh::Face_index> near;
    m_tree.all_intersected_primitives(cube_around(p, 1.1 * distance), std::back_inserter(near));
    for (const Mesh::Face_index triangle : near)
      distance = std::min(distance, project_from(triangle, p));
    return distance;
  }

private:
  /// projects, starting in the middle of the cell of which the triangle is a half.
  double project_from(const Mesh::Face_index triangle, const Point& p) const
  {
    const auto parts = static_cast<std::size_t>(m_parts), cell = static_cast<std::size_t>(triangle) / 2;
    const double u = (static_cast<double>(cell / parts % parts) + 0.5) / m_parts;
    const double v = (static_cast<double>(cell % parts) + 0.5) / m_parts;
    return project(m_patches[cell / (parts * parts)], p, u, v);
  }

  /// Gauss-Newton steps that stay in the unit square; a step that does not come nearer is halved.
  static double project(const Patch& patch, const Point& p, double u, double v)
  {
    Patch_point x = patch(u, v);
    double distance = CGAL::squared_distance(p, x.point);
    for (int iteration = 0, halvings = 0; iteration < 30 && halvings < 8; ++iteration) {
      const Vector r = p - x.point;
      const double e = x.du * x.du, f = x.du * x.dv, g = x.dv * x.dv, a = r * x.du, b = r * x.dv;
      const bool fixes_u = (u <= 0 && a < 0) || (u >= 1 && a > 0), fixes_v = (v <= 0 && b < 0) || (v >= 1 && b > 0);
      const double determinant = e * g - f * f;
      double du = fixes_u ? 0 : a / e, dv = fixes_v ? 0 : b / g;
      if (!fixes_u && !fixes_v && determinant > 1e-12 * e * g) {
        du = (g * a - f * b) / determinant;
        dv = (e * b - f * a) / determinant;
      }
      if ((u <= 0 && du < 0) || (u >= 1 && du > 0)) { // the step leaves the square where the gradient does not
        du = 0;
        dv = fixes_v ? 0 : b / g;
      }
      else if ((v <= 0 && dv < 0) || (v >= 1 && dv > 0)) {
        dv = 0;
        du = fixes_u ? 0 : a / e;
      }
      bool is_nearer = false;
      for (double step = 1; !is_nearer && halvings < 8; step /= 2) {
        const double new_u = std::clamp(u + step * du, 0., 1.), new_v = std::clamp(v + step * dv, 0., 1.);
        const Patch_point y = patch(new_u, new_v);
        const double new_distance = CGAL::squared_distance(p, y.point);
        is_nearer = new_distance < distance * (1 - 1e-9);
        if (is_nearer) {
          u = new_u;
          v = new_v;
          x = y;
          distance = new_distance;
          halvings = 0;
        }
        else
          ++halvings;
      }
    }
    return std::sqrt(distance);
  }

  const std::vector<Patch>& m_patches;
  int m_parts;
  Mesh m_cells; // each patch is divided into squares, each of these into two triangles
  Tree m_tree;
};

struct Findings {
  Distances to_mesh, to_surface;
  std::size_t folds = 0;
};

static Findings measure(const Mesh& mesh, const std::vector<Patch>& patches, const double tolerance,
                        const std::size_t samples, fuzz::Random& random)
{
  Findings found;
  const Mesh_side mesh_side(mesh);
  const int parts = std::max(4, static_cast<int>(std::sqrt(static_cast<double>(samples / patches.size()))));
  for (const Patch& patch : patches)
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double u = (i + random.unit()) / parts, v = (j + random.unit()) / parts;
        const Patch_point x = patch(u, v);
        const Vector normal = CGAL::cross_product(x.du, x.dv);
        found.to_mesh.add(mesh_side.distance(x.point), std::sqrt(normal.squared_length()) / (parts * parts));
        found.folds += !mesh_side.has_normal_near(x.point, normal, tolerance);
      }
  const Surface_side surface_side(patches);
  mesh_side.for_each_sample(samples, random, [&](const Point& p, const double area) {
    found.to_surface.add(surface_side.distance(p, found.to_surface.maximum), area);
  });
  return found;
}

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {}, {"--tolerance", "--samples", "--seed"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  Mesh mesh;
  std::vector<Patch> patches;
  if (arguments.files().size() == 2 && PMP::IO::read_polygon_mesh(arguments.files()[0], mesh) &&
      PMP::triangulate_faces(mesh) && !mesh.is_empty())
    patches = fuzz::read_patches(arguments.files()[1]);
  if (patches.empty()) {
    std::cerr << "a mesh and a t_spline.vtu are expected\n";
    return 2;
  }
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double side = std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  const double tolerance = arguments.real("--tolerance", 0.005);
  fuzz::Random random(static_cast<std::uint64_t>(arguments.integer("--seed", 1)));
  const auto samples = static_cast<std::size_t>(arguments.integer("--samples", 60000));
  const Findings found = measure(mesh, patches, tolerance * side, samples, random);
  const double to_mesh = found.to_mesh.maximum / side, to_surface = found.to_surface.maximum / side;
  std::printf(
      "surface to mesh: rms %.4g %%, maximum %.4g %%; mesh to surface: rms %.4g %%, maximum %.4g %%; folds: %zu\n",
      100 * found.to_mesh.rms() / side, 100 * to_mesh, 100 * found.to_surface.rms() / side, 100 * to_surface,
      found.folds);
  return to_mesh <= tolerance && to_surface <= tolerance && found.folds == 0 ? 0 : 1;
}
