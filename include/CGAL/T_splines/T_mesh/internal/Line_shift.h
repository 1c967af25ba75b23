// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_LINE_SHIFT_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_LINE_SHIFT_H

#include <CGAL/T_splines/T_mesh/T_mesh_edit.h>
#include <CGAL/T_splines/T_mesh/internal/T_mesh_surgery.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Moves a maximal straight line of edges of a T-mesh to its side.
//
// Lengths of the edges that meet the line orthogonally change by the displacement, in each face's own units; nothing
// else changes, as each face that the line touches has a full side on it.
template <typename TMesh, typename Observer>
class Line_shift {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename TMesh::vertex_descriptor;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using face_descriptor = typename TMesh::face_descriptor;
  using Surgery = T_mesh_surgery<TMesh, Observer>;
  using FT = typename Surgery::FT;
  using Piece = typename Surgery::Piece;
  using Status = T_mesh_edit_status;
  template <typename T>
  using Hash_set = std::unordered_set<T, boost::hash<T>>;
  template <typename T, typename Value>
  using Hash_map = std::unordered_map<T, Value, boost::hash<T>>;

  // An edge of the line, directed along it; the unit of the face of the line's first halfedge, in that of this face.
  struct Link {
    halfedge_descriptor h;
    FT unit;
  };

  // By how much a knot changes: in all, and without the gains.
  struct Change {
    FT all, loss;
  };

public:
  explicit Line_shift(Surgery& surgery) : m_surgery(surgery), m_graph(surgery.t_mesh().graph()) {}

  template <typename IsFixed>
  Status shift(const halfedge_descriptor h, const FT& delta, const IsFixed& is_fixed)
  {
    Status status = find_line(h, is_fixed);
    if (status == Status::DONE)
      status = find_changes(delta);
    if (status != Status::DONE)
      return status;
    const std::vector<Piece> pieces = find_pieces(delta);
    for (const auto& change : m_changes)
      m_surgery.t_mesh().set_knot(change.first, FT(knot(change.first) + change.second.all));
    for (const Link& link : m_line)
      m_surgery.observer().vertex_moved(target(link.h, m_graph), link.h);
    if (!m_is_closed) {
      const halfedge_descriptor o = opposite(m_line.front().h, m_graph);
      m_surgery.observer().vertex_moved(target(o, m_graph), o);
    }
    m_surgery.report_pieces(pieces);
    return Status::DONE;
  }

private:
  FT knot(const halfedge_descriptor h) const { return m_surgery.t_mesh().knot(h); }
  bool is_corner(const halfedge_descriptor h) const { return m_surgery.t_mesh().is_corner(h); }
  bool is_border(const halfedge_descriptor h) const { return face(h, m_graph) == Traits::null_face(); }
  FT ratio(const halfedge_descriptor h) const { return knot(opposite(h, m_graph)) / knot(h); }

  template <typename IsFixed>
  Status find_line(const halfedge_descriptor h, const IsFixed& is_fixed)
  {
    std::vector<Link> forward, backward;
    Status status = follow(h, is_fixed, forward);
    if (status != Status::DONE)
      return status;
    if (!m_is_closed) {
      const halfedge_descriptor o = opposite(h, m_graph);
      status = follow(o, is_fixed, backward);
      if (status != Status::DONE)
        return status;
      const FT unit = ratio(h);
      for (std::size_t i = backward.size() - 1; i > 0; --i) {
        const halfedge_descriptor b = backward[i].h;
        m_line.push_back({opposite(b, m_graph), FT(unit * backward[i].unit * ratio(b))});
      }
    }
    m_line.insert(m_line.end(), forward.begin(), forward.end());
    return Status::DONE;
  }

  // Collects the line from the edge of h in its direction, up to its end or back to h.
  template <typename IsFixed>
  Status follow(const halfedge_descriptor start, const IsFixed& is_fixed, std::vector<Link>& line)
  {
    Link link{start, FT(1)};
    while (true) {
      const halfedge_descriptor h = link.h;
      if (is_border(h) || is_border(opposite(h, m_graph)))
        return line.empty() ? Status::NO_FACE : Status::NO_FREE_LINE;
      if (m_surgery.t_mesh().is_crease(h))
        return Status::CREASE;
      if (is_fixed(target(h, m_graph)))
        return Status::FIXED_VERTEX;
      line.push_back(link);
      link.h = next(h, m_graph);
      if (is_corner(h)) {
        const halfedge_descriptor across = opposite(link.h, m_graph);
        if (is_border(across))
          return Status::NO_FREE_LINE;
        if (!is_corner(across))
          return Status::DONE; // an orthogonal line passes
        link.unit *= ratio(link.h);
        link.h = next(across, m_graph);
      }
      if (link.h == start) {
        m_is_closed = true;
        // otherwise it would spiral when shifted
        return is_same_unit(link.unit) ? Status::DONE : Status::NO_FREE_LINE;
      }
    }
  }

