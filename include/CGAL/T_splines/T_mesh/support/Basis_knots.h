// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_BASIS_KNOTS_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_BASIS_KNOTS_H

#include <CGAL/T_splines/T_mesh/internal/Knot_rays.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where a basis function sees a natural end: a border at which its knots go on as if it were a mirror, and the control
/// point beyond is 2 p - q, with p of the last vertex and q of the one before. So the second derivative vanishes there, and
/// the surface at the border depends on the control points of the border alone (as that of Catmull and Clark at a border
/// or an infinitely sharp crease: Biermann, Levin, Zorin 2000).
enum class Natural_end : char {
  NONE,        ///< or so far away that the function is a B-spline
  AT_VERTEX,   ///< the vertex is p
  AT_NEXT_KNOT ///< the vertex is q
};

/// The knots of the basis function of a vertex along an axis, increasing; those beyond a natural end are mirrored.
template <typename FT>
struct Axis_knots {
  std::array<FT, 5> t;
  Natural_end before = Natural_end::NONE, after = Natural_end::NONE;
  bool is_peak = false; ///< at the vertex one line ends, and another one begins

  /// Where the support begins and ends.
  const FT& begin() const { return before == Natural_end::AT_NEXT_KNOT ? t[1] : t[0]; }
  const FT& end() const { return after == Natural_end::AT_NEXT_KNOT ? t[3] : t[4]; }

  /// The half of a peak with x <= 0, and that with x >= 0.
  Axis_knots left_half() const
  {
    if (t[1] == t[2])
      return {{t[0], t[2], t[2], t[2], t[2]}, before};
    return {{t[0], t[1], t[2], FT(-t[1]), FT(-t[0])}, before, Natural_end::AT_VERTEX};
  }
  Axis_knots right_half() const
  {
    if (t[3] == t[2])
      return {{t[2], t[2], t[2], t[2], t[4]}, Natural_end::NONE, after};
    return {{FT(-t[4]), FT(-t[3]), t[2], t[3], t[4]}, Natural_end::AT_VERTEX, after};
  }
};

/// The knots of the basis function of a vertex, in its own frame: the vertex is the origin, the first direction of its
/// first quarter is +u, the unit is that of the face there ([CZ17] section 4.1).
template <typename FT>
struct Basis_knots {
  std::array<Axis_knots<FT>, 2> axes; ///< along u and along v
};

// The directions in which the knots of a vertex are looked for, and what was found.
template <typename FT>
using Vertex_rays = std::array<Knot_ray<FT>, 4>;

/// Whether between two borders that a vertex sees on opposite sides lie at least three knot intervals: fewer do not
/// suffice for a cubic curve that interpolates both ends. Between natural ends one is enough.
template <typename FT>
bool has_enough_intervals(const Knot_ray<FT>& after, const Knot_ray<FT>& before)
{
  const auto is_enough = [](const Knot_ray<FT>& a, const Knot_ray<FT>& b) {
    return a.border + b.border >= 3 || (a.is_natural && b.is_natural);
  };
  if (!after.begins_line)
    return is_enough(after, before);
  Knot_ray<FT> end;
  end.border = 0;
  end.is_natural = after.begins_naturally;
  return is_enough(after, end) && is_enough(before, end);
}

