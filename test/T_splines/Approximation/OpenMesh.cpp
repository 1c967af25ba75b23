// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Empty where CMake has not found OpenMesh.

#ifdef T_SPLINES_TEST_WITH_OPENMESH

// g++ takes what OpenMesh resizes a property with for uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "Approximation/box.h"

#include <catch2/catch.hpp>

namespace OpenMesh_test {

TEST_CASE("a mesh of OpenMesh gives a surface as good as that of a Surface_mesh")
{
  approximation_tests::check_box<OpenMesh::PolyMesh_ArrayKernelT<>>();
}

} // namespace OpenMesh_test

#endif
