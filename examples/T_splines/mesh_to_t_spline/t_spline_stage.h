// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_SPLINE_STAGE_H
#define MESH_TO_T_SPLINE_T_SPLINE_STAGE_H

#include "Figures.h"
#include "Progress.h"
#include "Surface_drawing.h"
#include "Surface_t_mesh.h"
#include "t_mesh_stage.h"

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

using Knot_map = decltype(Surface_t_mesh::knots);
using Corner_map = decltype(Surface_t_mesh::corners);
using Control_point_map = T_mesh::Property_map<T_mesh::Vertex_index, Kernel::Point_3>;
using T_spline = CGAL::T_splines::T_spline_surface<T_mesh, Knot_map, Corner_map, Control_point_map>;
using Compiled_t_spline = CGAL::T_splines::Compiled_T_spline<T_mesh, Kernel>;

inline double diagonal_of(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// Splits the faces until none is longer than `size` on the surface. \return what went wrong; empty if nothing did.
inline std::string refine(Progress& progress, Surface_t_mesh& t, const double size, T_spline_figures& figures)
{
  progress.begin_stage("refinement");
  using Coordinates = CGAL::T_splines::T_mesh_coordinates<T_mesh, Knot_map, Corner_map>;
  using Face_size = CGAL::T_splines::Surface_face_size<T_mesh, Knot_map, Corner_map, Samples>;
  Face_size face_size(Coordinates(t.mesh, t.knots, t.corners), t.samples);
  const CGAL::T_splines::T_mesh_visitor_pair<Roots, Face_size::Visitor> visitor(*t.roots, face_size.visitor());
  const auto report =
      CGAL::T_splines::refine_T_mesh(t.mesh, t.knots, t.corners, face_size, size, CGAL::parameters::visitor(visitor));
  figures.splits_for_size = report.splits;
  progress.end_stage();
  return report.success() ? "" : message(report.status);
}

/// \return why the T-mesh carries no T-spline; empty if it does.
inline std::string make_compatible(Progress& progress, Surface_t_mesh& t, T_spline_figures& figures)
{
  progress.begin_stage("compatibility");
  const auto report =
      CGAL::T_splines::make_spline_compatible(t.mesh, t.knots, t.corners, CGAL::parameters::visitor(*t.roots));
  progress.end_stage();
  figures.splits_for_rings = report.splits_for_rings;
  figures.splits_at_border = report.splits_at_border;
  figures.splits_for_supports = report.splits_of_reaching_supports + report.splits_of_overlapping_supports;
  figures.added_vertices = report.vertices_after - report.vertices_before;
  figures.vertices_in_rings = report.vertices_in_rings;
  return report.success() ? "" : describe(report, t.mesh);
}

/// What the page draws of a surface. About `most` triangles.
inline Surface_drawing drawing_of(const T_spline& surface, const Surface_t_mesh& t, const std::size_t most)
{
  Surface_drawing drawing;
  const std::size_t faces = std::max<std::size_t>(1, t.mesh.number_of_faces());
  const int resolution =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(most) / (2. * static_cast<double>(faces)))), 3, 16);
  const auto tessellation = CGAL::T_splines::tessellate_parameter_domain(surface, resolution);
  for (const auto& place : tessellation.places) {
    const T_spline::Jet jet = surface.jet(place.face, place.u, place.v);
    const bool is_regular = jet.normal().squared_length() > 0;
    drawing.points.push_back(jet.position);
    drawing.normals.push_back(surface.unit_normal(place.face, place.u, place.v));
    // On the page a sphere with outward normals has a positive curvature.
    drawing.mean_curvature.push_back(is_regular ? -jet.curvatures().mean : std::numeric_limits<double>::quiet_NaN());
  }
  for (const auto& triangle : tessellation.triangles)
    for (const std::size_t i : triangle)
      drawing.triangles.push_back(static_cast<std::uint32_t>(i));
  for (const T_mesh::Edge_index e : t.mesh.edges()) {
    const T_mesh::Halfedge_index any = t.mesh.halfedge(e), h = t.mesh.is_border(any) ? t.mesh.opposite(any) : any;
    drawing.net_points.push_back(t.mesh.point(t.mesh.source(h)));
    drawing.net_points.push_back(t.mesh.point(t.mesh.target(h)));
    drawing.net_sizes.push_back(2);
    const CGAL::T_splines::T_mesh_coordinates coordinates(t.mesh, t.knots, t.corners);
    const auto a = coordinates.source_point(h), b = coordinates.target_point(h);
    const double u = CGAL::to_double(a.first), v = CGAL::to_double(a.second), du = CGAL::to_double(b.first) - u,
                 dv = CGAL::to_double(b.second) - v;
    for (int i = 0; i <= resolution; ++i) {
      const double x = static_cast<double>(i) / resolution;
      const auto clamped = [](const double y, const double size) { return std::clamp(y, 0., size); };
      drawing.edge_points.push_back(surface.position(t.mesh.face(h), clamped(u + x * du, surface.width(t.mesh.face(h))),
                                                     clamped(v + x * dv, surface.height(t.mesh.face(h)))));
    }
    drawing.edge_sizes.push_back(static_cast<std::uint32_t>(resolution + 1));
  }
  for (const T_mesh::Vertex_index v : t.mesh.vertices())
    if (CGAL::T_splines::is_extraordinary(v, t.mesh, t.corners)) {
      const T_mesh::Halfedge_index h = t.mesh.halfedge(v);
      const auto p = CGAL::T_splines::T_mesh_coordinates(t.mesh, t.knots, t.corners).target_point(h);
      drawing.extraordinary_points.push_back(
          surface.position(t.mesh.face(h), std::min(CGAL::to_double(p.first), surface.width(t.mesh.face(h))),
                           std::min(CGAL::to_double(p.second), surface.height(t.mesh.face(h)))));
    }
  return drawing;
}

#endif // MESH_TO_T_SPLINE_T_SPLINE_STAGE_H
