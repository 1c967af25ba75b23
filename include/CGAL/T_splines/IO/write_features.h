// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_FEATURES_H
#define CGAL_T_SPLINES_IO_WRITE_FEATURES_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// writes features, edges of a mesh, as `read_features()` reads them: the two ends of an edge per line, counted from 0 in the
/// order of the mesh, the smaller one first; by increasing ends.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadablePropertyMap` from edges to `bool`
/// \param output receives the file
/// \param mesh the mesh
/// \param edge_is_feature the edges to be written
///
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear in the
///         size of the mesh, and O(n log n) for n features.
template <typename TriangleMesh, typename EdgeIsFeatureMap>
std::error_code write_features(std::ostream& output, const TriangleMesh& mesh, const EdgeIsFeatureMap& edge_is_feature)
{
  using Index_map =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type;
  const Index_map index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t number_of_vertices = 0;
  for (const auto v : CGAL::make_range(vertices(mesh)))
    put(index, v, number_of_vertices++);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto e : CGAL::make_range(edges(mesh)))
    if (get(edge_is_feature, e))
      pairs.push_back(std::minmax({get(index, source(e, mesh)), get(index, target(e, mesh))}));
  std::sort(pairs.begin(), pairs.end());
  internal::Text_writer writer(output);
  for (const auto& [v, w] : pairs)
    writer << v << " " << w << "\n";
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes features, edges of a mesh, to a file, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced. `read_features()` takes any extension but `.sharp`
///        and `.obj` for this format
/// \param mesh, edge_is_feature see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written.
template <typename TriangleMesh, typename EdgeIsFeatureMap>
std::error_code write_features(const std::string& filename, const TriangleMesh& mesh,
                               const EdgeIsFeatureMap& edge_is_feature)
{
  return internal::write_file(filename, [&](std::ostream& output) { write_features(output, mesh, edge_is_feature); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_FEATURES_H
