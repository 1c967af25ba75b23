// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long it takes until a computation ends that is cancelled. A user who waits for half a second takes a program for
// dead: so all functions that may take longer ask their visitor whether to go on, at least as often.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/write_map_obj.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/Carried_anchors.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/carry_surface.h>
#include <CGAL/T_splines/Tracing/place_T_mesh.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using FT = CGAL::Exact_rational;

namespace {

/// What a visitor has seen of one call.
struct Call {
  struct Stage {
    std::string name;
    double seconds = 0, longest_gap = 0;
    std::size_t number_of_questions = 0;
  };

  std::vector<Stage> stages{Stage()};
  double begin = cpu_seconds(), last_question = begin;
  std::atomic<bool> is_cancelled{false};

  /// A question, or the end of the call.
  void note()
  {
    const double now = cpu_seconds();
    const double gap = now - last_question;
    last_question = now;
    stages.back().seconds += gap;
    stages.back().longest_gap = std::max(stages.back().longest_gap, gap);
  }

  void begin_stage(const std::string& name)
  {
    if (!name.empty() && stages.back().name == name)
      return; // the next level of a fit
    if (stages.size() == 1 && stages.front().name.empty() && stages.front().number_of_questions == 0)
      stages.front().name = name;
    else {
      note();
      stages.emplace_back();
      stages.back().name = name;
    }
  }
};

class Measuring_visitor : public T::Progress_visitor {
public:
  explicit Measuring_visitor(Call& call) : m_call(&call) {}

  void begin_stage(const char* name) const { m_call->begin_stage(name); }
  bool go_on() const
  {
    m_call->note();
    ++m_call->stages.back().number_of_questions;
    return !m_call->is_cancelled;
  }

private:
  Call* m_call;
};

/// Cancels a call at a given time, in a thread of its own. The thread sleeps: the CPU time is that of the call.
class Timer {
public:
  Timer(Call& call, const double seconds)
    : m_thread([this, &call, seconds] {
        std::unique_lock<std::mutex> lock(m_mutex);
        if (m_condition.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return m_is_stopped; }))
          return;
        m_time = cpu_seconds();
        call.is_cancelled = true;
      })
  {
  }

  /// \return when the call was cancelled, if it was.
  std::optional<double> stop()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_stopped = true;
    }
    m_condition.notify_one();
    m_thread.join();
    return m_time;
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_condition;
  bool m_is_stopped = false;
  std::optional<double> m_time;
  std::thread m_thread; // after all that it uses
};

/// Calls functions, and prints a row for each of their stages.
class Measurement {
public:
  Measurement(const int number_of_cancellations, const unsigned int seed)
    : m_number_of_cancellations(number_of_cancellations),
      m_random(seed)
  {
    std::printf("%-34s %-21s %9s %10s %12s %12s\n", "function", "stage", "seconds", "questions", "longest gap",
                "latency");
  }

  /// \param function takes a visitor, and returns whether it was interrupted. It must start anew each time
  template <typename Function>
  void operator()(const std::string& name, const Function& function)
  {
    Call whole;
    function(Measuring_visitor(whole));
    whole.note();
    const double seconds = cpu_seconds() - whole.begin;
    double latency = 0;
    int number_of_interruptions = 0;
    for (int i = 0; i < m_number_of_cancellations; ++i) {
      Call call;
      Timer timer(call, seconds * static_cast<double>(m_random()) / 4294967296.);
      const bool is_interrupted = function(Measuring_visitor(call));
      const double end = cpu_seconds();
      const std::optional<double> begin = timer.stop();
      if (!begin || !is_interrupted)
        continue;
      ++number_of_interruptions;
      latency = std::max(latency, end - *begin);
    }
    bool is_first = true;
    for (const Call::Stage& stage : whole.stages) {
      std::printf("%-34s %-21s %9.2f %10zu %12.3f ", is_first ? name.c_str() : "", stage.name.c_str(), stage.seconds,
                  stage.number_of_questions, stage.longest_gap);
      if (is_first && number_of_interruptions > 0)
        std::printf("%12.3f\n", latency);
      else
        std::printf("%12s\n", is_first ? "-" : "");
      is_first = false;
    }
    std::fflush(stdout);
  }

private:
  int m_number_of_cancellations;
  std::mt19937 m_random;
};

