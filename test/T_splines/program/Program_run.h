// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_PROGRAM_PROGRAM_RUN_H
#define T_SPLINES_TEST_PROGRAM_PROGRAM_RUN_H

#include "../IO/Temporary_directory.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>

inline std::string file_content(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

/// What mesh_to_t_spline did with some arguments.
struct Program_run {
  int exit_code;
  std::string output, errors;

  /// \param arguments as the shell reads them
  /// \param prefix a command of the shell that goes before, or that runs the program
  explicit Program_run(const std::string& arguments, const std::string& prefix = "")
  {
    const Temporary_directory directory;
    const std::string out = directory.file("out"), err = directory.file("err");
    const std::string command = "(" + prefix + " '" T_SPLINES_EXAMPLES_DIR "/mesh_to_t_spline' " + arguments + ") >'" +
                                out + "' 2>'" + err + "'";
    const int status = std::system(command.c_str());
    exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    output = file_content(out);
    errors = file_content(err);
  }
};

#endif // T_SPLINES_TEST_PROGRAM_PROGRAM_RUN_H
