// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/Carried_samples.h>

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>

#include "T_mesh/Development.h"
#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace Carried_samples_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;

// A T-mesh of squares, whose number i has the unit i + 1, and samples in a grid of each: corners, sides and inside.
template <typename Graph, typename NT>
class Scene {
public:
  using Mesh = test_t_meshes::T_mesh<Graph, Rational>;
  using Development = test_t_meshes::Development<Graph, Rational>;
  using Sample = test_t_meshes::Developed_sample<Graph, NT>;
  using Samples = T::Carried_samples<Graph, Sample>;
  using Observer = T::T_mesh_observer_pair<typename Development::Observer, typename Samples::Observer>;
  using Editor = T::T_mesh_editor<T::T_mesh_view_of<Mesh>, Observer>;

  explicit Scene(const test_t_meshes::Faces<Rational>& faces)
    : mesh(faces),
      editor(mesh, Observer(development.observer(), samples.observer()))
  {
    constexpr int n = 6;
    for (std::size_t s = 0; s < mesh.face_list.size(); ++s) {
      const int unit = static_cast<int>(s) + 1;
      development.set(mesh.face_list[s], {0, Rational(1) / unit, 0, 0});
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          samples.push_back({{mesh.face_list[s], NT(unit * i) / NT(n), NT(unit * j) / NT(n)}, {NT(i) / n, NT(j) / n}});
    }
    given = std::as_const(samples).samples();
  }

  void split_randomly(const int number, const int seed)
  {
    CGAL::Random random(seed);
    for (int i = 0; i < number; ++i) {
      const auto range = faces(mesh.mesh);
      const std::vector<typename Mesh::face_descriptor> list(range.begin(), range.end());
      const auto f = list[random.get_int(0, static_cast<int>(list.size()))];
      const int axis = random.get_int(0, 2);
      const Rational size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
      editor.split_face(f, axis, Rational(size * random.get_int(1, 7) / 7));
    }
  }

  void regularize()
  {
    T::regularize_T_mesh(mesh, T::parameters::observer(Observer(development.observer(), samples.observer())));
  }

  bool has_order_of_samples() const
  {
    const auto& now = samples.samples();
    return std::equal(now.begin(), now.end(), given.begin(), given.end(),
                      [](const Sample& s, const Sample& t) { return s.position == t.position; });
  }

  Mesh mesh;
  Development development;
  Samples samples;
  std::vector<Sample> given;
  Editor editor;
};

} // namespace

TEMPLATE_TEST_CASE("Exact samples keep their places and their order while a T-mesh changes", "[Carried_samples]",
                   Surface_mesh, Polyhedron)
{
  Scene<TestType, Rational> scene(test_t_meshes::genus_two<Rational>());
  const test_t_meshes::Lattice_group lattice;
  CHECK(samples_stay(scene.samples, scene.editor.coordinates(), scene.development, lattice));
  for (int round = 0; round < 3; ++round) {
    scene.split_randomly(60, round);
    CHECK(samples_stay(scene.samples, scene.editor.coordinates(), scene.development, lattice));
    scene.regularize();
    CHECK(samples_stay(scene.samples, scene.editor.coordinates(), scene.development, lattice));
    CHECK(scene.has_order_of_samples());
  }
}

TEST_CASE("Samples in doubles stay in closed rectangles, at their places up to round-off", "[Carried_samples]")
{
  Scene<Surface_mesh, double> scene(test_t_meshes::cube<Rational>());
  for (int round = 0; round < 5; ++round) {
    scene.split_randomly(100, round);
    scene.regularize();
  }
  CHECK(scene.has_order_of_samples());
  const auto distance_to_integer = [](const double x) { return std::abs(x - std::round(x)); };
  for (const auto& sample : std::as_const(scene.samples).samples()) {
    const auto f = sample.place.face;
    CHECK((0 <= sample.place.u && sample.place.u <= CGAL::to_double(scene.editor.coordinates().width(f))));
    CHECK((0 <= sample.place.v && sample.place.v <= CGAL::to_double(scene.editor.coordinates().height(f))));
    // Equal up to quarter turns and integers.
    auto p = scene.development.of(f)(Rational(sample.place.u), Rational(sample.place.v));
    double distance = 1;
    for (int r = 0; r < 4; ++r, p = std::make_pair(Rational(-p.second), p.first))
      distance =
          (std::min)(distance, (std::max)(distance_to_integer(CGAL::to_double(p.first) - sample.position.first),
                                          distance_to_integer(CGAL::to_double(p.second) - sample.position.second)));
    CHECK(distance < 1e-12);
  }
}

TEST_CASE("Samples whose places were changed, and new ones, go along from where they are", "[Carried_samples]")
{
  using Exact_scene = Scene<Surface_mesh, Rational>;
  Exact_scene scene(test_t_meshes::cube<Rational>());
  const test_t_meshes::Lattice_group lattice;
  scene.split_randomly(50, 1);
  // As a fit does: each goes to the middle of the next face.
  std::vector<Surface_mesh::Face_index> faces(scene.mesh.mesh.faces().begin(), scene.mesh.mesh.faces().end());
  const auto sample_in = [&](const Surface_mesh::Face_index f) {
    const Rational u = scene.editor.coordinates().width(f) / 2, v = scene.editor.coordinates().height(f) / 2;
    return Exact_scene::Sample{{f, u, v}, scene.development.of(f)(u, v)};
  };
  for (auto& sample : scene.samples.samples()) {
    const auto next = std::find(faces.begin(), faces.end(), sample.place.face) + 1;
    sample = sample_in(next == faces.end() ? faces.front() : *next);
  }
  CHECK(samples_stay(scene.samples, scene.editor.coordinates(), scene.development, lattice));
  for (const auto f : faces)
    scene.samples.push_back(sample_in(f));
  const std::size_t number = std::as_const(scene.samples).samples().size();
  scene.split_randomly(50, 2);
  scene.regularize();
  CHECK(samples_stay(scene.samples, scene.editor.coordinates(), scene.development, lattice));
  CHECK(std::as_const(scene.samples).samples().size() == number);
}

TEST_CASE("A copy stays as it is", "[Carried_samples]")
{
  Scene<Surface_mesh, Rational> scene(test_t_meshes::cube<Rational>());
  const auto copy = scene.samples;
  scene.split_randomly(20, 3);
  const auto& samples = copy.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    CHECK(samples[i].place.face == scene.given[i].place.face);
    CHECK(samples[i].place.u == scene.given[i].place.u);
  }
}

TEST_CASE("Samples come from a vector or through an iterator, and faces without samples have none", "[Carried_samples]")
{
  using Sample = T::T_mesh_sample<Surface_mesh, Kernel>;
  using Samples = T::Carried_samples<Surface_mesh, Sample>;
  const Surface_mesh::Face_index a(0), b(1);
  const std::vector<Sample> given(3, Sample{{a, 0.5, 0.5}, {1, 2, 3}, 1});
  const Samples taken_over(given);
  Samples added;
  std::copy(given.begin(), given.end(), std::back_inserter(added));
  for (const Samples& samples : {taken_over, added}) {
    CHECK(samples.samples().size() == 3);
    CHECK(samples.samples_in_face(a) == std::vector<std::size_t>{0, 1, 2});
    CHECK(samples.samples_in_face(b).empty());
  }
}

} // namespace Carried_samples_test
