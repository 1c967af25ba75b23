// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact map, tracing and T-mesh against the metric that the map comes from; how often the filter of the predicates
// suffices; memory per face of the refined mesh.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace T_splines = CGAL::T_splines;
using Exact = CGAL::Exact_rational;
using Seamless_map = T_splines::Seamless_map<Mesh, Exact>;
using UV_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;

static const char usage[] =
    "usage: t_mesh_speed MESH... [--cones] [--repeats N]\n"
    "\n"
    "Computes the seamless map of each mesh, makes it exact and traces its motorcycle graph. Prints CPU seconds (best "
    "of the\n"
    "repeats), their ratio to the metric's (goal: 1), how many of the tracer's questions the floating point filter "
    "answers\n"
    "(goal: 95 %), and the memory of exact map, tracing and T-mesh per face of the refined mesh (goal: 1 KB), measured "
    "in a\n"
    "process of its own.\n"
    "  --cones      take the signature from the .cones file beside the mesh, not from a smooth cross field\n"
    "  --repeats N  (default 5)\n";

/// A T-mesh with all that the tracer can tell about it, knots in doubles.
struct T_mesh_output {
  T_splines::T_mesh<Kernel::Point_3> t_mesh;
  Mesh::Property_map<Mesh::Edge_index, std::vector<Kernel::Point_3>> polylines =
      t_mesh.graph().add_property_map<Mesh::Edge_index, std::vector<Kernel::Point_3>>("e:polyline").first;
  std::vector<T_splines::T_mesh_place<Mesh, double>> places; // by vertex of the refined mesh

  template <typename Visitor>
  T_splines::Motorcycle_graph_report trace(const Seamless_map& map, const bool with_places, const Visitor& visitor)
  {
    if (!with_places)
      return T_splines::trace_motorcycle_graph(map, t_mesh, CGAL::parameters::visitor(visitor));
    places.resize(num_vertices(map.mesh()));
    const auto place_map = boost::make_iterator_property_map(places.begin(), get(boost::vertex_index, map.mesh()));
    return T_splines::trace_motorcycle_graph(
        map, t_mesh,
        T_splines::parameters::vertex_place_map(
            place_map, T_splines::parameters::edge_polyline_map(polylines, CGAL::parameters::visitor(visitor))));
  }
};

struct Times {
  double exact_map = std::numeric_limits<double>::infinity(), tracing = exact_map, t_mesh = exact_map,
         t_mesh_with_places = exact_map;
};

static double metric_seconds(const Mesh& mesh, const Signature& signature, const int repeats)
{
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    Stage_times times;
    T_splines::Similarity_metric<Mesh> metric;
    T_splines::compute_similarity_metric(mesh, signature, metric, CGAL::parameters::visitor(Stage_clock(times)));
    times.end();
    best = std::min(best, times["similarity metric"]);
  }
  return best;
}

/// \return `false` after a message.
static bool trace(const std::string& file, const Mesh& refined, const UV_map uv, const int repeats, Times& best,
                  T_splines::Motorcycle_graph_report& report, std::size_t& faces)
{
  for (int i = 0; i < repeats; ++i) {
    const double start = cpu_seconds();
    Seamless_map map(refined);
    const auto map_report = T_splines::make_exactly_seamless(refined, uv, map);
    best.exact_map = std::min(best.exact_map, cpu_seconds() - start);
    if (!map_report.success()) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), message(map_report.status));
      return false;
    }
    for (const bool with_places : {false, true}) {
      T_mesh_output output;
      Stage_times times;
      report = output.trace(map, with_places, Stage_clock(times));
      times.end();
      if (!report.success()) {
        std::fprintf(stderr, "%s: %s\n", file.c_str(), message(report.status));
        return false;
      }
      faces = num_faces(output.t_mesh.graph());
      best.tracing = std::min(best.tracing, times[Stage_times::before_the_first] + times["tracing"]);
      double& t_mesh = with_places ? best.t_mesh_with_places : best.t_mesh;
      t_mesh = std::min(t_mesh, times["T-mesh"]);
    }
  }
  return true;
}

static void print_memory(const Mesh& refined, const UV_map uv)
{
  const Memory memory = memory_in_child([&] {
    Seamless_map map(refined);
    T_splines::make_exactly_seamless(refined, uv, map);
    T_mesh_output().trace(map, true, T_splines::Progress_visitor());
  });
  const double faces = static_cast<double>(num_faces(refined));
  std::printf(
      "  memory %.1f MB at the peak, %.1f MB before: %.0f bytes per face of the refined mesh, %.0f without what was "
      "there before (goal <= 1000)\n",
      memory.peak / 1e6, memory.before / 1e6, memory.peak / faces, (memory.peak - memory.before) / faces);
}

static bool measure(const std::string& file, const Signature_source source, const int repeats)
{
  Mesh mesh, refined;
  Signature signature;
  if (!read_input(file, source, mesh, signature))
    return false;
  const UV_map uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  const auto map_report = T_splines::compute_seamless_similarity_map(mesh, signature, refined, uv);
  if (!map_report.success()) {
    std::fprintf(stderr, "%s: %s\n", file.c_str(), message(map_report.status));
    return false;
  }
  Times times;
  T_splines::Motorcycle_graph_report report;
  std::size_t faces = 0;
  if (!trace(file, refined, uv, repeats, times, report, faces))
    return false;
  const double metric = metric_seconds(mesh, signature, repeats);
  const double graph = times.exact_map + times.tracing + times.t_mesh;
  const double all = times.exact_map + times.tracing + times.t_mesh_with_places;
  std::printf("%s: %zu faces, %zu refined, genus %d, %zu cones; T-mesh of %zu faces, %zu T-joints, %zu motorcycles, "
              "%zu seeds\n",
              name_of(file).c_str(), static_cast<std::size_t>(num_faces(mesh)),
              static_cast<std::size_t>(num_faces(refined)), genus_of(mesh), signature.cones().size(), faces,
              report.t_joints, report.motorcycles, report.seeds);
  std::printf("  metric %.3f s; exact map %.3f, tracing %.3f, T-mesh %.3f, with places and polylines %.3f\n", metric,
              times.exact_map, times.tracing, times.t_mesh, times.t_mesh_with_places);
  std::printf("  (exact map + tracing + T-mesh) / metric = %.2f, with places and polylines %.2f (goal <= 1)\n",
              graph / metric, all / metric);
  const double calls = static_cast<double>(report.predicates.calls),
               exact = static_cast<double>(report.predicates.exact_calls);
  std::printf("  predicates: %.0f calls for %zu crossed faces, %.0f exact; the filter answers %.3f %% (goal >= 95)\n",
              calls, report.crossed_faces, exact, 100 * (1 - exact / calls));
  print_memory(refined, uv);
  std::fflush(stdout);
  return true;
}

int main(const int argc, char** argv)
{
  run_with_one_blas_thread(argv);
  Arguments arguments(usage, {"--cones"}, {"--repeats"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  const Signature_source source = arguments.has("--cones") ? Signature_source::CONES_OR_FIELD : Signature_source::FIELD;
  bool is_complete = true;
  for (const std::string& file : arguments.files())
    is_complete = measure(file, source, arguments.integer("--repeats", 5)) && is_complete;
  return is_complete ? 0 : 2;
}
