// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_SURFACE_T_MESH_H
#define CGAL_T_SPLINES_APPROXIMATION_SURFACE_T_MESH_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/T_mesh/Carried_anchors.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>
#include <CGAL/T_splines/Tracing/carry_surface.h>
#include <CGAL/T_splines/Tracing/place_T_mesh.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/face_is_data.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Named_function_parameters.h>

#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesApproximation
/// A T-mesh and how it lies on a mapped mesh: what a fit begins with. `compute_T_mesh()` makes one. It can be moved but not
/// copied.
/// \tparam MappedMesh the mesh of the map
/// \tparam FT_ the number type of the map and of the knots
template <typename MappedMesh, typename FT_ = CGAL::Exact_rational>
class Surface_T_mesh {
public:
  /// Number type of the exact map and of the knots.
  using FT = FT_;
  /// Kernel of the points, in doubles.
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  /// The exactly seamless map.
  using Map = Seamless_map<MappedMesh, FT>;
  /// The T-mesh.
  using T_mesh = CGAL::T_splines::T_mesh<Kernel::Point_3, FT>;
  /// The graph of the T-mesh.
  using Graph = typename T_mesh::Graph;
  /// The mesh, on the T-mesh.
  using Surface = Carried_surface<Graph>;
  /// What holds the T-mesh to the map.
  using Roots = Carried_anchors<MappedMesh, Graph, FT>;
  /// Edge -> its course.
  using Polyline_map = typename Graph::template Property_map<typename Graph::Edge_index, std::vector<Kernel::Point_3>>;
  /// Follows changes of the T-mesh.
  using Observer = T_mesh_observer_pair<Roots, typename Surface::Observer>;

  /// is empty.
  Surface_T_mesh() : m_parts(std::make_unique<Parts>()) {}

  /// The T-mesh. Whoever changes it gives `observer()` to the operation.
  T_mesh& t_mesh() { return m_parts->t_mesh; }
  /// The T-mesh.
  const T_mesh& t_mesh() const { return m_parts->t_mesh; }

  /// The mesh, in the faces of the T-mesh: its points and triangles are the vertices and faces of the mapped mesh, in
  /// their order.
  const Surface& surface() const { return m_parts->surface; }

  /// The course of the edges on the mesh, from the source to the target of `halfedge(e, t_mesh().graph())`. Like the
  /// points of the T-mesh, they are those of the last `trace()` or `place()`.
  const Polyline_map& polylines() const { return m_parts->polylines; }

  /// returns what has to follow the changes of the T-mesh: give it to the operations.
  Observer observer() { return Observer(*m_parts->roots, m_parts->surface.observer()); }

  /// traces the motorcycle graph of a map, and carries the mesh on its faces.
  /// \param map made by `make_exactly_seamless()`
  /// \param np named parameters of `trace_motorcycle_graph()`, its output maps apart, and `face_is_data_map` of
  ///   `carry_surface()`
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Motorcycle_graph_report trace(const Map& map, const NamedParameters& np = CGAL::parameters::default_values())
  {
    using Anchor = T_mesh_anchor<MappedMesh, FT>;
    T_mesh& t = m_parts->t_mesh;
    auto anchors = t.graph().template add_property_map<typename Graph::Face_index, Anchor>("f:anchor").first;
    Motorcycle_graph_report report = trace_motorcycle_graph(
        map, t, parameters::edge_polyline_map(m_parts->polylines, parameters::face_anchor_map(anchors, np)));
    if (report.success()) {
      m_parts->surface =
          carry_surface(map, t, anchors,
                        parameters::face_is_data_map(internal::face_is_data_map<MappedMesh>(np),
                                                     CGAL::parameters::visitor(internal::progress_visitor(np))));
      if (m_parts->surface.triangles().empty()) {
        report.status = Motorcycle_graph_status::INTERRUPTED;
        m_parts = std::make_unique<Parts>();
        return report;
      }
      m_parts->roots.emplace(t.graph(), anchors);
    }
    t.graph().remove_property_map(anchors);
    return report;
  }

  /// makes the faces squarer, by `regularize_T_mesh()`, while the mesh stays on them.
  /// \param np its named parameters
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  T_mesh_regularization_report regularize(const NamedParameters& np = CGAL::parameters::default_values())
  {
    return regularize_T_mesh(m_parts->t_mesh, parameters::observer(observer(), np));
  }

  /// finds the points and polylines of the T-mesh after it has changed.
  /// \param map on which it was traced
  /// \param np named parameters of `place_T_mesh()`, its output maps apart
  /// \return whether it still fits on the mesh, as operations of the package leave it
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  T_mesh_placement_report<Graph> place(const Map& map, const NamedParameters& np = CGAL::parameters::default_values())
  {
    return place_T_mesh(map, m_parts->t_mesh, *m_parts->roots, parameters::edge_polyline_map(m_parts->polylines, np));
  }

private:
  struct Parts {
    T_mesh t_mesh;
    Polyline_map polylines =
        t_mesh.graph()
            .template add_property_map<typename Graph::Edge_index, std::vector<Kernel::Point_3>>("e:polyline")
            .first;
    Surface surface;
    std::optional<Roots> roots;
  };
  std::unique_ptr<Parts> m_parts; // their addresses last
};

/// \ingroup PkgTSplinesApproximation
/// makes the T-mesh of a map that a fit begins with: traces the motorcycle graph, carries the mesh on its faces, and
/// makes these squarer ([CZ17] sections 5, 7.5 and 8).
/// \param map made by `make_exactly_seamless()`; the result does not refer to it
/// \param result it must be empty; upon success, give its T-mesh and surface to `fit_adaptive_T_spline()`
/// \param np named parameters of `trace_motorcycle_graph()`, its output maps apart
/// \return whether there is a T-mesh, and why not. Complexity: that of the functions called
template <typename MappedMesh, typename FT, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Motorcycle_graph_report compute_T_mesh(const Seamless_map<MappedMesh, FT>& map, Surface_T_mesh<MappedMesh, FT>& result,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  Motorcycle_graph_report report = result.trace(map, np);
  if (report.success() && !result.regularize(CGAL::parameters::visitor(internal::progress_visitor(np))).success()) {
    report.status = Motorcycle_graph_status::INTERRUPTED;
    result = Surface_T_mesh<MappedMesh, FT>();
  }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_SURFACE_T_MESH_H
