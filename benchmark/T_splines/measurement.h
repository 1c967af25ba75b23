// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_MEASUREMENT_H
#define T_SPLINES_BENCHMARK_MEASUREMENT_H

#include <CGAL/T_splines/Progress_visitor.h>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

// What the benchmarks measure with: POSIX, and glibc's malloc_trim().

/// returns the CPU seconds that the process has used.
inline double cpu_seconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// starts the program again with one BLAS thread, unless the environment says how many: OpenBLAS reads it when it is
/// loaded. CPU seconds would otherwise contain those of threads that wait.
inline void run_with_one_blas_thread(char** argv)
{
  if (std::getenv("OPENBLAS_NUM_THREADS") != nullptr)
    return;
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  execv("/proc/self/exe", argv);
}

/// returns the smallest number of CPU seconds that `function()` takes in `repeats` calls.
template <typename Function>
double best_cpu_seconds(const int repeats, Function&& function)
{
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const double start = cpu_seconds();
    function();
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

/// CPU seconds per stage of a computation, taken by `Stage_clock`.
class Stage_times {
public:
  void begin(const std::string& stage)
  {
    end();
    m_stage = stage;
  }
  void end()
  {
    const double now = cpu_seconds();
    m_seconds[m_stage] += now - m_start;
    m_start = now;
    m_stage = before_the_first;
  }

  double operator[](const std::string& stage) const
  {
    const auto found = m_seconds.find(stage);
    return found == m_seconds.end() ? 0. : found->second;
  }

  /// The checks and conversions ahead of the first stage, and what comes after `end()`.
  static constexpr const char* before_the_first = "";

private:
  std::map<std::string, double> m_seconds;
  std::string m_stage = before_the_first;
  double m_start = cpu_seconds();
};

/// The visitor that times stages.
class Stage_clock : public CGAL::T_splines::Progress_visitor {
public:
  explicit Stage_clock(Stage_times& times) : m_times(&times) {}

  void begin_stage(const char* name) const { m_times->begin(name); }

private:
  Stage_times* m_times;
};

/// The stages of a whole map.
struct Map_times {
  double metric = 0, layout = 0, subdivision = 0, output = 0, whole = 0;

  explicit Map_times(const Stage_times& times)
    : metric(times["similarity metric"]),
      layout(times["layout"]),
      subdivision(times["subdivision"]),
      output(times["output"]),
      whole(times[Stage_times::before_the_first] + metric + layout + subdivision + output)
  {
  }

  /// From the metric to the refined mesh, but for writing it into a face graph.
  double after_metric() const { return layout + subdivision; }
};

/// The memory of a process in bytes.
struct Memory {
  double before = 0; ///< resident when the measured function began: the program, the mesh, its signature
  double peak = 0;   ///< largest resident size
};

/// returns the resident size of the process.
inline double resident_bytes()
{
  long pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident_pages;
  return static_cast<double>(resident_pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// returns the peak memory of `function()`, called in a forked process of its own; the peak is 0 if that did not end well.
template <typename Function>
Memory memory_in_child(Function&& function)
{
  malloc_trim(0); // what is free, but not given back, would hide what the child allocates
  std::fflush(stdout);
  Memory memory;
  memory.before = resident_bytes();
  const pid_t child = fork();
  if (child == 0) {
    function();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  if (child > 0 && wait4(child, &status, 0, &usage) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0)
    memory.peak = 1024. * static_cast<double>(usage.ru_maxrss);
  return memory;
}

/// returns the exponent p of the power law c n^p that fits the times best in the sense of least squares of the logarithms.
inline double fitted_exponent(const std::vector<std::pair<double, double>>& n_and_seconds)
{
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [n, seconds] : n_and_seconds) {
    x += std::log(n);
    y += std::log(seconds);
    xx += std::log(n) * std::log(n);
    xy += std::log(n) * std::log(seconds);
  }
  const double count = static_cast<double>(n_and_seconds.size());
  return (count * xy - x * y) / (count * xx - x * x);
}

#endif // T_SPLINES_BENCHMARK_MEASUREMENT_H
