// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// How long on a surface a unit step along u and one along v are, fitted to points (u, v) with their places in space.
//
// The squared distances of pairs of nearby points are fitted by a first fundamental form; chords of nearby points are
// hardly shorter than the surface between them, however the whole patch is bent.
class Metric_fit {
public:
  struct Sample {
    double u, v;
    std::array<double, 3> p;
  };

  // A result with zeros means that nothing could be measured.
  // pre: the samples are in a rectangle of the given size
  static std::array<double, 2> lengths(std::vector<Sample> samples, const double width, const double height)
  {
    Metric_fit fit;
    for (Sample& s : samples) {
      s.u /= width;
      s.v /= height;
    }
    fit.add_pairs(samples, &Sample::u, &Sample::v);
    fit.add_pairs(samples, &Sample::v, &Sample::u);
    const std::array<double, 2> result = fit.solve(width, height);
    return {result[0] / width, result[1] / height};
  }

private:
  // Pairs along strips across the patch, about as many strips as points in each.
  void add_pairs(std::vector<Sample>& samples, double Sample::*const across, double Sample::*const along)
  {
    const double strips = std::ceil(std::sqrt(static_cast<double>(samples.size())));
    const auto strip = [&](const Sample& s) { return std::floor(s.*across * strips); };
    std::stable_sort(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
      return strip(a) != strip(b) ? strip(a) < strip(b) : a.*along < b.*along;
    });
    for (std::size_t i = 1; i < samples.size(); ++i) {
      if (strip(samples[i - 1]) == strip(samples[i]) || samples.size() < 9)
        add_pair(samples[i - 1], samples[i]);
    }
  }

  // Each pair has the same weight, however long it is.
  void add_pair(const Sample& a, const Sample& b)
  {
    const double u = b.u - a.u, v = b.v - a.v, length = u * u + v * v;
    if (!(length > 0))
      return;
    double distance = 0;
    for (int i = 0; i < 3; ++i)
      distance += (b.p[i] - a.p[i]) * (b.p[i] - a.p[i]);
    const Eigen::Vector3d row = Eigen::Vector3d(u * u, u * v, v * v) / length;
    m_matrix += row * row.transpose();
    m_right += row * (distance / length);
    m_squares += Eigen::Vector2d(row[0], row[2]);
    m_distance += distance / length;
    m_pairs += 1;
  }

  // Lengths of the whole sides. Too few or too different pairs give the same for a unit step along both axes.
  std::array<double, 2> solve(const double width, const double height) const
  {
    if (m_pairs == 0)
      return {0, 0};
    const double mean = m_distance / m_pairs;
    Eigen::FullPivLU<Eigen::Matrix3d> lu(m_matrix);
    lu.setThreshold(1e-2);
    if (m_pairs >= 6 && lu.isInvertible()) {
      const Eigen::Vector3d form = lu.solve(m_right);
      if (form[0] > 0.01 * mean && form[2] > 0.01 * mean)
        return {std::sqrt(form[0]), std::sqrt(form[2])};
    }
    // distance^2 = s^2 (w^2 u^2 + h^2 v^2), summed up.
    const double unit = std::sqrt(m_distance / (width * width * m_squares[0] + height * height * m_squares[1]));
    return {unit * width, unit * height};
  }

  Eigen::Matrix3d m_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
  Eigen::Vector2d m_squares = Eigen::Vector2d::Zero();
  double m_distance = 0, m_pairs = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H
