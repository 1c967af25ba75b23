// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_REGULARIZATION_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_REGULARIZATION_H

#include <CGAL/T_splines/T_mesh/internal/Removal_sizes.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/internal/Changed_faces.h>
#include <CGAL/T_splines/T_mesh/support/Split_position.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// A short fraction of powers of two that is near x, 0 < x < 1: three significant bits.
inline std::pair<int, int> short_fraction(const double x)
{
  int exponent;
  const double mantissa = std::frexp(x, &exponent); // in [1/2, 1)
  return {static_cast<int>(std::lround(mantissa * 8)), exponent - 3};
}

// The greedy improvement of a T-mesh ([CZ17] section 8.1), its state between operations.
// \tparam TMesh a `T_mesh_view`
template <typename TMesh, typename Observer, typename VertexIsConstrainedMap>
class T_mesh_regularization {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using face_descriptor = typename TMesh::face_descriptor;
  using Editor_observer = T_mesh_observer_pair<typename Changed_faces<Graph>::Observer, Observer>;
  using Editor = T_mesh_editor<TMesh, Editor_observer, VertexIsConstrainedMap>;
  using FT = typename Editor::FT;
  using Sizes = Removal_sizes;

  // The part from `from` to `to`, as fractions, of the overlap of the two faces of `h` is to be removed.
  struct Removal {
    halfedge_descriptor h;
    double from, to;
    double cost;
    bool is_full; // no orthogonal edge is inserted
  };

  struct Entry {
    double aspect;
    std::size_t stamp;
    face_descriptor f;

    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.aspect != b.aspect ? a.aspect < b.aspect : a.stamp > b.stamp;
    }
  };

public:
  struct Counts {
    std::size_t removals = 0, flips = 0, partial_removals = 0, closed_gaps = 0;
    std::size_t sum() const { return removals + flips + partial_removals + closed_gaps; }
  };

  // An operation must make the worst of the faces better by this factor. Then it ends: the sequence of all aspect
  // ratios, rounded down to powers of the factor, sorted decreasingly, decreases lexicographically.
  static constexpr double gain = 0.95;

  // Chosen by experiments on 58 motorcycle graphs: of two operations, one with one face more must have an aspect ratio
  // that is better by this factor,
  static constexpr double face_cost = 1.5;
  // and where no face is worse than this, none is added.
  static constexpr double small_aspect = 3;

  // Where two lines end on opposite sides of a third one, closer to each other than this part of a face between them,
  // one of them is shortened,
  static constexpr double smallest_gap = 1 / 16.;

  // unless a face became worse than the worst one, or than this.
  static constexpr double aspect_at_gap = 5;

  // Faces at least as long, by their width, come first: they lie between lines of two extraordinary vertices that face
  // each other and miss each other by little.
  static constexpr double thin = Removal_sizes::thin;

  // There an operation is executed only if no face is expected to be worse than this in the end.
  static constexpr double largest_expected_aspect = 8;

  T_mesh_regularization(const TMesh& t_mesh, const Observer& observer,
                        const VertexIsConstrainedMap vertex_is_constrained)
    : m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_split_position(t_mesh),
      m_editor(t_mesh, Editor_observer(m_changed_faces.observer(), observer), vertex_is_constrained)
  {
  }

  // Executes at most the given number of operations. The progress is that of the logarithm of the worst aspect ratio.
  Counts run(const std::size_t number_of_operations, Progress& progress)
  {
    progress.go_on();
    m_counts = Counts();
    m_first_aspect = worst_aspect();
    execute_all(Purpose::SEPARATION, number_of_operations, progress);
    if (m_counts.sum() > 0) // the lines that are separated end next to each other
      close_gaps(Purpose::SEPARATION, number_of_operations, progress);
    execute_all(Purpose::ASPECT, number_of_operations, progress);
    close_gaps(Purpose::ASPECT, number_of_operations, progress);
    return m_counts;
  }

  double aspect(const face_descriptor f) const
  {
    return aspect_ratio(CGAL::to_double(m_editor.coordinates().width(f)),
                        CGAL::to_double(m_editor.coordinates().height(f)));
  }

