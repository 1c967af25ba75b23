// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CARRIED_POINTS_H
#define CGAL_T_SPLINES_T_MESH_CARRIED_POINTS_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>

#include <CGAL/number_type_basic.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Points in the faces of a T-mesh that stay where they are on the surface while the T-mesh changes under them.
///
/// Give `observer()` to the operations that change the T-mesh; each takes time linear in the number of points in the
/// faces that it touches.
/// \tparam Graph a model of `FaceGraph`
/// \tparam NT the number type of the points' coordinates: `double`, or an exact one
/// \tparam Payload a copyable type: what a point carries with it, such as its place on a surface
template <typename Graph, typename NT_, typename Payload_>
class Carried_points {
public:
  using NT = NT_;                                                               ///< number type of the coordinates
  using Payload = Payload_;                                                     ///< what a point carries with it
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the T-mesh

  /// A point in the frame of a face.
  struct Point {
    NT u,            ///< coordinate in the frame of the face
        v;           ///< coordinate in the frame of the face
    Payload payload; ///< what goes with the point
  };

  /// The observer that moves the points from old faces to new ones, a model of `TMeshObserver`. It refers to the points.
  ///
  /// \cgalModels{TMeshObserver}
  class Observer : public T_mesh_observer {
  public:
    /// refers to `points`.
    explicit Observer(Carried_points& points) : m_points(&points) {}

    /// follows the change of faces.
    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      m_points->replace_faces(pieces);
    }

  private:
    Carried_points* m_points;
  };

  /// adds a point with the coordinates (u, v) in the frame of `f`.
  void add(const face_descriptor f, NT u, NT v, Payload payload)
  {
    m_points[f].push_back(Point{std::move(u), std::move(v), std::move(payload)});
  }

  /// returns the points in the face `f`, in no particular order; valid until the T-mesh changes.
  const std::vector<Point>& points(const face_descriptor f) const
  {
    const auto found = m_points.find(f);
    return found == m_points.end() ? m_none : found->second;
  }

  /// returns the observer that keeps it up to date; it refers to this object.
  Observer observer() { return Observer(*this); }

  /// moves the points of the faces that are listed as `from`, each by its piece. Round-off may leave a point outside of
  /// all pieces by a little: it goes by the one that it is closest to.
  template <typename FT>
  void replace_faces(const std::vector<T_mesh_piece<Graph, FT>>& pieces)
  {
    std::vector<std::vector<Converted_piece>> pieces_of;
    std::vector<std::vector<Point>> old_points;
    std::unordered_map<face_descriptor, std::size_t, boost::hash<face_descriptor>> index;
    for (const T_mesh_piece<Graph, FT>& piece : pieces) {
      const auto inserted = index.emplace(piece.from, old_points.size());
      if (inserted.second) {
        old_points.emplace_back();
        pieces_of.emplace_back();
        const auto found = m_points.find(piece.from);
        if (found != m_points.end()) {
          old_points.back().swap(found->second);
          m_points.erase(found);
        }
      }
      if (!old_points[inserted.first->second].empty())
        pieces_of[inserted.first->second].push_back(converted(piece));
    }
    for (std::size_t i = 0; i < old_points.size(); ++i) {
      for (Point& point : old_points[i])
        move(point, pieces_of[i]);
    }
  }

private:
  struct Converted_piece {
    face_descriptor to;
    Similarity_2<NT> transition;
    NT width, height;
  };

  template <typename FT>
  static NT number(const FT& x)
  {
    if constexpr (std::is_convertible<FT, NT>::value)
      return x;
    else
      return NT(CGAL::to_double(x));
  }

  template <typename FT>
  static Converted_piece converted(const T_mesh_piece<Graph, FT>& piece)
  {
    const Similarity_2<FT>& t = piece.transition;
    return {piece.to, Similarity_2<NT>(t.quarter_turns(), number(t.scale()), number(t.u()), number(t.v())),
            number(piece.width), number(piece.height)};
  }

  // How far x is outside of [0, size], relative to size.
  static NT excess(const NT& x, const NT& size)
  {
    if (x < NT(0))
      return -x / size;
    return x > size ? NT((x - size) / size) : NT(0);
  }

  void move(Point& point, const std::vector<Converted_piece>& pieces)
  {
    const Converted_piece* best = nullptr;
    std::pair<NT, NT> best_image;
    NT best_excess(0);
    for (const Converted_piece& piece : pieces) {
      const std::pair<NT, NT> image = piece.transition(point.u, point.v);
      const NT e = (std::max)(excess(image.first, piece.width), excess(image.second, piece.height));
      if (best != nullptr && !(e < best_excess))
        continue;
      best = &piece;
      best_image = image;
      best_excess = e;
      if (e == NT(0))
        break;
    }
    m_points[best->to].push_back(Point{best_image.first, best_image.second, std::move(point.payload)});
  }

  std::unordered_map<face_descriptor, std::vector<Point>, boost::hash<face_descriptor>> m_points;
  std::vector<Point> m_none;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CARRIED_POINTS_H
