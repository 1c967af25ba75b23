// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ROWS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ROWS_H

#include <CGAL/T_splines/Similarity_map/internal/Alignment_energy.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Linear_parameters.h>
#include <CGAL/T_splines/Similarity_map/internal/Open_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Open_vertices.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// An edge that is to lie on an isoline.
struct Isoline_edge {
  Triangulation_connectivity::Index halfedge; ///< of a face
  int axis;                                   ///< the coordinate that is constant in the chart of the face: 0 for u
};

/// The equations of seams and of edges on isolines, in the unknowns of a map: the coordinates of open vertices, then
/// the translations of the branches of the cut.
class Alignment_rows {
  using Index = Triangulation_connectivity::Index;
  using Row = Linear_parameters::Row;

public:
  /// \param scale per branch: of the transition that is asked for
  Alignment_rows(const Open_map& map, const std::vector<double>& scale)
    : m_mesh(map.mesh()),
      m_open(map.open()),
      m_graph(map.graph()),
      m_fits(map.fits()),
      m_scale(scale)
  {
  }

  int number_of_unknowns() const { return m_open.number_of_unknowns() + 2 * m_graph.number_of_branches(); }

  /// The unknowns of a map: its coordinates, and the translations that go best with them.
  std::vector<double> unknowns(const Uv_array& uv) const
  {
    std::vector<double> x = m_open.coordinates(uv);
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      for (int axis = 0; axis < 2; ++axis) {
        double sum = 0;
        for (int i = 0; i <= m_graph.length(b); ++i) {
          const auto [here, there] = point(b, i);
          sum += Alignment_energy::value(difference(b, axis, here, there, 1), x);
        }
        x.push_back(sum / (m_graph.length(b) + 1));
      }
    return x;
  }

  /// The points of each branch are related by its transition.
  std::vector<Row> seam_equations() const
  {
    std::vector<Row> result;
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      for (int i = 0; i <= m_graph.length(b); ++i)
        for (int axis = 0; axis < 2; ++axis) {
          const auto [here, there] = point(b, i);
          Row row = difference(b, axis, here, there, 1);
          row.emplace_back(m_open.number_of_unknowns() + 2 * b + axis, -1.);
          result.push_back(sorted(std::move(row)));
        }
    return result;
  }

  /// Translations that no equation of a seam uses are 0.
  std::vector<Row> translation_equations() const
  {
    std::vector<Row> result;
    for (int i = m_open.number_of_unknowns(); i < number_of_unknowns(); ++i)
      result.push_back({{i, 1.}});
    return result;
  }

  /// The edges of each branch are related by the linear part of its transition; lengths are measured in the map.
  /// \param length per edge, in space
  std::vector<Penalty_row> seam_penalties(const Uv_array& uv, const std::vector<double>& length) const
  {
    std::vector<Penalty_row> result;
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      for (int i = 0; i < m_graph.length(b); ++i) {
        const Index h = m_graph.halfedge(b, i), g = opposite(h);
        const double size =
            (m_scale[b] * distance(uv[h], uv[m_mesh.previous(h)]) + distance(uv[g], uv[m_mesh.previous(g)])) / 2;
        for (int axis = 0; axis < 2; ++axis) {
          const auto [here, there] = point(b, i);
          const auto [next_here, next_there] = point(b, i + 1);
          Row row = difference(b, axis, next_here, next_there, 1 / size);
          const Row other = difference(b, axis, here, there, -1 / size);
          row.insert(row.end(), other.begin(), other.end());
          result.push_back({sorted(std::move(row)), length[edge_of(h)]});
        }
      }
    return normalized(std::move(result));
  }

  /// Both ends of an edge have one coordinate.
  std::vector<Row> isoline_equations(const std::vector<Isoline_edge>& edges) const
  {
    std::vector<Row> result;
    for (const Isoline_edge& edge : edges)
      result.push_back(isoline_row(edge, 1));
    return result;
  }

  /// The same. \param length per edge, in space
  std::vector<Penalty_row> isoline_penalties(const std::vector<Isoline_edge>& edges, const Uv_array& uv,
                                             const std::vector<double>& length) const
  {
    std::vector<Penalty_row> result;
    for (const Isoline_edge& edge : edges) {
      const Index h = edge.halfedge;
      result.push_back({isoline_row(edge, 1 / distance(uv[h], uv[m_mesh.previous(h)])), length[edge_of(h)]});
    }
    return normalized(std::move(result));
  }

  /// The largest of the lengths to which rows are off.
  static double largest_residual(const std::vector<Penalty_row>& rows, const std::vector<double>& x)
  {
    double result = 0;
    for (const Penalty_row& row : rows)
      result = (std::max)(result, std::abs(Alignment_energy::value(row.row, x)));
    return result;
  }

  /// The angle of an edge to its isoline, in radians.
  double misalignment(const Isoline_edge& edge, const std::vector<double>& x) const
  {
    const int p = 2 * m_open[edge.halfedge], q = 2 * m_open[m_mesh.previous(edge.halfedge)];
    return std::atan2(std::abs(x[p + edge.axis] - x[q + edge.axis]),
                      std::abs(x[p + 1 - edge.axis] - x[q + 1 - edge.axis]));
  }

private:
  // The open vertices of the i-th point of a branch: on the side of its halfedges, and on the other one.
  std::array<int, 2> point(const int b, const int i) const
  {
    if (i == 0) {
      const Index h = m_graph.halfedge(b, 0);
      return {{m_open[m_mesh.previous(h)], m_open[opposite(h)]}};
    }
    const Index h = m_graph.halfedge(b, i - 1);
    return {{m_open[h], m_open[m_mesh.previous(opposite(h))]}};
  }

  // The coordinate there less that of the image of the point here under the linear part.
  Row difference(const int b, const int axis, const int here, const int there, const double factor) const
  {
    const Plane_vector<double> u = Plane_vector<double>{1, 0}.turned(m_fits[b].quarter_turns()) * m_scale[b];
    const std::array<double, 2> image =
        axis == 0 ? std::array<double, 2>{{u.u, -u.v}} : std::array<double, 2>{{u.v, u.u}};
    return {{2 * there + axis, factor}, {2 * here, -factor * image[0]}, {2 * here + 1, -factor * image[1]}};
  }

  Row isoline_row(const Isoline_edge& edge, const double factor) const
  {
    return sorted({{2 * m_open[edge.halfedge] + edge.axis, factor},
                   {2 * m_open[m_mesh.previous(edge.halfedge)] + edge.axis, -factor}});
  }

  // By unknowns, each once, none with the coefficient 0.
  static Row sorted(const Row& row)
  {
    Row sum = row, result;
    std::sort(sum.begin(), sum.end());
    for (const auto& [unknown, coefficient] : sum) {
      if (!result.empty() && result.back().first == unknown)
        result.back().second += coefficient;
      else
        result.emplace_back(unknown, coefficient);
    }
    result.erase(std::remove_if(result.begin(), result.end(), [](const auto& entry) { return entry.second == 0; }),
                 result.end());
    return result;
  }

  static std::vector<Penalty_row> normalized(std::vector<Penalty_row> rows)
  {
    double sum = 0;
    for (const Penalty_row& row : rows)
      sum += row.weight;
    for (Penalty_row& row : rows)
      row.weight /= sum;
    return rows;
  }

  const Triangulation_connectivity& m_mesh;
  const Open_vertices& m_open;
  const Cut_graph& m_graph;
  const std::vector<Branch_fit>& m_fits;
  const std::vector<double>& m_scale;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ROWS_H
