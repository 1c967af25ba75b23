// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_LINES_IN_FACES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_LINES_IN_FACES_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/Tracing_traits.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>

#include <CGAL/enum.h>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where isolines enter and leave the faces of a map, and where their points lie.
template <typename FT, typename TracingTraits>
class Lines_in_faces {
public:
  using Number = Enclosed_number<FT>;
  static constexpr int none = -1;

  /// How a line comes into a face and leaves it.
  struct Gate {
    enum class Kind { EDGE, VERTEX, INSIDE } kind;
    int halfedge; ///< EDGE: of the face; VERTEX: with the vertex as target, of the face
    Number along; ///< INSIDE
  };

  Lines_in_faces(const Seamless_layout<FT>& layout, const TracingTraits& traits)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_traits(traits)
  {
  }

  /// Where a line leaves a face: the counter-clockwise boundary passes there from the right of the line to its left. A
  /// line along an edge leaves at the vertex where the edge ends. The kind is INSIDE if the line does not meet the face.
  Gate exit_of(const int face, const int direction, const Number& line, const Gate& entry) const
  {
    if (entry.kind == Gate::Kind::VERTEX) // the line enters the interior of the face
      return {Gate::Kind::EDGE, m_mesh.previous(entry.halfedge), {}};
    if (entry.kind == Gate::Kind::EDGE) { // whose source is on the left
      const int apex = m_mesh.next(entry.halfedge);
      const CGAL::Sign s = side(apex, direction, line);
      if (s == CGAL::ZERO)
        return {Gate::Kind::VERTEX, apex, {}};
      return {Gate::Kind::EDGE, s == CGAL::POSITIVE ? apex : m_mesh.next(apex), {}};
    }
    int h = m_mesh.halfedge_of_face(face);
    for (int i = 0; i < 3; ++i, h = m_mesh.next(h)) {
      const CGAL::Sign source = side(m_mesh.previous(h), direction, line), target = side(h, direction, line);
      if (source == CGAL::NEGATIVE && target == CGAL::POSITIVE)
        return {Gate::Kind::EDGE, h, {}};
      if (source == CGAL::NEGATIVE && target == CGAL::ZERO)
        return {Gate::Kind::VERTEX, h, {}};
      if (source == CGAL::ZERO && target == CGAL::ZERO && side(m_mesh.next(h), direction, line) == CGAL::POSITIVE)
        return {Gate::Kind::VERTEX, h, {}};
    }
    return {Gate::Kind::INSIDE, none, {}};
  }

  Enclosed_point<FT> corner(const int h) const { return {m_layout.coordinate(h, 0), m_layout.coordinate(h, 1)}; }

  static Enclosed_point<FT> point_on_line(const int direction, const Number& line, const Number& along)
  {
    return axis_along(direction) == 0 ? Enclosed_point<FT>{along, line} : Enclosed_point<FT>{line, along};
  }

  /// Whether `b` comes after `a` on a line of this direction.
  bool is_ahead(const int direction, const Number& a, const Number& b) const
  {
    return m_traits.compare(a, b) == (is_forward(direction) ? CGAL::SMALLER : CGAL::LARGER);
  }

  /// Whether the point of a line lies strictly on the inner side of a gate of the face.
  /// \param is_exit whether the line leaves through the gate, or else enters
  bool is_inside_gate(const Gate& gate, const int direction, const Number& line, const Number& along,
                      const bool is_exit) const
  {
    if (gate.kind == Gate::Kind::EDGE)
      return m_traits.orientation(corner(m_mesh.previous(gate.halfedge)), corner(gate.halfedge),
                                  point_on_line(direction, line, along)) == CGAL::POSITIVE;
    const Number at_gate =
        gate.kind == Gate::Kind::VERTEX ? m_layout.coordinate(gate.halfedge, axis_along(direction)) : gate.along;
    return is_exit ? is_ahead(direction, along, at_gate) : is_ahead(direction, at_gate, along);
  }

  /// Whether the point of a line that leaves through an edge lies beyond the edge.
  bool is_beyond_gate(const Gate& exit, const int direction, const Number& line, const Number& along) const
  {
    return m_traits.orientation(corner(m_mesh.previous(exit.halfedge)), corner(exit.halfedge),
                                point_on_line(direction, line, along)) == CGAL::NEGATIVE;
  }

private:
  CGAL::Sign side(const int corner, const int direction, const Number& line) const
  {
    return side_of_line(direction, m_traits.compare(m_layout.coordinate(corner, axis_across(direction)), line));
  }

  const Seamless_layout<FT>& m_layout;
  const Triangulation_connectivity& m_mesh;
  const TracingTraits& m_traits;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_LINES_IN_FACES_H
