// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Number_pool.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>

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
  static bool is_star(const int node) { return (node & 1) == 0; }

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
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_TRACES_H
