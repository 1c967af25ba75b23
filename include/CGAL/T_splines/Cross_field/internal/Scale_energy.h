// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SCALE_ENERGY_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SCALE_ENERGY_H

#include <CGAL/T_splines/Cross_field/internal/Edge_distances.h>
#include <CGAL/T_splines/Cross_field/internal/Intrinsic_laplacian.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Solver/support/factorize.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The angle defect of each vertex: 2 pi, or pi on the border, minus the sum of its angles.
inline std::vector<double> angle_defects(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
{
  std::vector<double> defect(mesh.number_of_vertices(), 2 * CGAL_PI);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.face(h) == Triangulation_connectivity::null)
      defect[mesh.target(h)] -= CGAL_PI;
    else
      defect[mesh.target(h)] -= geometry.m_corner_angle[h];
  }
  return defect;
}

/// For each component, the radius of the disks over which `Scale_energy` spreads cones: a thirtieth of the square root of
/// its area.
inline std::vector<double> disk_radii(const Triangle_geometry& geometry, const Mesh_components& components)
{
  constexpr double relative_radius = 1. / 30;
  std::vector<double> radii(components.size(), 0.);
  for (std::size_t f = 0; f < geometry.m_area.size(); ++f)
    radii[components.of_face[f]] += geometry.m_area[f];
  for (double& radius : radii)
    radius = relative_radius * std::sqrt(radius);
  return radii;
}

/// computes the lower triangle C of W = C C^T in place. \return `false` if W is not positive definite.
inline bool cholesky(std::vector<std::vector<double>>& w)
{
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < j; ++k)
        w[i][j] -= w[i][k] * w[j][k];
      if (j < i)
        w[i][j] /= w[j][j];
    }
    if (!(w[i][i] > 0))
      return false;
    w[i][i] = std::sqrt(w[i][i]);
  }
  return true;
}

/// How much the sizes of a flat metric with a holonomy signature differ from those of the surface, in the linear
/// approximation of conformal maps: the energy E = 1/2 <xi, xi> of the closed 1-form xi that is the differential of the
/// logarithm of the scale.
///
/// With L the cotangent Laplacian, K the angle defects less the curvatures of the corners, q the curvatures of the cones
/// and s_i what is missing to the turning of strip i, xi is du plus a harmonic form, where L u = q - K; on the border
/// these are the natural conditions: nothing but the turning of the border is prescribed. With the harmonic forms omega_i = eta_i + d
/// psi_i cohomologous to the crossing forms eta_i of the strips, <omega_i, xi> = z_i = s_i + psi_i (q - K). So
///   E = 1/2 (q - K)^T L^+ (q - K) + 1/2 z^T W^-1 z, W_ij = <omega_i, omega_j>.
/// Angles are all that it depends on, not the size of the surface.
///
/// The energy of a point cone would be infinite on a smooth surface, and depend on the lengths of its edges on a mesh.
/// Each cone is therefore spread over a disk with the radius of `disk_radii()`, with weights that fall to zero at the rim. Two meshes of a surface have almost the same energies, then, as
/// soon as their edges are shorter than that; the energy is positive whether disks overlap or not. In z they are
/// points.
template <typename SolverTraits>
class Scale_energy {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param defects per vertex: the angle defect that cones have to make up for
  /// \param strips for each component 2g independent loops, and arcs, one less than its border has curves
  /// \param progress to be asked by `compute()` before anything is used
  Scale_energy(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
               const Mesh_components& components, std::vector<double> defects,
               const std::vector<std::vector<int>>& strips, SolverTraits& solver, Progress& progress)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_components(components),
      m_strips(strips),
      m_solver(solver),
      m_distances(mesh, geometry.m_edge_length),
      m_mass(mesh.number_of_vertices(), 0.),
      m_radius(disk_radii(geometry, components)),
      m_defect(std::move(defects)),
      m_laplacian(mesh, geometry, components, strips, progress),
      m_right_hand_side(m_laplacian.matrix().size())
  {
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) != null)
        m_mass[mesh.target(h)] += geometry.m_area[mesh.face(h)] / 3;
  }

  /// computes everything that the energies of `cones`, which are vertices, consist of.
  /// \return `false` if the solver fails, or `progress` is interrupted.
  /// Complexity: one factorization, and a solve per cone and strip.
  bool compute(const std::vector<int>& cones, Progress& progress)
  {
    if (m_laplacian.matrix().size() > 0 && !analyze_and_factorize(m_solver, m_laplacian.matrix(), progress))
      return false;
    m_disks.clear();
    for (const int v : cones) {
      m_disks.push_back(disk(v));
      if (!progress.go_on_after(10 * m_disks.back().size()))
        return false;
    }
    if (!progress.go_on() || !compute_defect_terms() || !compute_strip_terms(cones, progress))
      return false;
    const std::size_t n = cones.size(), number_of_solves = m_strips.size() + n;
    m_interaction.assign(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
      progress.progress(static_cast<double>(m_strips.size() + i) / static_cast<double>(number_of_solves));
      if (!progress.go_on())
        return false;
      for (const auto& [v, weight] : m_disks[i])
        add_to_right_hand_side(v, weight);
      if (!solve())
        return false;
      for (std::size_t j = 0; j <= i; ++j)
        m_interaction[i][j] = m_interaction[j][i] = mean_over_disk(j);
    }
    return true;
  }

  /// The Green's function between the disks of two cones, up to terms that cancel in energies if curvatures add up as
  /// they have to.
  double interaction(const int i, const int j) const { return m_interaction[i][j]; }

  /// The mean of the solution of L u = K over the disk of cone `i`, up to the same terms.
  double defect_potential(const int i) const { return m_defect_potential[i]; }

  /// 1/2 K^T L^+ K, up to the same terms.
  double defect_energy() const { return m_defect_energy; }

  int number_of_strips() const { return static_cast<int>(m_strips.size()); }

  /// z_l of a signature without cones in which strip `l` does not turn, up to the same terms.
  double strip_residual(const int l) const { return m_strip_residual[l]; }

  /// psi_l at cone `i`. Harmonic forms are smooth: the mean over the disk would hardly differ, if it were not for the
  /// jump of psi_l across the strip.
  double strip_potential(const int l, const int i) const { return m_strip_potential[l][i]; }

  /// replaces z by y = C^-1 z, where W = C C^T: the part of the energy that strips demand is 1/2 |y|^2.
  void to_orthonormal(std::vector<double>& z) const
  {
    for (std::size_t i = 0; i < z.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k)
        z[i] -= m_strip_matrix[i][k] * z[k];
      z[i] /= m_strip_matrix[i][i];
    }
  }

