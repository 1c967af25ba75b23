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
/// turns around each vertex, along 2g loops that generate the homology of the surface without its border, and along arcs
/// that join the closed curves of the border, one less than there are.
///
/// - An inner vertex has the number `k_v` of quarter turns: its cone angle is k_v pi/2, the field's index 1 - k_v/4. Only
///   cones, the inner vertices with k_v != 4, are stored.
/// - A vertex on the border has the number `k_b` of quarter turns that its angle has in the map: 2 where the border is
///   straight, 1 where it turns outwards, 3 where it turns inwards, 4 at the end of a slit. Only corners, the vertices with
///   k_b != 2, are stored.
/// - A loop is a closed strip of triangles, given as the cyclic sequence of the halfedges by which the strip enters each
///   of its faces; consecutive ones satisfy: `opposite(l[i+1])` lies on the face of `l[i]`. It has the number `k` of quarter
///   turns that its direction makes relative to the crosses, counted counter-clockwise: in the metric of the map, the sum of the
///   corner angles that it leaves on its left minus those that it leaves on its right is k pi/2.
/// - An arc is a strip of triangles from border to border. Its first halfedge is that by which it comes in across the
///   border, its last one is the border halfedge by which it leaves; between them are those by which it enters its faces.
///   It has the number of quarter turns that its direction makes relative to the crosses, from the normal of the border to
///   the normal of the border: the same sum of angles.
///
/// A signature is a value; whether it belongs to a mesh is what `check_holonomy_signature()` tells.
/// \tparam TriangleMesh a model of `HalfedgeGraph`.
template <typename TriangleMesh>
class Holonomy_signature {
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor; ///< a vertex of the mesh
  /// a halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// An inner vertex with its number of quarter turns.
  using Cone = std::pair<vertex_descriptor, int>;

  /// A vertex on the border with its number of quarter turns.
  using Corner = std::pair<vertex_descriptor, int>;

  /// A closed strip of triangles with its number of quarter turns.
  struct Loop {
    std::vector<halfedge_descriptor> halfedges; ///< the halfedges by which the strip enters its faces, in cyclic order
    int quarter_turns = 0;                      ///< k of the loop
  };

  /// A strip of triangles from border to border with its number of quarter turns.
  struct Arc {
    std::vector<halfedge_descriptor>
        halfedges;         ///< by which it enters its faces, then that by which it leaves the last one
    int quarter_turns = 0; ///< k of the arc
  };

  /// Quarter turns around a regular inner vertex.
  static constexpr int regular = 4;
  /// Quarter turns of the angle at a regular vertex on the border.
  static constexpr int regular_on_border = 2;

  /// returns k_v of an inner vertex. Complexity: constant.
  int quarter_turns(const vertex_descriptor v) const { return m_cones.number_of(v, regular); }

  /// sets k_v of an inner vertex, of any sign: `check_holonomy_signature()` is where numbers are judged.
  void set_quarter_turns(const vertex_descriptor v, const int k) { m_cones.set(v, k, regular); }

  /// returns the inner vertices with k_v != 4, in the order in which they were set.
  const std::vector<Cone>& cones() const { return m_cones.numbers(); }

  /// returns k_b of a vertex on the border. Complexity: constant.
  int corner_quarter_turns(const vertex_descriptor v) const { return m_corners.number_of(v, regular_on_border); }

  /// sets k_b of a vertex on the border, of any sign.
  void set_corner_quarter_turns(const vertex_descriptor v, const int k) { m_corners.set(v, k, regular_on_border); }

  /// returns the vertices on the border with k_b != 2, in the order in which they were set.
  const std::vector<Corner>& corners() const { return m_corners.numbers(); }

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

  /// adds an arc behind those that are there.
  void add_arc(std::vector<halfedge_descriptor> halfedges, const int quarter_turns)
  {
    m_arcs.push_back({std::move(halfedges), quarter_turns});
  }

  /// sets the number of quarter turns of arc `i`. \pre `i` < `arcs().size()`
  void set_arc_quarter_turns(const std::size_t i, const int k)
  {
    CGAL_precondition(i < m_arcs.size());
    m_arcs[i].quarter_turns = k;
  }

  /// returns the arcs in the order in which they were added.
  const std::vector<Arc>& arcs() const { return m_arcs; }

  /// removes all cones, corners, loops and arcs.
  void clear() { *this = Holonomy_signature(); }

private:
  // The vertices whose numbers are not regular, in the order in which they were set.
  class Numbered_vertices {
  public:
    int number_of(const vertex_descriptor v, const int regular_number) const
    {
      const auto position = m_position.find(v);
      return position == m_position.end() ? regular_number : m_numbers[position->second].second;
    }

    void set(const vertex_descriptor v, const int k, const int regular_number)
    {
      const auto position = m_position.find(v);
      if (position != m_position.end()) {
        if (k == regular_number)
          remove(position->second);
        else
          m_numbers[position->second].second = k;
      }
      else if (k != regular_number) {
        m_position.emplace(v, m_numbers.size());
        m_numbers.emplace_back(v, k);
      }
    }

    const std::vector<std::pair<vertex_descriptor, int>>& numbers() const { return m_numbers; }

  private:
    void remove(const std::size_t i)
    {
      m_position.erase(m_numbers[i].first);
      m_numbers.erase(m_numbers.begin() + static_cast<std::ptrdiff_t>(i));
      for (std::size_t j = i; j < m_numbers.size(); ++j)
        m_position[m_numbers[j].first] = j;
    }

    std::vector<std::pair<vertex_descriptor, int>> m_numbers;
    std::unordered_map<vertex_descriptor, std::size_t> m_position;
  };

  Numbered_vertices m_cones, m_corners;
  std::vector<Loop> m_loops;
  std::vector<Arc> m_arcs;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_H
