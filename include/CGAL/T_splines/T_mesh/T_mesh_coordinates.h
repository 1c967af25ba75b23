// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/internal/face_frames.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// returns the extended valence of a vertex ([CZ17] section 4): the number of quarter turns of the faces around it, one
/// at each corner of a face and two where a face goes straight on.
///
/// At a cone it is k_v of the holonomy signature, at other inner vertices 4, at regular vertices of a border 2.
/// \tparam TMesh a model of `TMesh`; a vertex may occur several times on a face
/// \param v a vertex of `t_mesh` with at least one edge
/// \param t_mesh the T-mesh
template <typename TMesh>
int extended_valence(const typename TMesh::vertex_descriptor v, const TMesh& t_mesh)
{
  const auto& graph = t_mesh.graph();
  int result = 0;
  for (const auto h : CGAL::halfedges_around_target(halfedge(v, graph), graph)) {
    if (face(h, graph) != boost::graph_traits<typename TMesh::Graph>::null_face())
      result += get(t_mesh.corners(), h) ? 1 : 2;
  }
  return result;
}

/// \ingroup PkgTSplinesTMesh
/// returns whether a vertex is on the border of a T-mesh.
template <typename TMesh>
bool is_border_vertex(const typename TMesh::vertex_descriptor v, const TMesh& t_mesh)
{
  const auto& graph = t_mesh.graph();
  for (const auto h : CGAL::halfedges_around_target(halfedge(v, graph), graph)) {
    if (face(h, graph) == boost::graph_traits<typename TMesh::Graph>::null_face())
      return true;
  }
  return false;
}

/// \ingroup PkgTSplinesTMesh
/// returns whether the extended valence of a vertex is not the regular one: 4, or 2 on the border.
template <typename TMesh>
bool is_extraordinary(const typename TMesh::vertex_descriptor v, const TMesh& t_mesh)
{
  return extended_valence(v, t_mesh) != (is_border_vertex(v, t_mesh) ? 2 : 4);
}

/// \ingroup PkgTSplinesTMesh
/// Coordinates in the faces of a T-mesh with halfedge knots.
///
/// The frame of a face: its four sides are the runs of halfedges between corners. The side that contains `halfedge(f)`
/// is the bottom, number 0; the others follow counter-clockwise. The origin is the corner where the bottom begins, the
/// u axis runs along it, the v axis to its left: the face is [0, width] x [0, height].
///
/// The class refers to the T-mesh and follows its changes. Each function takes time linear in the number of halfedges
/// of one face, or two.
/// \tparam TMesh a `T_mesh_view` of a `const` graph, which the constructor finds for any model of `TMesh`
/// \pre each face has exactly four corners
template <typename TMesh>
class T_mesh_coordinates {
public:
  using Graph = typename TMesh::Graph;                             ///< the T-mesh's graph
  using FT = typename TMesh::FT;                                   ///< number type of the knots
  using vertex_descriptor = typename TMesh::vertex_descriptor;     ///< a vertex of the graph
  using halfedge_descriptor = typename TMesh::halfedge_descriptor; ///< a halfedge of the graph
  using face_descriptor = typename TMesh::face_descriptor;         ///< a face of the graph

  /// Where a halfedge lies on the boundary of its face.
  struct Place {
    int side; ///< in {0, 1, 2, 3}
    FT begin; ///< distance of the halfedge's source from the corner where the side begins
  };

  /// refers to the graph and the maps of `t_mesh`.
  explicit T_mesh_coordinates(const TMesh& t_mesh) : m_t_mesh(t_mesh) {}

  /// returns the T-mesh that the coordinates are of.
  const TMesh& t_mesh() const { return m_t_mesh; }

  /// returns the first halfedge of the side that contains `h`.
  halfedge_descriptor first_of_side(halfedge_descriptor h) const
  {
    for (halfedge_descriptor p = prev(h, graph()); !m_t_mesh.is_corner(p); p = prev(h, graph()))
      h = p;
    return h;
  }

  /// returns the last halfedge of the side that contains `h`.
  halfedge_descriptor last_of_side(halfedge_descriptor h) const
  {
    while (!m_t_mesh.is_corner(h))
      h = next(h, graph());
    return h;
  }

  /// returns the halfedge at which side number `side` of `f` begins.
  halfedge_descriptor first_of_side(const face_descriptor f, const int side) const
  {
    halfedge_descriptor h = halfedge(f, graph());
    if (side == 0)
      return first_of_side(h);
    for (int i = 0; i < side; ++i)
      h = next(last_of_side(h), graph());
    return h;
  }

  /// returns the length of the side that contains `h`.
  FT side_length(const halfedge_descriptor h) const
  {
    halfedge_descriptor i = first_of_side(h);
    FT result = m_t_mesh.knot(i);
    while (!m_t_mesh.is_corner(i)) {
      i = next(i, graph());
      result += m_t_mesh.knot(i);
    }
    return result;
  }

  FT width(const face_descriptor f) const { return side_length(halfedge(f, graph())); } ///< of the bottom side
  FT height(const face_descriptor f) const { return side_length(first_of_side(f, 1)); } ///< of the side after it

  /// returns the number of the side that contains `h`.
  int side(const halfedge_descriptor h) const
  {
    const halfedge_descriptor last = last_of_side(h);
    halfedge_descriptor i = last_of_side(halfedge(face(h, graph()), graph()));
    int result = 0;
    for (; i != last; i = last_of_side(next(i, graph())))
      ++result;
    CGAL_assertion(result < 4);
    return result;
  }

  /// returns on which side of its face, and how far from the side's beginning, `h` begins.
  Place place(const halfedge_descriptor h) const
  {
    Place result{side(h), FT(0)};
    for (halfedge_descriptor i = first_of_side(h); i != h; i = next(i, graph()))
      result.begin += m_t_mesh.knot(i);
    return result;
  }

  /// returns the point of face `f` at the distance `distance` from the beginning of side number `side`.
  std::pair<FT, FT> point(const face_descriptor f, const int side, const FT& distance) const
  {
    return internal::point_of_side(*this, f, side, distance);
  }

  /// returns the source of `h` in the frame of its face.
  std::pair<FT, FT> source_point(const halfedge_descriptor h) const
  {
    const Place p = place(h);
    return point(face(h, graph()), p.side, p.begin);
  }

  /// returns the target of `h` in the frame of its face: the frame's coordinates of a vertex, one pair for each
  /// halfedge that ends there.
  std::pair<FT, FT> target_point(const halfedge_descriptor h) const
  {
    const Place p = place(h);
    return point(face(h, graph()), p.side, p.begin + m_t_mesh.knot(h));
  }

  /// returns the similarity from the frame of the face of `h` to that of the face of its opposite, tau of [CZ17] 4.1.1.
  /// \pre both are faces
  Similarity_2<FT> transition(const halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, graph());
    const Place from = place(h), to = place(o);
    return internal::transition_of_frames<FT>({from.side, point(face(h, graph()), from.side, from.begin)},
                                              {to.side, point(face(o, graph()), to.side, to.begin + m_t_mesh.knot(o))},
                                              m_t_mesh.knot(o) / m_t_mesh.knot(h));
  }

private:
  const Graph& graph() const { return m_t_mesh.graph(); }

  TMesh m_t_mesh;
};

/// \cond INTERNAL
template <typename TMesh>
T_mesh_coordinates(const TMesh&) -> T_mesh_coordinates<Const_T_mesh_view_of<TMesh>>;
/// \endcond

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H
