// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_MAPPED_MESH_FIGURES_H
#define MESH_TO_T_SPLINE_MAPPED_MESH_FIGURES_H

#include "Approximation.h"
#include "Figures.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// Tells which edges of the refined mesh lie on edges of the input.
class Input_edge_finder {
public:
  /// \param mapped its vertices have locations on `input`
  Input_edge_finder(const Mesh& input, const Mapped& mapped) : m_input(input), m_mapped(mapped)
  {
    for (std::size_t i = input.number_of_vertices(); i < mapped.mesh().number_of_vertices(); ++i)
      m_edge_of_added_vertex.push_back(edge_of(mapped.locations()[vertex(i)]));
  }

  bool operator()(const Edge e) const
  {
    const Halfedge h = m_mapped.mesh().halfedge(e);
    Vertex v = m_mapped.mesh().source(h), w = m_mapped.mesh().target(h);
    if (!is_added(v))
      std::swap(v, w);
    if (!is_added(v))
      return m_input.halfedge(v, w) != Mesh::null_halfedge();
    const std::optional<Edge> edge = m_edge_of_added_vertex[v - m_input.number_of_vertices()];
    if (!edge)
      return false;
    if (is_added(w))
      return m_edge_of_added_vertex[w - m_input.number_of_vertices()] == edge;
    return m_input.vertex(*edge, 0) == w || m_input.vertex(*edge, 1) == w;
  }

private:
  static Vertex vertex(const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); }

  bool is_added(const Vertex v) const { return static_cast<std::size_t>(v) >= m_input.number_of_vertices(); }

  /// The edge of a location on the border of its face.
  std::optional<Edge> edge_of(const Location& location) const
  {
    const Halfedge h = m_input.halfedge(location.first);
    const std::array<Halfedge, 3> opposite_sides = {m_input.next(h), m_input.prev(h), h};
    for (std::size_t i = 0; i < 3; ++i)
      if (location.second[i] == 0)
        return m_input.edge(opposite_sides[i]);
    return std::nullopt;
  }

  const Mesh& m_input;
  const Mapped& m_mapped;
  std::vector<std::optional<Edge>> m_edge_of_added_vertex;
};

inline double diagonal_of(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// The longest side of the bounding box of the input, without what fills holes: that of the cube which encloses it.
inline double longest_side_of(const Approximation& approximation)
{
  const Mesh& mesh = approximation.mesh();
  CGAL::Bbox_3 box;
  for (const Face f : mesh.faces())
    if (approximation.is_data(f))
      box += CGAL::Polygon_mesh_processing::face_bbox(f, mesh);
  return std::max({box.x_span(), box.y_span(), box.z_span()});
}

/// The rotations and scale factors across the cut, each together with its inverse.
inline std::vector<Figures::Transition> distinct_transitions(const Mapped& mapped)
{
  constexpr double tolerance = 1e-9; // of logarithms of scale factors
  std::vector<Figures::Transition> result;
  for (const Edge e : mapped.mesh().edges()) {
    if (!mapped.cut()[e])
      continue;
    Transition t = mapped.transitions()[mapped.mesh().halfedge(e)];
    const bool is_rotation = std::abs(std::log(t.scale())) < tolerance;
    if (is_rotation ? t.quarter_turns() == 3 : t.scale() < 1)
      t = t.inverse();
    const auto position = std::find_if(result.begin(), result.end(), [&t](const Figures::Transition& other) {
      return other.quarter_turns == t.quarter_turns() && std::abs(std::log(other.scale / t.scale())) < tolerance;
    });
    if (position == result.end())
      result.push_back({t.quarter_turns(), t.scale(), 1});
    else
      ++position->edges;
  }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.scale, a.quarter_turns) < std::make_pair(b.scale, b.quarter_turns);
  });
  return result;
}

/// Largest over smallest square root of area in the plane over area in space.
inline double scale_range(const Mapped& mapped)
{
  double low = HUGE_VAL, high = 0;
  for (const Face f : mapped.mesh().faces()) {
    const Halfedge h = mapped.mesh().halfedge(f), g = mapped.mesh().next(h), k = mapped.mesh().next(g);
    const auto point = [&mapped](const Halfedge halfedge) {
      return mapped.mesh().point(mapped.mesh().target(halfedge));
    };
    const double area = std::sqrt(CGAL::squared_area(point(h), point(g), point(k)));
    const double uv_area = CGAL::area(mapped.uv()[h], mapped.uv()[g], mapped.uv()[k]);
    low = std::min(low, uv_area / area);
    high = std::max(high, uv_area / area);
  }
  return std::sqrt(high / low);
}

inline Figures::Refined refined_figures(const Mapped& mapped)
{
  Figures::Refined figures;
  figures.vertices = mapped.mesh().number_of_vertices();
  figures.faces = mapped.mesh().number_of_faces();
  figures.cut_edges = static_cast<std::size_t>(std::count_if(mapped.mesh().edges().begin(), mapped.mesh().edges().end(),
                                                             [&](const Edge e) { return mapped.cut()[e]; }));
  figures.scale_range = scale_range(mapped);
  figures.transitions = distinct_transitions(mapped);
  return figures;
}

#endif // MESH_TO_T_SPLINE_MAPPED_MESH_FIGURES_H
