// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_SEARCH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_SEARCH_H

#include <CGAL/T_splines/Spline/internal/Bezier_part.h>
#include <CGAL/T_splines/Spline/internal/Distances_to_mesh.h>
#include <CGAL/T_splines/Spline/internal/Fold_state.h>
#include <CGAL/T_splines/Spline/internal/Measured_mesh.h>
#include <CGAL/T_splines/Spline/internal/Mesh_normals.h>
#include <CGAL/T_splines/Spline/internal/Normal_hull.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Compares the normals of a surface with those of a mesh at the closest points.
///
/// Where they differ by a right angle or more, the surface has a fold, unless a triangle within the tolerance agrees
/// with it: there the mesh itself turns over within the tolerance, and the place is doubtful.
///
/// A patch has no fold where a cone around its normals, from the Bernstein coefficients of the homogeneous normal, and
/// the normals of all triangles on which closest points may lie are within a right angle. Patches for which that is not
/// shown, and whose samples have turned far, are sampled more densely.
///
/// What closes a hole counts: a fold there is one, though no normals are compared there.
/// \tparam Measured a `Measured_surface`
template <typename Measured>
class Fold_search {
  using Point_3 = Triangle_set::Point_3;
  using Vector_3 = Triangle_set::Kernel::Vector_3;
  using Patch = typename Measured::Patch;

public:
  Fold_search(const Measured& surface, const Measured_mesh& mesh, const double tolerance)
    : m_surface(surface),
      m_measured_mesh(mesh),
      m_mesh(mesh.tree),
      m_normals(mesh.normals),
      m_tolerance(tolerance),
      m_cosines(surface.number_of_patches(), 1.),
      m_states(surface.number_of_patches(), Fold_state::NONE),
      m_triangles(surface.number_of_patches(), 0)
  {
  }

  /// Takes a sample into account.
  void visit(const Surface_sample& sample)
  {
    m_triangles[sample.patch] = sample.foot.triangle;
    const double length = std::sqrt(sample.normal.squared_length());
    if (!(length > 0))
      return;
    const Vector_3 unit = sample.normal / length;
    double& smallest = m_cosines[sample.patch];
    constexpr double positive = 1e-3; // a cosine that round-off does not make of a negative one
    const double cosine = m_normals.cosine(unit, sample.foot, (std::max)(smallest, positive));
    Fold_state& state = m_states[sample.patch];
    if (cosine <= 0 && state != Fold_state::FOLDED)
      state = agrees_within_tolerance(unit, sample) ? Fold_state::DOUBTFUL : Fold_state::FOLDED;
    smallest = (std::min)(smallest, cosine);
    if (sample.is_measured() && cosine < m_smallest_cosine) {
      m_smallest_cosine = cosine;
      m_worst = sample;
    }
  }

  /// Looks at all patches, after some samples of each were visited.
  /// \param progress if it is interrupted, what was found means nothing
  void search(Progress& progress)
  {
    constexpr double far_turned = 0.5; // the cosine: more than 60 degrees within a patch is worth a look
    const std::size_t n = m_surface.number_of_patches();
    for (std::size_t i = 0; i < n && progress.go_on_after(1000); ++i) {
      progress.progress(static_cast<double>(i) / static_cast<double>(n));
      if (m_cosines[i] > 0 && is_certified(m_surface.patch(i), m_triangles[i], largest_depth))
        ++m_number_of_certified;
      else {
        sample(i, 6);
        if (m_cosines[i] < far_turned)
          sample(i, 18);
      }
    }
  }

  std::size_t number_of(const Fold_state state) const
  {
    return static_cast<std::size_t>(std::count(m_states.begin(), m_states.end(), state));
  }
  std::size_t number_of_certified() const { return m_number_of_certified; }
  Fold_state state(const std::size_t patch) const { return m_states[patch]; }
  double smallest_cosine() const { return m_smallest_cosine; }
  const Surface_sample& worst() const { return m_worst; }

private:
  static constexpr int largest_depth = 2;

  // Whether any triangle does that is as near as the tolerance allows, or as the closest one.
  bool agrees_within_tolerance(const Vector_3& unit, const Surface_sample& sample) const
  {
    constexpr double as_near = 1 + same_point;
    const double reach = (std::max)(m_tolerance, as_near * sample.foot.distance());
    return !m_mesh.is_true_near(sample.point, reach, [&](const std::size_t i) {
      return !(unit * m_normals.normal(i) > 0) ||
             CGAL::squared_distance(sample.point, closest_of_triangle(sample.point, m_mesh.triangle(i)).point) >
                 reach * reach;
    });
  }

  // At n x n places.
  void sample(const std::size_t patch, const int n)
  {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        visit(surface_sample(m_surface, m_measured_mesh, patch, (i + 0.5) / n, (j + 0.5) / n, m_triangles[patch]));
  }

  // Of a patch or a part of one; if it is not shown for the whole, then for all four quarters.
  bool is_certified(const Patch& patch, const std::size_t hint, const int depth) const
  {
    if (is_shown(patch, hint))
      return true;
    if (depth == 0)
      return false;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double s = quarter % 2 == 0 ? 0 : 0.5, t = quarter / 2 == 0 ? 0 : 0.5;
      if (!is_certified(restricted(patch, {s, s + 0.5, t, t + 0.5}), hint, depth - 1))
        return false;
    }
    return true;
  }

  bool is_shown(const Patch& patch, const std::size_t hint) const
  {
    for (const auto& h : patch.homogeneous_control_points())
      if (!(h[3] > 0))
        return false;
    const Direction_cone cone = cone_of(normal_hull(patch));
    if (!(cone.cosine > 0))
      return false;
    const Point_3 middle = patch.position(0.5, 0.5);
    double squared_radius = 0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        squared_radius = (std::max)(squared_radius, CGAL::squared_distance(middle, patch.control_point(i, j)));
    // The closest point of a point that is r from the middle is no farther from that than r + (r + the distance).
    const double reach = 2 * std::sqrt(squared_radius) + m_mesh.foot(middle, hint).distance();
    const double sine = std::sqrt((std::max)(0., 1 - cone.cosine * cone.cosine));
    return m_mesh.is_true_near(middle, reach, [&](const std::size_t i) {
      const Vector_3& normal = m_normals.normal(i);
      if (normal == CGAL::NULL_VECTOR || normal * cone.axis > sine)
        return true;
      const Point_3 q = closest_of_triangle(middle, m_mesh.triangle(i)).point;
      return CGAL::squared_distance(middle, q) > reach * reach;
    });
  }

  const Measured& m_surface;
  const Measured_mesh& m_measured_mesh;
  const Triangle_tree& m_mesh;
  const Mesh_normals& m_normals;
  double m_tolerance;
  std::vector<double> m_cosines; // per patch, the smallest one
  std::vector<Fold_state> m_states;
  std::vector<std::size_t> m_triangles; // per patch, one near by
  Surface_sample m_worst;
  double m_smallest_cosine = 2; // so that the first sample is the worst
  std::size_t m_number_of_certified = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_SEARCH_H
