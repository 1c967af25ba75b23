// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Flat_torus.h"

#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/Similarity_map/internal/first_degeneracy.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Similarity_structure_test {

namespace {

using CGAL::T_splines::internal::First_degeneracy;
using Structure = CGAL::T_splines::internal::Similarity_structure<double>;

double log_length(const Flat_torus& torus, const int h)
{
  return std::log(std::hypot(double(torus.vector[h][0]), double(torus.vector[h][1])));
}

Structure structure_of(const Flat_torus& torus)
{
  Structure structure;
  structure.mesh = torus.mesh;
  structure.loops = CGAL::T_splines::internal::Dual_loops(torus.mesh.number_of_edges());
  structure.form.assign(torus.mesh.number_of_edges(), 0.);
  for (int e = 0; e < torus.mesh.number_of_edges(); ++e)
    structure.log_length.push_back(log_length(torus, 2 * e));
  return structure;
}

std::vector<double> random_scales(const int size, const double most, CGAL::Random& random)
{
  std::vector<double> scales(size);
  for (double& x : scales)
    x = random.uniform_real(-most, most);
  return scales;
}

// b + c - a by the longest side a.
double excess(const Structure& structure, const int f)
{
  std::array<double, 3> l = structure.triangle_log_lengths(structure.mesh.halfedge_of_face(f));
  std::sort(l.begin(), l.end());
  return std::exp(l[0] - l[2]) + std::exp(l[1] - l[2]) - 1;
}

} // namespace

TEST_CASE("Euclidean flips keep the lengths of straight edges", "[Similarity_structure]")
{
  CGAL::Random random(1);
  Flat_torus torus(5, random);
  Structure structure = structure_of(torus);
  for (int i = 0; i < 100; ++i) {
    const int h = random.get_int(0, torus.mesh.number_of_halfedges());
    if (!torus.is_flippable(h))
      continue;
    torus.flip_vectors(h);
    torus.mesh.flip(h);
    structure.flip_euclidean(h);
    CHECK(structure.log_length[h / 2] == Approx(log_length(torus, h)).margin(1e-9));
  }
}

TEST_CASE("flips end in the Delaunay triangulation", "[Similarity_structure]")
{
  CGAL::Random random(2);
  Flat_torus torus(5, random);
  Structure structure = structure_of(torus);
  const auto flip = [&](const int h) {
    REQUIRE(torus.is_flippable(h));
    torus.flip_vectors(h);
    torus.mesh.flip(h);
    structure.flip_euclidean(h);
  };
  for (int i = 0; i < 60; ++i) {
    const int h = random.get_int(0, torus.mesh.number_of_halfedges());
    if (torus.is_flippable(h))
      flip(h);
  }
  CGAL::T_splines::internal::Progress progress;
  CHECK(flip_all_to_delaunay(structure, 100000, flip, progress) > 0);
  for (int e = 0; e < torus.mesh.number_of_edges(); ++e) {
    double angles = 0;
    for (const int h : {2 * e, 2 * e + 1}) {
      const auto a = torus.vector[torus.mesh.previous(h)],
                 b = Flat_torus::minus({{0, 0}}, torus.vector[torus.mesh.next(h)]);
      angles += std::atan2(double(Flat_torus::cross(b, a)), double(a[0] * b[0] + a[1] * b[1]));
    }
    CHECK(std::abs(angles) <= 4 * std::atan(1.) + 1e-9);
  }
}

TEST_CASE("Ptolemy's formula, and xi stays closed", "[Similarity_structure]")
{
  CGAL::Random random(3);
  Flat_torus torus(4, random);
  Structure structure = structure_of(torus);
  structure.set_form(random_scales(torus.mesh.number_of_vertices(), 3., random));
  for (int i = 0; i < 200; ++i) {
    const int h = random.get_int(0, structure.mesh.number_of_halfedges()), g = h ^ 1;
    if (structure.mesh.face(h) == structure.mesh.face(g))
      continue;
    const auto lambda = [&](const int k) { return structure.log_length[k / 2]; };
    const double one = lambda(structure.mesh.next(h)) + lambda(structure.mesh.next(g));
    const double other = lambda(structure.mesh.previous(h)) + lambda(structure.mesh.previous(g));
    const double before = lambda(h);
    structure.flip_ptolemy(h);
    CHECK(std::exp(one - before - lambda(h)) + std::exp(other - before - lambda(h)) == Approx(1));
    structure.flip_ptolemy(h);
    CHECK(lambda(h) == Approx(before).margin(1e-12));
    structure.flip_ptolemy(h);
  }
  for (int f = 0; f < structure.mesh.number_of_faces(); ++f) {
    const int h = structure.mesh.halfedge_of_face(f), j = structure.mesh.next(h), k = structure.mesh.next(j);
    CHECK(std::abs(structure.form_of(h) + structure.form_of(j) + structure.form_of(k)) <= 1e-10);
  }
}

TEST_CASE("no triangle degenerates before the first one does", "[first_degeneracy]")
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    CGAL::Random random(seed);
    Flat_torus torus(4, random);
    Structure structure = structure_of(torus);
    Structure end = structure;
    end.set_form(random_scales(torus.mesh.number_of_vertices(), 4., random));
    const First_degeneracy<double> first(structure, end.form);
    const auto worst_at = [&](const double time) {
      Structure moved = structure;
      for (std::size_t e = 0; e < moved.form.size(); ++e)
        moved.form[e] = time * end.form[e];
      double worst = 1;
      for (int f = 0; f < moved.mesh.number_of_faces(); ++f)
        worst = std::min(worst, excess(moved, f));
      return worst;
    };
    for (int i = 0; i < 20; ++i)
      CHECK(worst_at(first.time * i / 20) > 0);
    CHECK((first.time == 1) == first.triangles.empty());
    if (!first.triangles.empty()) {
      CHECK(std::abs(worst_at(first.time)) <= 1e-12);
      CHECK(worst_at(std::min(1., first.time * 1.001)) < 0);
    }
  }
}

} // namespace Similarity_structure_test
