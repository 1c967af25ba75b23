// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_SURFACE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_SURFACE_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/internal/Bezier_part.h>
#include <CGAL/T_splines/Spline/internal/Chord_errors.h>
#include <CGAL/T_splines/Spline/internal/Parameter_correction.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A compiled T-spline surface as the measurement of distances wants it: its patches in doubles with bounds of their
/// derivatives, and searches for points that are close to given ones.
/// \tparam Compiled_ a `Compiled_T_spline`
template <typename Compiled_>
class Measured_surface {
public:
  using Compiled = Compiled_;
  using FT = typename Compiled::FT;
  using Kernel = Triangle_set::Kernel;
  using Point_3 = Triangle_set::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Patch = Bezier_patch_3<Kernel>;

  /// Where a patch begins in its face, and the reciprocal of its size.
  struct Domain {
    int face;
    double u, v, u_factor, v_factor;
    int cap_corner; ///< the corner at the extraordinary vertex: bits that tell whether s = 1 and t = 1; -1: no cap
  };

  /// A point of the surface, and how far another one is from it.
  struct Foot {
    int face = 0, patch = 0;
    FT u = FT(0), v = FT(0);
    Point_3 point;
    double distance = 0;
    std::size_t triangle = 0; ///< of the triangulation, near by
  };

  /// \param progress if it is interrupted, patches are missing
  Measured_surface(const Compiled& compiled, Progress& progress)
    : m_compiled(compiled),
      m_chord_errors(compiled.t_mesh_arrays())
  {
    const std::size_t n = compiled.number_of_patches();
    m_patches.reserve(n);
    m_domains.reserve(n);
    m_bounds.reserve(n);
    m_sizes.reserve(n);
    for (std::size_t i = 0; i < n && progress.go_on_after(20); ++i)
      add_patch(i);
  }

  const Compiled& compiled() const { return m_compiled; }
  std::size_t number_of_patches() const { return m_patches.size(); }
  const Patch& patch(const std::size_t i) const { return m_patches[i]; }
  const Domain& domain(const std::size_t i) const { return m_domains[i]; }
  const Derivative_bounds& bounds(const std::size_t i) const { return m_bounds[i]; }

  /// The lengths of a patch along its two parameters: those of the longest rows of its control net.
  const std::array<double, 2>& size(const std::size_t i) const { return m_sizes[i]; }

  /// Whether all points of patches are finite and not too large.
  bool is_finite() const
  {
    return std::all_of(m_patches.begin(), m_patches.end(), [](const Patch& patch) {
      constexpr std::array<double, 3> places{0, 0.5, 1};
      for (const double s : places)
        for (const double t : places)
          if (!is_within_range(patch.position(s, t)))
            return false;
      return true;
    });
  }

  /// Prepares the searches. \return false if `progress` is interrupted
  bool prepare(Progress& progress)
  {
    constexpr double number_of_triangles = 200000;
    const double parts = std::sqrt(number_of_triangles / (2 * static_cast<double>(number_of_patches())));
    m_parts = static_cast<int>(std::clamp(parts, 2., 64.));
    const Triangle_set set = triangulation();
    if (!progress.go_on())
      return false;
    m_tree = std::make_unique<const Triangle_tree>(set, progress);
    if (!progress.go_on())
      return false;
    m_closest = std::make_unique<const T_spline_closest_point<Compiled>>(m_compiled);
    return progress.go_on();
  }

  /// A point of the surface that is close to p: from the closest point of a triangulation some Gauss-Newton steps
  /// descend, across the borders of patches. No other is closer, as a rule.
  /// \param hint another foot near by
  Foot close_point(const Point_3& p, const Foot& hint) const
  {
    const std::size_t triangle = m_tree->foot(p, hint.triangle).triangle;
    const std::size_t per_patch = 2 * static_cast<std::size_t>(m_parts * m_parts);
    const int cell = static_cast<int>(triangle % per_patch);
    const Domain& domain = m_domains[triangle / per_patch];
    const double third = cell % 2 == 0 ? 1. / 3 : 2. / 3; // the centroid of the lower or the upper half of a cell
    const double s = (cell / 2 % m_parts + 1 - third) / m_parts, t = (cell / 2 / m_parts + third) / m_parts;
    Foot foot;
    foot.triangle = triangle;
    set_place({domain.face, FT(domain.u + s / domain.u_factor), FT(domain.v + t / domain.v_factor)}, foot);
    descend(p, foot);
    return foot;
  }

