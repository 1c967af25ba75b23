// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_PROGRESS_H
#define CGAL_T_SPLINES_INTERNAL_PROGRESS_H

#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A progress visitor without its type: what algorithms report to and ask, so that they are not compiled anew for each
/// visitor.
///
/// Once the visitor has said no, it is not asked again, and all questions are answered by no. Functions then return as
/// soon as they can, with whatever they have; the public function looks at `is_interrupted()` before it writes anything.
class Progress {
public:
  /// Nobody listens.
  Progress() = default;

  /// \param visitor it must outlive this
  template <typename Visitor>
  explicit Progress(const Visitor& visitor)
  {
    if constexpr (!std::is_same<Visitor, Progress_visitor>::value) {
      m_visitor = &visitor;
      m_functions = &functions_of<Visitor>;
    }
  }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin_stage(const char* const name)
  {
    m_fraction = -1;
    m_begin = 0;
    m_end = 1;
    if (m_functions != nullptr && !m_is_interrupted)
      m_functions->begin_stage(m_visitor, name);
  }

  /// \param fraction of the stage, or of the present part of it. The visitor hears of it if it has grown.
  void progress(const double fraction)
  {
    if (m_functions == nullptr || m_is_interrupted)
      return;
    const double of_stage = m_begin + std::clamp(fraction, 0., 1.) * (m_end - m_begin);
    if (!(of_stage > m_fraction))
      return;
    m_fraction = (std::min)(of_stage, 1.);
    m_functions->progress(m_visitor, m_fraction);
  }

  /// Asks the visitor.
  bool go_on()
  {
    m_work = 0;
    if (m_functions != nullptr && !m_is_interrupted)
      m_is_interrupted = !m_functions->go_on(m_visitor);
    return !m_is_interrupted;
  }

  /// Asks the visitor if much has been done since it was asked last, for inner loops: no clock is read.
  /// \param work what was done since this was called last, in units of about a hundred machine instructions
  bool go_on_after(const std::size_t work)
  {
    m_work += work;
    return m_work < work_per_question ? !m_is_interrupted : go_on();
  }

  /// Whether the visitor has said no.
  bool is_interrupted() const { return m_is_interrupted; }

  /// While it lives, the fractions that are reported are those of a part of the stage.
  class Part {
  public:
    /// \param begin, end fractions of what the stage or the enclosing part is
    Part(Progress& progress, const double begin, const double end)
      : m_progress(progress),
        m_begin(progress.m_begin),
        m_end(progress.m_end)
    {
      progress.m_begin = m_begin + begin * (m_end - m_begin);
      progress.m_end = m_begin + end * (m_end - m_begin);
    }
    ~Part()
    {
      m_progress.m_begin = m_begin;
      m_progress.m_end = m_end;
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

  private:
    Progress& m_progress;
    double m_begin, m_end;
  };

private:
  // Some milliseconds, and not less than a percent of them for the question.
  static constexpr std::size_t work_per_question = 1 << 16;

  struct Functions {
    void (*begin_stage)(const void* visitor, const char* name);
    void (*progress)(const void* visitor, double fraction);
    bool (*go_on)(const void* visitor);
  };

  template <typename Visitor>
  static constexpr Functions functions_of = {
      [](const void* const visitor, const char* const name) {
        static_cast<const Visitor*>(visitor)->begin_stage(name);
      },
      [](const void* const visitor, const double fraction) {
        static_cast<const Visitor*>(visitor)->progress(fraction);
      },
      [](const void* const visitor) { return static_cast<bool>(static_cast<const Visitor*>(visitor)->go_on()); }};

  const void* m_visitor = nullptr;
  const Functions* m_functions = nullptr; // null: nobody listens
  double m_fraction = -1;                 // the largest one of the stage that was reported
  double m_begin = 0, m_end = 1;          // of the present part of the stage
  std::size_t m_work = 0;                 // since the last question
  bool m_is_interrupted = false;
};

/// The visitor with which a public function calls another one: questions and fractions are passed on, stages are not.
class Part_visitor {
public:
  explicit Part_visitor(Progress& progress) : m_progress(&progress) {}

  void begin_stage(const char* /*name*/) const {}
  void progress(const double fraction) const { m_progress->progress(fraction); }
  bool go_on() const { return m_progress->go_on(); }

private:
  Progress* m_progress;
};

/// The visitor among named parameters: a copy, or the one that does nothing.
template <typename NamedParameters>
auto progress_visitor(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor),
                                            Progress_visitor());
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_PROGRESS_H
