// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The places of samples are judged by walking to them along isolines, in exact arithmetic.

#include "Tracing/Traced_map.h"

#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/Tracing/internal/Isoline_walker.h>
#include <CGAL/T_splines/Tracing/sample_T_mesh.h>

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace sample_T_mesh_test {

using namespace hand_made_maps;
namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

namespace {

/// A traced map, and its samples.
template <typename TriangleMesh, typename TMesh, typename NT>
struct Sampled_map {
  using Traced = Traced_map<TriangleMesh, TMesh, NT>;
  using Point_3 = std::decay_t<decltype(get(get(CGAL::vertex_point, std::declval<const TriangleMesh&>()),
                                            typename Traced::Surface::vertex_descriptor()))>;
  using Sample = T::T_mesh_sample_of<TMesh, Point_3>;
  using Coordinates = T::T_mesh_coordinates<typename Traced::View>;

  Traced traced;
  std::vector<Sample> samples;

  template <typename... Map>
  explicit Sampled_map(const Map&... map) : traced(map...)
  {
    INFO(traced.message_text());
    REQUIRE(traced.success());
  }

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  void sample(const NamedParameters& np = CGAL::parameters::default_values())
  {
    samples.clear();
    T::sample_T_mesh(traced.map, traced.view(), boost::make_assoc_property_map(traced.anchors),
                     boost::make_assoc_property_map(traced.places), std::back_inserter(samples), np);
  }
  void sample_about(const std::size_t number) { sample(T::parameters::number_of_samples(number)); }

  Coordinates coordinates() { return T::T_mesh_coordinates(traced.view()); }

  std::vector<std::array<double, 3>> points() const { return plain_mesh(traced.mesh).points; }

  double area() const
  {
    double result = 0;
    const Plain_mesh plain = plain_mesh(traced.mesh);
    for (const auto& t : plain.triangles) {
      Kernel::Point_3 p[3];
      for (int i = 0; i < 3; ++i)
        p[i] = Kernel::Point_3(plain.points[t[i]][0], plain.points[t[i]][1], plain.points[t[i]][2]);
      result += std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
    }
    return result;
  }

  double weight() const
  {
    double result = 0;
    for (const Sample& s : samples)
      result += s.weight;
    return result;
  }
};

using Sampled = Sampled_map<Surface_mesh, Surface_mesh, Exact>;

/// The distance of a sample's point from the one that its place means: u along the bottom of the face, v upwards.
template <typename Map>
double distance_on_foot(Map& map, const std::size_t i)
{
  using Traits = T::Default_tracing_traits<Exact>;
  using Walker = T::internal::Isoline_walker<Exact, Traits>;
  const auto& sample = map.samples[i];
  const auto& anchor = map.traced.anchors.at(sample.place.face);
  const auto points = map.points();
  const auto coordinates = map.coordinates();
  const Traits traits; // the walker refers to it
  Walker walker(map.traced.map.layout(), points, traits);
  const auto origin = anchor.to_face.inverse()(Exact(0), Exact(0));
  auto stand =
      walker.stand_in_face(map.traced.map.indexing().face_index(anchor.triangle), {{origin.first, origin.second}},
                           (4 - anchor.to_face.quarter_turns()) % 4, Exact(1) / anchor.to_face.scale());
  std::vector<std::array<double, 3>> way;
  const Exact u = (std::min)(Exact(sample.place.u), Exact(coordinates.width(sample.place.face))),
              v = (std::min)(Exact(sample.place.v), Exact(coordinates.height(sample.place.face)));
  if (u != 0)
    REQUIRE(walker.walk(stand, u, way));
  walker.turn(stand, u != 0 ? -1 : 1); // after a walk, it looks back
  if (v != 0)
    REQUIRE(walker.walk(stand, v, way));
  const auto p = walker.point(stand);
  return std::sqrt(CGAL::squared_distance(sample.point, Kernel::Point_3(p[0], p[1], p[2])));
}

/// \param step every which sample is walked to
template <typename Map>
void check_samples(Map& map, const std::size_t step = 1)
{
  CHECK(map.weight() == Approx(map.area()).epsilon(1e-12));
  const auto coordinates = map.coordinates();
  int outside = 0, without_weight = 0;
  for (const auto& s : map.samples) {
    outside += !(0 <= s.place.u && s.place.u <= CGAL::to_double(coordinates.width(s.place.face)) && 0 <= s.place.v &&
                 s.place.v <= CGAL::to_double(coordinates.height(s.place.face)));
    without_weight += !(s.weight > 0);
  }
  CHECK(outside == 0);
  CHECK(without_weight == 0);
  double distance = 0;
  for (std::size_t i = 0; i < map.samples.size(); i += step)
    distance = (std::max)(distance, distance_on_foot(map, i));
  CHECK(distance < 1e-9);
  std::size_t v = 0;
  for (const auto vertex : vertices(map.traced.mesh))
    CHECK(map.samples.at(v++).point == get(CGAL::vertex_point, map.traced.mesh, vertex));
}

/// Where three vertices of a triangle have places in one face, the points inside of it lie between them.
template <typename Map>
std::size_t check_interpolation(Map& map)
{
  const auto coordinates = map.coordinates();
  const Plain_mesh plain = plain_mesh(map.traced.mesh);
  std::vector<typename Map::Sample> vertex_samples(map.samples.begin(), map.samples.begin() + plain.points.size());
  std::size_t checked = 0;
  for (std::size_t i = plain.points.size(); i < map.samples.size(); ++i) {
    const auto& s = map.samples[i];
    for (const auto& t : plain.triangles) {
      const auto &a = vertex_samples[t[0]], &b = vertex_samples[t[1]], &c = vertex_samples[t[2]];
      if (a.place.face != s.place.face || b.place.face != s.place.face || c.place.face != s.place.face)
        continue;
      const auto ab = b.point - a.point, ac = c.point - a.point, as = s.point - a.point;
      const auto normal = CGAL::cross_product(ab, ac);
      const double area = normal * normal, beta = CGAL::cross_product(as, ac) * normal / area,
                   gamma = CGAL::cross_product(ab, as) * normal / area;
      if (std::abs(as * normal) > 1e-12 * std::sqrt(area) || beta < 0 || gamma < 0 || beta + gamma > 1)
        continue;
      const double u = a.place.u + beta * (b.place.u - a.place.u) + gamma * (c.place.u - a.place.u),
                   v = a.place.v + beta * (b.place.v - a.place.v) + gamma * (c.place.v - a.place.v);
      CHECK(std::abs(u - s.place.u) < 1e-9 * CGAL::to_double(coordinates.width(s.place.face)));
      CHECK(std::abs(v - s.place.v) < 1e-9 * CGAL::to_double(coordinates.height(s.place.face)));
      ++checked;
    }
  }
  return checked;
}

std::vector<Plain_map> maps()
{
  const std::set<std::array<int, 3>> l = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}};
  std::vector<Plain_map> result = {folded(net(cube(), 1, Pattern::DIAGONALS)),
                                   folded(net(polycube(l), 2, Pattern::CROSSES)),
                                   folded(net(translation_surface(), 3, Pattern::MIXED_DIAGONALS)),
                                   folded(folded_triangle({{1, -0.0078125}}, {{0.380859375, 0.625}})),
                                   folded(folded_triangle({{1. / 64, -63. / 4096}}, {{1, 1 - 3. / 8192}})),
                                   folded(lattice_torus({{1, 0.25}}, {{-0.25, 1}}, 4, 3)),
                                   folded(bordered_l(2, Pattern::MIXED_DIAGONALS))};
  for (std::size_t i = 0; i < 4; ++i) {
    result.push_back(result[i]);
    flip_at_random(result.back(), 1000, 3);
  }
  for (const int k : {1, 2, 5, 28}) {
    const Net star = net(double_star(k), 2, Pattern::CROSSES);
    result.push_back(folded(k == 1 ? subdivided(split(star)) : star));
  }
  for (const double scale : {1.5, 2., 1 + 1. / 16})
    for (const int sectors : {1, 4, 5})
      for (const int turns : {0, 1})
        result.push_back(folded(scaled_torus(scale, sectors, turns, 4, 4)));
  return result;
}

} // namespace

