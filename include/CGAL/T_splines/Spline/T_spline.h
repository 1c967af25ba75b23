// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_H

#include <CGAL/T_splines/Spline/Control_point_map.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// A T-spline, as one value: a T-mesh with halfedge knots, whose points are the control points, and their weights. A
/// model of `TMesh`. Copies have their own T-mesh, control points and weights.
///
/// It is data: `surface()` makes of it what can be evaluated, `compile_T_spline()` patches of that. `read_t_mesh()` and
/// `write_t_mesh()` read and write it, weights included.
///
/// \cgalModels{TMesh}
///
/// \tparam Kernel_ a CGAL kernel
template <typename Kernel_ = CGAL::Exact_predicates_inexact_constructions_kernel>
class T_spline {
  using Value = T_mesh<typename Kernel_::Point_3, typename Kernel_::FT>;

public:
  using Kernel = Kernel_;                                          ///< the kernel
  using FT = typename Kernel::FT;                                  ///< number type
  using Point_3 = typename Kernel::Point_3;                        ///< a point in space
  using Graph = typename Value::Graph;                             ///< the T-mesh's graph
  using Knot_map = typename Value::Knot_map;                       ///< halfedge -> knot interval
  using Corner_map = typename Value::Corner_map;                   ///< halfedge -> whether the face turns at its target
  using Crease_map = typename Value::Crease_map;                   ///< edge -> whether it is a crease
  using vertex_descriptor = typename Value::vertex_descriptor;     ///< a vertex of the graph
  using halfedge_descriptor = typename Value::halfedge_descriptor; ///< a halfedge of the graph
  using face_descriptor = typename Value::face_descriptor;         ///< a face of the graph
  using Weight_map = typename Graph::template Property_map<vertex_descriptor, FT>; ///< vertex -> weight
  /// vertex -> control point with weight.
  using Control_points =
      Control_point_map<typename Graph::template Property_map<vertex_descriptor, Point_3>, Weight_map>;
  /// the surface that can be evaluated.
  using Surface = T_spline_surface<Const_T_mesh_view_of<Value>, Control_points, Kernel>;

  /// is empty.
  T_spline() { find_weights(); }
  /// \param t_mesh its points are the control points
  explicit T_spline(const Value& t_mesh) : m_t_mesh(t_mesh) { find_weights(); }
  /// copies T-mesh, control points and weights.
  T_spline(const T_spline& other) : T_spline(other.m_t_mesh) {}
  /// copies T-mesh, control points and weights.
  T_spline& operator=(const T_spline& other)
  {
    m_t_mesh = other.m_t_mesh;
    find_weights();
    return *this;
  }

  Graph& graph() { return m_t_mesh.graph(); }             ///< its points are the control points
  const Graph& graph() const { return m_t_mesh.graph(); } ///< likewise
  /// returns the knot intervals.
  const Knot_map& knots() const { return m_t_mesh.knots(); }
  /// returns where the faces have their corners.
  const Corner_map& corners() const { return m_t_mesh.corners(); }
  /// returns which edges are creases.
  const Crease_map& creases() const { return m_t_mesh.creases(); }
  const Weight_map& weights() const { return m_weights; } ///< of new vertices 1

  /// returns the number of vertices of the T-mesh.
  std::size_t number_of_control_points() const { return graph().number_of_vertices(); }
  /// returns the map of control points, vertex -> point with weight.
  Control_points control_points() const { return Control_points(graph().points(), m_weights); }

  /// returns the surface, which refers to this and follows its changes as `T_spline_surface` says.
  Surface surface() const { return Surface(*this, control_points()); }

private:
  // Of this graph, not of the one that was copied.
  void find_weights() { m_weights = graph().template add_property_map<vertex_descriptor, FT>("v:weight", FT(1)).first; }

  Value m_t_mesh;
  Weight_map m_weights;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_H
