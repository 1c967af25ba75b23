// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/internal/Catmull_clark_eigenstructure.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Catmull_clark_eigenstructure_test {

namespace {

using Exact = CGAL::Exact_rational;
using Exact_rules = CGAL::T_splines::internal::Catmull_clark_subdivision<Exact>;
using Rules = CGAL::T_splines::internal::Catmull_clark_subdivision<double>;
using Eigenstructure = CGAL::T_splines::internal::Catmull_clark_eigenstructure<double>;
using Vector_4 = Eigenstructure::Vector_4;
using Derivatives = Eigenstructure::Derivatives;
using Scalar_derivatives = Eigenstructure::Scalar_derivatives;

constexpr int largest_valence = 32;
constexpr std::array<std::array<int, 2>, 6> orders{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// Controls with few bits, so that they are the same as rational numbers.
std::vector<Vector_4> random_controls(const int number, CGAL::Random& random)
{
  std::vector<Vector_4> controls(static_cast<std::size_t>(number));
  for (Vector_4& control : controls)
    for (double& x : control)
      x = random.get_int(-1024, 1025) / 1024.;
  return controls;
}

template <typename FT>
std::vector<FT> component(const std::vector<Vector_4>& controls, const int c)
{
  std::vector<FT> result;
  for (const Vector_4& control : controls)
    result.push_back(FT(control[c]));
  return result;
}

double norm(const Vector_4& x)
{
  return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
}

double distance(const Vector_4& a, const Vector_4& b)
{
  return norm({a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]});
}

Vector_4 cross_product(const Vector_4& a, const Vector_4& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.};
}

Vector_4 direction(const Vector_4& a)
{
  const double length = std::hypot(a[0], a[1], a[2]);
  return {a[0] / length, a[1] / length, a[2] / length, 0.};
}

Derivatives evaluated(const Eigenstructure& structure, const std::vector<Vector_4>& coefficients, const double s,
                      const double t)
{
  Derivatives result;
  structure.evaluate(coefficients, s, t, 2, result);
  return result;
}

