// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fitting of T-spline surfaces: one fit against plain normal equations; errors and seconds of an adaptive fit by level.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Approximation/Surface_T_mesh.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/fit_T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/carry_surface.h>
#include <CGAL/T_splines/Tracing/sample_T_mesh.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace T = CGAL::T_splines;
using Point_3 = Kernel::Point_3;
using FT = CGAL::Exact_rational;
using Sample = T::T_mesh_sample<Mesh, Kernel>;
using Samples = T::Carried_samples<Mesh, Sample>;
using Exact_t_mesh = T::T_mesh<Point_3, FT>;
using Surface = T::T_spline_surface<T::Const_T_mesh_view_of<Exact_t_mesh>, Mesh::Property_map<Vertex, Point_3>>;
using Control_points = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Matrix = Eigen::SparseMatrix<double>;

const char* const usage =
    "Usage: t_spline_fit_speed [OPTION...] [MESH...]\n\n"
    "Fits T-spline surfaces to meshes; without files, to a sphere with bumps of 10242 vertices.\n\n"
    "One fit without correction, on a T-mesh of faces of even size: CPU seconds of fit_T_spline() with and without\n"
    "fairness, against those of the problem without fairness done plainly, with the basis functions of each sample,\n"
    "triplets, and Eigen's SimplicialLDLT or ConjugateGradient (Jacobi's preconditioner); how far their control\n"
    "points are from those without fairness, by the longest side of the bounding box, if the samples determine these.\n"
    "The adaptive fit, from the coarsest T-mesh: control points, errors by the longest side, CPU seconds of each "
    "level.\n\n"
    "  --samples N    of the one fit (200000)\n"
    "  --size X       of its faces, by the diagonal of the bounding box (0.05)\n"
    "  --tolerance X  of the adaptive fit, by the longest side of the bounding box (0.001)\n"
    "  --repeats N    of each time of one fit the best of N is told (3)\n";

struct Problem {
  Exact_t_mesh t_mesh;
  Samples carried_samples;

  const std::vector<Sample>& samples() const { return carried_samples.samples(); }
};

/// A sphere with bumps, of genus 0 and without symmetries.
void make_sphere(Mesh& mesh)
{
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(5));
  for (const Vertex v : vertices(mesh)) {
    const Kernel::Vector_3 n = mesh.point(v) - CGAL::ORIGIN;
    const double r = std::sqrt(n.squared_length()), x = n.x() / r, y = n.y() / r, z = n.z() / r;
    const double radius = 1 + 0.1 * std::sin(5 * x + 1) * std::cos(4 * y) + 0.08 * std::sin(6 * z + 2 * x * y);
    mesh.point(v) = CGAL::ORIGIN + (radius / r) * n;
  }
}

/// \return `false` after a message
template <typename Report>
bool is_success(const std::string& name, const Report& report)
{
  if (!report.success())
    std::cerr << name << ": " << message(report.status) << '\n';
  return report.success();
}

/// The map of a mesh whose cones are reduced.
bool make_map(const std::string& name, Mesh& mesh, Mesh& refined, std::optional<T::Seamless_map<Mesh, FT>>& map)
{
  Signature signature;
  const auto uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  return make_field_signature(name, mesh, signature) && is_success(name, T::reduce_cones(mesh, signature)) &&
         is_success(name, T::compute_seamless_similarity_map(mesh, signature, refined, uv)) &&
         is_success(name, T::make_exactly_seamless(refined, uv, map.emplace(refined)));
}

/// The T-mesh of a map, regular and with faces of the given size on the surface, and its samples.
bool make_problem(const std::string& name, const T::Seamless_map<Mesh, FT>& map, const std::size_t number_of_samples,
                  const double face_size, Problem& p)
{
  namespace P = T::parameters;
  const auto anchors = p.t_mesh.graph().add_property_map<Face, T::T_mesh_anchor<Mesh, FT>>("f:anchor").first;
  std::vector<T::T_mesh_place<Mesh, double>> places(map.mesh().number_of_vertices());
  const auto place_map = boost::make_iterator_property_map(places.begin(), get(boost::vertex_index, map.mesh()));
  if (!is_success(
          name, T::trace_motorcycle_graph(map, p.t_mesh, P::vertex_place_map(place_map, P::face_anchor_map(anchors)))))
    return false;
  T::sample_T_mesh(map, p.t_mesh, anchors, place_map, std::back_inserter(p.carried_samples),
                   P::number_of_samples(number_of_samples));
  T::regularize_T_mesh(p.t_mesh, P::observer(p.carried_samples.observer()));
  const T::T_mesh_coordinates coordinates(p.t_mesh);
  T::Surface_face_size size(coordinates, p.carried_samples);
  const auto np = P::observer(size.observer());
  return is_success(name, T::refine_T_mesh(p.t_mesh, size, face_size, np)) &&
         is_success(name, T::make_spline_compatible(p.t_mesh, np));
}

