// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_SURFACE_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_SURFACE_H

#include <CGAL/T_splines/Spline/Control_point_map.h>
#include <CGAL/T_splines/Spline/Surface_jet.h>
#include <CGAL/T_splines/Spline/T_spline_report.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/Spline/internal/rational_jet.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// A basis function at a point: its vertex, its value, and its derivatives with respect to u and v of the face.
template <typename Graph, typename FT>
struct Basis_function_jet {
  typename boost::graph_traits<Graph>::vertex_descriptor vertex; ///< the vertex that the function belongs to
  FT value,                                                      ///< of the function
      du,                                                        ///< first derivative along u
      dv,                                                        ///< first derivative along v
      duu,                                                       ///< second derivative along u
      duv,                                                       ///< mixed derivative
      dvv;                                                       ///< second derivative along v
};

/// \ingroup PkgTSplinesSpline
/// A T-spline surface on a T-mesh with halfedge knots ([CZ17] section 4): bi-cubic, rational, C2 away from
/// extraordinary vertices and with a continuous tangent plane there (at those of valence 1 it is only continuous).
///
/// The point at (u, v) of a face is the sum of w_i B_i(u, v) P_i over the vertices, divided by that of w_i B_i(u, v)
/// (equation (1), with weights). The basis functions B_i are products of cubic B-splines, whose knots are found by rays
/// through the T-mesh (4.1.2). In a face at an extraordinary vertex the surface is the limit of Catmull-Clark
/// subdivision of the homogeneous control points, by Stam's evaluation. At a border the surface is clamped: its border
/// curves are cubic rational splines of the border vertices alone. At a corner of the border that turns inwards it has a
/// tangent plane; see the definition of "Border" in the user manual.
///
/// Along creases of the T-mesh it is only continuous: basis functions end there, and both sides have the control points
/// of the crease in common. They end naturally, with the second derivative zero, as Catmull-Clark surfaces do at
/// infinitely sharp edges (Biermann, Levin, Zorin 2000); so the curve of a crease depends on its own control points
/// alone. Where creases meet or end, each sector between them has ends by its number of quarter turns; see "Crease" in
/// the user manual.
///
/// What is reproduced: constants everywhere, as B_i / (sum of B_j) sum to 1. Polynomials only where the basis functions
/// sum to 1 by themselves and the T-mesh is locally standard, such as a grid: in general not even linear ones.
///
/// A face is [0, width] x [0, height] in units of its knot intervals, its origin is the corner where the side of
/// `halfedge(f)` begins, u runs along this side.
///
/// The constructor reads T-mesh and control points; after a change of control points, call `update_control_points()`;
/// after a change of the T-mesh, make a new surface. Evaluation may run in any number of threads.
/// \tparam TMesh a `T_mesh_view` of a `const` graph, which the constructor finds for any model of `TMesh` whose graph is
///        one of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; it may have a border
/// \tparam ControlPointMap a readable map, vertex -> control point: a point with `x()`, `y()`, `z()` (its weight is 1),
///         or what has `point()` and `weight()`, such as `Kernel::Weighted_point_3`; see `Control_point_map`
/// \tparam Kernel_ a CGAL kernel; with one whose `FT` is exact, positions and derivatives are exact
template <typename TMesh, typename ControlPointMap,
          typename Kernel_ = typename internal::Control_point_kernel<
              typename boost::property_traits<ControlPointMap>::value_type>::type>