/// A derivative of the polynomial with the rows of the matrix of the uniform cubic B-spline as coefficients.
Exact cubic(const int segment, const Exact& x, const int derivative)
{
  static const int coefficients[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
  Exact sum(0), power(1);
  for (int degree = derivative; degree < 4; ++degree, power *= x) {
    int factor = coefficients[segment][degree];
    for (int i = 0; i < derivative; ++i)
      factor *= degree - i;
    sum += power * Exact(factor) / Exact(6);
  }
  return sum;
}

Exact bicubic(const std::vector<Exact>& controls, const Exact& x, const Exact& y, const std::array<int, 2>& order)
{
  Exact sum(0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum += controls[4 * j + i] * cubic(i, x, order[0]) * cubic(j, y, order[1]);
  return sum;
}

/// The largest relative error of the derivatives at a point with respect to exact bicubic patches, one per component.
double relative_error(const Derivatives& derivatives, const std::array<std::vector<Exact>, 4>& patches, const Exact& x,
                      const Exact& y, const int level)
{
  double error = 0;
  for (std::size_t d = 0; d < orders.size(); ++d) {
    Vector_4 exact;
    for (int c = 0; c < 4; ++c)
      exact[c] =
          std::ldexp(CGAL::to_double(bicubic(patches[c], x, y, orders[d])), level * (orders[d][0] + orders[d][1]));
    error = (std::max)(error, distance(derivatives[d], exact) / norm(exact));
  }
  return error;
}

/// A mesh of `size` times `size` quads in each of n sectors around a vertex.
struct Fan {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;

  Fan(const int n, const int size, CGAL::Random& random) : valence(n), rings(size)
  {
    mesh.add_vertex(random_point(0., 0., random));
    for (int i = 0; i < n; ++i)
      for (int a = 1; a <= size; ++a)
        for (int b = 0; b <= size; ++b) {
          const double angle = 2 * CGAL_PI / n, u = i * angle, v = u + angle;
          mesh.add_vertex(random_point(a * std::cos(u) + b * std::cos(v), a * std::sin(u) + b * std::sin(v), random));
        }
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b)
          mesh.add_face(vertex(i, a, b), vertex(i, a + 1, b), vertex(i, a + 1, b + 1), vertex(i, a, b + 1));
  }

  /// The vertex at `a` along spoke i and `b` along spoke i + 1.
  Vertex vertex(int i, int a, int b) const
  {
    if (a == 0 && b == 0)
      return Vertex(0);
    if (a == 0) {
      ++i;
      std::swap(a, b);
    }
    return Vertex(static_cast<Mesh::size_type>(1 + ((i % valence) * rings + a - 1) * (rings + 1) + b));
  }

  std::vector<Vector_4> controls() const
  {
    std::vector<Vertex> vertices{Vertex(0)};
    for (int i = 0; i < valence; ++i) {
      vertices.push_back(vertex(i, 1, 0));
      vertices.push_back(vertex(i, 1, 1));
    }
    for (const Vertex v : {vertex(valence - 1, 1, 2), vertex(0, 2, 0), vertex(0, 2, 1), vertex(0, 2, 2),
                           vertex(0, 1, 2), vertex(1, 2, 0), vertex(1, 2, 1)})
      vertices.push_back(v);
    std::vector<Vector_4> result;
    for (const Vertex v : vertices)
      result.push_back(homogeneous(mesh.point(v)));
    return result;
  }

  static Vector_4 homogeneous(const Point& p) { return {p.x(), p.y(), p.z(), 1.}; }

  static Point random_point(const double x, const double y, CGAL::Random& random)
  {
    return Point(x + random.get_double(-.2, .2), y + random.get_double(-.2, .2), random.get_double(-.5, .5));
  }

  int valence, rings;
  Mesh mesh;
};

/// The limit position of the target of `h`, which is not on the border.
Vector_4 limit_position(const Fan::Mesh::Halfedge_index h, const Fan::Mesh& mesh)
{
  Vector_4 neighbours{}, limit{};
  const double n = static_cast<double>(mesh.degree(mesh.target(h)));
  for (const Fan::Mesh::Halfedge_index g : CGAL::halfedges_around_target(h, mesh)) {
    const Vector_4 e = Fan::homogeneous(mesh.point(mesh.source(g)));
    const Vector_4 f = Fan::homogeneous(mesh.point(mesh.target(mesh.next(mesh.next(g)))));
    for (int c = 0; c < 4; ++c)
      neighbours[c] += 4 * e[c] + (c == 3 ? 1 : f[c]);
  }
  const Vector_4 center = Fan::homogeneous(mesh.point(mesh.target(h)));
  for (int c = 0; c < 4; ++c)
    limit[c] = (n * n * center[c] + neighbours[c]) / (n * (n + 5));
  return limit;
}

} // namespace

TEST_CASE("the rules are affine, and keep the limit position", "[Catmull_clark_rules]")
{
  for (int n = 3; n <= largest_valence; ++n) {
    const Exact_rules rules(n);
    REQUIRE(rules.step().size() == static_cast<std::size_t>(rules.number_of_controls()));
    const std::vector<Exact> ones(rules.step().size(), Exact(1)), weights = rules.limit_weights();
    std::vector<Exact> product(ones.size(), Exact(0));
    Exact sum(0);
    for (std::size_t i = 0; i < ones.size(); ++i) {
      CHECK(Exact_rules::combination(rules.step()[i], ones) == 1);
      sum += weights[i];
      for (const Exact_rules::Entry& entry : rules.step()[i]) {
        CHECK(entry.weight > 0);
        product[entry.index] += weights[i] * entry.weight;
      }
    }
    CHECK(sum == 1);
    CHECK(product == weights);
    for (int part = 0; part < Exact_rules::number_of_parts; ++part)
      for (const Exact_rules::Row& row : rules.part(part))
        CHECK(Exact_rules::combination(row, ones) == 1);
  }
}