TEST_CASE("Samples are where their places are, and stand for the whole area", "[sample]")
{
  for (const Plain_map& plain : maps()) {
    if (!is_simple(plain))
      continue;
    Sampled map(plain);
    map.sample_about(300);
    const std::size_t vertices = plain.points.size(), triangles = plain.triangles.size();
    CHECK(map.samples.size() + triangles >= 300);
    CHECK(map.samples.size() <= 300 + vertices + triangles);
    check_samples(map);
  }
}

TEST_CASE("The default number of samples", "[sample]")
{
  for (const int n : {1, 8}) {
    Sampled map(folded(net(cube(), n, Pattern::DIAGONALS)));
    map.sample();
    CHECK(map.samples.size() > 19500);
    CHECK(map.samples.size() < 21000);
    CHECK(map.weight() == Approx(map.area()).epsilon(1e-12));
  }
}

TEST_CASE("Few samples: the vertices of the mesh, in their places", "[sample]")
{
  Sampled map(folded(net(cube(), 4, Pattern::CROSSES)));
  map.sample_about(1);
  REQUIRE(map.samples.size() == num_vertices(map.traced.mesh));
  std::size_t i = 0;
  for (const auto v : vertices(map.traced.mesh)) {
    const auto& place = map.traced.places.at(v);
    CHECK(map.samples[i].place.face == place.face);
    CHECK(map.samples[i].place.u == CGAL::to_double(place.u));
    CHECK(map.samples[i].place.v == CGAL::to_double(place.v));
    ++i;
  }
  check_samples(map);
}

