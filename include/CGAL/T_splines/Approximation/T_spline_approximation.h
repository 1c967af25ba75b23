// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_H
#define CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_H

#include <CGAL/T_splines/Approximation/Mapped_mesh.h>
#include <CGAL/T_splines/Approximation/Surface_guidance.h>
#include <CGAL/T_splines/Approximation/Surface_T_mesh.h>
#include <CGAL/T_splines/Approximation/T_spline_approximation_report.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/match_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Similarity_map/align_seamless_map.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/cross_field_of_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The points of a map of any kernel, rounded to doubles.
template <typename VertexPointMap>
struct Point_in_doubles {
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  VertexPointMap points;

  Point_3 operator()(const typename boost::property_traits<VertexPointMap>::key_type v) const
  {
    return in_doubles<Point_3>(get(points, v));
  }
};

/// What a stage hands on to others: its visitor and its solver.
template <typename NamedParameters>
auto visitor_and_solver(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto result =
      CGAL::parameters::visitor(choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Progress_visitor()));
  if constexpr (is_missing<decltype(get_parameter(np, CGAL::internal_np::sparse_linear_solver))>)
    return result;
  else
    return result.sparse_linear_solver(
        std::ref(CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::sparse_linear_solver)));
}

} // namespace internal

/// \ingroup PkgTSplinesApproximation
/// The way from a triangle mesh to a T-spline surface, stage by stage ([CZ17]; [He06] for the fit):
///
/// 1. guidance: features, a cross field, its holonomy signature, few cones;
/// 2. the seamless similarity map with this signature, aligned to the field if there are features, and the exactly seamless
///    map;
/// 3. the T-mesh with halfedge knots: the motorcycle graph of the map, regularized, with the mesh on its faces;
/// 4. the fit, which refines the T-mesh.
///
/// Each stage needs the result of the one before; `compute_T_mesh()` runs all stages before the fit that have no result
/// yet, with their defaults. Between stages, results may be read, and replaced by what comes from elsewhere: by
/// `use_cross_field()`, `use_cones()`, `set_signature()` and `use_map()`. Stages that come later forget their results
/// then. With a T-mesh from elsewhere, begin with `fit_adaptive_T_spline()`. Each stage returns whether it has its result; if it has not, `report()` says why, with the elements of the mesh
/// concerned.
///
/// The named parameters of a stage are those of the function that it calls, the points of the mesh and the output maps
/// apart: these are the class's own.
/// \tparam TriangleMesh_ a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam VertexPointMap a model of `ReadablePropertyMap` with vertices as keys and points of any kernel, which are
///         rounded to doubles (default: the internal map of the mesh)
/// \tparam FT_ the exact number type of the map and the T-mesh
template <typename TriangleMesh_, typename VertexPointMap = CGAL::Default, typename FT_ = CGAL::Exact_rational>
class T_spline_approximation {
public:
  /// The given mesh.
  using TriangleMesh = TriangleMesh_;
  /// Number type of the exact map and of the knots.
  using FT = FT_;
  /// Kernel of the points, in doubles.
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  /// Vertex -> point of the given mesh.
  using Point_map =
      typename CGAL::Default::Get<VertexPointMap,
                                  typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::type;
  /// A holonomy signature of the mesh.
  using Signature = Holonomy_signature<TriangleMesh>;
  /// The refined mesh with its map.
  using Mapped = Mapped_mesh<TriangleMesh, FT>;
  /// The T-mesh, and the mesh on its faces.
  using Placed_T_mesh = Surface_T_mesh<typename Mapped::Mesh, FT>;
  /// The result.
  using Spline = T_spline<Kernel>;
  /// What was done.
  using Report = T_spline_approximation_report<TriangleMesh>;
  /// Face -> a direction of its cross.
  using Cross_field = typename Surface_guidance<TriangleMesh>::Cross_field;

  /// \param mesh a triangle mesh, of one or more components; it must outlive this object, unchanged
  explicit T_spline_approximation(const TriangleMesh& mesh)
    : T_spline_approximation(mesh, get(CGAL::vertex_point, mesh))
  {
  }
  /// \param mesh likewise
  /// \param points its points
  T_spline_approximation(const TriangleMesh& mesh, const Point_map& points)
    : m_mesh(mesh),
      m_points({points}),
      m_guidance(mesh)
  {
  }
  T_spline_approximation(const T_spline_approximation&) = delete; // results refer to each other
  T_spline_approximation& operator=(const T_spline_approximation&) = delete;

