// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a cross field that follows the sharp edges of a triangle mesh, detected or given by a file, and its holonomy
// signature.
//
//   feature_aligned_field [MESH [FEATURES]]

#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Features = Mesh::Property_map<Mesh::Edge_index, bool>;
namespace T = CGAL::T_splines;

namespace {

// Says what was done, or why it was not.
template <typename Report>
bool print(const Report& report, const std::string& text)
{
  (report.success() ? std::cout : std::cerr) << text << "\n";
  return report.success();
}

bool mark_features(const Mesh& mesh, Features is_feature, const std::string& features_file)
{
  if (features_file.empty()) {
    const auto report = T::detect_features(mesh, is_feature);
    return print(report, describe(report, mesh));
  }
  const auto report = T::read_features(features_file, mesh, is_feature);
  return print(report, features_file + ": " + describe(report));
}

bool compute_field(const Mesh& mesh, Features is_feature)
{
  Mesh refined; // no face of it has two features
  const Features is_feature_of_refined = refined.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  const auto refinement = T::refine_at_features(mesh, is_feature, refined, is_feature_of_refined);
  if (!print(refinement, describe(refinement, mesh)))
    return false;

  // The crosses and their matchings belong together: the signature is made of both.
  const auto field = refined.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  const auto matching = refined.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;
  const auto np = T::parameters::halfedge_matching_map(matching);
  const auto report = T::compute_feature_aligned_cross_field(refined, is_feature_of_refined, field, np);
  if (!print(report, describe(report, refined)))
    return false;
  T::Holonomy_signature<Mesh> signature;
  const auto made = T::holonomy_signature_of_cross_field(refined, field, signature, np);
  return print(made, describe(made, refined) + ": " + std::to_string(signature.cones().size()) + " cones");
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  const auto reading = T::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }
  const Features is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  return mark_features(mesh, is_feature, argc > 2 ? argv[2] : "") && compute_field(mesh, is_feature) ? EXIT_SUCCESS
                                                                                                     : EXIT_FAILURE;
}
