// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H
#define CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/support/Split_position.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// How the grading of a T-mesh ended.
enum class T_mesh_grading_status {
  GRADED,     ///< the sizes change gradually
  INTERRUPTED ///< the visitor asked to stop; the T-mesh has the splits so far, and is admissible
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_grading_status status)
{
  switch (status) {
  case T_mesh_grading_status::GRADED: return "the sizes of the faces change gradually";
  case T_mesh_grading_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// What `grade_T_mesh()` did.
struct T_mesh_grading_report {
  T_mesh_grading_status status = T_mesh_grading_status::GRADED; ///< how it ended
  std::size_t splits = 0;                                       ///< each adds one face

  /// returns whether `status` tells of success.
  bool success() const { return status == T_mesh_grading_status::GRADED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTMesh
/// returns what `report` says, with the number of splits.
inline std::string describe(const T_mesh_grading_report& report)
{
  return message(report.status) + (" (" + std::to_string(report.splits) + " splits)");
}

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

  T_mesh_grading_report run(const double ratio, Progress& progress)
  {
    constexpr std::size_t work_per_face = 20, work_per_split = 1000;
    const auto range = faces(m_graph);
    std::vector<face_descriptor> stack(range.begin(), range.end());
    const double number_of_faces = static_cast<double>(stack.size());
    T_mesh_grading_report report;
    progress.go_on();
    while (!stack.empty()) {
      if (!progress.go_on_after(work_per_face)) {
        report.status = T_mesh_grading_status::INTERRUPTED;
        return report;
      }
      progress.progress(1 - static_cast<double>(stack.size()) / number_of_faces);
      const face_descriptor f = stack.back();
      stack.pop_back();
      if (!is_too_large(f, ratio))
        continue;
      const int axis = m_editor.coordinates().width(f) >= m_editor.coordinates().height(f) ? 0 : 1;
      const auto edit = m_editor.split_face(f, axis, m_split_position(f, axis));
      CGAL_assertion(bool(edit));
      ++report.splits;
      progress.go_on_after(work_per_split);
      // The parts, and all that are larger beside them now.
      for (const halfedge_descriptor n : {edit.halfedge, opposite(edit.halfedge, m_graph)}) {
        stack.push_back(face(n, m_graph));
        for (const halfedge_descriptor h : CGAL::halfedges_around_face(n, m_graph))
          if (face(opposite(h, m_graph), m_graph) != Traits::null_face())
            stack.push_back(face(opposite(h, m_graph), m_graph));
      }
    }
    return report;
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
///   \cgalParamNBegin{observer}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshObserver`, copied}
///     \cgalParamDefault{`T_mesh_observer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended, and the number of splits. Complexity: linear in the size of the T-mesh and the number of splits, times the
/// number of halfedges of a face.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_grading_report grade_T_mesh(TMesh&& t_mesh, const double ratio,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  CGAL_precondition_msg(ratio >= 3, "the ratio must be at least 3: a split leaves a third of a side");
  T_mesh_editor editor(t_mesh, choose_parameter(get_parameter(np, np_tags::observer), T_mesh_observer()));
  using Grading = internal::T_mesh_grading<decltype(editor), Const_T_mesh_view_of<TMesh>>;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("grading");
  return Grading(editor, t_mesh).run(ratio, progress);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_GRADE_T_MESH_H
