// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H

#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Fit_progress.h>
#include <CGAL/T_splines/Spline/internal/Fold_state.h>
#include <CGAL/T_splines/Spline/internal/Measured_mesh.h>
#include <CGAL/T_splines/Spline/internal/Measured_surface.h>
#include <CGAL/T_splines/Spline/internal/Surface_fitter.h>
#include <CGAL/T_splines/Spline/internal/Surface_walk.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/grade_T_mesh.h>
#include <CGAL/T_splines/T_mesh/internal/Face_ancestors.h>
#include <CGAL/T_splines/T_mesh/internal/Split_position.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What an adaptive fit is asked for.
struct Adaptive_fit_options {
  double tolerance; ///< in the units of the points
  double fairness;
  std::size_t largest_number_of_control_points; ///< 0: as `default_limit()` says
  int number_of_corrections;                    ///< per level
};

/// As many control points as a surface may need that is worth having.
inline std::size_t default_limit(const std::size_t coarsest, const std::size_t number_of_points)
{
  constexpr std::size_t always_allowed = 5000;
  return (std::max)({always_allowed, 4 * coarsest, number_of_points / 2});
}

/// Fits, refines where the surface is too far from the mesh or folds, and fits again.
///
/// There are two T-meshes: a plain one, whose faces are split, and its copy that is made spline compatible anew for
/// each level. So the rings around extraordinary vertices are as wide as the faces of the level allow, and what they
/// needed in one level is no burden to the next.
///
/// Distances at samples tell where to refine. Only when they find nothing more, the distance is measured as users
/// would measure it; what exceeds the tolerance or folds then is refined as well.
template <typename Kernel, typename SolverTraits, typename Visitor>
class Adaptive_fit {
  using FT = typename Kernel::FT;
  using Working = T_mesh<typename Kernel::Point_3, FT>;
  using Graph = typename Working::Graph;
  using Face = typename Graph::Face_index;
  using Carried = Carried_surface<Graph>;
  using Fitter = Surface_fitter<Const_T_mesh_view_of<Working>, Kernel>;
  using Compiled = typename Fitter::Compiled;
  using Triangle_mesh = CGAL::Surface_mesh<typename Carried::Point_3>;
  using Status = Adaptive_fit_status;

public:
  /// \param t_mesh admissible
  /// \param surface in its faces
  Adaptive_fit(const Working& t_mesh, const Carried& surface, const Adaptive_fit_options& options, SolverTraits& solver,
               const Visitor& visitor)
    : m_options(options),
      m_solver(solver),
      m_visitor(visitor),
      m_points(surface.points()),
      m_triangles(surface.triangles()),
      m_walk(m_points, m_triangles),
      m_mesh(mesh_of(m_points, m_triangles)),
      m_plain{t_mesh, surface, std::vector<double>(t_mesh.graph().number_of_faces(), 1)}
  {
  }

  /// \tparam Given the graph that the report is about
  template <typename Given>
  void run(Adaptive_fit_report<Given>& report)
  {
    if (!make_compatible()) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      return;
    }
    const std::size_t coarsest = m_fine.t_mesh.graph().number_of_vertices();
    m_limit = m_options.largest_number_of_control_points;
    if (m_limit == 0)
      m_limit = default_limit(coarsest, m_points.size());
    if (coarsest > m_limit) {
      report.status = Status::LIMIT_TOO_LOW;
      report.levels.push_back({coarsest, m_fine.t_mesh.graph().number_of_faces(), m_in_rings, 0, 0, {}});
      return;
    }
    while (fit_level(report)) {
      if (m_progress.add(quality(report.levels.back()))) {
        report.best_level = report.levels.size() - 1;
        m_best = m_fine.t_mesh;
      }
      if (is_done(report))
        return;
    }
    // A level that cannot be fitted is no reason to give away those before.
    if (!report.levels.empty() && report.status != Status::INTERRUPTED)
      report.status = Status::NO_IMPROVEMENT;
  }

  /// The T-mesh of the best level, with its control points.
  const Working& best() const { return m_best; }

