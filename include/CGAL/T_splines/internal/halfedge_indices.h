// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_HALFEDGE_INDICES_H
#define CGAL_T_SPLINES_INTERNAL_HALFEDGE_INDICES_H

#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

// Wherever halfedges are indices, those of edge `e` are `2e` and `2e + 1`. The edge is oriented as the first of them.

/// The other halfedge of the edge of `h`.
constexpr int opposite(const int h)
{
  return h ^ 1;
}

/// The edge of a halfedge.
constexpr int edge_of(const int h)
{
  return h >> 1;
}

/// The halfedge along which an edge is oriented.
constexpr int halfedge_of_edge(const int e)
{
  return 2 * e;
}

/// Both halfedges of an edge, the one along which it is oriented first.
constexpr std::array<int, 2> halfedges_of_edge(const int e)
{
  return {{2 * e, 2 * e + 1}};
}

/// Whether a halfedge has the orientation of its edge.
constexpr bool is_along_edge(const int h)
{
  return (h & 1) == 0;
}

/// Index of a halfedge among the two of its edge: 0 along the edge, 1 against it.
constexpr int side_of_edge(const int h)
{
  return h & 1;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_HALFEDGE_INDICES_H