/// The five knots of a vertex along an axis, of which `after` and `before` look in the positive and the negative
/// direction.
///
/// Without borders they are two intersections on either side and the vertex. At a border the knot is repeated so often
/// that the curve ends at its last control point, and the first knot inside is left out, so that there are as many
/// cubic basis functions as vertices, "not a knot": with the vertices at t_0, ..., t_m the knots are t_0 (four times),
/// t_2, ..., t_{m-2}, t_m (four times). Natural ends leave no knot out. \pre has_enough_intervals(after, before)
template <typename FT>
Axis_knots<FT> axis_knots(const Knot_ray<FT>& after, const Knot_ray<FT>& before)
{
  const FT zero(0);
  const auto is_clamped = [](const Knot_ray<FT>& ray, const int border) {
    return ray.border == border && !ray.is_natural;
  };
  const bool is_clamped_peak = after.begins_line && !after.begins_naturally;
  // The intersections in the direction of a ray that are knots, the border repeated or mirrored.
  const auto outward = [&](const Knot_ray<FT>& ray, const Knot_ray<FT>& other) {
    std::array<FT, 2> result;
    int n = 0;
    for (int i = 1; i <= 3 && n < 2; ++i) {
      if (ray.is_natural && i > ray.border) {
        result[n] = FT(2) * result[n - 1];
        ++n;
      }
      else if ((ray.is_natural || i != ray.border - 1) && !(i == 1 && (is_clamped(other, 0) || is_clamped_peak)))
        result[n++] = ray.distance[i - 1];
    }
    while (n == 1)
      result[n++] = result[0];
    return result;
  };
  const auto end = [](const Knot_ray<FT>& ray) {
    return !ray.is_natural || ray.border > 1 ? Natural_end::NONE
           : ray.border == 0                 ? Natural_end::AT_VERTEX
                                             : Natural_end::AT_NEXT_KNOT;
  };
  std::array<FT, 2> a{}, b{};
  if (after.border != 0)
    a = outward(after, before);
  if (before.border != 0)
    b = outward(before, after);
  if (is_clamped(after, 0))
    return {{FT(-b[0]), zero, zero, zero, zero}, end(before)};
  if (is_clamped(before, 0))
    return {{zero, zero, zero, zero, a[0]}, Natural_end::NONE, end(after)};
  if (is_clamped_peak)
    return {{FT(-b[0]), zero, zero, zero, a[0]}, end(before), end(after), true};
  if (after.border == 0)
    a = b;
  if (before.border == 0)
    b = a;
  if (is_clamped(after, 1))
    return {{FT(-b[1]), FT(-b[0]), a[0], a[0], a[0]}};
  if (is_clamped(before, 1))
    return {{FT(-b[0]), FT(-b[0]), FT(-b[0]), a[0], a[1]}};
  return {{FT(-b[1]), FT(-b[0]), zero, a[0], a[1]}, end(before), end(after), after.begins_line};
}

/// Finds the knots of basis functions.
template <typename FT>
class Basis_knots_finder {
  using Arrays = T_mesh_arrays<FT>;

public:
  /// \param kinds per vertex
  /// \param has_border whether rays must look one intersection farther
  Basis_knots_finder(const Arrays& t_mesh, const std::vector<Vertex_kind>& kinds, const bool has_border)
    : m_t_mesh(t_mesh),
      m_kinds(kinds),
      m_tracer(t_mesh, kinds, has_border)
  {
  }

  /// The four rays of a vertex that is not extraordinary. \pre four quarters, or one or two on the border
  Vertex_rays<FT> rays(const Vertex_quarters<FT>& quarters) const
  {
    Vertex_rays<FT> result;
    for (int i = 0; i < quarters.size(); ++i)
      result[i] = m_tracer.trace_first(quarters[i]);
    if (quarters.size() == 4)
      return result;
    result[quarters.size()] = m_tracer.trace_second(quarters[quarters.size() - 1]);
    for (int i = quarters.size() + 1; i < 4; ++i)
      result[i].border = 0;
    const int first = quarters[0].h;
    const Vertex_kind& kind = m_kinds[m_t_mesh.target(first)];
    if (quarters.size() == 1) { // both lines along the border end
      result[2].is_natural = ends_naturally(m_t_mesh, m_t_mesh.next(first), kind);
      result[3].is_natural = ends_naturally(m_t_mesh, first, kind);
      return result;
    }
    result[3].is_natural = kind.is_natural;
    if (kind.ends_lines)
      for (const int i : {0, 2}) {
        result[i].begins_line = true;
        result[i].begins_naturally = ends_naturally(m_t_mesh, m_t_mesh.next(first), kind);
      }
    return result;
  }

  Basis_knots<FT> knots(const Vertex_rays<FT>& rays) const
  {
    return {{{axis_knots(rays[0], rays[2]), axis_knots(rays[1], rays[3])}}};
  }

  /// The knots of an extraordinary vertex, which are the same in all of its quarters: multiples of the first interval.
  Basis_knots<FT> extraordinary_knots(const Vertex_quarters<FT>& quarters) const
  {
    const FT d = m_tracer.trace_first(quarters[0]).distance[0];
    const Axis_knots<FT> knots{{FT(FT(-2) * d), FT(-d), FT(0), d, FT(FT(2) * d)}};
    return {{{knots, knots}}};
  }

private:
  const Arrays& m_t_mesh;
  const std::vector<Vertex_kind>& m_kinds;
  Knot_ray_tracer<FT> m_tracer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_BASIS_KNOTS_H
