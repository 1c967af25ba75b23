// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_RINGS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_RINGS_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Catmull_clark_eigenstructure.h>
#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>
#include <CGAL/T_splines/Spline/internal/Homogeneous_vector.h>
#include <CGAL/T_splines/Spline/internal/Vertex_cap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What all faces at extraordinary vertices of a valence share, to find the rings of patches around them.
template <typename Kernel>
class Vertex_ring_rules {
public:
  using FT = typename Kernel::FT;
  using Homogeneous = std::array<FT, 4>;
  using Rules = Catmull_clark_subdivision<FT>;
  using Eigenstructure = Catmull_clark_eigenstructure<FT>;

  static constexpr int last_level = 127; ///< no eigenvalue is larger than 0.655, apart from the first one

  explicit Vertex_ring_rules(const int valence) : rules(valence)
  {
    if (valence < 3)
      return;
    eigenstructure.emplace(valence);
    factors.resize(last_level + 1);
    for (int level = 0; level <= last_level; ++level)
      for (const FT& eigenvalue : eigenstructure->eigenvalues())
        factors[level].push_back(std::pow(eigenvalue, FT(level - 1)));
    for (int mode = 0; mode < rules.number_of_controls(); ++mode)
      add_mode(mode);
  }

  Rules rules;
  std::optional<Eigenstructure> eigenstructure;          ///< unless the valence is 1 or 2
  std::vector<std::vector<FT>> factors;                  ///< per level k and mode, the eigenvalue to the power k - 1
  std::vector<std::vector<FT>> vectors;                  ///< per mode, the right eigenvector
  std::vector<FT> largest;                               ///< per mode, the largest absolute entry of the eigenvector
  std::array<std::vector<std::array<FT, 16>>, 3> images; ///< per part and mode, Bezier coefficients

private:
  void add_mode(const int mode)
  {
    std::vector<Homogeneous_vector<FT>> controls;
    vectors.emplace_back();
    largest.push_back(FT(0));
    for (int c = 0; c < rules.number_of_controls(); ++c) {
      const FT x = eigenstructure->right_eigenvector(mode, c);
      vectors.back().push_back(x);
      largest.back() = (std::max)(largest.back(), std::abs(x));
      controls.push_back({{x, FT(0), FT(0), FT(0)}});
    }
    for (int part = 0; part < 3; ++part) {
      const auto patch = bezier_of_uniform_b_spline<Kernel>(rules.part_controls(controls, 1, part));
      images[part].emplace_back();
      for (int k = 0; k < 16; ++k)
        images[part].back()[k] = patch.homogeneous_control_points()[k][0];
    }
  }
};

/// The part [0, 2^-k]^2 of a face at an extraordinary vertex, as rings of exact Bezier patches that shrink to the
/// vertex.
///
/// Patches are relative to the vertex, so that they keep their relative precision. They are made of eigenvectors when
/// they are asked for, in a time linear in the valence; those at vertices of the valences 1 and 2, by subdivision, in
/// advance.
template <typename Kernel>
class Vertex_rings {
public:
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Homogeneous = std::array<FT, 4>;
  using Patch = Bezier_patch_3<Kernel>;
  using Shared_rules = Vertex_ring_rules<Kernel>;

  /// \param controls homogeneous, as `Catmull_clark_subdivision` orders them, with positive weights
  /// \param first_level 1 for the whole face. \pre 1 <= first_level <= 64
  Vertex_rings(std::shared_ptr<const Shared_rules> rules, std::vector<Homogeneous> controls, const int first_level)
    : m_rules(std::move(rules)),
      m_first_level(first_level),
      m_smallest_weight(controls[0][3])
  {
    const std::vector<FT> weights = m_rules->rules.limit_weights();
    Homogeneous limit{FT(0), FT(0), FT(0), FT(0)};
    for (std::size_t i = 0; i < controls.size(); ++i) {
      m_smallest_weight = (std::min)(m_smallest_weight, controls[i][3]);
      for (int c = 0; c < 4; ++c)
        limit[c] += weights[i] * controls[i][c];
    }
    m_vertex = Point_3(limit[0] / limit[3], limit[1] / limit[3], limit[2] / limit[3]);
    for (Homogeneous& h : controls) {
      h[0] -= h[3] * m_vertex.x();
      h[1] -= h[3] * m_vertex.y();
      h[2] -= h[3] * m_vertex.z();
    }
    if (m_rules->eigenstructure)
      find_coefficients(controls);
    else
      find_patches(controls);
  }

  const Point_3& vertex() const { return m_vertex; }

  /// Level k is [0, 2^-(k-1)]^2 without [0, 2^-k]^2. From the last one on the surface is the vertex, up to round-off.
  int first_level() const { return m_first_level; }
  int last_level() const { return m_first_level + static_cast<int>(m_radii.size()) - 1; }

  /// An upper bound of the distance from the vertex in [0, 2^-(k-1)]^2.
  const FT& radius(const int level) const { return m_radii[level - m_first_level]; }

