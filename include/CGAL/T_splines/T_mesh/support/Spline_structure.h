// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_SPLINE_STRUCTURE_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_SPLINE_STRUCTURE_H

#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>
#include <CGAL/T_splines/T_mesh/internal/Basis_support.h>
#include <CGAL/T_splines/T_mesh/internal/Ring_controls.h>
#include <CGAL/T_splines/T_mesh/support/Basis_knots.h>
#include <CGAL/T_splines/T_mesh/support/Regular_rings.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What makes a T-mesh not spline compatible, in indices.
struct Spline_defect {
  Spline_compatibility_status status = Spline_compatibility_status::SPLINE_COMPATIBLE;
  int vertex = -1, extraordinary_vertex = -1, face = -1;

  explicit operator bool() const { return status != Spline_compatibility_status::SPLINE_COMPATIBLE; }
};

/// The basis functions of an admissible T-mesh: extraordinary vertices with their rings, knots, supports; and whether
/// the conditions of [CZ17] 4.1.3 hold.
///
/// The T-mesh is cut along its creases: the parts on both sides have the control points of the crease in common, and
/// nothing else. So vertices are those of `T_mesh_arrays::cut_along_creases()`, in all that follows.
///
/// Rays are followed in the number type of the knots, so that they hit vertices exactly if the knots are exact.
/// Transitions are composed in the number type of the surface: the knots that the basis functions have do not depend on
/// them, and what round-off does to the rim of a support does not matter, where the function vanishes to second order.
/// \tparam KnotFT the number type of the knots
/// \tparam FT the number type of the surface
template <typename KnotFT, typename FT = KnotFT>
class Spline_structure {
public:
  using Knot_arrays = T_mesh_arrays<KnotFT>;
  using Arrays = T_mesh_arrays<FT>;
  using Status = Spline_compatibility_status;
  static constexpr int none = -1;

  /// \pre the knots are admissible
  /// \tparam TMesh a `T_mesh_view`
  /// \param progress asked by what looks at all vertices; it must outlive this. If it is interrupted, the defect that is
  ///        found is INTERRUPTED
  template <typename TMesh>
  Spline_structure(const Mesh_indexing<typename TMesh::Graph>& indexing, const TMesh& t_mesh, Progress& progress)
    : m_progress(progress),
      m_knot_arrays(indexing, t_mesh)
  {
    m_progress.go_on();
    if constexpr (!std::is_same<KnotFT, FT>::value)
      m_arrays = Arrays(indexing, t_mesh);
    classify_originals();
    if (m_knot_arrays.has_creases()) {
      m_uncut = arrays();
      m_knot_arrays = m_knot_arrays.cut_along_creases();
      m_arrays = m_arrays.cut_along_creases();
    }
    classify_vertices();
  }
  Spline_structure(const Spline_structure&) = delete; // the rings refer to the arrays
  Spline_structure& operator=(const Spline_structure&) = delete;

  const Arrays& arrays() const
  {
    if constexpr (std::is_same<KnotFT, FT>::value)
      return m_knot_arrays;
    else
      return m_arrays;
  }

  const Knot_arrays& knot_arrays() const { return m_knot_arrays; }
  /// The vertex of the T-mesh of which a vertex is a part.
  int vertex_in_graph(const int v) const { return m_knot_arrays.original_vertex(v); }

  /// A defect with its vertices as those of the T-mesh.
  Spline_defect in_graph(Spline_defect defect) const
  {
    for (int* const v : {&defect.vertex, &defect.extraordinary_vertex})
      if (*v >= 0)
        *v = vertex_in_graph(*v);
    return defect;
  }

  /// Those of the T-mesh with its creases, before it was cut.
  const Arrays& uncut_arrays() const { return m_uncut ? *m_uncut : arrays(); }
  bool has_border() const { return m_has_border; }
  const std::vector<int>& extraordinary_vertices() const { return m_extraordinary_vertices; }
  bool is_extraordinary(const int v) const { return m_kinds[v].is_extraordinary; }
  bool is_isolated(const int v) const { return m_valence[v] == 0; } ///< it has no faces, and no basis function

  /// Whether lines along the border end at a vertex of it.
  bool is_border_corner(const int v) const
  {
    return !is_isolated(v) && m_knot_arrays.is_border_vertex(v) && (m_valence[v] != 2 || m_kinds[v].ends_lines);
  }

  /// Whether a crease ends at an extraordinary vertex of a border that turns inwards, and is on both sides of it: or else,
  /// whether the border of the surface turns by a full turn or more.
  bool is_end_of_slit(const int v) const
  {
    const int original = m_knot_arrays.original_vertex(v);
    if (m_number_of_creases[original] == 0)
      return m_valence[v] > 3;
    return m_number_of_creases[original] == 1 && !m_kinds[v].is_on_border;
  }

