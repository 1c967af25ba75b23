// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_SAMPLING_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_SAMPLING_H

#include <CGAL/T_splines/Spline/internal/Bezier_cells.h>
#include <CGAL/T_splines/Spline/internal/Surface_walk.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/support/triangle_meets_rectangle.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A point of a carried surface with its place in a T-mesh.
struct Sampled_place {
  int face;
  double u, v;
  std::size_t triangle; ///< of the surface, on which the point lies
  Surface_walk::Point_3 point;
  double area;                            ///< for which the sample stands; 0 if it is only to be measured
  double reach;                           ///< the size of its Bezier cell on the surface
  std::array<double, 2> barycentric = {}; ///< coordinates of the point at the second and third corner; not of edges
  int side = -1;                          ///< of the triangle, from corner `side` on, for a point of the border
};

/// Takes samples of a carried surface as the Bezier cells of a spline over the T-mesh ask for them.
/// \tparam FT the number type of the spline
template <typename Graph, typename FT>
class Surface_sampling {
  using Surface = Carried_surface<Graph>;
  using Image = typename Surface::Image;
  using Parameters = typename Surface::Parameters;
  using Point_3 = Surface_walk::Point_3;

public:
  /// \param walk over the triangles of the surface, cut along creases
  /// \param progress it must outlive this; if it is interrupted, samples are missing
  Surface_sampling(const T_spline_basis<FT>& basis, const Mesh_indexing<Graph>& indexing, const Surface& surface,
                   const Surface_walk& walk, Progress& progress)
    : m_basis(basis),
      m_indexing(indexing),
      m_surface(surface),
      m_walk(walk),
      m_progress(progress)
  {
  }

  /// A grid of samples in each Bezier cell, at least `fewest` x `fewest`; more where the triangles are small against
  /// the cells, but not more than twice as many in each direction. Also where triangles are no data.
  std::vector<Sampled_place> cells(const int fewest)
  {
    std::vector<Sampled_place> samples;
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(work_per_face); ++f) {
      enter(f);
      m_progress.go_on_after(work_per_image * images().size());
      const double triangles_per_cell = static_cast<double>(images().size()) / number_of_cells();
      const int n = std::clamp(static_cast<int>(std::lround(std::sqrt(triangles_per_cell / 2))), fewest, 2 * fewest);
      add_grid(n, samples);
    }
    return samples;
  }

  /// `n` places per Bezier cell on those sides of faces where the border of the surface is, and data.
  std::vector<Sampled_place> border(const int n)
  {
    std::vector<Sampled_place> samples;
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(work_per_face); ++f) {
      enter(f);
      m_progress.go_on_after(work_per_image * images().size());
      for (const Image& image : images())
        for (int i = 0; i < 3; ++i)
          if (m_surface.is_data(image.triangle) &&
              m_walk.across(image.triangle, static_cast<std::size_t>(i)) == image.triangle)
            add_border_edge(image, i, n, samples);
    }
    return samples;
  }

  /// A vertex of the T-mesh at a corner of a border, the number of the surface's point there, and a place of it.
  struct Border_corner {
    int vertex;
    std::size_t point;
    int face;
    FT u, v;
  };

  /// The corners of the border and of the parts between creases: there the surface is where its control point is.
  std::vector<Border_corner> border_corners() const
  {
    std::vector<Border_corner> result;
    const auto& t_mesh = m_basis.t_mesh();
    for (const std::vector<int>& corner : m_basis.border_corners())
      for (const int h : corner)
        if (const std::optional<std::size_t> p = point_at_target(h)) {
          const auto place = t_mesh.target_point(h);
          result.push_back({t_mesh.target(h), *p, t_mesh.face(h), place.first, place.second});
          break;
        }
    return result;
  }

  /// The points of the surface that triangles with data have as corners, each once.
  std::vector<Sampled_place> corners()
  {
    std::vector<Sampled_place> samples;
    std::vector<char> is_taken(m_walk.points().size(), 0);
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(work_per_face); ++f) {
      enter(f);
      m_progress.go_on_after(work_per_image * images().size());
      const double eps_u = same_point * m_width, eps_v = same_point * m_height;
      for (const Image& image : images())
        for (int i = 0; i < 3; ++i) {
          const std::size_t p = m_walk.triangles()[image.triangle][i];
          const double u = image.corners[i][0], v = image.corners[i][1];
          if (!m_surface.is_data(image.triangle) || is_taken[p] || u < -eps_u || v < -eps_v || u > m_width + eps_u ||
              v > m_height + eps_v)
            continue;
          is_taken[p] = 1;
          samples.push_back(
              {f, std::clamp(u, 0., m_width), std::clamp(v, 0., m_height), image.triangle, m_walk.points()[p], 0, 0});
        }
    }
    return samples;
  }

  /// Points of those edges of the surface at which the normal turns by more than `largest_turn` (in radians), about
  /// `per_cell` of them where an edge between data crosses a cell.
  std::vector<Sampled_place> sharp_edges(const double largest_turn, const double per_cell)
  {
    const double cosine = std::cos(largest_turn);
    std::vector<Sampled_place> samples;
    for (int f = 0; f < m_basis.t_mesh().number_of_faces() && m_progress.go_on_after(work_per_face); ++f) {
      enter(f);
      m_progress.go_on_after(work_per_image * images().size());
      for (const Image& image : images())
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t other = m_walk.across(image.triangle, i);
          if (other > image.triangle && m_surface.is_data(image.triangle) && m_surface.is_data(other) &&
              m_walk.unit_normal(image.triangle) * m_walk.unit_normal(other) < cosine)
            add_edge(image, i, per_cell, samples);
        }
    }
    return samples;
  }

