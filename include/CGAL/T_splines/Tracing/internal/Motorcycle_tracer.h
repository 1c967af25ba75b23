// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Lines_in_faces.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Spiral_detection.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/Tracing/internal/places_on_chords.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Sends motorcycles along the isolines of a seamless map until each has met a trace ([CZ17] section 8; Eppstein et al.
/// 2008).
///
/// A motorcycle advances by one face or edge at a time; the one that has travelled least on the surface goes next. It
/// stands in the interior of an edge, at a vertex, or, before its first step, inside a face. What it may meet is
/// looked for where it lies: chords strictly inside the face that it crosses; crossings and chords on the edge at
/// which it arrives; the rays of the vertex at which it arrives. Each meeting is decided by signs of exact expressions.
///
/// Where the scales of the transitions are not all 1, a trace may spiral towards a closed isoline for ever, its turns
/// ever closer. One that comes back to an edge in the same direction on a smaller scale (or very often at all, see `Spiral_detection`)
/// gets a seed in its way: two motorcycles leave it sideways, and its own next turn, or another's, meets them.
template <typename FT, typename TracingTraits>
class Motorcycle_tracer {
  using Layout = Seamless_layout<FT>;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Traces = Motorcycle_traces<FT>;
  using Number = typename Traces::Number;
  using Chord = typename Traces::Chord;
  using Edge_crossing = typename Traces::Edge_crossing;
  using Crossing_node = typename Traces::Crossing_node;
  using Point_3 = std::array<double, 3>;
  using Lines = Lines_in_faces<FT, TracingTraits>;
  using Gate = typename Lines::Gate;

  // Predicates that exact numbers decide, once in a while, are a part of it.
  static constexpr std::size_t work_per_step = 200;

public:
  static constexpr int none = -1;
  static constexpr int maximal_seeds_per_trace = 256;

  /// \param points of the vertices: for the length of the traces on the surface
  Motorcycle_tracer(const Layout& layout, const std::vector<Point_3>& points, const TracingTraits& traits)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_chart_points(layout, points),
      m_traits(traits),
      m_lines(layout, traits),
      m_stars(layout, traits),
      m_spirals(layout)
  {
    m_traces.first_chord_in_face.assign(m_mesh.number_of_faces(), none);
    m_traces.first_chord_along_edge.assign(m_mesh.number_of_edges(), none);
    m_traces.first_crossing_of_edge.assign(m_mesh.number_of_edges(), none);
  }

  /// Traces the whole graph. The progress is that of the motorcycles that have ended.
  Motorcycle_graph_status trace(Progress& progress)
  {
    if (!progress.go_on())
      return Motorcycle_graph_status::INTERRUPTED;
    trace_borders();
    start_at_cones();
    start_on_surfaces_without_cones();
    run(progress);
    for (int v = 0; v < m_mesh.number_of_vertices() && m_status == Motorcycle_graph_status::SUCCESS; ++v)
      if (m_stars.is_on_border(v) && border_loop_is_free(v)) {
        ++m_number_of_seeds;
        start_at_vertex(v, 1, 1);
        run(progress);
      }
    return m_status;
  }

  std::size_t number_of_motorcycles() const { return m_motorcycles.size() - m_number_of_border_traces; }
  std::size_t number_of_seeds() const { return m_number_of_seeds; }
  std::size_t number_of_crossed_faces() const { return m_traces.chords.size(); }

  // For a `Motorcycle_graph`, once the tracing has come to its end.
  Stars take_stars() { return std::move(m_stars); }
  Traces take_traces() { return std::move(m_traces); }

private:
  /// Where a motorcycle stands.
  struct Motorcycle {
    enum class Place { ON_EDGE, AT_VERTEX, INSIDE, ENDED };
    Place place = Place::ENDED;
    double distance = 0;
    Point_3 point = {};
    int halfedge = none;           ///< ON_EDGE: of the face ahead
    int star = none, slot = none;  ///< AT_VERTEX
    int face = none, start = none; ///< INSIDE
    int direction = 0;
    Number line;
    std::int64_t log_scale = 0;   ///< of the chart, against that of its start
    int seeds = 0, last_seed = 0; ///< how many it got, and after how many chords
  };

