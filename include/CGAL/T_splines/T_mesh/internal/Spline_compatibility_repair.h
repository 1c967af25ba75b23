// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H

#include <CGAL/T_splines/T_mesh/internal/Ring_insertion.h>
#include <CGAL/T_splines/T_mesh/internal/Ring_line.h>
#include <CGAL/T_splines/T_mesh/internal/Spline_structure.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How many splits were made for what.
struct Spline_repair_counts {
  std::size_t rings = 0, border = 0, reaching_supports = 0, overlapping_supports = 0;
};

/// Splits faces of a T-mesh until the conditions of [CZ17] 4.1.3 hold, in rounds: each looks at the T-mesh in arrays,
/// and corrects what it finds wrong; of defects close to each other only the first one.
///
/// A line that is inserted outside of the rings adds intersections to rays: the supports of the vertices there become
/// smaller or stay. So a vertex that had no defect gets none later, and after the first round only vertices that had
/// one and new vertices are looked at.
/// Each round but the last one splits something. Rings are made at most twice around a vertex, unless all that a
/// support overlaps is rings. Lines of rings are extended only within supports, which they end; the splits for overlaps
/// end as shrink_support() says. That they end together is not proven: the number of splits may be bounded.
/// \tparam Splits `Counted_splits`
template <typename Splits>
class Spline_compatibility_repair {
  using Graph = typename Splits::Graph;
  using FT = typename Splits::FT;
  using vertex_descriptor = typename Splits::vertex_descriptor;
  using Status = Spline_compatibility_status;
  using Indexing = Mesh_indexing<Graph>;
  static constexpr int none = -1;

public:
  explicit Spline_compatibility_repair(Splits& splits) : m_splits(splits) {}

  /// Goes on until nothing is left to be done, nothing can be done, or no more splits are allowed.
  /// \pre the T-mesh is admissible, its border is as it must be
  /// \return whether all conditions hold
  bool run()
  {
    bool is_exact = std::is_same<FT, double>::value || !is_exact_number_type<FT>;
    while (!m_splits.is_exhausted()) {
      const Result result = is_exact ? round<FT>() : round<double>();
      if (result == Result::STUCK || (result == Result::DONE && is_exact))
        return result == Result::DONE;
      if (result == Result::DONE) {
        is_exact = true; // rounded transitions may hide an overlap
        m_checks_all = true;
      }
    }
    return false;
  }

  const Spline_repair_counts& counts() const { return m_counts; }

private:
  enum class Result { DONE, CHANGED, STUCK };

  // What a round knows.
  template <typename SurfaceFT>
  struct State {
    const Indexing indexing;
    Spline_structure<FT, SurfaceFT> structure;
    std::vector<int> cone_of_face; // the extraordinary vertex in whose rings a face lies
    std::vector<int> candidates;   // vertices to be looked at

    State(const Splits& splits) : indexing(splits.t_mesh()), structure(indexing, splits.knots(), splits.corners()) {}
  };

  template <typename SurfaceFT>
  Result round()
  {
    State<SurfaceFT> state(m_splits);
    if (insert_rings(state))
      return Result::CHANGED;
    find_cones_of_faces(state);
    find_candidates(state);
    m_splits.touched().clear();
    const std::size_t before = m_splits.count();
    std::vector<int> defects = border_defects(state);
    m_counts.border += m_splits.count() - before;
    if (!defects.empty())
      defects.insert(defects.end(), state.candidates.begin(),
                     state.candidates.end()); // their supports are still unknown
    else {
      defects = support_defects(state);
      m_checks_all = false;
    }
    if (defects.empty())
      return Result::DONE;
    m_candidates = m_splits.touched().new_vertices();
    for (const int v : defects)
      m_candidates.push_back(state.indexing.vertex(v));
    return m_splits.count() != before || !m_cones_to_do.empty() ? Result::CHANGED : Result::STUCK;
  }

  // Condition A.
  template <typename SurfaceFT>
  bool insert_rings(State<SurfaceFT>& state)
  {
    std::vector<vertex_descriptor> cones;
    for (const Spline_defect& defect : state.structure.ring_defects())
      cones.push_back(state.indexing.vertex(defect.vertex));
    for (const vertex_descriptor v : m_cones_to_do)
      if (std::find(cones.begin(), cones.end(), v) == cones.end())
        cones.push_back(v);
    m_cones_to_do.clear();
    if (cones.empty())
      return false;
    const std::size_t before = m_splits.count();
    Ring_insertion<Splits>(m_splits).run(cones);
    m_counts.rings += m_splits.count() - before;
    m_checks_all = true;
    return true;
  }