  /// The given mesh.
  const TriangleMesh& mesh() const { return m_mesh; }

  /// says which faces of the mesh the surface is fitted to and measured against; without this, all. The others only close
  /// holes, as those of `fill_holes()` do. To be called before the T-mesh is traced.
  /// \tparam FaceIsDataMap a model of `ReadablePropertyMap`, face of the mesh -> `bool`
  template <typename FaceIsDataMap>
  void set_data(const FaceIsDataMap is_data)
  {
    forget_T_mesh();
    m_is_data.emplace(get(CGAL::dynamic_face_property_t<bool>(), m_mesh));
    for (const auto f : faces(m_mesh))
      put(*m_is_data, f, get(is_data, f));
  }

  /// returns whether a face is one that the surface is fitted to and measured against.
  bool is_data(const typename boost::graph_traits<TriangleMesh>::face_descriptor f) const
  {
    return !m_is_data || get(*m_is_data, f);
  }

  const Report& report() const { return m_report; } ///< of the stages that were run

  /// \name Guidance
  /// @{

  /// says which edges of the mesh are features: a computed field follows them, and in the map they lie on isolines. All
  /// later stages forget their results.
  /// \param is_feature a model of `ReadablePropertyMap`, edge of the mesh -> `bool`; no face has two edges that are features
  ///   or on the border: see `refine_at_features()`
  template <typename EdgeIsFeatureMap>
  void set_features(const EdgeIsFeatureMap is_feature)
  {
    m_guidance = Surface_guidance<TriangleMesh>(m_mesh);
    m_guidance.set_features(is_feature);
    forget_map();
  }

  /// computes a cross field and its signature: `compute_smooth_cross_field()`, or with features
  /// `compute_feature_aligned_cross_field()`; and `holonomy_signature_of_cross_field()`. The cones of the field stay, unless
  /// `reduce_cones()` follows.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool compute_cross_field(const NamedParameters& np = CGAL::parameters::default_values())
  {
    const auto with_matchings = parameters::halfedge_matching_map(m_guidance.matchings(), with_points(np));
    bool is_computed = false;
    if (m_guidance.has_features()) {
      m_report.feature_field =
          compute_feature_aligned_cross_field(m_mesh, m_guidance.features(), m_guidance.cross_field(), with_matchings);
      if (m_report.feature_field.status == Feature_aligned_field_status::INVALID_CORNERS)
        m_report.signature = m_report.feature_field.corners;
      is_computed = ended(m_report.feature_field, m_report.feature_field.mesh, Status::INVALID_SIGNATURE);
    }
    else {
      m_report.cross_field = compute_smooth_cross_field(m_mesh, m_guidance.cross_field(), with_matchings);
      if (m_report.cross_field.status == Smooth_cross_field_status::INVALID_CORNERS)
        m_report.signature = m_report.cross_field.corners;
      is_computed = ended(m_report.cross_field, m_report.cross_field.mesh, Status::INVALID_SIGNATURE);
    }
    return is_computed && use_own_field(np);
  }

