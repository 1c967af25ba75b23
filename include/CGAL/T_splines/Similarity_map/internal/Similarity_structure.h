// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_STRUCTURE_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_STRUCTURE_H

#include <CGAL/T_splines/Similarity_map/internal/Dual_loops.h>
#include <CGAL/T_splines/Similarity_map/internal/Mirror_pairs.h>
#include <CGAL/T_splines/Similarity_map/internal/Normal_coordinates.h>
#include <CGAL/T_splines/Similarity_map/internal/Triangle_angles.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How long an elementary function takes, about, in the units of `Progress::go_on_after()`.
template <typename FT>
inline constexpr std::size_t work_of_function = std::is_floating_point<FT>::value ? 1 : 40;

/// A piecewise flat metric up to similarity on an intrinsic triangulation: log-lengths and a closed 1-form that scales
/// them.
///
/// On a simply connected piece, where the form xi is d phi, the edge i-j has the length exp(lambda_ij + (phi_i + phi_j)
/// / 2). A triangle needs xi alone: its sides i, j, k are exp(lambda_i + (xi_k - xi_j) / 6), and cyclically, up to a
/// common factor. xi = d phi + sum_j c_j eta_j, where eta_j counts the passages of loop j over an edge with sign: the
/// coefficients phi, c keep their meaning when edges are flipped.
/// \tparam FT a floating-point type.
template <typename FT_>
struct Similarity_structure {
  using FT = FT_;
  using Index = Triangulation_connectivity::Index;

  Triangulation_connectivity mesh;
  std::vector<FT> log_length; ///< lambda per edge
  std::vector<FT> form;       ///< xi of the halfedge 2e, per edge e
  Dual_loops loops;
  Mirror_pairs pairs;                ///< of a double: faces whose numbers are the same, and those of their sides
  Normal_coordinates delaunay_edges; ///< of the triangulation that the iteration starts from; empty if not wanted
  FT delaunay_tolerance =
      32 * std::numeric_limits<FT>::epsilon(); ///< relative, of the Delaunay test: the round-off of the lengths
  std::vector<FT> log_penner; ///< Penner's coordinates of the starting metric; empty: `log_length` has them

  FT form_of(const Index h) const { return is_along_edge(h) ? form[edge_of(h)] : FT(-form[edge_of(h)]); }

  /// Log-lengths of `h`, `next(h)`, `previous(h)` up to a common summand.
  std::array<FT, 3> triangle_log_lengths(const Index h) const
  {
    const Index j = mesh.next(h), k = mesh.next(j);
    const FT xi_h = form_of(h), xi_j = form_of(j), xi_k = form_of(k);
    return {FT(log_length[edge_of(h)] + (xi_k - xi_j) / 6), FT(log_length[edge_of(j)] + (xi_h - xi_k) / 6),
            FT(log_length[edge_of(k)] + (xi_j - xi_h) / 6)};
  }

  /// sets xi = d phi + sum_j c_j eta_j. The coefficients are phi at the vertices, then c. \pre Those of a double are
  /// symmetric.
  void set_form(const std::vector<FT>& coefficients)
  {
    const Index number_of_vertices = mesh.number_of_vertices();
    for (Index e = 0; e < mesh.number_of_edges(); ++e) {
      form[e] = coefficients[mesh.target(halfedge_of_edge(e))] - coefficients[mesh.source(halfedge_of_edge(e))];
      loops.for_each_passage(e, [&](const int loop, const int sign) {
        if (sign > 0)
          form[e] += coefficients[number_of_vertices + loop];
        else
          form[e] -= coefficients[number_of_vertices + loop];
      });
    }
    for (Index e = 0; e < mesh.number_of_edges() && !pairs.is_empty(); ++e)
      if (loops.has_passages(e) && pairs.is_image_edge(mesh, e)) // the round-off of sums is no other there
        copy_form(pairs.image(halfedge_of_edge(e)), halfedge_of_edge(e));
  }

