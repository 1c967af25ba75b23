// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_FACE_TRIANGLES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_FACE_TRIANGLES_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/internal/Closest_rectangle.h>
#include <CGAL/T_splines/internal/Enclosed_number.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Finds the triangles of a map that the faces of a T-mesh cover, and where they lie in the frames of the faces.
///
/// From the anchor of a face, it crosses the edges that meet the rectangle of the face, breadth first. A triangle that
/// a face meets several times has several images there; as the interior of a face is embedded, they show different
/// parts of it. Only the first corner is found in numbers of the type `FT`; the others follow one from the other by the
/// shapes of the triangles, so that round-off grows with the size of the face and its triangles, not with that of the
/// charts. The rectangle is enlarged by more than this round-off, in order that no triangle is missed. That does no
/// harm: ways in it differ from ways in the face only if they go around a cone or a corner of the border, and those are corners;
/// edges that leave a corner are crossed only if they lead into the rectangle.
template <typename FT>
class Face_triangles {
  using Layout = Seamless_layout<FT>;

public:
  static constexpr int none = -1;
  using Vector = std::array<double, 2>;
  using Barycentric_coordinates = std::array<double, 3>;

  /// A place in the closed rectangle of a face.
  struct Place {
    int face = none;
    double u = 0, v = 0;
  };

  explicit Face_triangles(const Layout& layout)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_vectors(layout.mesh().number_of_halfedges()),
      m_is_regular(layout.mesh().number_of_vertices()),
      m_last_image(layout.mesh().number_of_faces(), none)
  {
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_is_regular[v] = layout.quarter_turns(v) == 4;
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) == none)
        m_is_regular[m_mesh.target(h)] = 0;
      else
        for (int axis = 0; axis < 2; ++axis)
          m_vectors[h][axis] = difference(layout.coordinate(h, axis), layout.coordinate(m_mesh.previous(h), axis));
    for (int b = 0; b < layout.number_of_branches(); ++b)
      m_branch_scales.push_back(CGAL::to_double(layout.transition_of_branch(b).scale()));
  }

  /// Adds the next face, [0, width] x [0, height], of which a part lies in a triangle.
  /// \param progress if it is interrupted, images of the face are missing
  void add_face(const int triangle, const Similarity_2<FT>& to_face, const double width, const double height,
                Progress& progress)
  {
    const int face = static_cast<int>(m_sizes.size());
    std::size_t i = m_images.size();
    m_sizes.push_back({{width, height}});
    add_image(triangle, anchored(face, triangle, to_face));
    for (; i < m_images.size() && progress.go_on_after(5); ++i) {
      const auto corner = corners(m_images[i].triangle);
      for (int side = 0; side < 3; ++side) {
        const int across = opposite(corner[side]);
        if (m_mesh.face(across) == none || !is_crossed(m_images[i], corner, side))
          continue;
        const Image image = continued(m_images[i], side, across);
        if (!is_known(image))
          add_image(image.triangle, image);
      }
    }
  }

  /// Gives images to triangles that no face has met: those of their neighbors, continued. To be called after all faces.
  void complete()
  {
    std::vector<int> missing;
    for (int t = 0; t < m_mesh.number_of_faces(); ++t)
      if (m_last_image[t] == none)
        missing.push_back(t);
    for (std::size_t before = missing.size() + 1; missing.size() < before;) {
      before = missing.size();
      missing.erase(std::remove_if(missing.begin(), missing.end(), [&](const int t) { return is_completed(t); }),
                    missing.end());
    }
  }

  /// The place of a point of a triangle: in the first face that contains it, else in the one that misses it by least.
  /// \param barycentric of the targets of `halfedge_of_face(triangle)`, of the next halfedge, and of the one after it
  Place place(const int triangle, const Barycentric_coordinates& barycentric) const
  {
    Place result;
    Closest_rectangle<double> closest;
    for (int i = m_last_image[triangle]; i != none && !closest.contains_point(); i = m_images[i].next) {
      const Image& image = m_images[i];
      const Vector p = combination(image, barycentric), size = m_sizes[image.face];
      if (closest.offer(p[0], p[1], size[0], size[1]))
        result = {image.face, p[0], p[1]};
    }
    if (closest.is_chosen())
      clamp_to_rectangle(result.u, result.v, m_sizes[result.face][0], m_sizes[result.face][1]);
    return result;
  }

  std::size_t number_of_images() const { return m_images.size(); }

  /// Calls `f(face, triangle, corners)` for all images, with the places in the frame of the face of the targets of the
  /// three halfedges that `place()` names.
  template <typename Function>
  void for_each_image(const Function& f) const
  {
    for (const Image& image : m_images)
      f(image.face, image.triangle, image.corner);
  }