  /// The box of the levels from the first.
  Axis_parallel_box<FT> box() const
  {
    Axis_parallel_box<FT> result;
    for (const Homogeneous& h : m_first_controls)
      result.extend({m_vertex.x() + h[0] / h[3], m_vertex.y() + h[1] / h[3], m_vertex.z() + h[2] / h[3]});
    return result;
  }

  /// The patch of a level, relative to the vertex. Parts are numbered as in `Catmull_clark_subdivision`.
  /// \pre first_level() <= level < last_level()
  Patch patch(const int level, const int part) const
  {
    if (!m_patches.empty())
      return m_patches[3 * (level - m_first_level) + part];
    typename Patch::Controls controls;
    controls.fill(m_coefficients[0]);
    const FT negligible_weight = std::numeric_limits<FT>::epsilon() / FT(64) * m_smallest_weight,
             negligible = negligible_weight * radius(level);
    for (std::size_t mode = 1; mode < m_coefficients.size(); ++mode) {
      const Homogeneous h = scaled(mode, level);
      // Near the vertex few modes are left.
      const FT size = (std::abs(h[0]) + std::abs(h[1]) + std::abs(h[2])) * m_rules->largest[mode];
      if (size <= negligible && std::abs(h[3]) * m_rules->largest[mode] <= negligible_weight)
        continue;
      const std::array<FT, 16>& image = m_rules->images[part][mode];
      for (int k = 0; k < 16; ++k)
        for (int c = 0; c < 4; ++c)
          controls[k][c] += image[k] * h[c];
    }
    return Patch(controls);
  }

private:
  Homogeneous scaled(const std::size_t mode, const int level) const
  {
    const FT factor = m_rules->factors[level][mode];
    const Homogeneous& h = m_coefficients[mode];
    return {h[0] * factor, h[1] * factor, h[2] * factor, h[3] * factor};
  }

  static FT length(const Homogeneous& h) { return std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]); }

  void find_coefficients(const std::vector<Homogeneous>& controls)
  {
    m_coefficients = m_rules->eigenstructure->project(controls);
    for (int c = 0; c < 3; ++c)
      m_coefficients[0][c] = FT(0);
    int level = m_first_level;
    do {
      FT sum(0);
      for (std::size_t mode = 1; mode < m_coefficients.size(); ++mode)
        sum += length(scaled(mode, level)) * m_rules->largest[mode];
      m_radii.push_back(sum / m_smallest_weight);
    } while (!is_vertex(level++));
    m_first_controls.assign(controls.size(), m_coefficients[0]);
    for (std::size_t mode = 1; mode < m_coefficients.size(); ++mode) {
      const Homogeneous h = scaled(mode, m_first_level);
      for (std::size_t i = 0; i < controls.size(); ++i)
        for (int c = 0; c < 4; ++c)
          m_first_controls[i][c] += m_rules->vectors[mode][i] * h[c];
    }
  }

  void find_patches(const std::vector<Homogeneous>& controls)
  {
    std::vector<Homogeneous_vector<FT>> rows;
    for (const Homogeneous& h : controls)
      rows.push_back({h});
    const std::vector<FT> weights = m_rules->rules.limit_weights();
    for (int level = 1; level < m_first_level; ++level)
      subdivide(weights, rows);
    for (const Homogeneous_vector<FT>& row : rows)
      m_first_controls.push_back(row.values);
    for (int level = m_first_level;; ++level) {
      FT radius(0);
      for (const Homogeneous_vector<FT>& row : rows)
        radius = (std::max)(radius, length(row.values));
      m_radii.push_back(radius / m_smallest_weight);
      for (int part = 0; part < 3; ++part)
        m_patches.push_back(bezier_of_uniform_b_spline<Kernel>(m_rules->rules.part_controls(rows, 1, part)));
      if (is_vertex(level))
        break;
      subdivide(weights, rows);
    }
  }

  // One step; the vertex is brought back to the origin, so that round-off does not accumulate beside it.
  void subdivide(const std::vector<FT>& weights, std::vector<Homogeneous_vector<FT>>& rows) const
  {
    rows = m_rules->rules.subdivided(rows);
    Homogeneous limit{FT(0), FT(0), FT(0), FT(0)};
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (int c = 0; c < 3; ++c)
        limit[c] += weights[i] * rows[i].values[c];
    for (Homogeneous_vector<FT>& row : rows)
      for (int c = 0; c < 3; ++c)
        row.values[c] -= limit[c];
  }

  bool is_vertex(const int level) const
  {
    return !(radius(level) > std::numeric_limits<FT>::epsilon() * m_radii.front()) || level == Shared_rules::last_level;
  }

  std::shared_ptr<const Shared_rules> m_rules;
  int m_first_level;
  FT m_smallest_weight;
  Point_3 m_vertex;
  std::vector<Homogeneous> m_coefficients;   // relative to the vertex
  std::vector<Homogeneous> m_first_controls; // at the first level, relative to the vertex
  std::vector<Patch> m_patches;              // per level and part, if there are no eigenvectors
  std::vector<FT> m_radii;                   // per level
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_RINGS_H