  /// Whether the edge is Delaunay in the scaled metric: the cosines of the two angles opposite to it have a sum of at
  /// least 0, up to round-off. It needs no triangle inequality. Of an edge between a triangle and itself, it says yes.
  bool is_delaunay(const Index e) const
  {
    using std::exp;
    if (mesh.face(halfedge_of_edge(e)) == mesh.face(opposite(halfedge_of_edge(e))))
      return true;
    FT sum(0), magnitude(0);
    for (const Index h : halfedges_of_edge(e)) {
      const std::array<FT, 3> l = triangle_log_lengths(h);
      const FT ratio = exp(FT(l[1] - l[2])), inverse = 1 / ratio, square = exp(FT(2 * l[0] - l[1] - l[2]));
      sum += (ratio + inverse) - square; // twice the cosine
      magnitude += ratio + inverse + square;
    }
    return sum >= -delaunay_tolerance * magnitude;
  }

  /// flips the edge of `h` with Ptolemy's formula on the unscaled lengths.
  void flip_ptolemy(const Index h)
  {
    log_length[edge_of(h)] = ptolemy(log_length, h);
    flip_topology(h);
  }

  /// flips the edge of `h` in the scaled metric: the new edge is straight in the two triangles laid out in the plane.
  void flip_euclidean(const Index h)
  {
    using std::exp;
    using std::log;
    using std::sin;
    const Index g = opposite(h);
    const Index h1 = mesh.next(h), h2 = mesh.next(h1), g1 = mesh.next(g);
    const std::array<FT, 3> above = triangle_log_lengths(h), below = triangle_log_lengths(g);
    const FT at_source = Triangle_angles<FT>(above).angle[1] + Triangle_angles<FT>(below).angle[2];
    // Both sides at the source, in the units of the triangle of h; the larger is factored out.
    const FT log_p = above[2], log_q = below[1] + (above[0] - below[0]);
    const FT log_unit = log_p > log_q ? log_p : log_q;
    const FT p = exp(FT(log_p - log_unit)), q = exp(FT(log_q - log_unit)), half_sine = sin(FT(at_source / 2));
    const FT square = (p - q) * (p - q) + 4 * p * q * half_sine * half_sine;
    const FT scaled = log_unit + log(square) / 2;
    // phi is zero at the source of h here.
    const FT phi_above = -form_of(h2), phi_below = form_of(g1), mean = (form_of(h) + phi_above) / 3;
    if (!log_penner.empty())
      log_penner[edge_of(h)] = ptolemy(log_penner, h);
    log_length[edge_of(h)] = scaled + mean - (phi_above + phi_below) / 2;
    flip_topology(h);
  }

  /// flips the edge of `g`, which was the image of `h` before the edge of `h` was flipped.
  void flip_image(const Index h, const Index g)
  {
    log_length[edge_of(g)] = log_length[edge_of(h)];
    if (!log_penner.empty())
      log_penner[edge_of(g)] = log_penner[edge_of(h)];
    flip_topology(g);
    pairs.exchange_sides(mesh, h, g);
    copy_form(h, opposite(g));
  }

  /// parts the two faces of the edge of `h` from their images.
  void part(const Index h)
  {
    for (const Index k : {h, opposite(h)})
      if (pairs.has_image(mesh.face(k)))
        pairs.part(mesh.face(k));
  }

private:
  // From a halfedge to its image, which runs the other way.
  void copy_form(const Index h, const Index image)
  {
    const FT xi = -form_of(h);
    form[edge_of(image)] = is_along_edge(image) ? xi : FT(-xi);
  }

  FT ptolemy(const std::vector<FT>& lambda, const Index h) const
  {
    using std::exp;
    using std::log1p;
    const Index g = opposite(h);
    const FT u = lambda[edge_of(mesh.next(h))] + lambda[edge_of(mesh.next(g))];
    const FT v = lambda[edge_of(mesh.previous(h))] + lambda[edge_of(mesh.previous(g))];
    return u > v ? FT(u + log1p(exp(FT(v - u))) - lambda[edge_of(h)])
                 : FT(v + log1p(exp(FT(u - v))) - lambda[edge_of(h)]);
  }

