// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_THIN_PLATE_ENERGY_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_THIN_PLATE_ENERGY_H

#include <CGAL/T_splines/Spline/internal/Bezier_cells.h>
#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>
#include <CGAL/T_splines/Spline/internal/Face_functions.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Gauss's formula with four points on [0, 1], exact for polynomials of degree 7.
template <typename FT>
std::array<std::pair<FT, FT>, 4> gauss_points_and_weights()
{
  const FT inner = std::sqrt(FT(3) / FT(7) - FT(2) / FT(7) * std::sqrt(FT(6) / FT(5)));
  const FT outer = std::sqrt(FT(3) / FT(7) + FT(2) / FT(7) * std::sqrt(FT(6) / FT(5)));
  const FT heavy = (FT(18) + std::sqrt(FT(30))) / FT(72), light = (FT(18) - std::sqrt(FT(30))) / FT(72);
  return {{{(FT(1) - outer) / FT(2), light},
           {(FT(1) - inner) / FT(2), heavy},
           {(FT(1) + inner) / FT(2), heavy},
           {(FT(1) + outer) / FT(2), light}}};
}

/// What makes of the derivatives of a function, d/ds to d2/dt2, those of second order in other coordinates x and y: its
/// d2/dx2, sqrt(2) d2/dxdy, d2/dy2, times the square root of a weight.
template <typename FT>
using Second_order_form = Eigen::Matrix<FT, 3, 5>;

/// The coordinates in which the second derivatives at an extraordinary vertex are taken: those of the characteristic
/// map (Reif, A unified approach to subdivision algorithms near extraordinary vertices, 1995), the surface of the two
/// subdominant eigenvectors. It is scaled so that the face at the vertex has area 1.
///
/// With respect to the parameters of the face, the second derivatives of a surface with a tangent plane would not even
/// be square integrable at a vertex of valence 5 or more. At a vertex of valence 1, which has no characteristic map,
/// the parameters of the face must do. Of the infinitely many rings of patches the first ones are integrated; what is
/// left out tends to zero geometrically.
template <typename FT>
class Cone_face_quadrature {
public:
  struct Point {
    std::vector<Function_jet<FT>> jets; ///< of the basis functions, with respect to s and t
    Second_order_form<FT> form;
  };

  /// \param evaluator of the valence
  template <typename Evaluator>
  explicit Cone_face_quadrature(const Evaluator& evaluator)
  {
    const bool has_map = evaluator.valence() > 1;
    const std::vector<Row> map = has_map ? characteristic_map(evaluator.valence()) : std::vector<Row>();
    const int number_of_rings = has_map ? 6 : 2;
    FT area(0), size(1);
    for (int ring = 0; ring < number_of_rings; ++ring) {
      size /= FT(2);
      for (const auto& corner : {std::array<FT, 2>{size, FT(0)}, {size, size}, {FT(0), size}})
        for (const auto& s : gauss_points_and_weights<FT>())
          for (const auto& t : gauss_points_and_weights<FT>()) {
            m_points.emplace_back();
            evaluator.basis(corner[0] + size * s.first, corner[1] + size * t.first, 2, m_points.back().jets);
            const FT weight = s.second * t.second * size * size;
            area += add_form(map, weight, m_points.back());
          }
    }
    // Lengths are divided by sqrt(area): second derivatives times the area, the integral divided by it.
    for (Point& point : m_points)
      point.form *= std::sqrt(area);
  }

  const std::vector<Point>& points() const { return m_points; }

private:
  struct Row {
    FT x, y;
    Row operator+(const Row& other) const { return {x + other.x, y + other.y}; }
    Row operator*(const FT& factor) const { return {x * factor, y * factor}; }
  };

  // By the power method, from controls of the first mode of rotation. Round-off brings the limit position back, whose
  // eigenvalue is 1.
  static std::vector<Row> characteristic_map(const int valence)
  {
    const Catmull_clark_subdivision<FT> rules(valence);
    std::vector<Row> controls(rules.number_of_controls(), Row{FT(0), FT(0)});
    for (int i = 0; i < valence; ++i) {
      controls[rules.spoke(i)] = {cosine_of_pi_times<FT>(2 * i, valence), sine_of_pi_times<FT>(2 * i, valence)};
      controls[rules.diagonal(i)] =
          Row{cosine_of_pi_times<FT>(2 * i + 1, valence), sine_of_pi_times<FT>(2 * i + 1, valence)} * FT(1.4);
    }
    const std::vector<FT> limit_weights = rules.limit_weights();
    constexpr int number_of_steps = 100;
    for (int step = 0; step < number_of_steps; ++step) {
      controls = rules.subdivided(controls);
      Row limit{FT(0), FT(0)};
      for (std::size_t i = 0; i < controls.size(); ++i)
        limit = limit + controls[i] * limit_weights[i];
      const FT norm = std::hypot(controls[rules.spoke(0)].x, controls[rules.spoke(0)].y);
      for (Row& control : controls)
        control = (control + limit * FT(-1)) * (FT(1) / norm);
    }
    return controls;
  }

