// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_PROGRESS_H
#define MESH_TO_T_SPLINE_PROGRESS_H

#include "Figures.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

/// Whether the user has asked to stop: the first Ctrl-C ends the run in good order, the second one at once.
inline volatile std::sig_atomic_t interruption_flag = 0;

inline void request_interruption(const int signal)
{
  interruption_flag = 1;
  std::signal(signal, SIG_DFL);
}

/// The largest memory that the program has had so far; 0 if the system does not tell.
inline std::size_t peak_memory_bytes()
{
  // What getrusage() tells may be that of the program which started this one.
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:" && status >> kilobytes)
      return kilobytes * 1024;
  return 0;
}

/// Measures the stages of the run and shows each when it ends, on a terminal also while it lasts.
class Progress {
public:
  explicit Progress(const bool is_quiet) : m_is_quiet(is_quiet)
  {
#if defined(__unix__) || defined(__APPLE__)
    m_is_live = !is_quiet && ::isatty(::fileno(stderr)) != 0;
#endif
  }

  void begin_stage(const std::string& name)
  {
    end_stage();
    m_name = name;
    m_stage_begin = Clock::now();
    show(0);
  }

  /// adds the time of the stage to those of the same name.
  void end_stage()
  {
    if (m_name.empty())
      return;
    const double seconds = seconds_since(m_stage_begin);
    const auto stage =
        std::find_if(m_stages.begin(), m_stages.end(), [this](const auto& s) { return s.name == m_name; });
    if (stage == m_stages.end())
      m_stages.push_back({m_name, seconds, peak_memory_bytes()});
    else {
      stage->seconds += seconds;
      stage->peak_memory_bytes = peak_memory_bytes();
    }
    if (!m_is_quiet) {
      const char* separator = m_note.empty() ? "" : "   ";
      std::fprintf(stderr, "%s%-17s        %8.2f s%s%s\n", m_is_live ? "\r\033[K" : "", m_name.c_str(), seconds,
                   separator, m_note.c_str());
      std::fflush(stderr);
    }
    m_name.clear();
    m_note.clear();
  }

  void progress(const double fraction)
  {
    constexpr double interval = 0.05;
    if (m_is_live && seconds_since(m_shown) >= interval)
      show(fraction);
  }

  /// shows a few words until the stage ends.
  void set_note(const std::string& note, const double fraction)
  {
    m_note = note;
    show(fraction);
  }

  const std::vector<Figures::Stage>& stages() const
  {
    return m_stages;
  }
  double seconds() const
  {
    return seconds_since(m_begin);
  }

private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(const Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  void show(const double fraction)
  {
    if (!m_is_live)
      return;
    m_shown = Clock::now();
    std::fprintf(stderr, "\r\033[K%-17s %3.0f %%  %8.2f s   %s", m_name.c_str(), 100 * std::clamp(fraction, 0., 1.),
                 seconds_since(m_stage_begin), m_note.c_str());
    std::fflush(stderr);
  }

  bool m_is_quiet, m_is_live = false;
  std::string m_name, m_note;
  Clock::time_point m_begin = Clock::now(), m_stage_begin = m_begin, m_shown = m_begin;
  std::vector<Figures::Stage> m_stages;
};

/// The visitor that the algorithms are given: a handle of `Progress`.
class Progress_handle {
public:
  explicit Progress_handle(Progress& progress) : m_progress(&progress) {}
  void begin_stage(const char* name) const { m_progress->begin_stage(name); }
  void progress(const double fraction) const { m_progress->progress(fraction); }
  bool go_on() const { return interruption_flag == 0; }

private:
  Progress* m_progress;
};

#endif // MESH_TO_T_SPLINE_PROGRESS_H
