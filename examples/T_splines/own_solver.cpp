// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Passes other linear solvers to the algorithms: one of Eigen's, and a class of one's own.
//
//   own_solver [MESH]

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Any solver of Eigen for symmetric positive definite matrices that reads the lower triangle.
using Llt_solver = T::Eigen_spd_solver_traits<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>;

// A model of SparseSpdSolverTraits: it counts what it is asked for.
class Counting_solver {
public:
  using FT = double;
  using Matrix = T::Symmetric_sparse_matrix<FT>;

  bool analyze_pattern(const Matrix& a) { return m_solver.analyze_pattern(a); }
  bool factorize(const Matrix& a)
  {
    ++m_factorizations;
    return m_solver.factorize(a);
  }
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    ++m_solves;
    return m_solver.solve(b, x);
  }

  int factorizations() const { return m_factorizations; }
  int solves() const { return m_solves; }

private:
  Llt_solver m_solver;
  int m_factorizations = 0;
  mutable int m_solves = 0;
};

int main(int argc, char* argv[])
{
  const std::string mesh_file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  const auto reading = T::read_triangle_mesh(mesh_file, mesh);
  if (!reading.success()) {
    std::cerr << mesh_file << ": " << describe(reading) << "\n";
    return EXIT_FAILURE;
  }
  const auto cross_field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  T::Holonomy_signature<Mesh> signature;
  const auto with_llt = CGAL::parameters::sparse_linear_solver(Llt_solver()); // by value: the solver can be copied
  if (!T::compute_smooth_cross_field(mesh, cross_field, with_llt).success() ||
      !T::holonomy_signature_of_cross_field(mesh, cross_field, signature).success()) {
    std::cerr << mesh_file << ": there is no signature\n";
    return EXIT_FAILURE;
  }

  Counting_solver solver;
  T::Similarity_metric<Mesh> metric;
  const auto report = T::compute_similarity_metric( // by reference: what it counts is wanted afterwards
      mesh, signature, metric, CGAL::parameters::sparse_linear_solver(std::ref(solver)));
  if (!report.success()) {
    std::cerr << mesh_file << ": " << describe(report, mesh) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << report.iterations << " iterations, " << solver.factorizations() << " factorizations, " << solver.solves()
            << " solves\n";
  return EXIT_SUCCESS;
}
