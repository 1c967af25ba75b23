// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H

#include <CGAL/T_splines/Similarity_map/Similarity_2.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CGAL {
namespace T_splines {

/// returns the extended valence of a vertex ([CZ17] section 4): the number of quarter turns of the faces around it, one
/// at each corner of a face and two where a face goes straight on.
///
/// At a cone it is k_v of the holonomy signature, at other inner vertices 4, at regular vertices of a border 2.
/// \tparam TMesh a model of `HalfedgeGraph` and `FaceGraph`; a vertex may occur several times on a face
/// \tparam HalfedgeCornerMap a readable map, halfedge -> `bool`
/// \param v a vertex of `t_mesh` with at least one edge
template <typename TMesh, typename HalfedgeCornerMap>
int extended_valence(const typename boost::graph_traits<TMesh>::vertex_descriptor v, const TMesh& t_mesh,
                     const HalfedgeCornerMap corners)
{
  int result = 0;
  for (const auto h : CGAL::halfedges_around_target(halfedge(v, t_mesh), t_mesh)) {
    if (face(h, t_mesh) != boost::graph_traits<TMesh>::null_face())
      result += get(corners, h) ? 1 : 2;
  }
  return result;
}

/// returns whether a vertex is on the border of a T-mesh.
template <typename TMesh>
bool is_border_vertex(const typename boost::graph_traits<TMesh>::vertex_descriptor v, const TMesh& t_mesh)
{
  for (const auto h : CGAL::halfedges_around_target(halfedge(v, t_mesh), t_mesh)) {
    if (face(h, t_mesh) == boost::graph_traits<TMesh>::null_face())
      return true;
  }
  return false;
}

/// returns whether the extended valence of a vertex is not the regular one: 4, or 2 on the border.
template <typename TMesh, typename HalfedgeCornerMap>
bool is_extraordinary(const typename boost::graph_traits<TMesh>::vertex_descriptor v, const TMesh& t_mesh,
                      const HalfedgeCornerMap corners)
{
  return extended_valence(v, t_mesh, corners) != (is_border_vertex(v, t_mesh) ? 2 : 4);
}

/// Coordinates in the faces of a T-mesh with halfedge knots.
///
/// The frame of a face: its four sides are the runs of halfedges between corners. The side that contains `halfedge(f)`
/// is the bottom, number 0; the others follow counter-clockwise. The origin is the corner where the bottom begins, the
/// u axis runs along it, the v axis to its left: the face is [0, width] x [0, height].
///
/// The class refers to the T-mesh and follows its changes. Each function takes time linear in the number of halfedges
/// of one face, or two.
/// \tparam TMesh a model of `HalfedgeGraph` and `FaceGraph`; it may be non-simple
/// \tparam HalfedgeKnotMap a readable map, halfedge -> knot interval in the units of the halfedge's face
/// \tparam HalfedgeCornerMap a readable map, halfedge -> `bool`: its face turns at its target
/// \pre each face has exactly four corners
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap>
class T_mesh_coordinates {
  using Traits = boost::graph_traits<TMesh>;

public:
  using FT = typename boost::property_traits<HalfedgeKnotMap>::value_type;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  /// Where a halfedge lies on the boundary of its face.
  struct Place {
    int side; ///< in {0, 1, 2, 3}
    FT begin; ///< distance of the halfedge's source from the corner where the side begins
  };

  T_mesh_coordinates(const TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners)
    : m_t_mesh(&t_mesh),
      m_knots(knots),
      m_corners(corners)
  {
  }

  const TMesh& t_mesh() const { return *m_t_mesh; }

  /// returns the first halfedge of the side that contains `h`.
  halfedge_descriptor first_of_side(halfedge_descriptor h) const
  {
    for (halfedge_descriptor p = prev(h, *m_t_mesh); !get(m_corners, p); p = prev(h, *m_t_mesh))
      h = p;
    return h;
  }

