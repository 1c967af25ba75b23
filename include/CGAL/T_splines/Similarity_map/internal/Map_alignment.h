// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ALIGNMENT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ALIGNMENT_H

#include <CGAL/T_splines/Cross_field/support/Feature_arcs.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/Similarity_map/Map_alignment_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Alignment_energy.h>
#include <CGAL/T_splines/Similarity_map/internal/Alignment_rows.h>
#include <CGAL/T_splines/Similarity_map/internal/Field_in_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Open_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Projected_newton.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A cross field and constrained edges, in index arrays.
struct Alignment_target {
  std::vector<double> angle;        ///< per halfedge: of the cross in its face, relative to the halfedge
  std::vector<double> rotation;     ///< per edge: of the field, as `field_rotations()` has them
  std::vector<char> is_constrained; ///< per edge; all border edges are
};

struct Alignment_options {
  Scale_policy scale_policy = Scale_policy::UNIT_IF_CONSTRAINED;
  double distortion_weight = default_distortion_weight;
};

/// What a `Map_alignment_report` says, by index.
struct Map_alignment_figures {
  static constexpr int none = -1;

  Map_alignment_status status = Map_alignment_status::ALIGNED;
  int halfedge = none, vertex = none;
  std::vector<int> faces;
  double deviation = 0;
  Field_misalignment before, rotated, after;
  int number_of_steps = 0;
  double largest_log_scale_before = 0, largest_log_scale_after = 0;
  double mean_distortion = 0, largest_distortion = 0;
  std::size_t number_of_constrained_edges = 0;
  std::vector<int> edges_not_met;
};

/// Aligns a map to a cross field: the steps of `align_seamless_map()`, by index.
template <typename SolverTraits>
class Map_alignment {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param map with its cut
  /// \param solver, progress they must outlive this
  Map_alignment(const Open_map& map, const Triangle_geometry& geometry, const Alignment_target& target,
                const Alignment_options& options, SolverTraits& solver, Progress& progress)
    : m_map(map),
      m_mesh(map.mesh()),
      m_geometry(geometry),
      m_target(target),
      m_options(options),
      m_solver(solver),
      m_progress(progress),
      m_area(geometry.m_area),
      m_uv(map.uv())
  {
    const double sum = std::accumulate(m_area.begin(), m_area.end(), 0.);
    for (double& area : m_area)
      area /= sum;
  }

  /// Runs all steps. \return whether there is a map
  bool run()
  {
    const Mesh_components components = mesh_components(m_mesh);
    const Field_in_map field(m_mesh, components, m_uv, m_target.angle, m_target.rotation, m_area);
    if (field.first_jump().first != m_mesh.null)
      return fail(Map_alignment_status::FIELD_OF_OTHER_SIGNATURE, field.first_jump().first, field.first_jump().second);
    if (!choose_axes(field))
      return false;
    m_figures.before = misalignment([&](const Index f) { return field[f]; });
    turn_components(components, field);
    m_figures.rotated = misalignment([&](const Index f) { return m_angle[f]; });
    choose_scales();
    const Alignment_rows rows(m_map, m_scale);
    Alignment_energy energy = alignment_energy();
    std::vector<double> x = scaled_unknowns(rows);
    return minimize(rows, energy, x) && finish(energy, x);
  }

  const Map_alignment_figures& figures() const { return m_figures; }
  const Uv_array& uv() const { return m_uv; }

private:
  bool fail(const Map_alignment_status status, const int halfedge = Map_alignment_figures::none,
            const double deviation = 0)
  {
    m_figures.status = m_progress.is_interrupted() ? Map_alignment_status::INTERRUPTED : status;
    m_figures.halfedge = halfedge;
    m_figures.deviation = deviation;
    return false;
  }

