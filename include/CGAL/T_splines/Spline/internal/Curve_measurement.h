// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_MEASUREMENT_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_MEASUREMENT_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/internal/Border_curve.h>
#include <CGAL/T_splines/Spline/internal/Curve_distances.h>
#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Segment_tree.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Measures the border of a surface, or its creases, against those of a mesh, both ways. The curves of the surface are
/// rational cubic ones. They are divided into arcs that are straight up to what is negligible, whose chords are searched for
/// closest points.
/// \tparam Measured a `Measured_surface`
/// \tparam TriangleMesh the mesh
template <typename Measured, typename TriangleMesh>
class Curve_measurement {
  using Graph = typename Measured::Compiled::Graph;
  using Deviation = Curve_deviation<Graph, TriangleMesh>;
  using Place = Curve_place<Graph, TriangleMesh>;

public:
  /// \param mesh, reading, surface must outlive this
  /// \param kind BORDER or CREASE
  /// \param negligible distances that need not be told apart
  /// \param progress it must outlive this; if it is interrupted, what was measured means nothing
  Curve_measurement(const Triangle_set& mesh, const Triangle_reading<TriangleMesh>& reading, const Measured& surface,
                    const Curve_kind kind, const double negligible, Progress& progress)
    : m_mesh(mesh),
      m_mesh_edges(kind == Curve_kind::BORDER ? mesh.border : mesh.creases),
      m_halfedges(kind == Curve_kind::BORDER ? reading.border : reading.creases),
      m_surface(surface),
      m_progress(progress),
      m_curves(border_curves(surface.compiled(), kind)),
      m_negligible(negligible)
  {
    for (const Border_curve& curve : m_curves)
      m_whole_arcs.push_back(curve.arc);
    for (const auto& edge : m_mesh_edges)
      m_edges.push_back({mesh.points[edge[0]], mesh.points[edge[1]], m_edges.size()});
  }

  /// Whether both have such curves.
  bool is_possible() const { return !m_curves.empty() && !m_edges.empty(); }

  /// Measures. \param visit is called with faces, by index, and distances there
  /// \pre `is_possible()`
  template <typename Visit>
  void measure(const double tolerance, const Visit& visit, Deviation& result)
  {
    const std::vector<Cubic_arc> arcs = flat_arcs(m_curves, largest_sagitta());
    const Segment_tree of_mesh(chords(m_edges), m_progress), of_surface(chords(arcs), m_progress);
    if (!m_progress.go_on())
      return;
    {
      Curve_distances<Cubic_arc> distances(of_mesh, m_negligible, m_progress);
      measure_way(
          distances, m_whole_arcs, tolerance,
          [&](const auto& sample) { visit(m_curves[sample.arc.curve].face, sample.foot.distance()); },
          result.surface_to_mesh);
      const auto& farthest = distances.farthest();
      const auto& foot = farthest.foot;
      set_maximum(farthest.point, of_mesh.closest_point(farthest.point, foot.segment), distances.upper_bound(), 0,
                  result.surface_to_mesh);
      result.surface_to_mesh_place = place(closest_of_arc(farthest.point, farthest.arc).first,
                                           m_curves[farthest.arc.curve], m_edges[foot.segment]);
    }
    {
      Curve_distances<Straight_arc> distances(of_surface, m_negligible, m_progress);
      measure_way(
          distances, m_edges, tolerance,
          [&](const auto& sample) { visit(m_curves[arcs[sample.foot.segment].curve].face, sample.foot.distance()); },
          result.mesh_to_surface);
      const auto& farthest = distances.farthest();
      const Cubic_arc& arc = arcs[farthest.foot.segment];
      const auto [parameter, closest] = closest_of_arc(farthest.point, arc);
      set_maximum(farthest.point, closest, distances.upper_bound(), largest_sagitta_of(arcs), result.mesh_to_surface);
      result.mesh_to_surface_place = place(parameter, m_curves[arc.curve], farthest.arc);
    }
    measure_corners(result);
  }

private:
  // A part of what is negligible; by the mesh, arcs of a surface that is much larger would be many.
  double largest_sagitta() const
  {
    constexpr double share = 0.5, share_of_extent = 5e-8;
    Axis_parallel_box<double> box;
    for (const Border_curve& curve : m_curves)
      box.extend(curve.arc.source());
    return (std::max)(share * m_negligible, share_of_extent * box.extent());
  }

