// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_REFINE_T_MESH_H
#define CGAL_T_SPLINES_T_MESH_REFINE_T_MESH_H

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/support/Split_position.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// How the refinement of a T-mesh ended.
enum class T_mesh_refinement_status {
  REFINED,         ///< no face is larger than the target
  INVALID_TARGET,  ///< the target size is not positive; nothing was done
  SIZE_NOT_FINITE, ///< the size of `face` is infinite or not a number; it was left as it is
  ITERATION_LIMIT, ///< the allowed number of splits was not enough; `face` was the largest face then
  INTERRUPTED      ///< the visitor asked to stop; the T-mesh has the splits so far, and is admissible
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_refinement_status status)
{
  switch (status) {
  case T_mesh_refinement_status::REFINED: return "no face is larger than the target size";
  case T_mesh_refinement_status::INVALID_TARGET: return "the target size is not positive";
  case T_mesh_refinement_status::SIZE_NOT_FINITE: return "the size of a face is not a finite number";
  case T_mesh_refinement_status::ITERATION_LIMIT: return "the allowed number of splits was not enough";
  case T_mesh_refinement_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// What `refine_T_mesh()` did. Members that `status` does not mention have no meaning.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct T_mesh_refinement_report {
  T_mesh_refinement_status status = T_mesh_refinement_status::REFINED; ///< how it ended
  std::size_t splits = 0;                                              ///< each adds one face; always set
  /// the face that `status` is about.
  typename boost::graph_traits<Graph>::face_descriptor face = boost::graph_traits<Graph>::null_face();

  /// returns whether `status` tells of success.
  bool success() const { return status == T_mesh_refinement_status::REFINED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTMesh
/// returns what `report` says, with the number of the face concerned, counted from 0. Complexity: linear in the size of
/// the T-mesh.
template <typename Graph>
std::string describe(const T_mesh_refinement_report<Graph>& report, const Graph& graph)
{
  const std::string text = message(report.status);
  return report.face == boost::graph_traits<Graph>::null_face()
             ? text
             : text + ": " + internal::face_in_words(report.face, graph) + ", counted from 0";
}

namespace internal {

// Splits faces at their longer side, largest first.
// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename Editor, typename TMesh, typename FaceSize>
class T_mesh_refinement {
  using Graph = typename TMesh::Graph;
  using face_descriptor = typename Editor::face_descriptor;

  struct Entry {
    double size; // of the longer side
    int axis;
    std::size_t number; // order of entry
    face_descriptor f;

    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.size != b.size ? a.size < b.size : a.number > b.number;
    }
  };

public:
  T_mesh_refinement(Editor& editor, const TMesh& t_mesh, const FaceSize& face_size, Progress& progress)
    : m_editor(editor),
      m_graph(t_mesh.graph()),
      m_split_position(t_mesh),
      m_face_size(face_size),
      m_progress(progress)
  {
  }

  T_mesh_refinement_report<Graph> run(const double target, const std::size_t number_of_splits)
  {
    T_mesh_refinement_report<Graph> report;
    m_progress.go_on();
    for (const face_descriptor f : faces(m_graph))
      push(f, target, report);
    const double first = m_queue.empty() ? target : m_queue.top().size;
    while (!m_queue.empty()) {
      const Entry entry = m_queue.top();
      m_progress.progress(std::log(first / entry.size) / std::log(first / target));
      if (!m_progress.go_on_after(work_per_split))
        break;
      if (report.splits == number_of_splits) {
        report.status = T_mesh_refinement_status::ITERATION_LIMIT;
        report.face = entry.f;
        return report;
      }
      m_queue.pop();
      const auto edit = m_editor.split_face(entry.f, entry.axis, m_split_position(entry.f, entry.axis));
      CGAL_assertion(bool(edit));
      ++report.splits;
      push(face(edit.halfedge, m_graph), target, report);
      push(face(opposite(edit.halfedge, m_graph), m_graph), target, report);
    }
    if (m_progress.is_interrupted())
      report.status = T_mesh_refinement_status::INTERRUPTED;
    return report;
  }

private:
  static constexpr std::size_t work_per_split = 1000;

  void push(const face_descriptor f, const double target, T_mesh_refinement_report<Graph>& report)
  {
    m_progress.go_on_after(100);
    const std::pair<double, double> size = m_face_size(f);
    if (!std::isfinite(size.first) || !std::isfinite(size.second)) {
      report.status = T_mesh_refinement_status::SIZE_NOT_FINITE;
      report.face = f;
      return;
    }
    const double longer = (std::max)(size.first, size.second);
    if (longer > target)
      m_queue.push({longer, size.first >= size.second ? 0 : 1, m_number++, f});
  }

  Editor& m_editor;
  const Graph& m_graph;
  Split_position<TMesh> m_split_position;
  const FaceSize& m_face_size;
  Progress& m_progress;
  std::priority_queue<Entry> m_queue;
  std::size_t m_number = 0;
};

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// splits the faces of a T-mesh until none is larger than a target size ([CZ17] section 9.2: "1-to-2 face splits").
///
/// The largest face comes first. It is split across its longer side, at a vertex in the middle third of one of the two
/// sides that are cut, one that both have if there is one, or else in the middle.
///
/// It ends if the size of a face tends to zero with its extent in the parameter domain: each split leaves a face at
/// most two thirds of an extent. This holds for `Parametric_face_size` and `Surface_face_size`.
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph` and `FaceListGraph`
/// \tparam FaceSize a model of `TMeshFaceSize`; it is not copied, so that it may follow the changes
/// \pre the knots are admissible
/// \param t_mesh the T-mesh that is changed
/// \param face_size gives the lengths of a face along u and along v, in any unit: `Parametric_face_size`,
///        `Surface_face_size`
/// \param target_size the largest length allowed, in the same unit; positive
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{observer}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshObserver`, copied}
///     \cgalParamDefault{`T_mesh_observer`}
///     \cgalParamExtra{Needed if `face_size` has a visitor.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of splits}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no bound}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended
///
/// Complexity: O(log n) for each split, plus the number of halfedges of the face, plus its size.
template <typename TMesh, typename FaceSize, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_refinement_report<T_mesh_graph<TMesh>>
refine_T_mesh(TMesh&& t_mesh, const FaceSize& face_size, const double target_size,
              const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  if (!(target_size > 0)) {
    T_mesh_refinement_report<T_mesh_graph<TMesh>> report;
    report.status = T_mesh_refinement_status::INVALID_TARGET;
    return report;
  }
  const std::size_t number_of_splits = choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                                                        (std::numeric_limits<std::size_t>::max)());
  T_mesh_editor editor(t_mesh, choose_parameter(get_parameter(np, np_tags::observer), T_mesh_observer()));
  using Refinement = internal::T_mesh_refinement<decltype(editor), Const_T_mesh_view_of<TMesh>, FaceSize>;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("refinement");
  return Refinement(editor, t_mesh, face_size, progress).run(target_size, number_of_splits);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_REFINE_T_MESH_H
