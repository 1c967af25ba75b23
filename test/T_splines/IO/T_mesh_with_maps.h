// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_IO_T_MESH_WITH_MAPS_H
#define T_SPLINES_TEST_IO_T_MESH_WITH_MAPS_H

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

/// A T-mesh with its maps, whatever the graph.
template <typename Graph, typename FT = double>
struct T_mesh_with_maps {
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;

  using Knot_map = boost::associative_property_map<std::map<Halfedge, FT>>;
  using Corner_map = boost::associative_property_map<std::map<Halfedge, bool>>;

  /// By one halfedge of the edge: not all graphs order edges.
  class Crease_map {
  public:
    using key_type = typename boost::graph_traits<Graph>::edge_descriptor;
    using value_type = bool;
    using reference = bool;
    using category = boost::read_write_property_map_tag;

    Crease_map(const Graph& graph, std::map<Halfedge, bool>& creases) : m_graph(&graph), m_creases(&creases) {}

    friend bool get(const Crease_map& map, const key_type e)
    {
      const auto found = map.m_creases->find(map.halfedge_of(e));
      return found != map.m_creases->end() && found->second;
    }
    friend void put(const Crease_map& map, const key_type e, const bool is_crease)
    {
      (*map.m_creases)[map.halfedge_of(e)] = is_crease;
    }

  private:
    Halfedge halfedge_of(const key_type e) const
    {
      const Halfedge h = halfedge(e, *m_graph), o = opposite(h, *m_graph);
      return o < h ? o : h;
    }

    const Graph* m_graph;
    std::map<Halfedge, bool>* m_creases;
  };

  Graph graph;
  mutable std::map<Halfedge, FT> knots;
  mutable std::map<Halfedge, bool> corners;
  mutable std::map<Halfedge, bool> creases; ///< of one halfedge of each edge
  mutable std::map<Vertex, double> weights;

  Knot_map knot_map() const { return Knot_map(knots); }
  Corner_map corner_map() const { return Corner_map(corners); }
  Crease_map crease_map() const { return Crease_map(graph, creases); }
  auto view() { return T::T_mesh_view(graph, knot_map(), corner_map(), crease_map()); }
  auto view() const { return T::T_mesh_view(graph, knot_map(), corner_map(), crease_map()); }
  auto weight_map() const { return boost::make_assoc_property_map(weights); }

  T::T_mesh_reading_report read(const std::string& filename)
  {
    return T::read_t_mesh(filename, view(), T::parameters::vertex_weight_map(weight_map()));
  }

  /// What the writer makes of it.
  std::string text() const
  {
    std::ostringstream out;
    const auto np = T::parameters::vertex_weight_map(weight_map());
    return T::write_t_mesh(out, view(), np) ? "failed" : out.str();
  }
};

template <typename Graph>
std::size_t vertices_of(const Graph& graph)
{
  return static_cast<std::size_t>(std::distance(vertices(graph).first, vertices(graph).second));
}

template <typename Graph>
std::size_t faces_of(const Graph& graph)
{
  return static_cast<std::size_t>(std::distance(faces(graph).first, faces(graph).second));
}

#endif // T_SPLINES_TEST_IO_T_MESH_WITH_MAPS_H
