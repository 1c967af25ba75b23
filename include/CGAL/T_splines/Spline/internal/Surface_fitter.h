// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_FITTER_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_FITTER_H

#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Anderson_acceleration.h>
#include <CGAL/T_splines/Spline/internal/Border_curve.h>
#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Carried_spline.h>
#include <CGAL/T_splines/Spline/internal/Fitted_surface.h>
#include <CGAL/T_splines/Spline/internal/Fitting_system.h>
#include <CGAL/T_splines/Spline/internal/Fold_state.h>
#include <CGAL/T_splines/Spline/internal/Parameter_correction.h>
#include <CGAL/T_splines/Spline/internal/Segment_tree.h>
#include <CGAL/T_splines/Spline/internal/Surface_sampling.h>
#include <CGAL/T_splines/Spline/internal/Surface_walk.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/converted_number.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How a face of a fitted surface lies to the mesh.
struct Face_fit {
  double distance = 0;                ///< the largest one of its samples, either way
  double area = 0;                    ///< of the mesh under it
  Fold_state fold = Fold_state::NONE; ///< of its samples
};

/// Fits the control points of one T-mesh to the surface that it carries.
///
/// In each Bezier cell a grid of places is fixed; so are the matrix and its factorization. What moves are the points of
/// the mesh that they aim at: at first those under the places, then, as long as this helps, the points of the mesh that
/// are closest to the surface there, not farther away on the mesh than a cell. So every cell is determined however few
/// vertices the mesh has there, and the parametrization of the surface need not be that of the map, which is skewed at
/// sharp edges, but cannot leave it by much and fold.
/// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename TMesh, typename Kernel>
class Surface_fitter {
  using Graph = typename TMesh::Graph;
  using Fitted = Fitted_surface<TMesh, Kernel>;
  using Carried = Carried_surface<Graph>;
  using Point_3 = Surface_walk::Point_3;
  using Vector_3 = Surface_walk::Vector_3;

public:
  using FT = typename Kernel::FT;
  using Surface = typename Fitted::Surface;
  using Compiled = Compiled_T_spline<Graph, Kernel>;
  using Start = Carried_spline<Compiled, Carried>;
  using Sample = Fitting_sample<FT>;

  /// \param carried, walk must outlive this; the walk is over the triangles of the carried surface, cut along creases
  /// \param stiffness of the faces, by index: by what factor the fairness is larger in them
  /// \param progress it must outlive this; if it is interrupted before the fit, the surface is not valid
  Surface_fitter(const TMesh& t_mesh, const Carried& carried, const Surface_walk& walk, std::vector<double> stiffness,
                 Progress& progress)
    : m_fitted(t_mesh, CGAL::Constant_property_map<typename Surface::vertex_descriptor, FT>(FT(1)),
               CGAL::parameters::visitor(Part_visitor(progress))),
      m_carried(carried),
      m_walk(walk),
      m_progress(progress),
      m_stiffness(std::move(stiffness))
  {
  }

  const Fitted& fitted() const { return m_fitted; }
  const std::vector<Face_fit>& faces() const { return m_faces; } ///< after the fit

  /// Fits.
  /// \param number_of_corrections how often the points aimed at are moved, at most
  /// \param start a surface that is already near: the points that are aimed at first are those closest to it; or null
  /// \return false if the solver fails, or the visitor stops the work: then the report says so
  template <typename SolverTraits>
  bool fit(const Start* start, const double tolerance, const double fairness, const int number_of_corrections,
           SolverTraits& solver, T_spline_fit_report<Graph>& report)
  {
    const bool is_fitted = fit_and_measure(start, tolerance, fairness, number_of_corrections, solver, report);
    if (m_progress.is_interrupted())
      report.status = T_spline_fit_status::INTERRUPTED;
    return is_fitted && !m_progress.is_interrupted();
  }

private:
  template <typename SolverTraits>
  bool fit_and_measure(const Start* start, const double tolerance, const double fairness,
                       const int number_of_corrections, SolverTraits& solver, T_spline_fit_report<Graph>& report)
  {
    take_samples();
    if (!m_progress.go_on())
      return false;
    if (!has_samples()) {
      report.status = T_spline_fit_status::NO_SAMPLES;
      return false;
    }
    const std::vector<FT> weights = m_fitted.weights();
    Fitting_system<FT> system(m_fitted.surface().basis(), weights, m_progress);
    std::vector<Sample> aims = fitting_samples();
    if (start != nullptr)
      aim_from(*start, aims);
    system.set_samples(aims);
    report.number_of_control_points = weights.size();
    report.number_of_samples = aims.size();
    if (fairness > 0)
      set_fairness(fairness, system);
    // A surface that begins near needs fewer.
    const int most = start == nullptr ? number_of_corrections : (number_of_corrections + 3) / 4;
    if (!m_progress.go_on() || !iterate(most, system, aims, solver, report) || !m_progress.go_on())
      return false;
    report.status = T_spline_fit_status::FITTED;
    m_fitted.set_control_points(m_control_points);
    measure(tolerance, report);
    m_fitted.move_back();
    return true;
  }

