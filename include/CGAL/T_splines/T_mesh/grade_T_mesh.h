// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H
#define CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/internal/Split_position.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Splits faces that are too large for one of their neighbours.
// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename Editor, typename TMesh>
class T_mesh_grading {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using face_descriptor = typename Editor::face_descriptor;
  using halfedge_descriptor = typename Editor::halfedge_descriptor;

public:
  T_mesh_grading(Editor& editor, const TMesh& t_mesh)
    : m_editor(editor),
      m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_split_position(t_mesh)
  {
  }

  std::size_t run(const double ratio)
  {
    const auto range = faces(m_graph);
    std::vector<face_descriptor> stack(range.begin(), range.end());
    std::size_t splits = 0;
    while (!stack.empty()) {
      const face_descriptor f = stack.back();
      stack.pop_back();
      if (!is_too_large(f, ratio))
        continue;
      const int axis = m_editor.coordinates().width(f) >= m_editor.coordinates().height(f) ? 0 : 1;
      const auto edit = m_editor.split_face(f, axis, m_split_position(f, axis));
      CGAL_assertion(bool(edit));
      ++splits;
      // The parts, and all that are larger beside them now.
      for (const halfedge_descriptor n : {edit.halfedge, opposite(edit.halfedge, m_graph)}) {
        stack.push_back(face(n, m_graph));
        for (const halfedge_descriptor h : CGAL::halfedges_around_face(n, m_graph))
          if (face(opposite(h, m_graph), m_graph) != Traits::null_face())
            stack.push_back(face(opposite(h, m_graph), m_graph));
      }
    }
    return splits;
  }

private:
  double longer_side(const face_descriptor f) const
  {
    return (std::max)(CGAL::to_double(m_editor.coordinates().width(f)),
                      CGAL::to_double(m_editor.coordinates().height(f)));
  }

  bool is_too_large(const face_descriptor f, const double ratio) const
  {
    const double size = longer_side(f);
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_graph), m_graph)) {
      const halfedge_descriptor o = opposite(h, m_graph);
      if (face(o, m_graph) == Traits::null_face())
        continue;
      const double unit = CGAL::to_double(m_t_mesh.knot(h)) / CGAL::to_double(m_t_mesh.knot(o));
      if (size > ratio * longer_side(face(o, m_graph)) * unit)
        return true;
    }
    return false;
  }

  Editor& m_editor;
  TMesh m_t_mesh;
  const Graph& m_graph;
  Split_position<TMesh> m_split_position;
};

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// splits faces of a T-mesh until the sizes change gradually: until no face is, by its longer side, more than `ratio`
/// times as large as a face that it shares an edge with, in the units of the edge.
///
/// Where a small face lies beside a large one, a T-spline surface has no basis functions of the sizes between. Faces
/// are split across their longer side, as `refine_T_mesh()` splits them. No new face is smaller than the smallest one
/// beside it, so that it ends.
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph` and `FaceListGraph`
/// \pre the knots are admissible
/// \param t_mesh the T-mesh that is changed
/// \param ratio at least 3
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshVisitor`, copied}
///     \cgalParamDefault{`T_mesh_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the number of splits. Complexity: linear in the size of the T-mesh and the number of splits, times the
/// number of halfedges of a face.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t grade_T_mesh(TMesh&& t_mesh, const double ratio,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  CGAL_precondition_msg(ratio >= 3, "the ratio must be at least 3: a split leaves a third of a side");
  T_mesh_editor editor(t_mesh, choose_parameter(get_parameter(np, CGAL::internal_np::visitor), T_mesh_visitor()));
  using Grading = internal::T_mesh_grading<decltype(editor), Const_T_mesh_view_of<TMesh>>;
  return Grading(editor, t_mesh).run(ratio);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H
