// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_ARCS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_ARCS_H

#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Which curve of the border each vertex is on, or `null`.
inline std::vector<int> curves_of_vertices(const Triangulation_connectivity& mesh,
                                           const std::vector<std::vector<int>>& curves)
{
  std::vector<int> result(mesh.number_of_vertices(), Triangulation_connectivity::null);
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const int h : curves[i])
      result[mesh.target(h)] = static_cast<int>(i);
  return result;
}

/// Sets that are joined by and by.
class Disjoint_sets {
public:
  explicit Disjoint_sets(const std::size_t size) : m_parent(size) { std::iota(m_parent.begin(), m_parent.end(), 0); }

  /// joins the sets of `i` and `j`. \return whether they were different.
  bool join(const int i, const int j)
  {
    const int a = find(i), b = find(j);
    m_parent[a] = b;
    return a != b;
  }

private:
  int find(int i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  std::vector<int> m_parent;
};

/// Finds short strips of triangles that join the curves of the border of each component.
///
/// Shortest dual paths grow from all curves at once. Where those of two curves meet, an edge closes a strip between
/// these; the strips that are taken are a smallest spanning tree of the curves.
class Border_arcs {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// \param dual_length per edge: the length of a dual path across it, not negative
  Border_arcs(const Triangulation_connectivity& mesh, const std::vector<double>& dual_length)
    : m_mesh(mesh),
      m_dual_length(dual_length),
      m_distance(mesh.number_of_faces(), std::numeric_limits<double>::infinity()),
      m_curve(mesh.number_of_faces(), null),
      m_entry(mesh.number_of_faces(), null)
  {
  }

  /// computes b - 1 arcs for each component with b curves, each as in `Holonomy_signature::Arc`. If `progress` is
  /// interrupted, they are not all there. Complexity: O(n log n).
  std::vector<std::vector<int>> compute(Progress& progress)
  {
    const std::vector<std::vector<int>> curves = border_curves(m_mesh);
    grow(curves, progress);
    std::vector<std::pair<double, Index>> meetings;
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      const Index f = m_mesh.face(h), g = m_mesh.face(opposite(h));
      if (f != null && g != null && m_curve[f] < m_curve[g])
        meetings.emplace_back(m_distance[f] + m_distance[g] + m_dual_length[edge_of(h)], h);
    }
    std::sort(meetings.begin(), meetings.end());
    Disjoint_sets sets(curves.size());
    std::vector<std::vector<int>> result;
    for (const auto& meeting : meetings)
      if (progress.go_on_after(1) &&
          sets.join(m_curve[m_mesh.face(meeting.second)], m_curve[m_mesh.face(opposite(meeting.second))]))
        result.push_back(arc(meeting.second));
    return result;
  }

private:
  void grow(const std::vector<std::vector<int>>& curves, Progress& progress)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](const Index h, const int curve, const double distance) {
      const Index f = m_mesh.face(h);
      if (f == null || !(distance < m_distance[f]))
        return;
      m_distance[f] = distance;
      m_curve[f] = curve;
      m_entry[f] = h;
      queue.emplace(distance, f);
    };
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Index h : curves[i])
        reach(opposite(h), static_cast<int>(i), m_dual_length[edge_of(h)]);
    while (!queue.empty() && progress.go_on_after(10)) {
      const auto [distance, f] = queue.top();
      queue.pop();
      if (distance > m_distance[f])
        continue;
      Index h = m_mesh.halfedge_of_face(f);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h))
        reach(opposite(h), m_curve[f], distance + m_dual_length[edge_of(h)]);
    }
  }

  // From the curve of the face on the other side of h to that of its face.
  std::vector<int> arc(const Index h) const
  {
    std::vector<int> result;
    for (Index f = m_mesh.face(opposite(h)); f != null; f = m_mesh.face(opposite(m_entry[f])))
      result.push_back(m_entry[f]);
    std::reverse(result.begin(), result.end());
    result.push_back(h);
    for (Index f = m_mesh.face(h); f != null; f = m_mesh.face(result.back()))
      result.push_back(opposite(m_entry[f]));
    return result;
  }

  const Triangulation_connectivity& m_mesh;
  const std::vector<double>& m_dual_length;
  std::vector<double> m_distance; // per face: to the border
  std::vector<int> m_curve;       // per face: the curve that is closest
  std::vector<Index> m_entry;     // per face: the halfedge by which it is entered on the way from the curve
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_BORDER_ARCS_H