private:
  static Triangle_mesh mesh_of(const std::vector<typename Carried::Point_3>& points,
                               const std::vector<typename Carried::Triangle>& triangles)
  {
    Triangle_mesh mesh;
    for (const auto& p : points)
      mesh.add_vertex(p);
    for (const auto& t : triangles) {
      const auto vertex = [&](const int i) {
        return typename Triangle_mesh::Vertex_index(static_cast<unsigned>(t[i]));
      };
      mesh.add_face(vertex(0), vertex(1), vertex(2));
    }
    return mesh;
  }

  struct State {
    Working t_mesh;
    Carried surface;
    std::vector<double> stiffness; // of the faces, by index
  };

  // A face of the plain T-mesh that is to be split.
  struct Plan {
    Face face;
    double error;    // the largest one in the face, by the tolerance
    int longer_axis; // of the face: 0 for u, 1 for v
  };

  Fit_quality quality(const T_spline_fit_level& level) const
  {
    return {level.number_of_control_points,        level.error.maximum / m_options.tolerance,
            level.error.rms / m_options.tolerance, level.number_of_folded_faces,
            level.number_of_doubtful_faces,        m_area_to_mend};
  }

  // Refines, or says why not.
  template <typename Given>
  bool is_done(Adaptive_fit_report<Given>& report)
  {
    if (m_progress.best().is_within_tolerance())
      report.status = Status::WITHIN_TOLERANCE;
    else if (m_progress.has_stalled())
      report.status = Status::NO_IMPROVEMENT;
    else if (m_plans.empty())
      report.status = Status::RESOLUTION_REACHED;
    else if (!m_visitor.go_on())
      report.status = Status::INTERRUPTED;
    else if (refine())
      return false;
    else
      report.status = Status::CONTROL_POINT_LIMIT;
    return true;
  }

  // Makes the copy.
  bool make_compatible()
  {
    m_fine = m_plain;
    m_ancestors = Face_ancestors<Graph>();
    const T_mesh_visitor_pair visitor(m_fine.surface.visitor(), m_ancestors.visitor());
    const auto report = CGAL::T_splines::make_spline_compatible(m_fine.t_mesh, CGAL::parameters::visitor(visitor));
    m_in_rings = report.vertices_in_rings;
    m_fine.stiffness = inherited(m_plain.stiffness, m_ancestors, m_fine.t_mesh.graph());
    return report.success();
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

  template <typename Given>
  bool fit_level(Adaptive_fit_report<Given>& report)
  {
    constexpr double almost = 2;
    Working& t = m_fine.t_mesh;
    Fitter fitter(t, m_fine.surface, m_walk, m_fine.stiffness);
    if (!fitter.fitted().surface().is_valid()) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      return false;
    }
    T_spline_fit_report<Graph> fit;
    if (!fitter.fit(start(report), m_options.tolerance, m_options.fairness, m_options.number_of_corrections, m_solver,
                    m_visitor, fit)) {
      report.fit.status = fit.status;
      report.status = fit.status == T_spline_fit_status::INTERRUPTED  ? Status::INTERRUPTED
                      : fit.status == T_spline_fit_status::NO_SAMPLES ? Status::NO_SURFACE
                                                                      : Status::FIT_FAILED;
      return false;
    }
    for (const auto v : t.graph().vertices())
      t.graph().point(v) = fitter.fitted().control_point(v);
    std::vector<Face_fit> faces = fitter.faces();
    m_last.emplace(compile_T_spline(fitter.fitted().surface()), m_fine.surface);
    if (are_within(faces))
      measure(faces, fit.error);
    if (fit.error.maximum <= almost * m_options.tolerance)
      stiffen(faces);
    const auto number_of = [&](const Fold_state fold) {
      return static_cast<std::size_t>(
          std::count_if(faces.begin(), faces.end(), [&](const Face_fit& face) { return face.fold == fold; }));
    };
    report.number_of_samples = fit.number_of_samples;
    report.levels.push_back({t.graph().number_of_vertices(), t.graph().number_of_faces(), m_in_rings,
                             number_of(Fold_state::FOLDED), number_of(Fold_state::DOUBTFUL), fit.error});
    m_visitor.level_fitted(report.levels.back(), t);
    plan(faces);
    return true;
  }

  // The surface of the last level, if it is near enough to begin with.
  template <typename Given>
  const typename Fitter::Start* start(const Adaptive_fit_report<Given>& report) const
  {
    constexpr double near = 3; // by the tolerance
    return m_last && report.levels.back().error.maximum <= near * m_options.tolerance ? &*m_last : nullptr;
  }

  bool are_within(const std::vector<Face_fit>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(), [&](const Face_fit& face) {
      return face.distance <= m_options.tolerance && face.fold != Fold_state::FOLDED;
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
  void measure(std::vector<Face_fit>& faces, T_spline_fit_error& error)
  {
    if (!m_measured_mesh) {
      Triangle_set set;
      m_reading = read_triangle_set(m_mesh, m_mesh.points(), set);
      m_measured_mesh.emplace(std::move(set));
    }
    if (m_reading.status != T_spline_deviation_status::MEASURED)
      return;
    Measured_surface<Compiled> measured(m_last->compiled());
    if (!measured.is_finite())
      return;
    T_spline_deviation_report<Graph, Triangle_mesh> report;
    report.tolerance = m_options.tolerance;
    Deviation_measurement<Compiled, Triangle_mesh> measurement(*m_measured_mesh, m_reading, measured, report);
    measurement.measure_surface();
    measurement.measure_mesh();
    error.maximum = report.maximum();
    error.rms = (std::max)(report.mesh_to_surface.rms, report.surface_to_mesh.rms);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      faces[i].distance = (std::max)(faces[i].distance, measurement.face_deviation(i));
      faces[i].fold = (std::max)(faces[i].fold, measurement.face_state(i));
    }
    if (report.is_within_tolerance() && !report.has_folds())
      find_self_intersections(faces);
  }

  void find_self_intersections(std::vector<Face_fit>& faces)
  {
    constexpr int resolution = 8;
    const auto of_mesh = [&]() -> const Mesh_intersections& {
      if (!m_mesh_intersections)
        m_mesh_intersections.emplace(m_mesh, m_mesh.points());
      return *m_mesh_intersections;
    };
    std::vector<Face> found;
    find_new_self_intersections(m_last->compiled(), resolution, of_mesh, m_options.tolerance,
                                std::back_inserter(found));
    for (const Face f : found)
      faces[f].fold = Fold_state::FOLDED;
  }

  // What is to be split: the faces of the plain T-mesh under the faces of the copy that are not as they should be,
  // those with the largest errors first. Those that are much smaller than the tolerance are left alone.
  void plan(const std::vector<Face_fit>& faces)
  {
    constexpr double error_of_fold = 1.5, smallest_size = 0.1; // by the tolerance
    std::vector<double> errors(m_plain.t_mesh.graph().number_of_faces(), 0), areas(errors.size(), 0);
    m_area_to_mend = 0;
    for (const Face f : m_fine.t_mesh.graph().faces()) {
      const Face_fit& face = faces[f];
      const double error =
          (std::max)(face.distance / m_options.tolerance, face.fold == Fold_state::FOLDED ? error_of_fold : 0.);
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
      if (errors[f] > 1 && longer_side > smallest_size * m_options.tolerance)
        m_plans.push_back({f, errors[f], width >= height ? 0 : 1});
    }
    std::stable_sort(m_plans.begin(), m_plans.end(), [](const Plan& a, const Plan& b) { return a.error > b.error; });
  }

  // Splits a face into two across its longer side, or into four.
  template <typename Editor, typename Position>
  void split(const Plan& plan, const bool is_in_four, Editor& editor, const Position& position)
  {
    const Graph& graph = m_plain.t_mesh.graph();
    const auto edit = editor.split_face(plan.face, plan.longer_axis, position(plan.face, plan.longer_axis));
    if (!is_in_four)
      return;
    const Face other = graph.face(graph.opposite(edit.halfedge)), one = graph.face(edit.halfedge);
    for (const Face f : {one, other})
      editor.split_face(f, 1 - plan.longer_axis, position(f, 1 - plan.longer_axis));
  }

  // Neighbours of very different size share basis functions that suit neither.
  static constexpr double largest_ratio_of_neighbours = 6;

  // Returns whether the refined T-mesh has no more control points than allowed; if it had, fewer faces are split, those
  // with the largest errors.
  bool refine()
  {
    const std::size_t before = m_fine.t_mesh.graph().number_of_vertices();
    // By the tolerance; and if few faces are left, what more control points cost is less than what more levels do.
    constexpr double large_error = 2, few = 0.03;
    const bool are_few =
        static_cast<double>(m_plans.size()) < few * static_cast<double>(m_fine.t_mesh.graph().number_of_faces());
    const State plain = m_plain;
    std::size_t number = m_plans.size();
    while (number > 0) {
      Working& t = m_plain.t_mesh;
      Face_ancestors<Graph> ancestors;
      const T_mesh_visitor_pair visitor(m_plain.surface.visitor(), ancestors.visitor());
      T_mesh_editor editor(t, visitor);
      const Split_position position(t);
      for (std::size_t i = 0; i < number; ++i)
        split(m_plans[i], are_few || m_plans[i].error > large_error, editor, position);
      grade_T_mesh(t, largest_ratio_of_neighbours, CGAL::parameters::visitor(visitor));
      m_plain.stiffness = inherited(plain.stiffness, ancestors, t.graph());
      const bool is_compatible = make_compatible();
      const std::size_t after = m_fine.t_mesh.graph().number_of_vertices();
      if (is_compatible && after <= m_limit)
        return true;
      m_plain = plain;
      const double fraction = after > before && m_limit > before
                                  ? static_cast<double>(m_limit - before) / static_cast<double>(after - before)
                                  : 0;
      number = static_cast<std::size_t>(static_cast<double>(number) * (std::min)(0.9 * fraction, 0.5 + 0.4 * fraction));
    }
    return false;
  }

  const Adaptive_fit_options& m_options;
  SolverTraits& m_solver;
  const Visitor& m_visitor;
  const std::vector<typename Carried::Point_3> m_points; // of the surface
  const std::vector<typename Carried::Triangle> m_triangles;
  const Surface_walk m_walk;
  const Triangle_mesh m_mesh;
  Triangle_reading<Triangle_mesh> m_reading;
  std::optional<Measured_mesh> m_measured_mesh;
  std::optional<Mesh_intersections> m_mesh_intersections;
  State m_plain, m_fine; // without and with what makes it spline compatible
  Face_ancestors<Graph> m_ancestors;
  std::size_t m_in_rings = 0;
  std::optional<typename Fitter::Start> m_last; // the surface of the last level
  Fit_progress m_progress;
  Working m_best;
  std::size_t m_limit = 0;   // of the number of control points
  double m_area_to_mend = 0; // on the mesh
  std::vector<Plan> m_plans; // of the last level, the largest errors first
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
