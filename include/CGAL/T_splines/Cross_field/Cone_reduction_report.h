// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CONE_REDUCTION_REPORT_H
#define CGAL_T_SPLINES_CROSS_FIELD_CONE_REDUCTION_REPORT_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>

#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// How the reduction of cones ended.
enum class Cone_reduction_status {
  REDUCED,           ///< the signature has no more cones than asked for
  LIMIT_UNREACHABLE, ///< the theorem of Gauss and Bonnet demands more cones; the signature has as few as possible
  INVALID_MESH,      ///< the mesh is refused: see `signature.mesh`
  INVALID_SIGNATURE, ///< the signature is refused: see `signature`
  SOLVER_FAILED,     ///< the linear solver refused the system
  INTERRUPTED        ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Cone_reduction_status status)
{
  switch (status) {
  case Cone_reduction_status::REDUCED: return "the cones were reduced";
  case Cone_reduction_status::LIMIT_UNREACHABLE:
    return "the surface cannot do with so few cones; there are as few as possible";
  case Cone_reduction_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Cone_reduction_status::INVALID_SIGNATURE: return "the holonomy signature is not admissible on this mesh";
  case Cone_reduction_status::SOLVER_FAILED: return "the linear solver failed";
  case Cone_reduction_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// What `reduce_cones()` did and how it ended. The numbers have a meaning if the signature was written.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Cone_reduction_report {
  Cone_reduction_status status = Cone_reduction_status::REDUCED; ///< how it ended

  Holonomy_signature_report<TriangleMesh> signature; ///< the check of the input

  int number_of_cones_before = 0;   ///< of the signature that was given
  int number_of_cones = 0;          ///< afterwards
  int number_of_loop_turns = 0;     ///< quarter turns by which numbers of loops were changed, without merges
  int number_of_splits = 0;         ///< quarter turns that cones gave away or got, without merges
  int number_of_merges = 0;         ///< each made one or two cones regular
  double energy_before = 0;         ///< the energy that `reduce_cones()` explains; dimensionless
  double energy = 0;                ///< afterwards
  double largest_energy_change = 0; ///< of a merge, or 0 if no merge raised the energy

  /// returns whether `status` tells of success.
  bool success() const { return status == Cone_reduction_status::REDUCED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says; of an input that is refused, why. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Cone_reduction_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  switch (report.status) {
  case Cone_reduction_status::INVALID_MESH:
  case Cone_reduction_status::INVALID_SIGNATURE: return describe(report.signature, mesh);
  case Cone_reduction_status::LIMIT_UNREACHABLE:
    return "the surface cannot do with so few cones; the fewest possible are " + std::to_string(report.number_of_cones);
  default: return message(report.status);
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_CONE_REDUCTION_REPORT_H
