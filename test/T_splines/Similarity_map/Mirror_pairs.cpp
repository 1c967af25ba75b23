// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "open_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Similarity_map/internal/Metric_computation.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <cmath>
#include <random>
#include <vector>

namespace Mirror_pairs_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
namespace internal = CGAL::T_splines::internal;
using Signature = T::Holonomy_signature<Mesh>;
using Structure = internal::Similarity_structure<double>;

internal::Progress nobody;

internal::Metric_input double_of(Mesh& mesh)
{
  Signature signature;
  const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  REQUIRE(T::compute_smooth_cross_field(mesh, field));
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature));
  return internal::Metric_input(internal::Mesh_indexing<Mesh>(mesh), signature, mesh.points());
}

// phi per vertex and c per loop, at random, the same or the opposite for what is an image.
std::vector<double> symmetric_coefficients(const internal::Metric_input& input, const double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> any(-size, size);
  std::vector<double> result;
  for (std::size_t v = 0; v < input.original_vertex.size(); ++v)
    result.push_back(input.original_vertex[v] == static_cast<int>(v) ? any(random) : result[input.original_vertex[v]]);
  const std::size_t vertices = result.size();
  for (std::size_t j = 0; j < input.loops.size(); ++j) {
    const auto fold = input.folding[j];
    result.push_back(fold.sign *
                     (fold.original == static_cast<int>(j) ? any(random) / 10 : result[vertices + fold.original]));
  }
  return result;
}

std::size_t check_pairs(const internal::Metric_input& input, const Structure& structure)
{
  const auto& mesh = structure.mesh;
  const auto& pairs = structure.pairs;
  std::size_t number_of_pairs = 0;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    if (!pairs.has_image(f))
      continue;
    const int g = pairs.image_of_face(f);
    REQUIRE(pairs.has_image(g));
    CHECK(pairs.image_of_face(g) == f);
    CHECK(pairs.is_image(f) != pairs.is_image(g));
    number_of_pairs += pairs.is_image(f) ? 1 : 0;
    int h = mesh.halfedge_of_face(f);
    for (int i = 0; i < 3; ++i, h = mesh.next(h)) {
      const int k = pairs.image(h);
      CHECK(mesh.face(k) == g);
      CHECK(pairs.image(k) == h);
      CHECK(pairs.image(mesh.next(h)) == mesh.previous(k));
      CHECK(input.original_vertex[mesh.source(h)] == input.original_vertex[mesh.target(k)]);
      CHECK(structure.log_length[internal::edge_of(h)] == structure.log_length[internal::edge_of(k)]);
      CHECK(structure.form_of(h) == -structure.form_of(k));
    }
  }
  return number_of_pairs;
}

} // namespace

TEST_CASE("what is flipped in pairs stays symmetric to the last bit, and becomes Delaunay on both sheets",
          "[Mirror_pairs]")
{
  Mesh round = disk(8), ring = annulus(2.5, 40, 6), plate = perforated_plate(2, 3);
  std::mt19937 random(7);
  for (Mesh* const mesh : {&round, &ring, &plate}) {
    const internal::Metric_input input = double_of(*mesh);
    REQUIRE(input.is_double());
    Structure structure = internal::Metric_computation<double>(input, true).structure;
    CHECK(check_pairs(input, structure) == mesh->number_of_faces());
    std::size_t flips_on_one_sheet = 0, flips = 0;
    for (const double size : {0.2, 0.5, 1.}) {
      structure.set_form(symmetric_coefficients(input, size, random));
      flips += internal::flip_to_delaunay(
          structure, 100000, [](int) { return false; },
          [&](const int h) {
            structure.flip_ptolemy(h);
            ++flips_on_one_sheet;
            return true;
          });
      check_pairs(input, structure);
      for (int e = 0; e < structure.mesh.number_of_edges(); ++e)
        CHECK(structure.is_delaunay(e));
    }
    CHECK(flips < 100000);
    CHECK(flips > flips_on_one_sheet);                              // some in pairs
    CHECK(check_pairs(input, structure) < mesh->number_of_faces()); // some across the border
    CHECK(check_pairs(input, structure) > 0);
  }
}

TEST_CASE("an edge that is flipped alone parts its faces from their images", "[Mirror_pairs]")
{
  Mesh mesh = plate(6, 4);
  const internal::Metric_input input = double_of(mesh);
  Structure structure = internal::Metric_computation<double>(input, false).structure;
  const auto inner = [&](const int e) {
    return structure.pairs.has_image_edge(structure.mesh, e) && !structure.pairs.is_image_edge(structure.mesh, e);
  };
  int e = 0;
  while (!inner(e))
    ++e;
  const std::size_t before = check_pairs(input, structure);
  structure.part(internal::halfedge_of_edge(e));
  structure.flip_ptolemy(internal::halfedge_of_edge(e));
  CHECK(check_pairs(input, structure) == before - 2);
}

TEST_CASE("the folded system is the derivative of the gradient, with one row per vertex of the mesh, loop and arc",
          "[Mirror_pairs]")
{
  Mesh round = disk(6), ring = annulus(2.5, 30, 5), plate = perforated_plate(2, 3);
  std::mt19937 random(11);
  for (Mesh* const mesh : {&round, &ring, &plate}) {
    const internal::Metric_input input = double_of(*mesh);
    Structure structure = internal::Metric_computation<double>(input, false).structure;
    std::vector<double> at = symmetric_coefficients(input, 0.4, random);
    structure.set_form(at);
    internal::flip_to_delaunay(
        structure, 100000, [](int) { return false; },
        [&](const int h) {
          structure.flip_ptolemy(h);
          return true;
        });
    internal::Newton_system<double> system(input);
    const std::size_t rows = system.number_of_rows();
    CHECK(rows == mesh->number_of_vertices() - 1 + input.number_of_loops + input.number_of_arcs);
    const auto right_hand_side_at = [&](const std::vector<double>& coefficients) {
      structure.set_form(coefficients);
      REQUIRE(system.evaluate(structure, nobody));
      return system.right_hand_side();
    };
    right_hand_side_at(at);
    system.set_hessian(structure);
    std::vector<double> step(rows), image, of_matrix;
    for (double& x : step)
      x = std::uniform_real_distribution<double>(-1, 1)(random);
    system.multiply(step, image);
    system.matrix().multiply(step, of_matrix);
    const std::vector<double> direction = system.direction(step);
    const double t = 1e-5;
    std::vector<double> before = at, behind = at;
    for (std::size_t i = 0; i < at.size(); ++i) {
      before[i] -= t * direction[i];
      behind[i] += t * direction[i];
    }
    const std::vector<double> b = right_hand_side_at(before), c = right_hand_side_at(behind);
    for (std::size_t r = 0; r < rows; ++r) {
      CHECK((b[r] - c[r]) / (2 * t) == Approx(image[r]).margin(1e-7));
      CHECK(of_matrix[r] == Approx(image[r]).margin(1e-12));
    }
  }
}

} // namespace Mirror_pairs_test
