// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_CONES_H
#define CGAL_T_SPLINES_IO_READ_CONES_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_file_parser.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <istream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

// \param source an `std::istream` or the name of a file
template <typename Source, typename VertexListGraph>
Field_file_report
parse_cones(Source& source, const VertexListGraph& mesh,
            std::vector<std::pair<typename boost::graph_traits<VertexListGraph>::vertex_descriptor, int>>& cones)
{
  Progress progress; // such files are short
  Field_file_parser parser(source, progress);
  using vertex_descriptor = typename boost::graph_traits<VertexListGraph>::vertex_descriptor;
  const std::vector<vertex_descriptor> vertex_of_index(vertices(mesh).begin(), vertices(mesh).end());
  std::vector<char> is_listed(vertex_of_index.size(), 0);
  std::vector<std::pair<vertex_descriptor, int>> result;
  const auto number_of_vertices = static_cast<long long>(vertex_of_index.size());
  while (parser.has_token()) {
    long long index = 0, k = 0;
    if (!parser.read_integer(index) || !parser.read_integer(k))
      return parser.report();
    if (index < 0 || index >= number_of_vertices)
      parser.fail(Field_file_status::INDEX_OUT_OF_RANGE, Field_file_report::none, number_of_vertices, index);
    else if (k < 1)
      parser.fail(Field_file_status::NON_POSITIVE_CONE, static_cast<std::size_t>(index), 1, k);
    else if (k > (std::numeric_limits<int>::max)())
      parser.fail(Field_file_status::SYNTAX_ERROR, static_cast<std::size_t>(index));
    else if (is_listed[index])
      parser.fail(Field_file_status::DUPLICATE_CONE, static_cast<std::size_t>(index));
    if (!parser.success())
      return parser.report();
    is_listed[index] = 1;
    result.emplace_back(vertex_of_index[index], static_cast<int>(k));
  }
  if (parser.success())
    cones.swap(result);
  return parser.report();
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads cones in the format `.cones`: one line `vertex k` for each, with the index of the vertex, from 0 in the order of
/// the mesh, and its number k >= 1 of quarter turns.
/// \tparam VertexListGraph a model of `VertexListGraph`
/// \param input the text; it is read to its end
/// \param mesh the mesh that the cones are for
/// \param cones receives the cones in the order of the file; it is left as it was upon failure
/// \return the status UNREADABLE, TRUNCATED, SYNTAX_ERROR, INDEX_OUT_OF_RANGE, DUPLICATE_CONE, NON_POSITIVE_CONE or SUCCESS,
///         with the line and the vertex.
template <typename VertexListGraph>
Field_file_report
read_cones(std::istream& input, const VertexListGraph& mesh,
           std::vector<std::pair<typename boost::graph_traits<VertexListGraph>::vertex_descriptor, int>>& cones)
{
  return internal::parse_cones(input, mesh, cones);
}

/// \ingroup PkgTSplinesIO
/// reads cones from a file of the format `.cones`.
/// \param filename a file; its extension does not matter
/// \param mesh, cones see the function that reads from a stream
/// \return the same status, line and vertex.
template <typename VertexListGraph>
Field_file_report
read_cones(const std::string& filename, const VertexListGraph& mesh,
           std::vector<std::pair<typename boost::graph_traits<VertexListGraph>::vertex_descriptor, int>>& cones)
{
  return internal::parse_cones(filename, mesh, cones);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_CONES_H
