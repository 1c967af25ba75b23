// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_PARAMETER_CORRECTION_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_PARAMETER_CORRECTION_H

#include <CGAL/T_splines/Spline/internal/Fitting_system.h>
#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A point in a face of `T_mesh_arrays`.
template <typename FT>
struct Indexed_place {
  int face;
  FT u, v;
};

/// Moves a place by the vector (du, dv) in the frame of its face, straight on across the edges that it meets; along a
/// border where it meets one. After many crossings, where the T-mesh spirals, it stays where it is.
template <typename FT>
Indexed_place<FT> moved(const T_mesh_arrays<FT>& t_mesh, Indexed_place<FT> p, FT du, FT dv)
{
  constexpr int many_crossings = 64;
  for (int crossing = 0; crossing < many_crossings; ++crossing) {
    const FT width = t_mesh.width(p.face), height = t_mesh.height(p.face);
    // Of the way, until a side is met.
    FT t(1);
    int side = -1;
    const auto meet = [&](const int s, const FT& distance, const FT& speed) {
      if (speed > FT(0) && distance < t * speed) {
        t = (std::max)(FT(0), distance / speed);
        side = s;
      }
    };
    meet(0, p.v, -dv);
    meet(1, width - p.u, du);
    meet(2, height - p.v, dv);
    meet(3, p.u, -du);
    p.u = (std::clamp)(FT(p.u + t * du), FT(0), width);
    p.v = (std::clamp)(FT(p.v + t * dv), FT(0), height);
    if (side < 0)
      return p;
    du *= FT(1) - t;
    dv *= FT(1) - t;
    const FT distance = side == 0 ? p.u : side == 1 ? p.v : side == 2 ? FT(width - p.u) : FT(height - p.v);
    int h = t_mesh.first_of_side(p.face, side);
    while (!t_mesh.is_corner(h) && t_mesh.end(h) < distance)
      h = t_mesh.next(h);
    const int o = T_mesh_arrays<FT>::opposite(h);
    if (t_mesh.is_border(o)) {
      (side % 2 == 0 ? dv : du) = FT(0);
      continue;
    }
    const Similarity_2<FT> transition = t_mesh.transition(h);
    const std::pair<FT, FT> image = transition(p.u, p.v), end = transition(FT(p.u + du), FT(p.v + dv));
    du = end.first - image.first;
    dv = end.second - image.second;
    p.face = t_mesh.face(o);
    p.u = (std::clamp)(image.first, FT(0), t_mesh.width(p.face));
    p.v = (std::clamp)(image.second, FT(0), t_mesh.height(p.face));
  }
  return p;
}

/// Moves the places of samples towards the closest points of a surface nearby (Hoschek, Intrinsic parametrization for
/// approximation, 1988), by some Gauss-Newton steps. A sample is moved only if it comes closer. It does not jump to
/// another sheet of the surface, however close that one is.
///
/// The compiled surface, which is evaluated several times as fast, stands for the surface.
/// \tparam Compiled a `Compiled_T_spline`
template <typename Compiled>
class Parameter_correction {
  using FT = typename Compiled::FT;
  using Point_3 = typename Compiled::Point_3;
  using Vector_3 = typename Compiled::Vector_3;
  using Sample = Fitting_sample<FT>;

public:
  /// \param basis of the surface that was compiled
  Parameter_correction(const Compiled& surface, const T_spline_basis<FT>& basis)
    : m_surface(surface),
      m_basis(basis),
      m_t_mesh(surface.t_mesh_arrays())
  {
  }

  void operator()(Sample& sample) const
  {
    if (!is_at_extraordinary_vertex(sample)) {
      descend(sample);
      return;
    }
    // There the surface has no derivatives: the descent begins beside.
    Sample trial = sample;
    const FT width = m_t_mesh.width(sample.face), height = m_t_mesh.height(sample.face);
    trial.u += FT(trial.u < width / FT(2) ? 0.1 : -0.1) * width;
    trial.v += FT(trial.v < height / FT(2) ? 0.1 : -0.1) * height;
    descend(trial);
    if (squared_distance({trial.face, trial.u, trial.v}, sample) <
        squared_distance({sample.face, sample.u, sample.v}, sample))
      sample = trial;
  }

private:
  bool is_at_extraordinary_vertex(const Sample& sample) const
  {
    const int c = m_basis.cone_face_of(sample.face);
    if (c < 0)
      return false;
    const std::pair<FT, FT> p = m_basis.cone_faces()[c].to_unit_square(sample.u, sample.v);
    constexpr FT tolerance = FT(1e-9); // by the unit square: there, derivatives are not bounded
    return p.first <= tolerance && p.second <= tolerance;
  }

  void descend(Sample& sample) const
  {
    constexpr int number_of_steps = 4;
    for (int i = 0; i < number_of_steps; ++i)
      if (!step(sample))
        return;
  }

  FT squared_distance(const Indexed_place<FT>& p, const Sample& sample) const
  {
    const Point_3 q = m_surface.position(m_surface.indexing().face(p.face), p.u, p.v);
    const FT x = q.x() - sample.point[0], y = q.y() - sample.point[1], z = q.z() - sample.point[2];
    return x * x + y * y + z * z;
  }

  // Returns whether another step may help.
  bool step(Sample& sample) const
  {
    const auto jet = m_surface.jet(m_surface.indexing().face(sample.face), sample.u, sample.v);
    const Vector_3 rest(sample.point[0] - jet.position.x(), sample.point[1] - jet.position.y(),
                        sample.point[2] - jet.position.z());
    const FT a = jet.du * jet.du, b = jet.du * jet.dv, c = jet.dv * jet.dv, determinant = a * c - b * b;
    if (!(determinant > FT(parallel_tangents) * a * c))
      return false;
    const FT p = rest * jet.du, q = rest * jet.dv, width = m_t_mesh.width(sample.face),
             height = m_t_mesh.height(sample.face);
    const FT du = (c * p - b * q) / determinant, dv = (a * q - b * p) / determinant;
    const FT length = (std::max)(std::abs(du) / width, std::abs(dv) / height); // by the face
    const FT before = rest * rest;
    constexpr int number_of_trials = 4;
    constexpr double smallest_step = 1e-3; // by the face: convergence is quadratic, so the next one would be tiny
    FT factor(1);
    for (int trial = 0; trial < number_of_trials; ++trial, factor /= FT(4)) {
      const Indexed_place<FT> place = moved(m_t_mesh, {sample.face, sample.u, sample.v}, factor * du, factor * dv);
      if (squared_distance(place, sample) < before) {
        sample.face = place.face;
        sample.u = place.u;
        sample.v = place.v;
        return factor * length > FT(smallest_step);
      }
    }
    return false;
  }

  const Compiled& m_surface;
  const T_spline_basis<FT>& m_basis;
  const T_mesh_arrays<FT>& m_t_mesh;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_PARAMETER_CORRECTION_H
