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
    m_arrays = structure.uncut_arrays();
    const Arrays& cut = structure.arrays();
    std::vector<std::pair<int, Action>> actions;
    m_functions.resize(cut.number_of_vertices());
    const Spline_defect defect = structure.find_supports([&](const int v, const Basis_support<FT>& support) {
      const std::array<Axis_knots<FT>, 2>& axes = structure.knots(v).axes;
      for (int axis = 0; axis < 2; ++axis)
        m_functions[v][axis] = Cubic_b_spline<FT>(axes[axis]);
      int first_half = none;
      if (axes[0].is_peak) {
        first_half = static_cast<int>(m_functions.size());
        m_functions.push_back({Cubic_b_spline<FT>(axes[0].left_half()), m_functions[v][1]});
        m_functions.push_back({Cubic_b_spline<FT>(axes[0].right_half()), m_functions[v][1]});
      }
      for (const Support_face<FT>& face : support.faces())
        if (structure.corner_of_face(face.face) == none)
          actions.emplace_back(
              face.face, Action{cut.original_vertex(v),
                                first_half == none ? v : function_of_peak(v, first_half, support.rectangle_of(face)),
                                face.to_vertex});
    });
    if (defect)
      return defect;
    for (int v = 0; v < cut.number_of_vertices(); ++v)
      if (structure.is_border_corner(v)) {
        m_border_corners.emplace_back();
        cut.for_each_incoming(v, [&](const int h) { m_border_corners.back().push_back(cut.original_halfedge(h)); });
      }
    add_corner_ends(structure, actions);
    sort_by_faces(actions);
    add_faces_at_extraordinary_vertices(structure);
    return {};
  }

  const Arrays& t_mesh() const { return m_arrays; }
  const std::vector<Cone_face>& cone_faces() const { return m_cone_faces; }

  /// The corners of the border and of the parts between creases, where the surface is at the control point: of each, the
  /// halfedges that end there.
  const std::vector<std::vector<int>>& border_corners() const { return m_border_corners; }

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

  // Where a peak has a kink, its derivatives differ: the halves tell from which side a face sees it.
  static int function_of_peak(const int whole, const int first_half, const Support_rectangle<FT>& face)
  {
    const FT eps = knot_tolerance_between_faces(FT(face.high[0] - face.low[0]));
    return face.high[0] <= eps ? first_half : face.low[0] >= -eps ? first_half + 1 : whole;
  }

  template <typename KnotFT>
  void add_corner_ends(const Spline_structure<KnotFT, FT>& structure, std::vector<std::pair<int, Action>>& actions)
  {
    using Corner_end = typename Spline_structure<KnotFT, FT>::Corner_end;
    const Arrays& cut = structure.arrays();
    structure.find_corner_ends([&](const Corner_end& end, const Basis_support<FT>& support) {
      const Cubic_b_spline<FT> x(end.knots.axes[0]), y(end.knots.axes[1]);
      const int function = static_cast<int>(m_functions.size());
      m_functions.push_back({FT(2) * x, y});
      m_functions.push_back({FT(-1) * x, y});
      for (const Support_face<FT>& face : support.faces())
        if (structure.corner_of_face(face.face) == none) {
          actions.emplace_back(face.face, Action{cut.original_vertex(end.corner), function, face.to_vertex});
          actions.emplace_back(face.face, Action{cut.original_vertex(end.inner_vertex), function + 1, face.to_vertex});
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
    std::map<std::pair<int, Border_turn>, std::shared_ptr<const Corner_patches<FT>>> patches;
    const auto shared = [](auto& all, const auto key, const auto&... arguments) {
      using T = typename std::decay_t<decltype(all)>::mapped_type::element_type;
      auto& result = all[key];
      if (result == nullptr)
        result = std::make_shared<T>(arguments...);
      return result;
    };
    const Arrays& cut = structure.arrays();
    const auto originals = [&](std::vector<int> vertices) {
      for (int& v : vertices)
        v = cut.original_vertex(v);
      return vertices;
    };
    for (const Regular_rings<KnotFT>& rings : structure.rings()) {
      const int valence = rings.valence();
      const Border_turn turn =
          structure.is_end_of_slit(rings.vertex(0, 0, 0)) ? Border_turn::SLIT : Border_turn::CORNER;
      for (int sector = 0; sector < valence; ++sector) {
        const int h = cut.prev(rings.bottom(sector, 0, 0)), face = cut.face(h);
        const Vertex_quarter<FT> quarter{h, false, FT(1) / cut.width(face)};
        const Similarity_2<FT> to_unit_square = frame_of_quarter(cut, quarter, 0);
        if (rings.is_on_border()) {
          m_corner_face_of_face[face] = static_cast<int>(m_corner_faces.size());
          m_corner_faces.push_back({sector, to_unit_square, originals(rings.corner_controls()),
                                    shared(patches, std::make_pair(valence, turn), valence, turn)});
        }
        else {
          m_cone_face_of_face[face] = static_cast<int>(m_cone_faces.size());
          m_cone_faces.push_back(
              {face, to_unit_square, originals(rings.controls(sector)), shared(evaluators, valence, valence)});
        }
      }
    }
  }

  Arrays m_arrays;
  // Per vertex between creases; then halves of peaks, and those beyond corners.
  std::vector<std::array<Cubic_b_spline<FT>, 2>> m_functions;
  std::vector<std::size_t> m_first_action; // per face
  std::vector<Action> m_actions;
  std::vector<int> m_cone_face_of_face, m_corner_face_of_face;
  std::vector<Cone_face> m_cone_faces;
  std::vector<Corner_face> m_corner_faces;
  std::vector<std::vector<int>> m_border_corners;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_BASIS_H
