// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_computation.h"

#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/named_parameters.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>

namespace {

using Map_report = CGAL::T_splines::Similarity_map_report<Mesh>;

/// Calls the computation with the flip policy and the number type of the options.
template <typename Compute>
Map_report with_chosen_types(const Options& options, const Compute& compute)
{
  const auto with_number_type = [&](const auto policy) {
    switch (options.precision) {
    case Precision_choice::DOUBLE: return compute(policy, 0.);
    case Precision_choice::EXTENDED: return compute(policy, 0.L);
    case Precision_choice::QUAD: return compute(policy, boost::multiprecision::cpp_bin_float_quad(0));
    }
    return Map_report();
  };
  if (options.flips == Flips_choice::DELAUNAY)
    return with_number_type(CGAL::T_splines::Ideal_delaunay_flips());
  CGAL::T_splines::Degeneracy_flips policy;
  policy.delaunay = options.flips == Flips_choice::DEGENERACY;
  return with_number_type(policy);
}

/// The height of a triangle by its longest side.
double flatness(const Mesh& mesh, const Face face)
{
  const auto h = halfedge(face, mesh);
  const auto a = mesh.point(source(h, mesh)), b = mesh.point(target(h, mesh)),
             c = mesh.point(target(next(h, mesh), mesh));
  const double longest =
      std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / longest;
}

/// Says which triangle is the flattest, if it is so flat that it may be the cause of a failure.
std::string describe_flattest_triangle(const Mesh& mesh)
{
  constexpr double suspicious = 1e-6;
  Face flattest = *faces(mesh).begin();
  for (const Face face : faces(mesh))
    if (flatness(mesh, face) < flatness(mesh, flattest))
      flattest = face;
  if (!(flatness(mesh, flattest) < suspicious))
    return "";
  std::ostringstream text;
  text << "; triangle " << static_cast<std::size_t>(flattest) << " is nearly flat, its height is "
       << flatness(mesh, flattest) << " of its longest side: remove it by collapsing or flipping an edge of it";
  return text.str();
}

std::string describe_failure(const Map_report& report, const Mesh& mesh)
{
  std::ostringstream text;
  text << message(report.status) << " (residual " << report.residual << " after " << report.iterations << " iterations";
  if (report.vertex != Mesh::null_vertex())
    text << ", vertex " << static_cast<std::size_t>(report.vertex);
  if (report.loop != Map_report::no_loop)
    text << ", loop " << report.loop;
  if (report.face != Mesh::null_face())
    text << ", face " << static_cast<std::size_t>(report.face);
  const bool has_element =
      report.vertex != Mesh::null_vertex() || report.loop != Map_report::no_loop || report.face != Mesh::null_face();
  text << (has_element ? ", counted from 0)" : ")");
  if (report.hyperbolic_length > 0)
    text << "; the short loop closest to its limit has a scale factor of exp(" << report.scale_period
         << "), and the absolute value of the exponent must stay below " << report.hyperbolic_length;
  return text.str() + describe_flattest_triangle(mesh);
}

} // namespace

Failure compute_map(const Options& options, const Mesh& mesh, const Signature& signature,
                    Chosen_spd_solver_traits& solver, Progress& progress, Refined_map& refined, Map_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  const auto outputs = P::edge_is_cut_map(
      refined.is_cut, P::vertex_location_map(refined.location, P::halfedge_transition_map(refined.transition)));
  const Map_report report = with_chosen_types(options, [&](const auto policy, const auto zero) {
    const auto np =
        P::flip_policy(policy, P::number_type(zero, P::residual_tolerance(options.residual_tolerance, outputs)))
            .visitor(Progress_handle(progress))
            .number_of_iterations(options.max_iterations)
            .sparse_linear_solver(std::ref(solver));
    return CGAL::T_splines::compute_seamless_similarity_map(mesh, signature, refined.mesh, refined.uv, np);
  });
  progress.end_stage();

  figures.status = message(report.status);
  figures.converged = report.success();
  figures.residual = report.residual;
  figures.tolerance = options.residual_tolerance;
  figures.residual_history = report.residual_history;
  figures.iterations = report.iterations;
  figures.halvings = report.halvings;
  figures.factorizations = report.factorizations;
  figures.linear_iterations = report.linear_iterations;
  figures.delaunay_flips = report.delaunay_flips;
  figures.flips = report.flips;
  figures.mantissa_bits = report.mantissa_bits;
  figures.solver = options.solver == Solver_choice::LDLT ? "ldlt" : "cholmod";
  figures.flip_policy = options.flips == Flips_choice::DELAUNAY     ? "delaunay"
                        : options.flips == Flips_choice::DEGENERACY ? "degeneracy"
                                                                    : "degeneracy-only";
  if (report.success())
    return {};
  return {options.mesh + ": " + describe_failure(report, mesh)};
}
