// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H

#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/internal/Error_driven_splits.h>
#include <CGAL/T_splines/Spline/internal/T_spline_fitter.h>
#include <CGAL/T_splines/Spline/internal/Working_t_mesh.h>
#include <CGAL/T_splines/T_mesh/Carried_points.h>
#include <CGAL/T_splines/T_mesh/grade_T_mesh.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What an adaptive fit is asked for.
struct Adaptive_fit_options {
  double tolerance; ///< in the units of the points
  double fairness;
  std::size_t largest_number_of_control_points;
  bool is_limit_strict;      ///< or the coarsest T-mesh may have more
  int number_of_corrections; ///< per level
};

/// Fits, refines where the error is too large, and fits again.
///
/// A refinement that needs too many control points is taken back and tried with fewer faces, those with the largest
/// errors.
template <typename Kernel, typename SolverTraits, typename Visitor>
class Adaptive_fit {
  using FT = typename Kernel::FT;
  using Working = Working_t_mesh<Kernel>;
  using Mesh = typename Working::Mesh;
  using Face = typename Mesh::Face_index;
  using Carried = Carried_points<Mesh, FT, std::size_t>;
  using Fitter = T_spline_fitter<Mesh, typename Working::Knot_map, typename Working::Corner_map, Kernel>;
  using Sample = Fitting_sample<FT>;
  using Plan = Planned_split<Mesh>;
  using Status = Adaptive_fit_status;

public:
  /// \param t_mesh admissible; its faces have the indices of the samples' places
  Adaptive_fit(const Working& t_mesh, const std::vector<Sample>& samples, const Adaptive_fit_options& options,
               SolverTraits& solver, const Visitor& visitor)
    : m_options(options),
      m_solver(solver),
      m_visitor(visitor)
  {
    m_state.t_mesh = t_mesh;
    m_state.samples = samples;
  }

  /// \tparam TMesh what the report is about
  template <typename TMesh>
  void run(Adaptive_fit_report<TMesh>& report)
  {
    if (!start()) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      return;
    }
    const std::size_t control_points = m_state.t_mesh.mesh.number_of_vertices();
    if (control_points > m_options.largest_number_of_control_points && m_options.is_limit_strict) {
      report.status = Status::LIMIT_TOO_LOW;
      report.levels.push_back({control_points, m_state.t_mesh.mesh.number_of_faces(), m_state.in_rings, {}});
      return;
    }
    int without_improvement = 0;
    while (true) {
      if (!fit_level(report))
        return;
      const T_spline_fit_error& error = report.levels.back().error;
      const std::size_t last = report.levels.size() - 1;
      const T_spline_fit_error& best = report.levels[report.best_level].error;
      const bool improves = last == 0 || error.maximum < 0.99 * best.maximum || error.rms < 0.99 * best.rms;
      without_improvement = improves ? 0 : without_improvement + 1;
      if (last == 0 || error.maximum < best.maximum || (improves && error.maximum < 1.02 * best.maximum)) {
        report.best_level = last;
        m_best = m_state.t_mesh;
      }
      if (error.maximum <= m_options.tolerance)
        report.status = Status::WITHIN_TOLERANCE;
      else if (without_improvement == 3)
        report.status = Status::NO_IMPROVEMENT;
      else if (m_plans.empty())
        report.status = Status::SAMPLES_EXHAUSTED;
      else if (!m_visitor.go_on())
        report.status = Status::INTERRUPTED;
      else if (refine())
        continue;
      else
        report.status = Status::CONTROL_POINT_LIMIT;
      return;
    }
  }

  /// The T-mesh of the best level, with its control points.
  const Working& best() const { return m_best; }