TEST_CASE("Small components have enough samples, too", "[sample]")
{
  Plain_map plain = folded(net(cube(), 1, Pattern::DIAGONALS));
  const Plain_map other = plain;
  const int number_of_vertices = static_cast<int>(plain.points.size());
  for (const std::array<double, 3>& p : other.points)
    plain.points.push_back({{10 + 0.01 * p[0], 0.01 * p[1], 0.01 * p[2]}});
  for (const std::array<int, 3>& t : other.triangles)
    plain.triangles.push_back({{t[0] + number_of_vertices, t[1] + number_of_vertices, t[2] + number_of_vertices}});
  plain.uv.insert(plain.uv.end(), other.uv.begin(), other.uv.end());
  Sampled map(plain);
  map.sample_about(2000);
  const auto in_small_cube =
      std::count_if(map.samples.begin(), map.samples.end(), [](const Sampled::Sample& s) { return s.point.x() > 5; });
  CHECK(in_small_cube > 450);
  CHECK(in_small_cube < 550);
  CHECK(map.samples.size() > 2400);
  CHECK(map.samples.size() < 2600);
  CHECK(map.weight() == Approx(map.area()).epsilon(1e-12));
}

TEST_CASE("Points inside of triangles lie between the vertices", "[sample]")
{
  const std::set<std::array<int, 3>> l = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}};
  for (const Plain_map& plain :
       {folded(net(polycube(l), 2, Pattern::CROSSES)), folded(net(cube(), 5, Pattern::CROSSES))}) {
    Sampled map(plain);
    map.sample_about(2000);
    CHECK(check_interpolation(map) > 500);
  }
}

TEST_CASE("Charts that are large against their triangles cost no digits", "[sample]")
{
  Plain_map near = folded(net(cube(), 2, Pattern::CROSSES)), far = near;
  for (auto& triangle : far.uv)
    for (auto& p : triangle) {
      p[0] += 1099511627776.;
      p[1] -= 3 * 1099511627776.;
    }
  Sampled map(near), far_map(far);
  map.sample_about(1000);
  far_map.sample_about(1000);
  REQUIRE(map.samples.size() == far_map.samples.size());
  int different = 0;
  for (std::size_t i = 0; i < map.samples.size(); ++i) {
    const auto &a = map.samples[i], &b = far_map.samples[i];
    different += a.place.face != b.place.face || std::abs(a.place.u - b.place.u) > 1e-13 ||
                 std::abs(a.place.v - b.place.v) > 1e-13 || a.point != b.point;
  }
  CHECK(different == 0);
}

