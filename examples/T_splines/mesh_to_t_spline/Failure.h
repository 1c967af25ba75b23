// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_FAILURE_H
#define MESH_TO_T_SPLINE_FAILURE_H

#include <string>

/// Why a stage has no result, and whether the input is to blame; an empty message means that it has one.
struct Failure {
  std::string message;
  bool is_bad_input = false;

  explicit operator bool() const { return !message.empty(); }
};

#endif // MESH_TO_T_SPLINE_FAILURE_H
