// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/insert_knot_line.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/T_mesh/Carried_samples.h>

#include "Spline/Planar_t_mesh.h"
#include "Spline/Spline_mesh.h"

#include <CGAL/Polyhedron_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace insert_knot_line_test {

namespace {

using namespace spline_tests;
using CGAL::T_splines::insert_knot_line;
using Status = CGAL::T_splines::Knot_insertion_status;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Double_mesh = Spline_mesh<double>;
using Mesh = Spline_mesh<Rational>;
using Exact_mesh = Spline_mesh<Rational, Exact_kernel>;

template <typename Mesh>
std::string text(Mesh& t)
{
  std::ostringstream out;
  CGAL::T_splines::write_t_mesh(out, t);
  out.precision(17);
  for (const auto v : vertices(t.mesh))
    out << t.control(v) << "\n";
  return out.str();
}

// A surface with samples of it, at the places where they are as the T-mesh changes.
template <typename Mesh>
class Marked_surface {
  using Number = typename Mesh::Number;
  struct Sample {
    CGAL::T_splines::T_mesh_place<typename Mesh::Graph, Number> place;
    typename Mesh::Point_3 point;
  };
  using Samples = CGAL::T_splines::Carried_samples<typename Mesh::Graph, Sample>;
  using Face = typename Mesh::face_descriptor;
  static constexpr bool is_exact = !std::is_same<Number, double>::value;

public:
  Marked_surface(Mesh& t, const int points_per_face, CGAL::Random& random) : m_t(t)
  {
    const auto surface = t.surface();
    REQUIRE(surface.is_valid());
    const auto coordinate = [&] { return Number(Number(random.get_int(0, 65)) / Number(64)); };
    for (const auto f : faces(t.mesh))
      for (int i = 0; i < points_per_face; ++i) {
        const Number u = surface.width(f) * coordinate(), v = surface.height(f) * coordinate();
        m_samples.push_back({{f, u, v}, surface.position(f, u, v)});
      }
  }

  // At so many eighths of the face. Checks what must hold, however it ends.
  CGAL::T_splines::Knot_insertion_report<typename Mesh::Graph> insert(const Face f, const int axis, const int eighths)
  {
    const CGAL::T_splines::T_mesh_coordinates coordinates(m_t);
    const typename Mesh::FT size = axis == 0 ? coordinates.width(f) : coordinates.height(f);
    const std::string before = text(m_t);
    const std::size_t vertices_before = num_vertices(m_t.mesh);
    const auto report = insert_knot_line(m_t, m_t.controls(), f, axis, typename Mesh::FT(size * eighths / 8),
                                         CGAL::T_splines::parameters::observer(m_samples.observer()));
    ++m_count[report.status];
    const std::size_t vertices_after = std::distance(vertices(m_t.mesh).begin(), vertices(m_t.mesh).end());
    CHECK(vertices_after == vertices_before + report.inserted_vertices);
    CHECK((report.inserted_vertices > 0) == report.success());
    if (report)
      check();
    else {
      CHECK(text(m_t) == before);
      check_names(report);
    }
    return report;
  }

  void insert_randomly(const int number, CGAL::Random& random)
  {
    for (int i = 0; i < number; ++i) {
      const auto range = faces(m_t.mesh);
      const std::vector<Face> list(range.begin(), range.end());
      const Face f = list[random.get_int(0, static_cast<int>(list.size()))];
      const int axis = random.get_int(0, 2);
      insert(f, axis, random.get_int(1, 8));
    }
  }

  // How often a line ended so.
  int count(const Status status) const
  {
    const auto found = m_count.find(status);
    return found == m_count.end() ? 0 : found->second;
  }

private:
  void check() const
  {
    const auto compatibility = CGAL::T_splines::check_spline_compatibility(m_t);
    INFO(message(compatibility.status));
    REQUIRE(compatibility);
    const Number worst = difference();
    if constexpr (is_exact)
      CHECK(worst == Number(0));
    else
      CHECK(worst < 1e-12);
  }