using Exact_t_mesh = T::T_mesh<Kernel::Point_3, FT>;
using Anchors = Mesh::Property_map<Face, T::T_mesh_anchor<Mesh, FT>>;

/// A traced T-mesh with what follows it.
struct Traced {
  Exact_t_mesh t_mesh;
  Anchors anchors = t_mesh.graph().add_property_map<Face, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
};

/// The whole way, each step with what the one before has made.
class Pipeline {
public:
  explicit Pipeline(const Arguments& arguments)
    : m_measure(arguments.integer("--cancellations", 5), static_cast<unsigned int>(arguments.integer("--seed", 1))),
      m_tolerance(arguments.real("--tolerance", 0.005))
  {
  }

  /// \return `false` after a message, if a step fails that the following ones need.
  bool run(const std::string& file)
  {
    return make_signature(file) && make_map() && make_t_mesh() && make_spline() && measure_spline();
  }

private:
  template <typename Report>
  static bool is_success(const char* step, const Report& report)
  {
    if (!report.success())
      std::cerr << step << ": " << message(report.status) << '\n';
    return report.success();
  }

  template <typename Status, typename Report>
  static bool is_interrupted(const Report& report)
  {
    return report.status == Status::INTERRUPTED;
  }

  bool make_signature(const std::string& file)
  {
    m_measure("read_triangle_mesh()", [&](const auto& visitor) {
      Mesh mesh;
      const auto report = T::read_triangle_mesh(file, mesh, CGAL::parameters::visitor(visitor));
      if (report.success())
        m_mesh = std::move(mesh);
      return is_interrupted<T::Mesh_reading_status>(report);
    });
    m_measure("check_triangle_mesh()", [&](const auto& visitor) {
      return is_interrupted<T::Triangle_mesh_status>(
          T::check_triangle_mesh(m_mesh, CGAL::parameters::visitor(visitor)));
    });
    const auto field = m_mesh.add_property_map<Face, Kernel::Vector_3>("f:cross").first;
    m_measure("compute_smooth_cross_field()", [&](const auto& visitor) {
      return is_interrupted<T::Smooth_cross_field_status>(
          T::compute_smooth_cross_field(m_mesh, field, CGAL::parameters::visitor(visitor)));
    });
    Signature of_field;
    m_measure("holonomy_signature_of_cross_field()", [&](const auto& visitor) {
      return is_interrupted<T::Holonomy_signature_status>(
          T::holonomy_signature_of_cross_field(m_mesh, field, of_field, CGAL::parameters::visitor(visitor)));
    });
    m_measure("check_holonomy_signature()", [&](const auto& visitor) {
      return is_interrupted<T::Holonomy_signature_status>(
          T::check_holonomy_signature(m_mesh, of_field, CGAL::parameters::visitor(visitor)));
    });
    m_measure("reduce_cones()", [&](const auto& visitor) {
      Signature signature = of_field;
      const auto report = T::reduce_cones(m_mesh, signature, CGAL::parameters::visitor(visitor));
      if (report.success())
        m_signature = signature;
      return is_interrupted<T::Cone_reduction_status>(report);
    });
    return m_mesh.number_of_faces() > 0;
  }