private:
  using Disk = std::vector<std::pair<int, double>>;

  // Vertices with weights of sum 1.
  Disk disk(const int center)
  {
    const double radius = m_radius[m_components.of_vertex[center]];
    Disk result;
    double sum = 0;
    m_distances.search(center, [&](const int v, const double distance) {
      if (distance >= radius)
        return false;
      result.emplace_back(v, m_mass[v] * (1 - distance / radius));
      sum += result.back().second;
      return true;
    });
    for (auto& vertex_and_weight : result)
      vertex_and_weight.second /= sum;
    return result;
  }

  bool compute_defect_terms()
  {
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      add_to_right_hand_side(v, m_defect[v]);
    if (!solve())
      return false;
    m_defect_energy = 0.5 * product_with_defects();
    m_defect_potential.clear();
    for (std::size_t i = 0; i < m_disks.size(); ++i)
      m_defect_potential.push_back(mean_over_disk(i));
    return true;
  }

  bool compute_strip_terms(const std::vector<int>& cones, Progress& progress)
  {
    // With omega_j = eta_j + d psi_j harmonic, <omega_i, omega_j> = <eta_i, omega_j>: no two of them are needed at once.
    const auto& forms = m_laplacian.forms();
    std::vector<double> psi(m_mesh.number_of_vertices());
    m_strip_residual.clear();
    m_strip_potential.assign(forms.size(), std::vector<double>());
    m_strip_matrix.assign(forms.size(), std::vector<double>(forms.size(), 0.));
    for (std::size_t l = 0; l < forms.size(); ++l) {
      progress.progress(static_cast<double>(l) / static_cast<double>(forms.size() + cones.size()));
      if (!progress.go_on())
        return false;
      m_laplacian.for_each_flow(forms[l], [this](const int v, const double flow) { add_to_right_hand_side(v, flow); });
      if (!solve())
        return false;
      for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
        psi[v] = solution(v);
      const std::vector<double> harmonic = m_laplacian.with_differential(forms[l], psi);
      for (std::size_t i = l; i < forms.size(); ++i)
        m_strip_matrix[i][l] = m_laplacian.product(forms[i], harmonic);
      const double turning = strip_turning(m_mesh, m_strips[l], m_geometry.m_corner_angle);
      m_strip_residual.push_back(-turning - product_with_defects());
      for (const int v : cones)
        m_strip_potential[l].push_back(psi[v]);
    }
    return cholesky(m_strip_matrix);
  }

  void add_to_right_hand_side(const int v, const double value)
  {
    if (m_laplacian.row(v) != null)
      m_right_hand_side[m_laplacian.row(v)] += value;
  }

  bool solve()
  {
    const bool is_solved = m_right_hand_side.empty() || m_solver.solve(m_right_hand_side, m_solution);
    std::fill(m_right_hand_side.begin(), m_right_hand_side.end(), 0.);
    return is_solved;
  }

  double solution(const int v) const { return m_laplacian.row(v) == null ? 0. : m_solution[m_laplacian.row(v)]; }

  double product_with_defects() const
  {
    double sum = 0;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      sum += m_defect[v] * solution(v);
    return sum;
  }

  double mean_over_disk(const std::size_t i) const
  {
    double mean = 0;
    for (const auto& [v, weight] : m_disks[i])
      mean += weight * solution(v);
    return mean;
  }

  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const Mesh_components& m_components;
  const std::vector<std::vector<int>>& m_strips;
  SolverTraits& m_solver;
  Edge_distances m_distances;
  std::vector<double> m_mass;   // per vertex: a third of the areas around it
  std::vector<double> m_radius; // per component: of the disks
  std::vector<double> m_defect; // per vertex
  Intrinsic_laplacian m_laplacian;
  std::vector<double> m_right_hand_side, m_solution;
  std::vector<Disk> m_disks; // per cone
  std::vector<std::vector<double>> m_interaction;
  std::vector<double> m_defect_potential; // per cone
  double m_defect_energy = 0;
  std::vector<double> m_strip_residual;               // per strip
  std::vector<std::vector<double>> m_strip_potential; // per strip and cone
  std::vector<std::vector<double>> m_strip_matrix;    // C
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SCALE_ENERGY_H
