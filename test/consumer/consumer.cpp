// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines.h>

#ifndef CGAL_EIGEN3_ENABLED
#error "the package's target has to pass on the definitions of its dependencies"
#endif

int main()
{
  const CGAL::T_splines::Similarity_2<double> quarter_turn(1, 2.0, 0.0, 0.0);
  const bool good = compose(quarter_turn, quarter_turn.inverse()).is_identity();
  return good ? 0 : 1;
}
