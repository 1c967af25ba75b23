// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_MAP_COMPUTATION_H

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Seamless_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Sector_values.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/number_utils.h>

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
    const auto is_cut = [&seams](const Index edge) { return seams.is_cut(edge); };
    const Cut_sectors sectors(m_mesh, is_cut);
    std::vector<int> quarter_turns; // per cut vertex
    if (!read_cone_angles(sectors, is_cut, quarter_turns))
      return false;
    const Cut_graph graph(m_mesh, sectors, nodes(sectors, quarter_turns));
    std::vector<Branch_fit> fits;
    if (!fit_branches(graph, fits))
      return false;
    const std::vector<Cut_node_kind> kinds = kinds_of_nodes(sectors, graph, quarter_turns);
    const std::vector<double> uncertainty = scale_uncertainty(fits);
    if (!check_scale_products(sectors, graph, kinds, fits) || !check_closing(graph, kinds, fits, uncertainty))
      return false;
    make_exact(sectors, is_cut, graph, fits, kinds, uncertainty, quarter_turns);
    return m_figures.status == Exact_map_status::EXACT && check_quarter_turns(sectors, quarter_turns);
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
    return fail(is_flipped ? Exact_map_status::FLIPPED_TRIANGLES : Exact_map_status::DEGENERATE_TRIANGLES, none, none, 0);
  }

  // The angles around cut vertices must be multiples of a right angle, up to what the tolerance makes of short edges.
  template <typename IsCut>
  bool read_cone_angles(const Cut_sectors& sectors, const IsCut& is_cut, std::vector<int>& quarter_turns)
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

  static std::vector<Cut_node_kind> kinds_of_nodes(const Cut_sectors& sectors, const Cut_graph& graph,
                                                   const std::vector<int>& quarter_turns)
  {
    std::vector<Cut_node_kind> result;
    for (int node = 0; node < graph.number_of_nodes(); ++node) {
      const int i = graph.cut_vertex(node);
      result.push_back(sectors.is_on_border[i]        ? Cut_node_kind::BORDER
                       : quarter_turns[i] % 4 == 0 ? Cut_node_kind::IDENTITY
                                                   : Cut_node_kind::ROTATION);
    }
    return result;
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
      if (!(fit.deviation() <= m_tolerance))
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

  bool check_scale_products(const Cut_sectors& sectors, const Cut_graph& graph, const std::vector<Cut_node_kind>& kinds,
                            const std::vector<Branch_fit>& fits)
  {
    for (int node = 0; node < graph.number_of_nodes(); ++node) {
      if (kinds[node] == Cut_node_kind::BORDER)
        continue;
      double log_product = 0, allowed = m_tolerance;
      for (int i = 0; i < graph.number_of_ends(node); ++i) {
        const Cut_graph::End& end = graph.end(node, i);
        log_product += (end.is_outgoing ? -1 : 1) * std::log(fits[end.branch].scale());
        allowed += fits[end.branch].scale_uncertainty(m_tolerance);
      }
      if (!(std::abs(log_product) <= allowed))
        return fail(Exact_map_status::SCALE_PRODUCT, sectors.vertices[graph.cut_vertex(node)], none,
                    std::abs(std::expm1(log_product)));
    }
    return true;
  }

  // With the scale factors of the map itself, the transitions that close around the nodes must still fit.
  bool check_closing(const Cut_graph& graph, const std::vector<Cut_node_kind>& kinds,
                     const std::vector<Branch_fit>& fits, const std::vector<double>& uncertainty)
  {
    Exact_transitions<double> transitions(graph, fits, kinds, uncertainty);
    transitions.compute(53);
    for (int b = 0; b < graph.number_of_branches(); ++b) {
      const Similarity_2<double> t = transitions.transition(b);
      const std::pair<double, Index> worst = fits[b].deviation_from(t.scale(), {t.u(), t.v()});
      if (!(worst.first <= m_tolerance))
        return fail(Exact_map_status::TRANSITION_NOT_SIMILAR, none, worst.second, worst.first);
    }
    return true;
  }

  template <typename IsCut>
  void make_exact(const Cut_sectors& sectors, const IsCut& is_cut, const Cut_graph& graph,
                  const std::vector<Branch_fit>& fits, const std::vector<Cut_node_kind>& kinds,
                  const std::vector<double>& uncertainty, const std::vector<int>& quarter_turns)
  {
    const std::vector<int> kept = kept_sectors(sectors, is_cut, graph, fits, quarter_turns);
    const std::vector<int> faces = faces_at_cut(sectors, is_cut);
    m_layout = Seamless_layout<FT>(m_mesh, m_uv);
    Exact_transitions<FT> transitions(graph, fits, kinds, uncertainty);
    m_figures.is_isometric = transitions.is_isometric();
    constexpr int last = 53;
    for (int bits = m_figures.is_isometric ? last : 8; ; bits = std::min(bits + 4, last)) {
      m_figures.scale_bits = m_figures.is_isometric ? 0 : bits;
      transitions.compute(bits);
      if (bits < last && !try_in_doubles(sectors, is_cut, graph, transitions, kept, faces))
        continue;
      m_layout.clear_branches_and_determined();
      set_branches(graph, transitions);
      set_corners(sectors, is_cut, kept);
      find_lost_faces(faces);
      if (m_figures.faces.empty() || bits == last)
        break;
    }
    if (!m_figures.faces.empty())
      fail(Exact_map_status::ORIENTATION_LOST, none, none, 0);
    measure_displacement(faces);
  }

  // At each cut vertex the sector of the flattest triangle is kept: it suffers most from a displacement.
  template <typename IsCut>
  std::vector<int> kept_sectors(const Cut_sectors& sectors, const IsCut& is_cut, const Cut_graph& graph,
                                const std::vector<Branch_fit>& fits, const std::vector<int>& quarter_turns) const
  {
    std::vector<int> result;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      if (!sectors.is_on_border[i] && quarter_turns[i] % 4 != 0) {
        result.push_back(fixed_point);
        continue;
      }
      double scale = 1, smallest = 0; // of the sector's chart, and a height in the chart of the first sector
      int best = none;
      for (int k = 0; k < sectors.number_of_sectors(i); ++k) {
        const Index h = sectors.halfedge[sectors.first_sector[i] + k];
        if (k > 0) {
          const double factor = fits[graph.branch_of_edge(h >> 1)].scale();
          scale *= graph.is_along(h ^ 1) ? factor : 1 / factor;
        }
        Cut_sectors::for_each_corner(m_mesh, is_cut, h, [&](const Index corner) {
          const double height = height_over_opposite_side(corner) / scale;
          if (best == none || height < smallest) {
            smallest = height;
            best = k;
          }
        });
      }
      result.push_back(best);
    }
    return result;
  }

  static double area(const Uv_array& uv, const Triangulation_connectivity& mesh, const Index h)
  {
    const std::array<double, 2>&p = uv[h], &q = uv[mesh.next(h)], &r = uv[mesh.previous(h)];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  double height_over_opposite_side(const Index corner) const
  {
    return area(m_uv, m_mesh, corner) / distance(m_uv[m_mesh.next(corner)], m_uv[m_mesh.previous(corner)]);
  }

  template <typename IsCut>
  std::vector<int> faces_at_cut(const Cut_sectors& sectors, const IsCut& is_cut) const
  {
    std::vector<char> is_listed(m_mesh.number_of_faces(), 0);
    std::vector<int> result;
    for (const Index sector : sectors.halfedge)
      Cut_sectors::for_each_corner(m_mesh, is_cut, sector, [&](const Index h) {
        if (!is_listed[m_mesh.face(h)])
          result.push_back(m_mesh.face(h));
        is_listed[m_mesh.face(h)] = 1;
      });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Whether no triangle changes its area by more than a factor 2, as far as doubles tell.
  template <typename IsCut>
  bool try_in_doubles(const Cut_sectors& sectors, const IsCut& is_cut, const Cut_graph& graph,
                      const Exact_transitions<FT>& transitions, const std::vector<int>& kept,
                      const std::vector<int>& faces) const
  {
    std::vector<Similarity_2<double>> along, against;
    for (int b = 0; b < graph.number_of_branches(); ++b) {
      const Similarity_2<FT> t = transitions.transition(b);
      const double scale = CGAL::to_double(t.scale());
      if (!(scale > 0) || !std::isfinite(scale))
        return false;
      along.emplace_back(t.quarter_turns(), scale, CGAL::to_double(t.u()), CGAL::to_double(t.v()));
      against.push_back(along.back().inverse());
    }
    const auto transition = [&](const Index h) -> const Similarity_2<double>& {
      return (graph.is_along(h) ? along : against)[graph.branch_of_edge(h >> 1)];
    };
    Uv_array uv = m_uv;
    std::vector<std::pair<double, double>> values;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      compute_sector_values(sectors, i, transition, kept[i], start_value<double>(sectors, i, kept[i]), values);
      for (int k = 0; k < sectors.number_of_sectors(i); ++k)
        Cut_sectors::for_each_corner(m_mesh, is_cut, sectors.halfedge[sectors.first_sector[i] + k], [&](const Index h) {
          uv[h] = {{values[k].first, values[k].second}};
        });
    }
    for (const int f : faces) {
      const Index h = m_mesh.halfedge_of_face(f);
      const double before = area(m_uv, m_mesh, h), after = area(uv, m_mesh, h);
      if (!(after >= before / 2 && after <= before * 2))
        return false;
    }
    return true;
  }

  template <typename Number>
  std::pair<Number, Number> start_value(const Cut_sectors& sectors, const int i, const int kept) const
  {
    const Index h = m_mesh.previous(sectors.halfedge[sectors.first_sector[i] + std::max(kept, 0)]);
    return {Number(m_uv[h][0]), Number(m_uv[h][1])};
  }

  void set_branches(const Cut_graph& graph, const Exact_transitions<FT>& transitions)
  {
    for (int b = 0; b < graph.number_of_branches(); ++b) {
      m_layout.add_branch(transitions.transition(b));
      for (int i = 0; i < graph.length(b); ++i)
        m_layout.set_branch(graph.halfedge(b, i), b);
    }
  }

  template <typename IsCut>
  void set_corners(const Cut_sectors& sectors, const IsCut& is_cut, const std::vector<int>& kept)
  {
    const auto transition = [this](const Index h) -> const Similarity_2<FT>& { return m_layout.transition(h); };
    std::vector<std::pair<FT, FT>> values;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      const bool is_closed =
          compute_sector_values(sectors, i, transition, kept[i], start_value<FT>(sectors, i, kept[i]), values);
      CGAL_assertion(is_closed || !is_exact());
      CGAL_USE(is_closed);
      for (int k = 0; k < sectors.number_of_sectors(i); ++k)
        set_sector(is_cut, sectors.halfedge[sectors.first_sector[i] + k], k == kept[i], values[k]);
    }
  }

  // Coordinates that are doubles are stored as such.
  template <typename IsCut>
  void set_sector(const IsCut& is_cut, const Index sector, const bool is_kept, const std::pair<FT, FT>& value)
  {
    const std::array<double, 2> rounded = {{CGAL::to_double(value.first), CGAL::to_double(value.second)}};
    const bool is_double = is_kept || (FT(rounded[0]) == value.first && FT(rounded[1]) == value.second);
    const int determined = is_double ? none : m_layout.add_determined(value.first, value.second);
    Cut_sectors::for_each_corner(m_mesh, is_cut, sector, [&](const Index h) {
      if (is_double)
        m_layout.set_uv(h, rounded);
      else
        m_layout.set_determined(h, determined);
    });
  }

  static constexpr bool is_exact() { return CGAL::Algebraic_structure_traits<FT>::Is_exact::value; }

  void find_lost_faces(const std::vector<int>& faces)
  {
    m_figures.faces.clear();
    for (const int f : faces)
      if (uv_orientation(m_layout, m_mesh.halfedge_of_face(f)) != CGAL::POSITIVE)
        m_figures.faces.push_back(f);
  }

  void measure_displacement(const std::vector<int>& faces)
  {
    for (const int f : faces) {
      Index h = m_mesh.halfedge_of_face(f);
      double displacement = 0, side = 0;
      for (int k = 0; k < 3; ++k, h = m_mesh.next(h)) {
        displacement = std::max(displacement, distance(m_uv[h], m_layout.uv(h)));
        side = std::max(side, distance(m_uv[h], m_uv[m_mesh.next(h)]));
      }
      m_figures.largest_displacement = std::max(m_figures.largest_displacement, displacement / side);
    }
  }

  // The exact count must be what the angles were taken for.
  bool check_quarter_turns(const Cut_sectors& sectors, const std::vector<int>& quarter_turns)
  {
    const std::vector<int> counted = count_quarter_turns(m_layout);
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      if (counted[sectors.vertices[i]] != quarter_turns[i])
        return fail(Exact_map_status::CONE_ANGLE, sectors.vertices[i], none, 0);
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
