// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_FIT_VISITOR_H
#define MESH_TO_T_SPLINE_FIT_VISITOR_H

#include "Progress.h"

#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

/// Shows the levels of a fit as they come, and keeps their files: a level observer.
class Level_recorder {
public:
  /// \param tolerance by the longest side
  /// \param files receives the files of the levels; null if they are not wanted
  Level_recorder(Progress& progress, const double tolerance, std::vector<std::string>* files)
    : m_progress(progress),
      m_tolerance(tolerance),
      m_files(files)
  {
  }

  bool go_on() const { return interruption_flag == 0; }
  void show() { m_progress.progress(m_fraction); }

  template <typename TMesh>
  void operator()(const CGAL::T_splines::T_spline_fit_level& level, const TMesh& t_mesh)
  {
    const double error = level.error.relative_maximum();
    if (m_number_of_levels == 0)
      m_first_error = error;
    else
      m_fraction = std::max(m_fraction, share_of_way(error));
    char note[80];
    std::snprintf(note, sizeof(note), "level %d: %zu control points, max %.3g %%", m_number_of_levels++,
                  level.number_of_control_points, 100 * error);
    m_progress.set_note(note, m_fraction);
    if (m_files == nullptr)
      return;
    std::ostringstream file;
    CGAL::T_splines::write_t_mesh(file, t_mesh);
    m_files->push_back(file.str());
  }

private:
  /// How much of the way from the first error to the tolerance lies behind, each halving being as long as the other.
  double share_of_way(const double error) const
  {
    if (!(error > m_tolerance))
      return 1;
    return std::log(m_first_error / error) / std::log(m_first_error / m_tolerance);
  }

  Progress& m_progress;
  double m_tolerance, m_first_error = 0, m_fraction = 0;
  int m_number_of_levels = 0;
  std::vector<std::string>* m_files;
};

/// The visitor that the fit is given: a handle of `Level_recorder`. How far a level is, is no progress of the whole.
class Fit_visitor : public CGAL::T_splines::Progress_visitor {
public:
  explicit Fit_visitor(Level_recorder& recorder) : m_recorder(&recorder) {}

  void progress(double) const { m_recorder->show(); }
  bool go_on() const { return m_recorder->go_on(); }

private:
  Level_recorder* m_recorder;
};

#endif // MESH_TO_T_SPLINE_FIT_VISITOR_H
