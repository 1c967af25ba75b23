// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "features.h"

#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_features.h>
#include <CGAL/T_splines/named_parameters.h>

#include <filesystem>
#include <string>

namespace {

constexpr const char* feature_map_name = "e:is_feature";

} // namespace

Mesh::Property_map<Edge, bool> features_of(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>(feature_map_name, false).first;
}

Failure find_features(const Options& options, Progress& progress, Mesh& mesh, std::optional<Figures::Features>& figures)
{
  namespace T = CGAL::T_splines;
  const auto np = CGAL::parameters::visitor(Progress_handle(progress));
  const auto marked = features_of(mesh);
  if (!options.features.empty()) {
    const auto report = T::read_features(options.features, mesh, marked);
    if (!report.success())
      return {options.features + ": " + describe(report), true};
  }
  else {
    const double angle = options.feature_angle.value_or(T::default_feature_angle);
    if (!T::detect_features(mesh, marked, T::parameters::feature_angle(angle, np)).success())
      return {}; // of a mesh that is no triangle mesh the cross field tells why
  }
  progress.end_stage();
  const T::Feature_figures found = T::feature_figures(mesh, marked);
  if (found.number_of_edges == 0 || (!options.asks_for_features() && !found.divide_surface()))
    return {};
  Mesh refined;
  if (!T::refine_at_features(mesh, marked, refined, features_of(refined), np).success())
    return {};
  progress.end_stage();
  figures.emplace();
  figures->source =
      options.features.empty() ? "by angle" : "from " + std::filesystem::path(options.features).filename().string();
  figures->edges = static_cast<std::size_t>(found.number_of_edges);
  figures->arcs = static_cast<std::size_t>(found.number_of_arcs);
  figures->closed_arcs = static_cast<std::size_t>(found.number_of_loops);
  figures->corners = static_cast<std::size_t>(found.number_of_corners);
  figures->darts = static_cast<std::size_t>(found.number_of_darts);
  figures->added_faces = num_faces(refined) - num_faces(mesh);
  mesh = refined;
  return {};
}