  template <typename Report>
  void check_names(const Report& report) const
  {
    switch (report.status) {
    case Status::NOT_CONFORMING: CHECK(degree(report.face, m_t.mesh) > 4); break;
    case Status::LINE_MEETS_ITSELF: CHECK(degree(report.face, m_t.mesh) == 4); break;
    case Status::NEAR_CREASE: CHECK(report.vertex != boost::graph_traits<typename Mesh::Graph>::null_vertex()); break;
    case Status::AT_EXTRAORDINARY_VERTEX:
      CHECK((CGAL::T_splines::is_extraordinary(report.vertex, m_t) || has_crease(report.vertex)));
      break;
    default: FAIL(message(report.status));
    }
  }

  template <typename Vertex>
  bool has_crease(const Vertex v) const
  {
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, m_t.mesh), m_t.mesh))
      if (get(m_t.creases(), edge(h, m_t.mesh)))
        return true;
    return false;
  }

  // The largest one of a coordinate.
  Number difference() const
  {
    const auto surface = m_t.surface();
    REQUIRE(surface.is_valid());
    Number result(0);
    for (const Sample& sample : m_samples.samples()) {
      const auto p = surface.position(sample.place.face, sample.place.u, sample.place.v);
      for (int i = 0; i < 3; ++i)
        result = (std::max)(result, Number(CGAL::abs(Number(p[i] - sample.point[i]))));
    }
    return result;
  }

  Mesh& m_t;
  Samples m_samples;
  std::map<Status, int> m_count;
};

// The line x = p[0] of the plane if `axis` is 0, y = p[1] if it is 1. \pre the mesh is as `plane` made it
template <typename Mesh>
auto insert_in_plane(Mesh& t, Marked_surface<Mesh>& surface, const Planar_t_mesh& plane, const int axis,
                     const Position& p)
{
  const std::size_t i = plane.rectangle_at(p);
  const Planar_t_mesh::Rectangle& r = plane.rectangles()[i];
  const int part = static_cast<int>(8 * (p[axis] - r.low[axis]) / (r.high[axis] - r.low[axis]));
  // The frame's axis along that of the plane has its direction, or the opposite one.
  const bool is_reversed = axis == 0 ? r.turns == 1 || r.turns == 2 : r.turns >= 2;
  return surface.insert(t.face_list[i], (axis + r.turns) % 2, is_reversed ? 8 - part : part);
}

template <typename Mesh>
void prepare(Mesh& t, CGAL::Random& random)
{
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
}

// Cuts each square into four, several times.
template <typename Mesh>
void cut_squares(Mesh& t, const int times)
{
  typename Mesh::Editor editor(t);
  for (int i = 0; i < 2 * times; ++i) {
    const auto range = faces(t.mesh);
    for (const auto f : std::vector<typename Mesh::face_descriptor>(range.begin(), range.end())) {
      const typename Mesh::FT width = editor.coordinates().width(f), height = editor.coordinates().height(f);
      const int axis = width < height ? 1 : 0;
      editor.split_face(f, axis, typename Mesh::FT((axis == 0 ? width : height) / 2));
    }
  }
}

// Makes so many edges creases, from a halfedge straight on, up to where it turns.
template <typename Mesh>
void add_crease(const Mesh& t, typename Mesh::halfedge_descriptor h, const int number)
{
  for (int i = 0; i < number; ++i) {
    put(t.creases(), edge(h, t.mesh), true);
    const auto o = opposite(next(h, t.mesh), t.mesh);
    if (is_border(h, t.mesh) || is_border(o, t.mesh))
      return;
    h = next(o, t.mesh);
  }
}

// A torus with two slits; each side of one is glued to a side of the other, which is twice as long: a surface of genus
// 2 with two cones of eight quarter turns. Loops through a slit scale by 2, and turn if the second slit is orthogonal
// to the first one.
struct Torus_with_slits {
  explicit Torus_with_slits(const bool is_turned)
    : turns(is_turned),
      columns(is_turned ? 22 : 16),
      rows(is_turned ? 22 : 28)
  {
  }

