// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLES_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Lines_in_faces.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Spiral_detection.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/Tracing/internal/places_on_chords.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Motorcycles on the isolines of a seamless map, each at the head of the trace that has its number.
///
/// A motorcycle advances by one face or edge at a time. It stands in the interior of an edge, at a vertex, or, before
/// its first step, inside a face. What it may meet is looked for where it lies: chords strictly inside the face that it
/// crosses; crossings and chords on the edge at which it arrives; the rays of the vertex at which it arrives. Each
/// meeting is decided by signs of exact expressions.
template <typename FT, typename TracingTraits>
class Motorcycles {
  using Layout = Seamless_layout<FT>;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Traces = Motorcycle_traces<FT>;
  using Number = typename Traces::Number;
  using Chord = typename Traces::Chord;
  using Edge_crossing = typename Traces::Edge_crossing;
  using Lines = Lines_in_faces<FT, TracingTraits>;
  using Gate = typename Lines::Gate;

public:
  using Point_3 = std::array<double, 3>;
  static constexpr int none = -1;

  /// What a motorcycle does after a step.
  enum class Motion {
    GOES_ON,
    SPIRALS, ///< the same, but it seems to have no end; its last chord leaves a face
    ENDS,
    IS_LOST ///< predicates that are not exact contradict each other
  };

  /// \param points of the vertices: for the length of the traces on the surface
  Motorcycles(const Layout& layout, const std::vector<Point_3>& points, const TracingTraits& traits)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_chart_points(layout, points),
      m_traits(traits),
      m_lines(layout, traits),
      m_stars(layout, traits),
      m_traces(layout.mesh()),
      m_spirals(layout)
  {
  }

  Stars& stars() { return m_stars; }
  Traces& traces() { return m_traces; }
  int size() const { return static_cast<int>(m_motorcycles.size()); }

  bool has_ended(const int trace) const { return m_motorcycles[trace].place == Motorcycle::Place::ENDED; }

  /// The way that a motorcycle has made on the surface.
  double distance(const int trace) const { return m_motorcycles[trace].distance; }

  /// Whether no trace comes or leaves along a ray.
  bool is_free(const int star, const int slot) { return occupation(star, slot).state == Ray_state::FREE; }

  /// Puts a motorcycle at a vertex, to leave along a ray.
  int start_at_vertex(const int star, const int slot)
  {
    Motorcycle motorcycle;
    motorcycle.place = Motorcycle::Place::AT_VERTEX;
    motorcycle.point = m_chart_points.of_vertex(m_stars.star(star).vertex);
    motorcycle.star = star;
    motorcycle.slot = slot;
    const int trace = add(motorcycle, Traces::star_node(star), slot);
    occupation(star, slot) = {Ray_state::PENDING, trace};
    return trace;
  }

  /// Makes a border edge a trace, whose motorcycle has ended. \param h has the surface on its left
  void start_on_border(const int h)
  {
    const int star = m_stars.star_of_vertex(m_mesh.source(h)), end = m_stars.star_of_vertex(m_mesh.target(h));
    add_wall(h, star, 0, end, m_stars.star(end).number_of_rays - 1);
  }

  /// Makes an inner edge on an isoline a trace, whose motorcycle has ended.
  /// \return whether the edge lies on an isoline, as predicates that are not exact may deny
  bool start_on_wall(const int h)
  {
    const int star = m_stars.star_of_vertex(m_mesh.source(h)), end = m_stars.star_of_vertex(m_mesh.target(h));
    const int slot = m_stars.slot_along(star, h), end_slot = m_stars.slot_along(end, opposite(h));
    if (slot == none || end_slot == none || !is_free(star, slot) || !is_free(end, end_slot))
      return false;
    add_wall(h, star, slot, end, end_slot);
    return true;
  }

  /// Whether a motorcycle has ended inside the edge of h, which is a trace, on the left of h.
  bool is_met(const int h) const
  {
    const Chord& chord = m_traces.chords[m_traces.first_chord_along_edge[edge_of(h)]];
    return chord.is_met[chord.halfedge == h ? 0 : 1];
  }

