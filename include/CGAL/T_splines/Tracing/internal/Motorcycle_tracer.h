// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycles.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Sends motorcycles along the isolines of a seamless map until each has met a trace ([CZ17] section 8; Eppstein et al.
/// 2008). The one that has travelled least on the surface goes next.
///
/// Where the scales of the transitions are not all 1, a trace may spiral towards a closed isoline for ever, its turns
/// ever closer. One that comes back to an edge in the same direction on a smaller scale (or very often at all, see
/// `Spiral_detection`) gets a seed in its way: two motorcycles leave it sideways, and its own next turn, or another's,
/// meets them.
template <typename FT, typename TracingTraits>
class Motorcycle_tracer {
  using Layout = Seamless_layout<FT>;
  using Motion = typename Motorcycles<FT, TracingTraits>::Motion;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Traces = Motorcycle_traces<FT>;
  using Point_3 = typename Motorcycles<FT, TracingTraits>::Point_3;

  // Predicates that exact numbers decide, once in a while, are a part of it.
  static constexpr std::size_t work_per_step = 200;

public:
  static constexpr int none = -1;
  static constexpr int maximal_seeds_per_trace = 256;

  /// \param points of the vertices: for the length of the traces on the surface
  Motorcycle_tracer(const Layout& layout, const std::vector<Point_3>& points, const TracingTraits& traits)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_motorcycles(layout, points, traits),
      m_stars(m_motorcycles.stars()),
      m_traces(m_motorcycles.traces())
  {
  }

  // Members refer to parts of another one.
  Motorcycle_tracer(const Motorcycle_tracer&) = delete;
  Motorcycle_tracer& operator=(const Motorcycle_tracer&) = delete;

  /// Traces the whole graph. The progress is that of the motorcycles that have ended.
  Motorcycle_graph_status trace(Progress& progress)
  {
    if (!progress.go_on())
      return Motorcycle_graph_status::INTERRUPTED;
    start_on_walls();
    start_at_cones();
    start_on_surfaces_without_cones();
    run(progress);
    start_on_free_sides(progress);
    return m_status;
  }

  std::size_t number_of_motorcycles() const { return m_traces.traces.size() - m_number_of_walls; }
  std::size_t number_of_seeds() const { return m_number_of_seeds; }
  std::size_t number_of_crossed_faces() const { return m_traces.chords.size(); }

  // For a `Motorcycle_graph`, once the tracing has come to its end.
  Stars take_stars() { return std::move(m_stars); }
  Traces take_traces() { return std::move(m_traces); }

private:
  // --- starts

