// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_EDGE_FLAGS_H
#define T_SPLINES_TEST_EDGE_FLAGS_H

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>

// Which edges of a graph are marked, in a container of its own: no property maps that grow are needed. It is kept by
// halfedges, as edges of some graphs can only be compared while they exist.
template <typename Graph>
class Edge_flags {
  using Traits = boost::graph_traits<Graph>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Flags = std::unordered_map<Halfedge, bool, boost::hash<Halfedge>>;

public:
  class Map {
  public:
    using key_type = typename Traits::edge_descriptor;
    using value_type = bool;
    using reference = bool;
    using category = boost::read_write_property_map_tag;

    Map(const Graph& graph, Flags& flags) : m_graph(&graph), m_flags(&flags) {}

    friend bool get(const Map& map, const key_type e)
    {
      const Halfedge h = halfedge(e, *map.m_graph);
      for (const Halfedge g : {h, opposite(h, *map.m_graph)})
        if (const auto found = map.m_flags->find(g); found != map.m_flags->end())
          return found->second;
      return false;
    }
    friend void put(const Map& map, const key_type e, const bool is_marked)
    {
      const Halfedge h = halfedge(e, *map.m_graph);
      map.m_flags->erase(opposite(h, *map.m_graph));
      (*map.m_flags)[h] = is_marked;
    }

  private:
    const Graph* m_graph;
    Flags* m_flags;
  };

  // The map refers to the flags.
  Map of(const Graph& graph) const { return Map(graph, m_flags); }

  std::size_t size() const { return m_flags.size(); } // of edges that were marked or not
  std::size_t number_of_marked() const
  {
    return static_cast<std::size_t>(
        std::count_if(m_flags.begin(), m_flags.end(), [](const auto& flag) { return flag.second; }));
  }
  template <typename Function>
  void for_each_marked(const Function& f) const // with a halfedge
  {
    for (const auto& [h, is_marked] : m_flags)
      if (is_marked)
        f(h);
  }

private:
  mutable Flags m_flags;
};

#endif // T_SPLINES_TEST_EDGE_FLAGS_H