  /// The halfedge of a face that ends at an extraordinary vertex, where the face has a corner; or `none`.
  int corner_of_face(const int f) const { return m_corner_of_face[f]; }

  /// \pre `check_vertices()` and `check_rings()` found no defect
  const std::vector<Regular_rings<KnotFT>>& rings() const { return m_rings; }

  /// Finds a vertex where the border is not as it must be.
  Spline_defect check_vertices() const
  {
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v) {
      if (is_isolated(v) || !m_knot_arrays.is_border_vertex(v))
        continue;
      if (m_number_of_fans[m_knot_arrays.original_vertex(v)] > 1)
        return {Status::TOUCHING_BORDERS, v};
    }
    return {};
  }

  /// Condition A: all extraordinary vertices that violate it, or not all of them if the progress is interrupted.
  /// \pre `check_vertices()` found no defect
  std::vector<Spline_defect> ring_defects()
  {
    std::vector<Spline_defect> result;
    m_rings.clear();
    for (const int v : m_extraordinary_vertices) {
      if (!m_progress.go_on_after(500))
        break;
      m_rings.emplace_back(m_knot_arrays, Vertex_quarters<KnotFT>(m_knot_arrays, v));
      if (!m_rings.back().are_regular())
        result.push_back({Status::IRREGULAR_RINGS, v, v, m_rings.back().bad_face()});
      else if (const int face = face_with_two(m_rings.back()); face != none)
        result.push_back({Status::IRREGULAR_RINGS, v, v, face});
    }
    return result;
  }

  /// Condition A. \pre `check_vertices()` found no defect
  Spline_defect check_rings()
  {
    const std::vector<Spline_defect> defects = ring_defects();
    if (m_progress.is_interrupted())
      return {Status::INTERRUPTED};
    return defects.empty() ? Spline_defect() : defects.front();
  }

  /// Finds the knots of all vertices. \pre condition A holds
  Spline_defect find_knots()
  {
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v) {
      if (!m_progress.go_on_after(20))
        return {Status::INTERRUPTED};
      if (const Spline_defect defect = find_knots(v))
        return defect;
    }
    const std::vector<Spline_defect> defects = border_defects_of_rings();
    return defects.empty() ? Spline_defect() : defects.front();
  }

  /// Finds the knots of one vertex. \pre condition A holds
  Spline_defect find_knots(const int v)
  {
    m_knots.resize(m_knot_arrays.number_of_vertices());
    if (is_isolated(v))
      return {};
    if (is_extraordinary(v)) {
      m_knots[v] = converted(finder().extraordinary_knots(Vertex_quarters<KnotFT>(m_knot_arrays, v)));
      return {};
    }
    const Vertex_rays<KnotFT> vertex_rays = rays(v);
    if (!has_enough_intervals(vertex_rays[0], vertex_rays[2]) || !has_enough_intervals(vertex_rays[1], vertex_rays[3]))
      return {Status::TOO_FEW_BORDER_INTERVALS, v};
    m_knots[v] = converted(finder().knots(vertex_rays));
    return {};
  }

  /// The rays of a vertex, in the order of its quarters' first directions. \pre it is not extraordinary
  Vertex_rays<KnotFT> rays(const int v) const { return finder().rays(Vertex_quarters<KnotFT>(m_knot_arrays, v)); }

  /// Condition A near a border, where the knots of a vertex of the second ring may differ from those that the rings ask
  /// for: all vertices that violate it. \pre the knots of the rings are found
  std::vector<Spline_defect> border_defects_of_rings() const
  {
    std::vector<Spline_defect> result;
    if (!m_has_border)
      return result;
    for (const Regular_rings<KnotFT>& rings : m_rings)
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (const int v : rings.second_ring(sector)) {
          if (!is_uniform(m_knots[v].axes[0].t) || !is_uniform(m_knots[v].axes[1].t))
            result.push_back({Status::BORDER_IN_RINGS, v, rings.vertex(sector, 0, 0)});
        }
    return result;
  }

  const Basis_knots<FT>& knots(const int v) const { return m_knots[v]; }

  /// Which basis functions may act in the faces at extraordinary vertices. \pre condition A holds
  Ring_controls<FT> ring_controls() const { return Ring_controls<FT>(arrays(), m_rings); }

  /// Condition B: finds the supports of all vertices and calls `sink(v, support)` for each. \pre the knots are found
  template <typename Sink>
  Spline_defect find_supports(const Sink& sink) const
  {
    const Ring_controls<FT> controls = ring_controls();
    Basis_support<FT> support(arrays(), controls);
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v) {
      if (is_isolated(v))
        continue;
      if (!m_progress.go_on_after(100))
        return {Status::INTERRUPTED};
      const Spline_defect defect = find_support(v, support);
      if (defect)
        return defect;
      sink(v, support);
    }
    return {};
  }

  /// A basis function beyond the border at a corner that turns inwards, of which the natural end does not belong to all
  /// quarters. Its control point would be 2 p - q, with those of two vertices.
  struct Corner_end {
    int corner, inner_vertex; ///< p and q
    Basis_knots<FT> knots;    ///< in the frame in which its support is found
  };

  /// Calls `sink(end, support)` for both ends at each corner that turns inwards. Faces at the corner are left out.
  /// \pre conditions A and B hold
  template <typename Sink>
  void find_corner_ends(const Sink& sink) const
  {
    const Ring_controls<FT> controls = ring_controls();
    Basis_support<FT> support(arrays(), controls);
    for (const Regular_rings<KnotFT>& rings : m_rings)
      if (rings.is_on_border())
        find_corner_ends(rings, support, sink);
  }

  /// Calls `sink(defect, support)` for those of the vertices that violate B. \pre their knots are found
  template <typename Sink>
  void for_each_support_defect(const Ring_controls<FT>& controls, const std::vector<int>& vertices,
                               const Sink& sink) const
  {
    Basis_support<FT> support(arrays(), controls);
    for (const int v : vertices) {
      if (is_isolated(v))
        continue;
      if (!m_progress.go_on_after(100))
        return;
      if (const Spline_defect defect = find_support(v, support))
        sink(defect, support);
    }
  }