  /// The closest point of the surface, globally. \param hint a point of the surface that is close
  Foot closest_point(const Point_3& p, const Foot& hint) const
  {
    using Kernel_point = typename Compiled::Point_3;
    const auto found = (*m_closest)(Kernel_point(p.x(), p.y(), p.z()),
                                    typename Compiled::Place{m_compiled.indexing().face(hint.face), hint.u, hint.v});
    Foot foot = hint;
    foot.face = m_compiled.indexing().face_index(found.face);
    foot.u = found.u;
    foot.v = found.v;
    foot.patch = static_cast<int>(m_compiled.patch_at(found.face, found.u, found.v));
    foot.point = point_in_doubles(found.point);
    foot.distance = CGAL::to_double(found.distance);
    return foot;
  }

  /// How far the surface is, at most, from the triangle of three of its points; infinite where nothing is known.
  double chord_error(const Foot& a, const Foot& b, const Foot& c) const
  {
    if (a.patch != b.patch || a.patch != c.patch)
      return m_chord_errors({{{a.face, a.u, a.v}, {b.face, b.u, b.v}, {c.face, c.u, c.v}}});
    const auto range = [](const FT& x, const FT& y, const FT& z) {
      return CGAL::to_double(FT((std::max)({x, y, z}) - (std::min)({x, y, z})));
    };
    const Domain& domain = m_domains[a.patch];
    return m_bounds[a.patch].chord_error(range(a.u, b.u, c.u) * domain.u_factor,
                                         range(a.v, b.v, c.v) * domain.v_factor);
  }

private:
  void add_patch(const std::size_t i)
  {
    const auto domain = m_compiled.domain(i);
    const double u = CGAL::to_double(domain.u_begin), v = CGAL::to_double(domain.v_begin),
                 du = CGAL::to_double(FT(domain.u_end - domain.u_begin)),
                 dv = CGAL::to_double(FT(domain.v_end - domain.v_begin));
    const bool is_at_end_of_u = domain.u_begin > m_compiled.width(domain.face) / FT(4),
               is_at_end_of_v = domain.v_begin > m_compiled.height(domain.face) / FT(4);
    const int corner = domain.is_cap ? (is_at_end_of_u ? 1 : 0) + (is_at_end_of_v ? 2 : 0) : -1;
    m_domains.push_back({m_compiled.indexing().face_index(domain.face), u, v, 1 / du, 1 / dv, corner});
    typename Patch::Controls controls;
    for (int k = 0; k < 16; ++k)
      for (int x = 0; x < 4; ++x)
        controls[k][x] = CGAL::to_double(m_compiled.patch(i).homogeneous_control_points()[k][x]);
    m_patches.emplace_back(controls);
    m_bounds.push_back(derivative_bounds(m_patches.back()));
    m_sizes.push_back(size_of(m_patches.back()));
    const Derivative_bounds& b = m_bounds.back();
    m_chord_errors.add_patch(m_domains.back().face,
                             {b.s / du, b.t / dv, b.ss / (du * du), b.st / (du * dv), b.tt / (dv * dv)}, domain.is_cap);
  }

  static std::array<double, 2> size_of(const Patch& patch)
  {
    std::array<double, 2> result{0, 0};
    for (int j = 0; j < 4; ++j) {
      std::array<double, 2> sum{0, 0};
      for (int i = 0; i < 3; ++i) {
        sum[0] += std::sqrt(CGAL::squared_distance(patch.control_point(i, j), patch.control_point(i + 1, j)));
        sum[1] += std::sqrt(CGAL::squared_distance(patch.control_point(j, i), patch.control_point(j, i + 1)));
      }
      for (int axis = 0; axis < 2; ++axis)
        result[axis] = (std::max)(result[axis], sum[axis]);
    }
    return result;
  }