TEST_CASE("neighbouring parts share twelve controls", "[Catmull_clark_rules]")
{
  CGAL::Random random(1);
  for (const int n : {3, 4, 5, 9}) {
    const Exact_rules rules(n);
    const std::vector<Exact> controls = component<Exact>(random_controls(rules.number_of_controls(), random), 0);
    const std::vector<Exact> right = rules.part_controls(controls, 3, 0),
                             diagonal = rules.part_controls(controls, 3, 1), left = rules.part_controls(controls, 3, 2);
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i) {
        CHECK(right[4 * (i + 1) + j] == diagonal[4 * i + j]);
        CHECK(left[4 * j + i + 1] == diagonal[4 * j + i]);
      }
  }
}

TEST_CASE("the tangent weights are left eigenvectors", "[Catmull_clark_rules]")
{
  for (int n = 3; n <= largest_valence; ++n) {
    const Rules rules(n);
    const double lambda = Eigenstructure(n).eigenvalues()[1];
    const std::pair<std::vector<double>, std::vector<double>> weights = rules.tangent_weights();
    for (const std::vector<double>& w : {weights.first, weights.second}) {
      std::vector<double> product(w.size(), 0.);
      for (std::size_t i = 0; i < w.size(); ++i)
        for (const Rules::Entry& entry : rules.step()[i])
          product[entry.index] += w[i] * entry.weight;
      for (std::size_t i = 0; i < w.size(); ++i)
        CHECK(std::abs(product[i] - lambda * w[i]) < 1e-14);
    }
  }
}

TEST_CASE("the eigenvectors diagonalize the subdivision", "[Catmull_clark_eigenstructure]")
{
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const Rules rules(n);
    const int size = structure.number_of_controls();
    double residual = 0, defect = 0;
    for (int mode = 0; mode < size; ++mode) {
      std::vector<double> right;
      for (int i = 0; i < size; ++i)
        right.push_back(structure.right_eigenvector(mode, i));
      const std::vector<double> image = rules.subdivided(right);
      for (int i = 0; i < size; ++i)
        residual = (std::max)(residual, std::abs(image[i] - structure.eigenvalues()[mode] * right[i]));
      for (int other = 0; other < size; ++other) {
        double product = mode == other ? -1 : 0;
        for (int i = 0; i < size; ++i)
          product += structure.left_eigenvector(other, i) * right[i];
        defect = (std::max)(defect, std::abs(product));
      }
    }
    CAPTURE(n);
    CHECK(residual < 1e-13);
    CHECK(defect < 1e-12);
  }
}

TEST_CASE("the largest eigenvalues are those of the literature", "[Catmull_clark_eigenstructure]")
{
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    std::vector<double> sorted = structure.eigenvalues();
    const double c = std::cos(2 * CGAL_PI / n), lambda = (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
    CHECK(sorted[0] == 1);
    CHECK(std::abs(sorted[1] - lambda) < 1e-15);
    CHECK(sorted[2] == sorted[1]);
    std::sort(sorted.begin(), sorted.end());
    CHECK(sorted.front() >= 0);
    CHECK(sorted[sorted.size() - 3] == structure.eigenvalues()[1]);
    CHECK(sorted[sorted.size() - 4] < structure.eigenvalues()[1]);
  }
}

TEST_CASE("derivatives agree with exact subdivision", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(2);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const Exact_rules rules(n);
    const std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
    const std::vector<Vector_4> coefficients = structure.project(controls);
    std::array<std::vector<Exact>, 4> refined;
    for (int c = 0; c < 4; ++c)
      refined[c] = component<Exact>(controls, c);
    double error = 0;
    for (int level = 1; level <= 20; ++level) {
      const int part = random.get_int(0, 3), x = random.get_int(0, 64), y = random.get_int(0, 64);
      std::array<std::vector<Exact>, 4> patches;
      for (int c = 0; c < 4; ++c) {
        patches[c] = rules.part_controls(refined[c], 1, part);
        refined[c] = rules.subdivided(refined[c]);
      }
      const double s = std::ldexp(x / 64. + (part != 2), -level), t = std::ldexp(y / 64. + (part != 0), -level);
      const Derivatives derivatives = evaluated(structure, coefficients, s, t);
      error =
          (std::max)(error, relative_error(derivatives, patches, Exact(x) / Exact(64), Exact(y) / Exact(64), level));
    }
    CAPTURE(n);
    CHECK(error < 1e-13);
  }
}

