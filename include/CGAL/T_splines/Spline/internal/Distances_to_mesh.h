// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_MESH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_MESH_H

#include <CGAL/T_splines/Spline/internal/Bezier_part.h>
#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Largest_distance.h>
#include <CGAL/T_splines/Spline/internal/Measured_mesh.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A point of a surface and what is closest to it on a mesh.
struct Surface_sample {
  std::size_t patch = 0;
  double s = 0, t = 0;
  Triangle_set::Point_3 point;
  Triangle_set::Kernel::Vector_3 normal; ///< of the surface, as long as the area of the parameters' unit square
  Triangle_tree::Foot foot;
  double distance_beyond = 0; ///< see `Measured_mesh`

  /// Whether the closest point is on what is data.
  bool is_measured() const { return !(distance_beyond > 0); }
};

/// The point (s, t) of a patch, with what is closest on a mesh. \param hint a triangle near by
template <typename Measured>
Surface_sample surface_sample(const Measured& surface, const Measured_mesh& mesh, const std::size_t patch,
                              const double s, const double t, const std::size_t hint)
{
  const auto h = surface.patch(patch).template homogeneous_jet<1>(s, t);
  const double r = 1 / h[0][3], x = h[0][0] * r, y = h[0][1] * r, z = h[0][2] * r;
  const auto derivative = [&](const std::array<double, 4>& d) {
    return Triangle_set::Kernel::Vector_3((d[0] - d[3] * x) * r, (d[1] - d[3] * y) * r, (d[2] - d[3] * z) * r);
  };
  Surface_sample sample;
  sample.patch = patch;
  sample.s = s;
  sample.t = t;
  sample.point = Triangle_set::Point_3(x, y, z);
  sample.normal = CGAL::cross_product(derivative(h[1]), derivative(h[2]));
  sample.foot = mesh.tree.foot(sample.point, hint);
  sample.distance_beyond = mesh.distance_beyond(sample.point, sample.foot);
  return sample;
}

/// Measures the distances of a surface from a mesh.
///
/// Every Bezier patch is divided into a grid of cells, at least 3 x 3 of them, in caps graded towards the extraordinary
/// vertex; distances are measured in their middles. Then the cells whose bounds exceed the largest distance are halved.
/// There are two bounds. (1) Distances change by no more than the point moves. (2) The distance from a triangle is a
/// convex function: it is largest at one of the control points of the cell. Points whose closest point is on what closes a
/// hole have no distance.
/// \tparam Measured a `Measured_surface`
template <typename Measured>
class Distances_to_mesh {
public:
  using Point_3 = Triangle_set::Point_3;
  using Patch = typename Measured::Patch;

  /// \param negligible distances that need not be told apart
  /// \param smallest_size cells need not be smaller for means
  /// \param progress it must outlive this; if it is interrupted, what was measured means nothing
  Distances_to_mesh(const Measured& surface, const Measured_mesh& mesh, const double negligible,
                    const double smallest_size, Progress& progress)
    : m_surface(surface),
      m_mesh(mesh),
      m_smallest_size(smallest_size),
      m_progress(progress),
      m_largest(negligible)
  {
  }

  /// Calls `visit(sample, distance)` for all samples, also for those that are not measured.
  /// \param number_of_cells how many there are, about; more if patches are narrow
  template <typename Visit>
  void measure(const double number_of_cells, Distance_sum& sum, const Visit& visit)
  {
    double area = 0;
    for (std::size_t i = 0; i < m_surface.number_of_patches(); ++i)
      area += m_surface.size(i)[0] * m_surface.size(i)[1];
    const double size =
        (std::max)({std::sqrt(area / number_of_cells), m_smallest_size, (std::numeric_limits<double>::min)()});
    const std::size_t n = m_surface.number_of_patches();
    for (std::size_t i = 0; i < n && !m_progress.is_interrupted(); ++i) {
      m_progress.progress(static_cast<double>(i) / static_cast<double>(n));
      measure_patch(i, size, sum, visit);
    }
  }

  /// Looks for the largest distance. \param number_of_steps the most cells that are halved
  template <typename Visit>
  void search(std::size_t number_of_steps, const Visit& visit)
  {
    for (Cell& cell : m_cells)
      m_largest.add(std::move(cell));
    m_cells.clear();
    while (number_of_steps > 0 && m_largest.has_open_part() && m_progress.go_on_after(20)) {
      Cell cell = m_largest.take();
      if (!cell.has_hull_bound) {
        cell.has_hull_bound = true;
        cell.bound = (std::min)(cell.bound, hull_bound(cell));
        m_largest.add(std::move(cell));
        continue;
      }
      const int axis = longer_axis(cell);
      constexpr double smallest_part = 1e-9; // near round-off
      if ((axis == 0 ? cell.rectangle.width() : cell.rectangle.height()) < smallest_part) {
        m_largest.leave_out(cell.bound);
        continue;
      }
      for (const Patch_rectangle& half : cell.rectangle.bisected(axis)) {
        Cell part = measured(cell.patch, half, cell.triangle, visit);
        part.bound = (std::min)(part.bound, cell.bound);
        m_largest.add(std::move(part));
      }
      --number_of_steps;
    }
  }

