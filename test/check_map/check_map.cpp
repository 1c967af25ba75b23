// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// check_map MESH MAP.obj [--cones FILE [K1,K2,...] | --field FILE]
//
// Judges a seamless similarity map from the mesh, the map's file and the signature, with the checker of the tests. The signature is that of the
// cones (and turning numbers of the loops), of the field, or else of the smoothest field.

#include "Map_checker.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/read_cross_field.h>
#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Signature = T::Holonomy_signature<Mesh>;

bool find_signature(Mesh& mesh, const std::vector<std::string>& arguments, Signature& signature)
{
  if (arguments.size() > 1 && arguments[0] == "--cones") {
    std::vector<std::pair<Mesh::Vertex_index, int>> cones;
    if (!T::read_cones(arguments[1], mesh, cones).success() ||
        !T::holonomy_signature_of_cones(mesh, cones, signature).success())
      return false;
    std::istringstream numbers(arguments.size() > 2 ? arguments[2] : "");
    std::string number;
    for (std::size_t i = 0; std::getline(numbers, number, ',') && i < signature.loops().size(); ++i)
      signature.set_loop_quarter_turns(i, std::stoi(number));
    return true;
  }
  const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  if (arguments.size() > 1 && arguments[0] == "--field") {
    if (!T::read_cross_field(arguments[1], mesh, field).success())
      return false;
  }
  else if (!T::compute_smooth_cross_field(mesh, field).success())
    return false;
  return T::holonomy_signature_of_cross_field(mesh, field, signature).success();
}

} // namespace

int main(const int argc, const char* const argv[])
{
  if (argc < 3) {
    std::cerr << "usage: check_map MESH MAP.obj [--cones FILE [K1,K2,...] | --field FILE]\n";
    return 2;
  }
  Mesh mesh, refined;
  Signature signature;
  const auto uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if (!T::read_triangle_mesh(argv[1], mesh).success() || !T::read_map_obj(argv[2], refined, uv).success() ||
      !find_signature(mesh, std::vector<std::string>(argv + 3, argv + argc), signature)) {
    std::cerr << "check_map: the mesh, the map or the signature cannot be read\n";
    return 2;
  }
  const Map_check check = check_map(plain_mesh(mesh), plain_map(refined, uv), plain_signature(mesh, signature));
  std::cout << check.text() << "\n";
  return check.success() ? 0 : 1;
}
