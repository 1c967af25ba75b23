// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_T_MESH_DIVISIONS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_T_MESH_DIVISIONS_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How many parts per unit of length the interval [0, 1] has to be divided into, at least, from place to place.
class Division_density {
public:
  /// \param parts_per_unit in [begin, end], which is cut off at 0 and 1
  void add(const double begin, const double end, const double parts_per_unit)
  {
    if ((std::min)(end, 1.) - (std::max)(begin, 0.) > smallest_step)
      m_steps.push_back({(std::max)(begin, 0.), (std::min)(end, 1.), (std::min)(parts_per_unit, largest_density)});
  }

  /// Divides the interval into as few parts as the density allows, but not fewer than `least` nor more than `most`, and so
  /// that it allows for about as much in all of them.
  /// \return the ends of the parts, from 0 to 1
  std::vector<double> division(const int least, const int most)
  {
    join_steps();
    std::vector<double> ends = march(1, most);
    if (number_of_parts(ends) < least) {
      for (Step& step : m_steps)
        step.density = (std::max)(step.density, static_cast<double>(least));
      ends = march(1, most);
    }
    double enough = 1, too_little = 0; // lengths of parts, by what the density allows
    const int n = (std::min)(number_of_parts(ends), most);
    for (; number_of_parts(ends) > n; ends = march(enough, most)) {
      too_little = enough;
      enough *= 2;
    }
    constexpr int number_of_bisections = 12;
    for (int i = 0; i < number_of_bisections; ++i) {
      const double middle = (too_little + enough) / 2;
      std::vector<double> shorter = march(middle, n);
      (number_of_parts(shorter) > n ? too_little : enough) = middle;
      if (number_of_parts(shorter) <= n)
        ends.swap(shorter);
    }
    return ends;
  }

private:
  struct Step {
    double begin, end, density;
  };

  static int number_of_parts(const std::vector<double>& ends) { return static_cast<int>(ends.size()) - 1; }

  // Makes the steps follow each other from 0 to 1, the largest density of those at the same place for each.
  void join_steps()
  {
    std::vector<double> ends{0, 1};
    for (const Step& step : m_steps) {
      ends.push_back(step.begin);
      ends.push_back(step.end);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<Step> joined;
    for (const double end : ends) {
      const double begin = joined.empty() ? 0 : joined.back().end;
      if (end - begin > smallest_step)
        joined.push_back({begin, end, 0});
    }
    joined.back().end = 1;
    for (Step& piece : joined)
      for (const Step& step : m_steps)
        if (step.begin < (piece.begin + piece.end) / 2 && (piece.begin + piece.end) / 2 < step.end)
          piece.density = (std::max)(piece.density, step.density);
    m_steps.swap(joined);
  }

  // From 0 on, each part as long as the largest density in it allows, times a factor; it stops with more than `most` parts.
  std::vector<double> march(const double factor, const int most) const
  {
    std::vector<double> ends{0};
    std::size_t i = 0;
    while (ends.back() < 1 && number_of_parts(ends) <= most) {
      double density = 0, end = ends.back();
      for (; i < m_steps.size(); ++i) {
        density = (std::max)(density, m_steps[i].density);
        const double reach = density > 0 ? ends.back() + factor / density : 1;
        end = (std::min)((std::max)(reach, end), m_steps[i].end);
        if (end < m_steps[i].end)
          break;
      }
      ends.push_back(1 - end > smallest_step ? end : 1);
    }
    return ends;
  }

  static constexpr double smallest_step = 1e-9;   // what is less is round-off
  static constexpr double largest_density = 1e12; // so that no part vanishes

  std::vector<Step> m_steps;
};

/// Where the faces and the edges of a T-mesh are divided.
struct T_mesh_divisions {
  /// The ends of parts, from 0 to 1.
  using Ends = std::vector<double>;

  std::vector<std::array<Ends, 2>> faces; ///< along u and along v, at least two parts
  std::vector<Ends> edges;                ///< along `halfedge_of_edge(e)`
};

/// The least number of parts of a halfedge, if the sides of its face are divided into at least `n` parts.
template <typename FT>
int parts_of_halfedge(const T_mesh_arrays<FT>& t_mesh, const int h, const int n)
{
  if (t_mesh.is_border(h))
    return 1;
  const double share = CGAL::to_double(FT(t_mesh.knot(h) / t_mesh.side_length(t_mesh.face(h), t_mesh.side(h))));
  return (std::max)(static_cast<int>(std::ceil(n * share - summed_round_off)), 1);
}

/// The same number of equal parts for all sides of faces, or some more at vertices inside of a side.
template <typename FT>
T_mesh_divisions even_divisions(const T_mesh_arrays<FT>& t_mesh, const int n)
{
  const auto even = [](const int number) {
    T_mesh_divisions::Ends ends;
    for (int i = 0; i <= number; ++i)
      ends.push_back(static_cast<double>(i) / number);
    return ends;
  };
  T_mesh_divisions result;
  result.faces.assign(t_mesh.number_of_faces(), {even(n), even(n)});
  for (int e = 0; e < t_mesh.number_of_edges(); ++e) {
    const auto [h, o] = halfedges_of_edge(e);
    result.edges.push_back(even((std::max)(parts_of_halfedge(t_mesh, h, n), parts_of_halfedge(t_mesh, o, n))));
  }
  return result;
}

/// A part of a face, in units of its width and height, and how many parts per unit are wanted there in both directions.
struct Division_rectangle {
  int face;
  std::array<double, 2> begin, end;
  std::array<double, 2> density;
};

/// The largest second differences of the control points of a patch along its normal, as derivatives with respect to its own
/// parameters in [0, 1], the mixed one divided among both: a triangle over a cell of the size a x b is about (first a^2 +
/// second b^2) / 8 away from the patch, where its weights are equal and its normal does not turn far. What second
/// derivatives have along the patch moves points within it.
template <typename Kernel>
std::array<double, 2> bending_of_patch(const Bezier_patch_3<Kernel>& patch)
{
  const auto p = [&](const int i, const int j) { return patch.control_point(i, j); };
  const auto normal =
      CGAL::cross_product((p(3, 0) - p(0, 0)) + (p(3, 3) - p(0, 3)), (p(0, 3) - p(0, 0)) + (p(3, 3) - p(3, 0)));
  const double length = std::sqrt(CGAL::to_double(normal.squared_length()));
  const auto size = [&](const auto& difference) {
    return length > 0 ? std::abs(CGAL::to_double(difference * normal)) / length
                      : std::sqrt(CGAL::to_double(difference.squared_length()));
  };
  double uu = 0, uv = 0, vv = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i < 2)
        uu = (std::max)(uu, 6 * size((p(i + 2, j) - p(i + 1, j)) - (p(i + 1, j) - p(i, j))));
      if (j < 2)
        vv = (std::max)(vv, 6 * size((p(i, j + 2) - p(i, j + 1)) - (p(i, j + 1) - p(i, j))));
      if (i < 3 && j < 3)
        uv = (std::max)(uv, 9 * size((p(i + 1, j + 1) - p(i, j + 1)) - (p(i + 1, j) - p(i, j))));
    }
  return {uu + uv, vv + uv};
}

