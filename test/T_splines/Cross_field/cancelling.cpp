// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_visitor.h"
#include "test_meshes.h"

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/IO/read_rawfield.h>
#include <CGAL/T_splines/IO/write_rawfield.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <utility>
#include <vector>

namespace cancelling_test {

namespace {

namespace ts = CGAL::T_splines;
using Mesh = test::Surface_mesh;
using Vector_3 = test::Vector_3;
using Signature = ts::Holonomy_signature<Mesh>;
using Field = Mesh::Property_map<Mesh::Face_index, Vector_3>;

// A mesh of genus 2 with a field, and a field that nobody has written.
struct Scene {
  Mesh mesh = test::to_mesh<Mesh>(test::plate(2, 6));
  Field field = mesh.add_property_map<Mesh::Face_index, Vector_3>("f:field", Vector_3(0, 0, 0)).first;
  Field untouched = mesh.add_property_map<Mesh::Face_index, Vector_3>("f:untouched", Vector_3(7, 7, 7)).first;

  Scene() { REQUIRE(ts::compute_smooth_cross_field(mesh, field).success()); }

  void check_untouched()
  {
    for (const auto f : mesh.faces())
      if (untouched[f] != Vector_3(7, 7, 7)) {
        FAIL_CHECK("the field was written");
        return;
      }
  }
  void make_untouched()
  {
    for (const auto f : mesh.faces())
      untouched[f] = Vector_3(7, 7, 7);
  }

  Signature signature() const
  {
    Signature result;
    REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, result).success());
    return result;
  }
};

// One cone, which no function here makes.
Signature marked(const Scene& scene)
{
  Signature result;
  result.set_quarter_turns(*scene.mesh.vertices().begin(), 77);
  return result;
}

bool is_marked(const Signature& signature)
{
  return signature.cones().size() == 1 && signature.cones().front().second == 77 && signature.loops().empty();
}

} // namespace

TEST_CASE("The check of a mesh can be cancelled", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    const auto report = ts::check_triangle_mesh(scene.mesh, CGAL::parameters::visitor(visitor));
    return report.status == ts::Triangle_mesh_status::INTERRUPTED;
  });
}

TEST_CASE("A cross field that is cancelled is not written", "[cancel]")
{
  Scene scene;
  check_cancelling([&](const auto& visitor) {
    scene.make_untouched();
    const auto report = ts::compute_smooth_cross_field(scene.mesh, scene.untouched, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == ts::Smooth_cross_field_status::INTERRUPTED;
    if (is_interrupted)
      scene.check_untouched();
    return is_interrupted;
  });
}

TEST_CASE("The reading of a field that is cancelled writes nothing", "[cancel]")
{
  Scene scene;
  std::ostringstream text;
  ts::write_rawfield(text, scene.mesh, scene.field);
  check_cancelling([&](const auto& visitor) {
    scene.make_untouched();
    std::istringstream input(text.str());
    const auto report = ts::read_rawfield(input, scene.mesh, scene.untouched, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == ts::Field_file_status::INTERRUPTED;
    if (is_interrupted)
      scene.check_untouched();
    return is_interrupted;
  });
}

TEST_CASE("A signature whose computation is cancelled stays what it was", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    Signature signature = marked(scene);
    const auto report =
        ts::holonomy_signature_of_cross_field(scene.mesh, scene.field, signature, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == ts::Holonomy_signature_status::INTERRUPTED;
    CHECK(is_marked(signature) == is_interrupted);
    return is_interrupted;
  });
  const std::vector<Signature::Cone> cones = scene.signature().cones();
  check_cancelling([&](const auto& visitor) {
    Signature signature = marked(scene);
    const auto report =
        ts::holonomy_signature_of_cones(scene.mesh, cones, signature, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == ts::Holonomy_signature_status::INTERRUPTED;
    CHECK(is_marked(signature) == is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("The check of a signature can be cancelled", "[cancel]")
{
  const Scene scene;
  const Signature signature = scene.signature();
  check_cancelling([&](const auto& visitor) {
    const auto report = ts::check_holonomy_signature(scene.mesh, signature, CGAL::parameters::visitor(visitor));
    return report.status == ts::Holonomy_signature_status::INTERRUPTED;
  });
}

TEST_CASE("A signature whose reduction is cancelled stays what it was", "[cancel]")
{
  const Scene scene;
  const Signature before = scene.signature();
  check_cancelling([&](const auto& visitor) {
    Signature signature = before;
    const auto report = ts::reduce_cones(
        scene.mesh, signature, ts::parameters::maximum_number_of_cones(4, CGAL::parameters::visitor(visitor)));
    const bool is_interrupted = report.status == ts::Cone_reduction_status::INTERRUPTED;
    if (is_interrupted) {
      CHECK(signature.cones() == before.cones());
      for (std::size_t i = 0; i < before.loops().size(); ++i)
        CHECK(signature.loops()[i].quarter_turns == before.loops()[i].quarter_turns);
    }
    else
      CHECK(signature.cones().size() <= 4);
    return is_interrupted;
  });
}

} // namespace cancelling_test