private:
  static constexpr std::size_t work_per_face = 100, work_per_operation = 2000;

  // What an operation is for: that the lines beside a thin face end, though at first what is left of it is as thin; or
  // better aspect ratios.
  enum class Purpose { SEPARATION, ASPECT };

  double worst_aspect() const
  {
    double result = 1;
    for (const face_descriptor f : faces(m_graph))
      result = (std::max)(result, aspect(f));
    return result;
  }

  // The worst faces first.
  void execute_all(const Purpose purpose, const std::size_t number_of_operations, Progress& progress)
  {
    m_queue = {};
    m_stamps.clear();
    m_changed_faces.clear();
    for (const face_descriptor f : faces(m_graph))
      push(f);
    while (!m_queue.empty() && m_counts.sum() < number_of_operations && progress.go_on_after(work_per_face)) {
      const Entry entry = m_queue.top();
      m_queue.pop();
      const auto stamp = m_stamps.find(entry.f);
      if (stamp == m_stamps.end() || stamp->second != entry.stamp)
        continue;
      if (purpose == Purpose::SEPARATION && entry.aspect < thin)
        return;
      Removal best{Traits::null_halfedge(), 0, 1, std::numeric_limits<double>::infinity(), true};
      if (find_removal(entry.f, purpose, best) && execute(best)) {
        ++(best.is_full                     ? m_counts.removals
           : best.from == 0 && best.to == 1 ? m_counts.flips
                                            : m_counts.partial_removals);
        update_queue();
        progress.progress(1 - std::log(entry.aspect) / std::log(m_first_aspect));
        progress.go_on_after(work_per_operation);
      }
    }
  }

  // The narrowest gaps first.
  void close_gaps(const Purpose purpose, const std::size_t number_of_operations, Progress& progress)
  {
    const std::size_t number_of_gaps = gaps().size();
    for (std::size_t i = 0; i < number_of_gaps && m_counts.sum() < number_of_operations && progress.go_on(); ++i) {
      if (!close_a_gap(purpose))
        return;
      ++m_counts.closed_gaps;
    }
  }

  void push(const face_descriptor f)
  {
    m_stamps[f] = ++m_last_stamp;
    m_queue.push({aspect(f), m_last_stamp, f});
  }

  void update_queue()
  {
    for (const face_descriptor f : m_changed_faces.removed())
      m_stamps.erase(f);
    std::vector<face_descriptor> near;
    for (const face_descriptor f : m_changed_faces.changed()) {
      near.push_back(f);
      for (const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_graph), m_graph)) {
        const face_descriptor g = face(opposite(h, m_graph), m_graph);
        if (g != Traits::null_face() && g != near.back())
          near.push_back(g);
      }
    }
    const std::size_t first_stamp = m_last_stamp;
    for (const face_descriptor f : near) {
      const auto stamp = m_stamps.find(f);
      if (stamp == m_stamps.end() || stamp->second <= first_stamp)
        push(f);
    }
    m_changed_faces.clear();
  }

  // Finds the best removal on the long sides of f.
  bool find_removal(const face_descriptor f, const Purpose purpose, Removal& best) const
  {
    const bool is_wide = m_editor.coordinates().width(f) >= m_editor.coordinates().height(f);
    bool is_found = false;
    for (const int side : {is_wide ? 0 : 1, is_wide ? 2 : 3}) {
      halfedge_descriptor h = m_editor.coordinates().first_of_side(f, side);
      while (true) {
        const face_descriptor g = face(opposite(h, m_graph), m_graph);
        if (g != Traits::null_face() && g != f && !m_t_mesh.is_crease(h)) {
          const auto overlap = m_editor.overlap(h);
          is_found = find_removal(overlap, sizes(overlap), purpose, best) || is_found;
          h = overlap.last;
        }
        if (m_t_mesh.is_corner(h))
          break;
        h = next(h, m_graph);
      }
    }
    return is_found;
  }

  Sizes sizes(const typename Editor::Overlap& o) const
  {
    const halfedge_descriptor opposite_first = opposite(o.first, m_graph);
    const double scale = CGAL::to_double(o.scale), length = CGAL::to_double(FT(o.end - o.begin));
    const FT opposite_after = o.opposite_side_length - o.opposite_begin - FT(o.end - o.begin) / o.scale;
    Sizes result;
    result.length = length;
    result.depth = {depth(o.first), scale * depth(opposite_first)};
    result.before = {reach(o.begin, m_t_mesh.is_corner(prev(o.first, m_graph))),
                     scale * reach(opposite_after, m_t_mesh.is_corner(opposite_first))};
    result.after = {reach(FT(o.side_length - o.end), m_t_mesh.is_corner(o.last)),
                    scale * reach(o.opposite_begin, m_t_mesh.is_corner(prev(opposite(o.last, m_graph), m_graph)))};
    result.first_is_fixed = m_editor.is_fixed(target(opposite_first, m_graph));
    result.last_is_fixed = m_editor.is_fixed(target(o.last, m_graph));
    result.opens_at_first = {opens(o.first, false), opens(opposite_first, true)};
    result.opens_at_last = {opens(o.first, true), opens(opposite_first, false)};
    result.first_stub = stub(o.first);
    result.last_stub = scale * stub(opposite(o.last, m_graph));
    return result;
  }

  // Whether the side of a face opposite to that of h may be removed from where the side of h ends, or begins.
  bool opens(const halfedge_descriptor h, const bool at_end) const
  {
    const auto& coordinates = m_editor.coordinates();
    const face_descriptor f = face(h, m_graph);
    const int side = (coordinates.side(h) + 2) % 4;
    const halfedge_descriptor first = coordinates.first_of_side(f, side),
                              e = at_end ? first : coordinates.last_of_side(first);
    const face_descriptor behind = face(opposite(e, m_graph), m_graph);
    return behind != Traits::null_face() && behind != f &&
           !m_editor.is_fixed(at_end ? source(e, m_graph) : target(e, m_graph));
  }

  // If the line of h goes on before h, through an orthogonal line, to a fixed vertex: how far it is; or 0.
  double stub(const halfedge_descriptor h) const
  {
    const halfedge_descriptor side = prev(h, m_graph), across = opposite(side, m_graph);
    if (!m_t_mesh.is_corner(side) || face(across, m_graph) == Traits::null_face())
      return 0;
    const halfedge_descriptor before = prev(across, m_graph);
    if (!m_t_mesh.is_corner(before) || !m_editor.is_fixed(source(before, m_graph)))
      return 0;
    return CGAL::to_double(FT(m_t_mesh.knot(before))) * CGAL::to_double(FT(m_t_mesh.knot(side))) /
           CGAL::to_double(FT(m_t_mesh.knot(across)));
  }

  static double reach(const FT& x, const bool is_corner) { return is_corner ? 0 : CGAL::to_double(x); }

  double depth(const halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_graph);
    const bool is_horizontal = m_editor.coordinates().side(h) % 2 == 0;
    return CGAL::to_double(is_horizontal ? m_editor.coordinates().height(f) : m_editor.coordinates().width(f));
  }

  // Tries the ends of an overlap, and points at which the faces cut off there are about as wide as long; where lines are to
  // be separated, points near its middle, too.
  bool find_removal(const typename Editor::Overlap& o, const Sizes& s, const Purpose purpose, Removal& best) const
  {
    std::vector<double> first = fractions(s, s.before), last = fractions(s, s.after);
    if (purpose == Purpose::SEPARATION)
      for (const double fraction : {1 / 4., 3 / 8., 1 / 2.}) {
        first.push_back(fraction);
        last.push_back(fraction);
      }
    if (!s.first_is_fixed)
      first.push_back(0);
    if (!s.last_is_fixed)
      last.push_back(0);
    const double old_aspect = s.old_aspect(), enough = gain * old_aspect;
    bool is_found = false;
    for (const double x : first) {
      for (const double y : last) {
        if (!(x + y < 1))
          continue;
        const double aspect = s.new_aspect(x * s.length, (1 - y) * s.length);
        const int added_faces = s.added_faces(x, y);
        const double expected =
            purpose == Purpose::ASPECT ? aspect : s.expected_aspect(x * s.length, (1 - y) * s.length);
        const double cost = expected * std::pow(face_cost, added_faces);
        if (!(aspect <= enough) || (added_faces > 0 && old_aspect < small_aspect) || !(cost < best.cost) ||
            (purpose == Purpose::SEPARATION && expected > largest_expected_aspect))
          continue;
        best = {o.first, x, 1 - y, cost, added_faces == -1};
        is_found = true;
      }
    }
    return is_found;
  }

  // Where a removal may begin, as fractions of the overlap's length; exact doubles. What is left of the two faces
  // becomes about as long as they are wide, or half or double that.
  static std::vector<double> fractions(const Sizes& s, const std::array<double, 2>& reach)
  {
    std::vector<double> lengths{std::sqrt(s.depth[0] * s.depth[1]), (s.depth[0] + s.depth[1]) / 2};
    for (int i = 0; i < 2; ++i) {
      for (const double factor : {0.5, 1., 2.})
        lengths.push_back(factor * s.depth[i] - reach[i]);
    }
    constexpr double smallest_fraction = 1e-9; // less is round-off of a length that should be 0
    std::vector<double> result;
    for (const double length : lengths) {
      const double fraction = length / s.length;
      if (!(fraction > smallest_fraction && fraction < 1))
        continue;
      const std::pair<int, int> rounded = short_fraction(fraction);
      const double value = std::ldexp(rounded.first, rounded.second);
      if (value < 1)
        result.push_back(value);
    }
    return result;
  }

  bool execute(const Removal& r)
  {
    const auto o = m_editor.overlap(r.h);
    const FT length = o.end - o.begin;
    const FT from = FT(r.from) * length, to = r.to == 1 ? length : FT(FT(r.to) * length);
    return bool(m_editor.remove_partly(r.h, from, to));
  }

  // Whether lines end at both ends of the edge of h, on opposite sides: on its own side at its target if is_forward, at
  // its source if not.
  bool is_between_lines(const halfedge_descriptor h, const bool is_forward) const
  {
    const halfedge_descriptor o = opposite(h, m_graph);
    return face(h, m_graph) != Traits::null_face() && face(o, m_graph) != Traits::null_face() &&
           m_t_mesh.is_corner(h) == is_forward && m_t_mesh.is_corner(o) == is_forward &&
           m_t_mesh.is_corner(prev(h, m_graph)) != is_forward && m_t_mesh.is_corner(prev(o, m_graph)) != is_forward;
  }

  double part_of_side(const halfedge_descriptor h) const
  {
    const auto& coordinates = m_editor.coordinates();
    return CGAL::to_double(FT(m_t_mesh.knot(h))) / CGAL::to_double(coordinates.side_length(h));
  }

  // A line that ends next to another one: the halfedge at its end, which begins there or ends there.
  struct Line_at_gap {
    double width;
    halfedge_descriptor h;
    bool begins;
  };

  // Those at the narrowest gap first.
  std::vector<Line_at_gap> gaps() const
  {
    std::vector<Line_at_gap> result;
    for (const halfedge_descriptor h : halfedges(m_graph))
      for (const bool is_forward : {true, false})
        if (is_between_lines(h, is_forward)) {
          const double part = (std::min)(part_of_side(h), part_of_side(opposite(h, m_graph)));
          if (part < smallest_gap)
            result.push_back({part, is_forward ? next(h, m_graph) : prev(h, m_graph), is_forward});
        }
    std::stable_sort(result.begin(), result.end(),
                     [](const Line_at_gap& a, const Line_at_gap& b) { return a.width < b.width; });
    return result;
  }

  // Closes the narrowest gap that can be closed.
  bool close_a_gap(const Purpose purpose)
  {
    const double limit = purpose == Purpose::ASPECT ? (std::max)(aspect_at_gap, worst_aspect()) : aspect_at_gap;
    for (const Line_at_gap& line : gaps())
      if (shorten(line, purpose, limit))
        return true;
    return false;
  }

  // Removes the last piece of a line, if no face becomes worse than the limit. An orthogonal edge is inserted at its
  // new end, at a vertex of one of the two faces or away from them. Of lines that were separated half is left, too.
  bool shorten(const Line_at_gap& line, const Purpose purpose, const double limit)
  {
    if (face(line.h, m_graph) == face(opposite(line.h, m_graph), m_graph))
      return false;
    const auto o = m_editor.overlap(line.h);
    const Sizes s = sizes(o);
    const bool at_first = line.begins;
    const FT length = o.end - o.begin;
    double best = limit;
    FT best_x(0);
    std::vector<double> parts = fractions(s, at_first ? s.after : s.before);
    if (purpose == Purpose::SEPARATION)
      parts.push_back(1 / 2.);
    for (const double part : parts) {
      const double rest = part * s.length;
      const double aspect = at_first ? s.new_aspect(0, s.length - rest) : s.new_aspect(rest, s.length);
      if (aspect >= best)
        continue;
      const FT x = snapped(o, FT(FT(at_first ? 1 - part : part) * length));
      if (x > FT(0) && x < length) {
        best = aspect;
        best_x = x;
      }
    }
    return best < limit && m_editor.remove_partly(o.first, at_first ? FT(0) : best_x, at_first ? best_x : length);
  }

  // The place x of an orthogonal edge through both faces of an overlap, or that of a vertex close by; 0 if there are two
  // of them.
  FT snapped(const typename Editor::Overlap& o, const FT& x) const
  {
    const halfedge_descriptor last = opposite(o.last, m_graph);
    const FT length = o.end - o.begin;
    const FT y = snapped_in_face(o.first, FT(o.begin + x), o.side_length) - o.begin;
    const FT z = o.opposite_begin + FT(length - y) / o.scale;
    const FT snapped_z = snapped_in_face(last, z, o.opposite_side_length);
    if (snapped_z == z)
      return y;
    const FT w = length - FT(snapped_z - o.opposite_begin) * o.scale;
    return y == x && snapped_in_face(o.first, FT(o.begin + w), o.side_length) == o.begin + w ? w : FT(0);
  }

  // Of a distance on the side of h.
  FT snapped_in_face(const halfedge_descriptor h, const FT& x, const FT& size) const
  {
    const int side = m_editor.coordinates().side(h);
    const FT margin = size / FT(16), at = side < 2 ? x : FT(size - x);
    const FT result = m_split_position.near(face(h, m_graph), side % 2, FT(at - margin), at, FT(at + margin));
    return side < 2 ? result : FT(size - result);
  }

  TMesh m_t_mesh;
  const Graph& m_graph;
  Split_position<Const_T_mesh_view_of<TMesh>> m_split_position;
  Changed_faces<Graph> m_changed_faces;
  Editor m_editor;
  std::priority_queue<Entry> m_queue;
  std::unordered_map<face_descriptor, std::size_t, boost::hash<face_descriptor>> m_stamps; // of the valid entry
  std::size_t m_last_stamp = 0;
  Counts m_counts;
  double m_first_aspect = 1; // the worst one at first
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_REGULARIZATION_H
