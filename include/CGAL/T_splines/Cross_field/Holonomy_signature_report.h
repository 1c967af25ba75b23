// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_REPORT_H
#define CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_REPORT_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// What is wrong with a holonomy signature, or with what it is made from.
enum class Holonomy_signature_status {
  VALID,                 ///< the signature is admissible
  INVALID_MESH,          ///< the mesh is refused: see `mesh`
  INVALID_FIELD,         ///< the field has no direction at `face`: zero, not a number, or perpendicular to the face
  NULL_VERTEX,           ///< cone or corner number `index` has no vertex
  FOREIGN_VERTEX,        ///< the vertex of cone or corner number `index` is not one of the mesh, or not any more
  CONE_ON_BORDER,        ///< `vertex`, of cone number `index`, is on the border: it can be a corner
  CORNER_INSIDE,         ///< `vertex`, of corner number `index`, is not on the border: it can be a cone
  DUPLICATE_CONE,        ///< `vertex` is given twice; cone or corner number `index` repeats it
  NON_POSITIVE_CONE,     ///< `vertex` has the number `actual` < 1 of quarter turns
  SINGLE_TRIANGLE,       ///< `component` is the triangle `face` alone: no signature is admissible on it
  GAUSS_BONNET_VIOLATED, ///< the sum of 4 - k_v and 2 - k_b over the vertices of `component` is `actual` instead of
                         ///< `expected`
  WRONG_NUMBER_OF_LOOPS, ///< `component` has `actual` loops instead of `expected`
  WRONG_NUMBER_OF_TURNS, ///< `actual` loop turning numbers are given instead of `expected`
  INVALID_LOOP,          ///< loop number `index` is not a closed strip of faces that never turns back
  FOREIGN_LOOP,          ///< a halfedge of loop number `index` is not one of the mesh, or not any more
  DEPENDENT_LOOPS,       ///< the loops of `component` do not generate its homology
  WRONG_NUMBER_OF_ARCS,  ///< `component` has `actual` arcs instead of `expected`
  INVALID_ARC,           ///< arc number `index` is not a strip of faces from border to border that never turns back
  FOREIGN_ARC,           ///< a halfedge of arc number `index` is not one of the mesh, or not any more
  DEPENDENT_ARCS,        ///< the arcs of `component` do not join the curves of its border
  VERTEX_NOT_INTEGER,    ///< the turns around `vertex` are not a multiple of pi/2 within 1e-6
  LOOP_NOT_INTEGER,      ///< the turns along loop number `index` are not a multiple of pi/2 within 1e-6
  ARC_NOT_INTEGER,       ///< the turns along arc number `index` are not a multiple of pi/2 within 1e-6
  CORNERS_NOT_MET,   ///< the field makes `actual` quarter turns at `vertex`, on the border, where the corners that are
                     ///< given say `expected`, and no inner vertex can make up for it
  FIELD_NOT_ALIGNED, ///< the field does not follow the border at `halfedge`: it is off by `deviation`
  INTERRUPTED        ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Holonomy_signature_status status)
{
  switch (status) {
  case Holonomy_signature_status::VALID: return "the signature is admissible";
  case Holonomy_signature_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Holonomy_signature_status::INVALID_FIELD: return "the field has no direction in a face";
  case Holonomy_signature_status::NULL_VERTEX: return "a cone or corner has no vertex";
  case Holonomy_signature_status::CONE_ON_BORDER: return "a cone is on the border; make it a corner";
  case Holonomy_signature_status::CORNER_INSIDE: return "a corner is not on the border; make it a cone";
  case Holonomy_signature_status::FOREIGN_VERTEX:
    return "a cone or corner has a vertex that the mesh does not have; the signature belongs to another mesh, or the "
           "mesh was edited";
  case Holonomy_signature_status::DUPLICATE_CONE: return "a vertex is given as a cone, or as a corner, twice";
  case Holonomy_signature_status::NON_POSITIVE_CONE: return "a vertex has fewer than one quarter turn";
  case Holonomy_signature_status::SINGLE_TRIANGLE:
    return "a component is a single triangle: a border turns by four quarters, which three corners cannot";
  case Holonomy_signature_status::GAUSS_BONNET_VIOLATED:
    return "the cones and corners of a component violate the Gauss-Bonnet theorem: 4 - k of its cones and 2 - k of its "
           "corners must sum up to four times the Euler characteristic";
  case Holonomy_signature_status::WRONG_NUMBER_OF_LOOPS: return "a component has not as many loops as twice its genus";
  case Holonomy_signature_status::WRONG_NUMBER_OF_TURNS: return "there are not as many turning numbers as loops";
  case Holonomy_signature_status::INVALID_LOOP: return "a loop is not a closed strip of faces";
  case Holonomy_signature_status::FOREIGN_LOOP:
    return "a loop has a halfedge that the mesh does not have; the signature belongs to another mesh, or the mesh was "
           "edited";
  case Holonomy_signature_status::DEPENDENT_LOOPS: return "the loops of a component do not generate its homology";
  case Holonomy_signature_status::WRONG_NUMBER_OF_ARCS:
    return "a component has not one arc fewer than its border has closed curves";
  case Holonomy_signature_status::INVALID_ARC: return "an arc is not a strip of faces from border to border";
  case Holonomy_signature_status::FOREIGN_ARC:
    return "an arc has a halfedge that the mesh does not have; the signature belongs to another mesh, or the mesh was "
           "edited";
  case Holonomy_signature_status::DEPENDENT_ARCS:
    return "the arcs of a component do not join all the closed curves of its border";
  case Holonomy_signature_status::VERTEX_NOT_INTEGER: return "the field does not close up around a vertex";
  case Holonomy_signature_status::LOOP_NOT_INTEGER: return "the field does not close up along a loop";
  case Holonomy_signature_status::ARC_NOT_INTEGER: return "the field does not close up along an arc";
  case Holonomy_signature_status::CORNERS_NOT_MET:
    return "the field does not have the corners that are given, and no inner vertex can make up for it; where the mesh "
           "is "
           "too coarse for them, it needs smaller triangles at the border";
  case Holonomy_signature_status::FIELD_NOT_ALIGNED: return "the field does not follow the border";
  case Holonomy_signature_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// The result of making or checking a holonomy signature: what is wrong, and where. Members that `status` does not mention have
/// no meaning.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Holonomy_signature_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  Holonomy_signature_status status = Holonomy_signature_status::VALID; ///< what is wrong
  Triangle_mesh_report<TriangleMesh> mesh;                             ///< the check of the mesh
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();   ///< a cone, or where the field does not close up
  /// Of SINGLE_TRIANGLE, GAUSS_BONNET_VIOLATED and of wrong numbers of, or dependent, loops and arcs: the first face of the component.
  typename Traits::face_descriptor face = Traits::null_face();
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< of an edge on the border
  std::size_t index = 0;                                                   ///< of a cone, corner, loop or arc
  bool is_corner = false;  ///< whether `index` is that of a corner, not of a cone
  int component = 0;       ///< components are numbered in the order of their first faces
  int expected = 0;        ///< what `status` compares with
  int actual = 0;          ///< what was found
  bool is_aligned = false; ///< whether the field did not follow the border, and stands for one that does
  double deviation = 0; ///< largest distance, in quarter turns, of a computed number from an integer, or of the field
                        ///< from the direction of the border

  /// returns whether `status` tells of success.
  bool success() const { return status == Holonomy_signature_status::VALID; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the mesh.
template <typename TriangleMesh>
std::string describe(const Holonomy_signature_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  using Status = Holonomy_signature_status;
  std::string text = message(report.status);
  const std::string numbers = " is " + std::to_string(report.actual) + " instead of " + std::to_string(report.expected);
  const std::string counted = ", counted from 0";
  switch (report.status) {
  case Status::VALID:
  case Status::INTERRUPTED: break;
  case Status::INVALID_MESH: return describe(report.mesh, mesh);
  case Status::INVALID_FIELD: text += ": " + internal::face_in_words(report.face, mesh) + counted; break;
  case Status::NULL_VERTEX:
  case Status::FOREIGN_VERTEX:
    text += (report.is_corner ? ": corner " : ": cone ") + std::to_string(report.index) + counted;
    break;
  case Status::CONE_ON_BORDER:
  case Status::CORNER_INSIDE:
  case Status::DUPLICATE_CONE:
  case Status::VERTEX_NOT_INTEGER: text += ": " + internal::vertex_in_words(report.vertex, mesh) + counted; break;
  case Status::NON_POSITIVE_CONE:
    text += ": " + internal::vertex_in_words(report.vertex, mesh) + counted +
            ", has k = " + std::to_string(report.actual) + "; it needs at least 1";
    break;
  case Status::SINGLE_TRIANGLE:
    text += ": " + internal::face_in_words(report.face, mesh) + counted + "; remove it, or divide it";
    break;
  case Status::CORNERS_NOT_MET:
    text += ": " + internal::vertex_in_words(report.vertex, mesh) + counted +
            ", has k = " + std::to_string(report.actual) + " instead of " + std::to_string(report.expected);
    break;
  case Status::GAUSS_BONNET_VIOLATED:
    text += ": the sum over component " + std::to_string(report.component) + numbers + " (off by " +
            std::to_string(report.actual - report.expected) + "); " +
            (report.actual > report.expected ? "raise" : "lower") + " its numbers k by " +
            std::to_string(std::abs(report.actual - report.expected)) + " in all";
    break;
  case Status::WRONG_NUMBER_OF_ARCS:
  case Status::WRONG_NUMBER_OF_LOOPS:
    text += ": the number in component " + std::to_string(report.component) + numbers;
    break;
  case Status::WRONG_NUMBER_OF_TURNS: text += ": the number of turning numbers" + numbers; break;
  case Status::INVALID_LOOP:
  case Status::FOREIGN_LOOP:
  case Status::LOOP_NOT_INTEGER: text += ": loop " + std::to_string(report.index) + counted; break;
  case Status::INVALID_ARC:
  case Status::ARC_NOT_INTEGER:
  case Status::FOREIGN_ARC: text += ": arc " + std::to_string(report.index) + counted; break;
  case Status::FIELD_NOT_ALIGNED:
    text += ": it is off by " + std::to_string(static_cast<int>(std::lround(90 * report.deviation))) + " degrees at " +
            internal::edge_in_words(report.halfedge, mesh) + counted + "; give a field that follows it, or none";
    break;
  case Status::DEPENDENT_ARCS:
  case Status::DEPENDENT_LOOPS: text += ": component " + std::to_string(report.component) + counted; break;
  }
  return text;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_REPORT_H