  // Each border edge and each edge that is to be one of the T-mesh is a trace that is there from the beginning.
  void start_on_walls()
  {
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) != none && m_mesh.face(opposite(h)) == none)
        m_motorcycles.start_on_border(h);
    if (m_layout.has_constrained_edges())
      for (int e = 0; e < m_mesh.number_of_edges(); ++e)
        if (m_layout.is_constrained(e) && !m_motorcycles.start_on_wall(halfedge_of_edge(e)))
          m_status = Motorcycle_graph_status::TRACE_LOST;
    m_number_of_walls = m_traces.traces.size();
  }

  void start_at_cones()
  {
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v) {
      const int k = m_layout.quarter_turns(v);
      if (m_stars.is_on_border(v)) {
        if (k > 2)
          start_at_vertex(v, 1, k - 1);
      }
      else if (k != 4)
        start_at_vertex(v, 0, k - 1);
      else if (m_stars.has_star(v))
        start_between_walls(v);
    }
  }

  // Where walls end or turn at a regular vertex, faces would have an angle of more than two quarter turns.
  void start_between_walls(const int v)
  {
    const int star = m_stars.existing_star(v), n = m_stars.star(star).number_of_rays;
    std::vector<int> slots;
    for (int slot = 0; slot < n; ++slot)
      if (m_motorcycles.is_free(star, slot) &&
          (m_motorcycles.is_free(star, (slot + 1) % n) || m_motorcycles.is_free(star, (slot + n - 1) % n)))
        slots.push_back(slot);
    for (const int slot : slots)
      enqueue(m_motorcycles.start_at_vertex(star, slot));
  }

  // A component without border, cones and walls gets a seed, at its first vertex.
  void start_on_surfaces_without_cones()
  {
    std::vector<char> is_reached(m_mesh.number_of_vertices(), 0);
    std::vector<int> stack;
    const auto reach = [&](const int v) {
      if (is_reached[v] == 0) {
        is_reached[v] = 1;
        stack.push_back(v);
      }
    };
    const auto reach_component = [&]() {
      while (!stack.empty()) {
        const int first = m_stars.outgoing(stack.back());
        stack.pop_back();
        int h = first;
        do {
          reach(m_mesh.target(h));
          reach(m_mesh.target(m_mesh.next(h)));
          h = m_mesh.next_around_source(h);
        } while (h != first && m_mesh.face(h) != none);
      }
    };
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_layout.quarter_turns(v) != 4 || m_stars.is_on_border(v) || m_stars.has_star(v))
        reach(v);
    reach_component();
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (is_reached[v] == 0) {
        ++m_number_of_seeds;
        start_at_vertex(v, 0, 3);
        reach(v);
        reach_component();
      }
  }

  void start_at_vertex(const int v, const int first_slot, const int last_slot)
  {
    const int star = m_stars.star_of_vertex(v);
    if (last_slot >= m_stars.star(star).number_of_rays) { // predicates that are not exact have missed a ray
      m_status = Motorcycle_graph_status::TRACE_LOST;
      return;
    }
    for (int slot = first_slot; slot <= last_slot; ++slot)
      if (m_motorcycles.is_free(star, slot)) // it is no wall
        enqueue(m_motorcycles.start_at_vertex(star, slot));
  }

  // A wall that closes up gets a seed on each side on which no corner and no trace interrupts it: the face there would
  // be no disk.
  void start_on_free_sides(Progress& progress)
  {
    std::vector<char> is_checked; // per halfedge
    for (int v = 0; v < m_mesh.number_of_vertices() && m_status == Motorcycle_graph_status::SUCCESS; ++v) {
      if (!m_stars.has_star(v))
        continue;
      const int star = m_stars.existing_star(v);
      for (int slot = 0; slot < m_stars.star(star).number_of_rays; ++slot)
        if (is_wall(m_stars.ray(star, slot)) && side_is_free(m_stars.ray(star, slot).halfedge, is_checked)) {
          ++m_number_of_seeds;
          enqueue(m_motorcycles.start_at_vertex(star, slot + 1 == m_stars.star(star).number_of_rays ? 0 : slot + 1));
          run(progress);
        }
    }
  }

  // Whether a ray runs along a wall with the surface on its left.
  bool is_wall(const Vertex_ray& ray) const
  {
    return ray.is_along && m_mesh.face(ray.halfedge) != none &&
           (m_mesh.face(opposite(ray.halfedge)) == none || m_layout.is_constrained(edge_of(ray.halfedge)));
  }

  // Whether the wall along h closes up, on the left of h straight and without a trace that comes or leaves.
  bool side_is_free(const int h, std::vector<char>& is_checked)
  {
    is_checked.resize(m_mesh.number_of_halfedges(), 0);
    int g = h;
    do {
      if (is_checked[g] != 0 || m_motorcycles.is_met(g))
        return false;
      is_checked[g] = 1;
      const int star = m_stars.star_of_vertex(m_mesh.target(g));
      const int n = m_stars.star(star).number_of_rays, slot = m_stars.slot_along(star, opposite(g));
      if (slot == none || (m_stars.star(star).is_on_border && slot < 2) || n < 3)
        return false;
      const int straight = (slot + n - 2) % n;
      if (!m_motorcycles.is_free(star, (slot + n - 1) % n) || !is_wall(m_stars.ray(star, straight)))
        return false;
      g = m_stars.ray(star, straight).halfedge;
    } while (g != h);
    return true;
  }

  // --- the run

  void enqueue(const int trace) { m_queue.emplace(m_motorcycles.distance(trace), trace); }

  void run(Progress& progress)
  {
    for (std::size_t steps = 0; !m_queue.empty() && m_status == Motorcycle_graph_status::SUCCESS; ++steps) {
      if (steps % 1024 == 0)
        progress.progress(1 - static_cast<double>(m_queue.size()) / m_motorcycles.size());
      if (!progress.go_on_after(work_per_step)) {
        m_status = Motorcycle_graph_status::INTERRUPTED;
        return;
      }
      const int trace = m_queue.top().second;
      m_queue.pop();
      if (!m_motorcycles.has_ended(trace)) // else it was met by another one while it was waiting
        advance(trace);
    }
  }

  void advance(const int trace)
  {
    switch (m_motorcycles.advance(trace)) {
    case Motion::SPIRALS:
      set_seed(trace);
      enqueue(trace);
      break;
    case Motion::GOES_ON: enqueue(trace); break;
    case Motion::ENDS: break;
    case Motion::IS_LOST: m_status = Motorcycle_graph_status::TRACE_LOST; break;
    }
  }

  /// Sends two motorcycles to both sides of a trace, if there is room: else one of its next chords will do.
  void set_seed(const int trace)
  {
    m_tries.resize(m_motorcycles.size(), 0);
    if (++m_tries[trace] > maximal_seeds_per_trace) {
      m_status = Motorcycle_graph_status::TRACE_WITHOUT_END;
      return;
    }
    if (const std::optional<std::array<int, 2>> sideways = m_motorcycles.start_sideways(trace)) {
      ++m_number_of_seeds;
      for (const int side_trace : *sideways)
        advance(side_trace);
    }
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  Motorcycles<FT, TracingTraits> m_motorcycles;
  Stars& m_stars;
  Traces& m_traces;
  using Waiting = std::pair<double, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<Waiting>> m_queue; // by distance
  std::vector<int> m_tries; // per trace: how often a seed was asked for
  std::size_t m_number_of_walls = 0, m_number_of_seeds = 0;
  Motorcycle_graph_status m_status = Motorcycle_graph_status::SUCCESS;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H
