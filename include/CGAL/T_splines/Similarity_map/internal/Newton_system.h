// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_SYSTEM_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_SYSTEM_H

#include <CGAL/T_splines/Similarity_map/internal/Metric_input.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The gradient and the Hessian of the convex energy whose minimum is the metric with the prescribed signature.
///
/// The unknowns are phi at the vertices and one coefficient c per loop (see `Similarity_structure`). The gradient is
/// the prescribed minus the present angle at each vertex, and the present minus the prescribed turning of each loop;
/// the Hessian is [d eta]^T * [d eta] with the cotangent Hodge star ([CZ17] eq. (6), (7) in a symmetric form). On each
/// connected component, phi is determined up to a constant: one vertex is left out of the rows.
///
/// On a double, the metric is symmetric, P x with one unknown x for an element and its image: the Hessian is P^T H P, and
/// the gradient P^T g. The g of an element stands for that of its image, from which it differs by round-off: so it is
/// met as exactly as on a closed surface by what is on the first sheet, and `residual()` is the largest there.
template <typename FT_>
class Newton_system {
public:
  using FT = FT_;
  using Index = Triangulation_connectivity::Index;
  using Structure = Similarity_structure<FT>;

  explicit Newton_system(const Metric_input& input)
    : m_component(input.component_of_vertex),
      m_row(input.quarter_turns.size(), pinned),
      m_sign(input.quarter_turns.size(), 1),
      m_multiplicity(input.quarter_turns.size(), 1),
      m_target(input.quarter_turns.size())
  {
    using std::atan2;
    const FT quarter = 2 * atan2(FT(1), FT(1));
    for (std::size_t i = 0; i < m_target.size(); ++i)
      m_target[i] = input.quarter_turns[i] * quarter;
    std::vector<char> has_pin;
    for (std::size_t v = 0; v < m_component.size(); ++v) {
      const std::size_t component = m_component[v];
      if (component >= has_pin.size())
        has_pin.resize(component + 1, 0);
      add_unknown(v, input.original_vertex[v], 1, has_pin[component] != 0);
      has_pin[component] = 1;
    }
    m_number_of_components = has_pin.size();
    for (std::size_t j = 0; j < input.loops.size(); ++j) {
      const Folded_loop loop = input.folding.empty() ? Folded_loop{static_cast<int>(j), 1} : input.folding[j];
      add_unknown(m_component.size() + j, m_component.size() + loop.original, loop.sign, true);
    }
    m_gradient = m_target;
  }

  /// evaluates angles and gradient. \return `false` if some triangle violates the triangle inequality, or `progress` is
  /// interrupted.
  bool evaluate(const Structure& structure, Progress& progress)
  {
    if (!measure(structure, progress))
      return false;
    evaluate_gradient(structure);
    return has_triangles_only();
  }

  /// evaluates the angles of all triangles, once for two that are images of each other. \return `false` if `progress` is interrupted.
  bool measure(const Structure& structure, Progress& progress)
  {
    m_angle.resize(structure.mesh.number_of_halfedges());
    m_cotangent.resize(structure.mesh.number_of_halfedges());
    m_is_triangle.resize(structure.mesh.number_of_faces());
    for (Index f = 0; f < structure.mesh.number_of_faces(); ++f) {
      if (structure.pairs.is_image(f))
        continue;
      if (!progress.go_on_after(work_per_triangle))
        return false;
      measure(structure, f);
    }
    return true;
  }

  /// evaluates the angles of the triangle `f` anew, and those of its image. \pre `f` is no image itself
  void measure(const Structure& structure, const Index f)
  {
    Index h = structure.mesh.halfedge_of_face(f);
    const Triangle_angles<FT> angles(structure.triangle_log_lengths(h));
    m_is_triangle[f] = angles.is_triangle;
    for (int i = 0; i < 3; ++i, h = structure.mesh.next(h)) {
      m_angle[h] = angles.angle[i];
      m_cotangent[h] = angles.cotangent[i];
    }
    if (structure.pairs.has_image(f)) {
      m_is_triangle[structure.pairs.image_of_face(f)] = m_is_triangle[f];
      for (int i = 0; i < 3; ++i, h = structure.mesh.next(h)) {
        const Index image = structure.pairs.image(h);
        m_angle[image] = m_angle[h];
        m_cotangent[image] = m_cotangent[h];
      }
    }
  }

