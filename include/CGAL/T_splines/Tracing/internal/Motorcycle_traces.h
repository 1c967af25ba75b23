// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Number_pool.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/enum.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What the motorcycles leave behind: chords of faces, their crossings with edges, and the nodes where traces meet.
///
/// All numbers refer to the chart of the face that a chord lies in.
template <typename FT>
class Motorcycle_traces {
public:
  using Number = Enclosed_number<FT>;
  static constexpr int none = -1;

  /// A piece of a trace: across the interior of a face, or along an edge.
  struct Chord {
    int trace, ordinal; ///< the trace, and the number of chords before this one
    int face;
    int direction;
    bool is_along;
    int halfedge;              ///< along which it runs, or through which it leaves its face; none if it ends inside
    Number line;               ///< its constant coordinate
    int start = none;          ///< index of the coordinate where it starts inside the face or edge
    int stop = none;           ///< the same for where it stops
    int next_in_place = none;  ///< the next chord in the same face, or along the same edge
    int first_node = none;     ///< of the crossings inside it
    int crossing = none;       ///< of the edge through which it leaves its face
    double exit_parameter = 0; ///< place of that crossing on the halfedge, from 0 at its source to 1
    std::array<bool, 2> is_met = {
        {false, false}}; ///< along an edge: whether a trace ends inside it, from the left, right
  };

  /// A trace crosses the interior of an edge. Side 0 is the face of the even halfedge.
  struct Edge_crossing {
    int chord; ///< the one that leaves its face here
    int next_on_edge;
    int node;
    std::array<Number, 2> line;   ///< per side
    std::array<int, 2> direction; ///< per side
  };

  /// A place where traces meet, not at a vertex: on a chord. It has four slots, one per direction of the chord's chart.
  struct Crossing_node {
    int chord;
    bool is_at_end;   ///< on the edge through which the chord leaves its face
    bool is_anywhere; ///< only collinear traces have met here: any coordinate does
    Number along;     ///< the coordinate along the chord
    int next_on_chord;
  };

  /// A trace comes to a node. A node is named by a number: even for the stars of vertices, odd for crossing nodes.
  struct Visit {
    int node;
    int chord; ///< on which the trace comes; none at its start
    bool is_at_end;
    int arrival, departure; ///< slots; meaningless at the start and at the end of a trace
  };

  struct Trace {
    std::vector<Visit> visits;
    std::vector<int> chords;
  };

  static int star_node(const int star) { return 2 * star; }
  static int crossing_node(const int crossing) { return 2 * crossing + 1; }
  static bool is_star(const int node) { return node % 2 == 0; }
  static int star_of_node(const int node) { return node / 2; }
  static int crossing_of_node(const int node) { return node / 2; }

  explicit Motorcycle_traces(const Triangulation_connectivity& mesh)
    : first_chord_in_face(mesh.number_of_faces(), none),
      first_chord_along_edge(mesh.number_of_edges(), none),
      first_crossing_of_edge(mesh.number_of_edges(), none)
  {
  }

  /// \param node, departure where the trace starts, and by which slot it leaves
  int add_trace(const int node, const int departure)
  {
    traces.push_back({{{node, none, false, none, departure}}, {}});
    return static_cast<int>(traces.size()) - 1;
  }

  /// \param h along which the chord runs, or through which it leaves its face; none if it ends inside
  int add_chord(const int trace, const int face, const int direction, const Number& line, const bool is_along,
                const int h)
  {
    const int c = static_cast<int>(chords.size());
    Chord chord;
    chord.trace = trace;
    chord.ordinal = static_cast<int>(traces[trace].chords.size());
    chord.face = face;
    chord.direction = direction;
    chord.line = line;
    chord.is_along = is_along;
    chord.halfedge = h;
    int& first = is_along ? first_chord_along_edge[edge_of(h)] : first_chord_in_face[face];
    chord.next_in_place = first;
    first = c;
    chords.push_back(chord);
    traces[trace].chords.push_back(c);
    return c;
  }

  /// The trace of a chord comes to a node at the end of the chord.
  void add_arrival(const int chord, const int node, const int slot)
  {
    traces[chords[chord].trace].visits.push_back({node, chord, true, slot, none});
  }

  /// A chord leaves its face through the edge of its halfedge. \param line, direction as the other side sees them
  int add_crossing(const int c, const Number& line, const int direction)
  {
    Chord& chord = chords[c];
    const int here = side_of_edge(chord.halfedge), there = 1 - here;
    int& first = first_crossing_of_edge[edge_of(chord.halfedge)];
    Edge_crossing crossing = {c, first, none, {}, {}};
    crossing.line[here] = chord.line;
    crossing.direction[here] = chord.direction;
    crossing.line[there] = line;
    crossing.direction[there] = direction;
    chord.crossing = first = static_cast<int>(crossings.size());
    crossings.push_back(crossing);
    return first;
  }

  /// The node at a place of a chord, made if it is new: the chord's trace visits it.
  template <typename TracingTraits>
  int node_on_chord(const int c, const Number& along, const TracingTraits& traits)
  {
    for (int n = chords[c].first_node; n != none; n = nodes[n].next_on_chord)
      if (traits.compare(nodes[n].along, along) == CGAL::EQUAL)
        return crossing_node(n);
    const int n = static_cast<int>(nodes.size());
    nodes.push_back({c, false, false, along, chords[c].first_node});
    chords[c].first_node = n;
    pass(c, crossing_node(n), false);
    return crossing_node(n);
  }

  /// The node at a crossing of an edge, made if it is new. \param along in the chart of the crossing's chord
  int node_on_edge(const int crossing, const Number& along, const bool is_anywhere)
  {
    Edge_crossing& record = crossings[crossing];
    if (record.node == none) {
      record.node = static_cast<int>(nodes.size());
      nodes.push_back({record.chord, true, is_anywhere, along, none});
      pass(record.chord, crossing_node(record.node), true);
    }
    Crossing_node& node = nodes[record.node];
    if (node.is_anywhere && !is_anywhere) {
      node.along = along;
      node.is_anywhere = false;
    }
    return crossing_node(record.node);
  }

  int add_coordinate(const Number& x)
  {
    coordinates.push_back(x);
    return static_cast<int>(coordinates.size()) - 1;
  }

  std::vector<Trace> traces;
  std::vector<Chord> chords;
  std::vector<Edge_crossing> crossings;
  std::vector<Crossing_node> nodes;
  std::vector<Number> coordinates;
  std::vector<int> first_chord_in_face;    ///< per face: across its interior
  std::vector<int> first_chord_along_edge; ///< per edge
  std::vector<int> first_crossing_of_edge; ///< per edge
  Number_pool<FT> numbers;

private:
  /// The trace of a chord goes straight through a node on it.
  void pass(const int c, const int node, const bool is_at_end)
  {
    const Chord& chord = chords[c];
    traces[chord.trace].visits.push_back({node, c, is_at_end, turned(chord.direction, 2), chord.direction});
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H
