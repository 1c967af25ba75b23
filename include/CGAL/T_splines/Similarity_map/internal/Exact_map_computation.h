// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Border_lines.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_corners.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Seamless_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <algorithm>
#include <array>
#include <cmath>
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
};

/// Makes a map that is seamless up to round-off exactly seamless: the steps of `make_exactly_seamless()`, by index.
/// \tparam FT the number type of the transitions
template <typename FT>
class Exact_map_computation {
  using Index = Triangulation_connectivity::Index;

public:
  static constexpr int none = -1;

  /// \param tolerance of the transitions, relative
  Exact_map_computation(Triangulation_connectivity mesh, Uv_array uv, const double tolerance)
    : m_mesh(std::move(mesh)),
      m_uv(std::move(uv)),
      m_tolerance(tolerance)
  {
  }

  /// Runs all steps. \return whether the layout is complete
  bool run()
  {
    if (!check_coordinates() || !check_triangles())
      return false;
    const Uv_seams seams(m_mesh, m_uv, m_tolerance);
    const Cut_sectors sectors(m_mesh, seams.cut_edges());
    const Border_lines border(m_mesh, m_uv, sectors);
    std::vector<int> quarter_turns; // per cut vertex
    if (!check_border(border) || !read_cone_angles(sectors, seams.cut_edges(), quarter_turns))
      return false;
    const Cut_graph graph(m_mesh, sectors, nodes(sectors, quarter_turns), border.loops());
    std::vector<Branch_fit> fits;
    if (!fit_branches(graph, fits))
      return false;
    const Cut_map map{m_mesh, m_uv, seams.cut_edges(), sectors, border, graph, fits, quarter_turns};
    const std::vector<double> uncertainty = scale_uncertainty(fits);
    const std::vector<Cut_node_kind> kinds = kinds_of_nodes(map, uncertainty);
    return check_scale_products(map, kinds) && check_closing(map, kinds, uncertainty) &&
           make_exact(map, kinds, uncertainty) && check_quarter_turns(sectors, quarter_turns);
  }

  const Exact_map_figures& figures() const { return m_figures; }
  Seamless_layout<FT>& layout() { return m_layout; }

private:
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
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) != m_mesh.null && !(std::isfinite(m_uv[h][0]) && std::isfinite(m_uv[h][1])))
        return fail(Exact_map_status::NON_FINITE_UV, none, h, 0);
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

  bool check_border(const Border_lines& border)
  {
    const std::pair<Index, double> oblique = border.first_oblique_edge(m_tolerance);
    return oblique.first == m_mesh.null ||
           fail(Exact_map_status::BORDER_NOT_ALIGNED, none, oblique.first, oblique.second);
  }

  // The angles around cut vertices must be multiples of a right angle, up to what the tolerance makes of short edges.
  bool read_cone_angles(const Cut_sectors& sectors, const std::vector<char>& is_cut, std::vector<int>& quarter_turns)
  {
    constexpr double largest_uncertainty = 0.05;
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
    constexpr double largest_uncertainty = 0.05;
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
    const double noise = 8 * std::max(m_figures.deviation, 2.2e-16);
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

  // With the scale factors of the map itself, the transitions that close around the nodes must still fit.
  bool check_closing(const Cut_map& map, const std::vector<Cut_node_kind>& kinds,
                     const std::vector<double>& uncertainty)
  {
    Exact_transitions<double> transitions(map.graph, map.fits, kinds, uncertainty);
    transitions.compute(53);
    for (int b = 0; b < map.graph.number_of_branches(); ++b) {
      const Similarity_2<double> t = transitions.transition(b);
      const std::pair<double, Index> worst = map.fits[b].deviation_from(t.scale(), {t.u(), t.v()});
      if (!(worst.first <= m_tolerance))
        return fail(Exact_map_status::TRANSITION_NOT_SIMILAR, none, worst.second, worst.first);
    }
    return true;
  }

  // Scale factors get more bits until no triangle changes much.
  bool make_exact(const Cut_map& map, const std::vector<Cut_node_kind>& kinds, const std::vector<double>& uncertainty)
  {
    Exact_corners corners(map);
    Exact_transitions<double> trial(map.graph, map.fits, kinds, uncertainty);
    Exact_transitions<FT> transitions(map.graph, map.fits, kinds, uncertainty);
    m_figures.is_isometric = transitions.is_isometric();
    m_layout = Seamless_layout<FT>(m_mesh, m_uv);
    constexpr int first = 8, step = 4, last = 53;
    for (int bits = m_figures.is_isometric ? last : first;; bits = std::min(bits + step, last)) {
      m_figures.scale_bits = m_figures.is_isometric ? 0 : bits;
      if (bits < last) {
        trial.compute(bits);
        if (!corners.is_harmless(trial))
          continue;
      }
      transitions.compute(bits);
      const int open_loop = corners.write(transitions, m_layout);
      if (open_loop != -1)
        return fail(Exact_map_status::BORDER_NOT_CLOSED, map.sectors.vertices[map.border.loops()[open_loop].front()],
                    none, 0);
      m_figures.faces = corners.lost_faces(m_layout);
      if (m_figures.faces.empty() || bits == last)
        break;
    }
    for (const int f : corners.faces())
      m_figures.largest_displacement =
          std::max(m_figures.largest_displacement, corners.displacement(f, m_layout.coordinates()));
    return m_figures.faces.empty() || fail(Exact_map_status::ORIENTATION_LOST, none, none, 0);
  }

  // The exact count must be what the angles were taken for. With round-off, edges may be off the axes: angles count.
  bool check_quarter_turns(const Cut_sectors& sectors, const std::vector<int>& quarter_turns)
  {
    std::vector<int> counted = count_quarter_turns(m_layout);
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      const Index v = sectors.vertices[i];
      if (is_exact_number_type<FT> && counted[v] != quarter_turns[i])
        return fail(Exact_map_status::CONE_ANGLE, v, none, 0);
      counted[v] = quarter_turns[i];
    }
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_layout.set_quarter_turns(v, counted[v]);
    return true;
  }

  Triangulation_connectivity m_mesh;
  Uv_array m_uv;
  double m_tolerance;
  Exact_map_figures m_figures;
  Seamless_layout<FT> m_layout;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H