  /// Whether all faces satisfied the triangle inequality when they were measured.
  bool has_triangles_only() const
  {
    return std::find(m_is_triangle.begin(), m_is_triangle.end(), 0) == m_is_triangle.end();
  }

  /// Whether the measured angles tell that an edge is Delaunay, with some margin; `false` may be a false alarm.
  bool is_clearly_delaunay(const Structure& structure, const Index e) const
  {
    constexpr double margin = 1e-10; // above the round-off of a cotangent
    const auto [h, g] = halfedges_of_edge(e);
    const double first = m_cotangent[h], second = m_cotangent[g];
    return m_is_triangle[structure.mesh.face(h)] && m_is_triangle[structure.mesh.face(g)] &&
           first + second > margin * (1 + std::abs(first));
  }

  /// evaluates the gradient from the measured angles.
  void evaluate_gradient(const Structure& structure)
  {
    const Triangulation_connectivity& mesh = structure.mesh;
    m_gradient = m_target;
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      m_gradient[mesh.target(mesh.next(h))] -= m_angle[h];
    for (int loop = 0; loop < structure.loops.number_of_loops(); ++loop) {
      FT& gradient = m_gradient[m_component.size() + loop];
      gradient = -gradient;
      structure.loops.for_each_corner(mesh, loop, [&](const Index h, const bool turns_left) {
        if (turns_left)
          gradient += m_angle[mesh.next(h)];
        else
          gradient -= m_angle[mesh.previous(h)];
      });
    }
    m_worst = 0; // a vertex of the first sheet
    for (std::size_t i = 0; i < m_gradient.size(); ++i)
      if (m_multiplicity[i] != 0 && !(absolute(m_gradient[i]) <= absolute(m_gradient[m_worst])))
        m_worst = i;
  }

  /// Prescribed minus present angle per vertex, then present minus prescribed turning per loop, of the last evaluation.
  const std::vector<FT>& gradient() const { return m_gradient; }

  /// The unknown at which the gradient is largest, and its absolute value there; of a double, on the first sheet.
  std::size_t worst() const { return m_worst; }
  FT residual() const { return absolute(m_gradient[m_worst]); }

  /// The angle opposite to each halfedge.
  const std::vector<FT>& angles() const { return m_angle; }

  double gradient_norm() const
  {
    double sum = 0;
    for (const FT& g : m_gradient)
      sum += static_cast<double>(g) * static_cast<double>(g);
    return std::sqrt(sum);
  }

  int number_of_rows() const { return m_number_of_rows; }

  /// The Newton system's right-hand side, the negative gradient. On each component its vertex part is projected to sum
  /// zero: round-off would otherwise collect at the vertex that has no row.
  std::vector<double> right_hand_side() const
  {
    std::vector<FT> sum(m_number_of_components, FT(0));
    std::vector<int> count(m_number_of_components, 0);
    for (std::size_t v = 0; v < m_component.size(); ++v) {
      sum[m_component[v]] += m_multiplicity[v] * m_gradient[v];
      count[m_component[v]] += m_multiplicity[v];
    }
    for (std::size_t c = 0; c < m_number_of_components; ++c)
      sum[c] /= count[c];
    std::vector<double> result(m_number_of_rows);
    for (std::size_t i = 0; i < m_row.size(); ++i)
      if (m_row[i] != pinned && m_multiplicity[i] != 0)
        result[m_row[i]] =
            m_multiplicity[i] *
            static_cast<double>(i < m_component.size() ? FT(sum[m_component[i]] - m_gradient[i]) : FT(-m_gradient[i]));
    return result;
  }

