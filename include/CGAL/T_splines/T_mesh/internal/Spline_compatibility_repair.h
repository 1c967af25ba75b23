// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H

#include <CGAL/T_splines/T_mesh/internal/Ring_insertion.h>
#include <CGAL/T_splines/T_mesh/support/Spline_structure.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <CGAL/number_type_basic.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How many splits were made for what.
struct Spline_repair_counts {
  std::size_t rings = 0, border = 0, reaching_supports = 0, endless_supports = 0;
};

/// Splits faces of a T-mesh until the conditions of [CZ17] 4.1.3 hold, in rounds: each looks at the T-mesh in arrays,
/// and corrects what it finds wrong; of defects close to each other only the first one.
///
/// Why it ends. A line that is inserted outside of the rings adds intersections to rays: the supports of the vertices
/// there become smaller or stay. So a vertex that had no defect gets none later, and after the first round only
/// vertices that had one and new vertices are looked at.
///
/// Condition B. Let the support of v reach a face at an extraordinary vertex w, the closest one. In the frame of w, in
/// units of its rings, v is at (X, Y), X, Y > 0. Where |X| <= 3, the ray of v along y meets the rings at 3 and 2 and
/// ends there; so X, Y > 3. Along one of the two axes a ray of v has one intersection before 1 already: otherwise the
/// face next to v would contain the corner of the rings. A split of one face, across this ray, at a place p with
/// 1 < p <= 3, adds the second one; or two splits along the other axis. The new vertices at this line have X <= 3 and
/// do not reach w. No part of the face is narrower than 3/16 of the ring (split_interval() chooses p so). So with a_f
/// the area of face f, and l_f the smallest of the sides of the faces within f and of 3/16 of the rings whose lines may
/// cross it, both in the units of f and as they are when the rings have been made, no more than the sum of a_f / l_f^2
/// faces arise. Those rings are within the reach of supports in f, which is bounded, as supports do not grow; they are
/// finitely many unless f lies at a centre of the surface (see below), from which supports are kept away. The face to
/// be split might lie in the rings of a third vertex. This can only be if those are twice as large as these, and they
/// are made smaller; so often at most as their units have factors of 3 between them.
///
/// Supports without an end. They contain a centre p of a spiral; its surroundings, without p, are covered again and
/// again by the same faces, smaller and smaller. Each ray of a vertex at the distance d from p, by the larger
/// coordinate, ends after two faces; if each was smaller than half of its distance from p, the support would not reach
/// p. So faces that are larger are split, and their parts have a sixth of this distance at least: a finite number.
///
/// Rings are made once around a vertex, but for the two cases above; lines parallel to borders are inserted until three
/// of them are seen from everywhere.
/// \tparam Splits `Counted_splits`
template <typename Splits>
class Spline_compatibility_repair {
  using Graph = typename Splits::Graph;
  using FT = typename Splits::FT;
  using SurfaceFT = typename std::conditional<is_exact_number_type<FT>, double, FT>::type;
  using Support = Basis_support<SurfaceFT>;
  using vertex_descriptor = typename Splits::vertex_descriptor;
  using halfedge_descriptor = typename Splits::halfedge_descriptor;
  using face_descriptor = typename Splits::face_descriptor;
  using Status = Spline_compatibility_status;
  using Indexing = Mesh_indexing<Graph>;
  static constexpr int none = -1;

  // Each is at most a third of the one before. With knots that are not quite admissible they might never be regular.
  static constexpr int most_rings = 20;

public:
  explicit Spline_compatibility_repair(Splits& splits) : m_splits(splits), m_split_position(splits.t_mesh()) {}

  /// Goes on until nothing is left to be done, nothing can be done, or no more splits are allowed. With exact knots
  /// the rounds look at rounded copies, which are made anew each time, so that errors do not add up; where these find
  /// nothing more, the exact knots decide.
  /// \pre the T-mesh is admissible, its border is as it must be
  /// \return whether all conditions hold, as far as is known: not if the splits are exhausted
  bool run()
  {
    bool is_final = std::is_same<FT, SurfaceFT>::value;
    while (!m_splits.is_exhausted()) {
      const Result result = is_final ? round<FT>() : round<SurfaceFT>();
      if (is_final && result != Result::CHANGED)
        return result == Result::DONE;
      if (result != Result::CHANGED) {
        is_final = true;
        m_checks_all = true;
      }
    }
    return false;
  }

