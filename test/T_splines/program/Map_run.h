// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_PROGRAM_MAP_RUN_H
#define T_SPLINES_TEST_PROGRAM_MAP_RUN_H

#include "../IO/Soup.h"
#include "Program_test.h"

#include <string>

/// Runs the program on a soup as far as the map.
struct Map_run {
  Temporary_directory directory;
  std::string mesh, output;
  Program_run run;

  Map_run(const Soup& soup, const std::string& extension, const std::string& options)
    : mesh(write(soup, directory.file("soup" + extension))),
      output(directory.file("output")),
      run("'" + mesh + "' --map-only " + options + " -o '" + output + "'")
  {
  }

  static std::string write(const Soup& soup, const std::string& name)
  {
    soup.write(name);
    return name;
  }
  std::string report() const { return file_content(output + "/report.json"); }
};

#endif // T_SPLINES_TEST_PROGRAM_MAP_RUN_H