  int square(const int column, const int row) const { return columns * row + column; }

  // The first slit has the rows 3 to 10 of the column line 4.
  template <typename FT>
  Faces<FT> faces() const
  {
    Faces<FT> result;
    const auto edge = [&](const int i, const int j) { return 2 * square(i % columns, j % rows); };
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const FT width(i < 8 ? 1 : 2), height(j < 14 ? 1 : 2);
        result.push_back({{edge(i, j) + 1, width, true},
                          {edge(i + 1, j), height, true},
                          {edge(i, j + 1) + 1, width, true},
                          {edge(i, j), height, true}});
      }
    for (int k = 3; k <= 10; ++k)
      std::swap(result[square(4, k)][3].edge,
                turns ? result[square(21 - k, 18)][0].edge : result[square(12, 14 + k)][3].edge);
    for (std::size_t f = 0; f < result.size(); ++f)
      test_t_meshes::rescale(result[f], FT(static_cast<int>(f % 5 + 1)));
    return result;
  }

  bool turns;
  int columns, rows;
};

} // namespace

TEST_CASE("a line in a grid with nonuniform knots and many units changes nothing, exactly", "[insert_knot_line]")
{
  CGAL::Random random(1);
  const bool is_periodic = GENERATE(true, false);
  const std::vector<double> x{0, 1, 3, 3.5, 5, 8}, y{0, 2, 3, 5, 5.25, 6};
  for (const int axis : {0, 1})
    for (std::size_t i = 0; i < 5; ++i) { // without periods, the first and the last column are at the border
      INFO("axis " << axis << ", column " << i);
      Planar_t_mesh plane(x, y, is_periodic);
      plane.set_random_frames(random);
      Exact_mesh t(plane.faces<Rational>());
      t.set_random_controls(random);
      Marked_surface<Exact_mesh> surface(t, 8, random);
      Position p{0.5, 0.5};
      const std::vector<double>& along = axis == 0 ? x : y;
      p[axis] = along[i] + 0.375 * (along[i + 1] - along[i]);
      const auto report = insert_in_plane(t, surface, plane, axis, p);
      CHECK(report);
      CHECK(report.inserted_vertices == (is_periodic ? 5 : 6));
    }
}

TEST_CASE("where supports overlap themselves, the surface does not change either", "[insert_knot_line]")
{
  CGAL::Random random(12);
  // The columns must be different faces, and so must the rows of the columns.
  Planar_t_mesh plane({0, 1, 3, 3.5}, {0, 2}, true);
  plane.set_random_frames(random);
  Exact_mesh t(plane.faces<Rational>());
  t.set_random_controls(random);
  Marked_surface<Exact_mesh> surface(t, 8, random);
  CHECK(insert_in_plane(t, surface, plane, 1, {0.5, 0.75}).status == Status::LINE_MEETS_ITSELF);
  const auto report = insert_in_plane(t, surface, plane, 0, {1.5, 0.5});
  CHECK(report);
  CHECK(report.inserted_vertices == 1);
  CHECK(CGAL::T_splines::check_spline_compatibility(t).self_overlapping_supports == 4);
}

TEST_CASE("lines between two borders that are close", "[insert_knot_line]")
{
  CGAL::Random random(2);
  for (const int columns : {3, 4, 5})
    for (const bool is_closed : {false, true}) {
      Exact_mesh t(is_closed ? test_t_meshes::cylinder<Rational>(4, columns)
                             : test_t_meshes::rectangle<Rational>(columns, 3));
      t.set_random_controls(random);
      Marked_surface<Exact_mesh> surface(t, 6, random);
      surface.insert_randomly(6, random);
      CHECK(surface.count(Status::INSERTED) == 6);
    }
}

