// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_H
#define CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_H

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// The holonomy signature of a cross field or of a seamless similarity map ([CZ17] section 2.1): how often a cross
/// turns around each vertex and along 2g loops that generate the homology of a closed surface.
///
/// - A vertex has the number `k_v` of quarter turns: its cone angle is k_v pi/2, the field's index 1 - k_v/4. Only
///   cones, the vertices with k_v != 4, are stored.
/// - A loop is a closed strip of triangles, given as the cyclic sequence of the halfedges by which the strip enters each
///   of its faces; consecutive ones satisfy: `opposite(l[i+1])` lies on the face of `l[i]`. It has the number `k` of quarter
///   turns that its direction makes relative to the crosses, counted counter-clockwise: in the metric of the map, the sum of the
///   corner angles that it leaves on its left minus those that it leaves on its right is k pi/2.
///
/// A signature is a value; whether it belongs to a mesh is what `check_holonomy_signature()` tells.
/// \tparam TriangleMesh a model of `HalfedgeGraph`.
template <typename TriangleMesh>
class Holonomy_signature {
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor; ///< a vertex of the mesh
  /// a halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// A vertex with its number of quarter turns.
  using Cone = std::pair<vertex_descriptor, int>;

  /// A closed strip of triangles with its number of quarter turns.
  struct Loop {
    std::vector<halfedge_descriptor> halfedges; ///< the halfedges by which the strip enters its faces, in cyclic order
    int quarter_turns = 0;                      ///< k of the loop
  };

  /// Quarter turns around a regular vertex.
  static constexpr int regular = 4;

  /// returns k_v. Complexity: constant.
  int quarter_turns(const vertex_descriptor v) const
  {
    const auto position = m_cone_of_vertex.find(v);
    return position == m_cone_of_vertex.end() ? regular : m_cones[position->second].second;
  }

  /// sets k_v, of any sign: `check_holonomy_signature()` is where numbers are judged.
  void set_quarter_turns(const vertex_descriptor v, const int k)
  {
    const auto position = m_cone_of_vertex.find(v);
    if (position != m_cone_of_vertex.end()) {
      if (k == regular)
        remove_cone(position->second);
      else
        m_cones[position->second].second = k;
    }
    else if (k != regular) {
      m_cone_of_vertex.emplace(v, m_cones.size());
      m_cones.emplace_back(v, k);
    }
  }

  /// returns the vertices with k_v != 4, in the order in which they were set.
  const std::vector<Cone>& cones() const { return m_cones; }

  /// adds a loop behind those that are there.
  void add_loop(std::vector<halfedge_descriptor> halfedges, const int quarter_turns)
  {
    m_loops.push_back({std::move(halfedges), quarter_turns});
  }

  /// sets the number of quarter turns of loop `i`. \pre `i` < `loops().size()`
  void set_loop_quarter_turns(const std::size_t i, const int k)
  {
    CGAL_precondition(i < m_loops.size());
    m_loops[i].quarter_turns = k;
  }

  /// returns the loops in the order in which they were added.
  const std::vector<Loop>& loops() const { return m_loops; }

  /// removes all cones and loops.
  void clear()
  {
    m_cones.clear();
    m_cone_of_vertex.clear();
    m_loops.clear();
  }

private:
  void remove_cone(const std::size_t i)
  {
    m_cone_of_vertex.erase(m_cones[i].first);
    m_cones.erase(m_cones.begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t j = i; j < m_cones.size(); ++j)
      m_cone_of_vertex[m_cones[j].first] = j;
  }

  std::vector<Cone> m_cones;
  std::unordered_map<vertex_descriptor, std::size_t> m_cone_of_vertex;
  std::vector<Loop> m_loops;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_H