class T_spline_surface {
public:
  using Graph = typename TMesh::Graph;           ///< the T-mesh's graph
  using Kernel = Kernel_;                        ///< the kernel
  using FT = typename Kernel::FT;                ///< number type
  using Point_3 = typename Kernel::Point_3;      ///< a point in space
  using Vector_3 = typename Kernel::Vector_3;    ///< a vector in space
  using Jet = Surface_jet<Kernel>;               ///< a point with its derivatives
  using Curvatures = Surface_curvatures<Kernel>; ///< the curvatures at a point
  using Place = T_mesh_place<Graph, FT>;         ///< a face, and a point in its frame
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor; ///< a vertex of the graph
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;     ///< a face of the graph

private:
  using Knot = typename TMesh::FT;
  using Basis = internal::T_spline_basis<FT>;
  using Cone_face = typename Basis::Cone_face;
  using Homogeneous = std::array<FT, 4>;
  using Homogeneous_jet = std::array<Homogeneous, 6>;

public:
  /// prepares the surface, if the T-mesh is spline compatible and the control points are finite with positive weights;
  /// `report()` tells. Complexity: linear in the number of pairs of a basis function and a face where it acts.
  /// \param t_mesh its graph must outlive the surface
  /// \param control_points copied
  /// \param np an optional sequence of named parameters among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{relative_tolerance}
  ///     \cgalParamDescription{as for `check_admissibility()`}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{`default_relative_tolerance`, 1e-9; 0 for exact number types}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  T_spline_surface(const TMesh& t_mesh, const ControlPointMap control_points,
                   const NamedParameters& np = CGAL::parameters::default_values())
    : m_control_point_map(control_points),
      m_indexing(std::make_shared<const internal::Mesh_indexing<Graph>>(t_mesh.graph()))
  {
    const auto visitor = internal::progress_visitor(np);
    internal::Progress progress(visitor);
    progress.begin_stage("T-spline surface");
    if (!internal::is_known_admissible(t_mesh, np, progress, m_report.compatibility)) {
      m_report.status =
          progress.is_interrupted() ? T_spline_status::INTERRUPTED : T_spline_status::NOT_SPLINE_COMPATIBLE;
      return;
    }
    internal::Spline_structure<Knot, FT> structure(*m_indexing, t_mesh, progress);
    const auto basis = std::make_shared<Basis>();
    internal::Spline_defect defect = internal::defect_before_supports(structure);
    if (!defect)
      defect = basis->build(structure);
    if (!progress.go_on()) {
      m_report.status = T_spline_status::INTERRUPTED;
      return;
    }
    if (defect) {
      m_report.status = T_spline_status::NOT_SPLINE_COMPATIBLE;
      internal::set_defect(structure.in_graph(defect), *m_indexing, m_report.compatibility);
      return;
    }
    m_basis = basis;
    update_control_points();
  }

  /// returns whether the surface can be evaluated, and if not, why.
  const T_spline_report<Graph>& report() const { return m_report; }
  /// returns whether the surface can be evaluated.
  bool is_valid() const { return m_report.success(); }

  /// returns the graph of the T-mesh.
  const Graph& graph() const { return m_indexing->graph(); }
  /// returns the number of vertices of the T-mesh.
  std::size_t number_of_control_points() const { return m_controls.size(); }

  /// reads the control points again. Complexity: linear. \return whether the surface can be evaluated; see `report()`
  bool update_control_points()
  {
    if (m_basis == nullptr)
      return false;
    m_report = T_spline_report<Graph>();
    m_controls.resize(m_indexing->number_of_vertices());
    for (int v = 0; v < m_indexing->number_of_vertices(); ++v) {
      m_controls[v] = internal::homogeneous<FT>(get(m_control_point_map, m_indexing->vertex(v)));
      check(v);
    }
    m_cone_coefficients.clear();
    std::vector<Homogeneous> controls;
    for (const Cone_face& face : m_basis->cone_faces()) {
      controls.clear();
      for (const int v : face.controls)
        controls.push_back(m_controls[v]);
      m_cone_coefficients.push_back(face.evaluator->project(controls));
    }
    return is_valid();
  }

  FT width(const face_descriptor f) const { return m_basis->t_mesh().width(index(f)); }   ///< largest u of a face
  FT height(const face_descriptor f) const { return m_basis->t_mesh().height(index(f)); } ///< largest v of a face

  /// returns whether an extraordinary vertex inside, not on the border, is a corner of `f`: there the surface is no
  /// polynomial.
  bool is_at_extraordinary_vertex(const face_descriptor f) const { return m_basis->cone_face_of(index(f)) >= 0; }

  /// returns the point at (u, v) of a face. \pre `is_valid()`; 0 <= u <= width,
  /// 0 <= v <= height, but for round-off
  ///
  /// Complexity: linear in the number of basis functions that act in the face.
  Point_3 position(const face_descriptor f, const FT& u, const FT& v) const
  {
    const Homogeneous_jet jet = homogeneous_jet<0>(checked_index(f, u, v), u, v);
    return internal::projected_point<Kernel>(jet[0]);
  }

  /// returns the point at (u, v) of a face with the first and second derivatives. \pre as for `position()`
  ///
  /// At an extraordinary vertex inside the derivatives are not defined; they are 0.
  Jet jet(const face_descriptor f, const FT& u, const FT& v) const
  {
    return internal::rational_jet<Kernel>(homogeneous_jet<2>(checked_index(f, u, v), u, v));
  }

  /// returns the unit normal, on the side from which faces are seen counter-clockwise; at extraordinary vertices of
  /// valence 2 or more its limit. The zero vector where it is not defined. \pre as for `position()`; `FT` has a square
  /// root
  Vector_3 unit_normal(const face_descriptor f, const FT& u, const FT& v) const
  {
    const int i = checked_index(f, u, v);
    const int c = m_basis->cone_face_of(i);
    if (c >= 0) {
      const Cone_face& face = m_basis->cone_faces()[c];
      const std::pair<FT, FT> p = face.to_unit_square(u, v);
      if (p.first <= FT(0) && p.second <= FT(0)) {
        const auto tangents = face.evaluator->tangents(m_cone_coefficients[c]);
        const Homogeneous limit = homogeneous_jet<0>(i, u, v)[0];
        return internal::rational_jet<Kernel>({limit, tangents[0], tangents[1], {}, {}, {}}).unit_normal();
      }
    }
    return internal::rational_jet<Kernel>(homogeneous_jet<1>(i, u, v)).unit_normal();
  }

  /// returns the curvatures and principal directions. \pre as for `position()`; du and dv are linearly independent,
  /// which excludes extraordinary vertices: curvatures have in general no limit there
  Curvatures curvatures(const face_descriptor f, const FT& u, const FT& v) const { return jet(f, u, v).curvatures(); }

  /// writes the points at a range of places (`T_mesh_place`, or what has `face`, `u` and `v`).
  template <typename PlaceRange, typename OutputIterator>
  OutputIterator positions(const PlaceRange& places, OutputIterator out) const
  {
    for (const auto& place : places)
      *out++ = position(place.face, place.u, place.v);
    return out;
  }

  /// writes the jets (`Jet`) at a range of places.
  template <typename PlaceRange, typename OutputIterator>
  OutputIterator jets(const PlaceRange& places, OutputIterator out) const
  {
    for (const auto& place : places)
      *out++ = jet(place.face, place.u, place.v);
    return out;
  }

  /// writes the basis functions that act at a point (`Basis_function_jet<Graph, FT>`), each vertex once: the polynomial
  /// ones B_i, without weights. Divide by their sum for the rational form. \pre as for `position()`
  template <typename OutputIterator>
  OutputIterator basis_functions(const face_descriptor f, const FT& u, const FT& v, OutputIterator out) const
  {
    const int i = checked_index(f, u, v);
    // A basis function may act several times.
    std::map<int, internal::Function_jet<FT>> sums;
    const auto add = [&](const int vertex, const internal::Function_jet<FT>& jet) {
      const auto inserted = sums.emplace(vertex, jet);
      if (!inserted.second)
        for (int k = 0; k < 6; ++k)
          inserted.first->second[k] += jet[k];
    };
    const int c = m_basis->cone_face_of(i);
    if (c < 0)
      m_basis->template for_each_function<2>(i, u, v, add);
    else {
      const Cone_face& face = m_basis->cone_faces()[c];
      const std::pair<FT, FT> p = in_unit_square(face, u, v);
      std::vector<internal::Function_jet<FT>> jets;
      face.evaluator->basis(p.first, p.second, 2, jets);
      for (std::size_t k = 0; k < jets.size(); ++k) {
        internal::pull_back(face.to_unit_square, 2, jets[k]);
        add(face.controls[k], jets[k]);
      }
    }
    for (const auto& [vertex, jet] : sums)
      *out++ =
          Basis_function_jet<Graph, FT>{m_indexing->vertex(vertex), jet[0], jet[1], jet[2], jet[3], jet[4], jet[5]};
    return out;
  }

  /// \cond INTERNAL
  // What other headers of this room build on; not for users.
  const Basis& basis() const { return *m_basis; }
  const internal::T_mesh_arrays<FT>& t_mesh_arrays() const { return m_basis->t_mesh(); }
  const std::shared_ptr<const Basis>& shared_basis() const { return m_basis; }
  const internal::Mesh_indexing<Graph>& indexing() const { return *m_indexing; }
  const std::shared_ptr<const internal::Mesh_indexing<Graph>>& shared_indexing() const { return m_indexing; }
  const std::vector<Homogeneous>& homogeneous_control_points() const { return m_controls; }
  const std::vector<Homogeneous>& cone_coefficients(const int cone_face) const
  {
    return m_cone_coefficients[cone_face];
  }
  /// \endcond

