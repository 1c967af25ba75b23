// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_FILL_HOLES_H
#define CGAL_T_SPLINES_IO_FILL_HOLES_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/cgal_compatibility.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// How the filling of holes ended.
enum class Hole_filling_status {
  FILLED,       ///< all holes that may be filled were tried
  INVALID_MESH, ///< the mesh is refused: see `mesh`
  INTERRUPTED   ///< the visitor asked to stop; some holes may have been filled
};

/// \ingroup PkgTSplinesIO
/// returns one sentence that explains `status`.
inline const char* message(const Hole_filling_status status)
{
  switch (status) {
  case Hole_filling_status::FILLED: return "the holes were filled";
  case Hole_filling_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Hole_filling_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesIO
/// What `fill_holes()` did.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Hole_filling_report {
  Hole_filling_status status = Hole_filling_status::FILLED; ///< how it ended
  Triangle_mesh_report<TriangleMesh> mesh;                  ///< the check of the mesh, before
  std::size_t number_of_filled_holes = 0;                   ///< closed curves of the border that are gone
  std::size_t number_of_faces = 0;                          ///< that fill them
  std::size_t number_of_larger_holes = 0;                   ///< closed curves with more edges, which were left
  std::size_t number_of_failed_holes = 0; ///< others that were left: no faces with positive areas fill them
  /// An edge of the first of these, without face.
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor failed_hole =
      boost::graph_traits<TriangleMesh>::null_halfedge();

  /// returns whether `status` tells of success. Holes may be left.
  bool success() const { return status == Hole_filling_status::FILLED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesIO
/// returns what `report` says, and which holes were left. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Hole_filling_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  if (report.status == Hole_filling_status::INVALID_MESH)
    return describe(report.mesh, mesh);
  if (!report.success())
    return message(report.status);
  const auto counted = [](const std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  std::string text = counted(report.number_of_filled_holes, "hole", "holes") + " filled";
  if (report.number_of_filled_holes > 0)
    text += " with " + counted(report.number_of_faces, "face", "faces");
  if (report.number_of_larger_holes > 0)
    text += "; " + counted(report.number_of_larger_holes, "larger one", "larger ones") + " left";
  if (report.number_of_failed_holes > 0)
    text += "; " + counted(report.number_of_failed_holes, "hole that has", "holes that have") +
            " no filling left, the first at the " + internal::edge_in_words(report.failed_hole, mesh) +
            ", counted from 0";
  return text;
}

namespace internal {

/// Fills the holes of a mesh one by one.
template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits>
class Hole_filling {
  using Traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

public:
  Hole_filling(TriangleMesh& mesh, const VertexPointMap& points, const GeomTraits& traits)
    : m_mesh(mesh),
      m_points(points),
      m_traits(traits)
  {
  }

  const std::vector<Face>& faces() const { return m_faces; } ///< that were added

  std::size_t number_of_edges(const Halfedge hole) const
  {
    const auto curve = CGAL::halfedges_around_face(hole, m_mesh);
    return static_cast<std::size_t>(std::distance(curve.begin(), curve.end()));
  }

  /// \return whether the hole is filled; if it is not, it is as before, though elements may have been added and removed.
  bool fill(const Halfedge hole)
  {
    if (is_outside_of_triangle(hole))
      return false;
    std::vector<Face> patch;
    fill_hole_smoothly(m_mesh, hole, m_points, m_traits, patch);
    if (patch.empty())
      return false;
    if (!std::all_of(patch.begin(), patch.end(), [this](const Face f) { return has_positive_area(f); })) {
      for (const Face f : patch)
        CGAL::Euler::remove_face(halfedge(f, m_mesh), m_mesh);
      return false;
    }
    m_faces.insert(m_faces.end(), patch.begin(), patch.end());
    return true;
  }

private:
  // Its back would have the same three vertices.
  bool is_outside_of_triangle(const Halfedge hole) const
  {
    const Face f = face(opposite(hole, m_mesh), m_mesh);
    return number_of_edges(hole) == 3 && face(opposite(next(hole, m_mesh), m_mesh), m_mesh) == f &&
           face(opposite(prev(hole, m_mesh), m_mesh), m_mesh) == f;
  }

  bool has_positive_area(const Face f) const
  {
    const Halfedge h = halfedge(f, m_mesh);
    const auto &p = get(m_points, source(h, m_mesh)), &q = get(m_points, target(h, m_mesh)),
               &r = get(m_points, target(next(h, m_mesh), m_mesh));
    return is_finite(p) && is_finite(q) && is_finite(r) && !are_collinear(m_traits, p, q, r);
  }

  template <typename Point>
  static bool is_finite(const Point& p)
  {
    return std::isfinite(CGAL::to_double(p.x())) && std::isfinite(CGAL::to_double(p.y())) &&
           std::isfinite(CGAL::to_double(p.z()));
  }

  TriangleMesh& m_mesh;
  const VertexPointMap& m_points;
  const GeomTraits& m_traits;
  std::vector<Face> m_faces;
};

} // namespace internal

/// \ingroup PkgTSplinesIO
/// closes holes of a mesh: the closed curves of its border that have few edges. Each is triangulated, refined to the density of the
/// mesh around it, and made smooth (`CGAL::Polygon_mesh_processing::triangulate_refine_and_fair_hole()`).
///
/// What fills a hole is a guess, no data: give the map that is written to `approximate_by_T_spline()`, and the surface is neither
/// fitted to it nor measured against it.
///
/// Every closed curve of the border counts as a hole, also the outer one of a sheet if it has no more edges. A hole that
/// cannot be filled with triangles of positive area stays open; then the mesh may have removed elements, but none of those
/// that it had before.
/// \tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands. What it has stays as it is; vertices and faces are added
/// \param largest_number_of_edges of a hole that is filled
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`, which takes those of new ones, too}
///     \cgalParamType{a model of `ReadWritePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///     \cgalParamExtra{Points with coordinates of a floating point type.}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a geometric traits class}
///     \cgalParamType{a model of `Kernel`}
///     \cgalParamDefault{the kernel of the points, a new object}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_is_data_map}
///     \cgalParamDescription{receives `false` for the faces that fill holes, `true` for all others}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`, that
///       takes new faces, too}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work, between one hole and the next}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how many holes were filled, and which were left.
/// Complexity: linear in the size of the mesh, and for a hole with n edges as a rule n log n, at worst n^3.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hole_filling_report<TriangleMesh> fill_holes(TriangleMesh& mesh, const std::size_t largest_number_of_edges,
                                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using GeomTraits = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const auto points =
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(CGAL::vertex_point, mesh));
  const auto traits = choose_parameter<GeomTraits>(get_parameter(np, CGAL::internal_np::geom_traits));
  const auto is_data = get_parameter(np, np_tags::face_is_data_map);
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("hole filling");
  Hole_filling_report<TriangleMesh> report;
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success() && !progress.is_interrupted())
    report.status = Hole_filling_status::INVALID_MESH;
  std::vector<Halfedge> holes;
  if (report.mesh.success())
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(holes));
  internal::Hole_filling filling(mesh, points, traits);
  for (std::size_t i = 0; i < holes.size() && progress.go_on(); ++i) {
    progress.progress(static_cast<double>(i) / static_cast<double>(holes.size()));
    if (filling.number_of_edges(holes[i]) > largest_number_of_edges)
      ++report.number_of_larger_holes;
    else if (filling.fill(holes[i]))
      ++report.number_of_filled_holes;
    else if (report.number_of_failed_holes++ == 0)
      report.failed_hole = holes[i];
  }
  report.number_of_faces = filling.faces().size();
  if constexpr (!internal::is_missing<decltype(is_data)>)
    if (report.status != Hole_filling_status::INVALID_MESH) {
      for (const auto f : faces(mesh))
        put(is_data, f, true);
      for (const auto f : filling.faces())
        put(is_data, f, false);
    }
  if (progress.is_interrupted())
    report.status = Hole_filling_status::INTERRUPTED;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_FILL_HOLES_H