  /// returns the last halfedge of the side that contains `h`.
  halfedge_descriptor last_of_side(halfedge_descriptor h) const
  {
    while (!get(m_corners, h))
      h = next(h, *m_t_mesh);
    return h;
  }

  /// returns the halfedge at which side number `side` of `f` begins.
  halfedge_descriptor first_of_side(const face_descriptor f, const int side) const
  {
    halfedge_descriptor h = halfedge(f, *m_t_mesh);
    if (side == 0)
      return first_of_side(h);
    for (int i = 0; i < side; ++i)
      h = next(last_of_side(h), *m_t_mesh);
    return h;
  }

  /// returns the length of the side that contains `h`.
  FT side_length(const halfedge_descriptor h) const
  {
    halfedge_descriptor i = first_of_side(h);
    FT result = get(m_knots, i);
    while (!get(m_corners, i)) {
      i = next(i, *m_t_mesh);
      result += get(m_knots, i);
    }
    return result;
  }

  FT width(const face_descriptor f) const { return side_length(halfedge(f, *m_t_mesh)); } ///< of the bottom side
  FT height(const face_descriptor f) const { return side_length(first_of_side(f, 1)); }   ///< of the side after it

  /// returns the number of the side that contains `h`.
  int side(const halfedge_descriptor h) const
  {
    const halfedge_descriptor last = last_of_side(h);
    halfedge_descriptor i = last_of_side(halfedge(face(h, *m_t_mesh), *m_t_mesh));
    int result = 0;
    for (; i != last; i = last_of_side(next(i, *m_t_mesh)))
      ++result;
    CGAL_assertion(result < 4);
    return result;
  }

  /// returns on which side of its face, and how far from the side's beginning, `h` begins.
  Place place(const halfedge_descriptor h) const
  {
    Place result{side(h), FT(0)};
    for (halfedge_descriptor i = first_of_side(h); i != h; i = next(i, *m_t_mesh))
      result.begin += get(m_knots, i);
    return result;
  }

  /// returns the point of face `f` at the distance `distance` from the beginning of side number `side`.
  std::pair<FT, FT> point(const face_descriptor f, const int side, const FT& distance) const
  {
    switch (side) {
    case 0: return {distance, FT(0)};
    case 1: return {width(f), distance};
    case 2: return {FT(width(f) - distance), height(f)};
    default: return {FT(0), FT(height(f) - distance)};
    }
  }

  /// returns the source of `h` in the frame of its face.
  std::pair<FT, FT> source_point(const halfedge_descriptor h) const
  {
    const Place p = place(h);
    return point(face(h, *m_t_mesh), p.side, p.begin);
  }

  /// returns the target of `h` in the frame of its face: the frame's coordinates of a vertex, one pair for each
  /// halfedge that ends there.
  std::pair<FT, FT> target_point(const halfedge_descriptor h) const
  {
    const Place p = place(h);
    return point(face(h, *m_t_mesh), p.side, p.begin + get(m_knots, h));
  }

  /// returns the similarity from the frame of the face of `h` to that of the face of its opposite, tau of [CZ17] 4.1.1.
  /// \pre both are faces
  Similarity_2<FT> transition(const halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, *m_t_mesh);
    const Place from = place(h), to = place(o);
    const std::pair<FT, FT> p = point(face(h, *m_t_mesh), from.side, from.begin);
    const std::pair<FT, FT> q = point(face(o, *m_t_mesh), to.side, to.begin + get(m_knots, o));
    const int turns = to.side + 2 - from.side;
    const FT scale = get(m_knots, o) / get(m_knots, h);
    const std::pair<FT, FT> image = Similarity_2<FT>(turns, scale, FT(0), FT(0))(p.first, p.second);
    return Similarity_2<FT>(turns, scale, q.first - image.first, q.second - image.second);
  }

private:
  const TMesh* m_t_mesh;
  HalfedgeKnotMap m_knots;
  HalfedgeCornerMap m_corners;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_COORDINATES_H
