// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H

#include <CGAL/T_splines/Cross_field/internal/Connection_laplacian.h>
#include <CGAL/T_splines/Cross_field/internal/Low_vertex_repair.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_sectors.h>
#include <CGAL/T_splines/Cross_field/internal/face_crosses.h>
#include <CGAL/T_splines/Cross_field/internal/principal_crosses.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Solver/support/Multigrid.h>
#include <CGAL/T_splines/Solver/support/multigrid_iterations.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

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
  std::vector<double> edge_deviation;    ///< per constrained edge: from its direction to that of the cross
  double curvature_alignment = 0;
  int diffusion_steps = 0;
  unsigned int seed = 0;
};

/// The computation behind `compute_smooth_cross_field()`, in index arrays. Fields are fourth powers, in the frames of vertices
/// and faces.
class Smooth_field_computation {
  using Complex = std::complex<double>;
  static constexpr int most_iterations = 200;
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param progress it must outlive this
  Smooth_field_computation(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                           const Smooth_field_options& options, Progress& progress)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_options(options),
      m_progress(progress),
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
    if (m_progress.go_on())
      make_delaunay(m_intrinsic, m_progress);
  }

  /// computes the field on all components. \return `false` if the progress is interrupted.
  bool compute(const Mesh_components& components)
  {
    if (!compute_unrepaired(components))
      return false;
    const Vertex_sectors sectors(m_mesh, {});
    const std::vector<double> of_no_matter(m_mesh.number_of_edges(), 0.); // of the border, which is left alone
    Low_vertex_repair repair(m_mesh, m_geometry, sectors, of_no_matter, Low_vertex_repair::Fixed_crosses::GIVE_WAY,
                             m_is_face_fixed, m_angle, m_progress);
    m_number_of_repaired = repair.repair();
    m_rotation = repair.rotations();
    if (!m_progress.go_on())
      return false;
    for (int c = 0; c < components.size(); ++c)
      m_number_of_singularities += m_counter.count(m_faces[c], m_vertices[c], m_angle, m_progress);
    m_progress.progress(1.);
    return m_progress.go_on();
  }

  /// computes the field as the smoothest crosses are, whatever quarter turns they make around vertices.
  /// \return `false` if the progress is interrupted.
  bool compute_unrepaired(const Mesh_components& components)
  {
    m_vertices.resize(components.size());
    m_faces.resize(components.size());
    std::vector<std::vector<int>> halfedges(components.size());
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (components.of_vertex[v] != null)
        m_vertices[components.of_vertex[v]].push_back(v);
    for (int e = 0; e < m_mesh.number_of_edges(); ++e) {
      const int h = halfedge_of_edge(e);
      halfedges[components.of_vertex[m_mesh.target(h)]].push_back(h);
    }
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      m_faces[components.of_face[f]].push_back(f);
    for (int c = 0; c < components.size(); ++c) {
      const double n = components.size();
      const Progress::Part part(m_progress, 0.1 + 0.8 * c / n, 0.1 + 0.8 * (c + 1) / n);
      if (!m_progress.go_on())
        return false;
      compute_component(m_vertices[c], halfedges[c], m_faces[c]);
      m_progress.progress(1);
    }
    return m_progress.go_on();
  }

  /// The angle of the cross in the frame of each face.
  const std::vector<double>& angles() const { return m_angle; }
  /// Whether a face has an edge that is constrained.
  const std::vector<char>& is_face_fixed() const { return m_is_face_fixed; }
  /// The rotation of the cross across each edge, as `Low_vertex_repair` leaves it.
  const std::vector<double>& rotations() const { return m_rotation; }
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
      const int e = edge_of(h);
      if (!m_options.is_edge_constrained[e])
        continue;
      m_fixed[m_mesh.source(h)] +=
          std::polar(m_geometry.m_edge_length[e], 4 * (m_frames.direction(h) + m_options.edge_deviation[e]));
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
      const double length = m_geometry.m_edge_length[edge_of(h)];
      if (!m_options.is_edge_constrained[edge_of(h)])
        continue;
      const double direction = m_geometry.direction(m_mesh, h) + m_options.edge_deviation[edge_of(h)];
      sum += std::polar(length, 4 * direction);
      total += length;
      if (length > longest) {
        longest = length;
        direction_of_longest = direction;
      }
    }
    if (total == 0)
      return;
    m_is_face_fixed[f] = 1;
    m_face_direction[f] =
        total == longest || agreed_direction(sum, total) == Complex(0) ? direction_of_longest : std::arg(sum) / 4;
  }

  void compute_component(const std::vector<int>& vertices, const std::vector<int>& halfedges,
                         const std::vector<int>& faces)
  {
    const Connection_laplacian laplacian(m_intrinsic, vertices, halfedges, m_fixed, m_progress);
    for (const int v : vertices)
      m_field[v] = m_fixed[v];
    int fewest = -1;
    if (laplacian.free_vertices().empty()) {
      take_if_better(faces, vertices, fewest);
      return;
    }
    const bool is_guided = !m_guide.empty();
    const bool has_fixed_vertices = laplacian.free_vertices().size() < vertices.size();
    const double alignment = is_guided ? m_options.curvature_alignment / laplacian.area() : 0.;
    // By the area. The shift makes the matrix definite; where part of the field is given, it also pulls the rest to 0.
    constexpr double small_shift = 1e-4, free_shift = 1e-2;
    const double shift =
        (std::max)(alignment, (is_guided || has_fixed_vertices ? small_shift : free_shift) / laplacian.area());
    if (!m_progress.go_on())
      return;
    Multigrid<Complex> multigrid(laplacian.shifted(shift), m_progress);
    m_progress.progress(0.2);
    if (is_guided || has_fixed_vertices)
      solve_linear(laplacian, alignment, multigrid);
    else
      solve_eigen(laplacian, shift, multigrid);
    m_progress.progress(0.5);
    if (!m_progress.go_on())
      return;
    take_if_better(faces, vertices, fewest);
    if (!is_guided && m_options.diffusion_steps > 0) {
      diffuse(laplacian, shift, multigrid);
      if (m_progress.go_on())
        take_if_better(faces, vertices, fewest);
    }
  }

  // The smoothest field: the eigenvector of the smallest eigenvalue of the Laplacian.
  void solve_eigen(const Connection_laplacian& laplacian, const double shift, Multigrid<Complex>& multigrid)
  {
    std::vector<Complex> x;
    const double eigenvalue = smallest_eigenvector(multigrid, laplacian.masses(), m_options.seed, x, m_progress);
    if (m_progress.is_interrupted())
      return;
    m_energy += (std::max)(0., eigenvalue - shift) * laplacian.area();
    store(laplacian, x);
  }

  // The smoothest field with given values, or the one that compromises with a guiding field.
  void solve_linear(const Connection_laplacian& laplacian, const double alignment, Multigrid<Complex>& multigrid)
  {
    const std::vector<int>& vertices = laplacian.free_vertices();
    std::vector<Complex> right_hand_side = laplacian.boundary_term(), x(vertices.size());
    if (alignment > 0) {
      double norm = 0;
      for (std::size_t i = 0; i < vertices.size(); ++i)
        norm += laplacian.masses()[i] * std::norm(m_guide[vertices[i]]);
      norm = std::sqrt(norm / laplacian.area());
      for (std::size_t i = 0; i < vertices.size() && norm > 0; ++i)
        right_hand_side[i] += m_guide[vertices[i]] * (alignment * laplacian.masses()[i] / norm);
    }
    const std::vector<double> none(vertices.size(), 0.);
    constexpr double residual = 1e-8; // directions of crosses are not used with more digits
    solve_with_multigrid(multigrid, 1., none, right_hand_side, x, residual, most_iterations, m_progress);
    store(laplacian, x);
  }

  // Diffusion and projection to unit length by turns (Viertel and Osting, An approach to quad meshing based on harmonic
  // cross-valued maps and the Ginzburg-Landau theory, 2019): from the shortest energy in the mean to crosses of unit
  // length, of which pairs of singularities that are close to each other vanish.
  void diffuse(const Connection_laplacian& laplacian, const double shift, Multigrid<Complex>& multigrid)
  {
    constexpr double tolerance = 1e-3, last_tolerance = 1e-4; // crosses are projected after each step
    const std::vector<int>& vertices = laplacian.free_vertices();
    constexpr double share_of_area = 1e-2; // pairs that are nearer than about a tenth of the size vanish
    const double time = share_of_area * laplacian.area();
    std::vector<double> mass = laplacian.masses();
    for (double& m : mass)
      m *= 1 - time * shift;
    std::vector<Complex> right_hand_side(vertices.size()), x(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      x[i] = m_field[vertices[i]];
    for (int step = 0; step < m_options.diffusion_steps && m_progress.go_on(); ++step) {
      m_progress.progress(0.5 + 0.5 * step / m_options.diffusion_steps);
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const double length = magnitude(x[i]);
        const Complex unit = length > 0 ? x[i] / length : Complex(0);
        right_hand_side[i] = laplacian.masses()[i] * unit + time * laplacian.boundary_term()[i];
        if (step == 0)
          x[i] = unit / 2.;
      }
      solve_with_multigrid(multigrid, time, mass, right_hand_side, x,
                           step + 1 < m_options.diffusion_steps ? tolerance : last_tolerance, most_iterations,
                           m_progress);
    }
    store(laplacian, x);
  }

  void store(const Connection_laplacian& laplacian, const std::vector<Complex>& x)
  {
    for (std::size_t i = 0; i < laplacian.free_vertices().size(); ++i)
      m_field[laplacian.free_vertices()[i]] = x[i];
  }

  // Carries the field over to the faces of a component, in two ways; takes the one with the fewest singularities if they
  // are fewer than before.
  void take_if_better(const std::vector<int>& faces, const std::vector<int>& vertices, int& fewest)
  {
    for (const bool is_normalized : {false, true}) {
      if (!m_progress.go_on())
        return;
      for (const int f : faces)
        m_trial_angle[f] = m_is_face_fixed[f]
                               ? m_face_direction[f]
                               : std::arg(value_in_face(m_mesh, m_geometry, m_frames, m_field, f, is_normalized)) / 4;
      const int number = m_counter.count(faces, vertices, m_trial_angle, m_progress);
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
  Progress& m_progress;
  Vertex_frames m_frames, m_intrinsic;
  std::vector<std::vector<int>> m_vertices, m_faces; // per component
  std::vector<Complex> m_fixed;                      // per vertex: its given value, or 0
  std::vector<Complex> m_guide;                      // per vertex: the principal cross; empty if there is no alignment
  std::vector<Complex> m_field;                      // per vertex
  std::vector<char> m_is_face_fixed;
  std::vector<double> m_face_direction; // per fixed face
  std::vector<double> m_angle;          // per face: the result
  std::vector<double> m_trial_angle;    // per face
  std::vector<double> m_rotation;       // per edge
  Singularity_counter m_counter;
  double m_energy = 0;
  int m_number_of_repaired = 0;
  int m_number_of_singularities = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMOOTH_FIELD_COMPUTATION_H