private:
  static constexpr std::size_t work_per_face = 20, work_per_image = 2;

  void enter(const int f)
  {
    m_face = f;
    m_width = CGAL::to_double(m_basis.t_mesh().width(f));
    m_height = CGAL::to_double(m_basis.t_mesh().height(f));
    if (m_basis.cone_face_of(f) >= 0) { // the cells get infinitely small: the first ones do
      m_u = {FT(0), FT(m_width / 2), FT(m_width)};
      m_v = {FT(0), FT(m_height / 2), FT(m_height)};
    }
    else {
      find_cell_cuts(m_basis, f, 0, m_u);
      find_cell_cuts(m_basis, f, 1, m_v);
    }
    double on_surface = 0, in_face = 0;
    for (const Image& image : images()) {
      on_surface += area_of_triangle(image);
      in_face += area_of_image(image);
    }
    m_mean_area_of_unit = in_face > 0 ? on_surface / in_face : 0;
  }

  const std::vector<Image>& images() const { return m_surface.images(m_indexing.face(m_face)); }
  double number_of_cells() const { return static_cast<double>((m_u.size() - 1) * (m_v.size() - 1)); }

  // The middles of n parts of each cell.
  static std::vector<double> middles(const std::vector<FT>& cuts, const int n)
  {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      for (int k = 0; k < n; ++k)
        result.push_back(CGAL::to_double(cuts[i]) + CGAL::to_double(FT(cuts[i + 1] - cuts[i])) * (k + 0.5) / n);
    return result;
  }

  // The image in which a place of the grid lies deepest.
  struct Found {
    const Image* image = nullptr;
    double depth = std::numeric_limits<double>::lowest(); ///< the least barycentric coordinate
    std::array<double, 3> barycentric = {};
  };

  static std::array<double, 3> barycentric(const Image& image, const double u, const double v)
  {
    const auto &a = image.corners[0], &b = image.corners[1], &c = image.corners[2];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (!(area > 0))
      return {-1, -1, -1};
    const double y = ((u - a[0]) * (c[1] - a[1]) - (v - a[1]) * (c[0] - a[0])) / area;
    const double z = ((b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0])) / area;
    return {1 - y - z, y, z};
  }

  static void consider(const Image& image, const double u, const double v, Found& found)
  {
    const std::array<double, 3> b = barycentric(image, u, v);
    const double depth = (std::min)({b[0], b[1], b[2]});
    if (depth > found.depth)
      found = {&image, depth, b};
  }

  // Each triangle looks for the places that it covers.
  void find_triangles(const std::vector<double>& u, const std::vector<double>& v, std::vector<Found>& found) const
  {
    found.assign(u.size() * v.size(), Found());
    const auto range = [](const std::vector<double>& x, const Image& image, const int axis) {
      const auto [low, high] = std::minmax({image.corners[0][axis], image.corners[1][axis], image.corners[2][axis]});
      return std::pair<std::size_t, std::size_t>(std::lower_bound(x.begin(), x.end(), low) - x.begin(),
                                                 std::upper_bound(x.begin(), x.end(), high) - x.begin());
    };
    for (const Image& image : images()) {
      const auto [u_begin, u_end] = range(u, image, 0);
      const auto [v_begin, v_end] = range(v, image, 1);
      for (std::size_t i = u_begin; i < u_end; ++i)
        for (std::size_t j = v_begin; j < v_end; ++j)
          consider(image, u[i], v[j], found[i * v.size() + j]);
    }
    // Round-off may leave gaps.
    for (std::size_t i = 0; i < u.size(); ++i)
      for (std::size_t j = 0; j < v.size(); ++j)
        if (found[i * v.size() + j].depth < -summed_round_off)
          for (const Image& image : images())
            consider(image, u[i], v[j], found[i * v.size() + j]);
  }

  void add_grid(const int n, std::vector<Sampled_place>& samples)
  {
    const std::vector<double> u = middles(m_u, n), v = middles(m_v, n);
    find_triangles(u, v, m_found);
    for (std::size_t i = 0; i < u.size(); ++i)
      for (std::size_t j = 0; j < v.size(); ++j) {
        const Found& found = m_found[i * v.size() + j];
        if (found.image == nullptr)
          continue;
        const double cell = CGAL::to_double(FT(m_u[i / n + 1] - m_u[i / n])) *
                            CGAL::to_double(FT(m_v[j / n + 1] - m_v[j / n])) * area_of_unit(*found.image);
        const std::array<double, 2> b = inner_barycentric(found);
        samples.push_back(
            {m_face, u[i], v[j], found.image->triangle, point(found), cell / (n * n), std::sqrt(cell), b});
      }
  }

  static double area_of_image(const Image& image)
  {
    const auto &a = image.corners[0], &b = image.corners[1], &c = image.corners[2];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }

  double area_of_triangle(const Image& image) const
  {
    const auto& t = m_walk.triangles()[image.triangle];
    const auto& p = m_walk.points();
    return std::sqrt(CGAL::cross_product(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).squared_length()) / 2;
  }

  // The area on the surface of a parameter unit in a triangle. Slivers, of which the map knows little, must not count for
  // more than all that is around them.
  double area_of_unit(const Image& image) const
  {
    constexpr double most = 100;
    const double area = area_of_image(image);
    return area > 0 ? (std::min)(area_of_triangle(image) / area, most * m_mean_area_of_unit) : m_mean_area_of_unit;
  }

  Point_3 point(const Found& found) const
  {
    const auto& t = m_walk.triangles()[found.image->triangle];
    const auto& p = m_walk.points();
    const auto [y, z] = inner_barycentric(found);
    return p[t[0]] + y * (p[t[1]] - p[t[0]]) + z * (p[t[2]] - p[t[0]]);
  }

  // At the second and third corner, of a point that is not outside.
  static std::array<double, 2> inner_barycentric(const Found& found)
  {
    const double y = std::clamp(found.barycentric[1], 0., 1.);
    return {y, std::clamp(found.barycentric[2], 0., 1. - y)};
  }

  void add_edge(const Image& image, const std::size_t i, const double per_cell,
                std::vector<Sampled_place>& samples) const
  {
    const Parameters &a = image.corners[i], &b = image.corners[(i + 1) % 3];
    const std::array<double, 2> size = {m_width, m_height};
    double begin = 0, end = 1; // the part inside the face
    for (int axis = 0; axis < 2; ++axis) {
      const double d = b[axis] - a[axis];
      if (d == 0) {
        if (a[axis] < 0 || a[axis] > size[axis])
          return;
        continue;
      }
      begin = (std::max)(begin, ((d > 0 ? 0 : size[axis]) - a[axis]) / d);
      end = (std::min)(end, ((d > 0 ? size[axis] : 0) - a[axis]) / d);
    }
    if (!(begin < end))
      return;
    const double columns = static_cast<double>(m_u.size() - 1), rows = static_cast<double>(m_v.size() - 1);
    const double crossed =
        (end - begin) * (std::max)(std::abs(b[0] - a[0]) / m_width * columns, std::abs(b[1] - a[1]) / m_height * rows);
    const double cell = m_width * m_height / (columns * rows) * area_of_unit(image);
    const auto& t = m_walk.triangles()[image.triangle];
    const Point_3 &p = m_walk.points()[t[i]], &q = m_walk.points()[t[(i + 1) % 3]];
    const int n = static_cast<int>(std::lround(crossed * per_cell));
    for (int k = 0; k < n; ++k) {
      const double x = begin + (end - begin) * (k + 0.5) / n;
      samples.push_back({m_face, std::clamp(a[0] + x * (b[0] - a[0]), 0., m_width),
                         std::clamp(a[1] + x * (b[1] - a[1]), 0., m_height), image.triangle, p + x * (q - p),
                         cell / (per_cell * per_cell), std::sqrt(cell)});
    }
  }

  // The point that triangles have as a corner where a halfedge of a face ends; null if there is none.
  std::optional<std::size_t> point_at_target(const int h) const
  {
    const auto& t_mesh = m_basis.t_mesh();
    const int f = t_mesh.face(h);
    const auto place = t_mesh.target_point(h);
    const double width = CGAL::to_double(t_mesh.width(f)), height = CGAL::to_double(t_mesh.height(f)),
                 eps_u = same_point * width, eps_v = same_point * height;
    for (const Image& image : m_surface.images(m_indexing.face(f)))
      for (int i = 0; i < 3; ++i)
        if (std::abs(image.corners[i][0] - CGAL::to_double(place.first)) <= eps_u &&
            std::abs(image.corners[i][1] - CGAL::to_double(place.second)) <= eps_v && is_inside(image, width, height))
          return m_walk.triangles()[image.triangle][i];
    return std::nullopt;
  }

  // On the other side of a slit there are triangles that touch the face from outside, in its frame.
  static bool is_inside(const Image& image, const double width, const double height)
  {
    return triangle_covers_part_of_rectangle(image.corners, {width, height}, same_point);
  }

  // The places in the part of a side that an edge of the border covers.
  void add_border_edge(const Image& image, const int i, const int n, std::vector<Sampled_place>& samples) const
  {
    const Parameters &a = image.corners[i], &b = image.corners[(i + 1) % 3];
    const std::array<double, 2> size = {m_width, m_height};
    const int along = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1, across = 1 - along;
    const double eps = same_point * size[across], middle = (a[across] + b[across]) / 2;
    const bool is_first = std::abs(middle) <= eps;
    if (a[along] == b[along] || (!is_first && std::abs(middle - size[across]) > eps) ||
        !is_inside(image, m_width, m_height))
      return;
    const std::vector<FT>&cuts = along == 0 ? m_u : m_v, &cuts_across = along == 0 ? m_v : m_u;
    const std::size_t last = cuts_across.size() - 1;
    const double depth =
        CGAL::to_double(is_first ? FT(cuts_across[1] - cuts_across[0]) : FT(cuts_across[last] - cuts_across[last - 1]));
    const std::vector<double> places = middles(cuts, n);
    const auto [low, high] = std::minmax(a[along], b[along]);
    const auto& t = m_walk.triangles()[image.triangle];
    const Point_3 &p = m_walk.points()[t[i]], &q = m_walk.points()[t[(i + 1) % 3]];
    for (std::size_t k = std::lower_bound(places.begin(), places.end(), low) - places.begin();
         k < places.size() && places[k] < high; ++k) {
      const double x = (places[k] - a[along]) / (b[along] - a[along]);
      std::array<double, 3> barycentric = {};
      barycentric[i] = 1 - x;
      barycentric[(i + 1) % 3] = x;
      const std::size_t c = k / static_cast<std::size_t>(n);
      const double cell = CGAL::to_double(FT(cuts[c + 1] - cuts[c])) * depth * area_of_unit(image);
      std::array<double, 2> place = {};
      place[along] = places[k];
      place[across] = is_first ? 0 : size[across];
      samples.push_back({m_face,
                         place[0],
                         place[1],
                         image.triangle,
                         p + x * (q - p),
                         cell / (n * n),
                         std::sqrt(cell),
                         {barycentric[1], barycentric[2]},
                         i});
    }
  }

  const T_spline_basis<FT>& m_basis;
  const Mesh_indexing<Graph>& m_indexing;
  const Surface& m_surface;
  const Surface_walk& m_walk;
  Progress& m_progress;
  int m_face = 0;
  double m_width = 0, m_height = 0, m_mean_area_of_unit = 0;
  std::vector<FT> m_u, m_v; // the cuts of the cells
  std::vector<Found> m_found;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_SAMPLING_H
