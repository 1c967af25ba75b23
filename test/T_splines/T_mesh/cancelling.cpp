// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_visitor.h"
#include "Spline/Carried_box.h"

#include <CGAL/T_splines/T_mesh/Carried_anchors.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/T_mesh/grade_T_mesh.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/place_T_mesh.h>
#include <CGAL/T_splines/Tracing/sample_T_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <catch2/catch.hpp>

#include <iterator>
#include <string>
#include <vector>

namespace cancelling_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Box = spline_tests::Carried_box;
using Mesh = Box::Mesh;
using FT = Box::FT;
using T_mesh = T::T_mesh<Box::Kernel::Point_3, FT>;
using Anchor_map = Mesh::Property_map<Mesh::Face_index, T::T_mesh_anchor<Mesh, FT>>;

// The map of a box, its T-mesh, and what the T-mesh carries.
struct Scene {
  Box box{6, spline_tests::bumpy};
  T::Seamless_map<Mesh, FT> map{box.mesh};
  T_mesh t_mesh;
  Anchor_map anchors = t_mesh.graph().add_property_map<Mesh::Face_index, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
  Mesh::Property_map<Mesh::Vertex_index, T::T_mesh_place<Mesh, FT>> places =
      box.mesh.add_property_map<Mesh::Vertex_index, T::T_mesh_place<Mesh, FT>>("v:place").first;

  Scene()
  {
    REQUIRE(T::make_exactly_seamless(box.mesh, box.uv, map).success());
    REQUIRE(T::trace_motorcycle_graph(map, t_mesh, P::face_anchor_map(anchors, P::vertex_place_map(places))).success());
  }

  // Faces of very different sizes; what is left of its work is for the test.
  T_mesh split_once() const
  {
    T_mesh result = t_mesh;
    T::T_mesh_editor editor(result);
    Mesh::Face_index f = *result.graph().faces().begin();
    for (int i = 0; i < 8; ++i) {
      const FT size = i % 2 == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
      const auto edit = editor.split_face(f, i % 2, size / FT(i < 4 ? 2 : 16));
      REQUIRE(edit);
      f = face(edit.halfedge, result.graph());
    }
    return result;
  }
};

// What a T-mesh that was changed in part must still be; images of the surface must cover it.
void check_valid(const T_mesh& t_mesh, const T::Carried_surface<Mesh>& surface)
{
  CHECK(T::check_admissibility(t_mesh));
  CHECK(t_mesh.graph().is_valid(false));
  for (const auto f : t_mesh.graph().faces())
    if (surface.images(f).empty()) {
      FAIL_CHECK("the observer was not told of a face");
      return;
    }
}

} // namespace

TEST_CASE("A T-mesh whose tracing is cancelled stays empty", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    T_mesh t_mesh;
    const auto places = scene.box.mesh.number_of_faces(); // the map is not written, either
    const auto report = T::trace_motorcycle_graph(scene.map, t_mesh, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Motorcycle_graph_status::INTERRUPTED;
    CHECK((num_vertices(t_mesh.graph()) == 0) == is_interrupted);
    CHECK(scene.box.mesh.number_of_faces() == places);
    return is_interrupted;
  });
}

TEST_CASE("A carried surface that is cancelled is empty", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    const auto surface = T::carry_surface(scene.map, scene.t_mesh, scene.anchors, CGAL::parameters::visitor(visitor));
    CHECK(surface.points().empty() == surface.triangles().empty());
    return surface.triangles().empty();
  });
}

TEST_CASE("There are no samples if sampling is cancelled", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    std::vector<T::T_mesh_sample<Mesh, Box::Kernel>> samples;
    T::sample_T_mesh(scene.map, scene.t_mesh, scene.anchors, scene.places, std::back_inserter(samples),
                     CGAL::parameters::visitor(visitor));
    return samples.empty();
  });
}

TEST_CASE("A T-mesh whose change is cancelled is admissible, and its observer knows it", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    T_mesh t_mesh = scene.t_mesh;
    auto surface = scene.box.surface;
    const auto report = T::regularize_T_mesh(t_mesh, P::observer(surface.observer()).visitor(visitor));
    check_valid(t_mesh, surface);
    CHECK(describe(report).find(message(report.status)) == 0);
    return report.status == T::T_mesh_regularization_status::INTERRUPTED;
  });
  check_cancelling([&](const auto& visitor) {
    T_mesh t_mesh = scene.t_mesh;
    auto surface = scene.box.surface;
    const T::T_mesh_coordinates coordinates(t_mesh);
    const T::Parametric_face_size size(coordinates);
    const auto report = T::refine_T_mesh(t_mesh, size, 0.5, P::observer(surface.observer()).visitor(visitor));
    check_valid(t_mesh, surface);
    return report.status == T::T_mesh_refinement_status::INTERRUPTED;
  });
  check_cancelling([&](const auto& visitor) {
    T_mesh t_mesh = scene.t_mesh;
    auto surface = scene.box.surface;
    const auto report = T::make_spline_compatible(t_mesh, P::observer(surface.observer()).visitor(visitor));
    check_valid(t_mesh, surface);
    if (!report) // it may be gone on with
      CHECK(T::make_spline_compatible(t_mesh));
    return report.status == T::Spline_compatibility_status::INTERRUPTED;
  });
}

TEST_CASE("A T-mesh whose grading is cancelled is admissible", "[cancel]")
{
  const Scene scene;
  const T_mesh uneven = scene.split_once();
  check_cancelling([&](const auto& visitor) {
    T_mesh t_mesh = uneven;
    const auto report = T::grade_T_mesh(t_mesh, 3, CGAL::parameters::visitor(visitor));
    CHECK(T::check_admissibility(t_mesh));
    CHECK(describe(report).find(std::to_string(report.splits) + " splits") != std::string::npos);
    return report.status == T::T_mesh_grading_status::INTERRUPTED;
  });
}

TEST_CASE("Checks of T-meshes can be cancelled", "[cancel]")
{
  Scene scene;
  check_cancelling([&](const auto& visitor) {
    return T::check_admissibility(scene.t_mesh, CGAL::parameters::visitor(visitor)).status ==
           T::Admissibility_status::INTERRUPTED;
  });
  T_mesh compatible = scene.t_mesh;
  REQUIRE(T::make_spline_compatible(compatible));
  check_cancelling([&](const auto& visitor) {
    return T::check_spline_compatibility(compatible, CGAL::parameters::visitor(visitor)).status ==
           T::Spline_compatibility_status::INTERRUPTED;
  });
}

TEST_CASE("The placement of a T-mesh can be cancelled", "[cancel]")
{
  const Scene scene;
  T_mesh t_mesh = scene.t_mesh;
  T::Carried_anchors<Mesh, Mesh, FT> roots(t_mesh.graph(), scene.anchors);
  REQUIRE(T::make_spline_compatible(t_mesh, P::observer(roots)));
  check_cancelling([&](const auto& visitor) {
    const auto report = T::place_T_mesh(scene.map, t_mesh, roots, CGAL::parameters::visitor(visitor));
    CHECK(describe(report, t_mesh.graph()) == message(report.status));
    return report.status == T::T_mesh_placement_status::INTERRUPTED;
  });
}

} // namespace cancelling_test
