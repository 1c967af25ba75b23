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

/// The knots of the basis function of a vertex, in its own frame: the vertex is the origin, the first direction of its
/// first quarter is +u, the unit is that of the face there ([CZ17] section 4.1).
template <typename FT>
struct Basis_knots {
  std::array<std::array<FT, 5>, 2> knots; ///< along u and along v, increasing
};

// The directions in which the knots of a vertex are looked for, and what was found.
template <typename FT>
using Vertex_rays = std::array<Knot_ray<FT>, 4>;

/// Whether between two borders that a vertex sees on opposite sides lie at least three knot intervals: fewer do not
/// suffice for a cubic curve that interpolates both ends.
template <typename FT>
bool has_enough_intervals(const Knot_ray<FT>& after, const Knot_ray<FT>& before)
{
  return after.border + before.border >= 3;
}

/// The five knots of a vertex along an axis, of which `after` and `before` look in the positive and the negative
/// direction.
///
/// Without borders they are two intersections on either side and the vertex. At a border the knot is repeated so often
/// that the curve ends at its last control point, and the first knot inside is left out, so that there are as many
/// cubic basis functions as vertices, "not a knot": with the vertices at t_0, ..., t_m the knots are t_0 (four times),
/// t_2, ..., t_{m-2}, t_m (four times). A natural end is no border in this sense. \pre has_enough_intervals(after, before)
template <typename FT>
std::array<FT, 5> axis_knots(const Knot_ray<FT>& after, const Knot_ray<FT>& before)
{
  // The intersections in the direction of a ray that are knots, the border repeated.
  const auto outward = [](const Knot_ray<FT>& ray, const Knot_ray<FT>& other) {
    std::array<FT, 3> result;
    int n = 0;
    for (int i = 1; i <= 3 && n < 3; ++i)
      if (i != ray.border - 1 && !(i == 1 && other.border == 0))
        result[n++] = ray.border == 0 ? FT(0) : ray.distance[i - 1];
    while (n > 0 && n < 3) {
      result[n] = result[n - 1];
      ++n;
    }
    return result;
  };
  const std::array<FT, 3> a = outward(after, before), b = outward(before, after);
  const FT zero(0);
  if (after.border == 0)
    return {FT(-b[0]), zero, zero, zero, zero};
  if (before.border == 0)
    return {zero, zero, zero, zero, a[0]};
  if (after.border == 1)
    return {FT(-b[1]), FT(-b[0]), a[0], a[0], a[0]};
  if (before.border == 1)
    return {FT(-b[0]), FT(-b[0]), FT(-b[0]), a[0], a[1]};
  return {FT(-b[1]), FT(-b[0]), zero, a[0], a[1]};
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
    if (m_kinds[m_t_mesh.target(quarters[0].h)] == Vertex_kind::NATURAL_END)
      result[3].distance = result[1].distance;
    else
      for (int i = quarters.size() + 1; i < 4; ++i)
        result[i].border = 0;
    return result;
  }

  Basis_knots<FT> knots(const Vertex_rays<FT>& rays) const
  {
    return {{axis_knots(rays[0], rays[2]), axis_knots(rays[1], rays[3])}};
  }

  /// The knots of an extraordinary vertex, which are the same in all of its quarters: multiples of the first interval.
  Basis_knots<FT> extraordinary_knots(const Vertex_quarters<FT>& quarters) const
  {
    const FT d = m_tracer.trace_first(quarters[0]).distance[0];
    const std::array<FT, 5> knots{FT(FT(-2) * d), FT(-d), FT(0), d, FT(FT(2) * d)};
    return {{knots, knots}};
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