TEST_CASE("repeated subdivision may start at any level", "[Catmull_clark_rules]")
{
  CGAL::Random random(3);
  for (const int n : {3, 4, 7}) {
    const Exact_rules rules(n);
    const std::vector<Exact> controls = component<Exact>(random_controls(rules.number_of_controls(), random), 0);
    for (int part = 0; part < Exact_rules::number_of_parts; ++part)
      CHECK(rules.part_controls(controls, 4, part) == rules.part_controls(rules.subdivided(controls), 3, part));
  }
}

TEST_CASE("around a regular vertex the surface is one bicubic patch", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(4);
  const Eigenstructure structure(4);
  const std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
  const std::vector<Vector_4> coefficients = structure.project(controls);
  // The face (0, 0) - (1, 1) of the grid with corners (-1, -1) and (2, 2), row by row.
  const int grid[16] = {6, 7, 8, 9, 5, 0, 1, 10, 4, 3, 2, 11, 15, 14, 13, 12};
  std::array<std::vector<Exact>, 4> patches;
  for (int c = 0; c < 4; ++c)
    for (const int i : grid)
      patches[c].push_back(Exact(controls[i][c]));
  for (int i = 0; i < 200; ++i) {
    const double scale = std::ldexp(1., -random.get_int(0, 60));
    const double s = i == 0 ? 0 : scale * random.get_double(), t = i == 0 ? 0 : scale * random.get_double();
    CHECK(relative_error(evaluated(structure, coefficients, s, t), patches, Exact(s), Exact(t), 0) < 1e-13);
  }
}

