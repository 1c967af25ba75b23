// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_RING_INSERTION_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_RING_INSERTION_H

#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>
#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Surrounds extraordinary vertices with three regular rings of faces ([CZ17] section 8.2, condition A, Fig. 15).
///
/// In each sector, the face with a corner at the vertex, a square is cut out and divided into 3 x 3 cells, but for the
/// outermost one, which may be any face. The first of the two cuts goes through the whole face: it is the edge extended
/// at the outer corner of the rings. Where no other rings are in the way, the line of the second ring beside it does,
/// too: then there are as many faces, and no support comes from the opposite corner of the sector (condition B).
/// Lengths at a vertex are measured in its common unit, that of the face of its first sector. Borders and creases divide
/// the sectors of a vertex into fans; one between two of them gets rings if it turns inwards.
/// \tparam Splits `Counted_splits`
template <typename Splits>
class Ring_insertion {
  using FT = typename Splits::FT;
  using vertex_descriptor = typename Splits::vertex_descriptor;
  using halfedge_descriptor = typename Splits::halfedge_descriptor;
  using face_descriptor = typename Splits::face_descriptor;

  // The corner of a face that ends with h, and its unit in the common unit of the vertex there.
  struct Sector {
    halfedge_descriptor h;
    FT unit;
    bool has_rings; // its fan does
  };
  using Sectors = boost::container::small_vector<Sector, 8>;

  // An edge at a vertex, seen from there in the face of a sector.
  struct Spoke {
    halfedge_descriptor h, end_corner; // end_corner ends at the other vertex
    vertex_descriptor end;
    FT length, unit; // of the face
  };
  using Spokes = boost::container::small_vector<Spoke, 9>;

  // Each ring is `unit` wide, in the common unit of the vertex.
  struct Plan {
    vertex_descriptor v;
    FT clearance, unit;
  };

public:
  explicit Ring_insertion(Splits& splits) : m_splits(splits) {}

  /// Surrounds these vertices with rings.
  ///
  /// No ring leaves the half of an edge or of a face between two extraordinary vertices, so that rings of different
  /// vertices do not overlap; and no line passes through the place of other rings. Where the rings meet the other ends
  /// of all edges at the vertex, or keep away from them, they are as large as the clearance allows; otherwise a quarter
  /// of it remains. \pre on the border their extended valence is 3 or more
  void run(const std::vector<vertex_descriptor>& vertices)
  {
    for (const vertex_descriptor v : vertices)
      while (extend_at(v))
        continue;
    for (const vertex_descriptor v : vertices) {
      if (!m_splits.progress().go_on_after(500))
        return;
      m_index.emplace(v, m_plans.size());
      m_plans.push_back({v, clearance(v), FT(0)});
    }
    for (Plan& plan : m_plans) {
      if (!m_splits.progress().go_on_after(500))
        return;
      plan.unit = ring_unit(plan);
    }
    std::vector<std::size_t> order(m_plans.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](const std::size_t i, const std::size_t j) { return m_plans[i].unit < m_plans[j].unit; });
    for (const std::size_t i : order)
      insert(m_plans[i]);
  }

