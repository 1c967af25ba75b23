// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_cells.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Trace_arcs.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The motorcycle graph of a seamless map: the traces of the motorcycles, the arcs between the nodes where they meet,
/// and the cells between the arcs.
template <typename FT, typename TracingTraits>
class Motorcycle_graph {
public:
  using Layout = Seamless_layout<FT>;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Traces = Motorcycle_traces<FT>;
  using Arcs = Trace_arcs<FT, TracingTraits>;
  using Cells = Motorcycle_cells<FT, TracingTraits>;

  /// \param stars, traces of a tracer that has come to its end
  /// \param progress if it is interrupted, the cells are no T-mesh
  Motorcycle_graph(const Layout& layout, Stars stars, Traces traces, const TracingTraits& traits, Progress& progress)
    : m_layout(layout),
      m_traits(traits),
      m_stars(std::move(stars)),
      m_traces(std::move(traces)),
      m_arcs(layout, m_stars, m_traces, traits, progress),
      m_cells(m_arcs, progress)
  {
  }

  // The arcs refer to the traces, the cells to the arcs.
  Motorcycle_graph(const Motorcycle_graph&) = delete;
  Motorcycle_graph& operator=(const Motorcycle_graph&) = delete;

  const Layout& layout() const { return m_layout; }
  const TracingTraits& traits() const { return m_traits; }
  const Stars& stars() const { return m_stars; }
  const Traces& traces() const { return m_traces; }
  const Arcs& arcs() const { return m_arcs; }
  const Cells& cells() const { return m_cells; }

private:
  const Layout& m_layout;
  const TracingTraits& m_traits;
  const Stars m_stars;
  const Traces m_traces;
  const Arcs m_arcs;
  const Cells m_cells;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_H