  bool make_map()
  {
    bool is_made = false;
    m_measure("compute_seamless_similarity_map()", [&](const auto& visitor) {
      auto refined = std::make_unique<Mesh>();
      const auto uv = refined->add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
      const auto report =
          T::compute_seamless_similarity_map(m_mesh, m_signature, *refined, uv, CGAL::parameters::visitor(visitor));
      if (report.success()) {
        is_made = true;
        m_refined = std::move(refined);
      }
      return is_interrupted<T::Similarity_map_status>(report);
    });
    if (!is_made)
      return false;
    const auto uv = m_refined->property_map<Halfedge, Kernel::Point_2>("h:uv").first;
    const std::string file = (std::filesystem::temp_directory_path() / "cancel_latency_map.obj").string();
    T::write_map_obj(file, *m_refined, uv);
    m_measure("read_map_obj()", [&](const auto& visitor) {
      Mesh mesh;
      const auto map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
      return is_interrupted<T::Mesh_reading_status>(
          T::read_map_obj(file, mesh, map, CGAL::parameters::visitor(visitor)));
    });
    std::filesystem::remove(file);
    m_map.emplace(*m_refined);
    m_measure("make_exactly_seamless()", [&](const auto& visitor) {
      T::Seamless_map<Mesh, FT> map(*m_refined);
      const auto report = T::make_exactly_seamless(*m_refined, uv, map, CGAL::parameters::visitor(visitor));
      if (report.success())
        m_map = std::move(map);
      return is_interrupted<T::Exact_map_status>(report);
    });
    return true;
  }

  bool make_t_mesh()
  {
    bool is_traced = false;
    m_measure("trace_motorcycle_graph()", [&](const auto& visitor) {
      auto traced = std::make_unique<Traced>();
      const auto report =
          T::trace_motorcycle_graph(*m_map, traced->t_mesh, P::face_anchor_map(traced->anchors).visitor(visitor));
      if (report.success()) {
        is_traced = true;
        m_traced = std::move(traced);
      }
      return is_interrupted<T::Motorcycle_graph_status>(report);
    });
    if (!is_traced)
      return false;
    T::Carried_surface<Mesh> traced_surface;
    m_measure("carry_surface()", [&](const auto& visitor) {
      auto surface = T::carry_surface(*m_map, m_traced->t_mesh, m_traced->anchors, CGAL::parameters::visitor(visitor));
      const bool is_cancelled = surface.triangles().empty();
      if (!is_cancelled)
        traced_surface = std::move(surface);
      return is_cancelled;
    });
    std::optional<T::Carried_anchors<Mesh, Mesh, FT>> roots;
    m_measure("regularize_T_mesh()", [&](const auto& visitor) {
      Traced copy = *m_traced;
      T::Carried_surface<Mesh> surface = traced_surface;
      T::Carried_anchors<Mesh, Mesh, FT> own_roots(copy.t_mesh.graph(), copy.anchors);
      const auto report = T::regularize_T_mesh(
          copy.t_mesh, P::observer(T::T_mesh_observer_pair(surface.observer(), own_roots)).visitor(visitor));
      if (report.success()) {
        m_t_mesh = copy.t_mesh;
        m_surface = std::move(surface);
        roots = own_roots;
      }
      return is_interrupted<T::T_mesh_regularization_status>(report);
    });
    m_measure("place_T_mesh()", [&](const auto& visitor) {
      return is_interrupted<T::T_mesh_placement_status>(
          T::place_T_mesh(*m_map, m_t_mesh, *roots, CGAL::parameters::visitor(visitor)));
    });
    m_measure("refine_T_mesh()", [&](const auto& visitor) {
      Exact_t_mesh copy = m_t_mesh;
      T::Carried_surface<Mesh> surface = m_surface;
      const T::T_mesh_coordinates coordinates(copy);
      const T::Parametric_face_size<T::Const_T_mesh_view_of<Exact_t_mesh>> size(coordinates);
      const double target = size(*copy.graph().faces().begin()).first / 16;
      return is_interrupted<T::T_mesh_refinement_status>(T::refine_T_mesh(
          copy, size, target, P::observer(surface.observer()).visitor(visitor).number_of_iterations(20000)));
    });
    m_measure("make_spline_compatible()", [&](const auto& visitor) {
      Exact_t_mesh copy = m_t_mesh;
      T::Carried_surface<Mesh> surface = m_surface;
      return is_interrupted<T::Spline_compatibility_status>(
          T::make_spline_compatible(copy, P::observer(surface.observer()).visitor(visitor)));
    });
    return true;
  }