  static double largest_sagitta_of(const std::vector<Cubic_arc>& arcs)
  {
    double result = 0;
    for (const Cubic_arc& arc : arcs)
      result = (std::max)(result, arc.sagitta());
    return result;
  }

  template <typename Arc, typename Visit>
  void measure_way(Curve_distances<Arc>& distances, const std::vector<Arc>& arcs, const double tolerance,
                   const Visit& visit, One_way_deviation& result)
  {
    // Enough for means; where distances are almost constant, the search would not end soon.
    constexpr double number_of_samples = 4000;
    constexpr std::size_t number_of_steps = 60000;
    double length = 0;
    for (const Arc& arc : arcs)
      length += arc.length();
    Distance_sum sum(tolerance);
    distances.measure(arcs, length / number_of_samples, sum, visit);
    distances.search(number_of_steps + arcs.size(), visit);
    sum.add_to(result);
  }

  // The closest point is found on the arc, the distances were those from its chord.
  void set_maximum(const Triangle_set::Point_3& farthest, const Triangle_set::Point_3& closest,
                   const double upper_bound, const double sagitta, One_way_deviation& result) const
  {
    result.maximum = std::sqrt(CGAL::squared_distance(farthest, closest));
    result.upper_bound = (std::max)(upper_bound + sagitta, result.maximum);
    result.extent = m_mesh.extent();
    result.farthest_point = farthest;
    result.closest_point = closest;
  }

  // \param parameter of the curve
  Place place(const double parameter, const Border_curve& curve, const Straight_arc& edge) const
  {
    const auto& t_mesh = m_surface.compiled().t_mesh_arrays();
    using FT = typename Measured::FT;
    const auto p =
        t_mesh.point_of_side(curve.face, curve.side, FT(curve.begin + parameter * (curve.end - curve.begin)));
    return {{m_surface.compiled().indexing().face(curve.face), CGAL::to_double(p.first), CGAL::to_double(p.second)},
            m_halfedges[edge.curve]};
  }

  // A corner of the surface is where a vertex of the mesh should be.
  void measure_corners(Deviation& result)
  {
    const auto& t_mesh = m_surface.compiled().t_mesh_arrays();
    std::vector<Segment_tree::Segment> vertices;
    for (const auto& edge : m_mesh_edges)
      vertices.push_back({m_mesh.points[edge[0]], m_mesh.points[edge[0]]});
    const Segment_tree tree(std::move(vertices), m_progress);
    std::vector<char> is_counted(t_mesh.number_of_vertices(), 0); // several creases end at a corner, on both sides
    for (const Border_curve& curve : m_curves) {
      const double end = CGAL::to_double(t_mesh.end(curve.halfedge));
      const int v = t_mesh.target(curve.halfedge);
      const bool is_corner =
          t_mesh.is_crease(curve.halfedge) ? t_mesh.ends_creases(v) : t_mesh.extended_valence(v) != 2;
      if (end - curve.end > same_point * end || !is_corner || !m_progress.go_on_after(20))
        continue;
      result.number_of_corners += is_counted[v] == 0;
      is_counted[v] = 1;
      result.largest_corner_distance =
          (std::max)(result.largest_corner_distance, tree.foot(curve.arc.target()).distance());
    }
  }

  const Triangle_set& m_mesh;
  const std::vector<std::array<std::size_t, 2>>& m_mesh_edges;
  const std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>& m_halfedges; // of the edges
  const Measured& m_surface;
  Progress& m_progress;
  const std::vector<Border_curve> m_curves;
  std::vector<Cubic_arc> m_whole_arcs; // of the curves
  std::vector<Straight_arc> m_edges;
  double m_negligible;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_MEASUREMENT_H