TEST_CASE("the surface is twice continuously differentiable between the parts", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(5);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const std::vector<Vector_4> coefficients =
        structure.project(random_controls(structure.number_of_controls(), random));
    for (int level = 1; level <= 30; ++level) {
      const double side = std::ldexp(1., -level), before = std::nextafter(side, 0.), x = side * random.get_double();
      // Between the levels, and between the parts of a level.
      for (const double y : {x, side + x}) {
        const std::array<std::array<double, 4>, 2> pairs{{{side, y, before, y}, {y, side, y, before}}};
        for (const std::array<double, 4>& pair : pairs) {
          const Derivatives a = evaluated(structure, coefficients, pair[0], pair[1]);
          const Derivatives b = evaluated(structure, coefficients, pair[2], pair[3]);
          double jump = 0;
          for (std::size_t d = 0; d < orders.size(); ++d)
            jump = (std::max)(jump, distance(a[d], b[d]) / norm(a[d]));
          CHECK(jump < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("the far sides belong to the first level", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(6);
  for (const int n : {3, 4, 5, 12}) {
    const Eigenstructure structure(n);
    const std::vector<Vector_4> coefficients =
        structure.project(random_controls(structure.number_of_controls(), random));
    for (const double t : {0., 1e-300, .25, .5, .75, 1.}) {
      const double before = std::nextafter(1., 0.);
      const Derivatives a = evaluated(structure, coefficients, 1., t),
                        b = evaluated(structure, coefficients, before, t);
      const Derivatives c = evaluated(structure, coefficients, t, 1.),
                        d = evaluated(structure, coefficients, t, before);
      for (std::size_t i = 0; i < orders.size(); ++i) {
        CHECK(distance(a[i], b[i]) < 1e-12);
        CHECK(distance(c[i], d[i]) < 1e-12);
      }
    }
  }
}

TEST_CASE("affine maps of the controls map the surface", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(7);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
    for (Vector_4& control : controls)
      control[3] = 1;
    const std::vector<Vector_4> matrix = random_controls(3, random);
    const auto mapped = [&matrix](const Vector_4& x) {
      Vector_4 result{0., 0., 0., x[3]};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
          result[i] += matrix[i][j] * x[j];
      return result;
    };
    const std::vector<Vector_4> coefficients = structure.project(controls);
    std::transform(controls.begin(), controls.end(), controls.begin(), mapped);
    const std::vector<Vector_4> mapped_coefficients = structure.project(controls);
    for (int i = 0; i < 20; ++i) {
      const double scale = std::ldexp(1., -random.get_int(0, 30));
      const double s = scale * random.get_double(), t = scale * random.get_double();
      const Derivatives a = evaluated(structure, coefficients, s, t);
      const Derivatives b = evaluated(structure, mapped_coefficients, s, t);
      CHECK(a[0][3] == 1);
      for (std::size_t d = 0; d < orders.size(); ++d) {
        CHECK(distance(mapped(a[d]), b[d]) <= 1e-12 * norm(b[d]));
        CHECK((d == 0 || a[d][3] == 0));
      }
    }
  }
}

TEST_CASE("equal controls yield exactly a point", "[Catmull_clark_eigenstructure]")
{
  const Vector_4 point{1e10 / 3, -7., 1e-10 / 3, 1.};
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const std::vector<Vector_4> controls(static_cast<std::size_t>(structure.number_of_controls()), point);
    const std::vector<Vector_4> coefficients = structure.project(controls);
    for (const double s : {0., 1e-300, 1e-10, .3, 1.}) {
      const Derivatives derivatives = evaluated(structure, coefficients, s, .7 * s);
      CHECK(derivatives[0] == point);
      for (std::size_t d = 1; d < orders.size(); ++d)
        CHECK(derivatives[d] == Vector_4{});
    }
  }
}

TEST_CASE("the basis is a partition of unity", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(8);
  std::vector<Scalar_derivatives> basis;
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
    const std::vector<Vector_4> coefficients = structure.project(controls);
    for (int i = 0; i < 60; ++i) {
      const double scale = std::ldexp(1., -random.get_int(0, 30));
      const double s = i == 0 ? 0 : scale * random.get_double(), t = i == 0 ? 0 : scale * random.get_double();
      structure.basis(s, t, 2, basis);
      REQUIRE(basis.size() == controls.size());
      const Derivatives derivatives = evaluated(structure, coefficients, s, t);
      for (std::size_t d = 0; d < orders.size(); ++d) {
        double sum = d == 0 ? -1 : 0, largest = 0;
        Vector_4 combination{};
        for (std::size_t control = 0; control < basis.size(); ++control) {
          CHECK(basis[control][0] > -1e-15);
          sum += basis[control][d];
          largest = (std::max)(largest, std::abs(basis[control][d]));
          for (int c = 0; c < 4; ++c)
            combination[c] += basis[control][d] * controls[control][c];
        }
        CHECK(std::abs(sum) <= 1e-13 * largest);
        CHECK(distance(combination, derivatives[d]) <= 1e-12 * largest);
      }
    }
  }
}

TEST_CASE("the basis is symmetric in s and t", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(9);
  std::vector<Scalar_derivatives> basis, mirrored;
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const Rules rules(n);
    std::vector<int> mirror(static_cast<std::size_t>(rules.number_of_controls()), 0);
    for (int i = 0; i < n; ++i) {
      mirror[rules.spoke(i)] = rules.spoke(1 - i);
      mirror[rules.diagonal(i)] = rules.diagonal(-i);
    }
    for (int i = 0; i < 7; ++i)
      mirror[rules.outer(i)] = rules.outer(6 - i);
    const int mirrored_derivative[6] = {0, 2, 1, 5, 4, 3};
    for (int i = 0; i < 20; ++i) {
      const double scale = std::ldexp(1., -random.get_int(0, 6));
      const double s = scale * random.get_double(), t = scale * random.get_double();
      structure.basis(s, t, 2, basis);
      structure.basis(t, s, 2, mirrored);
      for (std::size_t control = 0; control < basis.size(); ++control)
        for (int d = 0; d < 6; ++d)
          CHECK(std::abs(basis[control][d] - mirrored[mirror[control]][mirrored_derivative[d]]) < 1e-11);
    }
  }
}

TEST_CASE("position and tangent plane at the vertex are limits", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(10);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const Rules rules(n);
    const std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
    const std::vector<Vector_4> coefficients = structure.project(controls);
    const std::pair<std::vector<double>, std::vector<double>> weights = rules.tangent_weights();
    const std::vector<double> limit_weights = rules.limit_weights();
    Vector_4 limit{}, a{}, b{};
    for (std::size_t i = 0; i < controls.size(); ++i)
      for (int c = 0; c < 4; ++c) {
        limit[c] += limit_weights[i] * controls[i][c];
        a[c] += weights.first[i] * controls[i][c];
        b[c] += weights.second[i] * controls[i][c];
      }
    const Vector_4 normal = direction(cross_product(a, b));
    CHECK(distance(evaluated(structure, coefficients, 0., 0.)[0], limit) < 1e-14);
    const std::array<Vector_4, 2> tangents = structure.tangents(coefficients);
    CHECK(distance(direction(cross_product(tangents[0], tangents[1])), normal) < 1e-11);
    std::vector<double> sorted = structure.eigenvalues();
    std::sort(sorted.begin(), sorted.end());
    const double ratio = sorted[sorted.size() - 4] / structure.eigenvalues()[1];
    for (const double scale : {1e-100, 1e-200, 1e-300}) {
      const Derivatives derivatives = evaluated(structure, coefficients, scale * .8, scale * random.get_double());
      CHECK(distance(derivatives[0], limit) < 1e-14);
      const Vector_4 approximate = direction(cross_product(derivatives[1], derivatives[2]));
      CHECK(distance(approximate, normal) < 100 * std::pow(ratio, -std::log2(scale)) + 1e-11);
      for (const Vector_4& derivative : derivatives)
        for (const double x : derivative)
          CHECK_FALSE(std::isnan(x));
    }
  }
}