  enum class Ray_state : char { FREE, PENDING, TAKEN };
  struct Ray_occupation {
    Ray_state state = Ray_state::FREE;
    int trace = none;
  };

  // --- starts

  int new_trace(const Motorcycle& motorcycle, const int node, const int departure)
  {
    const int trace = static_cast<int>(m_motorcycles.size());
    m_motorcycles.push_back(motorcycle);
    m_traces.traces.emplace_back();
    m_traces.traces[trace].visits.push_back({node, none, false, none, departure});
    return trace;
  }

  void enqueue(const int trace) { m_queue.emplace(m_motorcycles[trace].distance, trace); }

  Ray_occupation& occupation(const int star, const int slot)
  {
    const std::size_t index = static_cast<std::size_t>(m_stars.star(star).first_ray + slot);
    if (m_occupation.size() <= index)
      m_occupation.resize(index + 1);
    return m_occupation[index];
  }

  void start_at_vertex(const int v, const int first_slot, const int last_slot)
  {
    const int star = m_stars.star_of_vertex(v);
    if (last_slot >= m_stars.star(star).number_of_rays)
      return lose(); // predicates that are not exact have missed a ray
    for (int slot = first_slot; slot <= last_slot; ++slot) {
      Motorcycle motorcycle;
      motorcycle.place = Motorcycle::Place::AT_VERTEX;
      motorcycle.point = m_chart_points.of_vertex(v);
      motorcycle.star = star;
      motorcycle.slot = slot;
      const int trace = new_trace(motorcycle, Traces::star_node(star), slot);
      occupation(star, slot) = {Ray_state::PENDING, trace};
      enqueue(trace);
    }
  }