private:
  void classify_vertices()
  {
    m_valence.resize(m_knot_arrays.number_of_vertices());
    m_kinds.resize(m_knot_arrays.number_of_vertices());
    m_corner_of_face.assign(m_knot_arrays.number_of_faces(), none);
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v) {
      if (m_knot_arrays.incoming(v) == none)
        continue;
      const bool is_border = m_knot_arrays.is_border_vertex(v);
      m_has_border = m_has_border || is_border;
      m_valence[v] = m_knot_arrays.extended_valence(v);
      if (is_border ? m_valence[v] <= 2 : m_valence[v] == 4)
        continue;
      m_kinds[v].is_extraordinary = true;
      m_extraordinary_vertices.push_back(v);
      m_knot_arrays.for_each_incoming(v, [&](const int h) {
        if (m_knot_arrays.is_corner(h))
          m_corner_of_face[m_knot_arrays.face(h)] = h;
      });
    }
    for (const int v : m_extraordinary_vertices)
      if (m_knot_arrays.is_border_vertex(v))
        mark_beside_corner(v);
    classify_creases();
  }

  // What belongs to whole vertices, before creases are cut.
  void classify_originals()
  {
    m_number_of_fans.assign(m_knot_arrays.number_of_vertices(), 0);
    m_number_of_creases = m_number_of_fans;
    m_ends_creases.assign(m_number_of_fans.size(), 0);
    for (int h = 0; h < m_knot_arrays.number_of_halfedges(); ++h) {
      m_number_of_fans[m_knot_arrays.target(h)] += m_knot_arrays.is_border(h);
      m_number_of_creases[m_knot_arrays.target(h)] += m_knot_arrays.is_crease(h);
    }
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v)
      m_ends_creases[v] = m_number_of_creases[v] > 0 && m_knot_arrays.ends_creases(v);
  }

  void classify_creases()
  {
    for (int h = 0; h < m_knot_arrays.number_of_halfedges(); ++h)
      if (m_knot_arrays.is_crease(h) && m_knot_arrays.is_border(h))
        for (const int v : {m_knot_arrays.source(h), m_knot_arrays.target(h)})
          m_kinds[v].is_natural = true;
    for (int v = 0; v < m_knot_arrays.number_of_vertices(); ++v) {
      Vertex_kind& kind = m_kinds[v];
      const int original = m_knot_arrays.original_vertex(v);
      kind.is_natural = kind.is_natural || kind.is_beside_corner;
      kind.is_on_border = m_number_of_fans[original] > 0;
      kind.ends_lines = m_ends_creases[original] != 0;
    }
  }

  // The first two vertices on both sides along the border.
  void mark_beside_corner(const int v)
  {
    const auto mark = [&](const int w) {
      if (m_valence[w] == 2)
        m_kinds[w].is_beside_corner = true;
    };
    const int before = Arrays::opposite(m_knot_arrays.next(m_knot_arrays.incoming(v))); // to v along the border
    mark(m_knot_arrays.source(before));
    mark(m_knot_arrays.source(m_knot_arrays.prev(before)));
    const int after = m_knot_arrays.next(before);
    mark(m_knot_arrays.target(after));
    mark(m_knot_arrays.target(m_knot_arrays.next(after)));
  }

  // A face at the extraordinary vertex that has another one as a corner, or `none`; likewise a face of the first two
  // rings if both vertices are on one border.
  int face_with_two(const Regular_rings<KnotFT>& rings) const
  {
    const int n = rings.valence();
    for (int sector = 0; sector < n; ++sector)
      if (is_extraordinary(rings.vertex(sector, 1, 0)) || is_extraordinary(rings.vertex(sector, 1, 1)))
        return rings.face(sector, 0, 0);
    if (rings.is_on_border()) {
      if (is_extraordinary(rings.vertex(0, 2, 0)))
        return rings.face(0, 1, 0);
      for (int y = 1; y <= 2; ++y)
        if (is_extraordinary(rings.vertex(n - 1, 0, y)))
          return rings.face(n - 1, 0, y - 1);
    }
    return none;
  }

  Basis_knots_finder<KnotFT> finder() const { return {m_knot_arrays, m_kinds, m_has_border}; }

  // The second knot outside may be any: it is not seen from the faces at the extraordinary vertex.
  static bool is_uniform(const std::array<FT, 5>& k)
  {
    const FT d = k[3] - k[2], eps = d * FT(summed_round_off);
    const auto is_close = [&](const FT& x) { return CGAL::abs(FT(x - d)) <= eps; };
    return k[2] == FT(0) && is_close(FT(k[2] - k[1])) && (is_close(FT(k[1] - k[0])) || is_close(FT(k[4] - k[3])));
  }

  Spline_defect find_support(const int v, Basis_support<FT>& support) const
  {
    support.find(v, Vertex_quarters<FT>(arrays(), v), m_knots[v]);
    if (support.reached_cone_face() != none) {
      const int face = support.faces()[support.reached_cone_face()].face;
      return {Status::SUPPORT_REACHES_CONE, v, m_knot_arrays.target(m_corner_of_face[face]), face};
    }
    if (support.endless_piece() != none)
      return {Status::ENDLESS_SUPPORT, v, none, support.faces()[support.endless_piece()].face};
    return {};
  }

  // In the frames of the first and of the last quarter: elsewhere they do not act.
  template <typename Sink>
  void find_corner_ends(const Regular_rings<KnotFT>& rings, Basis_support<FT>& support, const Sink& sink) const
  {
    const int v = rings.vertex(0, 0, 0), last = rings.valence() - 1;
    const Vertex_quarters<FT> quarters(arrays(), v);
    const Axis_knots<FT>&uniform = m_knots[v].axes[0], beyond = knots_beyond(uniform);
    const Corner_end first{v, rings.vertex(0, 0, 1), {{{uniform, beyond}}}},
        second{v, rings.vertex(last, 1, 0), {{{beyond, uniform}}}};
    support.find(v, std::array<Vertex_quarter<FT>, 1>{quarters[0]}, first.knots);
    sink(first, support);
    support.find(v, std::array<Vertex_quarter<FT>, 1>{quarters[last]}, second.knots);
    sink(second, support);
  }

  static Axis_knots<FT> knots_beyond(Axis_knots<FT> uniform)
  {
    const FT d = uniform.t[3];
    for (FT& x : uniform.t)
      x -= d;
    return uniform;
  }

  static Basis_knots<FT> converted(const Basis_knots<KnotFT>& knots)
  {
    Basis_knots<FT> result;
    for (int axis = 0; axis < 2; ++axis) {
      const Axis_knots<KnotFT>& from = knots.axes[axis];
      result.axes[axis] = {{}, from.before, from.after, from.is_peak};
      for (int i = 0; i < 5; ++i)
        result.axes[axis].t[i] = converted_number<FT>(from.t[i]);
    }
    return result;
  }

  Progress& m_progress;
  Knot_arrays m_knot_arrays;
  Arrays m_arrays;               // empty if the number types are the same
  std::optional<Arrays> m_uncut; // if there are creases
  bool m_has_border = false;
  std::vector<int> m_valence, m_extraordinary_vertices, m_corner_of_face;
  // Per vertex before creases are cut.
  std::vector<int> m_number_of_fans, m_number_of_creases; // the fans are those between borders of the surface
  std::vector<char> m_ends_creases;
  std::vector<Vertex_kind> m_kinds;
  std::vector<Regular_rings<KnotFT>> m_rings;
  std::vector<Basis_knots<FT>> m_knots;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_SPLINE_STRUCTURE_H
