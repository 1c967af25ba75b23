// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CHECK_NUMBERED_VERTICES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CHECK_NUMBERED_VERTICES_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The vertices that are given with numbers, looked for among those of a mesh. Null ones are left out: handles of some graphs
/// must not be hashed if they are null.
template <typename TriangleMesh, typename Numbers>
Claimed_descriptors<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
claimed_vertices(const TriangleMesh& mesh, const Numbers& numbers)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  Claimed_descriptors<typename Traits::vertex_descriptor> result;
  for (const auto& number : numbers)
    if (number.first != Traits::null_vertex())
      result.insert(number.first);
  result.find_in(CGAL::make_range(vertices(mesh)));
  return result;
}

/// checks vertices that are given with their numbers of quarter turns: they are of the mesh, each is given once, cones inside
/// and corners on the border, and the numbers are positive.
/// \param numbers a range of pairs of a vertex and a number: cones, or corners if `are_corners`
template <typename TriangleMesh, typename Numbers>
void check_numbered_vertices(const TriangleMesh& mesh, const Numbers& numbers, const bool are_corners,
                             Holonomy_signature_report<TriangleMesh>& report)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Status = Holonomy_signature_status;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  const auto claimed = claimed_vertices(mesh, numbers);
  std::unordered_set<vertex_descriptor> known;
  std::size_t i = 0;
  for (const auto& [vertex, k] : numbers) {
    if (vertex == Traits::null_vertex())
      report.status = Status::NULL_VERTEX;
    else if (claimed.is_foreign(vertex))
      report.status = Status::FOREIGN_VERTEX;
    else if (!known.insert(vertex).second)
      report.status = Status::DUPLICATE_CONE;
    else if (k < 1)
      report.status = Status::NON_POSITIVE_CONE;
    else if (bool(CGAL::is_border(vertex, mesh)) != are_corners)
      report.status = are_corners ? Status::CORNER_INSIDE : Status::CONE_ON_BORDER;
    if (!report.success()) {
      report.vertex = vertex;
      report.actual = k;
      report.index = i;
      report.is_corner = are_corners;
      return;
    }
    ++i;
  }
}

/// The named parameter `corners`; nothing where corners are to be found by the turning of the border.
template <typename TriangleMesh, typename NamedParameters>
std::optional<std::vector<typename Holonomy_signature<TriangleMesh>::Corner>> given_corners(const NamedParameters& np)
{
  using Corners = std::optional<std::vector<typename Holonomy_signature<TriangleMesh>::Corner>>;
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, np_tags::corners), Corners());
}

/// checks the corners of the named parameter, if there are any.
template <typename TriangleMesh, typename NamedParameters>
void check_given_corners(const TriangleMesh& mesh, const NamedParameters& np,
                         Holonomy_signature_report<TriangleMesh>& report)
{
  if (const auto corners = given_corners<TriangleMesh>(np))
    check_numbered_vertices(mesh, *corners, true, report);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CHECK_NUMBERED_VERTICES_H