  void take_samples()
  {
    constexpr int fewest_per_cell = 3;     // in each direction
    constexpr double smallest_turn = 0.35; // in radians, of the normal at an edge: less does not show in a cell
    constexpr double edge_points_per_cell = 2;
    const Surface& surface = m_fitted.surface();
    Surface_sampling<Graph, FT> sampling(surface.basis(), surface.indexing(), m_carried, m_walk, m_progress);
    m_cells = sampling.cells(fewest_per_cell);
    const auto end_of_data = std::stable_partition(
        m_cells.begin(), m_cells.end(), [&](const Sampled_place& s) { return m_carried.is_data(s.triangle); });
    m_bare_cells.assign(end_of_data, m_cells.end());
    m_cells.erase(end_of_data, m_cells.end());
    m_edges = sampling.sharp_edges(smallest_turn, edge_points_per_cell);
    m_border = sampling.border(fewest_per_cell);
    m_border_corners = sampling.border_corners();
    m_is_border_corner.assign(m_walk.points().size(), 0);
    for (const auto& corner : m_border_corners)
      m_is_border_corner[corner.point] = 1;
    m_corners = sampling.corners();
    for (std::size_t i = 0; i < m_walk.triangles().size(); ++i)
      if (m_carried.is_data(i))
        for (const std::size_t p : m_walk.triangles()[i])
          m_box.extend(m_walk.points()[p]);
    m_fitted.set_origin({FT(m_box.middle(0)), FT(m_box.middle(1)), FT(m_box.middle(2))});
    double area = 0;
    m_triangles.clear();
    for (const Sampled_place& sample : m_cells) {
      m_triangles.push_back(sample.triangle);
      area += sample.area;
    }
    m_mean_area = area / static_cast<double>(m_cells.size());
    m_border_feet.clear();
    for (const Sampled_place& s : m_border)
      m_border_feet.push_back({s.triangle, s.point, 0, s.side, false});
  }

  void aim_from(const Start& start, std::vector<Sample>& aims)
  {
    m_points.clear();
    const auto add = [&](const Sampled_place& s) {
      if (m_progress.go_on_after(10))
        m_points.push_back(relative(start.position(s.triangle, s.barycentric[0], s.barycentric[1])));
    };
    std::for_each(m_cells.begin(), m_cells.end(), add);
    for (const Sampled_place& s : m_edges)
      m_points.push_back(relative(s.point)); // these aim where they are
    std::for_each(m_border.begin(), m_border.end(), add);
    if (!m_progress.is_interrupted())
      move_aims(aims);
  }

  // In every face: otherwise the surface does not cover the T-mesh. And there must be some that are data.
  bool has_samples() const
  {
    std::vector<char> has_sample(m_fitted.surface().t_mesh_arrays().number_of_faces(), 0);
    for (const std::vector<Sampled_place>* const samples : {&m_cells, &m_bare_cells})
      for (const Sampled_place& sample : *samples)
        has_sample[sample.face] = sample.area > 0 || has_sample[sample.face] != 0;
    return !m_cells.empty() &&
           std::all_of(has_sample.begin(), has_sample.end(), [](const char has) { return has != 0; });
  }

  std::array<FT, 3> relative(const Point_3& p) const
  {
    return {FT(p.x()) - m_fitted.origin()[0], FT(p.y()) - m_fitted.origin()[1], FT(p.z()) - m_fitted.origin()[2]};
  }

  Point_3 absolute(const std::array<FT, 3>& p) const
  {
    return Point_3(CGAL::to_double(FT(p[0] + m_fitted.origin()[0])), CGAL::to_double(FT(p[1] + m_fitted.origin()[1])),
                   CGAL::to_double(FT(p[2] + m_fitted.origin()[2])));
  }