TEST_CASE("T-joints beyond the columns do not matter, those within do", "[insert_knot_line]")
{
  CGAL::Random random(3);
  const std::vector<double> x{0, 1, 2, 3, 4, 5, 6, 8, 9}, y{0, 1, 2, 3, 4, 5, 7};
  const auto insert = [&](const std::size_t column, const int axis, const double cut) {
    Planar_t_mesh plane(x, y, true);
    plane.split(plane.rectangle_at({column + 0.5, 2.5}), axis, cut);
    plane.set_random_frames(random);
    Exact_mesh t(plane.faces<Rational>());
    t.set_random_controls(random);
    Marked_surface<Exact_mesh> surface(t, 6, random);
    return insert_in_plane(t, surface, plane, 0, {3.375, 0.5}).status;
  };
  // The columns are [2, 3], [3, 4], [4, 5].
  for (const std::size_t column : {2, 3, 4}) {
    CHECK(insert(column, 0, column + 0.5) == Status::NOT_CONFORMING);
    CHECK(insert(column, 1, 2.5) == Status::NOT_CONFORMING);
  }
  for (const std::size_t column : {1, 5}) {
    CHECK(insert(column, 0, column + 0.5) == Status::INSERTED); // the outer knots differ from row to row
    CHECK(insert(column, 1, 2.5) == Status::NOT_CONFORMING);    // T-joints on the outer side of the columns
  }
  CHECK(insert(0, 1, 2.5) == Status::INSERTED);
  CHECK(insert(6, 1, 2.5) == Status::INSERTED);
}

