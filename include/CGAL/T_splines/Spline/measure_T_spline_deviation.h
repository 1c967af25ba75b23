// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H
#define CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H

#include <CGAL/T_splines/Spline/Compiled_T_spline.h>
#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Distances_to_mesh.h>
#include <CGAL/T_splines/Spline/internal/Distances_to_surface.h>
#include <CGAL/T_splines/Spline/internal/Fold_search.h>
#include <CGAL/T_splines/Spline/internal/Curve_measurement.h>
#include <CGAL/T_splines/Spline/internal/Measured_mesh.h>
#include <CGAL/T_splines/Spline/internal/Measured_surface.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/face_is_data.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Measures a compiled surface against a mesh.
template <typename Compiled, typename TriangleMesh>
class Deviation_measurement {
  using Graph = typename Compiled::Graph;
  using Measured = Measured_surface<Compiled>;
  using Report = T_spline_deviation_report<Graph, TriangleMesh>;
  using Place = Deviation_place<Graph, TriangleMesh>;

public:
  /// \param reading of the mesh: successful
  /// \param progress it must outlive this; if it is interrupted, what is reported means nothing
  /// \pre the surface has faces and is finite
  Deviation_measurement(const Measured_mesh& mesh, const Triangle_reading<TriangleMesh>& reading, Measured& surface,
                        Progress& progress, Report& report)
    : m_mesh(mesh),
      m_reading(reading),
      m_surface(surface),
      m_progress(progress),
      m_report(report),
      m_extent(mesh.triangles.extent()),
      m_face_deviations(surface.compiled().indexing().number_of_faces(), 0.),
      m_face_states(surface.compiled().indexing().number_of_faces(), Fold_state::NONE)
  {
  }

  void measure_surface()
  {
    Distances_to_mesh<Measured> distances(m_surface, m_mesh, negligible(), smallest_size(), m_progress);
    Fold_search<Measured> folds(m_surface, m_mesh, reach_of_doubt());
    Distance_sum sum(m_report.tolerance);
    const auto visit = [&](const Surface_sample& sample, const double distance) {
      if (sample.is_measured())
        attribute(m_surface.domain(sample.patch).face, distance);
      folds.visit(sample);
    };
    {
      const Progress::Part part(m_progress, 0, 0.6);
      distances.measure(number_of_surface_samples(), sum, visit);
    }
    distances.search(number_of_steps(), visit);
    {
      const Progress::Part part(m_progress, 0.7, 1);
      folds.search(m_progress);
    }
    if (!m_progress.go_on())
      return;

    One_way_deviation& result = m_report.surface_to_mesh;
    const Surface_sample& farthest = distances.farthest();
    sum.add_to(result);
    set_maximum(farthest.point, farthest.foot.point, farthest.foot.distance(), distances.upper_bound(), result);
    m_report.surface_to_mesh_place = place_of(farthest);
    m_report.normals.largest_angle = std::acos(std::clamp(folds.smallest_cosine(), -1., 1.));
    m_report.normals.point = folds.worst().point;
    m_report.normals.place = place_of(folds.worst());
    m_report.normals.number_of_patches = m_surface.number_of_patches();
    m_report.normals.number_of_folded_patches = folds.number_of(Fold_state::FOLDED);
    m_report.normals.number_of_doubtful_patches = folds.number_of(Fold_state::DOUBTFUL);
    m_report.normals.number_of_certified_patches = folds.number_of_certified();
    for (std::size_t i = 0; i < m_surface.number_of_patches(); ++i) {
      Fold_state& state = m_face_states[m_surface.domain(i).face];
      state = (std::max)(state, folds.state(i));
    }
  }

  void measure_mesh()
  {
    if (!m_surface.prepare(m_progress))
      return;
    Distances_to_surface<Measured> distances(m_mesh.triangles, m_surface, negligible(), smallest_size(), m_progress);
    using Sample = typename Distances_to_surface<Measured>::Sample;
    Distance_sum sum(m_report.tolerance);
    const auto visit = [&](const Sample& sample) { attribute(sample.foot.face, sample.foot.distance); };
    distances.measure(number_of_mesh_samples(), sum, m_vertex_distances, visit);
    distances.search(number_of_steps(), visit);
    if (!m_progress.go_on())
      return;

    One_way_deviation& result = m_report.mesh_to_surface;
    const Sample& farthest = distances.farthest();
    sum.add_to(result);
    set_maximum(farthest.point, farthest.foot.point, farthest.foot.distance, distances.upper_bound(), result);
    m_report.mesh_to_surface_place = {{m_surface.compiled().indexing().face(farthest.foot.face),
                                       CGAL::to_double(farthest.foot.u), CGAL::to_double(farthest.foot.v)},
                                      m_reading.faces[farthest.triangle]};
  }