  /// The solution of the system per unknown: 0 where there is no row.
  std::vector<double> direction(const std::vector<double>& solution) const
  {
    std::vector<double> result(m_row.size(), 0.);
    for (std::size_t i = 0; i < m_row.size(); ++i)
      if (m_row[i] != pinned)
        result[i] = m_sign[i] * solution[m_row[i]];
    return result;
  }

  /// takes the Hessian at the last evaluation, for `multiply()` and `matrix()`.
  void set_hessian(const Structure& structure)
  {
    const Triangulation_connectivity& mesh = structure.mesh;
    m_terms.clear();
    m_loop_terms.clear();
    for (Index e = 0; e < mesh.number_of_edges(); ++e) {
      const auto [h, g] = halfedges_of_edge(e);
      if (structure.pairs.is_image_edge(mesh, e))
        continue;
      // Not negative on a Delaunay triangulation; on others, negative weights belong to the Hessian, which is
      // semidefinite all the same.
      const double cotangents = (m_cotangent[h] + m_cotangent[g]) / 2;
      const double weight = std::abs(cotangents) < least_weight ? least_weight : cotangents;
      const int multiplicity = structure.pairs.has_image_edge(mesh, e) ? 2 : 1;
      Edge_term term{multiplicity * weight, m_row[mesh.source(h)], m_row[mesh.target(h)],
                     static_cast<int>(m_loop_terms.size()), 0};
      if (structure.loops.has_passages(e))
        add_loop_terms(structure, e);
      term.loops_end = static_cast<int>(m_loop_terms.size());
      if (term.source != term.target || term.loops_begin != term.loops_end)
        m_terms.push_back(term);
    }
  }

  /// computes y = Hessian x, by rows.
  void multiply(const std::vector<double>& x, std::vector<double>& y) const
  {
    y.assign(m_number_of_rows, 0.);
    for (const Edge_term& term : m_terms) {
      double flow = 0;
      if (term.target != pinned)
        flow += x[term.target];
      if (term.source != pinned)
        flow -= x[term.source];
      for (int i = term.loops_begin; i < term.loops_end; ++i)
        flow += m_loop_terms[i].second * x[m_loop_terms[i].first];
      flow *= term.weight;
      if (term.target != pinned)
        y[term.target] += flow;
      if (term.source != pinned)
        y[term.source] -= flow;
      for (int i = term.loops_begin; i < term.loops_end; ++i)
        y[m_loop_terms[i].first] += m_loop_terms[i].second * flow;
    }
  }

  /// The Hessian as a matrix, by rows.
  Symmetric_sparse_matrix<double> matrix() const
  {
    std::vector<std::pair<int, double>> row; // the entries of one row of [d eta]
    std::vector<std::array<int, 2>> position;
    std::vector<double> value;
    position.reserve(3 * m_terms.size());
    value.reserve(3 * m_terms.size());
    for (const Edge_term& term : m_terms) {
      row.clear();
      if (term.source != term.target) {
        if (term.target != pinned)
          row.emplace_back(term.target, 1.);
        if (term.source != pinned)
          row.emplace_back(term.source, -1.);
      }
      row.insert(row.end(), m_loop_terms.begin() + term.loops_begin, m_loop_terms.begin() + term.loops_end);
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
          position.push_back({std::min(row[i].first, row[j].first), std::max(row[i].first, row[j].first)});
          value.push_back(term.weight * row[i].second * row[j].second);
        }
    }
    return compress(position, value);
  }

