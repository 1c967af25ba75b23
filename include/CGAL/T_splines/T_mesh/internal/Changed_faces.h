// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_CHANGED_FACES_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_CHANGED_FACES_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Collects the faces that operations on a T-mesh change and remove.
template <typename Graph>
class Changed_faces {
public:
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  class Observer : public T_mesh_observer {
  public:
    explicit Observer(Changed_faces& faces) : m_faces(&faces) {}

    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      for (const T_mesh_piece<Graph, FT>& piece : pieces)
        m_faces->erase(piece.from);
      for (const T_mesh_piece<Graph, FT>& piece : pieces)
        m_faces->insert(piece.to);
    }

  private:
    Changed_faces* m_faces;
  };

  Observer observer() { return Observer(*this); }

  /// The faces that are new or have another size or frame, in the order in which they were reported last.
  const std::vector<face_descriptor>& changed() const { return m_changed; }
  const std::vector<face_descriptor>& removed() const { return m_removed; }

  void clear()
  {
    m_changed.clear();
    m_removed.clear();
  }

private:
  // One operation touches few faces.
  static void erase_from(std::vector<face_descriptor>& list, const face_descriptor f)
  {
    list.erase(std::remove(list.begin(), list.end(), f), list.end());
  }

  void erase(const face_descriptor f)
  {
    erase_from(m_changed, f);
    erase_from(m_removed, f);
    m_removed.push_back(f);
  }

  void insert(const face_descriptor f)
  {
    erase_from(m_changed, f);
    erase_from(m_removed, f); // a removed descriptor may be used again
    m_changed.push_back(f);
  }

  std::vector<face_descriptor> m_changed, m_removed;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_CHANGED_FACES_H
