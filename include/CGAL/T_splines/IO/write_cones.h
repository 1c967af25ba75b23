// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_CONES_H
#define CGAL_T_SPLINES_IO_WRITE_CONES_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// writes the cones of a holonomy signature in the format `.cones`: one line `vertex k` for each vertex with k != 4, with its
/// index, from 0 in the order of the mesh; by increasing index.
/// \tparam TriangleMesh a model of `VertexListGraph` and `HalfedgeGraph`
/// \param output receives the file
/// \param mesh the mesh
/// \param signature a signature of the mesh
///
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear in the
///         number of vertices.
template <typename TriangleMesh>
std::error_code write_cones(std::ostream& output, const TriangleMesh& mesh,
                            const Holonomy_signature<TriangleMesh>& signature)
{
  internal::Text_writer writer(output);
  std::size_t index = 0;
  for (const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v : CGAL::make_range(vertices(mesh))) {
    const int k = signature.quarter_turns(v);
    if (k != Holonomy_signature<TriangleMesh>::regular)
      writer << index << " " << std::to_string(k) << "\n";
    ++index;
  }
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes the cones of a holonomy signature to a file of the format `.cones`, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced
/// \param mesh, signature see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear in the
///         number of vertices.
template <typename TriangleMesh>
std::error_code write_cones(const std::string& filename, const TriangleMesh& mesh,
                            const Holonomy_signature<TriangleMesh>& signature)
{
  return internal::write_file(filename, [&](std::ostream& output) { write_cones(output, mesh, signature); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_CONES_H
