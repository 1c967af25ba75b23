// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_FACE_ANCESTORS_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_FACE_ANCESTORS_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <unordered_map>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// From which old face each face of a T-mesh was cut, while faces are split.
template <typename Graph>
class Face_ancestors {
public:
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  /// A model of `TMeshObserver`; it refers to the ancestors.
  class Observer : public T_mesh_observer {
  public:
    explicit Observer(Face_ancestors& ancestors) : m_ancestors(&ancestors) {}

    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      std::vector<face_descriptor> old_faces;
      for (const auto& piece : pieces)
        old_faces.push_back((*m_ancestors)(piece.from));
      for (std::size_t i = 0; i < pieces.size(); ++i)
        m_ancestors->m_ancestor[pieces[i].to] = old_faces[i];
    }

  private:
    Face_ancestors* m_ancestors;
  };

  Observer observer() { return Observer(*this); }

  /// The face itself if it was there from the beginning.
  face_descriptor operator()(const face_descriptor f) const
  {
    const auto found = m_ancestor.find(f);
    return found == m_ancestor.end() ? f : found->second;
  }

private:
  std::unordered_map<face_descriptor, face_descriptor, boost::hash<face_descriptor>> m_ancestor;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_FACE_ANCESTORS_H