TEST_CASE("the characteristic map is regular, and scales by powers of its eigenvalue", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(11);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    std::vector<Vector_4> controls;
    for (int i = 0; i < structure.number_of_controls(); ++i)
      controls.push_back({structure.right_eigenvector(1, i), structure.right_eigenvector(2, i), 0., 1.});
    std::vector<Vector_4> coefficients(controls.size(), Vector_4{});
    coefficients[1][0] = coefficients[2][1] = coefficients[0][3] = 1;
    const std::vector<Vector_4> projected = structure.project(controls);
    for (std::size_t mode = 0; mode < controls.size(); ++mode)
      CHECK(distance(projected[mode], coefficients[mode]) < 1e-12);
    const long double c = std::cos(2 * std::acos(-1.L) / n);
    const long double lambda = (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
    for (int i = 0; i < 50; ++i) {
      const double s = 1 - random.get_double() / 2, t = random.get_double();
      const Derivatives near = evaluated(structure, coefficients, s, t);
      CHECK(near[1][0] * near[2][1] - near[1][1] * near[2][0] > 0);
      const int steps = random.get_int(1, 960);
      const Derivatives far = evaluated(structure, coefficients, std::ldexp(s, -steps), std::ldexp(t, -steps));
      // A polynomial patch has no relative accuracy of the value at its zero.
      for (std::size_t d = n == 4 ? 1 : 0; d < 3; ++d) {
        // Powers of lambda and of 2 apart, as the former underflow.
        const double factor = static_cast<double>(std::pow((d == 0 ? 1 : 2) * lambda, static_cast<long double>(steps)));
        const double tolerance = 1e-12 * factor * norm(near[d]) + (std::numeric_limits<double>::min)();
        for (int k = 0; k < 2; ++k)
          CHECK(std::abs(far[d][k] - factor * near[d][k]) <= tolerance);
      }
    }
  }
}

TEST_CASE("derivatives next to the vertex keep their relative accuracy", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(13);
  for (int n = 3; n <= largest_valence; ++n) {
    const Eigenstructure structure(n);
    const CGAL::T_splines::internal::Catmull_clark_eigenstructure<long double> accurate_structure(n);
    const std::vector<Vector_4> controls = random_controls(structure.number_of_controls(), random);
    std::vector<std::array<long double, 4>> same_controls;
    for (const Vector_4& x : controls)
      same_controls.push_back({x[0], x[1], x[2], x[3]});
    const std::vector<Vector_4> coefficients = structure.project(controls);
    const auto accurate_coefficients = accurate_structure.project(same_controls);
    for (const double scale : {1e-3, 1e-50, 1e-150, 1e-300, 5e-324}) {
      const double s = scale, t = random.get_double() * scale;
      const Derivatives derivatives = evaluated(structure, coefficients, s, t);
      std::array<std::array<long double, 4>, 6> accurate;
      accurate_structure.evaluate(accurate_coefficients, s, t, 2, accurate);
      for (std::size_t d = 0; d < orders.size(); ++d) {
        const Vector_4 rounded{static_cast<double>(accurate[d][0]), static_cast<double>(accurate[d][1]),
                               static_cast<double>(accurate[d][2]), static_cast<double>(accurate[d][3])};
        if (std::isfinite(norm(rounded)))
          CHECK(distance(derivatives[d], rounded) <= 2e-14 * norm(rounded));
        for (const double x : derivatives[d])
          CHECK_FALSE(std::isnan(x));
      }
    }
  }
}