  template <typename SurfaceFT>
  void find_cones_of_faces(State<SurfaceFT>& state) const
  {
    state.cone_of_face.assign(state.structure.arrays().number_of_faces(), none);
    for (const Regular_rings<FT>& rings : state.structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (int x = 0; x < 3; ++x)
          for (int y = 0; y < (x < 2 ? 3 : 2); ++y)
            state.cone_of_face[rings.face(sector, x, y)] = rings.vertex(sector, 0, 0);
  }

  template <typename SurfaceFT>
  void find_candidates(State<SurfaceFT>& state) const
  {
    if (m_checks_all) {
      state.candidates.resize(state.structure.arrays().number_of_vertices());
      std::iota(state.candidates.begin(), state.candidates.end(), 0);
      return;
    }
    for (const vertex_descriptor v : m_candidates)
      state.candidates.push_back(state.indexing.vertex_index(v));
    std::sort(state.candidates.begin(), state.candidates.end());
    state.candidates.erase(std::unique(state.candidates.begin(), state.candidates.end()), state.candidates.end());
  }

  // Finds the knots of the candidates. Returns those that see too few intervals, or border too close to rings.
  template <typename SurfaceFT>
  std::vector<int> border_defects(State<SurfaceFT>& state)
  {
    std::vector<int> result;
    for (const int v : state.candidates)
      if (state.structure.find_knots(v)) {
        result.push_back(v);
        widen_border(state, v);
      }
    if (!result.empty() || !state.structure.has_border())
      return result;
    for (const Regular_rings<FT>& rings : state.structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (const std::array<int, 2>& p : {std::array<int, 2>{2, 0}, {2, 1}, {2, 2}, {1, 2}})
          state.structure.find_knots(rings.vertex(sector, p[0], p[1]));
    for (const Spline_defect& defect : state.structure.border_defects_of_rings()) {
      result.push_back(defect.vertex);
      keep_off_border(state, defect);
    }
    return result;
  }

  // Two borders, one or two intervals apart: there shall be three.
  template <typename SurfaceFT>
  void widen_border(State<SurfaceFT>& state, const int v)
  {
    const Vertex_rays<FT> rays = state.structure.rays(v);
    for (int i = 0; i < 2; ++i)
      if (!has_enough_intervals(rays[i], rays[i + 2]))
        split_longest_interval(state, rays, i);
  }

  // The last interval before a border that is seen from the second ring.
  template <typename SurfaceFT>
  void keep_off_border(State<SurfaceFT>& state, const Spline_defect& defect)
  {
    const Vertex_rays<FT> rays = state.structure.rays(defect.vertex);
    for (const Knot_ray<FT>& ray : rays)
      if (ray.border < 3 && split_interval(state, ray, ray.border - 1) == Split::IMPOSSIBLE)
        m_cones_to_do.push_back(state.indexing.vertex(defect.extraordinary_vertex));
  }

  // Conditions B and C.
  template <typename SurfaceFT>
  std::vector<int> support_defects(State<SurfaceFT>& state)
  {
    std::vector<int> result;
    state.structure.for_each_support_defect(
        state.candidates, [&](const Spline_defect& defect, const Basis_support<SurfaceFT>& support) {
          result.push_back(defect.vertex);
          if (is_touched(state, support))
            return;
          const std::size_t before = m_splits.count();
          const bool overlaps = defect.status == Status::SUPPORT_OVERLAPS_ITSELF;
          if (overlaps || !extend_ring_line(state, defect, support))
            shrink_support(state, defect, support);
          (overlaps ? m_counts.overlapping_supports : m_counts.reaching_supports) += m_splits.count() - before;
        });
    return result;
  }

  template <typename SurfaceFT>
  bool is_touched(const State<SurfaceFT>& state, const Basis_support<SurfaceFT>& support) const
  {
    for (const Support_face<SurfaceFT>& face : support.faces())
      if (m_splits.touched().is_touched(state.indexing.face(face.face)))
        return true;
    return false;
  }

  // Condition B. The support of a vertex at (X, Y), beyond the corner of the third ring, ends at the line x = 2 if its
  // ray towards lower x meets this line, and something before. By convexity of the faces this is so along one of the
  // two axes.
  template <typename SurfaceFT>
  bool extend_ring_line(State<SurfaceFT>& state, const Spline_defect& defect, const Basis_support<SurfaceFT>& support)
  {
    const auto& arrays = state.structure.arrays();
    const auto& cone_faces = support.cone_faces();
    const auto found = std::find_if(cone_faces.begin(), cone_faces.end(),
                                    [&](const Support_face<SurfaceFT>& f) { return f.face == defect.face; });
    const int corner = state.structure.corner_of_face(defect.face);
    const double unit = CGAL::to_double(SurfaceFT(found->to_vertex.scale() * arrays.width(defect.face)));
    const auto in_face = arrays.target_point(corner);
    const auto cone = found->to_vertex(in_face.first, in_face.second);
    const int direction = (arrays.side(corner) + 1 + found->to_vertex.quarter_turns()) % 4;
    const Vertex_rays<FT> rays = state.structure.rays(defect.vertex);
    std::array<double, 2> at; // X, Y
    std::array<bool, 2> has_intersection;
    for (int axis = 0; axis < 2; ++axis) {
      const int d = (direction + axis) % 4;
      const double x = CGAL::to_double(d % 2 == 0 ? cone.first : cone.second) / unit;
      at[axis] = d < 2 ? -x : x;
      has_intersection[axis] = at[axis] - CGAL::to_double(rays[(d + 2) % 4].distance[0]) / unit > 2 + 1e-9;
    }
    if (!(at[0] > 3 && at[1] > 3))
      return false;
    const int first = at[1] <= at[0] ? 0 : 1; // the shorter way
    for (const int axis : {first, 1 - first})
      if (has_intersection[axis] &&
          Ring_line<Splits>(m_splits).extend(state.indexing.halfedge(corner), axis, at[1 - axis]))
        return true;
    return false;
  }

  enum class Split { DONE, LATER, IMPOSSIBLE };

  // A support that meets its own image, by the way on which it overlaps itself, or nearly does, is made shorter along
  // the axis along which less is missing. Otherwise only the face that it overlaps twice is too large, and is split.
  // Both end: the support becomes shorter until a quarter of its extent lies between it and its image, and the face
  // until it does not bridge this gap.
  template <typename SurfaceFT>
  void shrink_support(State<SurfaceFT>& state, const Spline_defect& defect, const Basis_support<SurfaceFT>& support)
  {
    if (state.structure.is_extraordinary(defect.vertex)) {
      m_cones_to_do.push_back(state.indexing.vertex(defect.vertex));
      return;
    }
    int axis = 0;
    if (defect.status == Status::SUPPORT_OVERLAPS_ITSELF) {
      if (extend_spokes(state, defect.vertex))
        return;
      const std::array<SurfaceFT, 2> common =
          overlap_with_image(state.structure.knots(defect.vertex), support.round_trip());
      if ((std::min)(common[0], common[1]) < SurfaceFT(-0.25) &&
          split_longer_side(state, defect.face) != Split::IMPOSSIBLE)
        return;
      axis = common[0] <= common[1] ? 0 : 1;
    }
    const Vertex_rays<FT> rays = state.structure.rays(defect.vertex);
    if (split_longest_interval(state, rays, axis) == Split::IMPOSSIBLE &&
        split_longest_interval(state, rays, 1 - axis) == Split::IMPOSSIBLE)
      m_cones_to_do.push_back(state.indexing.vertex(cone_of_rays(state, rays)));
  }

  // Around an extraordinary vertex of valence 1 or 2 a support comes back, and meets a face that crosses the
  // continuation of a spoke from both sides.
  template <typename SurfaceFT>
  bool extend_spokes(State<SurfaceFT>& state, const int v)
  {
    const auto& arrays = state.structure.arrays();
    const auto& knots = state.structure.knots(v).knots;
    const SurfaceFT reach =
        (std::max)((std::max)(knots[0][4], knots[1][4]), SurfaceFT(-(std::min)(knots[0][0], knots[1][0])));
    bool is_changed = false;
    for (const Vertex_quarter<SurfaceFT>& quarter : Vertex_quarters<SurfaceFT>(arrays, v)) {
      const int cone = state.cone_of_face[arrays.face(quarter.h)];
      if (cone == none || arrays.extended_valence(cone) > 2)
        continue;
      const SurfaceFT unit = quarter.unit * arrays.width(arrays.face(quarter.h));
      arrays.for_each_incoming(cone, [&](const int corner) {
        const bool is_split = Ring_line<Splits>(m_splits).extend_spoke(state.indexing.halfedge(corner),
                                                                       3 + CGAL::to_double(SurfaceFT(reach / unit)));
        is_changed = is_changed || is_split;
      });
    }
    return is_changed;
  }

  // How much of the extent of a support along each axis its image also has, as a fraction; negative if they are apart.
  template <typename SurfaceFT>
  static std::array<SurfaceFT, 2> overlap_with_image(const Basis_knots<SurfaceFT>& knots,
                                                     const Similarity_2<SurfaceFT>& to_image)
  {
    const auto &u = knots.knots[0], &v = knots.knots[1];
    const auto p = to_image(u.front(), v.front()), q = to_image(u.back(), v.back());
    const auto fraction = [](const std::array<SurfaceFT, 5>& k, const SurfaceFT& a, const SurfaceFT& b) {
      const SurfaceFT low = (std::max)(k.front(), (std::min)(a, b)), high = (std::min)(k.back(), (std::max)(a, b));
      return SurfaceFT((high - low) / (k.back() - k.front()));
    };
    return {fraction(u, p.first, q.first), fraction(v, p.second, q.second)};
  }

  template <typename SurfaceFT>
  Split split_longer_side(State<SurfaceFT>& state, const int face)
  {
    const auto& arrays = state.structure.knot_arrays();
    if (state.cone_of_face[face] != none)
      return Split::IMPOSSIBLE;
    const int axis = arrays.width(face) >= arrays.height(face) ? 0 : 1;
    return split_once(state, face, axis, FT(arrays.side_length(face, axis) / FT(2)));
  }

  // Faces that were touched in this round are left for the next one.
  template <typename SurfaceFT>
  Split split_once(State<SurfaceFT>& state, const int face, const int direction, const FT& distance)
  {
    const auto f = state.indexing.face(face);
    if (m_splits.touched().is_touched(f))
      return Split::LATER;
    return m_splits.split(f, direction, distance).is_split ? Split::DONE : Split::IMPOSSIBLE;
  }

  // Splits the longest of the intervals on both sides of a vertex, outside of rings.
  template <typename SurfaceFT>
  Split split_longest_interval(State<SurfaceFT>& state, const Vertex_rays<FT>& rays, const int axis)
  {
    const Knot_ray<FT>* best = nullptr;
    int best_interval = none;
    FT best_length(0);
    for (const int direction : {axis, axis + 2})
      for (int i = 0; i < 2 && i < rays[direction].border; ++i) {
        const Knot_ray<FT>& ray = rays[direction];
        const FT length = i == 0 ? ray.distance[0] : FT(ray.distance[i] - ray.distance[i - 1]);
        if (length > best_length && face_to_split(state, ray, i) != none) {
          best = &ray;
          best_interval = i;
          best_length = length;
        }
      }
    return best == nullptr ? Split::IMPOSSIBLE : split_interval(state, *best, best_interval);
  }

  // The halfedge of an interval of a ray in a face outside of rings.
  template <typename SurfaceFT>
  int face_to_split(const State<SurfaceFT>& state, const Knot_ray<FT>& ray, const int i) const
  {
    const auto& arrays = state.structure.knot_arrays();
    const int h = ray.halfedge[i];
    if (h == none)
      return none;
    if (state.cone_of_face[arrays.face(h)] == none)
      return h;
    const int o = h ^ 1;
    return ray.is_across[i] || arrays.is_border(o) || state.cone_of_face[arrays.face(o)] != none ? none : o;
  }

  // Splits a face across a ray, at the middle of one of its intervals.
  template <typename SurfaceFT>
  Split split_interval(State<SurfaceFT>& state, const Knot_ray<FT>& ray, const int i)
  {
    const auto& arrays = state.structure.knot_arrays();
    const int h = face_to_split(state, ray, i);
    if (h == none)
      return Split::IMPOSSIBLE;
    const int direction = ray.is_across[i] ? (arrays.side(h) + 1) % 4 : arrays.side(h);
    const FT middle = ray.is_across[i] ? FT(arrays.side_length(arrays.face(h), direction) / FT(2))
                                       : FT(arrays.begin(h) + arrays.knot(h) / FT(2));
    return split_once(state, arrays.face(h), direction, middle);
  }

  // One of the extraordinary vertices in whose rings rays run.
  template <typename SurfaceFT>
  int cone_of_rays(const State<SurfaceFT>& state, const Vertex_rays<FT>& rays) const
  {
    for (const Knot_ray<FT>& ray : rays)
      for (const int h : ray.halfedge)
        if (h != none && state.cone_of_face[state.structure.arrays().face(h)] != none)
          return state.cone_of_face[state.structure.arrays().face(h)];
    return none;
  }

  Splits& m_splits;
  Spline_repair_counts m_counts;
  bool m_checks_all = true;
  std::vector<vertex_descriptor> m_candidates, m_cones_to_do;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H