  const Spline_repair_counts& counts() const { return m_counts; }

private:
  enum class Result { DONE, CHANGED, STUCK };
  enum class Split { DONE, LATER, IMPOSSIBLE };

  static constexpr double round_off_of_rings = 1e-9; // of places in units of rings, which are multiples of a fraction

  // What a round knows.
  template <typename KnotFT>
  struct State {
    const Indexing indexing;
    Spline_structure<KnotFT, SurfaceFT> structure;
    std::vector<int> cone_of_face; // the extraordinary vertex in whose rings a face lies
    std::vector<int> candidates;   // vertices to be looked at

    explicit State(Splits& splits) : indexing(splits.graph()), structure(indexing, splits.t_mesh(), splits.progress())
    {
    }

    // In the graph, which is not cut along creases.
    vertex_descriptor vertex(const int v) const { return indexing.vertex(structure.vertex_in_graph(v)); }
    halfedge_descriptor halfedge(const int h) const
    {
      return indexing.halfedge(structure.knot_arrays().original_halfedge(h));
    }
  };

  template <typename KnotFT>
  Result round()
  {
    State<KnotFT> state(m_splits);
    if (insert_rings(state) || m_splits.progress().is_interrupted())
      return Result::CHANGED;
    if (m_is_stuck)
      return Result::STUCK;
    find_cones_of_faces(state);
    find_candidates(state);
    m_splits.touched().clear();
    const std::size_t before = m_splits.count();
    std::vector<int> defects = border_defects(state);
    m_counts.border += m_splits.count() - before;
    if (!m_splits.progress().go_on())
      return Result::CHANGED;
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
      m_candidates.push_back(state.vertex(v));
    return m_splits.count() != before || !m_cones_to_do.empty() ? Result::CHANGED : Result::STUCK;
  }

  // Condition A.
  template <typename KnotFT>
  bool insert_rings(State<KnotFT>& state)
  {
    std::vector<vertex_descriptor> cones;
    for (const Spline_defect& defect : state.structure.ring_defects())
      cones.push_back(state.vertex(defect.vertex));
    for (const vertex_descriptor v : m_cones_to_do)
      if (std::find(cones.begin(), cones.end(), v) == cones.end())
        cones.push_back(v);
    m_cones_to_do.clear();
    const auto is_hopeless = [this](const vertex_descriptor v) { return ++m_times[v] > most_rings; };
    m_is_stuck = !cones.empty() && std::all_of(cones.begin(), cones.end(), is_hopeless);
    if (cones.empty() || m_is_stuck)
      return false;
    const std::size_t before = m_splits.count();
    Ring_insertion<Splits>(m_splits).run(cones);
    m_counts.rings += m_splits.count() - before;
    m_checks_all = true;
    return true;
  }

