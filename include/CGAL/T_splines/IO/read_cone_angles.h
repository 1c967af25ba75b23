// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_CONE_ANGLES_H
#define CGAL_T_SPLINES_IO_READ_CONE_ANGLES_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_file_parser.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

// \param source an `std::istream` or the name of a file
template <typename Source, typename FaceGraph>
Field_file_report
parse_cone_angles(Source& source, const FaceGraph& mesh,
                  std::vector<std::pair<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int>>& cones)
{
  Progress progress; // such files are short
  Field_file_parser parser(source, progress);
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  const std::vector<vertex_descriptor> vertex_of_index(vertices(mesh).begin(), vertices(mesh).end());
  std::vector<std::pair<vertex_descriptor, int>> result;
  std::size_t index = 0;
  for (; parser.has_token(); ++index) {
    double angle = 0;
    if (!parser.read_number(angle)) {
      parser.at_index(index);
      return parser.report();
    }
    if (index >= vertex_of_index.size())
      continue; // only counted
    const double turns = angle / (CGAL_PI / 2), k = std::round(turns);
    if (std::abs(turns - k) > same_number_of_turns || std::abs(k) > largest_number_of_turns)
      parser.fail(Field_file_status::NOT_A_QUARTER_TURN, index);
    else if (k < 1)
      parser.fail(Field_file_status::NON_POSITIVE_CONE, index, 1, static_cast<long long>(k));
    if (!parser.success())
      return parser.report();
    if (k != (CGAL::is_border(vertex_of_index[index], mesh) ? 2 : 4))
      result.emplace_back(vertex_of_index[index], static_cast<int>(k));
  }
  if (parser.success() && index != vertex_of_index.size())
    parser.fail(Field_file_status::WRONG_COUNT, Field_file_report::none, static_cast<long long>(vertex_of_index.size()),
                static_cast<long long>(index));
  if (parser.success())
    cones.swap(result);
  return parser.report();
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads cones in the format `Th_hat` of ConformalIdealDelaunay and penner-optimization: one number per vertex, in the order
/// of the mesh, its total angle in radians.
/// \tparam FaceGraph a model of `FaceListGraph`
/// \param input the text; it is read to its end
/// \param mesh the mesh that the angles are for
/// \param cones receives the vertices whose angle is not regular, 2 pi in the interior and pi on the border, with their
///        number k >= 1 of quarter turns; it is left as it was upon failure
/// \return the status UNREADABLE, WRONG_COUNT, SYNTAX_ERROR, NON_FINITE_NUMBER, NOT_A_QUARTER_TURN, NON_POSITIVE_CONE or SUCCESS,
///         with the line and the vertex.
template <typename FaceGraph>
Field_file_report
read_cone_angles(std::istream& input, const FaceGraph& mesh,
                 std::vector<std::pair<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int>>& cones)
{
  return internal::parse_cone_angles(input, mesh, cones);
}

/// \ingroup PkgTSplinesIO
/// reads cones from a file of the format `Th_hat`.
/// \param filename a file; its extension does not matter
/// \param mesh, cones see the function that reads from a stream
/// \return the same status, line and vertex.
template <typename FaceGraph>
Field_file_report
read_cone_angles(const std::string& filename, const FaceGraph& mesh,
                 std::vector<std::pair<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int>>& cones)
{
  return internal::parse_cone_angles(filename, mesh, cones);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_CONE_ANGLES_H
