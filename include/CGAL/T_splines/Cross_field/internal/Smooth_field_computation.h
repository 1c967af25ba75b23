// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H

#include <CGAL/T_splines/Cross_field/internal/Connection_laplacian.h>
#include <CGAL/T_splines/Cross_field/internal/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/internal/face_crosses.h>
#include <CGAL/T_splines/Cross_field/internal/mesh_components.h>
#include <CGAL/T_splines/Cross_field/internal/principal_crosses.h>
#include <CGAL/T_splines/Cross_field/internal/smallest_eigenvector.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What the computation of a smooth field may be asked for.
struct Smooth_field_options {
  std::vector<char> is_edge_constrained; ///< per edge
  double curvature_alignment = 0;
  int diffusion_steps = 0;
  unsigned int seed = 0;
};

/// The computation behind `compute_smooth_cross_field()`, in index arrays. Fields are fourth powers, in the frames of vertices
/// and faces.
template <typename SolverTraits>
class Smooth_field_computation {
  using Complex = std::complex<double>;
  static constexpr int null = Triangulation_connectivity::null;

public:
  Smooth_field_computation(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                           const Smooth_field_options& options, SolverTraits& solver)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_options(options),
      m_solver(solver),
      m_frames(vertex_frames(mesh, geometry)),
      m_fixed(mesh.number_of_vertices()),
      m_field(mesh.number_of_vertices()),
      m_is_face_fixed(mesh.number_of_faces(), 0),
      m_angle(mesh.number_of_faces(), 0.),
      m_trial_angle(mesh.number_of_faces(), 0.),
      m_counter(mesh, geometry)
  {
    if (std::find(options.is_edge_constrained.begin(), options.is_edge_constrained.end(), 1) !=
        options.is_edge_constrained.end())
      fix_vertices_and_faces();
    if (options.curvature_alignment > 0)
      m_guide = principal_crosses(mesh, geometry, m_frames);
    m_intrinsic = m_frames;
    make_delaunay(m_intrinsic);
  }

  /// computes the field on all components. \return `false` if the solver fails.
  template <typename Visitor>
  bool compute(const Mesh_components& components, const Visitor& visitor, bool& is_interrupted)
  {
    std::vector<std::vector<int>> vertices(components.size()), halfedges(components.size()), faces(components.size());
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (components.of_vertex[v] != null)
        vertices[components.of_vertex[v]].push_back(v);
    for (int h = 0; h < m_mesh.number_of_halfedges(); h += 2)
      halfedges[components.of_vertex[m_mesh.target(h)]].push_back(h);
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      faces[components.of_face[f]].push_back(f);
    for (int c = 0; c < components.size(); ++c) {
      is_interrupted = !visitor.go_on();
      if (is_interrupted)
        return true;
      visitor.progress(static_cast<double>(c) / components.size());
      if (!compute_component(vertices[c], halfedges[c], faces[c]))
        return false;
    }
    m_number_of_repaired = Low_vertex_repair(m_mesh, m_geometry, m_is_face_fixed, m_angle).repair();
    for (int c = 0; c < components.size(); ++c)
      m_number_of_singularities += m_counter.count(faces[c], vertices[c], m_angle);
    visitor.progress(1.);
    return true;
  }

  /// The angle of the cross in the frame of each face.
  const std::vector<double>& angles() const { return m_angle; }
  int number_of_repaired_vertices() const { return m_number_of_repaired; }
  int number_of_singularities() const { return m_number_of_singularities; }
  double energy() const { return m_energy; }

private:
  // A direction that `sum` of `total` edge lengths agree on; none if they contradict each other.
  static Complex agreed_direction(const Complex& sum, const double total)
  {
    return std::abs(sum) > 0.5 * total ? sum / std::abs(sum) : Complex(0);
  }

