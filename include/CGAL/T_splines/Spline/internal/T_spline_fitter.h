// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H

#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Fitted_surface.h>
#include <CGAL/T_splines/Spline/internal/Fitting_system.h>
#include <CGAL/T_splines/Spline/internal/Parameter_correction.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Fits the control points of one T-mesh to samples, and moves the samples.
/// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename TMesh, typename Kernel>
class T_spline_fitter {
  using Graph = typename TMesh::Graph;
  using Fitted = Fitted_surface<TMesh, Kernel>;

public:
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Surface = typename Fitted::Surface;
  using Compiled = Compiled_T_spline<Graph, Kernel>;
  using Sample = Fitting_sample<FT>;

  /// \param weights vertex -> positive number
  /// \param progress it must outlive this; if it is interrupted before the fit, the surface is not valid
  template <typename VertexWeightMap, typename NamedParameters>
  T_spline_fitter(const TMesh& t_mesh, const VertexWeightMap weights, const NamedParameters& np, Progress& progress)
    : m_fitted(t_mesh, weights, np.visitor(Part_visitor(progress))),
      m_progress(progress)
  {
  }

  const Fitted& fitted() const { return m_fitted; }

  /// Fits; then moves the samples and fits again, up to `number_of_corrections` times, as long as the root mean square
  /// falls by at least a fiftieth. Members of the report that do not concern the surface are set.
  /// \param samples not empty; moved. Their points are relative to the origin afterwards
  template <typename SolverTraits>
  void fit(std::vector<Sample>& samples, const FT& fairness, const int number_of_corrections, SolverTraits& solver,
           T_spline_fit_report<Graph>& report)
  {
    fit_and_move(samples, fairness, number_of_corrections, solver, report);
    if (m_progress.is_interrupted())
      report.status = T_spline_fit_status::INTERRUPTED;
  }

private:
  template <typename SolverTraits>
  void fit_and_move(std::vector<Sample>& samples, const FT& fairness, const int number_of_corrections,
                    SolverTraits& solver, T_spline_fit_report<Graph>& report)
  {
    Axis_parallel_box<FT> box;
    for (const Sample& sample : samples)
      box.extend(sample.point);
    m_fitted.set_origin({box.middle(0), box.middle(1), box.middle(2)});
    for (Sample& sample : samples)
      for (int k = 0; k < 3; ++k)
        sample.point[k] -= m_fitted.origin()[k];
    report.error.extent = CGAL::to_double(box.extent());
    report.number_of_control_points = m_fitted.surface().number_of_control_points();
    report.number_of_samples = samples.size();

    const std::vector<FT> weights = m_fitted.weights();
    Fitting_system<FT> system(m_fitted.surface().basis(), weights, m_progress);
    if (fairness > FT(0))
      set_fairness(samples, fairness, system);
    system.set_samples(samples);
    std::vector<std::array<FT, 3>> points;
    if (!system.solve(solver, points)) {
      report.status = T_spline_fit_status::UNDERDETERMINED;
      return;
    }
    m_fitted.set_control_points(points);
    measure(samples, report);
    report.first_error = report.error;
    while (report.number_of_corrections < number_of_corrections && report.error.rms > 0) {
      m_progress.progress(static_cast<double>(report.number_of_corrections) / number_of_corrections);
      if (!m_progress.go_on())
        return;
      if (!correct(system, samples, solver, points, report))
        return;
    }
  }

  void set_fairness(const std::vector<Sample>& samples, const FT& fairness, Fitting_system<FT>& system) const
  {
    FT area(0), number(0);
    for (const Sample& sample : samples) {
      area += sample.weight;
      number += FT(sample.weight > FT(0));
    }
    const FT squared_spacing = area / number;
    // The stiffness of much smaller faces would only spoil the condition of the matrix.
    const FT smallest_area = squared_spacing / FT(256);
    std::vector<FT> areas = face_areas(m_fitted.surface().t_mesh_arrays(), samples);
    for (FT& a : areas)
      a = (std::max)(a, smallest_area);
    system.set_fairness(areas, std::vector<FT>(areas.size(), fairness * squared_spacing * squared_spacing));
  }

  // One round. Returns whether another one may help.
  template <typename SolverTraits>
  bool correct(Fitting_system<FT>& system, std::vector<Sample>& samples, SolverTraits& solver,
               std::vector<std::array<FT, 3>>& points, T_spline_fit_report<Graph>& report)
  {
    const std::vector<Sample> old_samples = samples;
    const std::vector<FT> old_distances = m_squared_distances;
    const T_spline_fit_report<Graph> old_report = report;
    const std::vector<std::array<FT, 3>> old_points = points;
    const Compiled compiled = compile_T_spline(m_fitted.surface(), CGAL::parameters::visitor(Part_visitor(m_progress)));
    if (compiled.status() == T_spline_compilation_status::INTERRUPTED)
      return false;
    const Parameter_correction<Compiled> correction(compiled, m_fitted.surface().basis());
    for (Sample& sample : samples) {
      if (!m_progress.go_on_after(50))
        return false;
      correction(sample);
    }
    system.set_samples(samples);
    const bool is_solved = system.solve_again(solver, points);
    if (is_solved) {
      m_fitted.set_control_points(points);
      measure(samples, report);
    }
    if (!is_solved || !(report.error.rms < old_report.error.rms)) {
      samples = old_samples;
      m_squared_distances = old_distances;
      report = old_report;
      m_fitted.set_control_points(old_points);
      return false;
    }
    ++report.number_of_corrections;
    constexpr double enough = 0.98; // otherwise another correction is not worth a solve
    return report.error.rms < enough * old_report.error.rms;
  }

  void measure(const std::vector<Sample>& samples, T_spline_fit_report<Graph>& report)
  {
    const Surface& surface = m_fitted.surface();
    m_squared_distances.clear();
    FT sum(0), weight(0);
    for (const Sample& sample : samples) {
      m_progress.go_on_after(10);
      const Point_3 p = surface.position(surface.indexing().face(sample.face), sample.u, sample.v);
      m_squared_distances.push_back(
          CGAL::squared_distance(p, Point_3(sample.point[0], sample.point[1], sample.point[2])));
      sum += sample.weight * m_squared_distances.back();
      weight += sample.weight;
    }
    const auto worst = std::max_element(m_squared_distances.begin(), m_squared_distances.end());
    report.sample = static_cast<std::size_t>(worst - m_squared_distances.begin());
    report.error.maximum = std::sqrt(*worst);
    report.error.rms = std::sqrt(sum / weight);
  }

  Fitted m_fitted;
  Progress& m_progress;
  std::vector<FT> m_squared_distances;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H