  // Those of the cells, then those of the edges, then those of the border, then its corners. Their weights are between areas and equal ones:
  // were they areas, the surface in a narrow cell would be what its large neighbours make of it. Along a sharp edge, a strip
  // of a cell's quarter counts once more. The border is a curve that the surface has to meet: it counts several times.
  std::vector<Sample> fitting_samples() const
  {
    std::vector<Sample> result;
    const auto add = [&](const Sampled_place& s, const double factor) {
      result.push_back({s.face, FT(s.u), FT(s.v), relative(s.point), FT(factor * std::sqrt(s.area * m_mean_area))});
    };
    for (const Sampled_place& s : m_cells)
      add(s, 1);
    for (const Sampled_place& s : m_edges)
      add(s, 0.25);
    for (const Sampled_place& s : m_border)
      add(s, 4);
    // Else their neighbours would be where others go well with them, and the surface would fold when they are put there.
    constexpr double pin = 1e8;
    for (const auto& corner : m_border_corners)
      result.push_back(
          {corner.face, corner.u, corner.v, relative(m_walk.points()[corner.point]), FT(pin * m_mean_area)});
    return result;
  }

  template <typename SolverTraits>
  bool iterate(const int number_of_corrections, Fitting_system<FT>& system, std::vector<Sample>& aims,
               SolverTraits& solver, T_spline_fit_report<Graph>& report)
  {
    report.number_of_corrections = 0;
    report.status = T_spline_fit_status::UNDERDETERMINED;
    if (!system.solve(solver, m_control_points))
      return false;
    put_corners();
    const auto move = [&] {
      system.evaluate(m_control_points, m_points);
      return move_aims(aims);
    };
    report.error.rms = move();
    report.first_error = report.error;
    // Control points -> aims -> control points is an iteration with a fixed point.
    constexpr double negligible = 0.995; // half a percent of the error is not worth a solve
    Anderson_acceleration<FT> acceleration;
    while (report.number_of_corrections < number_of_corrections) {
      m_progress.progress(static_cast<double>(report.number_of_corrections) / number_of_corrections);
      if (!m_progress.go_on())
        return false;
      ++report.number_of_corrections;
      const std::vector<std::array<FT, 3>> last = m_control_points;
      system.set_points(aims);
      if (!system.solve_for_points(solver, m_control_points))
        return false;
      put_corners();
      const double before = report.error.rms;
      const std::vector<std::array<FT, 3>> plain = m_control_points;
      m_control_points = accelerated(acceleration, last, plain);
      report.error.rms = move();
      if (report.error.rms > before) {
        acceleration.reset();
        m_control_points = plain;
        report.error.rms = move();
      }
      if (report.error.rms > negligible * before)
        break;
    }
    return true;
  }

  // Where the border has corners the surface meets them.
  void put_corners()
  {
    for (const auto& corner : m_border_corners)
      m_control_points[corner.vertex] = relative(m_walk.points()[corner.point]);
  }

  static std::vector<std::array<FT, 3>> accelerated(Anderson_acceleration<FT>& acceleration,
                                                    const std::vector<std::array<FT, 3>>& last,
                                                    const std::vector<std::array<FT, 3>>& next)
  {
    using Vector = typename Anderson_acceleration<FT>::Vector;
    const auto vector = [](const std::vector<std::array<FT, 3>>& points) {
      Vector result(3 * static_cast<Eigen::Index>(points.size()));
      Eigen::Index i = 0;
      for (const std::array<FT, 3>& p : points)
        for (const FT& x : p)
          result[i++] = x;
      return result;
    };
    const Vector x = acceleration.next(vector(last), vector(next));
    std::vector<std::array<FT, 3>> result(next.size());
    Eigen::Index i = 0;
    for (std::array<FT, 3>& p : result)
      for (FT& y : p)
        y = x[i++];
    return result;
  }

  // As a rule the stiffness is the same everywhere, in units of length: cells much smaller than most would else fold
  // between large neighbours with which they share basis functions.
  void set_fairness(const double fairness, Fitting_system<FT>& system) const
  {
    const FT factor = FT(fairness * m_mean_area * m_mean_area);
    const std::size_t number_of_faces = m_fitted.surface().t_mesh_arrays().number_of_faces();
    std::vector<FT> areas(number_of_faces, FT(0)), stiffness;
    for (const std::vector<Sampled_place>* const samples : {&m_cells, &m_bare_cells})
      for (const Sampled_place& s : *samples)
        areas[s.face] += FT(s.area);
    for (const double x : m_stiffness)
      stiffness.push_back(factor * FT(x));
    system.set_fairness(areas, stiffness);
  }