private:
  struct State {
    Working t_mesh;
    std::vector<Sample> samples; ///< places in the faces of the T-mesh, by index
    std::size_t in_rings = 0;
  };

  // The samples' places go along.
  template <typename Operation>
  static void with_carried_samples(State& state, const Operation& operation)
  {
    Carried carried;
    for (std::size_t i = 0; i < state.samples.size(); ++i) {
      const Sample& sample = state.samples[i];
      carried.add(Face(static_cast<typename Mesh::size_type>(sample.face)), sample.u, sample.v, i);
    }
    operation(carried.visitor());
    for (const Face f : state.t_mesh.mesh.faces())
      for (const auto& point : carried.points(f)) {
        Sample& sample = state.samples[point.payload];
        sample.face = static_cast<int>(static_cast<std::size_t>(f));
        sample.u = point.u;
        sample.v = point.v;
      }
  }

  // Makes the T-mesh spline compatible, and graded as far as the number of control points allows.
  bool start()
  {
    constexpr double no_grading = 100;
    const State given = m_state;
    bool success = make_compatible(m_state);
    while (success && m_state.t_mesh.mesh.number_of_vertices() > m_options.largest_number_of_control_points &&
           m_largest_ratio < no_grading) {
      m_state = given;
      m_largest_ratio *= 2;
      success = make_compatible(m_state);
    }
    return success;
  }

  bool make_compatible(State& state) const
  {
    Working& t = state.t_mesh;
    bool success = false;
    with_carried_samples(state, [&](const typename Carried::Visitor& visitor) {
      const auto np = CGAL::parameters::visitor(visitor);
      auto report = CGAL::T_splines::make_spline_compatible(t.mesh, t.knots, t.corners, np);
      if (report.success() && grade_T_mesh(t.mesh, t.knots, t.corners, m_largest_ratio, np) > 0)
        report = CGAL::T_splines::make_spline_compatible(t.mesh, t.knots, t.corners, np);
      success = report.success();
      state.in_rings = report.vertices_in_rings;
    });
    return success;
  }

  template <typename TMesh>
  bool fit_level(Adaptive_fit_report<TMesh>& report)
  {
    const Working& t = m_state.t_mesh;
    const CGAL::Constant_property_map<typename Mesh::Vertex_index, FT> weights(FT(1));
    Fitter fitter(t.mesh, t.knots, t.corners, weights, CGAL::parameters::default_values());
    T_spline_fit_report<Mesh> fit;
    if (!fitter.surface().is_valid()) {
      report.status = Status::NOT_SPLINE_COMPATIBLE;
      return false;
    }
    clamp_samples(fitter.surface());
    fitter.fit(m_state.samples, FT(m_options.fairness), m_options.number_of_corrections, m_solver, m_visitor, fit);
    for (Sample& sample : m_state.samples)
      for (int k = 0; k < 3; ++k)
        sample.point[k] += fitter.origin()[k];
    report.fit.status = fit.status;
    if (!fit.success()) {
      report.status = fit.status == T_spline_fit_status::INTERRUPTED ? Status::INTERRUPTED : Status::FIT_FAILED;
      return false;
    }
    for (const auto v : t.mesh.vertices())
      m_state.t_mesh.mesh.point(v) = fitter.control_point(v);
    report.levels.push_back({t.mesh.number_of_vertices(), t.mesh.number_of_faces(), m_state.in_rings, fit.error});
    m_visitor.level_fitted(report.levels.back(), t.mesh, t.knots, t.corners, t.mesh.points());
    plan(fitter);
    return true;
  }

  // Round-off may have led a little out of the faces.
  template <typename Surface>
  void clamp_samples(const Surface& surface)
  {
    const auto& t_mesh = surface.t_mesh_arrays();
    for (Sample& sample : m_state.samples) {
      sample.u = (std::clamp)(sample.u, FT(0), t_mesh.width(sample.face));
      sample.v = (std::clamp)(sample.v, FT(0), t_mesh.height(sample.face));
    }
  }

  // A face with fewer samples is not split: nothing would tell whether this helps.
  static constexpr std::size_t fewest_samples = 4;

  void plan(const Fitter& fitter)
  {
    const std::size_t n = m_state.t_mesh.mesh.number_of_faces();
    std::vector<double> error(n, 0); // by the tolerance
    std::vector<std::size_t> number(n, 0);
    for (std::size_t i = 0; i < m_state.samples.size(); ++i) {
      const int f = m_state.samples[i].face;
      error[f] = (std::max)(error[f], std::sqrt(CGAL::to_double(fitter.squared_distances()[i])) / m_options.tolerance);
      ++number[f];
    }
    std::vector<double> error_to_mend = error;
    for (std::size_t i = 0; i < n; ++i)
      if (error[i] > 1 && number[i] < fewest_samples)
        blame_surroundings(fitter.surface().t_mesh_arrays(), static_cast<int>(i), number, error[i], error_to_mend);
    m_plans.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const Face f(static_cast<typename Mesh::size_type>(i));
      if (error_to_mend[i] > 1 && number[i] >= fewest_samples)
        m_plans.push_back({f, error_to_mend[i], error_to_mend[i] > 2, longer_axis(fitter.surface(), f)});
    }
    std::stable_sort(m_plans.begin(), m_plans.end(), [](const Plan& a, const Plan& b) { return a.error > b.error; });
  }

  // An error in a small face, such as in the rings of an extraordinary vertex, that is surrounded by faces too large to
  // follow: those are to be refined.
  static void blame_surroundings(const T_mesh_arrays<FT>& t_mesh, const int face,
                                 const std::vector<std::size_t>& number, const double error,
                                 std::vector<double>& error_to_mend)
  {
    std::vector<int> queue{face};
    std::set<int> reached{face};
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int first = t_mesh.first_of_side(queue[i], 0);
      int h = first;
      do {
        const int g = t_mesh.face(T_mesh_arrays<FT>::opposite(h));
        if (g >= 0 && reached.insert(g).second) {
          if (number[g] < fewest_samples)
            queue.push_back(g);
          else
            error_to_mend[g] = (std::max)(error_to_mend[g], error);
        }
        h = t_mesh.next(h);
      } while (h != first);
    }
  }

  static int longer_axis(const typename Fitter::Surface& surface, const Face f)
  {
    constexpr int n = 4;
    const FT width = surface.width(f), height = surface.height(f);
    std::array<double, 2> length{0, 0};
    for (int i = 0; i < n; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        const auto point = [&](const int k) {
          const FT x = FT(k) / FT(n), half = FT(1) / FT(2);
          return axis == 0 ? surface.position(f, width * x, height * half)
                           : surface.position(f, width * half, height * x);
        };
        length[axis] += std::sqrt(CGAL::to_double(CGAL::squared_distance(point(i), point(i + 1))));
      }
    return length[0] >= length[1] ? 0 : 1;
  }

  // Returns whether the refined T-mesh has no more control points than allowed; if not, it is as before.
  bool refine()
  {
    const std::size_t before = m_state.t_mesh.mesh.number_of_vertices(),
                      limit = (std::max)(m_options.largest_number_of_control_points, before);
    std::size_t number = m_plans.size();
    while (number > 0) {
      State trial = m_state;
      with_carried_samples(trial, [&](const typename Carried::Visitor& visitor) {
        Error_driven_splits<Mesh, typename Working::Knot_map, typename Working::Corner_map, typename Carried::Visitor>(
            trial.t_mesh.mesh, trial.t_mesh.knots, trial.t_mesh.corners, visitor)
            .run({m_plans.begin(), m_plans.begin() + static_cast<std::ptrdiff_t>(number)});
      });
      const bool is_compatible = make_compatible(trial);
      const std::size_t after = trial.t_mesh.mesh.number_of_vertices();
      if (is_compatible && after <= limit) {
        m_state = std::move(trial);
        return true;
      }
      const double fraction = static_cast<double>(limit - before) / static_cast<double>(after - before);
      number = static_cast<std::size_t>(static_cast<double>(number) * (std::min)(0.9 * fraction, 0.5 + 0.4 * fraction));
    }
    return false;
  }

  const Adaptive_fit_options& m_options;
  SolverTraits& m_solver;
  const Visitor& m_visitor;
  State m_state;
  Working m_best;
  std::vector<Plan> m_plans;  // of the last level, the largest errors first
  double m_largest_ratio = 6; // of the sizes of neighbouring faces: rings may be much smaller than what surrounds them
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_ADAPTIVE_FIT_H
