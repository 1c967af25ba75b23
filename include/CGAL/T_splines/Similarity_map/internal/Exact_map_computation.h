// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Border_lines.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_corners.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_scales.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Scale_cycles.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/Similarity_map/internal/isolines_of_cones.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/exactness.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What an `Exact_map_report` says, by index.
struct Exact_map_figures {
  static constexpr int none = -1;

  Exact_map_status status = Exact_map_status::EXACT;
  int vertex = none, halfedge = none;
  std::vector<int> faces;
  double deviation = 0;
  int scale_bits = 0;
  bool is_isometric = true;
  double largest_displacement = 0;
  int number_of_joined_lines = 0, number_of_lines_left_apart = 0;
  double largest_gap = 0;
};

/// Makes a map that is seamless up to round-off exactly seamless: the steps of `make_exactly_seamless()`, by index.
/// \tparam FT the number type of the transitions
template <typename FT>
class Exact_map_computation {
  using Index = Triangulation_connectivity::Index;

public:
  static constexpr int none = -1;

  /// \param is_constrained per edge: those that are to lie on isolines; empty for none
  /// \param tolerance of the transitions, relative
  /// \param progress it must outlive this
  Exact_map_computation(Triangulation_connectivity mesh, Uv_array uv, std::vector<char> is_constrained,
                        const double tolerance, Progress& progress)
    : m_mesh(std::move(mesh)),
      m_uv(std::move(uv)),
      m_is_constrained(std::move(is_constrained)),
      m_tolerance(tolerance),
      m_progress(progress)
  {
  }

  /// Runs all steps. \return whether the layout is complete
  bool run()
  {
    const bool is_complete = run_steps();
    if (m_progress.is_interrupted()) {
      m_figures = Exact_map_figures();
      m_figures.status = Exact_map_status::INTERRUPTED;
    }
    return is_complete && !m_progress.is_interrupted();
  }

  const Exact_map_figures& figures() const { return m_figures; }
  Seamless_layout<FT>& layout() { return m_layout; }

private:
  // Reports the share of the work that is done. \return whether to go on
  bool is_at(const double fraction)
  {
    m_progress.progress(fraction);
    return m_progress.go_on();
  }

  bool run_steps()
  {
    if (!is_at(0) || !check_coordinates() || !check_triangles() || !is_at(0.1))
      return false;
    const Uv_seams seams(m_mesh, m_uv, m_tolerance);
    if (!is_at(0.3))
      return false;
    const Cut_sectors sectors(m_mesh, seams.cut_edges());
    const Isoline_arcs arcs(m_mesh, m_uv, std::move(m_is_constrained));
    const Border_lines border(m_mesh, m_uv, sectors, arcs);
    std::vector<int> quarter_turns; // per cut vertex
    if (!check_isolines(border, arcs) || !read_cone_angles(sectors, seams.cut_edges(), quarter_turns))
      return false;
    const Cut_graph graph(m_mesh, sectors, nodes(sectors, quarter_turns), border.loops());
    std::vector<Branch_fit> fits;
    if (!fit_branches(graph, fits))
      return false;
    const Cut_map map{m_mesh, m_uv, seams.cut_edges(), sectors, border, graph, fits, quarter_turns, m_size};
    const std::vector<double> uncertainty = scale_uncertainty(fits);
    const std::vector<Cut_node_kind> kinds = kinds_of_nodes(map, uncertainty);
    if (!check_scale_products(map, kinds))
      return false;
    if (!is_at(0.4))
      return false;
    m_layout = Seamless_layout<FT>(m_mesh, m_uv);
    m_layout.set_constrained_edges(arcs.constrained_edges());
    std::vector<int> counted = counted_quarter_turns();
    if (!is_at(0.5))
      return false;
    Exact_corners corners(map, arcs, other_free_points(map, arcs, counted));
    if (!is_at(0.6))
      return false;
    std::vector<Isoline_coincidence> lines = border.sides(quarter_turns);
    for (Isoline_coincidence& line : corners.arcs().coincidences())
      lines.push_back(std::move(line));
    std::vector<Exponents> cycles;
    if (!arcs.is_empty())
      cycles = Scale_cycles(map, lines).cycles();
    Exact_transitions<double> trial(map, corners.points(), kinds, uncertainty, cycles, m_progress);
    Exact_transitions<FT> transitions(map, corners.points(), kinds, uncertainty, cycles, m_progress);
    m_figures.is_isometric = trial.is_isometric();
    return check_closing(map, trial) && is_at(0.7) && make_exact(map, corners, lines, trial, transitions) &&
           is_at(0.9) && check_quarter_turns(map, corners, counted) && is_at(1);
  }

