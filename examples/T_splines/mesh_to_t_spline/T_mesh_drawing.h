// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_MESH_DRAWING_H
#define MESH_TO_T_SPLINE_T_MESH_DRAWING_H

#include "Approximation.h"
#include "t_mesh_figures.h"

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Whether a face goes straight on at `v`. (On the border the outside has no corners.)
template <typename TMesh>
bool is_t_joint(const TMesh& t_mesh, const Graph::Vertex_index v)
{
  const Graph& graph = t_mesh.graph();
  for (const auto h : CGAL::halfedges_around_target(graph.halfedge(v), graph))
    if (!graph.is_border(h) && !t_mesh.corners()[h])
      return true;
  return false;
}

template <typename TMesh>
T_mesh_figures figures_of(const TMesh& t_mesh)
{
  using Knot = typename TMesh::FT;
  const Graph& graph = t_mesh.graph();
  T_mesh_figures figures;
  figures.vertices = graph.number_of_vertices();
  figures.edges = graph.number_of_edges();
  figures.faces = graph.number_of_faces();
  for (const Graph::Vertex_index v : graph.vertices())
    figures.t_joints += is_t_joint(t_mesh, v);
  const CGAL::T_splines::T_mesh_coordinates coordinates(t_mesh);
  std::vector<double> ratios;
  for (const Graph::Face_index f : graph.faces()) {
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

inline T_mesh_drawing drawing_of(const Placed_t_mesh& t)
{
  const Graph& graph = t.t_mesh().graph();
  T_mesh_drawing drawing;
  for (const Graph::Edge_index e : graph.edges()) {
    drawing.points.insert(drawing.points.end(), t.polylines()[e].begin(), t.polylines()[e].end());
    drawing.sizes.push_back(static_cast<std::uint32_t>(t.polylines()[e].size()));
  }
  for (const Graph::Vertex_index v : graph.vertices())
    if (is_t_joint(t.t_mesh(), v))
      drawing.t_joints.push_back(graph.point(v));
  return drawing;
}

#endif // MESH_TO_T_SPLINE_T_MESH_DRAWING_H