  /// \param angle function object: face -> angle of the field to the map
  template <typename Angle>
  Field_misalignment misalignment(const Angle& angle) const
  {
    std::vector<std::pair<double, double>> angles; // and areas
    Field_misalignment result;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      angles.emplace_back(std::abs(angle(f)), m_area[f]);
      result.mean += angles.back().first * m_area[f];
    }
    std::sort(angles.begin(), angles.end());
    double area = 0;
    for (const auto& [a, weight] : angles) {
      area += weight;
      result.quantile_95 = a;
      if (area >= 0.95)
        break;
    }
    return result;
  }

  // The axis along which each constrained edge has one coordinate: the one next to it once the map is turned to the field.
  bool choose_axes(const Field_in_map& field)
  {
    constexpr double largest_deviation = CGAL_PI / 6; // of a field that means to follow an edge
    for (Index e = 0; e < m_mesh.number_of_edges(); ++e) {
      if (m_target.is_constrained[e] == 0)
        continue;
      const Index h =
          m_mesh.face(halfedge_of_edge(e)) != m_mesh.null ? halfedge_of_edge(e) : opposite(halfedge_of_edge(e));
      const bool is_on_border =
          m_mesh.face(opposite(h)) == m_mesh.null; // which has its axes already, where it is noisy, too
      const double off = std::abs(std::remainder(m_target.angle[h], quarter_turn));
      if (!is_on_border && off > largest_deviation)
        return fail(Map_alignment_status::FIELD_NOT_ALIGNED, h, off);
      const std::array<double, 2>&p = m_uv[m_mesh.previous(h)], &q = m_uv[h];
      const double in_map = std::atan2(q[1] - p[1], q[0] - p[0]),
                   turns = (is_on_border ? in_map : in_map - field.at_halfedge(h)) / quarter_turn;
      m_edges.push_back({h, std::lround(turns) % 2 == 0 ? 1 : 0});
    }
    m_figures.number_of_constrained_edges = m_edges.size();
    return true;
  }

  // Components without constrained edges may be turned as they like.
  void turn_components(const Mesh_components& components, const Field_in_map& field)
  {
    std::vector<double> turn(components.size());
    for (int c = 0; c < components.size(); ++c)
      turn[c] = -field.mean(c);
    for (const Isoline_edge& edge : m_edges)
      turn[components.of_face[m_mesh.face(edge.halfedge)]] = 0;
    std::vector<Plane_matrix> rotation;
    for (const double angle : turn)
      rotation.push_back(Plane_matrix::rotation_by(angle));
    m_angle.resize(m_mesh.number_of_faces());
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      m_angle[f] = field[f] + turn[components.of_face[f]];
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) != m_mesh.null && turn[components.of_face[m_mesh.face(h)]] != 0) {
        const Plane_matrix& r = rotation[components.of_face[m_mesh.face(h)]];
        m_uv[h] = {{r.a * m_uv[h][0] + r.b * m_uv[h][1], r.c * m_uv[h][0] + r.d * m_uv[h][1]}};
      }
  }

  bool has_inner_edges() const
  {
    return std::any_of(m_edges.begin(), m_edges.end(), [this](const Isoline_edge& edge) {
      return m_mesh.face(opposite(edge.halfedge)) != m_mesh.null;
    });
  }

  void choose_scales()
  {
    constexpr double round_off = 1e-9;
    const std::vector<Branch_fit>& fits = m_map.fits();
    for (const Branch_fit& fit : fits) {
      const double log_scale = std::log(fit.scale());
      m_figures.largest_log_scale_before = std::max(m_figures.largest_log_scale_before, std::abs(log_scale));
      m_scale.push_back(std::abs(log_scale) < round_off ? 1. : fit.scale());
    }
    const bool is_unit = m_options.scale_policy == Scale_policy::UNIT ||
                         (m_options.scale_policy == Scale_policy::UNIT_IF_CONSTRAINED && has_inner_edges());
    if (is_unit)
      m_scale.assign(fits.size(), 1.);
    else if (m_options.scale_policy == Scale_policy::DYADIC)
      m_scale = m_map.dyadic_scales();
    for (std::size_t b = 0; b < fits.size(); ++b) {
      m_changes_scales = m_changes_scales || std::abs(std::log(m_scale[b] / fits[b].scale())) > round_off;
      m_figures.largest_log_scale_after = std::max(m_figures.largest_log_scale_after, std::abs(std::log(m_scale[b])));
    }
  }

  // The triangles as the map has them, turned to the field; if scale factors change, of the size that they have in space.
  Alignment_energy alignment_energy()
  {
    std::vector<Alignment_energy::Triangle> triangles;
    std::vector<Plane_matrix> reference;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      const Index h = m_mesh.halfedge_of_face(f), j = m_mesh.next(h), k = m_mesh.next(j);
      triangles.push_back({{m_map.open()[h], m_map.open()[j], m_map.open()[k]}});
      const Plane_matrix edges{m_uv[j][0] - m_uv[h][0], m_uv[k][0] - m_uv[h][0], m_uv[j][1] - m_uv[h][1],
                               m_uv[k][1] - m_uv[h][1]};
      m_growth.push_back(m_changes_scales ? std::sqrt(2 * m_area[f] / edges.determinant()) : 1.);
      const Plane_matrix turned = Plane_matrix::rotation_by(-m_angle[f]) * edges;
      reference.push_back(
          {turned.a * m_growth[f], turned.b * m_growth[f], turned.c * m_growth[f], turned.d * m_growth[f]});
    }
    return Alignment_energy(std::move(triangles), reference, m_area, m_options.distortion_weight);
  }

  // The map, of the size that suits its references best.
  std::vector<double> scaled_unknowns(const Alignment_rows& rows)
  {
    double log_growth = 0;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      log_growth += m_area[f] * std::log(m_growth[f]);
    std::vector<double> x = rows.unknowns(m_uv);
    for (double& coordinate : x)
      coordinate *= std::exp(log_growth);
    for (std::array<double, 2>& corner : m_uv)
      corner = {{corner[0] * std::exp(log_growth), corner[1] * std::exp(log_growth)}};
    return x;
  }

  // If not all edges can lie on isolines, the weakest arcs of those that stay off them are given up.
  bool minimize(const Alignment_rows& rows, Alignment_energy& energy, std::vector<double>& x)
  {
    const std::vector<double> start = x;
    while (!minimize_with_edges(rows, energy, x)) {
      if (m_figures.status != Map_alignment_status::CONSTRAINTS_NOT_MET || !give_up_arcs(rows, x))
        return false;
      m_figures.status = Map_alignment_status::ALIGNED;
      x = start;
    }
    if (!m_figures.edges_not_met.empty())
      m_figures.status = Map_alignment_status::CONSTRAINTS_NOT_MET;
    return true;
  }

  bool minimize_with_edges(const Alignment_rows& rows, Alignment_energy& energy, std::vector<double>& x)
  {
    constexpr double round_off = 1e-9; // an angle: of edges that lie on isolines already
    std::vector<Isoline_edge> met, open;
    for (const Isoline_edge& edge : m_edges)
      (rows.misalignment(edge, x) < round_off ? met : open).push_back(edge);
    Linear_parameters space(rows.number_of_unknowns());
    space.add(m_changes_scales ? rows.translation_equations() : rows.seam_equations());
    space.add(rows.isoline_equations(met));
    if (!m_changes_scales && open.empty()) {
      x = space.unknowns(space.parameters(x)); // but for round-off it is there already
      return minimize_in(space, energy, true, x);
    }
    if (!approach(rows, space, open, energy, x))
      return false;
    Linear_parameters all(rows.number_of_unknowns());
    all.add(rows.seam_equations());
    all.add(rows.isoline_equations(m_edges));
    return minimize_in(all, energy, false, x);
  }

  // The arcs that turn least, by the integral of the angle between their two sides: one, and twice as many each time from
  // the third on, so that it ends soon where many cannot be met. \param x where they are off
  bool give_up_arcs(const Alignment_rows& rows, const std::vector<double>& x)
  {
    constexpr double clearly = 0.1; // by the largest angle: the others are dragged along
    std::vector<char> is_constrained(m_mesh.number_of_edges(), 0);
    std::vector<double> off(m_mesh.number_of_edges(), 0.);
    double largest = 0;
    for (const Isoline_edge& edge : m_edges) {
      is_constrained[edge_of(edge.halfedge)] = 1;
      off[edge_of(edge.halfedge)] = rows.misalignment(edge, x);
      largest = std::max(largest, off[edge_of(edge.halfedge)]);
    }
    const Feature_arcs graph(m_mesh, is_constrained);
    std::vector<std::pair<double, const Feature_arcs::Arc*>> arcs; // with their turns
    for (const Feature_arcs::Arc& arc : graph.arcs()) {
      if (std::none_of(arc.halfedges.begin(), arc.halfedges.end(),
                       [&](const Index h) { return off[edge_of(h)] > clearly * largest; }))
        continue;
      arcs.emplace_back(0., &arc);
      for (const Index h : arc.halfedges)
        arcs.back().first +=
            m_geometry.m_edge_length[edge_of(h)] * std::abs(dihedral_angle(m_mesh, m_geometry, edge_of(h)));
    }
    if (arcs.empty())
      return false;
    std::stable_sort(arcs.begin(), arcs.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    const std::size_t number = std::size_t(1) << std::clamp(m_times_given_up - 1, 0, 20);
    ++m_times_given_up;
    for (std::size_t i = 0; i < std::min(number, arcs.size()); ++i)
      for (const Index h : arcs[i].second->halfedges)
        is_constrained[edge_of(h)] = 0;
    for (const Isoline_edge& edge : m_edges)
      if (is_constrained[edge_of(edge.halfedge)] == 0)
        m_figures.edges_not_met.push_back(edge_of(edge.halfedge));
    m_edges.erase(std::remove_if(m_edges.begin(), m_edges.end(),
                                 [&](const Isoline_edge& edge) { return is_constrained[edge_of(edge.halfedge)] == 0; }),
                  m_edges.end());
    return true;
  }

  // The minimum in the space of the equations. \param is_in_space whether `x` satisfies them; else the next point does
  bool minimize_in(const Linear_parameters& space, const Alignment_energy& energy, const bool is_in_space,
                   std::vector<double>& x)
  {
    constexpr double tolerance = 1e-6;
    constexpr int most_steps = 100;
    Projected_newton<SolverTraits> newton(energy, space, m_solver, m_progress);
    if (!is_in_space && !newton.project(x))
      return fail(Map_alignment_status::SOLVER_FAILED);
    if (!std::isfinite(energy.value(x)))
      return fail(has_inner_edges() ? Map_alignment_status::CONSTRAINTS_NOT_MET : Map_alignment_status::SCALES_NOT_MET);
    const Minimization_end end = newton.minimize(x, tolerance, most_steps);
    m_figures.number_of_steps += newton.number_of_steps();
    return end != Minimization_end::SOLVER_FAILED || fail(Map_alignment_status::SOLVER_FAILED);
  }

  // Comes near to all equations, by penalties that grow. Those of seams are large from the start, so that no vertex slips
  // through a seam.
  bool approach(const Alignment_rows& rows, const Linear_parameters& space, const std::vector<Isoline_edge>& edges,
                Alignment_energy& energy, std::vector<double>& x)
  {
    constexpr double first = 100, last = 1e10, growth = 100, of_seams = 1000, largest_of_seams = 1e10;
    constexpr double near = 1e-4; // an angle, or a length by an edge
    // What can be met comes nearer by the growth of the factor, what cannot by about the fourth root of it.
    constexpr double least_decrease = 10;
    constexpr double tolerance = 1e-4;
    constexpr int most_steps = 60;
    const std::vector<Penalty_row> isolines = rows.isoline_penalties(edges, m_uv, m_geometry.m_edge_length);
    std::vector<Penalty_row> seams;
    if (m_changes_scales)
      seams = rows.seam_penalties(m_uv, m_geometry.m_edge_length);
    const auto set_penalties = [&](const double factor) {
      energy.set_penalties({{&isolines, factor}, {&seams, std::min(of_seams * factor, largest_of_seams)}});
    };
    set_penalties(first);
    Projected_newton<SolverTraits> newton(energy, space, m_solver, m_progress);
    double off_isolines = 0, off_seams = 0;
    bool is_near = false, is_hopeless = false;
    for (double factor = first; factor <= last && !is_near && !is_hopeless; factor *= growth) {
      set_penalties(factor);
      newton.forget_factorization();
      if (newton.minimize(x, tolerance, most_steps) == Minimization_end::SOLVER_FAILED)
        return fail(Map_alignment_status::SOLVER_FAILED);
      const double before = off_isolines;
      off_isolines = 0;
      for (const Isoline_edge& edge : edges)
        off_isolines = std::max(off_isolines, rows.misalignment(edge, x));
      off_seams = Alignment_rows::largest_residual(seams, x);
      is_near = off_isolines < near && off_seams < near;
      is_hopeless = factor > growth * first && off_isolines > before / least_decrease;
    }
    energy.set_penalties({});
    m_figures.number_of_steps += newton.number_of_steps();
    return is_near ||
           fail(off_isolines < near ? Map_alignment_status::SCALES_NOT_MET : Map_alignment_status::CONSTRAINTS_NOT_MET);
  }

  // The angles of all vertices in quarter turns: positive areas do not tell those that are off by full turns.
  std::vector<int> quarter_turns(const Uv_array& uv) const
  {
    std::vector<double> angle(m_mesh.number_of_vertices(), 0.);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) != m_mesh.null)
        angle[m_mesh.target(h)] += uv_angle(m_mesh, uv, h);
    std::vector<int> result;
    for (const double a : angle)
      result.push_back(static_cast<int>(std::lround(a / quarter_turn)));
    return result;
  }

  bool finish(const Alignment_energy& energy, const std::vector<double>& x)
  {
    m_map.open().write(x, m_uv);
    m_figures.faces = faces_not_positive(m_mesh, m_uv);
    m_figures.after = misalignment([&](const Index f) { return energy.deformation(f, x).rotation(); });
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      const double distortion = Plane_distortion::symmetric_dirichlet(energy.deformation(f, x));
      m_figures.mean_distortion += m_area[f] * distortion;
      m_figures.largest_distortion = std::max(m_figures.largest_distortion, distortion);
    }
    if (!m_figures.faces.empty())
      return fail(Map_alignment_status::FLIPPED_TRIANGLES);
    const std::vector<int> before = quarter_turns(m_map.uv()), after = quarter_turns(m_uv);
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (before[v] != after[v]) {
        m_figures.vertex = v;
        return fail(Map_alignment_status::TURNED_VERTEX);
      }
    return true;
  }

  const Open_map& m_map;
  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const Alignment_target& m_target;
  const Alignment_options& m_options;
  SolverTraits& m_solver;
  Progress& m_progress;
  std::vector<double> m_area; // per face; they sum to 1
  Uv_array m_uv;              // per halfedge
  std::vector<Isoline_edge> m_edges;
  std::vector<double> m_angle;  // per face: from the u-axis to the field
  std::vector<double> m_scale;  // per branch, asked for
  std::vector<double> m_growth; // per face: of its reference
  int m_times_given_up = 0;     // arcs
  bool m_changes_scales = false;
  Map_alignment_figures m_figures;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ALIGNMENT_H