  /// takes a given field and its signature: `holonomy_signature_of_cross_field()`.
  template <typename CrossFieldMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool use_cross_field(const CrossFieldMap field, const NamedParameters& np = CGAL::parameters::default_values())
  {
    using CGAL::parameters::get_parameter;
    Signature signature;
    if (!set_checked(holonomy_signature_of_cross_field(m_mesh, field, signature, with_points(np)), signature, true))
      return false;
    for (const auto f : CGAL::make_range(faces(m_mesh))) {
      const auto& d = get(field, f);
      put(m_guidance.cross_field(), f,
          Kernel::Vector_3(CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z())));
    }
    const auto given = get_parameter(np, np_tags::halfedge_matching_map);
    if constexpr (internal::is_missing<decltype(given)>)
      match_cross_field(m_mesh, m_guidance.cross_field(), m_guidance.matchings(),
                        with_points(CGAL::parameters::default_values()));
    else
      for (const auto h : CGAL::make_range(halfedges(m_mesh))) // those of the halfedges of edges are read
        put(m_guidance.matchings(), h,
            h == halfedge(edge(h, m_mesh), m_mesh) ? get(given, h) : -get(given, opposite(h, m_mesh)));
    return true;
  }

  /// takes cones, and the loops nearest to the metric or with given numbers: `holonomy_signature_of_cones()`.
  template <typename ConeRange, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool use_cones(const ConeRange& cones, const NamedParameters& np = CGAL::parameters::default_values())
  {
    Signature signature;
    return set_checked(holonomy_signature_of_cones(m_mesh, cones, signature, with_points(np)), signature, false);
  }

  /// takes a signature as it is; that it is admissible is checked when the map is computed.
  void set_signature(const Signature& signature)
  {
    m_guidance.set_signature(signature, false);
    forget_map();
  }

  /// merges cones: `CGAL::T_splines::reduce_cones()`. With features, those between them, and the field follows; without, the
  /// field is given up.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool reduce_cones(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_guidance.has_signature())
      return lacks("a signature");
    forget_map();
    if (m_guidance.has_field() && m_guidance.has_features())
      m_report.cone_reduction = CGAL::T_splines::reduce_cones(
          m_mesh, m_guidance.signature(),
          parameters::cross_field_map(
              m_guidance.cross_field(),
              parameters::halfedge_matching_map(m_guidance.matchings(),
                                                with_points(np).edge_is_constrained_map(m_guidance.features()))));
    else {
      m_report.cone_reduction = CGAL::T_splines::reduce_cones(m_mesh, m_guidance.signature(), with_points(np));
      if (m_report.cone_reduction.number_of_merges > 0 || m_report.cone_reduction.number_of_splits > 0 ||
          m_report.cone_reduction.number_of_loop_turns > 0)
        m_guidance.forget_field();
    }
    return ended(m_report.cone_reduction, m_report.cone_reduction.signature.mesh, Status::CONE_REDUCTION_FAILED);
  }

  /// returns whether there is a signature.
  bool has_signature() const { return m_guidance.has_signature(); }
  const Signature& signature() const { return m_guidance.signature(); } ///< \pre `has_signature()`
  /// The cross field that was computed or given last.
  const Cross_field& cross_field() const { return m_guidance.cross_field(); }
  /// Features, field and signature.
  const Surface_guidance<TriangleMesh>& guidance() const { return m_guidance; }

  /// @}
  /// \name Map
  /// @{

  /// computes the seamless map of a refinement of the mesh: `compute_seamless_similarity_map()`.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool compute_map(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_guidance.has_signature())
      return lacks("a signature");
    forget_map();
    Mapped mapped;
    m_report.map = compute_seamless_similarity_map(
        m_mesh, m_guidance.signature(), mapped.mesh(), mapped.uv(),
        parameters::edge_is_cut_map(mapped.cut(), parameters::vertex_location_map(
                                                      mapped.locations(), parameters::halfedge_transition_map(
                                                                              mapped.transitions(), with_points(np)))));
    if (m_report.map.success())
      m_mapped = std::move(mapped);
    m_has_transitions = true;
    return ended(m_report.map, m_report.map.signature.mesh, Status::MAP_FAILED);
  }

  /// aligns the map to the cross field, with the features on isolines: `align_seamless_map()`. If the signature is not that of
  /// a cross field, the map keeps its directions, and its scale factors change as `scale_policy` says. Features that cannot be
  /// met are no constrained edges of the mapped mesh any more.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool align_map(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_mapped)
      return lacks("a map");
    forget_T_mesh();
    m_mapped->remove_map();
    const auto field = get(CGAL::dynamic_face_property_t<Kernel::Vector_3>(), m_mapped->mesh());
    const auto matchings = get(CGAL::dynamic_halfedge_property_t<int>(), m_mapped->mesh());
    if (m_guidance.has_field())
      m_guidance.carry(*m_mapped, field, matchings);
    else
      cross_field_of_map(m_mapped->mesh(), m_mapped->uv(), field, parameters::halfedge_matching_map(matchings));
    m_report.alignment = align_seamless_map(
        m_mapped->mesh(), field, m_mapped->uv(),
        parameters::halfedge_matching_map(matchings, np.edge_is_constrained_map(m_mapped->constrained_edges())));
    for (const auto e : m_report.alignment.edges_not_met)
      put(m_mapped->constrained_edges(), e, false);
    m_has_transitions = m_has_transitions && !m_report.alignment.success();
    return ended(m_report.alignment, Status::ALIGNMENT_FAILED,
                 [&] { return describe(m_report.alignment, m_mapped->mesh()); });
  }

  /// says that features need not lie on isolines: to be called where `align_map()` has failed and the map is to be taken as
  /// it is.
  void release_features()
  {
    if (m_mapped)
      for (const auto e : m_mapped->mesh().edges())
        put(m_mapped->constrained_edges(), e, false);
  }

  /// takes a map of the mesh itself, up to round-off, and makes it exact: `make_exactly_seamless()`. The mesh may have a
  /// border.
  /// \param uv halfedge of the mesh -> `Point_2`: the coordinates of its target in the chart of its face
  /// \param np named parameters of `make_exactly_seamless()`; `edge_is_constrained_map` is one of the edges of the mesh
  template <typename HalfedgeUVMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool use_map(const HalfedgeUVMap uv, const NamedParameters& np = CGAL::parameters::default_values())
  {
    using CGAL::parameters::get_parameter;
    forget_map();
    m_mapped.emplace();
    m_mapped->copy(m_mesh, Points(m_points), uv, get_parameter(np, CGAL::internal_np::edge_is_constrained));
    m_has_transitions = false;
    return make_present_map_exact(np);
  }

  /// makes the map exactly seamless: `make_exactly_seamless()`. Which edges of the mapped mesh are to lie on isolines,
  /// `edge_is_constrained_map` says, or without it `Mapped_mesh::constrained_edges()`.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool make_map_exact(const NamedParameters& np = CGAL::parameters::default_values())
  {
    using CGAL::parameters::get_parameter;
    if (!m_mapped)
      return lacks("a map");
    const auto is_constrained = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    if constexpr (!internal::is_missing<decltype(is_constrained)>)
      for (const auto e : m_mapped->mesh().edges())
        put(m_mapped->constrained_edges(), e, get(is_constrained, e));
    return make_present_map_exact(np);
  }

  /// runs the stages up to the exact map that have no result yet, with their defaults.
  /// \param np named parameters: `visitor` and `sparse_linear_solver`, for all of them
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool compute_exact_map(const NamedParameters& np = CGAL::parameters::default_values())
  {
    const auto common = internal::visitor_and_solver(np);
    const bool is_new = !m_guidance.has_signature() && !m_mapped;
    if (is_new && !(compute_cross_field(common) && reduce_cones(common)))
      return false;
    if (!m_mapped && !compute_aligned_map(common))
      return false;
    if (is_new && m_guidance.has_features() && !m_report.alignment.meets_constraints() &&
        m_report.cone_reduction.number_of_merges > 0 &&
        !(compute_cross_field(common) && compute_aligned_map(common))) // with more cones, more features can be met
      return false;
    return make_map_exact(common);
  }

  /// returns whether there is a map; whether it is exact, `mapped_mesh().has_map()` tells.
  bool has_map() const { return m_mapped.has_value(); }
  const Mapped& mapped_mesh() const { return *m_mapped; } ///< the refined mesh with its map; \pre `has_map()`

  /// hands out the refined mesh with its map. The T-mesh is forgotten. \pre `has_map()`
  Mapped take_mapped_mesh()
  {
    forget_T_mesh();
    Mapped result = std::move(*m_mapped);
    m_mapped.reset();
    return result;
  }

  /// @}
  /// \name T-mesh
  /// @{

  /// traces the motorcycle graph: `Surface_T_mesh::trace()`.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool trace_T_mesh(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_mapped || !m_mapped->has_map())
      return lacks("an exact map");
    forget_T_mesh();
    Placed_T_mesh t_mesh;
    const auto is_data = boost::make_function_property_map<typename Mapped::Mesh::Face_index>(
        [this](const typename Mapped::Mesh::Face_index f) {
          return !m_is_data || get(*m_is_data, m_mapped->origin(f, m_mesh));
        });
    m_report.motorcycle_graph = t_mesh.trace(m_mapped->map(), parameters::face_is_data_map(is_data, np));
    if (m_report.motorcycle_graph.success())
      m_t_mesh = std::move(t_mesh);
    return ended(m_report.motorcycle_graph, Status::TRACING_FAILED,
                 [&] { return describe(m_report.motorcycle_graph); });
  }

  /// makes the faces of the T-mesh squarer: `Surface_T_mesh::regularize()`.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool regularize_T_mesh(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_t_mesh)
      return lacks("a T-mesh");
    m_report.regularization = m_t_mesh->regularize(np);
    return ended(m_report.regularization, Status::TRACING_FAILED, [&] { return describe(m_report.regularization); });
  }

  /// finds the points and polylines of the T-mesh after `regularize_T_mesh()`: `Surface_T_mesh::place()`. The fit does
  /// not need them.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool place_T_mesh(const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_t_mesh || !m_mapped)
      return lacks("a T-mesh");
    const auto report = m_t_mesh->place(m_mapped->map(), np);
    return ended(report, Status::PLACEMENT_FAILED, [&] { return describe(report, m_t_mesh->t_mesh().graph()); });
  }

  /// runs the stages up to the regularized T-mesh that have no result yet, with their defaults.
  /// \param np named parameters: `visitor` and `sparse_linear_solver`, for all of them
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool compute_T_mesh(const NamedParameters& np = CGAL::parameters::default_values())
  {
    const auto common = internal::visitor_and_solver(np);
    const bool has_exact_map = m_mapped && m_mapped->has_map();
    return m_t_mesh ||
           ((has_exact_map || compute_exact_map(common)) && trace_T_mesh(common) && regularize_T_mesh(common));
  }

  /// returns whether there is a T-mesh.
  bool has_T_mesh() const { return m_t_mesh.has_value(); }
  /// The T-mesh, and the mesh on its faces. \pre `has_T_mesh()`
  Placed_T_mesh& t_mesh() { return *m_t_mesh; }
  /// The T-mesh, and the mesh on its faces. \pre `has_T_mesh()`
  const Placed_T_mesh& t_mesh() const { return *m_t_mesh; }

  /// @}
  /// \name Fit
  /// @{

  /// fits a T-spline surface, and refines the T-mesh until it is within the tolerance: `fit_adaptive_T_spline()`.
  /// \param tolerance by the longest side of the bounding box of the mesh
  /// \param spline is written upon success only
  /// \param np named parameters of `fit_adaptive_T_spline()`
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  bool fit(const double tolerance, Spline& spline, const NamedParameters& np = CGAL::parameters::default_values())
  {
    if (!m_t_mesh)
      return lacks("a T-mesh");
    const auto are_data =
        boost::make_function_property_map<typename boost::graph_traits<TriangleMesh>::face_descriptor>(
            [this](const typename boost::graph_traits<TriangleMesh>::face_descriptor f) { return is_data(f); });
    m_report.fit = fit_adaptive_T_spline(
        m_t_mesh->t_mesh(), m_t_mesh->surface(), m_mesh, tolerance, spline,
        parameters::face_is_data_map(are_data,
                                     with_points(np).edge_is_constrained_map(m_mapped->constrained_origins(m_mesh))));
    return ended(m_report.fit, Status::FIT_FAILED, [&] { return describe(m_report.fit, m_t_mesh->t_mesh().graph()); });
  }

  /// @}