TEST_CASE("lower orders are the first entries", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(14);
  std::vector<Scalar_derivatives> all_basis, basis;
  for (const int n : {3, 4, 6}) {
    const Eigenstructure structure(n);
    const std::vector<Vector_4> coefficients =
        structure.project(random_controls(structure.number_of_controls(), random));
    const Derivatives all = evaluated(structure, coefficients, .1, .02);
    structure.basis(.1, .02, 2, all_basis);
    for (int order = 0; order < 2; ++order) {
      const std::size_t number = order == 0 ? 1 : 3;
      const Vector_4 unset{-1., -2., -3., -4.};
      Derivatives some;
      some.fill(unset);
      structure.evaluate(coefficients, .1, .02, order, some);
      structure.basis(.1, .02, order, basis);
      for (std::size_t d = 0; d < orders.size(); ++d) {
        CHECK(some[d] == (d < number ? all[d] : unset));
        for (std::size_t i = 0; i < basis.size(); ++i)
          CHECK(basis[i][d] == (d < number ? all_basis[i][d] : 0));
      }
    }
  }
}

TEST_CASE("it is the limit of CGAL's Catmull-Clark subdivision", "[Catmull_clark_eigenstructure]")
{
  CGAL::Random random(12);
  for (const int n : {3, 5, 8}) {
    Fan fan(n, 3, random);
    const Eigenstructure structure(n);
    std::vector<Vector_4> controls = fan.controls();
    const std::vector<Vector_4> coefficients = structure.project(controls);
    const int steps = 4;
    CGAL::Subdivision_method_3::CatmullClark_subdivision(fan.mesh, CGAL::parameters::number_of_iterations(steps));

    // The first edge of spoke 0 is the one that ends where the rules say.
    std::vector<double> x = component<double>(controls, 0), y = component<double>(controls, 1);
    for (int i = 0; i < steps; ++i) {
      x = Rules(n).subdivided(x);
      y = Rules(n).subdivided(y);
    }
    Fan::Mesh::Halfedge_index h = Fan::Mesh::null_halfedge();
    for (const Fan::Mesh::Halfedge_index g : fan.mesh.halfedges()) {
      const Fan::Point &p = fan.mesh.point(fan.mesh.source(g)), &q = fan.mesh.point(fan.mesh.target(g));
      if (std::hypot(p.x() - x[0], p.y() - y[0]) < 1e-9 && std::hypot(q.x() - x[1], q.y() - y[1]) < 1e-9)
        h = g;
    }
    REQUIRE(h != Fan::Mesh::null_halfedge());
    const auto straight_on = [&fan](const Fan::Mesh::Halfedge_index g) {
      return fan.mesh.next(fan.mesh.opposite(fan.mesh.next(g)));
    };
    CHECK(distance(evaluated(structure, coefficients, 0., 0.)[0], limit_position(fan.mesh.opposite(h), fan.mesh)) <
          1e-12);
    const int size = 1 << steps;
    for (int i = 1; i <= size; ++i, h = straight_on(h)) {
      Fan::Mesh::Halfedge_index g = h;
      for (int j = 0; j <= size; ++j, g = j == 1 ? fan.mesh.next(g) : straight_on(g)) {
        const Vector_4 value = evaluated(structure, coefficients, i / double(size), j / double(size))[0];
        CHECK(distance(value, limit_position(g, fan.mesh)) < 1e-12);
      }
    }
  }
}

} // namespace Catmull_clark_eigenstructure_test