private:
  const typename Splits::Coordinates& coordinates() const { return m_splits.coordinates(); }
  FT knot(const halfedge_descriptor h) const { return m_splits.t_mesh().knot(h); }
  bool is_corner(const halfedge_descriptor h) const { return m_splits.t_mesh().is_corner(h); }

  bool is_border(const vertex_descriptor v) const { return is_border_vertex(v, m_splits.t_mesh()); }
  // Whether rings belong around a vertex.
  bool is_centre(const vertex_descriptor v) const
  {
    const Sectors around = sectors(v);
    return std::any_of(around.begin(), around.end(), [](const Sector& sector) { return sector.has_rings; });
  }

  // Whether the border is ahead where a spoke ends.
  bool ends_at_border(const Spoke& spoke) const
  {
    if (!is_border(spoke.end))
      return false;
    return !CGAL::is_border_edge(spoke.h, m_splits.graph()) || extended_valence(spoke.end, m_splits.t_mesh()) == 1;
  }

  // Extends an edge at v through a face that goes straight on there.
  bool extend_at(const vertex_descriptor v)
  {
    for (const Sector& sector : sectors(v))
      if (sector.has_rings && !is_corner(sector.h))
        return m_splits.extend(sector.h);
    return false;
  }

  bool ends_fan(const halfedge_descriptor h) const
  {
    return CGAL::is_border_edge(h, m_splits.graph()) || m_splits.t_mesh().is_crease(h);
  }

  // Splits keep halfedge(v) where it is among the edges of v, and do not change the units of faces.
  Sectors sectors(const vertex_descriptor v) const
  {
    const auto& graph = m_splits.graph();
    Sectors result;
    FT unit(1);
    const halfedge_descriptor first = first_of_sectors(v);
    const bool is_divided = ends_fan(next(first, graph));
    std::size_t fan = 0; // its first sector
    int quarters = 0;
    halfedge_descriptor h = first;
    for (;;) {
      result.push_back({h, unit, false});
      quarters += is_corner(h) ? 1 : 2;
      const halfedge_descriptor o = opposite(h, graph);
      const bool is_border_ahead = CGAL::is_border(o, graph);
      const bool is_last = is_border_ahead || prev(o, graph) == first;
      if (is_last || ends_fan(h)) {
        for (const bool has_rings = is_divided ? quarters > 2 : quarters != 4; fan < result.size(); ++fan)
          result[fan].has_rings = has_rings;
        quarters = 0;
      }
      if (is_last)
        return result;
      unit *= knot(h) / knot(o);
      h = prev(o, graph);
    }
  }

  // On the border, of the first face after it, counter-clockwise; or else after a crease.
  halfedge_descriptor first_of_sectors(const vertex_descriptor v) const
  {
    const auto& graph = m_splits.graph();
    const halfedge_descriptor first = halfedge(v, graph);
    halfedge_descriptor result = CGAL::is_border(first, graph) ? prev(opposite(first, graph), graph) : first;
    for (const halfedge_descriptor h : CGAL::halfedges_around_target(first, graph)) {
      if (CGAL::is_border(h, graph))
        return prev(opposite(h, graph), graph);
      if (m_splits.t_mesh().is_crease(h))
        result = prev(opposite(h, graph), graph);
    }
    return result;
  }

  // One more than sectors on the border.
  Spokes spokes(const Sectors& sectors) const
  {
    const auto& graph = m_splits.graph();
    Spokes result;
    for (const Sector& sector : sectors) {
      const halfedge_descriptor h = next(sector.h, graph);
      result.push_back({h, h, target(h, graph), FT(knot(h) * sector.unit), sector.unit});
    }
    const Sector& last = sectors.back();
    if (CGAL::is_border(opposite(last.h, graph), graph))
      result.push_back({last.h, prev(last.h, graph), source(last.h, graph), FT(knot(last.h) * last.unit), last.unit});
    return result;
  }

  // How far the rings may reach.
  FT clearance(const vertex_descriptor v) const
  {
    const auto& graph = m_splits.graph();
    FT result(-1);
    const auto bound = [&](const FT& x) {
      if (result < FT(0) || x < result)
        result = x;
    };
    const Sectors around = sectors(v);
    for (const Spoke& spoke : spokes(around)) {
      // Beyond the third ring there must be room for two intervals before a border.
      if (is_centre(spoke.end))
        bound(FT(spoke.length / FT(2)));
      else
        bound(ends_at_border(spoke) ? FT(spoke.length * FT(3) / FT(4)) : spoke.length);
    }
    for (const Sector& sector : around)
      if (sector.has_rings && is_centre(target(corners_of_face(sector.h)[2], graph))) {
        const FT width = coordinates().side_length(next(sector.h, graph)), height = coordinates().side_length(sector.h);
        bound((std::max)(width, height) * sector.unit / FT(2));
      }
    return result;
  }

  // A third of the clearance, if no short edge would be left on any spoke; or else at most a quarter, a short fraction.
  FT ring_unit(const Plan& plan) const
  {
    for (const Spoke& spoke : spokes(sectors(plan.v))) {
      const FT rest = rest_of_spoke(spoke, plan.clearance), eps = knot_tolerance(plan.clearance);
      if (rest > eps && rest < plan.clearance / FT(4))
        return short_number_below(FT(plan.clearance / FT(4)));
    }
    return plan.clearance / FT(3);
  }

  // What is left of a spoke by rings that reach as far as the clearances allow.
  FT rest_of_spoke(const Spoke& spoke, const FT& reach) const
  {
    const FT rest = spoke.length - reach;
    if (!is_centre(spoke.end))
      return rest;
    const auto found = m_index.find(spoke.end);
    if (found == m_index.end())
      return FT(rest - reach);
    return rest - m_plans[found->second].clearance / unit_of_corner(spoke.end_corner) * spoke.unit;
  }

  // At most x, at least 8/9 of it: four significant bits.
  static FT short_number_below(const FT& x)
  {
    int exponent;
    const double mantissa = std::frexp(CGAL::to_double(x), &exponent);
    const FT result(std::ldexp(std::floor(mantissa * 16), exponent - 4));
    return result > FT(0) && result <= x ? result : x;
  }

  // The unit of the face of h in the common unit of the vertex at which h ends.
  FT unit_of_corner(const halfedge_descriptor h) const
  {
    for (const Sector& sector : sectors(target(h, m_splits.graph())))
      if (sector.h == h)
        return sector.unit;
    CGAL_assertion(false);
    return FT(1);
  }

  // The halfedges that end at the corners of a face, from h on.
  std::array<halfedge_descriptor, 4> corners_of_face(const halfedge_descriptor h) const
  {
    std::array<halfedge_descriptor, 4> result{h};
    for (int i = 1; i < 4; ++i)
      result[i] = coordinates().last_of_side(next(result[i - 1], m_splits.graph()));
    return result;
  }

  // Other rings may have come so close in the meantime that the edges are shorter than planned.
  void insert(Plan& plan)
  {
    const Sectors before = sectors(plan.v);
    for (const Spoke& spoke : spokes(before))
      if (plan.unit * FT(3) > spoke.length)
        plan.unit = spoke.length / FT(3);
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].has_rings)
        insert(plan.v, i, FT(plan.unit / before[i].unit));
  }

  // The first direction of a sector in the frame of its face.
  int direction_of_sector(const vertex_descriptor v, const std::size_t i) const
  {
    return (coordinates().side(sectors(v)[i].h) + 1) % 4;
  }

  // A sector in coordinates whose origin is the vertex: its extent, and the place of the rings at the other corners.
  struct Sector_plan {
    face_descriptor f;
    int direction; // of the first coordinate
    FT width, height;
    std::array<FT, 4> room; // counter-clockwise from the origin, at which it is that of the rings to be made
    halfedge_descriptor far_from_first, far_from_second; // begin the sides opposite to the two spokes
  };

  Sector_plan plan_of_sector(const vertex_descriptor v, const std::size_t i, const FT& reach) const
  {
    const auto& graph = m_splits.graph();
    const halfedge_descriptor h = sectors(v)[i].h;
    const std::array<halfedge_descriptor, 4> corners = corners_of_face(h);
    Sector_plan result{face(h, graph),
                       (coordinates().side(h) + 1) % 4,
                       coordinates().side_length(next(h, graph)),
                       coordinates().side_length(h),
                       {reach, FT(0), FT(0), FT(0)},
                       next(corners[2], graph),
                       next(corners[1], graph)};
    for (int k = 1; k < 4; ++k) {
      const auto found = m_index.find(target(corners[k], graph));
      if (found != m_index.end())
        result.room[k] = m_plans[found->second].unit * FT(3) / unit_of_corner(corners[k]);
    }
    return result;
  }

  void insert(const vertex_descriptor v, const std::size_t i, const FT& unit)
  {
    const FT reach = unit * FT(3);
    Sector_plan p = plan_of_sector(v, i, reach);
    const auto is_larger = [&](const FT& size) { return size > reach + knot_tolerance(size); };
    if (is_larger(p.width) && is_larger(p.height)) {
      if (!is_free(p, 0) && !is_free(p, 1) && separate(p))
        p = plan_of_sector(v, i, reach);
      const int first = first_axis(p);
      const face_descriptor strip = m_splits.split(p.f, (p.direction + first) % 4, reach).near;
      p = plan_of_sector(v, i, reach);
      if (p.f == strip && is_larger(first == 0 ? p.height : p.width) &&
          p.room[first == 0 ? 3 : 1] <= unit * FT(2) + knot_tolerance(unit)) {
        divide_strip(p, first, unit);
        return;
      }
    }
    for (int axis = 0; axis < 2; ++axis)
      if (is_larger(axis == 0 ? p.width : p.height))
        p.f = m_splits.split(p.f, (p.direction + axis) % 4, reach).near;
    divide(p.f, unit, direction_of_sector(v, i));
  }

  // Whether a cut through the whole sector at the distance room[0] along an axis keeps off the other rings.
  static bool is_free(const Sector_plan& p, const int axis)
  {
    const FT& size = axis == 0 ? p.width : p.height;
    return p.room[0] >= p.room[axis == 0 ? 3 : 1] && p.room[0] + p.room[2] <= size;
  }

  // Splits a sector between the rings at its corners, if there is a line between them.
  bool separate(const Sector_plan& p)
  {
    for (int axis = 0; axis < 2; ++axis) {
      const FT& size = axis == 0 ? p.width : p.height;
      const FT near = (std::max)(p.room[0], p.room[axis == 0 ? 3 : 1]);
      const FT far = (std::max)(p.room[2], p.room[axis == 0 ? 1 : 3]);
      if (near + far <= size)
        return m_splits.split(p.f, (p.direction + axis) % 4, near).is_split;
    }
    return false;
  }

  // Along which axis the first cut is made: so that the remaining faces are squarer, and no vertex is inserted where
  // one is there.
  int first_axis(const Sector_plan& p) const
  {
    const bool is_first_free = is_free(p, 0), is_second_free = is_free(p, 1);
    if (is_first_free != is_second_free)
      return is_first_free ? 0 : 1;
    return cost(p, 0) <= cost(p, 1) ? 0 : 1;
  }

  double cost(const Sector_plan& p, const int axis) const
  {
    const FT &size = axis == 0 ? p.width : p.height, &other = axis == 0 ? p.height : p.width;
    const double a = CGAL::to_double(size), b = CGAL::to_double(other), r = CGAL::to_double(p.room[0]);
    const auto aspect = [](const double x, const double y) { return x > y ? x / y : y / x; };
    const FT distance = axis == 0 ? FT(size - p.room[0]) : p.room[0];
    const bool has_vertex = has_vertex_at(axis == 0 ? p.far_from_first : p.far_from_second, distance, size);
    return (std::max)(aspect(a - r, b), aspect(r, b - r)) * (has_vertex ? 0.5 : 1);
  }

  bool has_vertex_at(halfedge_descriptor h, const FT& distance, const FT& size) const
  {
    FT x = knot(h);
    while (!is_corner(h) && x < distance - knot_tolerance(size)) {
      h = next(h, m_splits.graph());
      x += knot(h);
    }
    return !is_corner(h) && x <= distance + knot_tolerance(size);
  }

  // A strip three units wide along an axis, and longer along the other one.
  void divide_strip(const Sector_plan& p, const int axis, const FT& unit)
  {
    const int across = (p.direction + axis) % 4, along = (p.direction + 1 - axis) % 4;
    const auto parts = m_splits.split(p.f, across, unit * FT(2));
    for (const face_descriptor row : thirds(m_splits.split(parts.near, along, unit * FT(3)).near, unit, along))
      m_splits.split(row, across, unit);
    m_splits.split(m_splits.split(parts.far, along, unit * FT(2)).near, along, unit);
  }

  // Divides a square of three units into nine.
  void divide(const face_descriptor f, const FT& unit, const int direction)
  {
    for (const face_descriptor column : thirds(f, unit, direction))
      thirds(column, unit, (direction + 1) % 4);
  }

  std::array<face_descriptor, 3> thirds(const face_descriptor f, const FT& unit, const int direction)
  {
    const auto last = m_splits.split(f, direction, unit * FT(2));
    const auto first = m_splits.split(last.near, direction, unit);
    return {first.near, first.far, last.far};
  }

  Splits& m_splits;
  std::vector<Plan> m_plans;
  std::unordered_map<vertex_descriptor, std::size_t, boost::hash<vertex_descriptor>> m_index; // of the plans
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_RING_INSERTION_H