  // The samples of the cells aim at the points of the mesh that are closest to the surface there. Where that is farther
  // than a cell from where the map has them, they aim at the mesh next to the point that far on the way. Those of the
  // border aim at the border in the same way.
  // Returns the root mean square of the distances. If the progress is interrupted, feet are missing.
  double move_aims(std::vector<Sample>& aims)
  {
    double sum = 0, area = 0;
    m_feet.clear();
    for (std::size_t i = 0; i < m_cells.size() && m_progress.go_on_after(10); ++i) {
      const Sampled_place& sample = m_cells[i];
      const Point_3 q = absolute(m_points[i]);
      m_feet.push_back(m_walk.closest(q, m_triangles[i]));
      sum += sample.area * m_feet[i].squared_distance;
      area += sample.area;
      Surface_walk::Foot aim = m_feet[i];
      const Vector_3 way = q - sample.point;
      const double length = std::sqrt(way.squared_length());
      if (length > sample.reach)
        aim = m_walk.closest(sample.point + (sample.reach / length) * way, sample.triangle);
      m_triangles[i] = aim.triangle;
      aims[i].point = relative(aim.point);
    }
    for (std::size_t i = 0, k = m_cells.size() + m_edges.size(); i < m_border.size() && m_progress.go_on_after(10);
         ++i, ++k) {
      const Sampled_place& sample = m_border[i];
      const Point_3 q = absolute(m_points[k]);
      m_border_feet[i] =
          m_walk.closest_on_border(q, m_border_feet[i].triangle, m_border_feet[i].side, m_is_border_corner);
      sum += sample.area * m_border_feet[i].squared_distance;
      area += sample.area;
      const Vector_3 way = q - sample.point;
      const double length = std::sqrt(way.squared_length());
      Surface_walk::Foot aim = m_border_feet[i];
      if (length > sample.reach)
        aim = m_walk.closest_on_border(sample.point + (sample.reach / length) * way, sample.triangle, sample.side,
                                       m_is_border_corner);
      aims[k].point = relative(aim.point);
    }
    return std::sqrt(sum / area);
  }

  // Distances of the surface from the mesh in the cells, and of edges and vertices of the mesh from the surface; those
  // of the borders likewise.
  void measure(const double tolerance, T_spline_fit_report<Graph>& report)
  {
    m_faces.assign(m_fitted.surface().t_mesh_arrays().number_of_faces(), Face_fit());
    const Compiled compiled = compile_T_spline(m_fitted.surface(), CGAL::parameters::visitor(Part_visitor(m_progress)));
    if (compiled.status() == T_spline_compilation_status::INTERRUPTED)
      return;
    const auto& indexing = m_fitted.surface().indexing();
    for (std::size_t i = 0; i < m_cells.size() && m_progress.go_on_after(10); ++i) {
      const Sampled_place& s = m_cells[i];
      Face_fit& face = m_faces[s.face];
      const auto n = compiled.unit_normal(indexing.face(s.face), FT(s.u), FT(s.v));
      const Vector_3 normal = internal::in_doubles<Vector_3>(n);
      face.distance = (std::max)(face.distance, std::sqrt(m_feet[i].squared_distance));
      face.area += s.area;
      if (face.fold != Fold_state::FOLDED && m_walk.is_against(normal, m_feet[i])) {
        const auto p = compiled.position(indexing.face(s.face), FT(s.u), FT(s.v));
        face.fold = m_walk.agrees_within(tolerance, normal, absolute({p.x(), p.y(), p.z()}), m_feet[i])
                        ? Fold_state::DOUBTFUL
                        : Fold_state::FOLDED;
      }
    }
    for (const Sampled_place& s : m_bare_cells)
      m_faces[s.face].area += s.area;
    for (std::size_t i = 0; i < m_border.size(); ++i)
      m_faces[m_border[i].face].distance =
          (std::max)(m_faces[m_border[i].face].distance, std::sqrt(m_border_feet[i].squared_distance));
    measure_border_of_mesh(tolerance, compiled);
    measure_points_of_mesh(tolerance, compiled);
    report.error.maximum = 0;
    for (const Face_fit& face : m_faces)
      report.error.maximum = (std::max)(report.error.maximum, face.distance);
    report.error.extent = m_box.extent();
  }

