// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_COMPILER_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_COMPILER_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/Compiled_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Bezier_cells.h>
#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>
#include <CGAL/T_splines/Spline/internal/Homogeneous_vector.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/Spline/internal/Vertex_cap.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Extracts the Bezier patches of a T-spline surface.
///
/// On a cell between knot lines each basis function is a product of two cubic polynomials. Their Bernstein
/// coefficients, times the homogeneous control points, add up to the control points of the patch.
template <typename Surface>
class T_spline_compiler {
  using Kernel = typename Surface::Kernel;
  using FT = typename Kernel::FT;
  using Basis = T_spline_basis<FT>;
  using Action = typename Basis::Action;
  using Cone_face = typename Basis::Cone_face;
  using Corner_face = typename Basis::Corner_face;
  using Compiled = Compiled_T_spline<typename Surface::Graph, Kernel>;
  using Patch = typename Compiled::Patch;
  using Homogeneous = std::array<FT, 4>;

public:
  explicit T_spline_compiler(const Surface& surface) : m_surface(surface), m_basis(surface.basis()) {}

  Compiled compile(const int number_of_rings, Progress& progress)
  {
    constexpr std::size_t work_per_face = 50, work_per_cone_face = 2000;
    progress.go_on();
    Compiled result;
    result.m_indexing = m_surface.shared_indexing();
    result.m_t_mesh = std::shared_ptr<const T_mesh_arrays<FT>>(m_surface.shared_basis(), &m_basis.t_mesh());
    result.m_number_of_rings = m_basis.cone_faces().empty() ? 0 : number_of_rings;
    const int n = m_basis.t_mesh().number_of_faces();
    result.m_faces.reserve(n);
    result.m_patches.reserve(n);
    result.m_rectangles.reserve(n);
    for (int f = 0; f < n; ++f) {
      const bool is_cone_face = m_basis.cone_face_of(f) >= 0;
      if (f % 64 == 0)
        progress.progress(static_cast<double>(f) / n);
      if (!progress.go_on_after(is_cone_face ? work_per_cone_face : work_per_face)) {
        Compiled nothing;
        nothing.m_status = T_spline_compilation_status::INTERRUPTED;
        return nothing;
      }
      if (is_cone_face)
        compile_cone_face(m_basis.cone_faces()[m_basis.cone_face_of(f)], result);
      else
        compile_face(f, result);
    }
    return result;
  }

private:
  void compile_face(const int f, Compiled& result)
  {
    find_cell_cuts(m_basis, f, 0, m_u);
    find_cell_cuts(m_basis, f, 1, m_v);
    const int columns = static_cast<int>(m_u.size()) - 1, rows = static_cast<int>(m_v.size()) - 1;
    const std::size_t first = result.m_patches.size();
    result.m_faces.push_back({first, result.m_cuts.size(), columns, rows, 0});
    result.m_cuts.insert(result.m_cuts.end(), m_u.begin() + 1, m_u.end() - 1);
    result.m_cuts.insert(result.m_cuts.end(), m_v.begin() + 1, m_v.end() - 1);
    result.m_patches.resize(first + columns * rows);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        add_rectangle(f, m_u[column], m_u[column + 1], m_v[row], m_v[row + 1], false, result);

    if (const Corner_face* const corner = m_basis.corner_face(f); corner != nullptr) {
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          result.m_patches[first + row * columns + column] = corner_patch(*corner, f, column, row);
      return;
    }
    for (const Action* a = m_basis.actions_begin(f); a != m_basis.actions_end(f); ++a) {
      find_coefficients(*a, 0, m_u, m_a);
      find_coefficients(*a, 1, m_v, m_b);
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          add(m_a[column], m_b[row], m_surface.homogeneous_control_points()[a->vertex],
              result.m_patches[first + row * columns + column]);
    }
  }

  // The Bernstein coefficients of a factor of a basis function, between successive cuts.
  void find_coefficients(const Action& action, const int face_axis, const std::vector<FT>& cuts,
                         std::vector<std::array<FT, 4>>& coefficients) const
  {
    const Frame_axis<FT> axis = frame_axis(action.to_vertex, face_axis);
    const Cubic_b_spline<FT>& function = m_basis.factors(action.function)[axis.axis];
    coefficients.clear();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      coefficients.push_back(function.bernstein_coefficients(FT(axis.factor * cuts[i] + axis.offset),
                                                             FT(axis.factor * cuts[i + 1] + axis.offset)));
  }