  /// Puts two motorcycles on the last chord of a trace, which leaves its face, to go to both sides; none if the chord is
  /// too short.
  std::optional<std::array<int, 2>> start_sideways(const int trace)
  {
    const Chord chord = m_traces.chords[m_traces.traces[trace].chords.back()];
    const std::optional<double> place = free_place_on_chord(m_layout, m_traces, m_lines, m_traits, chord);
    if (!place)
      return std::nullopt;
    const Number along = {*place, *place, nullptr};
    m_motorcycles[trace].last_seed = chord.ordinal + 1;
    const int node = m_traces.node_on_chord(m_traces.traces[trace].chords.back(), along, m_traits);
    const auto start = [&](const int turn) {
      Motorcycle motorcycle = m_motorcycles[trace];
      motorcycle.place = Motorcycle::Place::INSIDE;
      motorcycle.face = chord.face;
      motorcycle.start = m_traces.add_coordinate(chord.line);
      motorcycle.direction = turned(chord.direction, turn);
      motorcycle.line = along;
      motorcycle.last_seed = 0;
      return add(motorcycle, node, motorcycle.direction);
    };
    const int left = start(1), right = start(3);
    return std::array<int, 2>{{left, right}};
  }

  /// \pre the motorcycle has not ended
  Motion advance(const int trace)
  {
    const Motorcycle motorcycle = m_motorcycles[trace];
    switch (motorcycle.place) {
    case Motorcycle::Place::ON_EDGE:
      return cross_face(trace, m_mesh.face(motorcycle.halfedge), motorcycle.direction, motorcycle.line,
                        {Gate::Kind::EDGE, motorcycle.halfedge, {}});
    case Motorcycle::Place::INSIDE:
      return cross_face(trace, motorcycle.face, motorcycle.direction, motorcycle.line,
                        {Gate::Kind::INSIDE, none, m_traces.coordinates[motorcycle.start]});
    case Motorcycle::Place::AT_VERTEX: {
      occupation(motorcycle.star, motorcycle.slot).state = Ray_state::TAKEN;
      const Vertex_ray& ray = m_stars.ray(motorcycle.star, motorcycle.slot);
      const int h = ray.halfedge, before = m_mesh.previous(h);
      const Number line = m_layout.coordinate(before, axis_across(ray.direction));
      return ray.is_along ? go_along(trace, h, ray.direction, line)
                          : cross_face(trace, m_mesh.face(h), ray.direction, line, {Gate::Kind::VERTEX, before, {}});
    }
    case Motorcycle::Place::ENDED: break;
    }
    return Motion::ENDS;
  }

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
    std::int64_t log_scale = 0; ///< of the chart, against that of its start
    int last_seed = 0;          ///< after how many chords two motorcycles were sent sideways
  };

  enum class Ray_state : char { FREE, PENDING, TAKEN };
  struct Ray_occupation {
    Ray_state state = Ray_state::FREE;
    int trace = none;
  };

  int add(const Motorcycle& motorcycle, const int node, const int departure)
  {
    m_motorcycles.push_back(motorcycle);
    return m_traces.add_trace(node, departure);
  }

  void add_wall(const int h, const int star, const int slot, const int end, const int end_slot)
  {
    const int trace = add(Motorcycle(), Traces::star_node(star), slot);
    const int direction = m_stars.ray(star, slot).direction;
    const int chord =
        m_traces.add_chord(trace, m_mesh.face(h), direction, m_layout.coordinate(h, axis_across(direction)), true, h);
    m_traces.add_arrival(chord, Traces::star_node(end), end_slot);
    occupation(star, slot) = {Ray_state::TAKEN, trace};
    occupation(end, end_slot) = {Ray_state::TAKEN, trace};
  }

  Ray_occupation& occupation(const int star, const int slot)
  {
    const std::size_t index = static_cast<std::size_t>(m_stars.star(star).first_ray + slot);
    if (m_occupation.size() <= index)
      m_occupation.resize(index + 1);
    return m_occupation[index];
  }

  Motion end_at(const int chord, const int node, const int arrival)
  {
    m_traces.add_arrival(chord, node, arrival);
    m_motorcycles[m_traces.chords[chord].trace].place = Motorcycle::Place::ENDED;
    return Motion::ENDS;
  }

  void move_to(const int trace, const Point_3& point)
  {
    Motorcycle& motorcycle = m_motorcycles[trace];
    motorcycle.distance +=
        std::hypot(point[0] - motorcycle.point[0], point[1] - motorcycle.point[1], point[2] - motorcycle.point[2]);
    motorcycle.point = point;
  }

  // --- through a face

  Motion cross_face(const int trace, const int face, const int direction, const Number& line, const Gate& entry)
  {
    const Gate exit = m_lines.exit_of(face, direction, line, entry);
    if (exit.kind == Gate::Kind::INSIDE)
      return Motion::IS_LOST;
    const int met = first_chord_ahead(face, direction, line, entry, exit);
    const int c = m_traces.add_chord(trace, face, direction, line, false, met != none ? none : exit.halfedge);
    if (entry.kind == Gate::Kind::INSIDE)
      m_traces.chords[c].start = m_motorcycles[trace].start;
    if (met != none) {
      m_traces.chords[c].stop = m_traces.add_coordinate(m_traces.chords[met].line);
      return end_at(c, m_traces.node_on_chord(met, line, m_traits), turned(direction, 2));
    }
    if (exit.kind == Gate::Kind::EDGE)
      return arrive_at_edge(trace, c, exit.halfedge);
    m_traces.chords[c].exit_parameter = 1;
    move_to(trace, m_chart_points.of_vertex(m_mesh.target(exit.halfedge)));
    const int star = m_stars.star_of_vertex(m_mesh.target(exit.halfedge));
    return arrive_at_vertex(trace, c, star,
                            m_stars.slot_in_corner(star, m_mesh.next(exit.halfedge), turned(direction, 2)));
  }

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

  bool covers(const Chord& chord, const Number& along) const { return chord_covers(m_traces, m_lines, chord, along); }

  // --- through the interior of an edge

  std::pair<Number, int> across_edge(const int h, const Number& line, const int direction)
  {
    return line_across_edge(m_layout, m_traces.numbers, h, line, direction);
  }

  /// The motorcycle is in the interior of the edge of h, which belongs to the face that it has crossed.
  Motion arrive_at_edge(const int trace, const int c, const int h)
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
          return meet_head_on(c, r);
      }
      else if (m_traits.orientation(m_lines.corner(m_mesh.previous(h)), m_lines.corner(h),
                                    m_lines.point_on_line(direction, line, record.line[side])) == CGAL::ZERO)
        return end_on_edge(c, h, r);
    }
    for (int b = m_traces.first_chord_along_edge[edge_of(h)]; b != none; b = m_traces.chords[b].next_in_place) {
      const auto [line_there, direction_there] =
          m_traces.chords[b].halfedge == h ? std::make_pair(line, direction) : across_edge(h, line, direction);
      if (covers(m_traces.chords[b], line_there)) {
        m_traces.chords[c].stop = m_traces.add_coordinate(m_layout.coordinate(h, axis_along(direction)));
        m_traces.chords[b].is_met[m_traces.chords[b].halfedge == h ? 0 : 1] = true;
        return end_at(c, m_traces.node_on_chord(b, line_there, m_traits), turned(direction_there, 2));
      }
    }
    return m_mesh.face(opposite(h)) == none ? Motion::IS_LOST : pass_edge(trace, c, h);
  }

  /// Two motorcycles on one isoline: the other one, waiting on the edge, ends too.
  Motion meet_head_on(const int c, const int crossing)
  {
    const Chord& other = m_traces.chords[m_traces.crossings[crossing].chord];
    const int g = other.halfedge, axis = axis_along(other.direction);
    const double at_source = m_layout.uv(m_mesh.previous(g))[axis];
    const double along = at_source + other.exit_parameter * (m_layout.uv(g)[axis] - at_source);
    m_motorcycles[other.trace].place = Motorcycle::Place::ENDED;
    return end_at(c, m_traces.node_on_edge(crossing, {along, along, nullptr}, true), other.direction);
  }

  /// Ends a trace at a crossing of the edge of h with another one, which comes from either side.
  Motion end_on_edge(const int c, const int h, const int crossing)
  {
    Chord& chord = m_traces.chords[c];
    chord.stop = m_traces.add_coordinate(m_traces.crossings[crossing].line[side_of_edge(h)]);
    const bool is_same_side = m_traces.chords[m_traces.crossings[crossing].chord].halfedge == h;
    const auto [line, direction] =
        is_same_side ? std::make_pair(chord.line, chord.direction) : across_edge(h, chord.line, chord.direction);
    return end_at(c, m_traces.node_on_edge(crossing, line, false), turned(direction, 2));
  }

  Motion pass_edge(const int trace, const int c, const int h)
  {
    const auto [line, direction] = across_edge(h, m_traces.chords[c].line, m_traces.chords[c].direction);
    const int crossing = m_traces.add_crossing(c, line, direction);
    Motorcycle& motorcycle = m_motorcycles[trace];
    m_spirals.add_crossing(motorcycle.log_scale);
    motorcycle.place = Motorcycle::Place::ON_EDGE;
    motorcycle.halfedge = opposite(h);
    motorcycle.direction = direction;
    motorcycle.line = line;
    motorcycle.log_scale += m_spirals.log_scale_across(h);
    return m_spirals.is_endless(m_traces, crossing, h, motorcycle.last_seed) ? Motion::SPIRALS : Motion::GOES_ON;
  }

  // --- along an edge and through a vertex

  Motion go_along(const int trace, const int h, const int direction, const Number& line)
  {
    const int side = side_of_edge(h);
    int nearest = none;
    for (int r = m_traces.first_crossing_of_edge[edge_of(h)]; r != none; r = m_traces.crossings[r].next_on_edge)
      if (nearest == none ||
          m_lines.is_ahead(direction, m_traces.crossings[r].line[side], m_traces.crossings[nearest].line[side]))
        nearest = r;
    const int c = m_traces.add_chord(trace, m_mesh.face(h), direction, line, true, h);
    if (nearest != none)
      return end_on_edge(c, h, nearest);
    const int star = m_stars.star_of_vertex(m_mesh.target(h));
    move_to(trace, m_chart_points.of_vertex(m_mesh.target(h)));
    m_motorcycles[trace].log_scale += m_spirals.log_scale_across(h); // the ray there is seen from the other side
    return arrive_at_vertex(trace, c, star, m_stars.slot_along(star, opposite(h)));
  }

  Motion arrive_at_vertex(const int trace, const int c, const int star, const int slot)
  {
    if (slot == none)
      return Motion::IS_LOST;
    const int n = m_stars.star(star).number_of_rays, straight = (slot + 2) % n;
    end_at(c, Traces::star_node(star), slot);
    Ray_occupation& here = occupation(star, slot);
    if (here.state == Ray_state::PENDING)
      m_motorcycles[here.trace].place = Motorcycle::Place::ENDED; // the two meet head-on
    const bool is_ray_free = here.state == Ray_state::FREE;
    here = {Ray_state::TAKEN, trace};
    if (!is_ray_free || m_stars.star(star).is_on_border || n != 4 || !is_free(star, (slot + 1) % n) ||
        !is_free(star, (slot + 3) % n) || !is_free(star, straight))
      return Motion::ENDS;
    m_traces.traces[trace].visits.back().departure = straight;
    occupation(star, straight) = {Ray_state::PENDING, trace};
    Motorcycle& motorcycle = m_motorcycles[trace];
    motorcycle.place = Motorcycle::Place::AT_VERTEX;
    motorcycle.star = star;
    motorcycle.slot = straight;
    return Motion::GOES_ON;
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
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLES_H