private:
  using Status = T_spline_approximation_status;
  using Data_map = typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<bool>>::const_type;
  using Points =
      boost::function_property_map<internal::Point_in_doubles<Point_map>,
                                   typename boost::graph_traits<TriangleMesh>::vertex_descriptor, Kernel::Point_3>;

  bool fail(const Status status, const std::string& reason)
  {
    m_report.status = status;
    m_report.reason = reason;
    return false;
  }

  bool succeed()
  {
    m_report.status = Status::SUCCESS;
    m_report.reason.clear();
    return true;
  }

  bool lacks(const std::string& what)
  {
    return fail(Status::MISSING_RESULT, "there is not yet " + what + ": run the stage before, or compute_T_mesh()");
  }

  // How a stage ended. \param reason says why it failed
  template <typename StageReport, typename Reason>
  bool ended(const StageReport& report, const Status failure, const Reason& reason)
  {
    if (report.success())
      return succeed();
    return fail(report.status == std::decay_t<decltype(report.status)>::INTERRUPTED ? Status::INTERRUPTED : failure,
                reason());
  }

  // The same, for a stage that checks the mesh.
  template <typename StageReport>
  bool ended(const StageReport& report, const Triangle_mesh_report<TriangleMesh>& mesh, const Status failure)
  {
    if (report.status == std::decay_t<decltype(report.status)>::INVALID_MESH) {
      m_report.mesh = mesh;
      return fail(Status::INVALID_MESH, describe(mesh, m_mesh));
    }
    return ended(report, failure, [&] { return description(report); });
  }

  template <typename StageReport>
  std::string description(const StageReport& report) const
  {
    if constexpr (std::is_same<StageReport, Similarity_map_report<TriangleMesh>>::value)
      return describe(report, m_mesh, CGAL::parameters::vertex_point_map(Points(m_points)));
    else
      return describe(report, m_mesh);
  }

  // The signature of the cross field that was computed.
  template <typename NamedParameters>
  bool use_own_field(const NamedParameters& np)
  {
    Signature signature;
    return set_checked(
        holonomy_signature_of_cross_field(m_mesh, m_guidance.cross_field(), signature,
                                          parameters::halfedge_matching_map(m_guidance.matchings(), with_points(np))),
        signature, true);
  }

  // With features the map is aligned; if it cannot be, it stays as it is, and has no constrained edges.
  template <typename NamedParameters>
  bool compute_aligned_map(const NamedParameters& np)
  {
    if (!compute_map(np) || !m_guidance.has_features() || !m_guidance.has_field())
      return m_mapped.has_value();
    if (!align_map(np)) {
      if (m_report.status == Status::INTERRUPTED)
        return false;
      release_features();
    }
    return succeed();
  }

  bool set_checked(const Holonomy_signature_report<TriangleMesh>& report, const Signature& signature,
                   const bool is_that_of_field)
  {
    m_report.signature = report;
    if (report.success()) {
      m_guidance.set_signature(signature, is_that_of_field);
      forget_map();
    }
    return ended(report, report.mesh, Status::INVALID_SIGNATURE);
  }

  void forget_map()
  {
    forget_T_mesh();
    m_mapped.reset();
  }
  void forget_T_mesh()
  {
    m_t_mesh.reset();
    m_report.fit = {};
  }

  // The named parameters of a stage, with the points of the mesh.
  template <typename NamedParameters>
  auto with_points(const NamedParameters& np) const
  {
    return np.vertex_point_map(Points(m_points));
  }

  template <typename NamedParameters>
  bool make_present_map_exact(const NamedParameters& np)
  {
    forget_T_mesh();
    m_report.exact_map = make_exactly_seamless(m_mapped->mesh(), m_mapped->uv(), m_mapped->reset_map(),
                                               np.edge_is_constrained_map(m_mapped->constrained_edges()));
    if (!m_report.exact_map.success())
      m_mapped->remove_map();
    else if (!m_has_transitions)
      m_mapped->take_transitions();
    return ended(m_report.exact_map, Status::EXACT_MAP_FAILED,
                 [&] { return describe(m_report.exact_map, m_mapped->mesh()); });
  }

  const TriangleMesh& m_mesh;
  internal::Point_in_doubles<Point_map> m_points;
  Surface_guidance<TriangleMesh> m_guidance;
  std::optional<Data_map> m_is_data; // all, if there is none
  std::optional<Mapped> m_mapped;
  bool m_has_transitions = false; // `m_mapped` has those of its map, before that is exact
  std::optional<Placed_T_mesh> m_t_mesh;
  Report m_report;
};

/// \cond
template <typename TriangleMesh>
T_spline_approximation(const TriangleMesh&) -> T_spline_approximation<TriangleMesh>;
template <typename TriangleMesh, typename VertexPointMap>
T_spline_approximation(const TriangleMesh&, const VertexPointMap&)
    -> T_spline_approximation<TriangleMesh, VertexPointMap>;
/// \endcond

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_H
