// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_BASIS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_BASIS_H

#include <CGAL/T_splines/Spline/internal/Catmull_clark_evaluator.h>
#include <CGAL/T_splines/Spline/internal/Corner_patches.h>
#include <CGAL/T_splines/Spline/internal/Cubic_b_spline.h>
#include <CGAL/T_splines/T_mesh/support/Spline_structure.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A scalar function with its derivatives: the value, d/du, d/dv, d2/du2, d2/dudv, d2/dv2.
template <typename FT>
using Function_jet = std::array<FT, 6>;

constexpr int number_of_derivatives_up_to(const int order)
{
  return order == 0 ? 1 : order == 1 ? 3 : 6;
}

/// Takes derivatives with respect to the target of a similarity to those with respect to its source.
template <typename FT>
void pull_back(const Similarity_2<FT>& similarity, const int order, Function_jet<FT>& jet)
{
  const FT s = similarity.scale();
  if (order > 0) {
    const FT x = s * jet[1], y = s * jet[2];
    switch (similarity.quarter_turns()) {
    case 0: jet[1] = x, jet[2] = y; break;
    case 1: jet[1] = y, jet[2] = -x; break;
    case 2: jet[1] = -x, jet[2] = -y; break;
    default: jet[1] = -y, jet[2] = x;
    }
  }
  if (order > 1) {
    const FT xx = s * s * jet[3], xy = s * s * jet[4], yy = s * s * jet[5];
    const bool is_odd = similarity.quarter_turns() % 2 == 1;
    jet[3] = is_odd ? yy : xx;
    jet[4] = is_odd ? FT(-xy) : xy;
    jet[5] = is_odd ? xx : yy;
  }
}

/// The basis functions of a spline compatible T-mesh, by faces: which act there, and how ([CZ17] section 4).
///
/// It knows nothing of control points; one basis serves any number of surfaces.
/// \tparam FT the number type of the surface
template <typename FT_>
class T_spline_basis {
public:
  using FT = FT_;
  using Arrays = T_mesh_arrays<FT>;
  using Evaluator = Catmull_clark_evaluator<FT>;
  static constexpr int none = -1;

  /// A product of two cubic B-splines that acts in a face for a vertex, and the similarity from the frame of the face to
  /// its own: a piece of its support. One may act in a face several times, on different ways around the surface.
  struct Action {
    int vertex, function;
    Similarity_2<FT> to_vertex;
  };

  /// A face at an extraordinary vertex inside, where the surface is the Catmull-Clark limit of the controls.
  struct Cone_face {
    int face;
    Similarity_2<FT> to_unit_square; ///< the extraordinary vertex becomes the origin
    std::vector<int> controls;       ///< as `Catmull_clark_subdivision` orders them
    std::shared_ptr<const Evaluator> evaluator;
  };

  /// A face at a corner of the border that turns inwards, where the functions are those of `Corner_patches`.
  struct Corner_face {
    int sector;
    Similarity_2<FT> to_unit_square; ///< the corner becomes the origin
    std::vector<int> controls;       ///< as `Corner_patches` orders them
    std::shared_ptr<const Corner_patches<FT>> patches;
  };

  T_spline_basis() = default;

  /// Finds the basis. \return the first defect; then the basis is not to be used
  template <typename KnotFT>
  Spline_defect build(Spline_structure<KnotFT, FT>& structure)
  {
    m_arrays = structure.arrays();
    std::vector<std::pair<int, Action>> actions;
    const Spline_defect defect = structure.find_supports([&](const int v, const Basis_support<FT>& support) {
      for (const Support_face<FT>& face : support.faces())
        if (structure.corner_of_face(face.face) == none)
          actions.emplace_back(face.face, Action{v, v, face.to_vertex});
    });
    if (defect)
      return defect;
    m_functions.resize(m_arrays.number_of_vertices());
    for (int v = 0; v < m_arrays.number_of_vertices(); ++v)
      if (!structure.is_isolated(v))
        for (int axis = 0; axis < 2; ++axis)
          m_functions[v][axis] = Cubic_b_spline<FT>(structure.knots(v).knots[axis]);
    add_natural_ends(structure, actions);
    sort_by_faces(actions);
    add_faces_at_extraordinary_vertices(structure);
    return {};
  }

  const Arrays& t_mesh() const { return m_arrays; }
  const std::vector<Cone_face>& cone_faces() const { return m_cone_faces; }
  int cone_face_of(const int f) const { return m_cone_face_of_face[f]; } ///< an index of `cone_faces()`, or `none`

  /// `nullptr` if the face is none.
  const Corner_face* corner_face(const int f) const
  {
    return m_corner_face_of_face[f] == none ? nullptr : &m_corner_faces[m_corner_face_of_face[f]];
  }

  /// None in faces at extraordinary vertices.
  const Action* actions_begin(const int f) const { return m_actions.data() + m_first_action[f]; }
  const Action* actions_end(const int f) const { return m_actions.data() + m_first_action[f + 1]; }

  /// The two factors of a function of an action, in its frame.
  const std::array<Cubic_b_spline<FT>, 2>& factors(const int function) const { return m_functions[function]; }

  /// Calls `f(vertex)` for the vertices whose basis functions act in a face, for some of them several times.
  template <typename Function>
  void for_each_vertex(const int face, const Function& f) const
  {
    if (const int c = m_cone_face_of_face[face]; c != none)
      std::for_each(m_cone_faces[c].controls.begin(), m_cone_faces[c].controls.end(), f);
    else if (const Corner_face* const corner = corner_face(face); corner != nullptr)
      std::for_each(corner->controls.begin(), corner->controls.end(), f);
    else
      std::for_each(actions_begin(face), actions_end(face), [&](const Action& a) { f(a.vertex); });
  }