  template <typename KnotFT>
  void find_cones_of_faces(State<KnotFT>& state) const
  {
    state.cone_of_face.assign(state.structure.arrays().number_of_faces(), none);
    for (const Regular_rings<KnotFT>& rings : state.structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (int x = 0; x < 3; ++x)
          for (int y = 0; y < (x < 2 ? 3 : 2); ++y)
            state.cone_of_face[rings.face(sector, x, y)] = rings.vertex(sector, 0, 0);
  }

  template <typename KnotFT>
  void find_candidates(State<KnotFT>& state) const
  {
    if (m_checks_all) {
      state.candidates.resize(state.structure.arrays().number_of_vertices());
      std::iota(state.candidates.begin(), state.candidates.end(), 0);
      return;
    }
    const auto& arrays = state.structure.arrays();
    std::vector<char> is_candidate(arrays.number_of_original_vertices(), 0);
    for (const vertex_descriptor v : m_candidates)
      is_candidate[state.indexing.vertex_index(v)] = 1;
    for (int v = 0; v < arrays.number_of_vertices(); ++v)
      if (is_candidate[arrays.original_vertex(v)] != 0)
        state.candidates.push_back(v);
  }

  // Finds the knots of the candidates. Returns those that see too few intervals, or border too close to rings.
  template <typename KnotFT>
  std::vector<int> border_defects(State<KnotFT>& state)
  {
    std::vector<int> result;
    for (const int v : state.candidates) {
      if (!m_splits.progress().go_on_after(20))
        break;
      if (state.structure.find_knots(v)) {
        result.push_back(v);
        widen_border(state, v);
      }
    }
    if (!result.empty() || !state.structure.has_border())
      return result;
    for (const Regular_rings<KnotFT>& rings : state.structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (const int v : rings.second_ring(sector))
          state.structure.find_knots(v);
    for (const Spline_defect& defect : state.structure.border_defects_of_rings()) {
      result.push_back(defect.vertex);
      keep_off_border(state, defect);
    }
    return result;
  }

  // Two borders, one or two intervals apart: there shall be three.
  template <typename KnotFT>
  void widen_border(State<KnotFT>& state, const int v)
  {
    const Vertex_rays<KnotFT> rays = state.structure.rays(v);
    for (int i = 0; i < 2; ++i)
      if (!has_enough_intervals(rays[i], rays[i + 2]))
        split_longest_interval(state, rays, i);
  }

  // The last interval before a border that is seen from the second ring; natural ends do no harm.
  template <typename KnotFT>
  void keep_off_border(State<KnotFT>& state, const Spline_defect& defect)
  {
    const Vertex_rays<KnotFT> rays = state.structure.rays(defect.vertex);
    for (const Knot_ray<KnotFT>& ray : rays)
      if (!ray.is_natural && ray.border > 0 && ray.border < 3 &&
          halve_interval(state, ray, ray.border - 1) == Split::IMPOSSIBLE)
        m_cones_to_do.push_back(state.vertex(defect.extraordinary_vertex));
  }

  // Condition B.
  template <typename KnotFT>
  std::vector<int> support_defects(State<KnotFT>& state)
  {
    std::vector<int> result;
    const Ring_controls<SurfaceFT> controls = state.structure.ring_controls();
    state.structure.for_each_support_defect(controls, state.candidates,
                                            [&](const Spline_defect& defect, const Support& support) {
                                              result.push_back(defect.vertex);
                                              const std::size_t before = m_splits.count();
                                              if (defect.status == Status::SUPPORT_REACHES_CONE) {
                                                shorten(state, controls, defect, support);
                                                m_counts.reaching_supports += m_splits.count() - before;
                                              }
                                              else {
                                                divide_around_centre(state, support);
                                                m_counts.endless_supports += m_splits.count() - before;
                                              }
                                            });
    return result;
  }

  // How a vertex sees an extraordinary vertex along one of the two axes, in units of the rings around this one.
  struct View {
    int direction;        // of the ray that comes closer to it, in the frame of the vertex
    double distance;      // between the two
    double rings_per_ray; // units of the rings per unit of the ray
    bool ends_before;     // the support ends before the face at the extraordinary vertex
    int intersections;    // number of those before this face
    int interval;         // of the ray, the one to be split
    double begin;         // where it begins, as a distance from the extraordinary vertex
    double target, high;  // where to split it, likewise

    bool is_better_than(const View& other) const
    {
      return intersections != other.intersections ? intersections > other.intersections : distance > other.distance;
    }
  };

  // Next to a border not all intersections are knots: another one may be needed where there are two.
  template <typename KnotFT>
  View view(const Vertex_rays<KnotFT>& rays, const int direction, const double distance,
            const double rings_per_ray) const
  {
    const Knot_ray<KnotFT>& ray = rays[direction];
    const auto place_at = [&](const KnotFT& x) { return distance - rings_per_ray * CGAL::to_double(x); };
    const auto place = [&](const int i) { return i < 0 ? distance : place_at(ray.distance[i]); };
    const double first = 1 - round_off_of_rings;
    View result{direction, distance, rings_per_ray, place_at(axis_knots(ray, rays[(direction + 2) % 4]).t[4]) >= first,
                0,         0,        distance,      2,
                0};
    while (result.intersections < 2 && place(result.intersections) >= first)
      ++result.intersections;
    const int n = result.intersections;
    result.interval = n > 0 && place(n - 1) < 1.5 ? n - 1 : n;
    result.begin = place(result.interval - 1);
    result.high = (std::min)(3., result.begin - 0.25);
    result.target = result.begin >= 2.25 ? 2 : (1 + result.begin) / 2;
    return result;
  }

  // Adds an intersection to a ray of the vertex of a support that reaches a face at an extraordinary vertex.
  template <typename KnotFT>
  void shorten(State<KnotFT>& state, const Ring_controls<SurfaceFT>& controls, const Spline_defect& defect,
               const Support& support)
  {
    const Support_face<SurfaceFT>& piece = support.faces()[support.reached_cone_face()];
    const auto place = controls.place(piece.face, piece.to_vertex);
    const Similarity_2<SurfaceFT>& to_rings = controls.to_unit_square(piece.face);
    const int turns = to_rings.quarter_turns() - piece.to_vertex.quarter_turns() + 8;
    const double scale = CGAL::to_double(to_rings.scale()) / CGAL::to_double(piece.to_vertex.scale());
    const double x = CGAL::to_double(place.first), y = CGAL::to_double(place.second);
    if (!state.structure.is_extraordinary(defect.vertex)) {
      const Vertex_rays<KnotFT> rays = state.structure.rays(defect.vertex);
      std::array<View, 2> views{view(rays, ((x > 0 ? 2 : 0) + turns * 3) % 4, CGAL::abs(x), scale),
                                view(rays, ((y > 0 ? 3 : 1) + turns * 3) % 4, CGAL::abs(y), scale)};
      if (views[1].is_better_than(views[0]))
        std::swap(views[0], views[1]);
      for (const View& v : views)
        if (v.distance > 3 - round_off_of_rings && !v.ends_before &&
            split_interval(state, rays[v.direction], v) != Split::IMPOSSIBLE)
          return;
      const int in_the_way = cone_of_rays(state, rays);
      m_cones_to_do.push_back(state.vertex(in_the_way != none ? in_the_way : defect.extraordinary_vertex));
      return;
    }
    m_cones_to_do.push_back(state.vertex(defect.vertex));
  }

  // Splits a face across a ray, at a place where it has a vertex, or a short fraction of its side.
  template <typename KnotFT>
  Split split_interval(State<KnotFT>& state, const Knot_ray<KnotFT>& ray, const View& view)
  {
    const auto& arrays = state.structure.knot_arrays();
    const int h = face_to_split(state, ray, view.interval);
    if (h == none)
      return Split::IMPOSSIBLE;
    const int f = arrays.face(h);
    const bool is_reversed = h != ray.halfedge[view.interval];
    const int direction = (arrays.side(h) + (ray.is_across[view.interval] ? 1 : is_reversed ? 2 : 0)) % 4;
    const double size = CGAL::to_double(arrays.side_length(f, direction));
    const double begin = ray.is_across[view.interval] ? 0
                         : is_reversed                ? size - CGAL::to_double(KnotFT(arrays.end(h)))
                                                      : CGAL::to_double(arrays.begin(h));
    const double length = ray.is_across[view.interval] ? size : CGAL::to_double(arrays.knot(h));
    const double ray_length = CGAL::to_double(ray.distance[view.interval]) -
                              (view.interval == 0 ? 0 : CGAL::to_double(ray.distance[view.interval - 1]));
    const double rings_per_face = view.rings_per_ray * ray_length / length;
    const auto in_face = [&](const double x) { return (begin + (view.begin - x) / rings_per_face) / size; };
    constexpr double snap = 1 / 16., low = 1.25;
    return split_near(state, f, direction, in_face(view.high + snap), in_face(view.target), in_face(low - snap));
  }

  // Splits a face between the fractions `low` and `high` of its extent in a direction. Faces that were touched in this
  // round are left for the next one.
  template <typename KnotFT>
  Split split_near(State<KnotFT>& state, const int face, const int direction, const double low, const double target,
                   const double high)
  {
    const face_descriptor f = state.indexing.face(face);
    if (m_splits.touched().is_touched(f))
      return Split::LATER;
    const int axis = direction % 2;
    const FT size = m_splits.coordinates().side_length(m_splits.coordinates().first_of_side(f, axis));
    const auto at = [&](const double fraction) { return FT(size * FT(direction < 2 ? fraction : 1 - fraction)); };
    const double step = std::exp2(std::floor(std::log2((high - low) / 8)));
    const FT target_at = at(step * std::round(target / step)), low_at = at(low), high_at = at(high);
    const FT x = m_split_position.near(f, axis, (std::min)(low_at, high_at), target_at, (std::max)(low_at, high_at));
    return m_splits.split(f, axis, x).is_split ? Split::DONE : Split::IMPOSSIBLE;
  }

  // Splits the faces of a support that has no end.
  template <typename KnotFT>
  void divide_around_centre(State<KnotFT>& state, const Support& support)
  {
    const auto& arrays = state.structure.arrays();
    const std::array<SurfaceFT, 2> p{support.centre().first, support.centre().second};
    bool is_divided = false;
    int cone = none;
    for (const Support_face<SurfaceFT>& piece : support.faces()) {
      const auto r = support.rectangle_of(piece);
      SurfaceFT distance(0);
      for (int axis = 0; axis < 2; ++axis)
        distance = (std::max)({distance, SurfaceFT(r.low[axis] - p[axis]), SurfaceFT(p[axis] - r.high[axis])});
      if ((std::max)(SurfaceFT(r.high[0] - r.low[0]), SurfaceFT(r.high[1] - r.low[1])) < distance / SurfaceFT(2))
        continue;
      if (state.cone_of_face[piece.face] != none)
        cone = state.cone_of_face[piece.face];
      else {
        const int axis = arrays.width(piece.face) >= arrays.height(piece.face) ? 0 : 1;
        split_near(state, piece.face, axis, 1 / 3., 1 / 2., 2 / 3.);
        is_divided = true;
      }
    }
    if (!is_divided && cone != none)
      m_cones_to_do.push_back(state.vertex(cone));
  }

  // Splits the longest of the intervals on both sides of a vertex, outside of rings.
  template <typename KnotFT>
  Split split_longest_interval(State<KnotFT>& state, const Vertex_rays<KnotFT>& rays, const int axis)
  {
    const Knot_ray<KnotFT>* best = nullptr;
    int best_interval = none;
    KnotFT best_length(0);
    for (const int direction : {axis, axis + 2})
      for (int i = 0; i < 2 && i < rays[direction].border; ++i) {
        const Knot_ray<KnotFT>& ray = rays[direction];
        const KnotFT length = i == 0 ? ray.distance[0] : KnotFT(ray.distance[i] - ray.distance[i - 1]);
        if (length > best_length && face_to_split(state, ray, i) != none) {
          best = &ray;
          best_interval = i;
          best_length = length;
        }
      }
    return best == nullptr ? Split::IMPOSSIBLE : halve_interval(state, *best, best_interval);
  }

  // The halfedge of an interval of a ray in a face outside of rings.
  template <typename KnotFT>
  int face_to_split(const State<KnotFT>& state, const Knot_ray<KnotFT>& ray, const int i) const
  {
    const auto& arrays = state.structure.knot_arrays();
    const int h = ray.halfedge[i];
    if (h == none)
      return none;
    if (state.cone_of_face[arrays.face(h)] == none)
      return h;
    const int o = arrays.opposite(h);
    return ray.is_across[i] || arrays.is_border(o) || state.cone_of_face[arrays.face(o)] != none ? none : o;
  }

  // Splits a face across a ray, at the middle of one of its intervals.
  template <typename KnotFT>
  Split halve_interval(State<KnotFT>& state, const Knot_ray<KnotFT>& ray, const int i)
  {
    const auto& arrays = state.structure.knot_arrays();
    const int h = face_to_split(state, ray, i);
    if (h == none)
      return Split::IMPOSSIBLE;
    const auto& coordinates = m_splits.coordinates();
    const auto f = state.indexing.face(arrays.face(h));
    if (m_splits.touched().is_touched(f))
      return Split::LATER;
    const auto g = state.halfedge(h);
    const int direction = (arrays.side(h) + (ray.is_across[i] ? 1 : 0)) % 4;
    const FT middle = ray.is_across[i] ? FT(coordinates.side_length(coordinates.first_of_side(f, direction)) / FT(2))
                                       : FT(coordinates.place(g).begin + FT(m_splits.t_mesh().knot(g)) / FT(2));
    return m_splits.split(f, direction, middle).is_split ? Split::DONE : Split::IMPOSSIBLE;
  }

  // One of the extraordinary vertices in whose rings rays run.
  template <typename KnotFT>
  int cone_of_rays(const State<KnotFT>& state, const Vertex_rays<KnotFT>& rays) const
  {
    for (const Knot_ray<KnotFT>& ray : rays)
      for (const int h : ray.halfedge)
        if (h != none && state.cone_of_face[state.structure.arrays().face(h)] != none)
          return state.cone_of_face[state.structure.arrays().face(h)];
    return none;
  }

  Splits& m_splits;
  typename Splits::Position m_split_position;
  Spline_repair_counts m_counts;
  bool m_checks_all = true, m_is_stuck = false;
  std::unordered_map<vertex_descriptor, int, boost::hash<vertex_descriptor>> m_times; // rings were made there
  std::vector<vertex_descriptor> m_candidates, m_cones_to_do;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_SPLINE_COMPATIBILITY_REPAIR_H