  // Each border edge is a trace that is there from the beginning.
  void trace_borders()
  {
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if (m_mesh.face(h) == none || m_mesh.face(opposite(h)) != none)
        continue;
      const int star = m_stars.star_of_vertex(m_mesh.source(h)), end = m_stars.star_of_vertex(m_mesh.target(h));
      const int last = m_stars.star(end).number_of_rays - 1;
      const int trace = new_trace(Motorcycle(), Traces::star_node(star), 0);
      const int direction = m_stars.ray(star, 0).direction;
      const int chord =
          add_chord(trace, m_mesh.face(h), direction, m_layout.coordinate(h, axis_across(direction)), true, h);
      m_traces.traces[trace].visits.push_back({Traces::star_node(end), chord, true, last, none});
      occupation(star, 0) = {Ray_state::TAKEN, trace};
      occupation(end, last) = {Ray_state::TAKEN, trace};
    }
    m_number_of_border_traces = m_traces.traces.size();
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
    }
  }

  // A component without border and cones gets a seed, at its first vertex.
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
      if (m_layout.quarter_turns(v) != 4 || m_stars.is_on_border(v))
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

  // Whether no corner and no trace interrupts the border at v, a straight loop: the face inside would be no disk.
  bool border_loop_is_free(const int v)
  {
    const int first = m_stars.outgoing(v);
    int h = first;
    do {
      const int star = m_stars.star_of_vertex(m_mesh.source(h));
      if (m_stars.star(star).number_of_rays != 3 || occupation(star, 1).state != Ray_state::FREE ||
          m_traces.chords[m_traces.first_chord_along_edge[edge_of(h)]].first_node != none)
        return false;
      h = m_stars.outgoing(m_mesh.target(h));
    } while (h != first);
    return true;
  }

  // --- the run

  void run(Progress& progress)
  {
    for (std::size_t steps = 0; !m_queue.empty() && m_status == Motorcycle_graph_status::SUCCESS; ++steps) {
      if (steps % 1024 == 0)
        progress.progress(1 - static_cast<double>(m_queue.size()) / static_cast<double>(m_motorcycles.size()));
      if (!progress.go_on_after(work_per_step)) {
        m_status = Motorcycle_graph_status::INTERRUPTED;
        return;
      }
      const int trace = m_queue.top().second;
      m_queue.pop();
      if (m_motorcycles[trace].place == Motorcycle::Place::ENDED)
        continue; // met by another one while it was waiting
      advance(trace);
      if (m_motorcycles[trace].place != Motorcycle::Place::ENDED)
        enqueue(trace);
    }
  }

  void advance(const int trace)
  {
    const Motorcycle motorcycle = m_motorcycles[trace];
    switch (motorcycle.place) {
    case Motorcycle::Place::ON_EDGE:
      cross_face(trace, m_mesh.face(motorcycle.halfedge), motorcycle.direction, motorcycle.line,
                 {Gate::Kind::EDGE, motorcycle.halfedge, {}});
      break;
    case Motorcycle::Place::INSIDE:
      cross_face(trace, motorcycle.face, motorcycle.direction, motorcycle.line,
                 {Gate::Kind::INSIDE, none, m_traces.coordinates[motorcycle.start]});
      break;
    case Motorcycle::Place::AT_VERTEX: {
      occupation(motorcycle.star, motorcycle.slot).state = Ray_state::TAKEN;
      const Vertex_ray& ray = m_stars.ray(motorcycle.star, motorcycle.slot);
      const int h = ray.halfedge, before = m_mesh.previous(h);
      const Number line = m_layout.coordinate(before, axis_across(ray.direction));
      if (ray.is_along)
        go_along(trace, h, ray.direction, line);
      else
        cross_face(trace, m_mesh.face(h), ray.direction, line, {Gate::Kind::VERTEX, before, {}});
      break;
    }
    case Motorcycle::Place::ENDED: break;
    }
  }

  void lose() { m_status = Motorcycle_graph_status::TRACE_LOST; }

  // --- meetings in a face

  bool covers(const Chord& chord, const Number& along) const { return chord_covers(m_traces, m_lines, chord, along); }

  /// The first chord that a line meets strictly inside a face.
  int first_chord_ahead(const int face, const int direction, const Number& line, const Gate& entry,
                        const Gate& exit) const
  {
    int first = none;
    for (int c = m_traces.first_chord_in_face[face]; c != none; c = m_traces.chords[c].next_in_place) {
      const Chord& chord = m_traces.chords[c];
      if (axis_along(chord.direction) != axis_along(direction) &&
          (first == none || m_lines.is_ahead(direction, chord.line, m_traces.chords[first].line)) &&
          m_lines.is_inside_gate(entry, direction, line, chord.line, false) &&
          m_lines.is_inside_gate(exit, direction, line, chord.line, true) && covers(chord, line))
        first = c;
    }
    return first;
  }

  // --- steps

  int add_chord(const int trace, const int face, const int direction, const Number& line, const bool is_along,
                const int h)
  {
    const int c = static_cast<int>(m_traces.chords.size());
    Chord chord;
    chord.trace = trace;
    chord.ordinal = static_cast<int>(m_traces.traces[trace].chords.size());
    chord.face = face;
    chord.direction = direction;
    chord.line = line;
    chord.is_along = is_along;
    chord.halfedge = h;
    int& first = is_along ? m_traces.first_chord_along_edge[edge_of(h)] : m_traces.first_chord_in_face[face];
    chord.next_in_place = first;
    first = c;
    m_traces.chords.push_back(chord);
    m_traces.traces[trace].chords.push_back(c);
    return c;
  }

  void cross_face(const int trace, const int face, const int direction, const Number& line, const Gate& entry)
  {
    const Gate exit = m_lines.exit_of(face, direction, line, entry);
    if (exit.kind == Gate::Kind::INSIDE)
      return lose();
    const int met = first_chord_ahead(face, direction, line, entry, exit);
    const int c = add_chord(trace, face, direction, line, false, met != none ? none : exit.halfedge);
    if (entry.kind == Gate::Kind::INSIDE)
      m_traces.chords[c].start = m_motorcycles[trace].start;
    if (met != none) {
      m_traces.chords[c].stop = m_traces.add_coordinate(m_traces.chords[met].line);
      end_at(trace, c, node_on_chord(met, line), turned(direction, 2));
    }
    else if (exit.kind == Gate::Kind::VERTEX) {
      m_traces.chords[c].exit_parameter = 1;
      move_to(trace, m_chart_points.of_vertex(m_mesh.target(exit.halfedge)));
      const int star = m_stars.star_of_vertex(m_mesh.target(exit.halfedge));
      arrive_at_vertex(trace, c, star, m_stars.slot_in_corner(star, m_mesh.next(exit.halfedge), turned(direction, 2)));
    }
    else
      arrive_at_edge(trace, c, exit.halfedge);
  }

  void end_at(const int trace, const int chord, const int node, const int arrival)
  {
    m_traces.traces[trace].visits.push_back({node, chord, true, arrival, none});
    m_motorcycles[trace].place = Motorcycle::Place::ENDED;
  }

  void move_to(const int trace, const Point_3& point)
  {
    Motorcycle& motorcycle = m_motorcycles[trace];
    motorcycle.distance +=
        std::hypot(point[0] - motorcycle.point[0], point[1] - motorcycle.point[1], point[2] - motorcycle.point[2]);
    motorcycle.point = point;
  }

  /// The node at a place of a chord, made if it is new: the chord's trace visits it.
  int node_on_chord(const int c, const Number& along)
  {
    for (int n = m_traces.chords[c].first_node; n != none; n = m_traces.nodes[n].next_on_chord)
      if (m_traits.compare(m_traces.nodes[n].along, along) == CGAL::EQUAL)
        return Traces::crossing_node(n);
    const int n = static_cast<int>(m_traces.nodes.size());
    Chord& chord = m_traces.chords[c];
    m_traces.nodes.push_back({c, false, false, along, chord.first_node});
    chord.first_node = n;
    m_traces.traces[chord.trace].visits.push_back(
        {Traces::crossing_node(n), c, false, turned(chord.direction, 2), chord.direction});
    return Traces::crossing_node(n);
  }

  /// The node at a crossing of an edge, made if it is new. \param along in the chart of the crossing's chord
  int node_on_edge(const int crossing, const Number& along, const bool is_anywhere)
  {
    Edge_crossing& record = m_traces.crossings[crossing];
    if (record.node == none) {
      record.node = static_cast<int>(m_traces.nodes.size());
      const Chord& chord = m_traces.chords[record.chord];
      m_traces.nodes.push_back({record.chord, true, is_anywhere, along, none});
      m_traces.traces[chord.trace].visits.push_back(
          {Traces::crossing_node(record.node), record.chord, true, turned(chord.direction, 2), chord.direction});
    }
    Crossing_node& node = m_traces.nodes[record.node];
    if (node.is_anywhere && !is_anywhere) {
      node.along = along;
      node.is_anywhere = false;
    }
    return Traces::crossing_node(record.node);
  }

  std::pair<Number, int> across_edge(const int h, const Number& line, const int direction)
  {
    return line_across_edge(m_layout, m_traces.numbers, h, line, direction);
  }

  /// The motorcycle is in the interior of the edge of h, which belongs to the face that it has crossed.
  void arrive_at_edge(const int trace, const int c, const int h)
  {
    const int direction = m_traces.chords[c].direction, side = side_of_edge(h);
    const Number line = m_traces.chords[c].line;
    const double parameter = m_chart_points.parameter_on_edge(h, line, direction);
    m_traces.chords[c].exit_parameter = parameter;
    move_to(trace, m_chart_points.on_edge(h, parameter));
    for (int r = m_traces.first_crossing_of_edge[edge_of(h)]; r != none; r = m_traces.crossings[r].next_on_edge) {
      const Edge_crossing& record = m_traces.crossings[r];
      if (axis_along(record.direction[side]) == axis_along(direction)) {
        if (m_traits.compare(record.line[side], line) == CGAL::EQUAL)
          return meet_head_on(trace, c, r);
      }
      else if (m_traits.orientation(m_lines.corner(m_mesh.previous(h)), m_lines.corner(h),
                                    m_lines.point_on_line(direction, line, record.line[side])) == CGAL::ZERO)
        return end_on_edge(trace, c, h, r);
    }
    for (int b = m_traces.first_chord_along_edge[edge_of(h)]; b != none; b = m_traces.chords[b].next_in_place) {
      const auto [line_there, direction_there] =
          m_traces.chords[b].halfedge == h ? std::make_pair(line, direction) : across_edge(h, line, direction);
      if (covers(m_traces.chords[b], line_there)) {
        m_traces.chords[c].stop = m_traces.add_coordinate(m_layout.coordinate(h, axis_along(direction)));
        return end_at(trace, c, node_on_chord(b, line_there), turned(direction_there, 2));
      }
    }
    if (m_mesh.face(opposite(h)) == none)
      return lose();
    pass_edge(trace, c, h);
  }

  /// Two motorcycles on one isoline: the other one, waiting on the edge, ends too.
  void meet_head_on(const int trace, const int c, const int crossing)
  {
    const Chord& other = m_traces.chords[m_traces.crossings[crossing].chord];
    const int g = other.halfedge, axis = axis_along(other.direction);
    const double at_source = m_layout.uv(m_mesh.previous(g))[axis];
    const double along = at_source + other.exit_parameter * (m_layout.uv(g)[axis] - at_source);
    m_motorcycles[other.trace].place = Motorcycle::Place::ENDED;
    end_at(trace, c, node_on_edge(crossing, {along, along, nullptr}, true), other.direction);
  }

  /// Ends a trace at a crossing of the edge of h with another one, which comes from either side.
  void end_on_edge(const int trace, const int c, const int h, const int crossing)
  {
    Chord& chord = m_traces.chords[c];
    chord.stop = m_traces.add_coordinate(m_traces.crossings[crossing].line[side_of_edge(h)]);
    const bool is_same_side = m_traces.chords[m_traces.crossings[crossing].chord].halfedge == h;
    const auto [line, direction] =
        is_same_side ? std::make_pair(chord.line, chord.direction) : across_edge(h, chord.line, chord.direction);
    end_at(trace, c, node_on_edge(crossing, line, false), turned(direction, 2));
  }

  void pass_edge(const int trace, const int c, const int h)
  {
    const Chord& chord = m_traces.chords[c];
    const auto [line, direction] = across_edge(h, chord.line, chord.direction);
    Motorcycle& motorcycle = m_motorcycles[trace];
    int& first = m_traces.first_crossing_of_edge[edge_of(h)];
    Edge_crossing crossing = {c, first, none, {}, {}};
    crossing.line[side_of_edge(h)] = chord.line;
    crossing.direction[side_of_edge(h)] = chord.direction;
    crossing.line[side_of_edge(opposite(h))] = line;
    crossing.direction[side_of_edge(opposite(h))] = direction;
    first = static_cast<int>(m_traces.crossings.size());
    m_traces.chords[c].crossing = first;
    m_traces.crossings.push_back(crossing);
    m_spirals.add_crossing(motorcycle.log_scale);
    motorcycle.place = Motorcycle::Place::ON_EDGE;
    motorcycle.halfedge = opposite(h);
    motorcycle.direction = direction;
    motorcycle.line = line;
    motorcycle.log_scale += m_spirals.log_scale_across(h);
    if (m_spirals.is_endless(m_traces, first, h, motorcycle.last_seed))
      set_seed(trace, c);
  }

  // --- along edges and through vertices

  void go_along(const int trace, const int h, const int direction, const Number& line)
  {
    int nearest = none;
    for (int r = m_traces.first_crossing_of_edge[edge_of(h)]; r != none; r = m_traces.crossings[r].next_on_edge)
      if (nearest == none || m_lines.is_ahead(direction, m_traces.crossings[r].line[side_of_edge(h)],
                                              m_traces.crossings[nearest].line[side_of_edge(h)]))
        nearest = r;
    const int c = add_chord(trace, m_mesh.face(h), direction, line, true, h);
    if (nearest != none)
      return end_on_edge(trace, c, h, nearest);
    const int star = m_stars.star_of_vertex(m_mesh.target(h));
    move_to(trace, m_chart_points.of_vertex(m_mesh.target(h)));
    m_motorcycles[trace].log_scale += m_spirals.log_scale_across(h); // the ray there is seen from the other side
    arrive_at_vertex(trace, c, star, m_stars.slot_along(star, opposite(h)));
  }

  void arrive_at_vertex(const int trace, const int c, const int star, const int slot)
  {
    if (slot == none)
      return lose();
    const int n = m_stars.star(star).number_of_rays;
    m_traces.traces[trace].visits.push_back({Traces::star_node(star), c, true, slot, none});
    Motorcycle& motorcycle = m_motorcycles[trace];
    motorcycle.place = Motorcycle::Place::ENDED;
    Ray_occupation& here = occupation(star, slot);
    if (here.state == Ray_state::PENDING)
      m_motorcycles[here.trace].place = Motorcycle::Place::ENDED; // the two meet head-on
    const bool is_free = here.state == Ray_state::FREE;
    here = {Ray_state::TAKEN, trace};
    const int straight = (slot + 2) % n;
    if (!is_free || m_stars.star(star).is_on_border || n != 4 ||
        occupation(star, (slot + 1) % n).state != Ray_state::FREE ||
        occupation(star, (slot + 3) % n).state != Ray_state::FREE ||
        occupation(star, straight).state != Ray_state::FREE)
      return;
    m_traces.traces[trace].visits.back().departure = straight;
    occupation(star, straight) = {Ray_state::PENDING, trace};
    motorcycle.place = Motorcycle::Place::AT_VERTEX;
    motorcycle.star = star;
    motorcycle.slot = straight;
  }

  // --- seeds on spirals

  /// Sends two motorcycles to both sides from a place inside a chord that leaves its face.
  void set_seed(const int trace, const int c)
  {
    if (++m_motorcycles[trace].seeds > maximal_seeds_per_trace) {
      m_status = Motorcycle_graph_status::TRACE_WITHOUT_END;
      return;
    }
    const Chord chord = m_traces.chords[c];
    const std::optional<double> place = free_place_on_chord(m_layout, m_traces, m_lines, m_traits, chord);
    if (!place)
      return; // the chord is too short for a seed: one of the next ones will do
    const Number along = {*place, *place, nullptr};
    ++m_number_of_seeds;
    m_motorcycles[trace].last_seed = chord.ordinal + 1;
    const int node = node_on_chord(c, along);
    for (const int turn : {1, 3}) {
      Motorcycle motorcycle = m_motorcycles[trace];
      motorcycle.place = Motorcycle::Place::INSIDE;
      motorcycle.face = chord.face;
      motorcycle.start = m_traces.add_coordinate(chord.line);
      motorcycle.direction = turned(chord.direction, turn);
      motorcycle.line = along;
      motorcycle.seeds = motorcycle.last_seed = 0;
      const int side_trace = new_trace(motorcycle, node, motorcycle.direction);
      advance(side_trace);
      if (m_motorcycles[side_trace].place != Motorcycle::Place::ENDED)
        enqueue(side_trace);
    }
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  const Chart_points<FT> m_chart_points;
  const TracingTraits& m_traits;
  const Lines m_lines;
  Stars m_stars;
  Traces m_traces;
  std::vector<Motorcycle> m_motorcycles;    // per trace
  std::vector<Ray_occupation> m_occupation; // per ray of the stars
  Spiral_detection<FT> m_spirals;
  using Waiting = std::pair<double, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<Waiting>> m_queue;
  std::size_t m_number_of_border_traces = 0, m_number_of_seeds = 0;
  Motorcycle_graph_status m_status = Motorcycle_graph_status::SUCCESS;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACER_H
