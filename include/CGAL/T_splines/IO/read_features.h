// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_FEATURES_H
#define CGAL_T_SPLINES_IO_READ_FEATURES_H

#include <CGAL/T_splines/IO/Feature_file_report.h>
#include <CGAL/T_splines/IO/internal/Feature_file_parser.h>
#include <CGAL/T_splines/IO/internal/lowercase_extension.h>
#include <CGAL/T_splines/IO/internal/read_whole_file.h>

#include <CGAL/boost/graph/iterator.h>

#include <istream>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename TriangleMesh, typename EdgeIsFeatureMap>
Feature_file_report parse_features(const bool is_readable, const std::string_view text, const TriangleMesh& mesh,
                                   EdgeIsFeatureMap edge_is_feature, const Feature_file_format format)
{
  Feature_file_report report;
  if (!is_readable) {
    report.status = Feature_file_status::UNREADABLE;
    return report;
  }
  const Feature_file_parser<TriangleMesh> parser(text, mesh, format);
  report = parser.report();
  if (!report.success())
    return report;
  for (const auto e : CGAL::make_range(edges(mesh)))
    put(edge_is_feature, e, false);
  for (const auto h : parser.halfedges()) {
    const auto e = edge(h, mesh);
    ++(get(edge_is_feature, e) ? report.number_of_repetitions : report.number_of_edges);
    put(edge_is_feature, e, true);
  }
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads features, edges of a mesh, from a stream.
///
/// Indices are those of the mesh, in the order in which it lists its elements. The formats:
/// - `VERTEX_PAIRS`: the two ends of an edge per line, counted from 0. What follows a `#` is a comment.
/// - `SHARP`, of quadwild: a line with the number of features, then one line for each: 0 if it is concave and 1 if it
///   is convex, which does not matter here; a face, counted from 0; and which of its edges, 0 for that from its
///   first corner to its second one, and so on. The first corner is where `halfedge(f, mesh)` ends: the first one in the file
///   for meshes that CGAL's builders make of one.
/// - `OBJ_LINES`: each statement `l` names a chain of vertices, counted from 1, or, if negative, from the last statement `v`
///   before it backwards. All other statements are passed over.
///
/// An edge may be named several times, in either direction: it is a feature all the same. The report counts that.
/// A file may name none.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` from edges to `bool`
/// \param input the text; it is read to its end
/// \param mesh the mesh that the features are of, as the reader of its file has made it: without repairs
/// \param edge_is_feature receives for each edge whether the file names it; nothing is written upon failure
/// \param format what the text is
/// \return what is wrong with the text, in which line, and which element it names.
/// Complexity: linear in the size of the text and of the mesh, for bounded numbers of edges at a vertex.
template <typename TriangleMesh, typename EdgeIsFeatureMap>
Feature_file_report read_features(std::istream& input, const TriangleMesh& mesh, EdgeIsFeatureMap edge_is_feature,
                                  const Feature_file_format format = Feature_file_format::VERTEX_PAIRS)
{
  std::string text;
  const bool is_readable = internal::read_whole_stream(input, text);
  return internal::parse_features(is_readable, text, mesh, edge_is_feature, format);
}

/// \ingroup PkgTSplinesIO
/// reads features, edges of a mesh, from a file. Its extension, in any case, says its format: `.sharp` for `SHARP`, `.obj` for
/// `OBJ_LINES`, any other one for `VERTEX_PAIRS`.
/// \param filename a file
/// \param mesh, edge_is_feature see the function that reads from a stream
/// \return the same status, line and elements.
template <typename TriangleMesh, typename EdgeIsFeatureMap>
Feature_file_report read_features(const std::string& filename, const TriangleMesh& mesh,
                                  EdgeIsFeatureMap edge_is_feature)
{
  const std::string extension = internal::lowercase_extension(filename);
  std::string text;
  const bool is_readable = internal::read_whole_file(filename, text);
  return internal::parse_features(is_readable, text, mesh, edge_is_feature,
                                  extension == ".sharp" ? Feature_file_format::SHARP
                                  : extension == ".obj" ? Feature_file_format::OBJ_LINES
                                                        : Feature_file_format::VERTEX_PAIRS);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_FEATURES_H