  void flip_topology(const Index h)
  {
    const Index g = opposite(h);
    const FT xi = -(form_of(mesh.next(g)) + form_of(mesh.previous(h)));
    form[edge_of(h)] = is_along_edge(h) ? xi : FT(-xi);
    if (delaunay_edges.is_empty())
      loops.flip(mesh, h);
    else {
      Normal_coordinates::Flip update(delaunay_edges, mesh, h);
      loops.flip(mesh, h);
      update.finish(mesh);
    }
  }
};

/// flips edges that are not Delaunay until there is none or `maximum` flips have been made. Edges of a double that are
/// images of others are not tested, but flipped with these.
/// \param is_clearly_delaunay called with an edge before the first flip: `true` if it need not be tested
/// \param flip called with a halfedge, not for images; it returns `false` to give up
/// \return the number of flips, or `maximum + 1` if that is not enough.
template <typename FT, typename IsClearlyDelaunay, typename Flip>
std::size_t flip_to_delaunay(Similarity_structure<FT>& structure, const std::size_t maximum,
                             const IsClearlyDelaunay& is_clearly_delaunay, Flip&& flip)
{
  using Index = typename Similarity_structure<FT>::Index;
  const Triangulation_connectivity& mesh = structure.mesh;
  const Mirror_pairs& pairs = structure.pairs;
  std::vector<Index> stack, sides;
  std::vector<char> is_on_stack(mesh.number_of_edges(), 0);
  for (Index e = mesh.number_of_edges() - 1; e >= 0; --e)
    if (!is_clearly_delaunay(e) && !pairs.is_image_edge(mesh, e) && !structure.is_delaunay(e)) {
      stack.push_back(e);
      is_on_stack[e] = 1;
    }
  const auto add_sides = [&](const Index f) {
    const Index h = mesh.halfedge_of_face(f);
    sides.insert(sides.end(), {h, mesh.next(h), mesh.previous(h)});
  };
  std::size_t flips = 0;
  while (!stack.empty()) {
    const Index e = stack.back();
    stack.pop_back();
    is_on_stack[e] = 0;
    if (structure.is_delaunay(e))
      continue;
    const bool has_image = pairs.has_image_edge(mesh, e);
    if (flips + (has_image ? 2 : 1) > maximum)
      return maximum + 1;
    const auto [h, g] = halfedges_of_edge(e);
    sides.assign({mesh.next(h), mesh.previous(h), mesh.next(g), mesh.previous(g)});
    const Index image = has_image ? pairs.image(h) : Triangulation_connectivity::null;
    if (!pairs.is_empty())
      for (const Index k : {h, g})
        if (pairs.has_image(mesh.face(k))) // its sides were not tested, or will not be its images any more
          add_sides(pairs.image_of_face(mesh.face(k)));
    if (!has_image)
      structure.part(h);
    if (!flip(h))
      return maximum + 1;
    ++flips;
    if (has_image) {
      structure.flip_image(h, image);
      ++flips;
    }
    for (const Index side : sides) {
      const Index s = edge_of(side);
      if (!is_on_stack[s] && s != e && (!has_image || s != edge_of(image)) && !pairs.is_image_edge(mesh, s)) {
        is_on_stack[s] = 1;
        stack.push_back(s);
      }
    }
  }
  return flips;
}

/// does the same, all edges being tested; it gives up if `progress` is interrupted.
template <typename FT, typename Flip>
std::size_t flip_all_to_delaunay(Similarity_structure<FT>& structure, const std::size_t maximum, Flip&& flip,
                                 Progress& progress)
{
  const auto flip_and_go_on = [&](const int h) {
    flip(h);
    return progress.go_on_after(10);
  };
  return flip_to_delaunay(
      structure, maximum, [](int) { return false; }, flip_and_go_on);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_STRUCTURE_H