private:
  /// A triangle in the frame of a face.
  struct Image {
    int triangle, face;
    int next = none; ///< the image of the same triangle that was found before
    int quarter_turns;
    double scale;  ///< from the chart of the triangle to the face
    double extent; ///< the largest coordinate on the way to here, which round-off is a part of
    std::array<Vector, 3> corner;

    double tolerance() const { return round_off * extent; }
    static constexpr double round_off = 1e-12; // of sums of some transitions
  };

  /// Where digits cancel, the exact numbers are subtracted: charts may be large against their triangles.
  static double difference(const Enclosed_number<FT>& a, const Enclosed_number<FT>& b)
  {
    const double result = a.lower - b.lower;
    if ((a.exact != nullptr || b.exact != nullptr) && std::abs(result) < std::abs(b.lower))
      return CGAL::to_double(FT(a.value() - b.value()));
    return result;
  }

  static Vector linear(const Image& image, const Vector& x)
  {
    const std::pair<double, double> y = Similarity_2<double>(image.quarter_turns, image.scale, 0, 0)(x[0], x[1]);
    return {{y.first, y.second}};
  }
  static Vector sum(const Vector& a, const Vector& b) { return {{a[0] + b[0], a[1] + b[1]}}; }
  static Vector negated(const Vector& a) { return {{-a[0], -a[1]}}; }

  static Vector combination(const Image& image, const Barycentric_coordinates& b)
  {
    Vector p = {{0, 0}};
    for (int axis = 0; axis < 2; ++axis)
      p[axis] = b[0] * image.corner[0][axis] + b[1] * image.corner[1][axis] + b[2] * image.corner[2][axis];
    return p;
  }

  static void extend(Image& image)
  {
    for (const Vector& p : image.corner)
      image.extent = (std::max)({image.extent, std::abs(p[0]), std::abs(p[1])});
  }

  /// The halfedges that point to the corners.
  std::array<int, 3> corners(const int triangle) const
  {
    const int h = m_mesh.halfedge_of_face(triangle), g = m_mesh.next(h);
    return {{h, g, m_mesh.next(g)}};
  }

  Image anchored(const int face, const int triangle, const Similarity_2<FT>& to_face) const
  {
    Image image;
    image.triangle = triangle;
    image.face = face;
    image.quarter_turns = to_face.quarter_turns();
    image.scale = CGAL::to_double(to_face.scale());
    image.extent = (std::max)(m_sizes[face][0], m_sizes[face][1]);
    const std::array<int, 3> corner = corners(triangle);
    const auto [u, v] = to_face(m_layout.coordinate(corner[0], 0).value(), m_layout.coordinate(corner[0], 1).value());
    image.corner[0] = {{CGAL::to_double(u), CGAL::to_double(v)}};
    image.corner[1] = sum(image.corner[0], linear(image, m_vectors[corner[1]]));
    image.corner[2] = sum(image.corner[0], negated(linear(image, m_vectors[corner[0]])));
    extend(image);
    return image;
  }

  /// The image of the triangle of `across`, the opposite of the halfedge that points to the corner `side`.
  Image continued(const Image& from, const int side, const int across) const
  {
    Image image = from;
    image.triangle = m_mesh.face(across);
    image.next = none;
    if (m_layout.is_cut(edge_of(across))) {
      const int branch = m_layout.branch(edge_of(across));
      const bool is_along = m_layout.is_along_branch(across);
      image.quarter_turns = (image.quarter_turns + m_layout.rotation(across)) % 4;
      image.scale *= is_along ? m_branch_scales[branch] : 1 / m_branch_scales[branch];
    }
    const std::array<int, 3> corner = corners(image.triangle);
    const int i = corner[0] == across ? 0 : corner[1] == across ? 1 : 2, apex = (i + 1) % 3, source = (i + 2) % 3;
    image.corner[i] = from.corner[(side + 2) % 3];
    image.corner[source] = from.corner[side];
    const Vector &after = m_vectors[corner[apex]], &before = m_vectors[corner[source]];
    const bool is_after_shorter = std::hypot(after[0], after[1]) < std::hypot(before[0], before[1]);
    image.corner[apex] = is_after_shorter ? sum(image.corner[i], linear(image, after))
                                          : sum(image.corner[source], negated(linear(image, before)));
    extend(image);
    return image;
  }

  void add_image(const int triangle, Image image)
  {
    image.next = m_last_image[triangle];
    m_last_image[triangle] = static_cast<int>(m_images.size());
    m_images.push_back(image);
  }

  bool is_known(const Image& image) const
  {
    for (int i = m_last_image[image.triangle]; i != none && m_images[i].face == image.face; i = m_images[i].next)
      if (is_same(m_images[i], image))
        return true;
    return false;
  }

  /// Whether two images of a triangle in a face are one: up to round-off, and to a small part of their size.
  static bool is_same(const Image& a, const Image& b)
  {
    double size = 0, distance = 0;
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        size = (std::max)(size, std::abs(a.corner[i][axis] - a.corner[(i + 1) % 3][axis]));
        distance = (std::max)(distance, std::abs(a.corner[i][axis] - b.corner[i][axis]));
      }
    return a.quarter_turns == b.quarter_turns && distance <= same_point * size + 2 * (a.tolerance() + b.tolerance());
  }

  // --- which edges are crossed

  /// \param corner the halfedges of the image's triangle. \param side the halfedge that points to this corner
  bool is_crossed(const Image& image, const std::array<int, 3>& corner, const int side) const
  {
    const int source = (side + 2) % 3;
    for (const auto& [from, to] : {std::pair<int, int>(source, side), std::pair<int, int>(side, source)}) {
      Vector inwards;
      if (m_is_regular[m_mesh.target(corner[from])] == 0 && is_corner_of_face(image, from, inwards))
        return leads_inwards(image.corner[from], image.corner[to], inwards);
    }
    return meets_rectangle(image, image.corner[source], image.corner[side]);
  }

  /// \param inwards the signs of the directions from the corner into the rectangle
  bool is_corner_of_face(const Image& image, const int i, Vector& inwards) const
  {
    for (int axis = 0; axis < 2; ++axis) {
      const double x = image.corner[i][axis], size = m_sizes[image.face][axis];
      inwards[axis] = x < size / 2 ? 1 : -1;
      if ((std::min)(std::abs(x), std::abs(x - size)) > 100 * image.tolerance())
        return false;
    }
    return true;
  }

  static bool leads_inwards(const Vector& from, const Vector& to, const Vector& inwards)
  {
    const double u = (to[0] - from[0]) * inwards[0], v = (to[1] - from[1]) * inwards[1];
    const double tolerance = Image::round_off * (std::max)(std::abs(u), std::abs(v));
    return u > -tolerance && v > -tolerance;
  }

  /// Whether a segment meets the open rectangle, enlarged.
  bool meets_rectangle(const Image& image, const Vector& a, const Vector& b) const
  {
    double begin = 0, end = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double length = b[axis] - a[axis], lower = -image.tolerance() - a[axis],
                   upper = m_sizes[image.face][axis] + image.tolerance() - a[axis];
      if (length == 0) {
        if (lower >= 0 || upper <= 0)
          return false;
        continue;
      }
      begin = (std::max)(begin, (length > 0 ? lower : upper) / length);
      end = (std::min)(end, (length > 0 ? upper : lower) / length);
    }
    return begin < end;
  }

  // --- triangles without an image

  bool is_completed(const int triangle)
  {
    Image best;
    Closest_rectangle<double> closest;
    for (const int h : corners(triangle)) {
      const int neighbor = m_mesh.face(opposite(h));
      if (neighbor == none || neighbor == triangle)
        continue;
      const std::array<int, 3> corner = corners(neighbor);
      const int side = static_cast<int>(std::find(corner.begin(), corner.end(), opposite(h)) - corner.begin());
      for (int i = m_last_image[neighbor]; i != none; i = m_images[i].next) {
        const Image image = continued(m_images[i], side, h);
        const Vector p = combination(image, {{1. / 3, 1. / 3, 1. / 3}}), size = m_sizes[image.face];
        if (closest.offer(p[0], p[1], size[0], size[1]))
          best = image;
      }
    }
    if (!closest.is_chosen())
      return false;
    add_image(triangle, best);
    return true;
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  std::vector<Vector> m_vectors;       // per halfedge: from its source to its target, in the chart of its face
  std::vector<double> m_branch_scales; // of the transitions
  std::vector<char> m_is_regular;      // per vertex: inside, and no cone
  std::vector<int> m_last_image;       // per triangle: the head of the list of its images
  std::vector<Image> m_images;         // those of a face are consecutive
  std::vector<Vector> m_sizes;         // per face: width, height
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_FACE_TRIANGLES_H
