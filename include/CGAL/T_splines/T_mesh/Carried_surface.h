// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CARRIED_SURFACE_H
#define CGAL_T_SPLINES_T_MESH_CARRIED_SURFACE_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/support/triangle_meets_rectangle.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/converted_similarity.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// A surface of triangles that a T-mesh lies on, and that stays where it is in space while the T-mesh changes: which
/// triangles each face covers, and where they are in its frame. So every place in a face is a point of the surface.
///
/// `carry_surface()` makes one of a map and the T-mesh that was traced on it; for surfaces of other origin, points,
/// triangles and images are added one by one. Triangles that only close holes are no data: fits take nothing from them. Give `observer()` to the operations that change the T-mesh; each takes
/// time n log n in the number of images in the faces that it touches.
/// \tparam Graph_ a model of `FaceGraph`
template <typename Graph_>
class Carried_surface {
public:
  using Graph = Graph_;                                                         ///< the T-mesh's graph
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the graph
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;                      ///< a point in space
  using Parameters = std::array<double, 2>;                                     ///< u and v
  using Triangle = std::array<std::size_t, 3>; ///< numbers of points, seen counter-clockwise from outside

  /// A triangle in the frame of a face that it meets, in the interior of both. It may reach out of the face, and a face
  /// may meet a triangle several times.
  struct Image {
    std::size_t triangle;              ///< its number
    std::array<Parameters, 3> corners; ///< of the three points, u and v; counter-clockwise
  };

  /// The observer that moves the images from old faces to new ones, a model of `TMeshObserver`. It refers to the surface.
  ///
  /// \cgalModels{TMeshObserver}
  class Observer : public T_mesh_observer {
  public:
    /// refers to `surface`.
    explicit Observer(Carried_surface& surface) : m_surface(&surface) {}

    /// follows the change of faces.
    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      m_surface->replace_faces(pieces);
    }

  private:
    Carried_surface* m_surface;
  };

  /// adds a point, and returns its number: they are counted from 0.
  std::size_t add_point(const Point_3& p)
  {
    m_points.push_back(p);
    return m_points.size() - 1;
  }

  /// adds a triangle of three different points, and returns its number, counted from 0. An edge has at most two
  /// triangles, which name it in opposite directions.
  /// \param triangle the numbers of its points
  /// \param is_data whether it counts for a fit
  std::size_t add_triangle(const Triangle& triangle, const bool is_data = true)
  {
    m_triangles.push_back(triangle);
    m_is_data.push_back(is_data);
    return m_triangles.size() - 1;
  }

  /// adds the image of a triangle in a face. Together, the images of a face cover it; each triangle has one.
  void add_image(const face_descriptor f, const Image& image) { m_images[f].push_back(image); }

  /// returns all points, by their numbers.
  const std::vector<Point_3>& points() const { return m_points; }
  /// returns all triangles, by their numbers.
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  /// returns whether a triangle counts for a fit.
  bool is_data(const std::size_t triangle) const { return m_is_data[triangle]; }

  /// returns the images in the face `f`, in no particular order; valid until the T-mesh changes.
  const std::vector<Image>& images(const face_descriptor f) const
  {
    const auto found = m_images.find(f);
    return found == m_images.end() ? m_none : found->second;
  }

  /// returns the triangles as a mesh, whose vertices and faces are numbered as the points and the triangles.
  CGAL::Surface_mesh<Point_3> mesh() const
  {
    using Mesh = CGAL::Surface_mesh<Point_3>;
    using Size = typename Mesh::size_type;
    Mesh result;
    for (const Point_3& p : m_points)
      result.add_vertex(p);
    for (const Triangle& t : m_triangles)
      result.add_face(typename Mesh::Vertex_index(static_cast<Size>(t[0])),
                      typename Mesh::Vertex_index(static_cast<Size>(t[1])),
                      typename Mesh::Vertex_index(static_cast<Size>(t[2])));
    return result;
  }

  /// returns the observer that keeps it up to date; it refers to this object.
  Observer observer() { return Observer(*this); }

  /// moves the images of the faces that are listed as `from`: by each piece whose rectangle they meet.
  template <typename FT>
  void replace_faces(const std::vector<T_mesh_piece<Graph, FT>>& pieces)
  {
    std::unordered_map<face_descriptor, std::vector<Image>, boost::hash<face_descriptor>> old_images;
    for (const T_mesh_piece<Graph, FT>& piece : pieces) {
      const auto found = m_images.find(piece.from);
      if (found == m_images.end())
        continue;
      old_images[piece.from].swap(found->second);
      m_images.erase(found);
    }
    for (const T_mesh_piece<Graph, FT>& piece : pieces)
      add_images(old_images[piece.from], piece);
    for (const T_mesh_piece<Graph, FT>& piece : pieces)
      remove_duplicates(piece.to);
  }

private:
  template <typename FT>
  void add_images(const std::vector<Image>& images, const T_mesh_piece<Graph, FT>& piece)
  {
    using internal::converted_number;
    const Similarity_2<double> transition = internal::converted_similarity<double>(piece.transition);
    const Parameters size = {converted_number<double>(piece.width), converted_number<double>(piece.height)};
    std::vector<Image>& result = m_images[piece.to];
    for (Image image : images) {
      for (Parameters& corner : image.corners) {
        const std::pair<double, double> p = transition(corner[0], corner[1]);
        corner = {p.first, p.second};
      }
      if (internal::triangle_meets_rectangle(image.corners, size))
        result.push_back(image);
    }
  }

  // Where two faces became one, a triangle that met both has come twice.
  void remove_duplicates(const face_descriptor f)
  {
    std::vector<Image>& images = m_images[f];
    std::stable_sort(images.begin(), images.end(),
                     [](const Image& a, const Image& b) { return a.triangle < b.triangle; });
    auto end = images.begin();
    for (auto image = images.begin(); image != images.end(); ++image) {
      const auto is_known = [&](const Image& other) { return is_same(*image, other); };
      auto first = end;
      while (first != images.begin() && std::prev(first)->triangle == image->triangle)
        --first;
      if (std::none_of(first, end, is_known))
        *end++ = *image;
    }
    images.erase(end, images.end());
  }

  // Two images of one triangle in a face are equal up to round-off, or do not overlap.
  static bool is_same(const Image& a, const Image& b)
  {
    double size = 0, distance = 0;
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        size = (std::max)(size, std::abs(a.corners[i][axis] - a.corners[(i + 1) % 3][axis]));
        distance = (std::max)(distance, std::abs(a.corners[i][axis] - b.corners[i][axis]));
      }
    return distance <= internal::same_image * size;
  }

  std::vector<Point_3> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<bool> m_is_data; // of the triangles
  std::unordered_map<face_descriptor, std::vector<Image>, boost::hash<face_descriptor>> m_images;
  std::vector<Image> m_none;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CARRIED_SURFACE_H