TEMPLATE_TEST_CASE("Models of triangle mesh and T-mesh, and number types", "[sample]",
                   (std::tuple<Surface_mesh, Polyhedron, double>), (std::tuple<Polyhedron, Surface_mesh, Exact>),
                   (std::tuple<Polyhedron, Polyhedron, double>),
                   (std::tuple<CGAL::Surface_mesh<CGAL::Epeck::Point_3>, Surface_mesh, Exact>),
                   (std::tuple<CGAL::Polyhedron_3<CGAL::Cartesian<CGAL::Gmpq>>, Surface_mesh, double>))
{
  for (const Plain_map& plain :
       {folded(net(translation_surface(), 3, Pattern::MIXED_DIAGONALS)), folded(scaled_torus(1.5, 4, 0, 4, 4))}) {
    Sampled_map<std::tuple_element_t<0, TestType>, std::tuple_element_t<1, TestType>, std::tuple_element_t<2, TestType>>
        map(plain);
    Sampled reference(plain);
    map.sample_about(300);
    reference.sample_about(300);
    CHECK(map.weight() == Approx(map.area()).epsilon(1e-12));
    REQUIRE(map.samples.size() == reference.samples.size());
    for (std::size_t i = 0; i < map.samples.size(); ++i) {
      CHECK(map.samples[i].place.u == Approx(reference.samples[i].place.u).margin(1e-12));
      CHECK(map.samples[i].place.v == Approx(reference.samples[i].place.v).margin(1e-12));
      CHECK(map.samples[i].point == reference.samples[i].point);
    }
  }
}

TEMPLATE_TEST_CASE(
    "Other points for the vertices, of another kernel: samples have its numbers, or doubles for exact ones", "[sample]",
    CGAL::Simple_cartesian<float>, CGAL::Epeck, CGAL::Cartesian<CGAL::Gmpq>)
{
  using Point_3 = typename TestType::Point_3;
  using Sample = T::T_mesh_sample_of<Surface_mesh, Point_3>;
  STATIC_REQUIRE(std::is_same_v<typename Sample::FT,
                                std::conditional_t<std::is_same_v<typename TestType::FT, float>, float, double>>);
  Sampled map(folded(net(cube(), 2, Pattern::CROSSES)));
  map.sample_about(300);
  std::map<Surface_mesh::Vertex_index, Point_3> points;
  for (const auto v : map.traced.mesh.vertices()) {
    const auto& p = map.traced.mesh.point(v);
    points[v] = Point_3(float(2 * p.x()), float(2 * p.y()), float(2 * p.z()));
  }
  std::vector<Sample> samples;
  T::sample_T_mesh(map.traced.map, map.traced.view(), boost::make_assoc_property_map(map.traced.anchors),
                   boost::make_assoc_property_map(map.traced.places), std::back_inserter(samples),
                   T::parameters::number_of_samples(
                       300, CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points))));
  REQUIRE(samples.size() == map.samples.size());
  double weight = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto &sample = samples[i], &reference = map.samples[i];
    weight += sample.weight;
    CHECK(sample.place.face == reference.place.face);
    CHECK(sample.place.u == Approx(reference.place.u).margin(1e-6));
    CHECK(sample.place.v == Approx(reference.place.v).margin(1e-6));
    for (int axis = 0; axis < 3; ++axis)
      CHECK(sample.point[axis] == Approx(2 * reference.point[axis]).margin(1e-6));
  }
  CHECK(weight == Approx(4 * map.area()).epsilon(1e-5));
}

TEST_CASE("Samples can go right into what carries them", "[sample]")
{
  Sampled map(folded(net(cube(), 2, Pattern::CROSSES)));
  map.sample_about(300);
  T::Carried_samples<Surface_mesh, Sampled::Sample> carried;
  T::sample_T_mesh(map.traced.map, map.traced.view(), boost::make_assoc_property_map(map.traced.anchors),
                   boost::make_assoc_property_map(map.traced.places), std::back_inserter(carried),
                   T::parameters::number_of_samples(300));
  REQUIRE(carried.samples().size() == map.samples.size());
  CHECK(carried.samples().front().point == map.samples.front().point);
  CHECK(carried.samples().back().place.u == map.samples.back().place.u);
}

