// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H

#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/T_spline_self_intersection_report.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Creased_triangles.h>
#include <CGAL/T_splines/Spline/internal/Fit_progress.h>
#include <CGAL/T_splines/Spline/internal/Fold_state.h>
#include <CGAL/T_splines/Spline/internal/Measured_surface.h>
#include <CGAL/T_splines/Spline/internal/Mesh_intersections.h>
#include <CGAL/T_splines/Spline/internal/Surface_fitter.h>
#include <CGAL/T_splines/Spline/internal/Surface_walk.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/grade_T_mesh.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/support/Face_ancestors.h>
#include <CGAL/T_splines/T_mesh/support/Split_position.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What an adaptive fit is asked for.
struct Adaptive_fit_options {
  double tolerance; ///< by the longest side of the bounding box of the mesh
  double fairness;
  std::optional<std::size_t> largest_number_of_control_points; ///< none: as `default_limit()` says
  int number_of_corrections;                                   ///< per level
};

/// As many control points as a surface may need that is worth having.
inline std::size_t default_limit(const std::size_t coarsest, const std::size_t number_of_points)
{
  return (std::max)({std::size_t(always_allowed_control_points), 4 * coarsest, number_of_points / 2});
}

/// Fits, refines where the surface is too far from the mesh or folds, and fits again.
///
/// There are two T-meshes: a plain one, whose faces are split, and its copy that is made spline compatible anew for
/// each level. So the rings around extraordinary vertices are as wide as the faces of the level allow, and what they
/// needed in one level is no burden to the next.
///
/// Distances at samples tell where to refine. Only when they find nothing more, the distance is measured as users
/// would measure it; what exceeds the tolerance or folds then is refined as well.
/// \tparam Reference a `Reference_mesh`
template <typename Kernel, typename SolverTraits, typename Reference>
class Adaptive_fit {
  using FT = typename Kernel::FT;
  using Working = T_mesh<typename Kernel::Point_3, FT>;
  using Graph = typename Working::Graph;
  using Face = typename Graph::Face_index;
  using Carried = Carried_surface<Graph>;
  using Fitter = Surface_fitter<Const_T_mesh_view_of<Working>, Kernel>;
  using Compiled = typename Fitter::Compiled;
  using Deviation_report = T_spline_deviation_report<Graph, typename Reference::TriangleMesh>;
  using Status = Adaptive_fit_status;

public:
  using Level_observer = std::function<void(const T_spline_fit_level&, const Working&)>;

  /// \param t_mesh admissible
  /// \param surface in its faces
  /// \param reference valid, not flat
  /// \param observer is told each level that is fitted, with its T-mesh, whose points are the control points
  /// \param progress must outlive this
  Adaptive_fit(const Working& t_mesh, const Carried& surface, Reference& reference, const Adaptive_fit_options& options,
               SolverTraits& solver, const Level_observer& observer, Progress& progress)
    : m_options(options),
      m_tolerance(options.tolerance * reference.extent()),
      m_reference(reference),
      m_solver(solver),
      m_observer(observer),
      m_caller(progress),
      m_triangles(Const_T_mesh_view_of<Working>(t_mesh), surface),
      m_walk(m_triangles.points(), m_triangles.triangles(), others_than_data(surface), progress),
      m_plain{t_mesh, surface, std::vector<double>(t_mesh.graph().number_of_faces(), 1)}
  {
  }

  /// \tparam Report an `Adaptive_fit_report`
  template <typename Report>
  void run(Report& report)
  {
    run_levels(report);
    if (m_caller.is_interrupted())
      report.status = Status::INTERRUPTED;
  }

  /// The T-mesh of the best level, with its control points.
  const Working& best() const { return m_best; }

private:
  static std::vector<bool> others_than_data(const Carried& surface)
  {
    std::vector<bool> result;
    for (std::size_t i = 0; i < surface.triangles().size(); ++i)
      result.push_back(!surface.is_data(i));
    return result;
  }