  void fix_vertices_and_faces()
  {
    std::vector<double> total(m_mesh.number_of_vertices(), 0.);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      const int e = m_mesh.edge(h);
      if (!m_options.is_edge_constrained[e])
        continue;
      m_fixed[m_mesh.source(h)] += std::polar(m_geometry.m_edge_length[e], 4 * m_frames.direction(h));
      total[m_mesh.source(h)] += m_geometry.m_edge_length[e];
    }
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_fixed[v] = agreed_direction(m_fixed[v], total[v]);
    m_face_direction.assign(m_mesh.number_of_faces(), 0.);
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      fix_face(f);
  }

  // With several marked edges the cross takes the direction of their mean, or of the longest one if they have none.
  void fix_face(const int f)
  {
    Complex sum(0);
    double total = 0, longest = 0, direction_of_longest = 0;
    int h = m_mesh.halfedge_of_face(f);
    for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h)) {
      const double length = m_geometry.m_edge_length[m_mesh.edge(h)];
      if (!m_options.is_edge_constrained[m_mesh.edge(h)])
        continue;
      sum += std::polar(length, 4 * m_geometry.direction(m_mesh, h));
      total += length;
      if (length > longest) {
        longest = length;
        direction_of_longest = m_geometry.direction(m_mesh, h);
      }
    }
    if (total == 0)
      return;
    m_is_face_fixed[f] = 1;
    m_face_direction[f] =
      total == longest || agreed_direction(sum, total) == Complex(0) ? direction_of_longest : std::arg(sum) / 4;
  }

  bool factorize(const Connection_laplacian& laplacian, const double a, const double b, const bool is_first)
  {
    const Symmetric_sparse_matrix<double> matrix = laplacian.combination(a, b);
    return (!is_first || m_solver.analyze_pattern(matrix)) && m_solver.factorize(matrix);
  }

  // A L + b M with the smallest b of a sequence for which the solver finds the matrix positive definite.
  bool factorize_shifted(const Connection_laplacian& laplacian, double& shift)
  {
    constexpr int number_of_trials = 4;
    for (int trial = 0; trial < number_of_trials; ++trial, shift *= 100)
      if (factorize(laplacian, 1., shift, trial == 0))
        return true;
    return false;
  }

  bool compute_component(const std::vector<int>& vertices, const std::vector<int>& halfedges,
                         const std::vector<int>& faces)
  {
    const Connection_laplacian laplacian(m_intrinsic, vertices, halfedges, m_fixed);
    for (const int v : vertices)
      m_field[v] = m_fixed[v];
    const bool is_guided = !m_guide.empty();
    if (!laplacian.free_vertices().empty()) {
      const bool has_fixed_vertices = laplacian.free_vertices().size() < vertices.size();
      const bool success = is_guided || has_fixed_vertices ? solve_linear(laplacian, is_guided) : solve_eigen(laplacian);
      if (!success)
        return false;
    }
    int fewest = -1;
    take_if_better(faces, vertices, fewest);
    if (!is_guided && !laplacian.free_vertices().empty() && m_options.diffusion_steps > 0) {
      if (!diffuse(laplacian))
        return false;
      take_if_better(faces, vertices, fewest);
    }
    return true;
  }

  // The smoothest field: the eigenvector of the smallest eigenvalue of the Laplacian.
  bool solve_eigen(const Connection_laplacian& laplacian)
  {
    constexpr int number_of_solves = 24;
    const std::size_t n = laplacian.free_vertices().size();
    double shift = 1e-2 / laplacian.area();
    if (!factorize_shifted(laplacian, shift))
      return false;
    std::vector<double> mass(2 * n), x(2 * n);
    std::mt19937 random(m_options.seed);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      mass[i] = laplacian.masses()[i / 2];
      x[i] = (static_cast<double>(random()) / 4294967296. - 0.5) * std::sqrt(mass[i]);
    }
    double eigenvalue = 0;
    if (!smallest_eigenvector(m_solver, mass, number_of_solves, x, eigenvalue))
      return false;
    m_energy += (std::max)(0., eigenvalue - shift) * laplacian.area();
    store(laplacian, x);
    return true;
  }

  // The smoothest field with given values, or the one that compromises with a guiding field.
  bool solve_linear(const Connection_laplacian& laplacian, const bool is_guided)
  {
    const std::vector<int>& vertices = laplacian.free_vertices();
    double alignment = is_guided ? m_options.curvature_alignment / laplacian.area() : 0.;
    std::vector<double> right_hand_side = laplacian.boundary_term(), x;
    if (is_guided) {
      double norm = 0;
      for (std::size_t i = 0; i < vertices.size(); ++i)
        norm += laplacian.masses()[i] * std::norm(m_guide[vertices[i]]);
      norm = std::sqrt(norm / laplacian.area());
      for (std::size_t i = 0; i < vertices.size() && norm > 0; ++i) {
        const Complex guide = m_guide[vertices[i]] * (alignment * laplacian.masses()[i] / norm);
        right_hand_side[2 * i] += guide.real();
        right_hand_side[2 * i + 1] += guide.imag();
      }
    }
    double shift = (std::max)(alignment, 1e-4 / laplacian.area());
    if (!factorize_shifted(laplacian, shift) || !m_solver.solve(right_hand_side, x))
      return false;
    store(laplacian, x);
    return true;
  }

  // Diffusion and projection to unit length by turns (Viertel and Osting, An approach to quad meshing based on harmonic
  // cross-valued maps and the Ginzburg-Landau theory, 2019): from the shortest energy in the mean to crosses of unit
  // length, of which pairs of singularities that are close to each other vanish.
  bool diffuse(const Connection_laplacian& laplacian)
  {
    const std::vector<int>& vertices = laplacian.free_vertices();
    const double time = 1e-2 * laplacian.area();
    std::vector<double> right_hand_side(2 * vertices.size()), x;
    if (!factorize(laplacian, time, 1., false))
      return false;
    for (int step = 0; step < m_options.diffusion_steps; ++step) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Complex value = m_field[vertices[i]];
        const double length = std::abs(value);
        const Complex unit = length > 0 ? value / length : Complex(0);
        right_hand_side[2 * i] = laplacian.masses()[i] * unit.real() + time * laplacian.boundary_term()[2 * i];
        right_hand_side[2 * i + 1] = laplacian.masses()[i] * unit.imag() + time * laplacian.boundary_term()[2 * i + 1];
      }
      if (!m_solver.solve(right_hand_side, x))
        return false;
      store(laplacian, x);
    }
    return true;
  }

  void store(const Connection_laplacian& laplacian, const std::vector<double>& x)
  {
    for (std::size_t i = 0; i < laplacian.free_vertices().size(); ++i)
      m_field[laplacian.free_vertices()[i]] = Complex(x[2 * i], x[2 * i + 1]);
  }

  // Carries the field over to the faces of a component, in two ways; takes the one with the fewest singularities if they
  // are fewer than before.
  void take_if_better(const std::vector<int>& faces, const std::vector<int>& vertices, int& fewest)
  {
    for (const bool is_normalized : {false, true}) {
      for (const int f : faces)
        m_trial_angle[f] = m_is_face_fixed[f]
                             ? m_face_direction[f]
                             : std::arg(value_in_face(m_mesh, m_geometry, m_frames, m_field, f, is_normalized)) / 4;
      const int number = m_counter.count(faces, vertices, m_trial_angle);
      if (fewest >= 0 && number >= fewest)
        continue;
      fewest = number;
      for (const int f : faces)
        m_angle[f] = m_trial_angle[f];
    }
  }

  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const Smooth_field_options& m_options;
  SolverTraits& m_solver;
  Vertex_frames m_frames, m_intrinsic;
  std::vector<Complex> m_fixed;         // per vertex: its given value, or 0
  std::vector<Complex> m_guide;         // per vertex: the principal cross; empty if there is no alignment
  std::vector<Complex> m_field;         // per vertex
  std::vector<char> m_is_face_fixed;
  std::vector<double> m_face_direction; // per fixed face
  std::vector<double> m_angle;          // per face: the result
  std::vector<double> m_trial_angle;    // per face
  Singularity_counter m_counter;
  double m_energy = 0;
  int m_number_of_repaired = 0;
  int m_number_of_singularities = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H