private:
  static constexpr std::size_t work_per_triangle = 10 * work_of_function<FT>;
  static constexpr int pinned = -1;
  static constexpr double least_weight = 1e-14; // weights of 0 would make the matrix singular

  struct Edge_term {
    double weight;
    int source, target;         // rows
    int loops_begin, loops_end; // in m_loop_terms
  };

  // Gives unknown i its row, or none if it is pinned or vanishes.
  void add_unknown(const std::size_t i, const std::size_t original, const int sign, const bool has_row)
  {
    m_sign[i] = sign;
    if (original != i) {
      m_row[i] = m_row[original];
      m_multiplicity[i] = 0;
      m_multiplicity[original] = 2;
    }
    else if (sign == 0)
      m_multiplicity[i] = 0;
    else if (has_row)
      m_row[i] = m_number_of_rows++;
  }

  static FT absolute(const FT& x) { return x < 0 ? FT(-x) : x; }

  // Adds up the passages of each loop over edge e.
  void add_loop_terms(const Structure& structure, const Index e)
  {
    const std::size_t begin = m_loop_terms.size();
    structure.loops.for_each_passage(e, [&](const int loop, const int sign) {
      const int row = m_row[m_component.size() + loop], value = sign * m_sign[m_component.size() + loop];
      if (row == pinned)
        return;
      const auto same = std::find_if(m_loop_terms.begin() + static_cast<std::ptrdiff_t>(begin), m_loop_terms.end(),
                                     [row](const std::pair<int, double>& term) { return term.first == row; });
      if (same == m_loop_terms.end())
        m_loop_terms.emplace_back(row, value);
      else
        same->second += value;
    });
    m_loop_terms.erase(std::remove_if(m_loop_terms.begin() + static_cast<std::ptrdiff_t>(begin), m_loop_terms.end(),
                                      [](const std::pair<int, double>& term) { return term.second == 0; }),
                       m_loop_terms.end());
  }

  // Sorts entries (column, row) into compressed columns and adds up those at the same place.
  Symmetric_sparse_matrix<double> compress(const std::vector<std::array<int, 2>>& position,
                                           const std::vector<double>& value) const
  {
    std::vector<int> begin(m_number_of_rows + 1, 0);
    for (const std::array<int, 2>& p : position)
      ++begin[p[0] + 1];
    for (int j = 0; j < m_number_of_rows; ++j)
      begin[j + 1] += begin[j];
    std::vector<std::pair<int, double>> entries(position.size());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < position.size(); ++i)
      entries[end[position[i][0]]++] = {position[i][1], value[i]};
    Symmetric_sparse_matrix<double> result;
    result.column_begin.reserve(m_number_of_rows + 1);
    result.row.reserve(entries.size() / 2);
    result.value.reserve(entries.size() / 2);
    for (int j = 0; j < m_number_of_rows; ++j) {
      std::sort(entries.begin() + begin[j], entries.begin() + begin[j + 1],
                [](const std::pair<int, double>& a, const std::pair<int, double>& b) { return a.first < b.first; });
      for (int i = begin[j]; i < begin[j + 1]; ++i) {
        if (i > begin[j] && entries[i].first == result.row.back())
          result.value.back() += entries[i].second;
        else {
          result.row.push_back(entries[i].first);
          result.value.push_back(entries[i].second);
        }
      }
      result.column_begin.push_back(static_cast<int>(result.row.size()));
    }
    return result;
  }

  std::vector<int> m_component;    // per vertex
  std::vector<int> m_row;          // per unknown: that of an image is the row of its original
  std::vector<int> m_sign;         // per unknown: what it is times the value of its row
  std::vector<int> m_multiplicity; // per unknown: 2 if it has an image, 0 if it is one or vanishes
  std::vector<FT> m_target;        // per unknown
  int m_number_of_rows = 0;
  std::size_t m_number_of_components = 0;

  std::vector<FT> m_angle; // per halfedge, opposite to it
  std::vector<double> m_cotangent;
  std::vector<char> m_is_triangle; // per face
  std::vector<FT> m_gradient;
  std::size_t m_worst = 0;

  std::vector<Edge_term> m_terms;
  std::vector<std::pair<int, double>> m_loop_terms;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_SYSTEM_H