  bool fail(const Exact_map_status status, const int vertex, const int halfedge, const double deviation)
  {
    m_figures.status = status;
    m_figures.vertex = vertex;
    m_figures.halfedge = halfedge;
    m_figures.deviation = deviation;
    return false;
  }

  bool check_coordinates()
  {
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if (m_mesh.face(h) == m_mesh.null)
        continue;
      if (!(std::isfinite(m_uv[h][0]) && std::isfinite(m_uv[h][1])))
        return fail(Exact_map_status::NON_FINITE_UV, none, h, 0);
      m_size = std::max(m_size, largest_coordinate(m_uv[h]));
    }
    return true;
  }

  CGAL::Orientation orientation(const Index h) const
  {
    const Index j = m_mesh.next(h);
    return uv_orientation(m_uv[h], m_uv[j], m_uv[m_mesh.next(j)]);
  }

  bool check_triangles()
  {
    bool is_flipped = false;
    for (int f = 0; f < m_mesh.number_of_faces(); ++f) {
      if (!m_progress.go_on_after(1))
        return false;
      const CGAL::Orientation sign = orientation(m_mesh.halfedge_of_face(f));
      if (sign == CGAL::POSITIVE)
        continue;
      m_figures.faces.push_back(f);
      is_flipped = is_flipped || sign == CGAL::NEGATIVE;
    }
    if (m_figures.faces.empty())
      return true;
    return fail(is_flipped ? Exact_map_status::FLIPPED_TRIANGLES : Exact_map_status::DEGENERATE_TRIANGLES, none, none,
                0);
  }

  bool check_isolines(const Border_lines& border, const Isoline_arcs& arcs)
  {
    const std::pair<Index, double> border_edge = border.first_oblique_edge(m_tolerance);
    if (border_edge.first != m_mesh.null)
      return fail(Exact_map_status::BORDER_NOT_ALIGNED, none, border_edge.first, border_edge.second);
    const std::pair<Index, double> edge = arcs.first_oblique_edge(m_tolerance);
    return edge.first == m_mesh.null ||
           fail(Exact_map_status::CONSTRAINED_EDGE_NOT_ALIGNED, none, edge.first, edge.second);
  }

  // The angles around cut vertices must be multiples of a right angle, up to what the tolerance makes of short edges.
  bool read_cone_angles(const Cut_sectors& sectors, const std::vector<char>& is_cut, std::vector<int>& quarter_turns)
  {
    const double quarter = 2 * std::atan(1.);
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      double angle = 0, allowed = m_tolerance;
      for (int k = sectors.first_sector[i]; k < sectors.first_sector[i + 1]; ++k)
        Cut_sectors::for_each_corner(m_mesh, is_cut, sectors.halfedge[k], [&](const Index h) {
          angle += uv_angle(m_mesh, m_uv, h);
          const std::array<double, 2>&p = m_uv[h], &q = m_uv[m_mesh.next(h)], &r = m_uv[m_mesh.previous(h)];
          allowed += m_tolerance * largest_coordinate(p) * (1 / distance(p, q) + 1 / distance(p, r));
        });
      const int turns = static_cast<int>(std::round(angle / quarter));
      const double deviation = std::abs(angle - turns * quarter);
      if (turns < 1 || deviation > std::min(allowed, largest_uncertainty))
        return fail(Exact_map_status::CONE_ANGLE, sectors.vertices[i], none, deviation);
      quarter_turns.push_back(turns);
    }
    return true;
  }

  static std::vector<char> nodes(const Cut_sectors& sectors, const std::vector<int>& quarter_turns)
  {
    std::vector<char> result;
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      result.push_back(sectors.is_on_border[i] || sectors.degree(i) != 2 || quarter_turns[i] != 4);
    return result;
  }

  static std::vector<Cut_node_kind> kinds_of_nodes(const Cut_map& map, const std::vector<double>& uncertainty)
  {
    std::vector<Cut_node_kind> result;
    const int number_of_loops = static_cast<int>(map.border.loops().size());
    for (int node = 0; node < map.graph.number_of_nodes(); ++node) {
      if (node < number_of_loops)
        result.push_back(kind_of_loop(map, uncertainty, node));
      else
        result.push_back(map.quarter_turns[map.graph.cut_vertex(node)] % 4 == 0 ? Cut_node_kind::IDENTITY
                                                                                : Cut_node_kind::ROTATION);
    }
    return result;
  }

  // A loop of the border without corners lies on one line; if the transitions around it are a translation, then along
  // this line. A similarity or a half turn has its own invariant line.
  static Cut_node_kind kind_of_loop(const Cut_map& map, const std::vector<double>& uncertainty, const int node)
  {
    double log_scale = 0, allowed = 0;
    int rotation = 0;
    for (int i = 0; i < map.graph.number_of_ends(node); ++i) {
      const Cut_graph::End& end = map.graph.end(node, i);
      const int sign = end.is_outgoing ? -1 : 1;
      log_scale += sign * std::log(map.fits[end.branch].scale());
      rotation += sign * map.fits[end.branch].quarter_turns();
      allowed += uncertainty[end.branch];
    }
    if (map.border.has_corner(node, map.quarter_turns) || rotation % 4 != 0 || std::abs(log_scale) > allowed)
      return Cut_node_kind::BORDER;
    return map.border.first_axis(node) == 0 ? Cut_node_kind::BORDER_LINE_U : Cut_node_kind::BORDER_LINE_V;
  }

  bool fit_branches(const Cut_graph& graph, std::vector<Branch_fit>& fits)
  {
    fits.reserve(graph.number_of_branches());
    for (int b = 0; b < graph.number_of_branches(); ++b) {
      fits.emplace_back(m_mesh, m_uv, graph, b);
      const Branch_fit& fit = fits.back();
      for (int i = 0; i < graph.length(b); ++i) {
        const Index h = graph.halfedge(b, i);
        const std::pair<double, int> rotation = fit.rotation_of_edge(h);
        if (rotation.second != fit.quarter_turns() ||
            std::abs(rotation.first) > std::min(fit.rotation_uncertainty(h, m_tolerance), largest_uncertainty))
          return fail(Exact_map_status::TRANSITION_ROTATION, none, h, std::abs(rotation.first));
      }
      if (!(fit.scale() > 0) || !std::isfinite(fit.scale()) || !(fit.deviation() <= m_tolerance))
        return fail(Exact_map_status::TRANSITION_NOT_SIMILAR, none, fit.worst_halfedge(), fit.deviation());
      m_figures.deviation = std::max(m_figures.deviation, fit.deviation());
    }
    return true;
  }

  // The noise of the coordinates is read off from how well the similarities fit.
  std::vector<double> scale_uncertainty(const std::vector<Branch_fit>& fits) const
  {
    constexpr double unit_of_rounding = 2.2e-16; // of a double: coordinates have no less noise
    const double noise = 8 * std::max(m_figures.deviation, unit_of_rounding);
    std::vector<double> result;
    for (const Branch_fit& fit : fits)
      result.push_back(fit.scale_uncertainty(noise));
    return result;
  }

  bool check_scale_products(const Cut_map& map, const std::vector<Cut_node_kind>& kinds)
  {
    for (int node = 0; node < map.graph.number_of_nodes(); ++node) {
      if (kinds[node] != Cut_node_kind::IDENTITY && kinds[node] != Cut_node_kind::ROTATION)
        continue;
      double log_product = 0, allowed = m_tolerance;
      for (int i = 0; i < map.graph.number_of_ends(node); ++i) {
        const Cut_graph::End& end = map.graph.end(node, i);
        log_product += (end.is_outgoing ? -1 : 1) * std::log(map.fits[end.branch].scale());
        allowed += map.fits[end.branch].scale_uncertainty(m_tolerance);
      }
      if (!(std::abs(log_product) <= allowed))
        return fail(Exact_map_status::SCALE_PRODUCT, map.sectors.vertices[map.graph.cut_vertex(node)], none,
                    std::abs(std::expm1(log_product)));
    }
    return true;
  }

  // The angles of all vertices in the map as it is given: exact off the cut and the border.
  std::vector<int> counted_quarter_turns() const
  {
    std::vector<int> result(m_mesh.number_of_vertices(), 0);
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      add_quarter_turns(
          m_mesh, f, [this](const Index h) { return given_octant(h); }, 1, result);
    return result;
  }

  int given_octant(const Index h) const { return uv_octant(m_uv[m_mesh.previous(h)], m_uv[h]); }

  // With the scale factors of the map itself, the transitions that close around the nodes must still fit.
  bool check_closing(const Cut_map& map, Exact_transitions<double>& transitions)
  {
    transitions.compute(53);
    for (int b = 0; b < map.graph.number_of_branches(); ++b) {
      const Similarity_2<double> t = transitions.transition(b);
      const std::pair<double, Index> worst = map.fits[b].deviation_from(t.scale(), {t.u(), t.v()});
      if (!(worst.first <= m_tolerance))
        return fail(Exact_map_status::TRANSITION_NOT_SIMILAR, none, worst.second, worst.first);
    }
    return true;
  }

  // The number of bits by which coordinates on the cut, in multiples of a power of two, are far below the heights of
  // triangles, but not more than doubles hold.
  int bits_of_grid(const Cut_map& map, const Exact_corners& corners) const
  {
    constexpr int below_heights = 16, least = 34, most = 50;
    const double bits = std::ceil(std::log2(map.size / corners.smallest_height())) + below_heights;
    return static_cast<int>(std::clamp<double>(bits, least, most));
  }

  // \param sides lines of the border and of arcs, which hold in any case
  bool make_exact(const Cut_map& map, Exact_corners& corners, const std::vector<Isoline_coincidence>& sides,
                  Exact_transitions<double>& trial, Exact_transitions<FT>& transitions)
  {
    std::vector<Isoline_coincidence> chosen;
    const std::vector<Isoline_coincidence> found =
        nearly_coincident_isolines(map, corners, trial, m_layout.constrained_edges(), m_figures.deviation, m_progress);
    // If triangles are in the way, only round-off is removed, which is measured up to some 1e-9, or nothing.
    constexpr std::array<double, 3> largest_gaps{1, 1e-9, -1};
    for (const double largest_gap : largest_gaps) {
      if (!m_progress.go_on())
        return false;
      chosen = sides;
      for (const Isoline_coincidence& line : found)
        if (line.gap <= largest_gap)
          chosen.push_back(line);
      keep_independent_lines(trial, sides.size(), chosen);
      trial.set_lines(chosen);
      transitions.set_lines(chosen);
      const bool has_to_do = chosen.size() == sides.size();
      if (choose_bits(map, corners, trial, transitions, has_to_do) || has_to_do)
        break;
    }
    for (const int f : corners.faces())
      m_figures.largest_displacement =
          std::max(m_figures.largest_displacement, corners.displacement(f, m_layout.coordinates()));
    if (m_figures.status != Exact_map_status::EXACT)
      return false;
    if (!m_figures.faces.empty())
      return fail(Exact_map_status::ORIENTATION_LOST, none, none, 0);
    const std::vector<char> is_exact = transitions.lines_that_hold(found);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ++(is_exact[i] != 0 ? m_figures.number_of_joined_lines : m_figures.number_of_lines_left_apart);
      if (is_exact[i] != 0)
        m_figures.largest_gap = std::max(m_figures.largest_gap, found[i].gap);
    }
    return true;
  }

  static void keep_independent_lines(Exact_transitions<double>& trial, const std::size_t number_of_sides,
                                     std::vector<Isoline_coincidence>& lines)
  {
    const std::vector<char> is_independent = trial.independent_lines(lines, number_of_sides);
    std::size_t n = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (is_independent[i] != 0 && n++ != i)
        lines[n - 1] = std::move(lines[i]);
    lines.resize(n);
  }

  // Scale factors, or the grid, get more bits until no triangle changes much.
  // \param has_to_do whether in the end, a change is accepted that turns no triangle over
  // \return whether there is a map
  bool choose_bits(const Cut_map& map, Exact_corners& corners, Exact_transitions<double>& trial,
                   Exact_transitions<FT>& transitions, const bool has_to_do)
  {
    constexpr int first = 8, step = 4, last = 53;
    const bool is_any_accepted = has_to_do || m_figures.is_isometric; // with all bits
    m_figures.status = Exact_map_status::EXACT;
    for (int bits = m_figures.is_isometric ? bits_of_grid(map, corners) : first;; bits = std::min(bits + step, last)) {
      if (!m_progress.go_on())
        return false;
      const bool is_last = bits == last;
      m_figures.scale_bits = m_figures.is_isometric ? 0 : bits;
      if (!(is_last && is_any_accepted)) {
        trial.compute(bits);
        if (!corners.is_harmless(trial)) {
          if (is_last)
            return false;
          continue;
        }
      }
      transitions.compute(bits);
      if (!m_progress.go_on())
        return false;
      const Index open = corners.write(transitions, m_layout); // a vertex of a line
      if (open != none && !is_last)
        continue; // with so few bits, scale factors multiply to 1 that do not: a closed line is not where it was
      CGAL_assertion(open == none); // those that differ from 1 by round-off are 1, and equations close their loops
      if (open != none)
        return fail(Exact_map_status::ORIENTATION_LOST, open, none, 0);
      m_figures.faces = corners.lost_faces(m_layout);
      if (m_figures.faces.empty() && ((is_last && is_any_accepted) || corners.is_harmless(m_layout.coordinates())))
        return true;
      if (is_last)
        return false;
    }
  }

  // The exact count must be what the angles were taken for. With round-off, edges may be off the axes: angles count.
  bool check_quarter_turns(const Cut_map& map, const Exact_corners& corners, std::vector<int>& counted)
  {
    for (const int f : corners.faces()) {
      add_quarter_turns(
          m_mesh, f, [this](const Index h) { return given_octant(h); }, -1, counted);
      add_quarter_turns(
          m_mesh, f, [this](const Index h) { return uv_octant(m_layout, h); }, 1, counted);
    }
    for (int i = 0; i < map.sectors.number_of_vertices(); ++i) {
      const Index v = map.sectors.vertices[i];
      if (is_exact_number_type<FT> && counted[v] != map.quarter_turns[i])
        return fail(Exact_map_status::CONE_ANGLE, v, none, 0);
      counted[v] = map.quarter_turns[i];
    }
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_layout.set_quarter_turns(v, counted[v]);
    return true;
  }

  Triangulation_connectivity m_mesh;
  Uv_array m_uv;
  std::vector<char> m_is_constrained; // per edge, or empty
  double m_tolerance;
  double m_size = 0; // the largest coordinate
  Progress& m_progress;
  Exact_map_figures m_figures;
  Seamless_layout<FT> m_layout;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H
