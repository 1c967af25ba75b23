// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_CONES_H
#define CGAL_T_SPLINES_IO_WRITE_CONES_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// writes the cones of a holonomy signature in the format `.cones`: one line `vertex k` for each vertex with k != 4, with its
/// index, from 0 in the order of the mesh; by increasing index.
/// \tparam TriangleMesh a model of `VertexListGraph` and `HalfedgeGraph`
/// \param output is written to; its state tells whether this succeeded
/// \param mesh the mesh
/// \param signature a signature of the mesh
///
/// Complexity: linear in the number of vertices.
template <typename TriangleMesh>
void write_cones(std::ostream& output, const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature)
{
  std::size_t index = 0;
  for (const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v : CGAL::make_range(vertices(mesh))) {
    const int k = signature.quarter_turns(v);
    if (k != Holonomy_signature<TriangleMesh>::regular)
      output << std::to_string(index) + ' ' + std::to_string(k) + '\n';
    ++index;
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_CONES_H
