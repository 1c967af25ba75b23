// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "t_spline_stage.h"

#include "Fit_visitor.h"

#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using Fit_report = CGAL::T_splines::Adaptive_fit_report<Graph>;
using Surface = T_spline::Surface;

Failure failure_of(const Options& options, const Fit_report& report, const Graph& graph)
{
  using Status = CGAL::T_splines::Adaptive_fit_status;
  if (report.success())
    return {};
  const std::string text = describe(report, graph);
  if (report.status != Status::LIMIT_TOO_LOW)
    return {options.input_file() + ": " + text + " (--no-spline ends with the T-mesh)"};
  return {"--max-control-points " + std::to_string(*options.largest_number_of_control_points) + ": " + text, true};
}

void set_fit_figures(const Fit_report& report, T_spline_figures& figures)
{
  using Status = CGAL::T_splines::Adaptive_fit_status;
  figures.status = message(report.status);
  figures.fit_is_within_tolerance = report.status == Status::WITHIN_TOLERANCE;
  figures.best_level = report.best_level;
  for (const CGAL::T_splines::T_spline_fit_level& level : report.levels)
    figures.levels.push_back({level.number_of_control_points,
                              level.number_of_faces,
                              level.control_points_in_rings,
                              level.number_of_folded_faces,
                              {level.error.relative_rms(), level.error.relative_maximum()}});
}

/// Fits and refines.
Failure fit(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress, const Surface_t_mesh& t,
            T_spline& fitted, std::vector<std::string>& levels, T_spline_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  progress.begin_stage("fitting");
  figures.faces_before_fit = t.t_mesh.graph().number_of_faces();
  figures.tolerance = options.tolerance;
  figures.fairness = options.fairness.value_or(default_fairness());
  Level_recorder recorder(progress, options.tolerance, options.has_levels ? &levels : nullptr);
  const std::size_t limit = options.largest_number_of_control_points.value_or(0);
  const auto np = P::fairness(figures.fairness, P::maximum_number_of_control_points(limit))
                      .visitor(Fit_visitor(recorder))
                      .sparse_linear_solver(std::ref(solver));
  const Fit_report report =
      CGAL::T_splines::fit_adaptive_T_spline(t.t_mesh, t.surface, options.tolerance * figures.longest_side, fitted, np);
  progress.end_stage();
  figures.samples = report.number_of_samples;
  set_fit_figures(report, figures);
  return failure_of(options, report, t.t_mesh.graph());
}

/// The images of the edges of the T-mesh, and the edges of the control net.
void draw_edges(const Surface& surface, const T_spline& spline, const int resolution, Surface_drawing& drawing)
{
  const Graph& graph = spline.graph();
  const CGAL::T_splines::T_mesh_coordinates coordinates(spline);
  for (const Graph::Edge_index e : graph.edges()) {
    const Graph::Halfedge_index any = graph.halfedge(e), h = graph.is_border(any) ? graph.opposite(any) : any;
    const Graph::Face_index f = graph.face(h);
    drawing.net_points.push_back(graph.point(graph.source(h)));
    drawing.net_points.push_back(graph.point(graph.target(h)));
    drawing.net_sizes.push_back(2);
    const auto a = coordinates.source_point(h), b = coordinates.target_point(h);
    for (int i = 0; i <= resolution; ++i) {
      const double x = static_cast<double>(i) / resolution;
      drawing.edge_points.push_back(
          surface.position(f, std::clamp(a.first + x * (b.first - a.first), 0., surface.width(f)),
                           std::clamp(a.second + x * (b.second - a.second), 0., surface.height(f))));
    }
    drawing.edge_sizes.push_back(static_cast<std::uint32_t>(resolution + 1));
  }
}

/// What the page draws of a surface. About `most` triangles.
Surface_drawing drawing_of(const Surface& surface, const T_spline& spline, const std::size_t most)
{
  const Graph& graph = spline.graph();
  Surface_drawing drawing;
  const std::size_t faces = std::max<std::size_t>(1, graph.number_of_faces());
  const int resolution =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(most) / (2. * static_cast<double>(faces)))), 3, 16);
  const auto tessellation = CGAL::T_splines::tessellate_parameter_domain(surface, resolution);
  for (const auto& place : tessellation.places) {
    const Surface::Jet jet = surface.jet(place.face, place.u, place.v);
    const bool is_regular = jet.normal().squared_length() > 0;
    drawing.points.push_back(jet.position);
    drawing.normals.push_back(surface.unit_normal(place.face, place.u, place.v));
    // On the page a sphere with outward normals has a positive curvature.
    drawing.mean_curvature.push_back(is_regular ? -jet.curvatures().mean : std::numeric_limits<double>::quiet_NaN());
  }
  for (const auto& triangle : tessellation.triangles)
    for (const std::size_t i : triangle)
      drawing.triangles.push_back(static_cast<std::uint32_t>(i));
  draw_edges(surface, spline, resolution, drawing);
  for (const Graph::Vertex_index v : graph.vertices())
    if (CGAL::T_splines::is_extraordinary(v, spline)) {
      const Graph::Halfedge_index h = graph.halfedge(v);
      const Graph::Face_index f = graph.face(h);
      const auto p = CGAL::T_splines::T_mesh_coordinates(spline).target_point(h);
      drawing.extraordinary_points.push_back(
          surface.position(f, std::min(p.first, surface.width(f)), std::min(p.second, surface.height(f))));
    }
  return drawing;
}