  // The edge of h, which meets the line, becomes longer by delta in the units of the face of the line's first halfedge;
  // unit is that one in the units of the face of h.
  void change(const halfedge_descriptor h, const FT& unit, const FT& delta)
  {
    const halfedge_descriptor o = opposite(h, m_graph);
    const FT change = unit * delta;
    const auto add = [this](const halfedge_descriptor i, const FT& c) {
      Change& total = m_changes.emplace(i, Change{FT(0), FT(0)}).first->second;
      total.all += c;
      if (c < FT(0))
        total.loss += c;
    };
    add(h, change);
    if (!is_border(o))
      add(o, FT(change * ratio(h)));
  }

  Status find_changes(const FT& delta)
  {
    Hash_set<halfedge_descriptor> line;
    for (const Link& link : m_line) {
      line.insert(link.h);
      line.insert(opposite(link.h, m_graph));
    }
    const FT minus_delta = -delta;
    for (std::size_t i = 0; i < m_line.size(); ++i) {
      // At the source of the edge: what meets the line from the left and from the right.
      const Link& link = m_line[i];
      const halfedge_descriptor o = opposite(link.h, m_graph);
      const FT right_unit = link.unit * ratio(link.h);
      if (is_corner(prev(link.h, m_graph)))
        change(prev(link.h, m_graph), link.unit, delta);
      if (is_corner(o))
        change(next(o, m_graph), right_unit, minus_delta);
      if (i + 1 == m_line.size() && !m_is_closed) {
        change(next(link.h, m_graph), link.unit, delta);
        change(prev(o, m_graph), right_unit, minus_delta);
      }
    }
    for (const auto& c : m_changes) {
      if (line.count(c.first) != 0)
        return Status::LINE_MEETS_ITSELF;
      // Where an edge ends at the line on both sides, neither side may reach the place where the other was: the strips
      // between old and new line would overlap.
      const FT rest = knot(c.first) + c.second.loss;
      if (!(rest > FT(0)) || !CGAL::is_finite(c.second.all) || rest < knot_tolerance(knot(c.first)))
        return Status::OUTSIDE;
    }
    return Status::DONE;
  }

  // Each side of a face that lies on the line is counted at its first halfedge: how far it moves outwards.
  std::vector<Piece> find_pieces(const FT& delta)
  {
    Hash_map<face_descriptor, std::size_t> index;
    std::vector<std::pair<face_descriptor, std::array<FT, 4>>> moved;
    const auto move = [&](const halfedge_descriptor h, const FT& distance) {
      if (!is_corner(prev(h, m_graph)))
        return;
      const face_descriptor f = face(h, m_graph);
      const auto inserted = index.emplace(f, moved.size());
      if (inserted.second)
        moved.emplace_back(f, std::array<FT, 4>{FT(0), FT(0), FT(0), FT(0)});
      moved[inserted.first->second].second[m_surgery.coordinates().side(h)] += distance;
    };
    for (const Link& link : m_line) {
      move(link.h, FT(link.unit * delta));
      move(opposite(link.h, m_graph), FT(-(link.unit * ratio(link.h) * delta)));
    }

    std::vector<Piece> pieces;
    for (const auto& m : moved) {
      const std::array<FT, 4>& d = m.second;
      pieces.push_back(Piece{m.first, m.first, Similarity_2<FT>(0, FT(1), d[3], d[0]),
                             FT(m_surgery.coordinates().width(m.first) + d[1] + d[3]),
                             FT(m_surgery.coordinates().height(m.first) + d[0] + d[2])});
    }
    // Then the strips that change faces, once for each pair of faces that touch.
    for (const Link& link : m_line) {
      const halfedge_descriptor o = opposite(link.h, m_graph);
      if (!is_corner(prev(link.h, m_graph)) && !is_corner(o))
        continue;
      const halfedge_descriptor loser = delta > FT(0) ? o : link.h;
      const Piece& winner = pieces[index[face(opposite(loser, m_graph), m_graph)]];
      Piece strip = winner;
      strip.from = face(loser, m_graph);
      strip.transition = compose(winner.transition, m_surgery.coordinates().transition(loser));
      pieces.push_back(strip);
    }
    return pieces;
  }

  Surgery& m_surgery;
  const Graph& m_graph;
  std::vector<Link> m_line;
  bool m_is_closed = false;
  Hash_map<halfedge_descriptor, Change> m_changes;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_LINE_SHIFT_H
