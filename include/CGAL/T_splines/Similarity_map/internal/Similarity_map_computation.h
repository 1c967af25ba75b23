// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_MAP_COMPUTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_MAP_COMPUTATION_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Common_subdivision.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Edge_crossings.h>
#include <CGAL/T_splines/Similarity_map/internal/First_sheet.h>
#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Metric_computation.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/Similarity_map/internal/Sliver_removal.h>
#include <CGAL/T_splines/Similarity_map/internal/Subdivided_part.h>
#include <CGAL/T_splines/Similarity_map/internal/converged_metric.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// From a converged metric to the refined triangulation with its map.
/// \tparam Metric a `Metric_computation` that tracked its edges
template <typename Metric>
class Similarity_map_computation {
  using FT = Layout_number_type<typename Metric::FT>;

public:
  static constexpr int none = -1;

  /// \param progress in the stage "layout"; if it is interrupted, nothing of this may be used
  Similarity_map_computation(const Metric_input& input, const Metric& metric, Progress& progress)
    : m_layout(metric.structure, metric.coefficients, input.quarter_turns, progress)
  {
    using std::sqrt;
    const Triangulation_connectivity& last = metric.structure.mesh;
    progress.progress(0.3);
    if (!progress.go_on())
      return;
    m_transitions.emplace(last, metric.structure.loops, m_layout, input.quarter_turns, loop_coefficients(metric));
    progress.progress(0.5);
    const std::int64_t most_nodes = largest_subdivision(input.mesh.number_of_vertices());
    m_is_too_large = input.mesh.number_of_vertices() + metric.input_on_middle.sum_of_crossings() +
                         metric.structure.delaunay_edges.sum_of_crossings() >
                     most_nodes;
    if (m_is_too_large)
      return;
    std::vector<FT> length;
    for (int e = 0; e < input.mesh.number_of_edges(); ++e)
      length.push_back(sqrt(input.template squared_length<FT>(e)));
    if (!progress.go_on())
      return;
    const Subdivided_part part(input.number_of_edges, input.number_of_faces, metric.middle, metric.middle_pairs, last,
                               metric.structure.pairs);
    const Input_crossings<FT> on_input(input.mesh, metric.middle, metric.input_on_middle, length, part, progress);
    progress.progress(0.7);
    if (!progress.go_on())
      return;
    const Final_crossings<FT> on_final(metric.middle, last, metric.structure.delaunay_edges,
                                       convert(metric.log_penner()), part, progress);
    if (!progress.go_on())
      return;
    progress.begin_stage("subdivision");
    const auto& form = convert(metric.structure.form);
    Common_subdivision<FT> subdivision(input.mesh, input.point, metric.middle, last, on_input, on_final, form, m_layout,
                                       part, most_nodes, progress);
    if (!progress.go_on())
      return;
    m_is_too_large = !subdivision.is_complete();
    if (m_is_too_large)
      return;
    m_refined = std::move(subdivision.result());
    m_cut.resize(m_refined.mesh.number_of_edges());
    for (int e = 0; e < m_refined.mesh.number_of_edges(); ++e) {
      const int on_final = m_refined.final_halfedge[halfedge_of_edge(e)];
      m_cut[e] = on_final != none && m_layout.is_cut(edge_of(on_final));
    }
    if (input.is_double()) {
      complete_first_sheet(input, m_refined, m_cut);
      m_alignment.emplace(m_refined); // before the signs of areas are decided
    }
    progress.progress(0.8);
    m_first_bad_input_face = Sliver_removal(input.mesh, input.point, m_refined, m_cut, progress).first_bad_input_face();
    progress.progress(1.);
  }

  /// The most vertices that the refinement of a mesh with `number_of_vertices` may have. Flips of benign meshes add a few
  /// percent, those of bad triangles a multiple; where the edges of two triangulations with long triangles cross each other
  /// the number is that of pairs of edges. A vertex takes about 800 bytes.
  static std::int64_t largest_subdivision(const std::int64_t number_of_vertices)
  {
    return 250000 + 20 * number_of_vertices;
  }

  /// Whether the refinement would have too many vertices; then there is none.
  bool is_too_large() const { return m_is_too_large; }

  const Refined_triangulation& refined() const { return m_refined; }

  /// Per edge of the refined triangulation.
  const std::vector<char>& cut_edges() const { return m_cut; }

  /// An input face that contains a triangle whose area is not positive on the surface or in the plane, or `none`.
  int first_bad_input_face() const { return m_first_bad_input_face; }

  /// The transition across the halfedge `h` of the refined triangulation.
  Similarity_2<double> transition(const int h) const
  {
    if (!m_cut[edge_of(h)])
      return Similarity_2<double>();
    const Similarity_2<FT> wide = m_transitions->transition(m_refined.final_halfedge[h]);
    std::array<double, 2> translation = {{static_cast<double>(wide.u()), static_cast<double>(wide.v())}};
    if (m_alignment)
      translation = m_alignment->turned(translation, m_refined.mesh.target(h));
    return Similarity_2<double>(wide.quarter_turns(), static_cast<double>(wide.scale()), translation[0],
                                translation[1]);
  }

private:
  static const std::vector<FT>& convert(const std::vector<FT>& from) { return from; }

  template <typename From>
  static std::vector<FT> convert(const std::vector<From>& from)
  {
    std::vector<FT> to;
    to.reserve(from.size());
    for (const From& x : from)
      to.push_back(static_cast<FT>(x));
    return to;
  }

  static std::vector<FT> loop_coefficients(const Metric& metric)
  {
    const auto first = metric.coefficients.begin() + metric.structure.mesh.number_of_vertices();
    return convert(std::vector<typename Metric::FT>(first, metric.coefficients.end()));
  }

  Flat_layout<FT> m_layout;
  std::optional<Cut_transitions<FT>> m_transitions; // none if the work was interrupted
  Refined_triangulation m_refined;
  std::vector<char> m_cut;
  std::optional<Border_alignment> m_alignment; // of a mesh with border
  bool m_is_too_large = false;
  int m_first_bad_input_face = none;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SIMILARITY_MAP_COMPUTATION_H
