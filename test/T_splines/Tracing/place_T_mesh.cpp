// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// T-meshes that operations have changed are judged as those that were traced, in exact arithmetic: that the faces cover
// the surface once, that vertices of the surface are where the T-mesh carried them, and where points and edges lie.

#include "Tracing/Traced_map.h"

#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/place_T_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace place_T_mesh_test {

using namespace hand_made_maps;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// Keeps the origins of vertices up to date.
template <typename Origins>
struct Origin_keeper : CGAL::T_splines::T_mesh_observer {
  Origins* origins;
  typename Origins::mapped_type none;

  Origin_keeper(Origins& all, const typename Origins::mapped_type no_origin) : origins(&all), none(no_origin) {}

  template <typename Vertex, typename Halfedge>
  void vertex_inserted(const Vertex v, Halfedge) const
  {
    (*origins)[v] = none;
  }
  template <typename Vertex, typename Halfedge>
  void vertex_removed(const Vertex v, Halfedge) const
  {
    origins->erase(v);
  }
  template <typename Vertex, typename Halfedge>
  void vertex_moved(const Vertex v, Halfedge) const
  {
    (*origins)[v] = none;
  }
};

/// A traced graph, and what it carries along when it changes.
template <typename TMesh>
struct Changing_graph {
  using Traced = Traced_map<Surface_mesh, TMesh, Exact>;
  struct Sample {
    CGAL::T_splines::T_mesh_place<TMesh, Exact> place;
    Surface_mesh::Vertex_index vertex;
  };
  using Samples = CGAL::T_splines::Carried_samples<TMesh, Sample>;
  using Roots = CGAL::T_splines::Carried_anchors<Surface_mesh, TMesh, Exact>;
  using Origins = decltype(Traced::origins);

  Traced traced;
  Samples samples;
  Roots roots;

  explicit Changing_graph(const Plain_map& plain)
    : traced(plain),
      roots(traced.graph, boost::make_assoc_property_map(traced.anchors))
  {
    REQUIRE(traced.success());
    for (const auto& [v, place] : traced.places)
      samples.push_back({place, v});
  }

  auto observer()
  {
    using namespace CGAL::T_splines;
    const Origin_keeper<Origins> origins(traced.origins, Surface_mesh::null_vertex());
    return T_mesh_observer_pair(origins, T_mesh_observer_pair(samples.observer(), roots));
  }

  T_mesh_check check()
  {
    using namespace CGAL::T_splines::parameters;
    traced.points.clear();
    traced.polylines.clear();
    REQUIRE(place_T_mesh(traced.map, traced.view(), roots,
                         edge_polyline_map(boost::make_assoc_property_map(traced.polylines),
                                           output_vertex_point_map(boost::make_assoc_property_map(traced.points)))));
    traced.places.clear();
    for (const Sample& sample : samples.samples())
      traced.places[sample.vertex] = sample.place;
    CHECK(traced.places.size() == num_vertices(traced.mesh));
    Exact_t_mesh_reader reader(traced.view());
    reader.read_places(traced.mesh, boost::make_assoc_property_map(traced.places));
    reader.read_origins(traced.mesh, boost::make_assoc_property_map(traced.origins));
    reader.read_points(boost::make_assoc_property_map(traced.points));
    reader.read_polylines(boost::make_assoc_property_map(traced.polylines));
    Exact_t_mesh t_mesh = reader.result();
    put_anchors(t_mesh);
    return T_mesh_checker(traced.exact_map(), t_mesh).check();
  }

private:
  // The roots, by the numbers of faces and triangles.
  void put_anchors(Exact_t_mesh& t_mesh) const
  {
    const auto number = [](const auto& range, const auto element) {
      return static_cast<int>(std::distance(range.begin(), std::find(range.begin(), range.end(), element)));
    };
    t_mesh.anchor.resize(t_mesh.number_of_faces());
    t_mesh.anchors_may_touch = true;
    for (const auto& root : roots.roots())
      t_mesh.anchor[number(CGAL::make_range(faces(traced.graph)), root.place.face)] = {
          number(faces(traced.mesh), root.anchor.triangle), exact_similarity(root.anchor.to_face)};
  }
};

