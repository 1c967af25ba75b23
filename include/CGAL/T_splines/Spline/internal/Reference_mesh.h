// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_REFERENCE_MESH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_REFERENCE_MESH_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/internal/Measured_mesh.h>
#include <CGAL/T_splines/Spline/internal/Mesh_intersections.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The mesh that the surfaces of a fit are measured against. What a measurement needs of it is computed when it is first
/// needed. It refers to the mesh.
template <typename TriangleMesh_, typename VertexPointMap>
class Reference_mesh {
public:
  using TriangleMesh = TriangleMesh_;

  /// \param progress it must outlive this; once it is interrupted, what is computed means nothing
  /// \param np as for `read_triangle_set()`
  template <typename NamedParameters>
  Reference_mesh(const TriangleMesh& mesh, const VertexPointMap point_map, const NamedParameters& np,
                 Progress& progress)
    : m_mesh(mesh),
      m_point_map(point_map),
      m_progress(progress)
  {
    m_reading = read_triangle_set(mesh, point_map, np, m_triangles);
    m_extent = m_triangles.extent();
  }

  /// Whether there are triangles with points to measure; what follows needs that.
  bool is_valid() const { return m_reading.status == T_spline_deviation_status::MEASURED; }
  const Triangle_reading<TriangleMesh>& reading() const { return m_reading; }
  double extent() const { return m_extent; } ///< the longest side of the bounding box of the data

  const Measured_mesh& measured()
  {
    if (!m_measured)
      m_measured.emplace(std::move(m_triangles), m_progress);
    return *m_measured;
  }

  const Mesh_intersections& intersections()
  {
    if (!m_intersections)
      m_intersections.emplace(m_mesh, m_point_map, m_progress);
    return *m_intersections;
  }

private:
  const TriangleMesh& m_mesh;
  VertexPointMap m_point_map;
  Progress& m_progress;
  Triangle_reading<TriangleMesh> m_reading;
  Triangle_set m_triangles; // until they are measured
  double m_extent = 0;
  std::optional<Measured_mesh> m_measured;
  std::optional<Mesh_intersections> m_intersections;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_REFERENCE_MESH_H
