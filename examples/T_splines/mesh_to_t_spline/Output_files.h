// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OUTPUT_FILES_H
#define MESH_TO_T_SPLINE_OUTPUT_FILES_H

#include "Figures.h"
#include "Options.h"
#include "Results.h"

#include <filesystem>
#include <string>

/// \return why nothing can be written to the directory, as far as this can be told beforehand; empty if all seems well.
std::string check_output_directory(const std::filesystem::path& directory);

/// \return that the run would replace its own input; empty if it would not.
std::string check_input_stays(const Options& options);

/// Writes all files of the run, or none. Then removes those that an earlier run has left in the directory and this one
/// does not write: they have the names of files of this program, and `report.json` tells that there was such a run.
/// Files of the input are never removed.
/// \param names receives the names of the files
/// \return what went wrong; empty if nothing did.
std::string write_output_files(const Options& options, const Results& results, const Figures& figures,
                               std::string& names);

#endif // MESH_TO_T_SPLINE_OUTPUT_FILES_H