  // Of the vertices and the middles of edges on the border of the mesh from that of the surface: where the mesh has a
  // narrow notch, all of the surface may be near to it, its border to that of the mesh, but not the other way round.
  void measure_border_of_mesh(const double tolerance, const Compiled& compiled)
  {
    if (m_border.empty())
      return;
    const std::vector<Border_curve> curves = border_curves(compiled, Curve_kind::BORDER_OR_CREASE);
    constexpr double share_of_tolerance = 0.01;
    const std::vector<Cubic_arc> arcs = flat_arcs(curves, share_of_tolerance * tolerance);
    const Segment_tree tree(chords(arcs), m_progress);
    const auto& points = m_walk.points();
    std::size_t hint = 0;
    for (std::size_t i = 0; i < m_walk.triangles().size() && m_progress.go_on_after(1); ++i)
      for (std::size_t side = 0; side < 3; ++side) {
        if (m_walk.across(i, side) != i)
          continue;
        const Point_3 &a = points[m_walk.triangles()[i][side]], &b = points[m_walk.triangles()[i][(side + 1) % 3]];
        for (const Point_3& p : {a, CGAL::midpoint(a, b)}) {
          const std::array<double, 3> q = in_doubles(relative(p));
          const Segment_tree::Foot foot = tree.foot(Point_3(q[0], q[1], q[2]), hint);
          hint = foot.segment;
          Face_fit& face = m_faces[curves[arcs[hint].curve].face];
          face.distance = (std::max)(face.distance, foot.distance());
        }
      }
  }

  // From the places that the map gives them, steps lead to the closest places of the surface. Where that seems to end too
  // early, as where the surface has left the map, they begin again at the closest sample of the surface.
  void measure_points_of_mesh(const double tolerance, const Compiled& compiled)
  {
    const auto& indexing = m_fitted.surface().indexing();
    const Parameter_correction<Compiled> correction(compiled, m_fitted.surface().basis());
    std::optional<Box_tree<double>> tree; // of the samples of the cells
    const auto corrected_distance = [&](Sample& sample) {
      correction(sample);
      const auto p = compiled.position(indexing.face(sample.face), sample.u, sample.v);
      return std::sqrt(CGAL::squared_distance(absolute({p.x(), p.y(), p.z()}), absolute(sample.point)));
    };
    const auto measure_sample = [&](const Sampled_place& s) {
      constexpr std::size_t work = 50;
      if (!m_progress.go_on_after(work))
        return;
      Sample sample{s.face, FT(s.u), FT(s.v), relative(s.point), FT(0)};
      double distance = corrected_distance(sample);
      if (distance > tolerance) {
        if (!tree)
          tree = tree_of_points();
        const Sampled_place& near = m_cells[closest_sample(*tree, sample.point)];
        Sample other{near.face, FT(near.u), FT(near.v), sample.point, FT(0)};
        const double other_distance = corrected_distance(other);
        if (other_distance < distance) {
          distance = other_distance;
          sample = other;
        }
      }
      m_faces[sample.face].distance = (std::max)(m_faces[sample.face].distance, distance);
    };
    std::for_each(m_edges.begin(), m_edges.end(), measure_sample);
    std::for_each(m_corners.begin(), m_corners.end(), measure_sample);
  }

  static std::array<double, 3> in_doubles(const std::array<FT, 3>& p)
  {
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  Box_tree<double> tree_of_points() const
  {
    std::vector<Axis_parallel_box<double>> boxes(m_cells.size());
    for (std::size_t i = 0; i < m_cells.size(); ++i)
      boxes[i].extend(in_doubles(m_points[i]));
    return Box_tree<double>(boxes);
  }

  // The sample of the cells at which the surface is closest.
  std::size_t closest_sample(const Box_tree<double>& tree, const std::array<FT, 3>& point) const
  {
    const std::array<double, 3> p = in_doubles(point);
    const auto squared_distance = [&](const std::size_t i) {
      const std::array<double, 3> q = in_doubles(m_points[i]);
      const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
      return x * x + y * y + z * z;
    };
    return tree.closest(p, {(std::numeric_limits<double>::max)(), 0}, squared_distance).second;
  }

  Fitted m_fitted;
  const Carried& m_carried;
  const Surface_walk& m_walk;
  Progress& m_progress;
  std::vector<double> m_stiffness; // of the faces
  Axis_parallel_box<double> m_box;
  double m_mean_area = 0; // of a sample of the cells
  std::vector<Sampled_place> m_cells, m_edges, m_border, m_corners;
  std::vector<Sampled_place> m_bare_cells; // where there is no data: no samples, but the surface has an area there
  std::vector<typename Surface_sampling<Graph, FT>::Border_corner> m_border_corners;
  std::vector<char> m_is_border_corner;            // per point of the surface
  std::vector<std::array<FT, 3>> m_control_points; // relative to the origin
  std::vector<std::array<FT, 3>> m_points;         // of the surface, at the samples, those of the cells first; likewise
  std::vector<std::size_t> m_triangles;            // per sample of the cells: that of the point that it aims at
  std::vector<Surface_walk::Foot> m_feet;          // likewise: the point of the mesh closest to the surface
  std::vector<Surface_walk::Foot>
      m_border_feet; // per sample of the border: the point of the mesh's border closest to it
  std::vector<Face_fit> m_faces;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_FITTER_H
