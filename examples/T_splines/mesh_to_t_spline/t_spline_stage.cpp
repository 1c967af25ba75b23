// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "t_spline_stage.h"

#include "Fit_visitor.h"
#include "Mapped_mesh_figures.h"

#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using Fit_report = CGAL::T_splines::Adaptive_fit_report<Graph, Graph, Mesh>;
using Surface = T_spline::Surface;

Failure failure_of(const Options& options, const Approximation& approximation)
{
  using Status = CGAL::T_splines::Adaptive_fit_status;
  const auto& report = approximation.report();
  if (report.fit.status != Status::LIMIT_TOO_LOW)
    return {options.input_file() + ": " + report.reason + " (--no-spline ends with the T-mesh)"};
  return {"--max-control-points " + std::to_string(report.fit.limit) + ": " + report.reason, true};
}

void set_fit_figures(const Fit_report& report, T_spline_figures& figures)
{
  figures.status = message(report.status);
  figures.fit_is_within_tolerance = report.within_tolerance();
  figures.best_level = report.best_level;
  figures.samples = report.number_of_samples;
  for (const CGAL::T_splines::T_spline_fit_level& level : report.levels)
    figures.levels.push_back({level.number_of_control_points,
                              level.number_of_faces,
                              level.control_points_in_rings,
                              level.number_of_folded_faces,
                              {level.error.relative_rms(), level.error.relative_maximum()}});
}

/// Fits and refines.
Failure fit(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress, Results& results,
            T_spline_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  progress.begin_stage("fitting");
  Approximation& approximation = *results.approximation;
  figures.faces_before_fit = approximation.t_mesh().t_mesh().graph().number_of_faces();
  figures.tolerance = options.tolerance;
  figures.fairness = options.fairness;
  Level_recorder recorder(progress, options.tolerance, options.has_levels ? &results.levels : nullptr);
  const auto np =
      P::fairness(options.fairness, P::maximum_number_of_control_points(options.largest_number_of_control_points,
                                                                        P::level_observer(std::ref(recorder))))
          .visitor(Fit_visitor(recorder))
          .sparse_linear_solver(std::ref(solver));
  const bool is_fitted = approximation.fit(options.tolerance, results.fitted, np);
  progress.end_stage();
  set_fit_figures(approximation.report().fit, figures);
  return is_fitted ? Failure() : failure_of(options, approximation);
}

/// The images of the edges of the T-mesh, those of the border and creases once more, and the edges of the control net.
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
    const std::size_t first = drawing.edge_points.size();
    for (int i = 0; i <= resolution; ++i) {
      const double x = static_cast<double>(i) / resolution;
      drawing.edge_points.push_back(
          surface.position(f, std::clamp(a.first + x * (b.first - a.first), 0., surface.width(f)),
                           std::clamp(a.second + x * (b.second - a.second), 0., surface.height(f))));
    }
    drawing.edge_sizes.push_back(static_cast<std::uint32_t>(resolution + 1));
    const auto draw_again = [&](std::vector<Kernel::Point_3>& points, std::vector<std::uint32_t>& sizes) {
      points.insert(points.end(), drawing.edge_points.begin() + static_cast<std::ptrdiff_t>(first),
                    drawing.edge_points.end());
      sizes.push_back(drawing.edge_sizes.back());
    };
    if (graph.is_border(e))
      draw_again(drawing.border_points, drawing.border_sizes);
    else if (spline.creases()[e])
      draw_again(drawing.crease_points, drawing.crease_sizes);
  }
}

