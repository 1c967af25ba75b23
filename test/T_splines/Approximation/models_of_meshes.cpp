// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Approximation/box.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <catch2/catch.hpp>

namespace models_of_meshes_test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Cartesian<CGAL::Gmpq>;
using Cell_complex_traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
using Cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Cell_complex_traits>::type;

} // namespace

TEMPLATE_TEST_CASE(
    "meshes of other types, and points of other kernels, give a surface as good as that of a Surface_mesh", "",
    CGAL::Polyhedron_3<Kernel>, CGAL::Surface_mesh<Exact_kernel::Point_3>, CGAL::Polyhedron_3<Rational_kernel>,
    Cell_complex)
{
  approximation_tests::check_box<TestType>();
}

} // namespace models_of_meshes_test