/// How finely the patches of a surface are to be divided, for their triangles to be within a distance.
template <typename CompiledTSpline>
std::vector<Division_rectangle> division_rectangles(const CompiledTSpline& surface, const double distance)
{
  std::vector<Division_rectangle> result;
  for (std::size_t i = 0; i < surface.number_of_patches(); ++i) {
    const auto domain = surface.domain(i);
    const double width = CGAL::to_double(surface.width(domain.face)),
                 height = CGAL::to_double(surface.height(domain.face));
    Division_rectangle r{surface.indexing().face_index(domain.face),
                         {CGAL::to_double(domain.u_begin) / width, CGAL::to_double(domain.v_begin) / height},
                         {CGAL::to_double(domain.u_end) / width, CGAL::to_double(domain.v_end) / height},
                         {}};
    const std::array<double, 2> bending = bending_of_patch(surface.patch(i));
    for (int k = 0; k < 2; ++k)
      r.density[k] = std::sqrt(bending[k] / (4 * distance)) / (r.end[k] - r.begin[k]);
    result.push_back(r);
  }
  return result;
}

/// What the rectangles ask for in the outermost part of a face at a halfedge, in units of its edge and along it.
/// \param faces how they are divided
template <typename FT>
void add_density_of_halfedge(const T_mesh_arrays<FT>& t_mesh, const int h,
                             const std::vector<Division_rectangle>& rectangles,
                             const std::vector<std::size_t>& first_of_face,
                             const std::vector<std::array<std::vector<double>, 2>>& faces, Division_density& density)
{
  if (t_mesh.is_border(h))
    return;
  const int f = t_mesh.face(h), side = t_mesh.side(h), along = side % 2, across = 1 - along;
  const bool is_at_end = side == 1 || side == 2, is_reversed = side >= 2;
  const std::vector<double>& lines = faces[f][across];
  const double length = CGAL::to_double(t_mesh.side_length(f, side));
  const double begin = CGAL::to_double(t_mesh.begin(h)) / length, knot = CGAL::to_double(t_mesh.knot(h)) / length;
  for (std::size_t i = first_of_face[f]; i < first_of_face[f + 1]; ++i) {
    const Division_rectangle& r = rectangles[i];
    if (is_at_end ? r.end[across] <= lines[lines.size() - 2] : r.begin[across] >= lines[1])
      continue;
    const double x = ((is_reversed ? 1 - r.end[along] : r.begin[along]) - begin) / knot;
    const double y = ((is_reversed ? 1 - r.begin[along] : r.end[along]) - begin) / knot;
    density.add(is_along_edge(h) ? x : 1 - y, is_along_edge(h) ? y : 1 - x, r.density[along] * knot);
  }
}

/// Divides as far as rectangles ask for: a face by the most in each column and row, an edge by the most beside it, on both
/// sides.
/// \param rectangles cover the faces; those of a face follow each other, by increasing face
/// \param least, most numbers of parts of the sides of a face
template <typename FT>
T_mesh_divisions adaptive_divisions(const T_mesh_arrays<FT>& t_mesh, const std::vector<Division_rectangle>& rectangles,
                                    const int least, const int most)
{
  std::vector<std::size_t> first(t_mesh.number_of_faces() + 1, 0);
  for (const Division_rectangle& rectangle : rectangles)
    ++first[rectangle.face + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  T_mesh_divisions result;
  for (int f = 0; f < t_mesh.number_of_faces(); ++f) {
    std::array<Division_density, 2> density;
    for (std::size_t i = first[f]; i < first[f + 1]; ++i)
      for (int k = 0; k < 2; ++k)
        density[k].add(rectangles[i].begin[k], rectangles[i].end[k], rectangles[i].density[k]);
    result.faces.push_back({density[0].division(least, most), density[1].division(least, most)});
  }
  for (int e = 0; e < t_mesh.number_of_edges(); ++e) {
    Division_density density;
    int least_of_edge = 1;
    for (const int h : halfedges_of_edge(e)) {
      add_density_of_halfedge(t_mesh, h, rectangles, first, result.faces, density);
      least_of_edge = (std::max)(least_of_edge, parts_of_halfedge(t_mesh, h, least));
    }
    result.edges.push_back(density.division(least_of_edge, most));
  }
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_MESH_DIVISIONS_H