  /// Calls `f(vertex, jet)` for the pieces of basis functions that do not vanish at a point of a face, with the
  /// derivatives up to `Order` with respect to its u and v. The values of one vertex are to be added up. \pre the face is not a cone face
  template <int Order, typename Function>
  void for_each_function(const int face, const FT& u, const FT& v, const Function& f) const
  {
    if (const Corner_face* const corner = corner_face(face); corner != nullptr) {
      for_each_function_at_corner<Order>(*corner, u, v, f);
      return;
    }
    for (const Action* a = actions_begin(face); a != actions_end(face); ++a) {
      const std::pair<FT, FT> p = a->to_vertex(u, v);
      const std::array<Cubic_b_spline<FT>, 2>& b = m_functions[a->function];
      if (b[0].vanishes_at(p.first) || b[1].vanishes_at(p.second))
        continue;
      if constexpr (Order == 0)
        f(a->vertex, Function_jet<FT>{FT(b[0].value(p.first) * b[1].value(p.second))});
      else {
        const Univariate_jet<FT> x = b[0].jet(p.first), y = b[1].jet(p.second);
        Function_jet<FT> jet{FT(x[0] * y[0]), FT(x[1] * y[0]), FT(x[0] * y[1])};
        if constexpr (Order > 1) {
          jet[3] = x[2] * y[0];
          jet[4] = x[1] * y[1];
          jet[5] = x[0] * y[2];
        }
        pull_back(a->to_vertex, Order, jet);
        f(a->vertex, jet);
      }
    }
  }

private:
  template <int Order, typename Function>
  static void for_each_function_at_corner(const Corner_face& corner, const FT& u, const FT& v, const Function& f)
  {
    const std::pair<FT, FT> p = corner.to_unit_square(u, v);
    corner.patches->for_each_function(corner.sector, p.first, p.second, Order,
                                      [&](const int control, Function_jet<FT> jet) {
                                        pull_back(corner.to_unit_square, Order, jet);
                                        f(corner.controls[control], jet);
                                      });
  }

  template <typename KnotFT>
  void add_natural_ends(const Spline_structure<KnotFT, FT>& structure, std::vector<std::pair<int, Action>>& actions)
  {
    using Natural_end = typename Spline_structure<KnotFT, FT>::Natural_end;
    structure.find_natural_ends([&](const Natural_end& end, const Basis_support<FT>& support) {
      const Cubic_b_spline<FT> x(end.knots.knots[0]), y(end.knots.knots[1]);
      const int function = static_cast<int>(m_functions.size());
      m_functions.push_back({FT(2) * x, y});
      m_functions.push_back({FT(-1) * x, y});
      for (const Support_face<FT>& face : support.faces())
        if (structure.corner_of_face(face.face) == none) {
          actions.emplace_back(face.face, Action{end.border_vertex, function, face.to_vertex});
          actions.emplace_back(face.face, Action{end.inner_vertex, function + 1, face.to_vertex});
        }
    });
  }

  void sort_by_faces(const std::vector<std::pair<int, Action>>& actions)
  {
    m_first_action.assign(m_arrays.number_of_faces() + 1, 0);
    for (const auto& action : actions)
      ++m_first_action[action.first + 1];
    for (std::size_t f = 1; f < m_first_action.size(); ++f)
      m_first_action[f] += m_first_action[f - 1];
    m_actions.resize(actions.size());
    std::vector<std::size_t> next(m_first_action.begin(), m_first_action.end() - 1);
    for (const auto& action : actions)
      m_actions[next[action.first]++] = action.second;
  }

  template <typename KnotFT>
  void add_faces_at_extraordinary_vertices(const Spline_structure<KnotFT, FT>& structure)
  {
    m_cone_face_of_face.assign(m_arrays.number_of_faces(), none);
    m_corner_face_of_face.assign(m_arrays.number_of_faces(), none);
    std::map<int, std::shared_ptr<const Evaluator>> evaluators; // per valence
    std::map<int, std::shared_ptr<const Corner_patches<FT>>> patches;
    const auto of_valence = [](auto& shared, const int valence) {
      using T = typename std::decay_t<decltype(shared)>::mapped_type::element_type;
      auto& result = shared[valence];
      if (result == nullptr)
        result = std::make_shared<T>(valence);
      return result;
    };
    for (const Regular_rings<KnotFT>& rings : structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector) {
        const int h = m_arrays.prev(rings.bottom(sector, 0, 0)), face = m_arrays.face(h);
        const Vertex_quarter<FT> quarter{h, false, FT(1) / m_arrays.width(face)};
        const Similarity_2<FT> to_unit_square = frame_of_quarter(m_arrays, quarter, 0);
        if (rings.is_on_border()) {
          m_corner_face_of_face[face] = static_cast<int>(m_corner_faces.size());
          m_corner_faces.push_back(
              {sector, to_unit_square, rings.corner_controls(), of_valence(patches, rings.valence())});
        }
        else {
          m_cone_face_of_face[face] = static_cast<int>(m_cone_faces.size());
          m_cone_faces.push_back(
              {face, to_unit_square, rings.controls(sector), of_valence(evaluators, rings.valence())});
        }
      }
  }

  Arrays m_arrays;
  std::vector<std::array<Cubic_b_spline<FT>, 2>> m_functions; // per vertex; then those beyond natural ends
  std::vector<std::size_t> m_first_action;                    // per face
  std::vector<Action> m_actions;
  std::vector<int> m_cone_face_of_face, m_corner_face_of_face;
  std::vector<Cone_face> m_cone_faces;
  std::vector<Corner_face> m_corner_faces;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_BASIS_H