  bool make_spline()
  {
    bool is_fitted = false;
    m_measure("fit_adaptive_T_spline()", [&](const auto& visitor) {
      const auto report = T::fit_adaptive_T_spline(m_t_mesh, m_surface, m_mesh, m_tolerance, m_spline,
                                                   CGAL::parameters::visitor(visitor));
      is_fitted = is_fitted || report.success();
      return is_interrupted<T::Adaptive_fit_status>(report);
    });
    return is_fitted;
  }

  bool measure_spline()
  {
    m_measure("T_spline_surface", [&](const auto& visitor) {
      const auto surface = T::T_spline_surface(m_spline, m_spline.control_points(), CGAL::parameters::visitor(visitor));
      return is_interrupted<T::T_spline_status>(surface.report());
    });
    const auto surface = m_spline.surface();
    m_measure("compile_T_spline()", [&](const auto& visitor) {
      return T::compile_T_spline(surface, CGAL::parameters::visitor(visitor)).status() ==
             T::T_spline_compilation_status::INTERRUPTED;
    });
    const auto compiled = T::compile_T_spline(surface);
    m_measure("tessellate_T_spline()", [&](const auto& visitor) {
      Mesh mesh;
      return is_interrupted<T::T_spline_tessellation_status>(
          T::tessellate_T_spline(compiled, 8, mesh, CGAL::parameters::visitor(visitor)));
    });
    m_measure("measure_T_spline_deviation()", [&](const auto& visitor) {
      return is_interrupted<T::T_spline_deviation_status>(
          T::measure_T_spline_deviation(compiled, m_mesh, P::tolerance(m_tolerance).visitor(visitor)));
    });
    m_measure("check_T_spline_self_intersections()", [&](const auto& visitor) {
      std::vector<Face> faces;
      return is_interrupted<T::T_spline_self_intersection_status>(T::check_T_spline_self_intersections(
          compiled, m_mesh, std::back_inserter(faces), P::tolerance(m_tolerance).visitor(visitor)));
    });
    return true;
  }

  Measurement m_measure;
  double m_tolerance;
  Mesh m_mesh;
  Signature m_signature;
  std::unique_ptr<Mesh> m_refined;
  std::optional<T::Seamless_map<Mesh, FT>> m_map;
  std::unique_ptr<Traced> m_traced;
  Exact_t_mesh m_t_mesh;
  T::Carried_surface<Mesh> m_surface;
  T::T_spline<Kernel> m_spline;
};

/// writes a mesh after some Loop subdivisions. \return the file, or an empty name after a message.
std::string subdivided(const std::string& file, const int number_of_subdivisions)
{
  if (number_of_subdivisions == 0)
    return file;
  Mesh mesh;
  if (!read_mesh(file, mesh))
    return "";
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(number_of_subdivisions));
  const std::string result = (std::filesystem::temp_directory_path() / "cancel_latency.off").string();
  std::ofstream output(result);
  output.precision(17);
  output << mesh;
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  run_with_one_blas_thread(argv);
  Arguments arguments("cancel_latency [options] mesh...\n\n"
                      "Runs the whole way from a mesh to a T-spline with a visitor that takes the time between its\n"
                      "questions; then cancels each function at random times. Prints CPU seconds by stage: the\n"
                      "longest time between two questions, begin and end of the function included, and the longest\n"
                      "time from a cancellation to the end of the function.\n\n"
                      "  --subdivide N      Loop subdivisions of the mesh (0)\n"
                      "  --cancellations N  of each function (5)\n"
                      "  --tolerance X      of the fit, by the longest side (0.005)\n"
                      "  --seed N           of the times (1)\n",
                      {}, {"--subdivide", "--cancellations", "--tolerance", "--seed"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  bool is_success = true;
  for (const std::string& file : arguments.files()) {
    const std::string input = subdivided(file, arguments.integer("--subdivide", 0));
    std::printf("%s\n", name_of(file).c_str());
    is_success = !input.empty() && Pipeline(arguments).run(input) && is_success;
    if (input != file)
      std::filesystem::remove(input);
  }
  return is_success ? 0 : 2;
}