  static void add(const std::array<FT, 4>& a, const std::array<FT, 4>& b, const Homogeneous& p, Patch& patch)
  {
    if (vanish(a) || vanish(b))
      return;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const FT x = a[i] * b[j];
        Homogeneous& c = patch.homogeneous_control_point(i, j);
        for (int k = 0; k < 4; ++k)
          c[k] += x * p[k];
      }
  }

  static bool vanish(const std::array<FT, 4>& a)
  {
    return a[0] == FT(0) && a[1] == FT(0) && a[2] == FT(0) && a[3] == FT(0);
  }

  static void add_rectangle(const int f, const FT& u0, const FT& u1, const FT& v0, const FT& v1, const bool is_cap,
                            Compiled& result)
  {
    result.m_rectangles.push_back({u0, v0, FT(FT(1) / FT(u1 - u0)), FT(FT(1) / FT(v1 - v0)), f, is_cap});
  }

  void compile_cone_face(const Cone_face& face, Compiled& result)
  {
    const int corner = (4 - face.to_unit_square.quarter_turns()) % 4;
    result.m_faces.push_back({result.m_patches.size(), 0, 0, 0, corner});
    auto& rules = m_rules[face.evaluator->valence()];
    if (rules == nullptr)
      rules = std::make_unique<Catmull_clark_subdivision<FT>>(face.evaluator->valence());
    std::vector<Homogeneous_vector<FT>> controls;
    for (const int v : face.controls)
      controls.push_back({m_surface.homogeneous_control_points()[v]});

    const FT half = FT(1) / FT(2), zero(0);
    FT size(1); // of the square that is left
    std::array<Patch, 3> last;
    for (int ring = 0; ring < result.m_number_of_rings; ++ring) {
      for (int part = 0; part < 3; ++part)
        last[part] = part_of(*rules, controls, part);
      size *= half;
      add_local_patch(face, last[0], size, zero, size, false, result);
      add_local_patch(face, last[1], size, size, size, false, result);
      add_local_patch(face, last[2], zero, size, size, false, result);
      controls = rules->subdivided(controls);
    }
    const Homogeneous limit = limit_of(*rules, controls);
    const std::array<Patch, 3> next{part_of(*rules, controls, 0), part_of(*rules, controls, 1),
                                    part_of(*rules, controls, 2)};
    const Patch cap = vertex_cap(limit, last, next);
    add_local_patch(face, cap, zero, zero, size, true, result);
    result.m_cap_deviation = (std::max)(result.m_cap_deviation, deviation(face, cap, size));
  }

  static Patch part_of(const Catmull_clark_subdivision<FT>& rules, const std::vector<Homogeneous_vector<FT>>& controls,
                       const int part)
  {
    const std::vector<Homogeneous_vector<FT>> b_spline = rules.part_controls(controls, 1, part);
    return bezier_of_uniform_b_spline<Kernel>(b_spline);
  }

  static Homogeneous limit_of(const Catmull_clark_subdivision<FT>& rules,
                              const std::vector<Homogeneous_vector<FT>>& controls)
  {
    const std::vector<FT> weights = rules.limit_weights();
    Homogeneous_vector<FT> sum = controls[0] * weights[0];
    for (std::size_t i = 1; i < controls.size(); ++i)
      sum = sum + controls[i] * weights[i];
    return sum.values;
  }

  // Adds a patch that is given in the frame of the extraordinary vertex.
  void add_local_patch(const Cone_face& face, const Patch& patch, const FT& s, const FT& t, const FT& size,
                       const bool is_cap, Compiled& result) const
  {
    const Similarity_2<FT> to_face = face.to_unit_square.inverse();
    const auto a = to_face(s, t), b = to_face(FT(s + size), FT(t + size));
    add_rectangle(face.face, (std::min)(a.first, b.first), (std::max)(a.first, b.first), (std::min)(a.second, b.second),
                  (std::max)(a.second, b.second), is_cap, result);
    result.m_patches.push_back(turned(patch, face.to_unit_square.quarter_turns()));
  }

  // The same patch in a frame that such a number of quarter turns takes to that of `patch`.
  static Patch turned(const Patch& patch, const int quarter_turns)
  {
    Patch result;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        Homogeneous& p = result.homogeneous_control_point(i, j);
        switch (quarter_turns) {
        case 0: p = patch.homogeneous_control_point(i, j); break;
        case 1: p = patch.homogeneous_control_point(3 - j, i); break;
        case 2: p = patch.homogeneous_control_point(3 - i, 3 - j); break;
        default: p = patch.homogeneous_control_point(j, 3 - i);
        }
      }
    return result;
  }

  // A patch of a face at a corner of the border; the face is divided along both axes into parts of one size.
  Patch corner_patch(const Corner_face& corner, const int f, const int column, const int row) const
  {
    const Corner_patches<FT>& patches = *corner.patches;
    const int n = patches.pieces_per_side();
    const auto centre = [n](const FT& size, const int i) { return FT(size * FT(2 * i + 1) / FT(2 * n)); };
    const auto p =
        corner.to_unit_square(centre(m_basis.t_mesh().width(f), column), centre(m_basis.t_mesh().height(f), row));
    const int local_column = patches.piece(p.first), local_row = patches.piece(p.second);
    Patch patch;
    for (int control = 0; control < patches.number_of_controls(); ++control) {
      const Homogeneous& point = m_surface.homogeneous_control_points()[corner.controls[control]];
      const auto& coefficients = patches.coefficients(corner.sector, local_column, local_row, control);
      for (int k = 0; k < 16; ++k)
        for (int axis = 0; axis < 4; ++axis)
          patch.homogeneous_control_point(k % 4, k / 4)[axis] += coefficients[k] * point[axis];
    }
    return turned(patch, corner.to_unit_square.quarter_turns());
  }

  // The largest distance of the cap from the surface at 8 x 8 points, the vertex itself excluded.
  double deviation(const Cone_face& face, const Patch& cap, const FT& size) const
  {
    constexpr int n = 8;
    const auto& coefficients = m_surface.cone_coefficients(m_basis.cone_face_of(face.face));
    typename Basis::Evaluator::Derivatives jet;
    double result = 0;
    for (int i = 0; i <= n; ++i)
      for (int j = i == 0 ? 1 : 0; j <= n; ++j) {
        const FT x = FT(i) / FT(n), y = FT(j) / FT(n);
        face.evaluator->evaluate(coefficients, FT(size * x), FT(size * y), 0, jet);
        const auto difference = cap.position(x, y) - projected_point<Kernel>(jet[0]);
        result = (std::max)(result, CGAL::to_double(FT(difference.squared_length())));
      }
    return std::sqrt(result);
  }

  const Surface& m_surface;
  const Basis& m_basis;
  std::map<int, std::unique_ptr<Catmull_clark_subdivision<FT>>> m_rules; // per valence
  std::vector<FT> m_u, m_v;
  std::vector<std::array<FT, 4>> m_a, m_b;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_T_SPLINE_COMPILER_H
