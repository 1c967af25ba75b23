// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CARRIED_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CARRIED_SPLINE_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Closest_rectangle.h>

#include <CGAL/number_type_basic.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A spline surface as a function on the triangles of a carried surface.
/// \tparam Compiled a `Compiled_T_spline`
/// \tparam Carried a `Carried_surface` on its T-mesh
template <typename Compiled, typename Carried>
class Carried_spline {
  using FT = typename Compiled::FT;

public:
  /// Copies what it needs of the carried surface; the faces of its T-mesh must stay valid descriptors.
  Carried_spline(Compiled compiled, const Carried& carried)
    : m_compiled(std::move(compiled)),
      m_first(carried.triangles().size() + 1, 0)
  {
    const int number_of_faces = m_compiled.indexing().number_of_faces();
    for (int f = 0; f < number_of_faces; ++f)
      for (const auto& image : carried.images(m_compiled.indexing().face(f)))
        ++m_first[image.triangle + 1];
    for (std::size_t t = 0; t + 1 < m_first.size(); ++t)
      m_first[t + 1] += m_first[t];
    m_images.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (int f = 0; f < number_of_faces; ++f)
      for (const auto& image : carried.images(m_compiled.indexing().face(f)))
        m_images[next[image.triangle]++] = {f, image.corners};
  }

  const Compiled& compiled() const { return m_compiled; }

  /// The point of the spline over a point of a triangle.
  /// \param y, z its barycentric coordinates at the second and third corner
  Triangle_set::Point_3 position(const std::size_t triangle, const double y, const double z) const
  {
    int face = 0;
    std::array<double, 2> place = {}, size = {};
    Closest_rectangle<double> closest;
    for (std::size_t i = m_first[triangle]; i < m_first[triangle + 1] && !closest.contains_point(); ++i) {
      const auto& c = m_images[i].corners;
      const double u = c[0][0] + y * (c[1][0] - c[0][0]) + z * (c[2][0] - c[0][0]),
                   v = c[0][1] + y * (c[1][1] - c[0][1]) + z * (c[2][1] - c[0][1]);
      const auto f = m_compiled.indexing().face(m_images[i].face);
      const double width = CGAL::to_double(m_compiled.width(f)), height = CGAL::to_double(m_compiled.height(f));
      if (closest.offer(u, v, width, height)) {
        face = m_images[i].face;
        place = {u, v};
        size = {width, height};
      }
    }
    clamp_to_rectangle(place[0], place[1], size[0], size[1]);
    return point_in_doubles(m_compiled.position(m_compiled.indexing().face(face), FT(place[0]), FT(place[1])));
  }

private:
  struct Image {
    int face;
    std::array<std::array<double, 2>, 3> corners;
  };

  Compiled m_compiled;
  std::vector<std::size_t> m_first; // per triangle, in m_images
  std::vector<Image> m_images;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CARRIED_SPLINE_H