  double upper_bound() const { return m_largest.upper_bound(); }
  const Surface_sample& farthest() const { return m_farthest; }

private:
  struct Cell {
    std::size_t patch = 0, triangle = 0; ///< that of the closest point
    Patch_rectangle rectangle;
    double bound = 0;
    bool has_hull_bound = false;
  };

  template <typename Visit>
  void measure_patch(const std::size_t i, const double size, Distance_sum& sum, const Visit& visit)
  {
    constexpr double smallest_number = 3, largest_number = 1000;
    const auto parts = [&](const int axis, const double share) {
      return static_cast<int>(
          std::clamp(std::round(share * m_surface.size(i)[axis] / size), smallest_number, largest_number));
    };
    const int corner = m_surface.domain(i).cap_corner;
    if (corner < 0) {
      measure_grid(i, {}, parts(0, 1), parts(1, 1), sum, visit);
      return;
    }
    // Three quarters of a square, and so on in the last one.
    constexpr int number_of_halvings = 6;
    double begin[2] = {0, 0}, width = 1;
    for (int level = 0; level < number_of_halvings; ++level) {
      width /= 2;
      for (int quarter = 0; quarter < 4; ++quarter)
        if (quarter != corner || level + 1 == number_of_halvings) {
          const double s = begin[0] + (quarter % 2) * width, t = begin[1] + (quarter / 2) * width;
          measure_grid(i, {s, s + width, t, t + width}, parts(0, width), parts(1, width), sum, visit);
        }
      begin[0] += (corner % 2) * width;
      begin[1] += (corner / 2) * width;
    }
  }

  template <typename Visit>
  void measure_grid(const std::size_t patch, const Patch_rectangle& r, const int columns, const int rows,
                    Distance_sum& sum, const Visit& visit)
  {
    const double width = r.width() / columns, height = r.height() / rows;
    for (int j = 0; j < rows && m_progress.go_on_after(20 * static_cast<std::size_t>(columns)); ++j)
      for (int column = 0; column < columns; ++column) {
        const int i = j % 2 == 0 ? column : columns - 1 - column; // the next one is a neighbour
        Cell cell = measured(
            patch,
            {r.s_begin + i * width, r.s_begin + (i + 1) * width, r.t_begin + j * height, r.t_begin + (j + 1) * height},
            m_sample.foot.triangle, visit);
        if (m_sample.is_measured())
          sum.add(std::sqrt(m_sample.normal.squared_length()) * width * height, m_sample.foot.distance());
        if (m_largest.is_open(cell.bound))
          m_cells.push_back(cell);
        else
          m_largest.leave_out(cell.bound);
      }
  }

  // Measures in the middle of a rectangle; `m_sample` is the sample.
  template <typename Visit>
  Cell measured(const std::size_t patch, const Patch_rectangle& rectangle, const std::size_t triangle,
                const Visit& visit)
  {
    m_sample = surface_sample(m_surface, m_mesh, patch, rectangle.middle_s(), rectangle.middle_t(), triangle);
    const double distance = m_sample.foot.distance(), radius = m_surface.bounds(patch).radius(rectangle);
    if (m_sample.is_measured() && m_largest.offer(distance))
      m_farthest = m_sample;
    visit(m_sample, distance);
    // On the way to any other point of the cell, one distance grows and the other one shrinks by no more than the radius.
    const bool is_measured = !(m_sample.distance_beyond > 2 * radius);
    return {patch, m_sample.foot.triangle, rectangle, is_measured ? distance + radius : 0, false};
  }

  int longer_axis(const Cell& cell) const
  {
    const std::array<double, 2>& size = m_surface.size(cell.patch);
    return size[0] * cell.rectangle.width() >= size[1] * cell.rectangle.height() ? 0 : 1;
  }

  double hull_bound(const Cell& cell) const
  {
    const Patch part = restricted(m_surface.patch(cell.patch), cell.rectangle);
    double largest = 0;
    for (const auto& h : part.homogeneous_control_points()) {
      if (!(h[3] > 0))
        return cell.bound;
      const Point_3 p(h[0] / h[3], h[1] / h[3], h[2] / h[3]);
      largest = (std::max)(
          largest, CGAL::squared_distance(p, closest_of_triangle(p, m_mesh.tree.triangle(cell.triangle)).point));
    }
    return std::sqrt(largest);
  }

  const Measured& m_surface;
  const Measured_mesh& m_mesh;
  double m_smallest_size;
  Progress& m_progress;
  Surface_sample m_sample, m_farthest;
  std::vector<Cell> m_cells; // those of the first grid that are open
  Largest_distance<Cell> m_largest;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_MESH_H