/// What is remarkable: extraordinary points, and where the border has corners.
void draw_points(const Surface& surface, const T_spline& spline, Surface_drawing& drawing)
{
  const Graph& graph = spline.graph();
  const CGAL::T_splines::T_mesh_coordinates coordinates(spline);
  for (const Graph::Vertex_index v : graph.vertices()) {
    if (!CGAL::T_splines::is_extraordinary(v, spline))
      continue;
    const Graph::Halfedge_index any = graph.halfedge(v),
                                h = graph.is_border(any) ? graph.opposite(graph.next(any)) : any;
    const Graph::Face_index f = graph.face(h);
    const auto p = coordinates.target_point(h);
    const Kernel::Point_3 point =
        surface.position(f, std::min(p.first, surface.width(f)), std::min(p.second, surface.height(f)));
    if (CGAL::T_splines::is_border_vertex(v, spline)) {
      drawing.corner_points.push_back(point);
      drawing.corner_turns.push_back(static_cast<std::uint32_t>(CGAL::T_splines::extended_valence(v, spline)));
    }
    else
      drawing.extraordinary_points.push_back(point);
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
  for (const auto* const places : {&tessellation.places, &tessellation.crease_places})
    for (const auto& place : *places) {
      const Surface::Jet jet = surface.jet(place.face, place.u, place.v);
      const bool is_regular = jet.normal().squared_length() > 0;
      drawing.points.push_back(jet.position);
      drawing.normals.push_back(surface.unit_normal(place.face, place.u, place.v));
      // On the page a sphere with outward normals has a positive curvature.
      drawing.mean_curvature.push_back(is_regular ? -jet.curvatures().mean : std::numeric_limits<double>::quiet_NaN());
    }
  for (const auto& triangle : tessellation.triangles_split_at_creases())
    for (const std::size_t i : triangle)
      drawing.triangles.push_back(static_cast<std::uint32_t>(i));
  draw_edges(surface, spline, resolution, drawing);
  draw_points(surface, spline, drawing);
  return drawing;
}

/// The distances of the drawing from the mesh; none next to what fills holes.
void draw_deviation(Results& results, const double longest_side)
{
  using CGAL::T_splines::Mesh_distance;
  const auto distances = [&](const Mesh_distance& distance) {
    std::vector<double> result;
    distance.distances(results.surface_drawing.points, std::back_inserter(result));
    return result;
  };
  const std::vector<double> to_mesh = distances(Mesh_distance(results.input));
  std::vector<double> to_data;
  if (results.is_data)
    to_data = distances(Mesh_distance(results.input, CGAL::T_splines::parameters::face_is_data_map(*results.is_data)));
  for (std::size_t i = 0; i < to_mesh.size(); ++i)
    results.surface_drawing.deviation.push_back(to_data.empty() || to_data[i] <= to_mesh[i] ? to_mesh[i] / longest_side
                                                                                            : 0);
}

void set_surface_figures(const Results& results, T_spline_figures& figures)
{
  figures.t_mesh = figures_of(results.fitted);
  figures.patches = results.surface->number_of_patches();
  figures.rings = results.surface->number_of_rings();
  figures.cap_deviation = results.surface->cap_deviation() / figures.longest_side;
  figures.tessellation_triangles = results.surface_drawing.triangles.size() / 3;
  figures.creases = results.surface_drawing.crease_sizes.size();
  const T_spline& spline = results.fitted;
  for (const Graph::Vertex_index v : spline.graph().vertices())
    if (CGAL::T_splines::is_extraordinary(v, spline))
      ++(CGAL::T_splines::is_border_vertex(v, spline) ? figures.corners
                                                      : figures.valences)[CGAL::T_splines::extended_valence(v, spline)];
}

std::array<double, 3> coordinates_of(const CGAL::Simple_cartesian<double>::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

Deviation_figures::Place place_of(const CGAL::T_splines::Deviation_place<Graph, Mesh>& place,
                                  const CGAL::Simple_cartesian<double>::Point_3& point)
{
  return {coordinates_of(point), place.place.face, place.place.u, place.place.v, place.mesh_face, std::nullopt};
}

Deviation_figures::One_way figures_of(const CGAL::T_splines::One_way_deviation& way,
                                      const Deviation_figures::Place& worst)
{
  return {{way.relative_rms(), way.relative_maximum()},
          way.relative_upper_bound(),
          way.share_within_tolerance,
          way.share_within_half,
          worst};
}

Deviation_figures::Of_curves figures_of(const CGAL::T_splines::Curve_deviation<Graph, Mesh>& curves, const Mesh& mesh)
{
  const auto one_way = [&](const CGAL::T_splines::One_way_deviation& way,
                           const CGAL::T_splines::Curve_place<Graph, Mesh>& place) {
    const Halfedge given = place.mesh_halfedge, h = mesh.is_border(given) ? mesh.opposite(given) : given;
    return figures_of(way, {coordinates_of(way.farthest_point),
                            place.place.face,
                            place.place.u,
                            place.place.v,
                            mesh.face(h),
                            {{mesh.source(h), mesh.target(h)}}});
  };
  Deviation_figures::Of_curves figures;
  figures.surface_to_mesh = one_way(curves.surface_to_mesh, curves.surface_to_mesh_place);
  figures.mesh_to_surface = one_way(curves.mesh_to_surface, curves.mesh_to_surface_place);
  figures.corners = curves.number_of_corners;
  const double extent = curves.mesh_to_surface.extent;
  figures.largest_corner_distance = extent > 0 ? curves.largest_corner_distance / extent : 0;
  return figures;
}

/// What was measured of the surface that the fit hands out.
Deviation_figures figures_of(const Fit_report& fit, const Mesh& mesh)
{
  const auto& report = fit.deviation;
  const auto one_way = [](const CGAL::T_splines::One_way_deviation& way,
                          const CGAL::T_splines::Deviation_place<Graph, Mesh>& place) {
    return figures_of(way, place_of(place, way.farthest_point));
  };
  Deviation_figures figures;
  figures.of_surface.surface_to_mesh = one_way(report.surface_to_mesh, report.surface_to_mesh_place);
  figures.of_surface.mesh_to_surface = one_way(report.mesh_to_surface, report.mesh_to_surface_place);
  if (report.free_edge)
    figures.free_edge = figures_of(*report.free_edge, mesh);
  if (report.crease)
    figures.crease = figures_of(*report.crease, mesh);
  figures.largest_angle = report.normals.largest_angle * 180 / CGAL_PI;
  figures.worst_angle = place_of(report.normals.place, report.normals.point);
  figures.folded_patches = report.normals.number_of_folded_patches;
  figures.doubtful_patches = report.normals.number_of_doubtful_patches;
  figures.certified_patches = report.normals.number_of_certified_patches;
  figures.self_intersections = fit.self_intersections.number_of_intersections;
  figures.self_intersections_of_mesh = fit.self_intersections.number_of_mesh_intersections;
  figures.self_intersections_beyond_mesh = fit.self_intersections.number_of_new_intersections;
  figures.self_intersection = coordinates_of(fit.self_intersections.place);
  return figures;
}

} // namespace

Failure make_t_spline(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress, Results& results,
                      T_spline_figures& figures)
{
  figures.longest_side = longest_side_of(*results.approximation);
  Failure failure = fit(options, solver, progress, results, figures);
  if (failure)
    return failure;
  progress.begin_stage("surface");
  const T_spline& spline = results.fitted;
  const Surface surface = spline.surface();
  results.surface = CGAL::T_splines::compile_T_spline(surface);
  progress.begin_stage("drawing");
  results.surface_drawing = drawing_of(surface, spline, 400000);
  draw_deviation(results, figures.longest_side);
  progress.end_stage();
  figures.deviation = figures_of(results.approximation->report().fit, results.approximation->mesh());
  set_surface_figures(results, figures);
  return failure;
}
