// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H

#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Fitting_system.h>
#include <CGAL/T_splines/Spline/internal/Parameter_correction.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The box of the points of samples.
template <typename FT>
struct Sample_box {
  std::array<FT, 3> low, high;

  explicit Sample_box(const std::vector<Fitting_sample<FT>>& samples)
  {
    low.fill((std::numeric_limits<FT>::max)());
    high.fill(std::numeric_limits<FT>::lowest());
    for (const Fitting_sample<FT>& sample : samples)
      for (int k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], sample.point[k]);
        high[k] = (std::max)(high[k], sample.point[k]);
      }
  }

  FT extent() const { return (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  FT center(const int k) const { return low[k] / FT(2) + high[k] / FT(2); }
};

/// Fits the control points of one T-mesh to samples, and moves the samples.
///
/// Works relative to an origin near the samples, so that a model far from zero loses no digits.
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename Kernel>
class T_spline_fitter {
  using Control_points =
      typename boost::property_map<TMesh,
                                   CGAL::dynamic_vertex_property_t<typename Kernel::Weighted_point_3>>::const_type;

public:
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Surface = T_spline_surface<TMesh, HalfedgeKnotMap, HalfedgeCornerMap, Control_points, Kernel>;
  using Compiled = Compiled_T_spline<TMesh, Kernel>;
  using Sample = Fitting_sample<FT>;

  /// \param weights vertex -> positive number
  template <typename VertexWeightMap, typename NamedParameters>
  T_spline_fitter(const TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                  const VertexWeightMap weights, const NamedParameters& np)
    : m_control_points(with_weights(t_mesh, weights)),
      m_surface(t_mesh, knots, corners, m_control_points, np)
  {
  }
  T_spline_fitter(const T_spline_fitter&) = delete; // the property map is shared
  T_spline_fitter& operator=(const T_spline_fitter&) = delete;

  /// Its control points are relative to `origin()`.
  const Surface& surface() const { return m_surface; }
  const std::array<FT, 3>& origin() const { return m_origin; }
  const std::vector<FT>& squared_distances() const { return m_squared_distances; } ///< per sample, after the fit

  Point_3 control_point(const typename Surface::vertex_descriptor v) const
  {
    const auto& p = get(m_control_points, v).point();
    return Point_3(p.x() + m_origin[0], p.y() + m_origin[1], p.z() + m_origin[2]);
  }

  /// Fits; then moves the samples and fits again, up to `number_of_corrections` times, as long as the root mean square
  /// falls by at least a fiftieth. Members of the report that do not concern the surface are set.
  /// \param samples not empty; moved. Their points are relative to the origin afterwards
  template <typename SolverTraits, typename Visitor>
  void fit(std::vector<Sample>& samples, const FT& fairness, const int number_of_corrections, SolverTraits& solver,
           const Visitor& visitor, T_spline_fit_report<TMesh>& report)
  {
    const Sample_box<FT> box(samples);
    for (int k = 0; k < 3; ++k)
      m_origin[k] = box.center(k);
    for (Sample& sample : samples)
      for (int k = 0; k < 3; ++k)
        sample.point[k] -= m_origin[k];
    report.error.extent = CGAL::to_double(box.extent());
    report.number_of_control_points = m_surface.number_of_control_points();
    report.number_of_samples = samples.size();

    std::vector<FT> weights;
    for (const auto& p : m_surface.homogeneous_control_points())
      weights.push_back(p[3]);
    Fitting_system<FT> system(m_surface.basis(), weights);
    const FT lambda = fairness > FT(0) ? set_fairness(samples, fairness, system) : FT(0);
    system.set_samples(samples);
    std::vector<std::array<FT, 3>> points;
    if (!system.solve(lambda, solver, points)) {
      report.status = T_spline_fit_status::UNDERDETERMINED;
      return;
    }
    set_control_points(points);
    measure(samples, report);
    report.first_error = report.error;
    while (report.number_of_corrections < number_of_corrections && report.error.rms > 0) {
      visitor.progress(static_cast<double>(report.number_of_corrections) / number_of_corrections);
      if (!visitor.go_on()) {
        report.status = T_spline_fit_status::INTERRUPTED;
        return;
      }
      if (!correct(system, samples, lambda, solver, points, report))
        return;
    }
  }

private:
  template <typename VertexWeightMap>
  static Control_points with_weights(const TMesh& t_mesh, const VertexWeightMap weights)
  {
    Control_points result = get(CGAL::dynamic_vertex_property_t<typename Kernel::Weighted_point_3>(), t_mesh);
    for (const auto v : CGAL::make_range(vertices(t_mesh)))
      put(result, v, typename Kernel::Weighted_point_3(Point_3(FT(0), FT(0), FT(0)), FT(get(weights, v))));
    return result;
  }

  // Returns the factor of E_fair.
  FT set_fairness(const std::vector<Sample>& samples, const FT& fairness, Fitting_system<FT>& system) const
  {
    FT area(0), number(0);
    for (const Sample& sample : samples) {
      area += sample.weight;
      number += FT(sample.weight > FT(0));
    }
    const FT squared_spacing = area / number;
    // The stiffness of much smaller faces would only spoil the condition of the matrix.
    const FT smallest_area = squared_spacing / FT(256);
    std::vector<FT> areas = face_areas(m_surface.t_mesh_arrays(), samples);
    for (FT& a : areas)
      a = (std::max)(a, smallest_area);
    system.set_fairness(areas);
    return fairness * squared_spacing * squared_spacing;
  }

  void set_control_points(const std::vector<std::array<FT, 3>>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto v = m_surface.indexing().vertex(static_cast<int>(i));
      put(m_control_points, v,
          typename Kernel::Weighted_point_3(Point_3(points[i][0], points[i][1], points[i][2]),
                                            get(m_control_points, v).weight()));
    }
    m_surface.update_control_points();
  }

  // One round. Returns whether another one may help.
  template <typename SolverTraits>
  bool correct(Fitting_system<FT>& system, std::vector<Sample>& samples, const FT& lambda, SolverTraits& solver,
               std::vector<std::array<FT, 3>>& points, T_spline_fit_report<TMesh>& report)
  {
    const std::vector<Sample> old_samples = samples;
    const std::vector<FT> old_distances = m_squared_distances;
    const T_spline_fit_report<TMesh> old_report = report;
    const std::vector<std::array<FT, 3>> old_points = points;
    const Compiled compiled = compile_T_spline(m_surface);
    const Parameter_correction<Compiled> correction(compiled, m_surface.basis());
    for (Sample& sample : samples)
      correction(sample);
    system.set_samples(samples);
    const bool is_solved = system.solve_again(lambda, solver, points);
    if (is_solved) {
      set_control_points(points);
      measure(samples, report);
    }
    if (!is_solved || !(report.error.rms < old_report.error.rms)) {
      samples = old_samples;
      m_squared_distances = old_distances;
      report = old_report;
      set_control_points(old_points);
      return false;
    }
    ++report.number_of_corrections;
    return report.error.rms < 0.98 * old_report.error.rms;
  }

  void measure(const std::vector<Sample>& samples, T_spline_fit_report<TMesh>& report)
  {
    m_squared_distances.clear();
    FT sum(0), weight(0);
    for (const Sample& sample : samples) {
      const Point_3 p = m_surface.position(m_surface.indexing().face(sample.face), sample.u, sample.v);
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

  Control_points m_control_points;
  Surface m_surface;
  std::array<FT, 3> m_origin = {};
  std::vector<FT> m_squared_distances;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_FITTER_H
