// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_FUNCTIONS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_FUNCTIONS_H

#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes jets of functions w_i B_i those of the rational functions w_i B_i / sum of w_j B_j. `Order` is 0, 1 or 2.
template <int Order, typename FT>
void divide_by_sum(std::vector<Function_jet<FT>>& jets)
{
  constexpr int n = number_of_derivatives_up_to(Order);
  Function_jet<FT> sum{};
  for (const Function_jet<FT>& jet : jets)
    for (int k = 0; k < n; ++k)
      sum[k] += jet[k];
  for (Function_jet<FT>& jet : jets) {
    jet[0] /= sum[0];
    if constexpr (Order > 0) {
      jet[1] = (jet[1] - jet[0] * sum[1]) / sum[0];
      jet[2] = (jet[2] - jet[0] * sum[2]) / sum[0];
    }
    if constexpr (Order > 1) {
      jet[3] = (jet[3] - FT(2) * jet[1] * sum[1] - jet[0] * sum[3]) / sum[0];
      jet[4] = (jet[4] - jet[1] * sum[2] - jet[2] * sum[1] - jet[0] * sum[4]) / sum[0];
      jet[5] = (jet[5] - FT(2) * jet[2] * sum[2] - jet[0] * sum[5]) / sum[0];
    }
  }
}

/// The rational basis functions of a T-spline surface in one face after the other: of which vertices they are, and
/// their values. With them, the surface is a linear function of the euclidean control points.
template <typename FT>
class Face_functions {
  using Basis = T_spline_basis<FT>;

public:
  /// \param weights of the vertices
  Face_functions(const Basis& basis, const std::vector<FT>& weights)
    : m_basis(basis),
      m_weights(weights),
      m_position(weights.size(), Basis::none)
  {
  }

  /// Goes to a face.
  void enter(const int face)
  {
    for (const int v : m_vertices)
      m_position[v] = Basis::none;
    m_vertices.clear();
    m_face = face;
    m_basis.for_each_vertex(face, [this](const int v) { m_vertices.push_back(v); });
    // A basis function may act several times.
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_position[m_vertices[i]] = static_cast<int>(i);
  }

  int face() const { return m_face; }

  /// The vertices whose functions act in the face, increasing.
  const std::vector<int>& vertices() const { return m_vertices; }

  /// Evaluates at (u, v) of the face, with derivatives up to `Order` with respect to u and v.
  template <int Order>
  const std::vector<Function_jet<FT>>& evaluate(const FT& u, const FT& v)
  {
    m_jets.assign(m_vertices.size(), Function_jet<FT>{});
    const int c = m_basis.cone_face_of(m_face);
    if (c < 0)
      m_basis.template for_each_function<Order>(
          m_face, u, v, [&](const int vertex, const Function_jet<FT>& jet) { add<Order>(vertex, jet); });
    else {
      const typename Basis::Cone_face& cone_face = m_basis.cone_faces()[c];
      const std::pair<FT, FT> p = cone_face.to_unit_square(u, v);
      cone_face.evaluator->basis((std::clamp)(p.first, FT(0), FT(1)), (std::clamp)(p.second, FT(0), FT(1)), Order,
                                 m_cone_jets);
      for (std::size_t i = 0; i < m_cone_jets.size(); ++i) {
        pull_back(cone_face.to_unit_square, Order, m_cone_jets[i]);
        add<Order>(cone_face.controls[i], m_cone_jets[i]);
      }
    }
    divide_by_sum<Order>(m_jets);
    return m_jets;
  }

  /// The same of jets of the functions of a cone face with respect to any coordinates, in the order of its controls.
  const std::vector<Function_jet<FT>>& rational_jets(const std::vector<int>& controls,
                                                     const std::vector<Function_jet<FT>>& jets)
  {
    m_jets.assign(m_vertices.size(), Function_jet<FT>{});
    for (std::size_t i = 0; i < jets.size(); ++i)
      add<2>(controls[i], jets[i]);
    divide_by_sum<2>(m_jets);
    return m_jets;
  }

private:
  template <int Order>
  void add(const int vertex, const Function_jet<FT>& jet)
  {
    Function_jet<FT>& sum = m_jets[m_position[vertex]];
    for (int k = 0; k < number_of_derivatives_up_to(Order); ++k)
      sum[k] += m_weights[vertex] * jet[k];
  }

  const Basis& m_basis;
  const std::vector<FT>& m_weights;
  std::vector<int> m_position; // per vertex: in m_vertices
  std::vector<int> m_vertices;
  int m_face = Basis::none;
  std::vector<Function_jet<FT>> m_jets, m_cone_jets;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_FUNCTIONS_H
