// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_REGULARIZE_T_MESH_H
#define CGAL_T_SPLINES_T_MESH_REGULARIZE_T_MESH_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/internal/T_mesh_regularization.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// How the regularization of a T-mesh ended.
enum class T_mesh_regularization_status {
  REGULARIZED, ///< no operation makes it better, or as many were done as were allowed
  INTERRUPTED  ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_regularization_status status)
{
  switch (status) {
  case T_mesh_regularization_status::REGULARIZED: return "the T-mesh was regularized";
  case T_mesh_regularization_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// What `regularize_T_mesh()` did. An aspect ratio is at least 1.
struct T_mesh_regularization_report {
  T_mesh_regularization_status status = T_mesh_regularization_status::REGULARIZED; ///< how it ended
  std::size_t faces_before = 0,                                                    ///< of the T-mesh that was given
      faces_after = 0;                                                             ///< of the changed T-mesh
  double worst_aspect_before = 1,                                                  ///< largest aspect ratio
      worst_aspect_after = 1;                                                      ///< largest aspect ratio
  double median_aspect_before = 1,                                                 ///< median of the aspect ratios
      median_aspect_after = 1;                                                     ///< median of the aspect ratios
  std::size_t removals = 0;                                                        ///< edges removed
  std::size_t flips = 0;            ///< edges removed with orthogonal insertion
  std::size_t partial_removals = 0; ///< edges removed in part
  std::size_t closed_gaps = 0;      ///< lines shortened that ended close to another one

  /// returns whether `status` tells of success.
  bool success() const { return status == T_mesh_regularization_status::REGULARIZED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTMesh
/// returns what `report` says, with the numbers of faces and the worst aspect ratios before and after.
inline std::string describe(const T_mesh_regularization_report& report)
{
  std::ostringstream text;
  text << message(report.status) << ": from " << report.faces_before << " to " << report.faces_after
       << " faces, the worst aspect ratio from " << report.worst_aspect_before << " to " << report.worst_aspect_after;
  return text.str();
}

namespace internal {

template <typename Graph, typename Regularization>
void aspect_statistics(const Graph& graph, const Regularization& regularization, std::size_t& number, double& worst,
                       double& median)
{
  std::vector<double> aspects;
  for (const auto f : CGAL::make_range(faces(graph)))
    aspects.push_back(regularization.aspect(f));
  number = aspects.size();
  if (aspects.empty())
    return;
  worst = *std::max_element(aspects.begin(), aspects.end());
  const auto middle = aspects.begin() + aspects.size() / 2;
  std::nth_element(aspects.begin(), middle, aspects.end());
  median = *middle;
}

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// makes the faces of a T-mesh squarer by removing edges, wholly or in part ([CZ17] section 8.1).
///
/// First come faces of more than 1:32, between the lines of two extraordinary vertices that face each other and miss
/// each other by little. What is left of such a face when a line is cut short may still be as thin: it is removed from
/// its other side next. So each of the two lines ends halfway, where a greedy choice would leave ever shorter faces
/// towards the vertices, and the rings that a T-spline surface needs there would be as small as the smallest one. Then
/// narrow gaps between the ends are closed as below.
///
/// Greedily, the face with the worst aspect ratio comes first; of the removals on its long sides the one is executed
/// after which the worst of the faces concerned is best, if it is better than before by at least 5 percent. So it
/// ends. Of two removals, one that leaves a face more is taken only if its worst aspect ratio is better by a factor of
/// 1.5; and where no face is worse than 1:3, no face is added. Edges at extraordinary vertices are removed only in
/// part, and no such vertex moves. Creases are never removed, and vertices where they end or turn are treated as
/// extraordinary ones.
///
/// Afterwards, where two lines end at opposite sides of a third one, and the gap between them is less than a sixteenth
/// of a face beside it, one of them is shortened, if no face becomes worse than the worst one, or than 1:5: aspect
/// ratios do not see such gaps, but the knots of a T-spline surface would be as close.
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph` and `FaceListGraph`
/// \pre the knots are admissible
/// \param t_mesh the T-mesh that is changed
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{observer}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshObserver`, copied}
///     \cgalParamDefault{`T_mesh_observer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{vertices that are treated as extraordinary ones}
///     \cgalParamType{a model of `ReadablePropertyMap`, vertex of the T-mesh -> `bool`}
///     \cgalParamDefault{no vertex is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of operations}
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
/// \return how many operations were done, and aspect ratios before and after. If the status is INTERRUPTED, the T-mesh is
///         what the operations so far have made of it: admissible, and its observer is up to date.
/// Complexity: O(log n) for each operation, plus the number of halfedges of the faces that it touches and of their
/// neighbours; quadratic in the number of T-joints of a single face.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_regularization_report regularize_T_mesh(TMesh&& t_mesh,
                                               const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using View = T_mesh_view_of<TMesh>;
  const std::size_t number_of_operations = choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                                                            (std::numeric_limits<std::size_t>::max)());
  const auto observer = choose_parameter(get_parameter(np, np_tags::observer), T_mesh_observer());
  const auto constrained =
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_is_constrained),
                       CGAL::Static_boolean_property_map<typename View::vertex_descriptor, false>());
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("regularization");
  const View view(t_mesh);
  internal::T_mesh_regularization<View, std::decay_t<decltype(observer)>, std::decay_t<decltype(constrained)>>
      regularization(view, observer, constrained);
  T_mesh_regularization_report report;
  internal::aspect_statistics(view.graph(), regularization, report.faces_before, report.worst_aspect_before,
                              report.median_aspect_before);
  const auto counts = regularization.run(number_of_operations, progress);
  if (progress.is_interrupted())
    report.status = T_mesh_regularization_status::INTERRUPTED;
  report.removals = counts.removals;
  report.flips = counts.flips;
  report.partial_removals = counts.partial_removals;
  report.closed_gaps = counts.closed_gaps;
  internal::aspect_statistics(view.graph(), regularization, report.faces_after, report.worst_aspect_after,
                              report.median_aspect_after);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_REGULARIZE_T_MESH_H