TEST_CASE("Triangles that no face has met continue their neighbors", "[sample]")
{
  Sampled map(folded(net(cube(), 3, Pattern::CROSSES)));
  const auto& [face, anchor] = *map.traced.anchors.begin();
  T::internal::Face_triangles<Exact> triangles(map.traced.map.layout());
  T::internal::Progress nobody;
  triangles.add_face(map.traced.map.indexing().face_index(anchor.triangle), anchor.to_face,
                     CGAL::to_double(map.coordinates().width(face)), CGAL::to_double(map.coordinates().height(face)),
                     nobody);
  const auto number_without_place = [&] {
    std::size_t result = 0;
    for (int t = 0; t < static_cast<int>(num_faces(map.traced.mesh)); ++t) {
      const auto place = triangles.place(t, {{1. / 3, 1. / 3, 1. / 3}});
      result += place.face == triangles.none ? 1 : 0;
      CHECK((place.face == triangles.none || (0 <= place.u && place.u <= 3 && 0 <= place.v && place.v <= 3)));
    }
    return result;
  };
  CHECK(number_without_place() > 100);
  triangles.complete();
  CHECK(number_without_place() == 0);
}

TEST_CASE("Fans of needles are sampled as compact triangles are", "[sample]")
{
  constexpr int needles = 2000;
  constexpr double pi = 3.14159265358979, spacing = 0.05;
  T::internal::Triangle_samples samples(spacing);
  const double base = 2 * std::sin(pi / needles), area = std::sin(2 * pi / needles) / 2;
  int number = 0, inner = 0;
  for (int i = 0; i < needles; ++i)
    for (const auto& b : samples.points({{base * base, 1, 1}}, area)) { // the first corner is the center
      ++number;
      inner += b[0] > 0.5;
      CHECK(b[0] + b[1] + b[2] == Approx(1));
      CHECK((b[0] >= 0 && b[1] >= 0 && b[2] >= 0));
    }
  CHECK(number == Approx(pi / (spacing * spacing)).epsilon(0.02));
  CHECK(inner == Approx(number / 4.).epsilon(0.1)); // the inner half of the disk's radius has a quarter of its area
}

TEST_CASE("Points inside of a compact triangle are evenly spread", "[sample]")
{
  T::internal::Triangle_samples samples(0.02);
  const double area = std::sqrt(3.) / 4;
  const auto points = samples.points({{1, 1, 1}}, area);
  CHECK(points.size() == Approx(area / 0.0004).margin(1));
  double farthest = 0;
  for (int i = 1; i < 60; ++i)
    for (int j = 1; i + j < 60; ++j) { // the distance of any place from the nearest point
      const double b = i / 60., c = j / 60.;
      double nearest = 1;
      for (const auto& p : points) {
        const double x = p[1] - b + (p[2] - c) / 2, y = (p[2] - c) * std::sqrt(3.) / 2;
        nearest = (std::min)(nearest, std::hypot(x, y));
      }
      farthest = (std::max)(farthest, nearest);
    }
  CHECK(farthest < 1.5 * 0.02);
}

TEST_CASE("Computed maps of meshes", "[sample]")
{
  Surface_mesh mesh, refined;
  std::vector<std::pair<Surface_mesh::Vertex_index, int>> cones;
  SECTION("a sphere with cones of one, two and six quarter turns")
  {
    mesh = test_meshes::face_graph<Surface_mesh>(test_meshes::sphere(2));
    for (const auto& [v, k] : {std::pair<int, int>(0, 1), {1, 2}, {2, 3}, {3, 2}, {4, 6}, {5, 2}})
      cones.emplace_back(Surface_mesh::Vertex_index(v), k);
  }
  SECTION("a slab with holes, with scale factors")
  {
    mesh = test_meshes::face_graph<Surface_mesh>(test_meshes::slab_with_holes(2, 2));
    for (const auto& [v, k] : {std::pair<int, int>(0, 5), {21, 6}, {30, 5}, {50, 8}})
      cones.emplace_back(Surface_mesh::Vertex_index(v), k);
  }
  SECTION("a mesh of CGAL")
  {
    REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/eight.off", mesh).success());
    for (const auto& [v, k] : {std::pair<int, int>(0, 5), {60, 5}, {120, 6}, {180, 5}, {300, 7}})
      cones.emplace_back(Surface_mesh::Vertex_index(v), k);
  }
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::holonomy_signature_of_cones(mesh, cones, signature).success());
  const auto uv = refined.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(T::compute_seamless_similarity_map(mesh, signature, refined, uv).success());
  Sampled_map<Surface_mesh, Surface_mesh, double> map(refined, uv);
  map.sample_about(5000);
  CHECK(map.samples.size() > 4500);
  check_samples(map, 10);
}

} // namespace sample_T_mesh_test
