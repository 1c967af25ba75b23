// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H
#define CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H

// Everything that reads differently on CGAL 5.5 and CGAL 6 stands here.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version_macros.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h> // deprecated in CGAL 6
#include <CGAL/iterator.h>
#endif

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <typename Kernel, typename Primitive>
using AABB_traits_for_3 = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
template <typename Kernel, typename Primitive>
using AABB_traits_for_3 = CGAL::AABB_traits<Kernel, Primitive>;
#endif

/// Fills a hole by `triangulate_refine_and_fair_hole()`.
/// \param hole a halfedge of its border, without face
/// \param faces receives the new faces, none if there is no triangulation
template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits, typename Face>
void fill_hole_smoothly(TriangleMesh& mesh, const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor hole,
                        const VertexPointMap& points, const GeomTraits& traits, std::vector<Face>& faces)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto np = CGAL::parameters::vertex_point_map(points).geom_traits(traits);
#if CGAL_VERSION_NR >= 1060000000
  PMP::triangulate_refine_and_fair_hole(mesh, hole, np.face_output_iterator(std::back_inserter(faces)));
#else
  PMP::triangulate_refine_and_fair_hole(mesh, hole, std::back_inserter(faces), CGAL::Emptyset_iterator(), np);
#endif
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H