  // Returns the area element, times the weight.
  static FT add_form(const std::vector<Row>& map, const FT& weight, Point& point)
  {
    using Matrix_2 = Eigen::Matrix<FT, 2, 2>;
    std::array<Row, 6> jet{};
    for (std::size_t i = 0; i < map.size(); ++i)
      for (int k = 0; k < 6; ++k)
        jet[k] = jet[k] + map[i] * point.jets[i][k];
    Matrix_2 inverse = Matrix_2::Identity(); // of the matrix of x_s, x_t; y_s, y_t
    FT area_element = weight;
    if (!map.empty()) {
      Matrix_2 jacobian;
      jacobian << jet[1].x, jet[2].x, jet[1].y, jet[2].y;
      inverse = jacobian.inverse();
      area_element *= std::abs(jacobian.determinant());
    }
    // With the gradient g in x and y: H_xy = inverse^T (H_st - g_x H_st(x) - g_y H_st(y)) inverse.
    for (int d = 0; d < 5; ++d) {
      Matrix_2 hessian = Matrix_2::Zero();
      if (d < 2) {
        const FT g_x = inverse(d, 0), g_y = inverse(d, 1);
        hessian << -(g_x * jet[3].x + g_y * jet[3].y), -(g_x * jet[4].x + g_y * jet[4].y),
            -(g_x * jet[4].x + g_y * jet[4].y), -(g_x * jet[5].x + g_y * jet[5].y);
      }
      else
        hessian << FT(d == 2), FT(d == 3), FT(d == 3), FT(d == 4);
      const Matrix_2 h = inverse.transpose() * hessian * inverse;
      point.form.col(d) << h(0, 0), std::sqrt(FT(2)) * h(0, 1), h(1, 1);
    }
    point.form *= std::sqrt(area_element);
    return area_element;
  }

  std::vector<Point> m_points;
};

/// The thin-plate energy of the rational basis functions in each face, the integral of f_xx^2 + 2 f_xy^2 + f_yy^2 over
/// the face; x and y are u and v in the unit in which the face has area 1, at an extraordinary vertex the coordinates
/// of
/// `Cone_face_quadrature`. So the unit of the knots does not matter.
template <typename FT>
class Thin_plate_energy {
public:
  using Matrix = Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic>;

  explicit Thin_plate_energy(const T_spline_basis<FT>& basis) : m_basis(basis) {}

  /// The matrix of the quadratic form, of the functions at a face, in their order.
  const Matrix& matrix(Face_functions<FT>& functions)
  {
    const int c = m_basis.cone_face_of(functions.face());
    m_row = 0;
    if (c < 0)
      add_cells(functions);
    else
      add_cone_face(m_basis.cone_faces()[c], functions);
    const Eigen::Index n = static_cast<Eigen::Index>(functions.vertices().size());
    m_matrix.setZero(n, n);
    m_matrix.template selfadjointView<Eigen::Lower>().rankUpdate(m_rows.leftCols(m_row));
    return m_matrix;
  }

private:
  void add_cells(Face_functions<FT>& functions)
  {
    const int face = functions.face();
    const FT width = m_basis.t_mesh().width(face), height = m_basis.t_mesh().height(face);
    find_cell_cuts(m_basis, face, 0, m_u);
    find_cell_cuts(m_basis, face, 1, m_v);
    reserve(functions, 16 * (m_u.size() - 1) * (m_v.size() - 1));
    Second_order_form<FT> unit = Second_order_form<FT>::Zero();
    unit(0, 2) = unit(2, 4) = width * height;
    unit(1, 3) = std::sqrt(FT(2)) * width * height;
    for (std::size_t i = 0; i + 1 < m_u.size(); ++i)
      for (std::size_t j = 0; j + 1 < m_v.size(); ++j) {
        const FT du = m_u[i + 1] - m_u[i], dv = m_v[j + 1] - m_v[j];
        for (const auto& s : gauss_points_and_weights<FT>())
          for (const auto& t : gauss_points_and_weights<FT>()) {
            const FT weight = s.second * t.second * (du / width) * (dv / height);
            add_point(functions.template evaluate<2>(m_u[i] + du * s.first, m_v[j] + dv * t.first),
                      unit * std::sqrt(weight));
          }
      }
  }

  void add_cone_face(const typename T_spline_basis<FT>::Cone_face& face, Face_functions<FT>& functions)
  {
    auto found = m_quadratures.find(face.evaluator->valence());
    if (found == m_quadratures.end())
      found = m_quadratures.emplace(face.evaluator->valence(), Cone_face_quadrature<FT>(*face.evaluator)).first;
    reserve(functions, found->second.points().size());
    for (const auto& point : found->second.points())
      add_point(functions.rational_jets(face.controls, point.jets), point.form);
  }

  void reserve(const Face_functions<FT>& functions, const std::size_t number_of_points)
  {
    const Eigen::Index rows = static_cast<Eigen::Index>(functions.vertices().size());
    const Eigen::Index columns = 3 * static_cast<Eigen::Index>(number_of_points);
    if (m_rows.rows() != rows || m_rows.cols() < columns)
      m_rows.resize(rows, columns);
  }

  void add_point(const std::vector<Function_jet<FT>>& jets, const Second_order_form<FT>& form)
  {
    for (std::size_t i = 0; i < jets.size(); ++i) {
      Eigen::Matrix<FT, 5, 1> derivatives;
      derivatives << jets[i][1], jets[i][2], jets[i][3], jets[i][4], jets[i][5];
      m_rows.template block<1, 3>(static_cast<Eigen::Index>(i), m_row).noalias() = (form * derivatives).transpose();
    }
    m_row += 3;
  }

  const T_spline_basis<FT>& m_basis;
  std::map<int, Cone_face_quadrature<FT>> m_quadratures; // per valence
  Matrix m_rows, m_matrix;
  Eigen::Index m_row = 0;
  std::vector<FT> m_u, m_v;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_THIN_PLATE_ENERGY_H
