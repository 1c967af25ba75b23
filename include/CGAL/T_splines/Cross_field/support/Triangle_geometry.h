// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_TRIANGLE_GEOMETRY_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_TRIANGLE_GEOMETRY_H

#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Angles, lengths, areas and normals of a triangle mesh in index arrays, and the frame of each face: the x-axis of a face has
/// the direction of `halfedge_of_face(f)`, the y-axis is a quarter turn counter-clockwise of it.
///
/// All lengths are in the unit `m_unit`, which is chosen such that squares and cubes neither overflow nor vanish.
/// A face that is collinear to working precision gets the angles 0, 0, pi, a normal perpendicular to its longest
/// edge, and an area that is tiny but positive.
struct Triangle_geometry {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;

  std::vector<Vector_3> m_edge_vector; ///< per edge: along its halfedge of even index
  std::vector<double> m_edge_length;   ///< per edge
  std::vector<double> m_corner_angle;  ///< per halfedge: the angle of its face at its target; 0 at border halfedges
  std::vector<double> m_area;          ///< per face
  std::vector<Vector_3> m_normal;      ///< per face: of length 1
  double m_unit = 1;

  /// The vector from the source to the target of `h`.
  Vector_3 vector(const int h) const
  {
    const Vector_3& v = m_edge_vector[edge_of(h)];
    return is_along_edge(h) ? v : -v;
  }

  Vector_3 x_axis(const Triangulation_connectivity& mesh, const int f) const
  {
    const int h = mesh.halfedge_of_face(f);
    return vector(h) / m_edge_length[edge_of(h)];
  }

  Vector_3 y_axis(const Triangulation_connectivity& mesh, const int f) const
  {
    return CGAL::cross_product(m_normal[f], x_axis(mesh, f));
  }

  /// The direction of `h` in the frame of its face, as an angle; exact sums of corner angles.
  double direction(const Triangulation_connectivity& mesh, const int h) const
  {
    const int first = mesh.halfedge_of_face(mesh.face(h));
    if (h == first)
      return 0;
    if (h == mesh.next(first))
      return CGAL_PI - m_corner_angle[first];
    return m_corner_angle[h] - CGAL_PI;
  }
};

inline void compute_face_geometry(const Triangulation_connectivity& mesh, const int f, Triangle_geometry& geometry)
{
  using Vector_3 = Triangle_geometry::Vector_3;
  int h = mesh.halfedge_of_face(f);
  for (int corner = 0; corner < 3; ++corner, h = mesh.next(h)) {
    const Vector_3 a = geometry.vector(mesh.next(h)), b = -geometry.vector(h);
    const Vector_3 normal = CGAL::cross_product(a, b);
    geometry.m_corner_angle[h] = std::atan2(CGAL::approximate_sqrt(normal.squared_length()), a * b);
  }
  for (const int g : {mesh.next(h), mesh.previous(h)})
    if (geometry.m_edge_length[edge_of(g)] > geometry.m_edge_length[edge_of(h)])
      h = g;
  const Vector_3 longest = geometry.vector(h);
  // The corner opposite to the longest edge has the two shorter ones: there the cross product loses least.
  Vector_3 normal = CGAL::cross_product(geometry.vector(mesh.next(h)), geometry.vector(mesh.previous(h)));
  double double_area = CGAL::approximate_sqrt(normal.squared_length());
  constexpr double unit_of_rounding = 1e-16; // a smaller area has no digits, and might be 0
  const double smallest = unit_of_rounding * longest.squared_length();
  if (!(double_area > 0)) {
    const Vector_3 axis =
        std::abs(longest.x()) < 0.5 * geometry.m_edge_length[edge_of(h)] ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    normal = CGAL::cross_product(longest, axis);
    double_area = CGAL::approximate_sqrt(normal.squared_length());
    geometry.m_area[f] = 0.5 * smallest;
  }
  else
    geometry.m_area[f] = 0.5 * (std::max)(double_area, smallest);
  geometry.m_normal[f] = normal / double_area;
}

/// computes the geometry of a mesh without zero-length edges; borders are allowed.
template <typename FaceGraph, typename VertexPointMap>
Triangle_geometry triangle_geometry(const Mesh_indexing<FaceGraph>& indexing, const Triangulation_connectivity& mesh,
                                    const VertexPointMap& points)
{
  using Vector_3 = Triangle_geometry::Vector_3;
  Triangle_geometry geometry;
  geometry.m_edge_vector.resize(mesh.number_of_edges());
  geometry.m_edge_length.resize(mesh.number_of_edges());
  geometry.m_corner_angle.assign(mesh.number_of_halfedges(), 0.);
  geometry.m_area.resize(mesh.number_of_faces());
  geometry.m_normal.resize(mesh.number_of_faces());
  double largest = 0;
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto& p = get(points, indexing.vertex(mesh.source(halfedge_of_edge(e))));
    const auto& q = get(points, indexing.vertex(mesh.target(halfedge_of_edge(e))));
    const Vector_3 v(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()), CGAL::to_double(q.z() - p.z()));
    geometry.m_edge_vector[e] = v;
    largest = (std::max)({largest, std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  }
  geometry.m_unit = std::ldexp(1., std::ilogb(largest)); // a power of two: dividing by it is exact
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    geometry.m_edge_vector[e] = geometry.m_edge_vector[e] / geometry.m_unit;
    geometry.m_edge_length[e] = CGAL::approximate_sqrt(geometry.m_edge_vector[e].squared_length());
  }
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    compute_face_geometry(mesh, f, geometry);
  return geometry;
}

/// The angle between the normals of the two faces of an edge, positive where the surface is convex.
inline double dihedral_angle(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry, const int e)
{
  const int h = halfedge_of_edge(e), f = mesh.face(h), g = mesh.face(opposite(h));
  if (f == Triangulation_connectivity::null || g == Triangulation_connectivity::null)
    return 0;
  const Triangle_geometry::Vector_3 axis = geometry.m_edge_vector[e] / geometry.m_edge_length[e];
  return std::atan2(CGAL::cross_product(geometry.m_normal[g], geometry.m_normal[f]) * axis,
                    geometry.m_normal[f] * geometry.m_normal[g]);
}

/// The lengths of dual edges, from barycenter to barycenter by the midpoint of the edge.
inline std::vector<double> dual_edge_lengths(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
{
  std::vector<double> result(mesh.number_of_edges(), 0.);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.face(h) == Triangulation_connectivity::null)
      continue;
    // The barycenter lies on the median of the edge, at a third of its length.
    const Triangle_geometry::Vector_3 twice_median = geometry.vector(mesh.next(h)) - geometry.vector(mesh.previous(h));
    result[edge_of(h)] += CGAL::approximate_sqrt(twice_median.squared_length()) / 6;
  }
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_TRIANGLE_GEOMETRY_H