  template <typename Report>
  void run_levels(Report& report)
  {
    m_caller.begin_stage("fit");
    if (!m_caller.go_on())
      return;
    report.incompatibility = make_compatible();
    if (report.incompatibility != Spline_compatibility_status::SPLINE_COMPATIBLE) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      return;
    }
    const std::size_t coarsest = m_fine.t_mesh.graph().number_of_vertices();
    report.is_limit_default = !m_options.largest_number_of_control_points;
    report.limit =
        m_options.largest_number_of_control_points.value_or(default_limit(coarsest, m_triangles.points().size()));
    if (coarsest > report.limit) {
      report.status = Status::LIMIT_TOO_LOW;
      report.levels.push_back({coarsest, m_fine.t_mesh.graph().number_of_faces(), m_in_rings, 0, 0, {}});
      return;
    }
    while (fit_level(report)) {
      if (m_progress.add(quality(report.levels.back()))) {
        report.best_level = report.levels.size() - 1;
        m_best = m_fine.t_mesh;
        m_measured_best = m_measured;
      }
      if (is_done(report))
        break;
    }
    if (report.status == Status::INTERRUPTED || report.levels.empty())
      return;
    // A level that cannot be fitted is no reason to give away those before.
    if (!report.success())
      report.status = Status::NO_IMPROVEMENT;
    describe_best(report);
  }

  struct State {
    Working t_mesh;
    Carried surface;
    std::vector<double> stiffness; // of the faces, by index
  };

  // What is known of the surface of a level once it is within the tolerance at all samples.
  struct Measured_level {
    Deviation_report deviation;
    std::optional<T_spline_self_intersection_report> self_intersections; // if there are no folds
  };

  // A face of the plain T-mesh that is to be split.
  struct Plan {
    Face face;
    double error;    // the largest one in the face, by the tolerance
    int longer_axis; // of the face: 0 for u, 1 for v
    bool is_strip;
  };

  Fit_quality quality(const T_spline_fit_level& level) const
  {
    return {level.number_of_control_points, level.error.maximum / m_tolerance, level.error.rms / m_tolerance,
            level.number_of_folded_faces,   level.number_of_doubtful_faces,    m_area_to_mend};
  }

  // Refines, or says why not.
  template <typename Report>
  bool is_done(Report& report)
  {
    if (m_progress.best().is_within_tolerance())
      report.status = Status::WITHIN_TOLERANCE;
    else if (m_progress.has_stalled())
      report.status = Status::NO_IMPROVEMENT;
    else if (m_plans.empty())
      report.status = Status::RESOLUTION_REACHED;
    else if (!m_caller.go_on())
      report.status = Status::INTERRUPTED;
    else {
      const Refinement refinement = refine(report.limit);
      if (refinement == Refinement::DONE)
        return false;
      report.status = refinement == Refinement::NOT_ALLOWED ? Status::CONTROL_POINT_LIMIT : Status::RESOLUTION_REACHED;
    }
    return true;
  }

  // Measures the surface that is handed out, if that was not done when its level was fitted.
  template <typename Report>
  void describe_best(Report& report)
  {
    if (!m_measured_best || !m_measured_best->self_intersections) {
      const T_spline<Kernel> best(m_best);
      const Compiled compiled = compile_T_spline(best.surface(), CGAL::parameters::visitor(Part_visitor(m_caller)));
      if (compiled.status() == T_spline_compilation_status::INTERRUPTED)
        return;
      if (!m_measured_best)
        m_measured_best = measure(compiled, [](std::size_t, double, Fold_state) {});
      if (m_caller.is_interrupted())
        return;
      if (!m_measured_best) {
        report.status = Status::NOT_MEASURABLE;
        report.deviation.status = T_spline_deviation_status::SURFACE_NOT_FINITE;
        return;
      }
      m_measured_best->self_intersections = self_intersections(compiled, CGAL::Emptyset_iterator());
    }
    report.deviation = m_measured_best->deviation;
    report.self_intersections = *m_measured_best->self_intersections;
    report.self_intersections.number_of_mesh_intersections = m_reference.intersections().number_of_pairs();
    if (report.deviation.within_tolerance() && !report.deviation.has_folds() && report.self_intersections.success())
      report.status = Status::WITHIN_TOLERANCE;
  }

  // Makes the copy. Returns which condition could not be met.
  Spline_compatibility_status make_compatible()
  {
    m_fine = m_plain;
    m_ancestors = Face_ancestors<Graph>();
    const T_mesh_observer_pair observer(m_fine.surface.observer(), m_ancestors.observer());
    const auto refinement = CGAL::T_splines::make_spline_compatible(m_fine.t_mesh, with_part_visitor(observer));
    m_in_rings = refinement.vertices_in_rings;
    m_fine.stiffness = inherited(m_plain.stiffness, m_ancestors, m_fine.t_mesh.graph());
    return refinement.status;
  }

  // The named parameters with which a T-mesh is changed.
  template <typename Observer>
  auto with_part_visitor(const Observer& observer) const
  {
    return CGAL::T_splines::parameters::observer(observer).visitor(Part_visitor(m_caller));
  }

  // What the faces have of those that they were cut from.
  static std::vector<double> inherited(const std::vector<double>& stiffness, const Face_ancestors<Graph>& ancestors,
                                       const Graph& graph)
  {
    std::vector<double> result;
    for (const Face f : graph.faces())
      result.push_back(stiffness[ancestors(f)]);
    return result;
  }

  template <typename Report>
  bool fit_level(Report& report)
  {
    constexpr double almost = 2;
    Working& t = m_fine.t_mesh;
    m_caller.begin_stage("fit");
    Fitter fitter(t, m_fine.surface, m_walk, m_fine.stiffness, m_caller);
    if (!fitter.fitted().surface().is_valid()) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      report.incompatibility = fitter.fitted().surface().report().compatibility.status;
      return false;
    }
    T_spline_fit_report<Graph> fit;
    if (!fitter.fit(start(report), m_tolerance, m_options.fairness, m_options.number_of_corrections, m_solver, fit)) {
      report.fit.status = fit.status;
      report.status = fit.status == T_spline_fit_status::INTERRUPTED  ? Status::INTERRUPTED
                      : fit.status == T_spline_fit_status::NO_SAMPLES ? Status::NO_SURFACE
                                                                      : Status::FIT_FAILED;
      return false;
    }
    for (const auto v : t.graph().vertices())
      t.graph().point(v) = fitter.fitted().control_point(v);
    std::vector<Face_fit> faces = fitter.faces();
    Compiled compiled = compile_T_spline(fitter.fitted().surface(), CGAL::parameters::visitor(Part_visitor(m_caller)));
    if (compiled.status() == T_spline_compilation_status::INTERRUPTED)
      return false;
    m_last.emplace(std::move(compiled), m_fine.surface);
    m_measured.reset();
    if (are_within(faces))
      measure_level(faces, fit.error);
    if (!m_caller.go_on())
      return false;
    if (fit.error.maximum <= almost * m_tolerance)
      stiffen(faces);
    const auto number_of = [&](const Fold_state fold) {
      return static_cast<std::size_t>(
          std::count_if(faces.begin(), faces.end(), [&](const Face_fit& face) { return face.fold == fold; }));
    };
    report.number_of_samples = fit.number_of_samples;
    report.levels.push_back({t.graph().number_of_vertices(), t.graph().number_of_faces(), m_in_rings,
                             number_of(Fold_state::FOLDED), number_of(Fold_state::DOUBTFUL), fit.error});
    if (m_observer)
      m_observer(report.levels.back(), t);
    plan(faces);
    return true;
  }

  // The surface of the last level, if it is near enough to begin with.
  template <typename Report>
  const typename Fitter::Start* start(const Report& report) const
  {
    constexpr double near = 3; // by the tolerance
    return m_last && report.levels.back().error.maximum <= near * m_tolerance ? &*m_last : nullptr;
  }

  bool are_within(const std::vector<Face_fit>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(), [&](const Face_fit& face) {
      return face.distance <= m_tolerance && face.fold != Fold_state::FOLDED;
    });
  }

  // Where the surface folds, it will be stiffer, and in the faces beside: the fold would only move there.
  void stiffen(const std::vector<Face_fit>& faces)
  {
    constexpr double stiffer = 3;
    const Graph& graph = m_plain.t_mesh.graph();
    std::vector<char> is_concerned(graph.number_of_faces(), false);
    for (const Face f : m_fine.t_mesh.graph().faces()) {
      if (faces[f].fold != Fold_state::FOLDED)
        continue;
      const Face folded = m_ancestors(f);
      is_concerned[folded] = true;
      for (const auto h : graph.halfedges_around_face(graph.halfedge(folded)))
        if (!graph.is_border(graph.opposite(h)))
          is_concerned[graph.face(graph.opposite(h))] = true;
    }
    for (const Face f : graph.faces())
      m_plain.stiffness[f] *= is_concerned[f] ? stiffer : 1;
  }

  // What the samples did not see, by what `measure_T_spline_deviation()` and `check_T_spline_self_intersections()` do.
  void measure_level(std::vector<Face_fit>& faces, T_spline_fit_error& error)
  {
    m_measured = measure(m_last->compiled(), [&](const std::size_t i, const double distance, const Fold_state fold) {
      faces[i].distance = (std::max)(faces[i].distance, distance);
      faces[i].fold = (std::max)(faces[i].fold, fold);
    });
    if (!m_measured)
      return;
    const Deviation_report& deviation = m_measured->deviation;
    error.maximum = (std::max)(deviation.maximum(), deviation.maximum_of_curves());
    error.rms = (std::max)(deviation.mesh_to_surface.rms, deviation.surface_to_mesh.rms);
    if (!deviation.within_tolerance() || deviation.has_folds())
      return;
    std::vector<Face> found;
    m_measured->self_intersections = self_intersections(m_last->compiled(), std::back_inserter(found));
    for (const Face f : found)
      faces[f].fold = Fold_state::FOLDED;
  }

  // Distances and folds, if the surface is finite.
  // \param visit is called with each face, the largest distance there, and whether it folds
  template <typename Visit>
  std::optional<Measured_level> measure(const Compiled& compiled, const Visit& visit)
  {
    Measured_surface<Compiled> surface(compiled, m_caller);
    if (!m_caller.go_on() || !surface.is_finite())
      return std::nullopt;
    Measured_level level;
    level.deviation.tolerance = m_tolerance;
    Deviation_measurement<Compiled, typename Reference::TriangleMesh> measurement(
        m_reference.measured(), m_reference.reading(), surface, m_caller, level.deviation);
    measurement.measure_surface();
    measurement.measure_mesh();
    measurement.measure_curves();
    if (m_caller.is_interrupted())
      return std::nullopt;
    for (int i = 0; i < compiled.indexing().number_of_faces(); ++i)
      visit(static_cast<std::size_t>(i), measurement.face_deviation(i), measurement.face_state(i));
    return level;
  }

  template <typename OutputIterator>
  T_spline_self_intersection_report self_intersections(const Compiled& compiled, const OutputIterator faces)
  {
    const auto of_mesh = [this]() -> const Mesh_intersections& { return m_reference.intersections(); };
    return find_new_self_intersections(compiled, default_tessellation_resolution, of_mesh, m_tolerance, faces,
                                       m_caller);
  }

  // What is to be split: the faces of the plain T-mesh under the faces of the copy that are not as they should be,
  // those with the largest errors first. Those that are much smaller than the tolerance are left alone.
  void plan(const std::vector<Face_fit>& faces)
  {
    constexpr double error_of_fold = 1.5, smallest_size = 0.1; // by the tolerance
    constexpr double strip = 3;                                // how long one is, by its width
    std::vector<double> errors(m_plain.t_mesh.graph().number_of_faces(), 0), areas(errors.size(), 0);
    m_area_to_mend = 0;
    for (const Face f : m_fine.t_mesh.graph().faces()) {
      const Face_fit& face = faces[f];
      const double error =
          (std::max)(face.distance / m_tolerance, face.fold == Fold_state::FOLDED ? error_of_fold : 0.);
      const Face plain = m_ancestors(f);
      errors[plain] = (std::max)(errors[plain], error);
      areas[plain] += face.area;
      m_area_to_mend += error > 1 ? face.area : 0;
    }
    const Working& t = m_plain.t_mesh;
    const T_mesh_coordinates coordinates(t);
    m_plans.clear();
    for (const Face f : t.graph().faces()) {
      const double width = CGAL::to_double(coordinates.width(f)), height = CGAL::to_double(coordinates.height(f));
      const double longer_side = std::sqrt(areas[f] * (std::max)(width / height, height / width));
      if (errors[f] > 1 && longer_side > smallest_size * m_tolerance)
        m_plans.push_back({f, errors[f], width >= height ? 0 : 1, (std::max)(width / height, height / width) >= strip});
    }
    std::stable_sort(m_plans.begin(), m_plans.end(), [](const Plan& a, const Plan& b) { return a.error > b.error; });
  }

  // Splits a face into two across its longer side, or into four, those of a strip one after the other.
  template <typename Editor, typename Position>
  void split(const Plan& plan, const bool is_in_four, Editor& editor, const Position& position)
  {
    const Graph& graph = m_plain.t_mesh.graph();
    const auto edit = editor.split_face(plan.face, plan.longer_axis, position(plan.face, plan.longer_axis));
    if (!is_in_four)
      return;
    const Face other = graph.face(graph.opposite(edit.halfedge)), one = graph.face(edit.halfedge);
    const int axis = plan.is_strip ? plan.longer_axis : 1 - plan.longer_axis;
    for (const Face f : {one, other})
      editor.split_face(f, axis, position(f, axis));
  }

  static constexpr std::size_t work_per_split = 1000;

  // Neighbours of very different size share basis functions that suit neither.
  static constexpr double largest_ratio_of_neighbours = 6;

  enum class Refinement { DONE, NOT_ALLOWED, NOT_COMPATIBLE };

  // Refines; where the T-mesh would have more control points than allowed, or could not be made spline compatible, fewer
  // faces are split, those with the largest errors.
  Refinement refine(const std::size_t limit)
  {
    const std::size_t before = m_fine.t_mesh.graph().number_of_vertices();
    // By the tolerance; and if few faces are left, what more control points cost is less than what more levels do.
    constexpr double large_error = 2, few = 0.03;
    const bool are_few =
        static_cast<double>(m_plans.size()) < few * static_cast<double>(m_fine.t_mesh.graph().number_of_faces());
    const State plain = m_plain;
    std::size_t number = m_plans.size();
    Refinement result = Refinement::NOT_COMPATIBLE;
    while (number > 0 && m_caller.go_on()) {
      Working& t = m_plain.t_mesh;
      Face_ancestors<Graph> ancestors;
      const T_mesh_observer_pair observer(m_plain.surface.observer(), ancestors.observer());
      T_mesh_editor editor(t, observer);
      const Split_position position(t);
      for (std::size_t i = 0; i < number && m_caller.go_on_after(work_per_split); ++i)
        split(m_plans[i], are_few || m_plans[i].error > large_error, editor, position);
      grade_T_mesh(t, largest_ratio_of_neighbours, with_part_visitor(observer));
      m_plain.stiffness = inherited(plain.stiffness, ancestors, t.graph());
      const bool is_compatible = make_compatible() == Spline_compatibility_status::SPLINE_COMPATIBLE;
      const std::size_t after = m_fine.t_mesh.graph().number_of_vertices();
      if (is_compatible && after <= limit)
        return Refinement::DONE;
      m_plain = plain;
      result = is_compatible ? Refinement::NOT_ALLOWED : Refinement::NOT_COMPATIBLE;
      if (is_compatible) {
        const double share_of_growth = static_cast<double>(limit - before) / static_cast<double>(after - before);
        number = static_cast<std::size_t>(static_cast<double>(number) *
                                          (std::min)(0.9 * share_of_growth, 0.5 + 0.4 * share_of_growth));
      }
      else
        number /= 2;
    }
    return result;
  }

  const Adaptive_fit_options& m_options;
  const double m_tolerance; // a length
  Reference& m_reference;
  SolverTraits& m_solver;
  const Level_observer& m_observer;
  Progress& m_caller;
  const Creased_triangles<Graph> m_triangles; // of the surface
  const Surface_walk m_walk;
  State m_plain, m_fine; // without and with what makes it spline compatible
  Face_ancestors<Graph> m_ancestors;
  std::size_t m_in_rings = 0;
  std::optional<typename Fitter::Start> m_last; // the surface of the last level
  Fit_progress m_progress;
  Working m_best;
  std::optional<Measured_level> m_measured, m_measured_best; // the last level and the best one, if they were measured
  double m_area_to_mend = 0;                                 // on the mesh
  std::vector<Plan> m_plans;                                 // of the last level, the largest errors first
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