TEST_CASE("random lines in random T-meshes", "[insert_knot_line]")
{
  CGAL::Random random(4);
  int inserted = 0, refused = 0;
  for (const bool is_periodic : {true, false})
    for (int i = 0; i < 4; ++i) {
      Planar_t_mesh plane({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, is_periodic);
      plane.split_randomly(1 + i, random);
      plane.set_random_frames(random);
      Double_mesh t(plane.faces<double>());
      t.set_random_controls(random);
      Marked_surface<Double_mesh> surface(t, 4, random);
      surface.insert_randomly(12, random);
      inserted += surface.count(Status::INSERTED);
      refused += surface.count(Status::NOT_CONFORMING);
    }
  CHECK(inserted > 20);
  CHECK(refused > 20);
}

TEMPLATE_TEST_CASE("lines keep away from the rings of extraordinary vertices, or run along them", "[insert_knot_line]",
                   Mesh, Double_mesh, (Spline_mesh<double, Kernel, Polyhedron>))
{
  CGAL::Random random(5);
  TestType t(test_t_meshes::cube<typename TestType::FT>());
  cut_squares(t, 3);
  prepare(t, random);
  Marked_surface<TestType> surface(t, 3, random);
  // The columns 3 and 4 of a side of the cube are outside of all rings.
  const auto f = t.face_list[0];
  const auto row = [&](const int number) { // a face in the first column, which has kept the descriptor
    auto h = halfedge(f, t.mesh);
    for (int i = 0; i < number; ++i)
      h = opposite(next(next(h, t.mesh), t.mesh), t.mesh);
    return face(h, t.mesh);
  };
  const int axis = 1; // from one side of the face to the other, and around the cube
  const auto refused = surface.insert(row(2), axis, 3);
  CHECK(refused.status == Status::AT_EXTRAORDINARY_VERTEX);
  const auto report = surface.insert(row(3), axis, 3);
  CHECK(report);
  CHECK(report.inserted_vertices == 32);
  surface.insert_randomly(4, random);
  CHECK(surface.count(Status::AT_EXTRAORDINARY_VERTEX) > 2);
}

TEST_CASE("around cones with another holonomy", "[insert_knot_line]")
{
  CGAL::Random random(6);
  for (const int sectors : {3, 5}) {
    Double_mesh t(test_t_meshes::star<double>(sectors, 7));
    prepare(t, random);
    Marked_surface<Double_mesh> surface(t, 3, random);
    surface.insert_randomly(16, random);
    CHECK(surface.count(Status::INSERTED) > 2);
    CHECK(surface.count(Status::AT_EXTRAORDINARY_VERTEX) > 1);
  }
}

TEST_CASE("around corners of the border that turn inwards", "[insert_knot_line]")
{
  CGAL::Random random(6);
  for (const int quarters : {3, 4}) {
    Exact_mesh t(test_t_meshes::fan<Rational>(quarters, 8));
    t.set_random_controls(random);
    Marked_surface<Exact_mesh> surface(t, 3, random);
    CHECK(surface.insert(t.face_list[3], 0, 3).status == Status::AT_EXTRAORDINARY_VERTEX);
    CHECK(surface.insert(t.face_list[4], 0, 3).status == Status::INSERTED);
    surface.insert_randomly(16, random);
    CHECK(surface.count(Status::INSERTED) > 4);
    CHECK(surface.count(Status::AT_EXTRAORDINARY_VERTEX) > 1);
  }
}

TEST_CASE("a line along the third ring changes nothing, exactly", "[insert_knot_line]")
{
  CGAL::Random random(12);
  Exact_mesh t(test_t_meshes::star<Rational>(3, 7));
  t.set_random_controls(random);
  Marked_surface<Exact_mesh> surface(t, 1, random);
  CHECK(surface.insert(t.face_list[2], 0, 3).status == Status::AT_EXTRAORDINARY_VERTEX);
  const auto report = surface.insert(t.face_list[3], 0, 3);
  CHECK(report);
  CHECK(report.inserted_vertices == 15);
}

TEST_CASE("lines on a surface where loops scale and turn", "[insert_knot_line]")
{
  CGAL::Random random(7);
  for (const bool turns : {false, true}) {
    const Torus_with_slits torus(turns);
    Double_mesh t(torus.faces<double>());
    t.set_random_controls(random);
    Marked_surface<Double_mesh> surface(t, 2, random);
    const auto insert = [&](const int column, const int row, const int axis) {
      return surface.insert(t.face_list[torus.square(column, row)], axis, 3);
    };
    // Through the slits: from columns and rows of width 1 to those of width 2, and back.
    CHECK(insert(2, 5, 1).status == Status::AT_EXTRAORDINARY_VERTEX);
    const auto through = insert(2, 6, 1);
    if (turns)
      CHECK(through.status == Status::LINE_MEETS_ITSELF); // it comes back orthogonally
    else {
      CHECK(through);
      CHECK(through.inserted_vertices == 32); // two rows of 16 columns
    }
    // Beside them.
    const auto beside = insert(0, 6, 0);
    CHECK(beside);
    CHECK(int(beside.inserted_vertices) == torus.rows + (turns ? 0 : 2));
  }
}

TEST_CASE("lines across creases and beside them change nothing, exactly", "[insert_knot_line]")
{
  CGAL::Random random(14);
  for (const int cuts : {0, 1, 2}) { // between creases one interval suffices
    Exact_mesh t(test_t_meshes::cube<Rational>());
    for (const auto e : edges(t.mesh))
      put(t.creases(), e, true);
    cut_squares(t, cuts);
    prepare(t, random);
    Marked_surface<Exact_mesh> surface(t, 6, random);
    surface.insert_randomly(4, random);
    CHECK(surface.count(Status::INSERTED) == 4);
  }
}

TEST_CASE("lines beside places where creases end at others", "[insert_knot_line]")
{
  CGAL::Random random(15);
  // The lines y = 0 and y = 4 are creases, and x = 4 from one to the other.
  Planar_t_mesh plane({0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 2, 3, 4, 5, 6, 7, 8}, true);
  const auto insert = [&](const int axis, const Position& p) {
    Exact_mesh t(plane.faces<Rational>());
    for (int i = 0; i < 8; ++i) {
      add_crease(t, t.halfedge_of(plane.rectangle_at({i + 0.5, 0.5}), 0), 1);
      add_crease(t, t.halfedge_of(plane.rectangle_at({i + 0.5, 4.5}), 0), 1);
    }
    for (int i = 0; i < 4; ++i)
      add_crease(t, t.halfedge_of(plane.rectangle_at({4.5, i + 0.5}), 3), 1);
    t.set_random_controls(random);
    Marked_surface<Exact_mesh> surface(t, 3, random);
    return insert_in_plane(t, surface, plane, axis, p).status;
  };
  for (const double y : {0.5, 1.5, 2.5, 3.5}) // across x = 4
    CHECK(insert(1, {0.5, y}) == Status::INSERTED);
  for (const double y : {4.5, 5.5, 6.5, 7.5}) // beyond, where y = 0 and y = 4 end and the surface goes straight on
    CHECK(insert(1, {0.5, y}) == Status::NEAR_CREASE);
  for (const double x : {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5}) // along x = 4, which ends
    CHECK(insert(0, {x, 0.5}) == Status::INSERTED);
}

TEST_CASE("lines are refused where one beside them ends at a crease", "[insert_knot_line]")
{
  CGAL::Random random(16);
  // A border along x = 0 and x = 8, y = 0 and y = 8, and the crease y = 4.
  Planar_t_mesh plane({0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 2, 3, 4, 5, 6, 7, 8}, false);
  const auto insert = [&](const int axis, const Position& p) {
    Exact_mesh t(plane.faces<Rational>());
    for (int i = 0; i < 8; ++i)
      add_crease(t, t.halfedge_of(plane.rectangle_at({i + 0.5, 4.5}), 0), 1);
    REQUIRE(t.make_spline_compatible());
    t.set_random_controls(random);
    Marked_surface<Exact_mesh> surface(t, 3, random);
    return insert_in_plane(t, surface, plane, axis, p).status;
  };
  for (const double x : {0.5, 1.5, 6.5, 7.5}) // the border is no natural end for lines along the crease, nor beside it
    CHECK(insert(0, {x, 0.5}) == Status::NEAR_CREASE);
  for (const double x : {2.5, 3.5, 4.5, 5.5})
    CHECK(insert(0, {x, 0.5}) == Status::INSERTED);
  for (const double y : {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5})
    CHECK(insert(1, {0.5, y}) == Status::INSERTED);
}

TEST_CASE("random lines with random creases", "[insert_knot_line]")
{
  CGAL::Random random(17);
  int inserted = 0;
  for (const bool is_periodic : {true, false})
    for (int i = 0; i < 10; ++i) {
      Planar_t_mesh plane({0, 1, 2, 3.5, 4, 5, 6, 7.5, 8, 9}, {0, 1, 1.5, 3, 4, 5, 5.5, 7}, is_periodic);
      plane.set_random_frames(random);
      Exact_mesh t(plane.faces<Rational>());
      for (int k = 0; k < 1 + i % 5; ++k) {
        const auto f = t.face_list[random.get_int(0, static_cast<int>(t.face_list.size()))];
        auto h = halfedge(f, t.mesh);
        for (int turns = random.get_int(0, 4); turns > 0; --turns)
          h = next(h, t.mesh);
        add_crease(t, h, i % 2 == 0 ? 10 : random.get_int(1, 10));
        add_crease(t, opposite(h, t.mesh), i % 2 == 0 ? 10 : 1);
      }
      prepare(t, random);
      Marked_surface<Exact_mesh> surface(t, 2, random);
      surface.insert_randomly(15, random);
      inserted += surface.count(Status::INSERTED);
    }
  CHECK(inserted > 60);
}

TEST_CASE("a line that comes back beside itself is refused", "[insert_knot_line]")
{
  CGAL::Random random(8);
  // Upwards one comes back shifted by one column.
  Mesh t(test_t_meshes::torus<Rational>(6, 5));
  t.set_random_controls(random);
  Marked_surface<Mesh> surface(t, 3, random);
  CHECK(surface.insert(t.face_list[0], 0, 3).status == Status::LINE_MEETS_ITSELF);
  CHECK(surface.insert(t.face_list[0], 1, 3));
}

TEST_CASE("many lines, one after the other", "[insert_knot_line]")
{
  CGAL::Random random(9);
  const bool is_periodic = GENERATE(true, false);
  Planar_t_mesh plane({0, 1, 2, 4, 5}, {0, 1, 1.5, 2, 3}, is_periodic);
  plane.set_random_frames(random);
  Double_mesh t(plane.faces<double>());
  t.set_random_controls(random);
  Marked_surface<Double_mesh> surface(t, 40, random);
  surface.insert_randomly(25, random);
  CHECK(surface.count(Status::INSERTED) == 25);
}

TEST_CASE("lines close to others, in doubles", "[insert_knot_line]")
{
  CGAL::Random random(13);
  Planar_t_mesh plane({0, 1, 2, 4, 5}, {0, 1, 1.5, 2, 3}, true);
  plane.set_random_frames(random);
  for (const double part : {2e-6, 1 - 2e-6}) {
    Double_mesh t(plane.faces<double>());
    t.set_random_controls(random);
    for (int i = 0; i < 3; ++i) {
      const Double_mesh::Editor editor(t);
      const auto f = t.face_list[0];
      const double x = part * editor.coordinates().width(f);
      CHECK(insert_knot_line(t, t.controls(), f, 0, x));
      CHECK(CGAL::T_splines::check_spline_compatibility(t));
    }
  }
}

TEST_CASE("control points without weights", "[insert_knot_line]")
{
  CGAL::Random random(10);
  Double_mesh t(test_t_meshes::rectangle<double>(4, 5));
  auto points = t.mesh.points();
  for (const auto v : vertices(t.mesh))
    put(points, v, Kernel::Point_3(random.get_double(), random.get_double(), random.get_double()));
  using Surface =
      CGAL::T_splines::T_spline_surface<CGAL::T_splines::Const_T_mesh_view_of<Double_mesh>, decltype(points)>;
  const auto f = t.face_list[5]; // of unit 6; the line leaves the lower half to it
  const auto position = [&] { return Surface(t, points).position(f, 1.5, 2.5); };
  const Kernel::Point_3 before = position();
  CHECK(insert_knot_line(t, points, f, 1, 3.));
  CHECK(t.mesh.number_of_faces() == 24);
  CHECK(std::sqrt(CGAL::squared_distance(position(), before)) < 1e-14);
}

TEST_CASE("what is wrong from the beginning is named", "[insert_knot_line]")
{
  CGAL::Random random(11);
  Double_mesh t(test_t_meshes::rectangle<double>(4, 4));
  t.set_random_controls(random);
  const auto f = t.face_list[4]; // of unit 5
  const auto insert = [&](const double x) {
    const std::string before = text(t);
    const auto report = insert_knot_line(t, t.controls(), f, 0, x);
    CHECK(text(t) == before);
    return report;
  };
  for (const double x : {0., 5., -1., 6., 4e-6, 5 - 4e-6, std::numeric_limits<double>::quiet_NaN()})
    CHECK(insert(x).status == Status::OUTSIDE);

  SECTION("a weight")
  {
    const auto v = source(t.halfedge_of(5, 0), t.mesh);
    for (const double weight :
         {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      t.set_control(v, Kernel::Point_3(1, 2, 3), weight);
      const auto report = insert_knot_line(t, t.controls(), f, 0, 2.);
      CHECK(report.status == Status::WEIGHT_NOT_POSITIVE);
      CHECK(report.vertex == v);
      CHECK(num_vertices(t.mesh) == 25);
    }
  }

  SECTION("the T-mesh")
  {
    put(t.knots(), t.halfedge_of(4, 0), 7.);
    const auto report = insert(2);
    CHECK(report.status == Status::NOT_SPLINE_COMPATIBLE);
    CHECK(report.compatibility.status == CGAL::T_splines::Spline_compatibility_status::INADMISSIBLE);
    CHECK(report.compatibility.face == f);
  }
}

} // namespace insert_knot_line_test