private:
  int index(const face_descriptor f) const { return m_indexing->face_index(f); }

  int checked_index(const face_descriptor f, [[maybe_unused]] const FT& u, [[maybe_unused]] const FT& v) const
  {
    CGAL_precondition_msg(is_valid(), "the surface is not valid: see report()");
    const int i = index(f);
    CGAL_precondition_msg(is_in_side(u, m_basis->t_mesh().width(i)), "u is outside of the face");
    CGAL_precondition_msg(is_in_side(v, m_basis->t_mesh().height(i)), "v is outside of the face");
    return i;
  }

  // But for round-off: a side of several edges is as long as a sum, which depends on the order.
  [[maybe_unused]] static bool is_in_side(const FT& x, const FT& size)
  {
    const FT tolerance = internal::knot_tolerance(size);
    return x >= -tolerance && x <= size + tolerance;
  }

  void check(const int v)
  {
    if (!m_report.success())
      return;
    for (const FT& x : m_controls[v])
      if (!CGAL::is_finite(x))
        m_report.status = T_spline_status::CONTROL_POINT_NOT_FINITE;
    if (m_report.success() && !(m_controls[v][3] > FT(0)))
      m_report.status = T_spline_status::WEIGHT_NOT_POSITIVE;
    if (!m_report.success())
      m_report.vertex = m_indexing->vertex(v);
  }

  // Round-off may lead out of the square.
  static std::pair<FT, FT> in_unit_square(const Cone_face& face, const FT& u, const FT& v)
  {
    std::pair<FT, FT> p = face.to_unit_square(u, v);
    for (FT* const x : {&p.first, &p.second})
      *x = *x < FT(0) ? FT(0) : FT(1) < *x ? FT(1) : *x;
    return p;
  }

  template <int Order>
  Homogeneous_jet homogeneous_jet(const int f, const FT& u, const FT& v) const
  {
    constexpr int n = internal::number_of_derivatives_up_to(Order);
    Homogeneous_jet result;
    const int c = m_basis->cone_face_of(f);
    if (c >= 0) {
      const Cone_face& face = m_basis->cone_faces()[c];
      const std::pair<FT, FT> p = in_unit_square(face, u, v);
      face.evaluator->evaluate(m_cone_coefficients[c], p.first, p.second, Order, result);
      if constexpr (Order > 0)
        for (int k = 0; k < 4; ++k) {
          internal::Function_jet<FT> jet;
          for (int i = 0; i < n; ++i)
            jet[i] = result[i][k];
          internal::pull_back(face.to_unit_square, Order, jet);
          for (int i = 0; i < n; ++i)
            result[i][k] = jet[i];
        }
      return result;
    }
    for (int i = 0; i < n; ++i)
      result[i] = {FT(0), FT(0), FT(0), FT(0)};
    m_basis->template for_each_function<Order>(f, u, v, [&](const int vertex, const internal::Function_jet<FT>& jet) {
      const Homogeneous& p = m_controls[vertex];
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < 4; ++k)
          result[i][k] += jet[i] * p[k];
    });
    return result;
  }

  ControlPointMap m_control_point_map;
  std::shared_ptr<const internal::Mesh_indexing<Graph>> m_indexing;
  std::shared_ptr<const Basis> m_basis; // null if the T-mesh is not spline compatible
  std::vector<Homogeneous> m_controls;  // per vertex
  std::vector<std::vector<Homogeneous>> m_cone_coefficients;
  T_spline_report<Graph> m_report;
};

/// \cond INTERNAL
template <typename TMesh, typename ControlPointMap>
T_spline_surface(const TMesh&, ControlPointMap) -> T_spline_surface<Const_T_mesh_view_of<TMesh>, ControlPointMap>;

template <typename TMesh, typename ControlPointMap, typename NamedParameters>
T_spline_surface(const TMesh&, ControlPointMap, const NamedParameters&)
    -> T_spline_surface<Const_T_mesh_view_of<TMesh>, ControlPointMap>;
/// \endcond

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_SURFACE_H