  void measure_curves()
  {
    measure_curves(Curve_kind::BORDER, m_report.free_edge);
    measure_curves(Curve_kind::CREASE, m_report.crease);
  }

  const std::vector<double>& vertex_distances() const { return m_vertex_distances; }
  double face_deviation(const std::size_t face) const { return m_face_deviations[face]; }
  Fold_state face_state(const std::size_t face) const { return m_face_states[face]; }

private:
  void measure_curves(const Curve_kind kind, std::optional<Curve_deviation<Graph, TriangleMesh>>& result)
  {
    Curve_measurement<Measured, TriangleMesh> measurement(m_mesh.triangles, m_reading, m_surface, kind, negligible(),
                                                          m_progress);
    if (measurement.is_possible())
      measurement.measure(
          m_report.tolerance, [&](const int face, const double distance) { attribute(face, distance); },
          result.emplace());
  }

  // Without a tolerance, nothing is doubtful.
  double reach_of_doubt() const
  {
    return m_report.tolerance < (std::numeric_limits<double>::infinity)() ? m_report.tolerance : 0;
  }

  // Distances that need not be told apart: a thousandth of a small tolerance.
  double negligible() const
  {
    constexpr double share = 1e-7;
    return share * m_extent;
  }

  // Of the cells that means are taken from: smaller ones have no weight in a mean.
  double smallest_size() const
  {
    constexpr double share = 1e-4;
    return share * m_extent;
  }

  // Enough for means. On the surface some per patch and triangle, but not without limit; on the mesh more, as distances
  // are largest next to sharp edges.
  double number_of_surface_samples() const
  {
    const double triangles = static_cast<double>(m_mesh.triangles.triangles.size()),
                 patches = static_cast<double>(m_surface.number_of_patches());
    return (std::max)(std::clamp(20 * patches + 2 * triangles, 20000., 60000.), 0.5 * triangles);
  }
  double number_of_mesh_samples() const
  {
    return (std::max)(100000., 0.5 * static_cast<double>(m_mesh.triangles.triangles.size()));
  }

  // Where distances are almost constant, the search would not end soon.
  std::size_t number_of_steps() const
  {
    constexpr double smallest_number = 60000;
    return static_cast<std::size_t>((std::max)(number_of_mesh_samples() / 2, smallest_number));
  }

  void attribute(const int face, const double distance)
  {
    m_face_deviations[face] = (std::max)(m_face_deviations[face], distance);
  }

  void set_maximum(const Triangle_set::Point_3& farthest, const Triangle_set::Point_3& closest, const double distance,
                   const double upper_bound, One_way_deviation& result) const
  {
    result.maximum = distance;
    result.upper_bound = upper_bound;
    result.extent = m_extent;
    result.farthest_point = farthest;
    result.closest_point = closest;
  }

  Place place_of(const Surface_sample& sample) const
  {
    const typename Measured::Domain& domain = m_surface.domain(sample.patch);
    const auto face = m_surface.compiled().indexing().face(domain.face);
    const double width = CGAL::to_double(m_surface.compiled().width(face)),
                 height = CGAL::to_double(m_surface.compiled().height(face));
    return {{face, (std::min)(domain.u + sample.s / domain.u_factor, width),
             (std::min)(domain.v + sample.t / domain.v_factor, height)},
            m_reading.faces[sample.foot.triangle]};
  }