/// The normal equations as one would write them down: a row of basis functions per sample.
struct Plain_system {
  Matrix matrix; ///< the lower triangle
  Control_points right;

  Plain_system(const Surface& surface, const std::vector<Sample>& samples)
  {
    const int n = static_cast<int>(surface.number_of_control_points());
    std::vector<Eigen::Triplet<double>> triplets;
    std::vector<T::Basis_function_jet<Mesh, double>> functions;
    right = Control_points::Zero(n, 3);
    for (const Sample& s : samples) {
      functions.clear();
      surface.basis_functions(s.place.face, s.place.u, s.place.v, std::back_inserter(functions));
      double sum = 0;
      for (const auto& b : functions)
        sum += b.value;
      for (const auto& b : functions) {
        const int i = surface.indexing().vertex_index(b.vertex);
        const double value = s.weight * b.value / sum;
        right.row(i) += value * Eigen::RowVector3d(s.point.x(), s.point.y(), s.point.z());
        for (const auto& c : functions)
          if (const int j = surface.indexing().vertex_index(c.vertex); j <= i)
            triplets.emplace_back(i, j, value * c.value / sum);
      }
    }
    matrix.resize(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
  }
};

/// The largest distance between control points.
double difference(const Surface& surface, const Control_points& points)
{
  double largest = 0;
  for (const Vertex v : vertices(surface.graph())) {
    const Point_3& p = surface.graph().point(v);
    const Eigen::RowVector3d q(p.x(), p.y(), p.z());
    largest = std::max(largest, (points.row(surface.indexing().vertex_index(v)) - q).norm());
  }
  return largest;
}

/// CPU seconds of fit_T_spline(); none after a message if it fails.
std::optional<double> fit_seconds(const std::string& name, Problem& p, const double fairness, const int corrections,
                                  const int repeats)
{
  bool is_fitted = true;
  std::vector<Sample> samples;
  const double seconds = best_cpu_seconds(repeats, [&] {
    samples = p.samples();
    is_fitted = is_fitted &&
                is_success(name, T::fit_T_spline(p.t_mesh, samples, p.t_mesh.graph().points(),
                                                 T::parameters::fairness(fairness).number_of_iterations(corrections)));
  });
  return is_fitted ? std::optional<double>(seconds) : std::nullopt;
}

void measure_one_fit(const std::string& name, const T::Seamless_map<Mesh, FT>& map, const CGAL::Bbox_3& box,
                     const Arguments& arguments)
{
  const int repeats = std::max(1, arguments.integer("--repeats", 3));
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  Problem p;
  if (!make_problem(name, map, static_cast<std::size_t>(std::max(1, arguments.integer("--samples", 200000))),
                    arguments.real("--size", 0.05) * diagonal, p))
    return;
  Control_points direct, iterative;
  Eigen::Index iterations = 0;
  bool is_converged = false;
  const auto plain_surface = [&] { return Surface(p.t_mesh, p.t_mesh.graph().points()); };
  const double direct_seconds = best_cpu_seconds(repeats, [&] {
    const Plain_system system(plain_surface(), p.samples());
    direct = Eigen::SimplicialLDLT<Matrix>(system.matrix).solve(system.right);
  });
  const double iterative_seconds = best_cpu_seconds(repeats, [&] {
    const Plain_system system(plain_surface(), p.samples());
    Eigen::ConjugateGradient<Matrix> solver;
    solver.setTolerance(1e-9);
    solver.setMaxIterations(5000); // singular systems may take any number
    iterative = solver.compute(system.matrix).solve(system.right);
    iterations = solver.iterations();
    is_converged = solver.info() == Eigen::Success;
  });
  const std::optional<double> fair = fit_seconds(name, p, T::default_fairness, 0, repeats),
                              corrected = fit_seconds(name, p, T::default_fairness, 6, 1),
                              unfair = fit_seconds(name, p, 0, 0, repeats); // last: its control points are compared
  if (!fair || !corrected)
    return;
  const double side = std::max({box.x_span(), box.y_span(), box.z_span()});
  const Surface surface = plain_surface();
  const auto print = [&](const std::string& title, const double seconds, const Control_points* const points) {
    std::printf("  %-38s %9.3f %9.2f", title.c_str(), seconds, seconds / *fair);
    if (points != nullptr && unfair)
      std::printf(" %12.2g", difference(surface, *points) / side);
    std::printf("\n");
  };
  std::printf("one fit: %zu samples, %zu control points, %zu faces\n", p.samples().size(),
              surface.number_of_control_points(), static_cast<std::size_t>(num_faces(p.t_mesh.graph())));
  std::printf("  %-38s %9s %9s %12s\n", "", "seconds", "ratio", "difference");
  print("fit_T_spline()", *fair, nullptr);
  print("fit_T_spline() with corrections", *corrected, nullptr);
  if (unfair)
    print("fit_T_spline() without fairness", *unfair, nullptr);
  print("triplets, SimplicialLDLT", direct_seconds, &direct);
  print("triplets, CG, " + std::to_string(iterations) + " iterations" + (is_converged ? "" : " (no end)"),
        iterative_seconds, &iterative);
}

void measure_adaptive_fit(const std::string& name, const T::Seamless_map<Mesh, FT>& map, const double tolerance,
                          const double seconds_of_map)
{
  namespace P = T::parameters;
  const double before = cpu_seconds();
  T::Surface_T_mesh<Mesh, FT> placed;
  if (!is_success(name, T::compute_T_mesh(map, placed)))
    return;
  T::T_spline<Kernel> spline;
  std::vector<double> times{cpu_seconds()};
  const double t_mesh_seconds = times.front() - before;
  const auto report = T::fit_adaptive_T_spline(
      placed.t_mesh(), placed.surface(), map.mesh(), tolerance, spline,
      P::maximum_number_of_control_points(
          map.mesh().number_of_vertices(),
          P::level_observer([&](const auto& /*level*/, const auto& /*t_mesh*/) { times.push_back(cpu_seconds()); })));
  const double end = cpu_seconds();
  if (!report.success()) {
    std::cerr << name << ": " << describe(report, placed.t_mesh().graph()) << '\n';
    return;
  }
  std::printf("adaptive fit: tolerance %.3g %%: %s\n", 100 * tolerance, message(report.status));
  std::printf("  %5s %15s %9s %11s %11s %9s\n", "level", "control points", "in rings", "rms [%]", "max [%]", "seconds");
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    const T::T_spline_fit_level& level = report.levels[i];
    std::printf("  %5zu %15zu %9zu %11.4f %11.4f %9.3f\n", i, level.number_of_control_points,
                level.control_points_in_rings, 100 * level.error.relative_rms(), 100 * level.error.relative_maximum(),
                times[i + 1] - times[i]);
  }
  const double seconds = end - times.front();
  std::printf("  seconds: field and map %.3f, T-mesh %.3f, fit %.3f, together %.3f\n\n", seconds_of_map, t_mesh_seconds,
              seconds, seconds_of_map + t_mesh_seconds + seconds);
}

void measure(const std::string& name, Mesh& mesh, const Arguments& arguments)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  std::printf("%s: %zu vertices\n", name.c_str(), static_cast<std::size_t>(mesh.number_of_vertices()));
  Mesh refined;
  std::optional<T::Seamless_map<Mesh, FT>> map;
  const double start = cpu_seconds();
  if (!make_map(name, mesh, refined, map))
    return;
  const double seconds = cpu_seconds() - start;
  measure_one_fit(name, *map, box, arguments);
  measure_adaptive_fit(name, *map, arguments.real("--tolerance", 0.001), seconds);
}

} // namespace

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {}, {"--samples", "--size", "--tolerance", "--repeats"});
  arguments.allow_no_files();
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  if (arguments.files().empty()) {
    Mesh mesh;
    make_sphere(mesh);
    measure("sphere with bumps", mesh, arguments);
  }
  for (const std::string& file : arguments.files()) {
    Mesh mesh;
    if (!read_mesh(file, mesh))
      return 2;
    measure(name_of(file), mesh, arguments);
  }
  return EXIT_SUCCESS;
}
