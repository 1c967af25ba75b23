// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CHECK_ADMISSIBILITY_H
#define CGAL_T_SPLINES_T_MESH_CHECK_ADMISSIBILITY_H

#include <CGAL/T_splines/T_mesh/Admissibility_report.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/exactness.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

// Checks faces and vertices of a T-mesh one by one; each check writes the first defect into a report.
// \tparam TMesh a `T_mesh_view`
template <typename TMesh>
class Admissibility_check {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename TMesh::vertex_descriptor;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using face_descriptor = typename TMesh::face_descriptor;
  using FT = typename TMesh::FT;
  using Report = Admissibility_report<Graph>;

public:
  Admissibility_check(const TMesh& t_mesh, const double relative_tolerance)
    : m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_tolerance(is_exact_number_type<FT> ? 0. : relative_tolerance)
  {
  }

  bool check_face(const face_descriptor f, Report& report) const
  {
    const halfedge_descriptor any = halfedge(f, m_graph);
    halfedge_descriptor start = Traits::null_halfedge();
    int number_of_corners = 0;
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(any, m_graph)) {
      if (!check_knot(h, report))
        return false;
      if (m_t_mesh.is_corner(h)) {
        ++number_of_corners;
        start = next(h, m_graph);
      }
    }
    if (number_of_corners == 4)
      return check_sides(start, report);
    report.status = Admissibility_status::WRONG_CORNER_COUNT;
    report.face = f;
    report.number_of_corners = number_of_corners;
    return false;
  }

  // On the border the vertices have no cycle.
  // pre: all knots are positive and finite
  bool check_vertex(const vertex_descriptor v, Report& report) const
  {
    const halfedge_descriptor any = halfedge(v, m_graph);
    if (any == Traits::null_halfedge())
      return true;
    FT product(1);
    for (const halfedge_descriptor h : CGAL::halfedges_around_target(any, m_graph)) {
      const halfedge_descriptor o = opposite(h, m_graph);
      if (face(h, m_graph) == Traits::null_face() || face(o, m_graph) == Traits::null_face())
        return true;
      product *= FT(m_t_mesh.knot(h)) / FT(m_t_mesh.knot(o));
    }
    if (is_close(product, FT(1)))
      return true;
    report.status = Admissibility_status::CYCLE_CONDITION_VIOLATED;
    report.vertex = v;
    report.defect = CGAL::to_double(FT(product - FT(1)));
    return false;
  }

private:
  bool check_knot(const halfedge_descriptor h, Report& report) const
  {
    const FT knot = m_t_mesh.knot(h);
    const bool is_finite = CGAL::is_finite(knot);
    if (is_finite && knot > FT(0))
      return true;
    report.status = is_finite ? Admissibility_status::NON_POSITIVE_KNOT : Admissibility_status::KNOT_NOT_FINITE;
    report.halfedge = h;
    report.face = face(h, m_graph);
    if (is_finite)
      report.defect = CGAL::to_double(knot);
    return false;
  }

  bool check_sides(const halfedge_descriptor start, Report& report) const
  {
    std::array<FT, 4> length{FT(0), FT(0), FT(0), FT(0)};
    std::array<halfedge_descriptor, 4> first;
    halfedge_descriptor h = start;
    for (int side = 0; side < 4; ++side) {
      first[side] = h;
      bool is_last = false;
      while (!is_last) {
        length[side] += m_t_mesh.knot(h);
        is_last = m_t_mesh.is_corner(h);
        h = next(h, m_graph);
      }
    }
    for (int side = 0; side < 2; ++side) {
      if (is_close(length[side], length[side + 2]))
        continue;
      report.status = Admissibility_status::OPPOSITE_SIDES_DIFFER;
      report.face = face(start, m_graph);
      report.halfedge = first[side];
      report.defect = CGAL::to_double(FT((length[side] - length[side + 2]) / length[side + 2]));
      return false;
    }
    return true;
  }

  bool is_close(const FT& a, const FT& b) const
  {
    if constexpr (is_exact_number_type<FT>)
      return a == b;
    else
      return CGAL::abs(FT(a - b)) <= FT(m_tolerance) * (std::max)(a, b);
  }

  TMesh m_t_mesh;
  const Graph& m_graph;
  double m_tolerance;
};

// What `check_admissibility()` does; no stage is begun.
template <typename TMesh, typename NamedParameters>
Admissibility_report<T_mesh_graph<TMesh>> admissibility_report(const TMesh& t_mesh, const NamedParameters& np,
                                                               Progress& progress)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  constexpr std::size_t work = 10; // for an element
  const double tolerance = choose_parameter(get_parameter(np, np_tags::relative_tolerance), default_relative_tolerance);
  const Const_T_mesh_view_of<TMesh> view(t_mesh);
  const Admissibility_check check(view, tolerance);
  Admissibility_report<T_mesh_graph<TMesh>> report;
  progress.go_on();
  for (const auto f : CGAL::make_range(faces(view.graph()))) {
    if (!progress.go_on_after(work))
      break;
    if (!check.check_face(f, report))
      return report;
  }
  for (const auto v : CGAL::make_range(vertices(view.graph()))) {
    if (!progress.go_on_after(work))
      break;
    if (!check.check_vertex(v, report))
      return report;
  }
  if (progress.is_interrupted())
    report.status = Admissibility_status::INTERRUPTED;
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// checks whether halfedge knots are admissible on a T-mesh ([CZ17] sections 2.2 and 4).
///
/// Each interval must be positive and finite, each face must have four corners and opposite sides of equal length, and
/// around each inner vertex, cones included, the product of the ratios k(h) / k(opposite(h)) must be 1. Exact number
/// types are compared exactly, others to a relative tolerance.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph` and `VertexListGraph`, with or without border; its
///         knots are models of `Field` and `RealEmbeddable`
/// \param t_mesh the T-mesh
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{the relative difference of opposite sides, and of a product from 1, that counts as
///       round-off}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9}
///     \cgalParamExtra{For exact number types it is 0, whatever is given.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the first defect, faces before vertices: the status, the element and how large the defect is. The report
///         converts to `true` if there is none.
///
/// Complexity: linear.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Admissibility_report<T_mesh_graph<TMesh>>
check_admissibility(const TMesh& t_mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("admissibility");
  return internal::admissibility_report(t_mesh, np, progress);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CHECK_ADMISSIBILITY_H
