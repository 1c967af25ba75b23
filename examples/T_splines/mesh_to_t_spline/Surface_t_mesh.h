// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_SURFACE_T_MESH_H
#define MESH_TO_T_SPLINE_SURFACE_T_MESH_H

#include "Refined_map.h"
#include "t_mesh_figures.h"

#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using Exact_number = CGAL::Exact_rational;
using T_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Anchor = CGAL::T_splines::T_mesh_anchor<Mesh, Exact_number>;

/// A T-mesh with exact knots, and how it lies on the surface.
struct Surface_t_mesh {
  T_mesh mesh;
  T_mesh::Property_map<T_mesh::Halfedge_index, Exact_number> knots =
      mesh.add_property_map<T_mesh::Halfedge_index, Exact_number>("h:knot").first;
  T_mesh::Property_map<T_mesh::Halfedge_index, bool> corners =
      mesh.add_property_map<T_mesh::Halfedge_index, bool>("h:is_corner", false).first;
  T_mesh::Property_map<T_mesh::Edge_index, std::vector<Kernel::Point_3>> polylines =
      mesh.add_property_map<T_mesh::Edge_index, std::vector<Kernel::Point_3>>("e:polyline").first;
  T_mesh::Property_map<T_mesh::Face_index, Anchor> anchors =
      mesh.add_property_map<T_mesh::Face_index, Anchor>("f:anchor").first; ///< of the motorcycle graph only
  CGAL::T_splines::Carried_surface<T_mesh> surface;                        ///< the mesh, in the faces of the T-mesh

  Surface_t_mesh() = default;
  Surface_t_mesh(const Surface_t_mesh&) = delete; // the property maps are those of this mesh
  Surface_t_mesh& operator=(const Surface_t_mesh&) = delete;
};

/// Whether a face goes straight on at `v`. (On the border the outside has no corners.)
/// \tparam Any_t_mesh a T-mesh with its knots and corners, as `Surface_t_mesh` is
template <typename Any_t_mesh>
bool is_t_joint(const Any_t_mesh& t, const T_mesh::Vertex_index v)
{
  for (const auto h : CGAL::halfedges_around_target(t.mesh.halfedge(v), t.mesh))
    if (!t.mesh.is_border(h) && !t.corners[h])
      return true;
  return false;
}

template <typename Any_t_mesh>
T_mesh_figures figures_of(const Any_t_mesh& t)
{
  using Knot = typename boost::property_traits<decltype(t.knots)>::value_type;
  T_mesh_figures figures;
  figures.vertices = t.mesh.number_of_vertices();
  figures.edges = t.mesh.number_of_edges();
  figures.faces = t.mesh.number_of_faces();
  for (const T_mesh::Vertex_index v : t.mesh.vertices())
    figures.t_joints += is_t_joint(t, v);
  const CGAL::T_splines::T_mesh_coordinates coordinates(t.mesh, t.knots, t.corners);
  std::vector<double> ratios;
  for (const T_mesh::Face_index f : t.mesh.faces()) {
    const double ratio = CGAL::to_double(Knot(coordinates.width(f) / coordinates.height(f)));
    ratios.push_back(std::max(ratio, 1 / ratio));
    const auto octave = static_cast<std::size_t>(std::max(0, std::ilogb(ratios.back())));
    figures.aspect_histogram.resize(std::max(figures.aspect_histogram.size(), octave + 1));
    ++figures.aspect_histogram[octave];
  }
  if (!ratios.empty()) {
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
    figures.median_aspect_ratio = ratios[ratios.size() / 2];
    figures.worst_aspect_ratio = *std::max_element(ratios.begin(), ratios.end());
  }
  return figures;
}

/// What the page draws of a T-mesh.
struct T_mesh_drawing {
  std::vector<Kernel::Point_3> points; ///< of all polylines, one after the other
  std::vector<std::uint32_t> sizes;    ///< per polyline: its number of points
  std::vector<Kernel::Point_3> t_joints;
};

inline T_mesh_drawing drawing_of(const Surface_t_mesh& t)
{
  T_mesh_drawing drawing;
  for (const T_mesh::Edge_index e : t.mesh.edges()) {
    drawing.points.insert(drawing.points.end(), t.polylines[e].begin(), t.polylines[e].end());
    drawing.sizes.push_back(static_cast<std::uint32_t>(t.polylines[e].size()));
  }
  for (const T_mesh::Vertex_index v : t.mesh.vertices())
    if (is_t_joint(t, v))
      drawing.t_joints.push_back(t.mesh.point(v));
  return drawing;
}

#endif // MESH_TO_T_SPLINE_SURFACE_T_MESH_H
