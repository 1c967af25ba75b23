// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_COUNTED_SPLITS_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_COUNTED_SPLITS_H

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/support/Split_position.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Collects the vertices that operations on a T-mesh insert, and the faces on whose boundary they changed something.
template <typename Graph>
class Touched_elements {
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

public:
  /// A model of `TMeshObserver`. It refers to the elements.
  class Observer : public T_mesh_observer {
  public:
    explicit Observer(Touched_elements& elements) : m_elements(&elements) {}

    void vertex_inserted(const vertex_descriptor v, const halfedge_descriptor h) const
    {
      m_elements->m_vertices.push_back(v);
      m_elements->touch(h);
    }
    void edge_inserted(const halfedge_descriptor h) const { m_elements->touch(h); }

  private:
    Touched_elements* m_elements;
  };

  explicit Touched_elements(const Graph& graph) : m_graph(graph) {}

  Observer observer() { return Observer(*this); }

  const std::vector<vertex_descriptor>& new_vertices() const { return m_vertices; }
  bool is_touched(const face_descriptor f) const { return m_faces.count(f) != 0; }

  void clear()
  {
    m_vertices.clear();
    m_faces.clear();
  }

private:
  void touch(const halfedge_descriptor h)
  {
    m_faces.insert(face(h, m_graph));
    m_faces.insert(face(opposite(h, m_graph), m_graph));
  }

  const Graph& m_graph;
  std::vector<vertex_descriptor> m_vertices;
  std::unordered_set<face_descriptor, boost::hash<face_descriptor>> m_faces;
};

/// Splits faces of a T-mesh, a limited number of times, and keeps account.
/// \tparam TMesh a `T_mesh_view`
template <typename TMesh, typename Observer>
class Counted_splits {
  using Editor =
      T_mesh_editor<TMesh, T_mesh_observer_pair<typename Touched_elements<typename TMesh::Graph>::Observer, Observer>>;

public:
  using Graph = typename TMesh::Graph;
  using FT = typename Editor::FT;
  using Coordinates = typename Editor::Coordinates;
  using Position = Split_position<Const_T_mesh_view_of<TMesh>>;
  using vertex_descriptor = typename Editor::vertex_descriptor;
  using halfedge_descriptor = typename Editor::halfedge_descriptor;
  using face_descriptor = typename Editor::face_descriptor;

  /// The two parts of a face; `near` is the one where the direction of measurement begins.
  struct Parts {
    face_descriptor near, far;
    bool is_split;
  };

  /// \param progress if it is interrupted, no more splits are allowed; it must outlive this
  Counted_splits(const TMesh& t_mesh, const Observer& observer, const std::size_t limit, Progress& progress)
    : m_t_mesh(t_mesh),
      m_progress(progress),
      m_touched(t_mesh.graph()),
      m_editor(t_mesh, {m_touched.observer(), observer}),
      m_limit(limit)
  {
  }
  Counted_splits(const Counted_splits&) = delete; // the editor refers to m_touched
  Counted_splits& operator=(const Counted_splits&) = delete;

  /// Splits `f` by a line across the direction `direction`, 0 to 3 for +u, +v, -u, -v, at a distance from the side
  /// where this direction begins. Where the limit is reached, or the line would leave the face, nothing happens.
  Parts split(const face_descriptor f, const int direction, const FT& distance)
  {
    const int axis = direction % 2;
    const FT size = axis == 0 ? coordinates().width(f) : coordinates().height(f);
    if (is_exhausted())
      return {f, f, false};
    const auto edit = m_editor.split_face(f, axis, direction < 2 ? distance : FT(size - distance));
    if (!edit)
      return {f, f, false};
    ++m_count;
    m_progress.go_on_after(work_per_split);
    const face_descriptor low = face(edit.halfedge, graph()), high = face(opposite(edit.halfedge, graph()), graph());
    return direction < 2 ? Parts{low, high, true} : Parts{high, low, true};
  }

  /// Extends the T-joint at which `h` ends through the face of `h`.
  bool extend(const halfedge_descriptor h)
  {
    if (is_exhausted() || !m_editor.extend(h))
      return false;
    ++m_count;
    m_progress.go_on_after(work_per_split);
    return true;
  }

  std::size_t count() const { return m_count; }
  bool is_exhausted() const { return m_count >= m_limit || m_progress.is_interrupted(); }
  Progress& progress() { return m_progress; }

  const TMesh& t_mesh() const { return m_t_mesh; }
  const Graph& graph() const { return m_t_mesh.graph(); }
  const Coordinates& coordinates() const { return m_editor.coordinates(); }
  Touched_elements<Graph>& touched() { return m_touched; }

private:
  static constexpr std::size_t work_per_split = 1000;

  TMesh m_t_mesh;
  Progress& m_progress;
  Touched_elements<Graph> m_touched;
  Editor m_editor;
  std::size_t m_limit, m_count = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_COUNTED_SPLITS_H