  // Each patch apart.
  Triangle_set triangulation() const
  {
    Triangle_set set;
    const std::size_t n = m_parts, row = n + 1;
    for (const Patch& patch : m_patches) {
      const std::size_t first = set.points.size();
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
          set.points.push_back(patch.position(static_cast<double>(i) / static_cast<double>(n),
                                              static_cast<double>(j) / static_cast<double>(n)));
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          const std::size_t corner = first + row * j + i;
          set.triangles.push_back({corner, corner + 1, corner + row + 1});
          set.triangles.push_back({corner, corner + row + 1, corner + row});
        }
    }
    return set;
  }

  struct Tangents {
    Vector_3 du, dv;
  };

  // \return the first derivatives
  Tangents set_place(const Indexed_place<FT>& place, Foot& foot) const
  {
    foot.face = place.face;
    foot.u = place.u;
    foot.v = place.v;
    foot.patch = static_cast<int>(m_compiled.patch_at(m_compiled.indexing().face(place.face), place.u, place.v));
    const Domain& domain = m_domains[foot.patch];
    const auto h =
        m_patches[foot.patch].template homogeneous_jet<1>((CGAL::to_double(place.u) - domain.u) * domain.u_factor,
                                                          (CGAL::to_double(place.v) - domain.v) * domain.v_factor);
    const double r = 1 / h[0][3], x = h[0][0] * r, y = h[0][1] * r, z = h[0][2] * r;
    foot.point = Point_3(x, y, z);
    const auto derivative = [&](const std::array<double, 4>& d, const double factor) {
      return Vector_3((d[0] - d[3] * x) * r * factor, (d[1] - d[3] * y) * r * factor, (d[2] - d[3] * z) * r * factor);
    };
    return {derivative(h[1], domain.u_factor), derivative(h[2], domain.v_factor)};
  }

  // Until a step changes the distance by less than a millionth.
  void descend(const Point_3& p, Foot& foot) const
  {
    constexpr int number_of_steps = 16;
    constexpr double negligible = 1e-6;
    const auto& t_mesh = m_compiled.t_mesh_arrays();
    Tangents tangents = set_place({foot.face, foot.u, foot.v}, foot);
    double squared_distance = CGAL::squared_distance(p, foot.point);
    for (int i = 0; i < number_of_steps; ++i) {
      const Vector_3 rest = p - foot.point;
      const double a = tangents.du.squared_length(), b = tangents.du * tangents.dv, c = tangents.dv.squared_length(),
                   determinant = a * c - b * b;
      if (!(determinant > parallel_tangents * a * c))
        break;
      const double x = rest * tangents.du, y = rest * tangents.dv;
      const double du = (c * x - b * y) / determinant, dv = (a * y - b * x) / determinant;
      if (!(a * du * du + 2 * b * du * dv + c * dv * dv > negligible * squared_distance))
        break;
      constexpr int number_of_trials = 4;
      double factor = 1;
      bool is_closer = false;
      for (int trial = 0; trial < number_of_trials && !is_closer; ++trial, factor /= 4) {
        Foot next = foot;
        const Tangents at_next = set_place(
            moved(t_mesh, Indexed_place<FT>{foot.face, foot.u, foot.v}, FT(factor * du), FT(factor * dv)), next);
        const double squared = CGAL::squared_distance(p, next.point);
        is_closer = squared < squared_distance;
        if (is_closer) {
          foot = next;
          tangents = at_next;
          squared_distance = squared;
        }
      }
      if (!is_closer)
        break;
    }
    foot.distance = std::sqrt(squared_distance);
  }

  const Compiled& m_compiled;
  std::vector<Patch> m_patches;
  std::vector<Domain> m_domains;
  std::vector<Derivative_bounds> m_bounds; // per patch
  Chord_errors<FT> m_chord_errors;
  std::vector<std::array<double, 2>> m_sizes;  // per patch
  int m_parts = 2;                             // of each side of a patch in the triangulation
  std::unique_ptr<const Triangle_tree> m_tree; // of the triangulation
  std::unique_ptr<const T_spline_closest_point<Compiled>> m_closest;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_SURFACE_H