static std::vector<Plain_map> maps()
{
  const std::set<std::array<int, 3>> l = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}};
  std::vector<Plain_map> result = {folded(net(polycube(l), 2, Pattern::CROSSES)),
                                   folded(folded_triangle({{1, -0.0078125}}, {{0.380859375, 0.625}})),
                                   folded(folded_triangle({{1. / 64, -63. / 4096}}, {{1, 1 - 3. / 8192}})),
                                   folded(scaled_torus(1.5, 4, 0, 4, 4)),
                                   folded(scaled_torus(2, 5, 1, 4, 2)),
                                   folded(lattice_torus({{1, 0.25}}, {{-0.25, 1}}, 4, 3)),
                                   folded(bordered_l(2, Pattern::MIXED_DIAGONALS))};
  for (std::size_t i = 0; i < 3; ++i) {
    result.push_back(result[i]);
    flip_at_random(result.back(), 1000, 3);
  }
  const std::vector<Position> octagon = {{{1, -0.25}}, {{0.75, 0.5}}, {{0.125, 1}}, {{-0.5, 0.75}}};
  result.push_back(folded(subdivided(subdivided(symmetric_polygon(octagon)))));
  return result;
}

TEMPLATE_TEST_CASE("A T-mesh that was not changed is placed where it was traced", "[place]", Surface_mesh, Polyhedron)
{
  for (const Plain_map& map : maps()) {
    Changing_graph<TestType> graph(map);
    const T_mesh_check check = graph.check();
    INFO(check.text());
    CHECK(check.success());
  }
}

TEMPLATE_TEST_CASE("After regularization and refinement the T-mesh lies on the surface", "[place]", Surface_mesh,
                   Polyhedron)
{
  for (const Plain_map& map : maps()) {
    Changing_graph<TestType> graph(map);
    const auto t_mesh = graph.traced.view();
    const auto regularization =
        CGAL::T_splines::regularize_T_mesh(t_mesh, CGAL::T_splines::parameters::observer(graph.observer()));
    const T_mesh_check regular = graph.check();
    INFO(regular.text());
    CHECK(regular.success());
    CHECK(regular.largest_aspect_ratio == Approx(regularization.worst_aspect_after));
    CHECK(regular.faces == static_cast<int>(regularization.faces_after));
    const CGAL::T_splines::T_mesh_coordinates coordinates(t_mesh);
    const CGAL::T_splines::Parametric_face_size size(coordinates);
    double largest = 0;
    for (const auto f : faces(t_mesh.graph()))
      largest = std::max({largest, size(f).first, size(f).second});
    CGAL::T_splines::refine_T_mesh(t_mesh, size, largest / 4,
                                   CGAL::T_splines::parameters::observer(graph.observer()).number_of_iterations(200));
    const T_mesh_check refined = graph.check();
    INFO(refined.text());
    CHECK(refined.success());
    CHECK(refined.extraordinary_vertices == regular.extraordinary_vertices);
  }
}

TEST_CASE("A T-mesh with edges over cones or borders, or with foreign roots, does not fit the map", "[place]")
{
  using Changing = Changing_graph<Surface_mesh>;
  using Status = CGAL::T_splines::T_mesh_placement_status;
  const auto place = [](auto&& t_mesh, const Changing& graph, const Changing::Roots& roots) {
    std::map<Surface_mesh::Vertex_index, Kernel::Point_3> points;
    const auto report =
        place_T_mesh(graph.traced.map, t_mesh, roots,
                     CGAL::T_splines::parameters::output_vertex_point_map(boost::make_assoc_property_map(points)));
    CHECK(report.success() == (report.status == Status::PLACED));
    return std::pair(report.status, describe(report, t_mesh.graph()));
  };
  for (const Plain_map& map : {folded(net(cube(), 2, Pattern::CROSSES)), folded(bordered_l(2, Pattern::CROSSES))}) {
    Changing graph(map);
    const std::pair placed(Status::PLACED, std::string("the T-mesh was placed on the surface"));
    const std::pair foreign(Status::FOREIGN_ROOT,
                            std::string("a root names a face that the T-mesh or the mapped mesh does "
                                        "not have: the roots are those of another T-mesh or map"));
    CHECK(place(graph.traced.view(), graph, graph.roots) == placed);
    CHECK(place(CGAL::T_splines::T_mesh<Kernel::Point_3, Exact>(), graph, graph.roots) == foreign);
    for (auto& knot : graph.traced.knots)
      knot.second *= 3; // over a cone, or beyond the border
    const auto [status, words] = place(graph.traced.view(), graph, graph.roots);
    CHECK(status == Status::DOES_NOT_FIT);
    CHECK(words.find("beyond a border: edge from vertex ") != std::string::npos);
    CHECK(words.find(", counted from 0") != std::string::npos);
    for (auto& knot : graph.traced.knots)
      knot.second /= 3;
    for (auto& anchor : graph.traced.anchors)
      anchor.second.triangle = Surface_mesh::Face_index(num_faces(graph.traced.mesh));
    const Changing::Roots roots(graph.traced.graph, boost::make_assoc_property_map(graph.traced.anchors));
    CHECK(place(graph.traced.view(), graph, roots) == foreign);
  }
}

} // namespace place_T_mesh_test