  const Measured_mesh& m_mesh;
  const Triangle_reading<TriangleMesh>& m_reading;
  Measured& m_surface;
  Progress& m_progress;
  Report& m_report;
  double m_extent;
  std::vector<double> m_vertex_distances, m_face_deviations;
  std::vector<Fold_state> m_face_states;
};

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// measures the distances between a T-spline surface and a triangle mesh, both ways, and the angles between their
/// normals. They are distances in space, between a point of the one and the closest point of the other: no
/// parametrization is involved.
///
/// Distances are measured at points in all Bezier patches of the surface, and at all vertices, along edges and inside
/// of triangles of the mesh, as densely as the patches are next to them. Then the largest distance is searched by branch
/// and bound, until it is certain to 1 percent; where this would take too long, as for surfaces that are equally far
/// everywhere, `upper_bound` tells what is certain. Means are weighted by area.
///
/// If surface and mesh have borders, the free edges, these are measured against each other, too, as curves: where the
/// surface ends too early or too late, points inside are close to each other nevertheless.
///
/// Around extraordinary vertices the caps of `compile_T_spline()` are measured; how far they are from the surface,
/// `cap_deviation()` tells.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`, with which this is faster; their `FT` is `double` or
///   `long double`
/// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
/// \param surface \pre it is valid
/// \param mesh it may have borders, several components and degenerate faces. Vertices without faces do not count.
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///     \cgalParamExtra{Points of any kernel; the distances are computed in doubles.}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the distance that is allowed, by the longest side of the bounding box of the mesh; the report has
///       it as a length}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinite}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_is_data_map}
///     \cgalParamDescription{which faces are measured: the others only close holes, and no distance is taken from a point
///       of them, nor from a point of the surface whose closest point is on them; folds are looked for there, too}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`}
///     \cgalParamDefault{all}
///     \cgalParamExtra{The bounding box of the mesh is that of the faces that are measured.}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{which edges of the mesh the creases of the surface stand for: they are measured against each
///       other, as borders are}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%edge_descriptor` -> `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_distance_map}
///     \cgalParamDescription{receives the distance of each vertex of the mesh from the surface}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `double`}
///     \cgalParamDefault{none is written}
///     \cgalParamExtra{Written upon success, for the vertices of faces that are measured.}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_deviation_map}
///     \cgalParamDescription{receives the largest distance found of a point of the face from the mesh, and of a point
///       of the mesh whose closest point is in the face; likewise of the borders}
///     \cgalParamType{a model of `WritablePropertyMap`, face of the T-mesh -> `double`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_is_folded_map}
///     \cgalParamDescription{receives whether a face has a fold, doubtful places apart (`Normal_deviation`)}
///     \cgalParamType{a model of `WritablePropertyMap`, face of the T-mesh -> `bool`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the distances and angles, or why there are none. `Mesh_distance` tells the distances of other points from the
/// mesh. Complexity: for n triangles and patches, n log n as a rule.
template <typename Surface, typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_deviation_report<typename Surface::Graph, TriangleMesh>
measure_T_spline_deviation(const Surface& surface, const TriangleMesh& mesh,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Compiled = Compiled_T_spline<typename Surface::Graph, typename Surface::Kernel>;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  const auto distance_map = get_parameter(np, np_tags::vertex_distance_map);
  const auto deviation_map = get_parameter(np, np_tags::face_deviation_map);
  const auto fold_map = get_parameter(np, np_tags::face_is_folded_map);

  T_spline_deviation_report<typename Surface::Graph, TriangleMesh> report;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("preparation");
  const auto is_interrupted = [&] {
    if (!progress.go_on())
      report.status = T_spline_deviation_status::INTERRUPTED;
    return progress.is_interrupted();
  };
  internal::Triangle_set triangles;
  const auto reading = internal::read_triangle_set(mesh, point_map, np, triangles);
  report.status = reading.status;
  report.vertex = reading.vertex;
  report.face = reading.face;
  if (!report.success())
    return report;
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  const double tolerance = choose_parameter(get_parameter(np, np_tags::tolerance), infinity);
  report.tolerance = tolerance < infinity ? tolerance * triangles.extent() : infinity;
  if (is_interrupted())
    return report;
  const Compiled& compiled = internal::as_compiled(surface, progress);
  if (is_interrupted())
    return report;
  internal::Measured_surface<Compiled> measured(compiled, progress);
  if (is_interrupted())
    return report;
  if (measured.number_of_patches() == 0)
    report.status = T_spline_deviation_status::SURFACE_WITHOUT_FACES;
  else if (!measured.is_finite())
    report.status = T_spline_deviation_status::SURFACE_NOT_FINITE;
  if (!report.success())
    return report;

  const internal::Measured_mesh measured_mesh(std::move(triangles), progress);
  if (is_interrupted())
    return report;
  internal::Deviation_measurement<Compiled, TriangleMesh> measurement(measured_mesh, reading, measured, progress,
                                                                      report);
  progress.begin_stage("surface to mesh");
  measurement.measure_surface();
  if (is_interrupted())
    return report;
  progress.begin_stage("mesh to surface");
  measurement.measure_mesh();
  if (is_interrupted())
    return report;
  progress.begin_stage("border and creases");
  measurement.measure_curves();
  if (is_interrupted())
    return report;
  if constexpr (!internal::is_missing<decltype(distance_map)>)
    for (std::size_t i = 0; i < measurement.vertex_distances().size(); ++i)
      put(distance_map, reading.vertices[i], measurement.vertex_distances()[i]);
  for (int f = 0; f < compiled.indexing().number_of_faces(); ++f) {
    if constexpr (!internal::is_missing<decltype(deviation_map)>)
      put(deviation_map, compiled.indexing().face(f), measurement.face_deviation(f));
    if constexpr (!internal::is_missing<decltype(fold_map)>)
      put(fold_map, compiled.indexing().face(f), measurement.face_state(f) == internal::Fold_state::FOLDED);
  }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H