void set_surface_figures(const Results& results, T_spline_figures& figures)
{
  figures.t_mesh = figures_of(results.fitted);
  figures.patches = results.surface->number_of_patches();
  figures.rings = results.surface->number_of_rings();
  figures.cap_deviation = results.surface->cap_deviation() / figures.longest_side;
  figures.tessellation_triangles = results.surface_drawing.triangles.size() / 3;
  const T_spline& spline = results.fitted;
  for (const Graph::Vertex_index v : spline.graph().vertices())
    if (CGAL::T_splines::is_extraordinary(v, spline))
      ++figures.valences[CGAL::T_splines::extended_valence(v, spline)];
}

using Deviation_report = CGAL::T_splines::T_spline_deviation_report<Graph, Mesh>;

std::array<double, 3> coordinates_of(const CGAL::Simple_cartesian<double>::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

Deviation_figures::Place place_of(const CGAL::T_splines::Deviation_place<Graph, Mesh>& place,
                                  const CGAL::Simple_cartesian<double>::Point_3& point)
{
  return {coordinates_of(point), place.place.face, place.place.u, place.place.v, place.mesh_face};
}

Deviation_figures figures_of(const Deviation_report& report)
{
  const auto one_way = [](const CGAL::T_splines::One_way_deviation& way,
                          const CGAL::T_splines::Deviation_place<Graph, Mesh>& place) {
    return Deviation_figures::One_way{{way.relative_rms(), way.relative_maximum()},
                                      way.relative_upper_bound(),
                                      way.share_within_tolerance,
                                      way.share_within_half,
                                      place_of(place, way.farthest_point)};
  };
  Deviation_figures figures;
  figures.surface_to_mesh = one_way(report.surface_to_mesh, report.surface_to_mesh_place);
  figures.mesh_to_surface = one_way(report.mesh_to_surface, report.mesh_to_surface_place);
  figures.largest_angle = report.normals.largest_angle * 180 / CGAL_PI;
  figures.worst_angle = place_of(report.normals.place, report.normals.point);
  figures.folded_patches = report.normals.number_of_folded_patches;
  figures.doubtful_patches = report.normals.number_of_doubtful_patches;
  figures.certified_patches = report.normals.number_of_certified_patches;
  return figures;
}

/// Measures the distances between the surface and the mesh, those of the points of the drawing included.
Failure measure(const Options& options, const Mesh& mesh, const Compiled_t_spline& surface, Surface_drawing& drawing,
                T_spline_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  const double tolerance = options.tolerance * figures.longest_side;
  const Deviation_report report = CGAL::T_splines::measure_T_spline_deviation(surface, mesh, P::tolerance(tolerance));
  if (!report.success())
    return {options.input_file() + ": deviation: " + describe(report, mesh)};
  figures.deviation = figures_of(report);
  const CGAL::T_splines::Mesh_distance distance(mesh);
  std::vector<double> distances;
  distance.distances(drawing.points, std::back_inserter(distances));
  for (const double x : distances)
    drawing.deviation.push_back(x / figures.longest_side);
  return {};
}

/// Looks for intersections of the surface with itself, in the triangles of t_spline.obj.
void check_self_intersections(const Options& options, const Mesh& mesh, const Compiled_t_spline& surface,
                              T_spline_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  const double tolerance = options.tolerance * figures.longest_side;
  const auto report = CGAL::T_splines::check_T_spline_self_intersections(
      surface, mesh, CGAL::Emptyset_iterator(),
      P::tolerance(tolerance, P::tessellation_resolution(options.resolution)));
  Deviation_figures& deviation = *figures.deviation;
  deviation.self_intersections = report.number_of_intersections;
  deviation.self_intersections_of_mesh = report.number_of_mesh_intersections;
  deviation.self_intersections_beyond_mesh = report.number_of_new_intersections;
  deviation.self_intersection = coordinates_of(report.place);
}

} // namespace

double default_fairness()
{
  return CGAL::T_splines::default_fairness;
}

Failure make_t_spline(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress, Results& results,
                      T_spline_figures& figures)
{
  const Mesh& mesh = results.has_map ? results.input : results.refined.mesh;
  figures.longest_side = longest_side_of(mesh);
  Failure failure = fit(options, solver, progress, results.t_mesh, results.fitted, results.levels, figures);
  if (failure)
    return failure;
  progress.begin_stage("surface");
  const T_spline& spline = results.fitted;
  const Surface surface = spline.surface();
  if (!surface.is_valid())
    return {options.input_file() + ": " + describe(surface.report(), spline.graph())};
  results.surface = CGAL::T_splines::compile_T_spline(surface);
  results.resolution = options.resolution;
  progress.begin_stage("drawing");
  results.surface_drawing = drawing_of(surface, spline, 400000);
  progress.begin_stage("deviation");
  failure = measure(options, mesh, *results.surface, results.surface_drawing, figures);
  if (failure)
    return failure;
  progress.begin_stage("self-intersections");
  check_self_intersections(options, mesh, *results.surface, figures);
  progress.end_stage();
  set_surface_figures(results, figures);
  return failure;
}
