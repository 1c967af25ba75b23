// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_COUNTING_VISITOR_H
#define T_SPLINES_TEST_COUNTING_VISITOR_H

#include <CGAL/T_splines/Progress_visitor.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

/// What a function has told and asked its visitor.
struct Visitor_record {
  int last_question = (std::numeric_limits<int>::max)(); ///< the one that is answered by no
  int number_of_questions = 0;
  std::string stage;
  double fraction = -1; ///< the last one of the stage
};

/// Says no to a given question, counts them, and checks what it is told: a stage comes first, fractions are in [0, 1] and do
/// not fall within a stage, and after the no there is nothing more.
class Counting_visitor : public CGAL::T_splines::Progress_visitor {
public:
  explicit Counting_visitor(Visitor_record& record) : m_record(&record) {}

  void begin_stage(const char* name) const
  {
    check_that_it_goes_on();
    m_record->stage = name;
    m_record->fraction = -1;
    CHECK_FALSE(m_record->stage.empty());
  }

  void progress(const double fraction) const
  {
    check_that_it_goes_on();
    check_stage();
    CHECK(fraction >= (std::max)(0., m_record->fraction));
    CHECK(fraction <= 1);
    m_record->fraction = fraction;
  }

  bool go_on() const
  {
    check_that_it_goes_on();
    check_stage();
    return ++m_record->number_of_questions != m_record->last_question;
  }

private:
  // Catch2's assertions take their time.
  void check_that_it_goes_on() const
  {
    if (m_record->number_of_questions >= m_record->last_question)
      FAIL_CHECK("the visitor hears something after it has said no");
  }
  void check_stage() const
  {
    if (m_record->stage.empty())
      FAIL_CHECK("no stage has begun");
  }

  Visitor_record* m_record;
};

/// Runs a function to its end, and then cancels it at its first, its second, its middle and its last question.
/// \param function takes a visitor and returns whether it was interrupted; it starts anew each time, and checks what it
///        has written
template <typename Function>
void check_cancelling(const Function& function)
{
  Visitor_record whole;
  REQUIRE_FALSE(function(Counting_visitor(whole)));
  const int n = whole.number_of_questions;
  REQUIRE(n > 0);
  for (const int question : std::set<int>{1, (std::min)(2, n), (n + 1) / 2, n}) {
    CAPTURE(question, n);
    Visitor_record record;
    record.last_question = question;
    CHECK(function(Counting_visitor(record)));
    CHECK(record.number_of_questions == question);
  }
}

#endif // T_SPLINES_TEST_COUNTING_VISITOR_H
