// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_BENCHMARK_INPUT_H
#define T_SPLINES_BENCHMARK_BENCHMARK_INPUT_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Halfedge = boost::graph_traits<Mesh>::halfedge_descriptor;
using Signature = CGAL::T_splines::Holonomy_signature<Mesh>;
using Cones = std::vector<std::pair<Vertex, int>>;

/// Where the signature of a mesh comes from.
enum class Signature_source {
  FIELD,         ///< a smooth cross field that is computed
  CONES_OR_FIELD ///< the file of the mesh with the extension `.cones`, if there is one
};

inline std::string name_of(const std::string& file)
{
  return std::filesystem::path(file).filename().string();
}

inline int genus_of(const Mesh& mesh)
{
  const int characteristic = static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
                             static_cast<int>(mesh.number_of_faces());
  return 1 - characteristic / 2;
}

/// reads a mesh. \return `false` after a message.
inline bool read_mesh(const std::string& file, Mesh& mesh)
{
  const auto report = CGAL::T_splines::read_triangle_mesh(file, mesh);
  if (!report.success())
    std::cerr << file << ": " << describe(report) << '\n';
  return report.success();
}

/// makes the signature of a smooth field. \return `false` after a message.
inline bool make_field_signature(const std::string& file, Mesh& mesh, Signature& signature)
{
  auto [field, is_new] = mesh.add_property_map<Face, Kernel::Vector_3>("f:cross");
  const auto field_report = CGAL::T_splines::compute_smooth_cross_field(mesh, field);
  if (!field_report.success()) {
    std::cerr << file << ": " << message(field_report.status) << '\n';
    return false;
  }
  const auto report = CGAL::T_splines::holonomy_signature_of_cross_field(mesh, field, signature);
  mesh.remove_property_map(field);
  if (!report.success())
    std::cerr << file << ": " << message(report.status) << '\n';
  return report.success();
}

/// makes the signature of cones, with the loops' numbers nearest to the metric. \return `false` after a message.
inline bool make_cone_signature(const std::string& file, const Mesh& mesh, const Cones& cones, Signature& signature)
{
  const auto report = CGAL::T_splines::holonomy_signature_of_cones(mesh, cones, signature);
  if (!report.success())
    std::cerr << file << ": " << message(report.status) << '\n';
  return report.success();
}

/// reads a mesh and makes its signature. \return `false` after a message.
inline bool read_input(const std::string& file, const Signature_source source, Mesh& mesh, Signature& signature)
{
  if (!read_mesh(file, mesh))
    return false;
  const std::filesystem::path cone_file = std::filesystem::path(file).replace_extension(".cones");
  if (source == Signature_source::FIELD || !std::filesystem::exists(cone_file))
    return make_field_signature(file, mesh, signature);
  Cones cones;
  const auto report = CGAL::T_splines::read_cones(cone_file.string(), mesh, cones);
  if (!report.success()) {
    std::cerr << cone_file.string() << ": " << message(report.status) << '\n';
    return false;
  }
  return make_cone_signature(file, mesh, cones, signature);
}

#endif // T_SPLINES_BENCHMARK_BENCHMARK_INPUT_H
