// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OPTIONS_H
#define MESH_TO_T_SPLINE_OPTIONS_H

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

constexpr std::string_view program_version = "0.1.0";

constexpr std::string_view help_text =
    R"(Usage: mesh_to_t_spline MESH [OPTION...]
       mesh_to_t_spline --uv MAP [OPTION...]

Computes a seamless similarity map of a closed triangle mesh, guided by a cross field, from it a T-mesh with halfedge
knots, and on this a T-spline surface whose control points lie on the mesh; or the T-mesh and the surface from a given
map. It writes map.obj (unless the map is given), t_mesh.ply (the T-spline), t_spline.vtu (Bezier patches),
t_spline.obj (triangles), report.json and report.html.

MESH is an OFF, OBJ, PLY or STL file. Faces that are not triangles are triangulated.

  --uv MAP                  a seamless map: an OBJ file with uv (vt) at every corner; nothing of the next two
                            groups of options goes with it
Guidance (without any, a smooth cross field is computed):
  --field FILE              a cross field: .rawfield, .crossfield, .rosy or .ffield
  --cones FILE              cones: .cones, or total angles: .Th_hat
  --loops K1,K2,...         turning numbers of the homology loops, in quarter turns; with --cones
  --align-curvature X       aligns the computed field to principal curvatures: 0 not at all, 100 well
Computation:
  --solver ldlt|cholmod     the sparse linear solver (ldlt)
  --flips delaunay|degeneracy|degeneracy-only
                            how the triangulation follows the metric: ideal Delaunay flips (delaunay), or flips of
                            degenerating triangles with or without the intrinsic Delaunay property
  --tolerance-residual X    the largest deviation from the prescribed angles, in radians (1e-12)
  --max-iterations N        (100)
  --precision double|extended|quad
                            the number type to begin with; wider ones follow where it does not suffice (double)
T-mesh:
  --no-regularization       the T-mesh as the motorcycles trace it
  --map-only                no T-mesh
T-spline:
  --face-size X             the longest side that a face of the T-mesh may have on the surface, by the diagonal of the
                            bounding box (0.05)
  --resolution N            each side of a face is divided into at least N parts in t_spline.obj (8)
  --no-spline               the T-mesh alone, as it was traced and regularized
Output:
  -o DIR                    where to write; made if it does not exist (.)
  --quiet                   no progress and no summary
  --version, --help

Exit code: 0 all was computed and written, 1 the computation or the writing failed, 2 bad usage or bad input,
130 interrupted. Files are written whole or not at all, and only when all has been computed.
)";

enum class Solver_choice { LDLT, CHOLMOD };
enum class Flips_choice { DELAUNAY, DEGENERACY, DEGENERACY_ONLY };
enum class Precision_choice { DOUBLE, EXTENDED, QUAD };

struct Options {
  std::string mesh, uv, field, cones, output_directory = ".";
  std::optional<std::vector<int>> loops;
  double curvature_alignment = 0, residual_tolerance = 1e-12;
  double face_size = 0.05;
  int max_iterations = 100, resolution = 8;
  Solver_choice solver = Solver_choice::LDLT;
  Flips_choice flips = Flips_choice::DELAUNAY;
  Precision_choice precision = Precision_choice::DOUBLE;
  bool is_map_only = false, is_regularized = true, has_spline = true, is_quiet = false, asks_help = false, asks_version = false;
};

/// Reads the command line.
class Options_parser {
public:
  Options_parser(const int argc, const char* const* argv) : m_arguments(argv + (argc > 0 ? 1 : 0), argv + argc) {}

  /// \return what is wrong with the command line; empty if nothing is.
  std::string parse(Options& options)
  {
    bool are_options_over = false;
    while (m_next < m_arguments.size() && m_error.empty()) {
      const std::string argument = m_arguments[m_next++];
      if (!are_options_over && argument == "--")
        are_options_over = true;
      else if (!are_options_over && argument.size() > 1 && argument[0] == '-')
        parse_option(argument, options);
      else if (options.mesh.empty())
        options.mesh = argument;
      else
        m_error = "more than one mesh is given: " + options.mesh + " and " + argument;
    }
    if (m_error.empty() && !options.asks_help && !options.asks_version)
      check(options);
    return m_error;
  }

private:
  void check(const Options& options)
  {
    if (!options.uv.empty())
      check_given_map(options);
    else if (options.mesh.empty())
      m_error = "no mesh is given";
    else if (!options.field.empty() && !options.cones.empty())
      m_error = "--field and --cones exclude each other";
    else if (options.loops && options.cones.empty())
      m_error = "--loops goes with --cones: a field has turning numbers of its own";
    else if (!m_spline_option.empty() && (options.is_map_only || !options.has_spline))
      m_error = m_spline_option + " goes with a T-spline";
    else if (options.curvature_alignment > 0 && !(options.field.empty() && options.cones.empty()))
      m_error = "--align-curvature is for the computed field";
  }

  void check_given_map(const Options& options)
  {
    if (!options.mesh.empty())
      m_error = "--uv and a mesh exclude each other: the file of the map has the mesh";
    else if (options.is_map_only)
      m_error = "--uv and --map-only leave nothing to do";
    else if (!m_map_option.empty())
      m_error = m_map_option + " does not go with --uv: the map is given";
    else if (!m_spline_option.empty() && !options.has_spline)
      m_error = m_spline_option + " goes with a T-spline";
  }

  void parse_option(const std::string& argument, Options& options)
  {
    const std::size_t equals = argument.find('=');
    m_name = argument.substr(0, equals);
    m_value = equals == std::string::npos ? std::nullopt : std::optional<std::string>(argument.substr(equals + 1));
    if (m_name == "--help" || m_name == "-h")
      parse_flag(options.asks_help);
    else if (m_name == "--version")
      parse_flag(options.asks_version);
    else if (m_name == "--quiet")
      parse_flag(options.is_quiet);
    else if (m_name == "-o")
      options.output_directory = value();
    else if (m_name == "--uv")
      options.uv = value();
    else if (m_name == "--map-only")
      parse_flag(options.is_map_only);
    else if (m_name == "--no-regularization")
      parse_flag(options.is_regularized, false);
    else if (m_name == "--no-spline")
      parse_flag(options.has_spline, false);
    else if (m_name == "--face-size" || m_name == "--resolution")
      parse_spline_option(options);
    else
      parse_map_option(options);
  }

  void parse_spline_option(Options& options)
  {
    m_spline_option = m_name;
    if (m_name == "--face-size")
      options.face_size = number(value(), 1e-6, 1e6);
    else
      options.resolution = integer(value(), 2);
  }

  /// What says how the map is computed.
  void parse_map_option(Options& options)
  {
    if (m_map_option.empty())
      m_map_option = m_name;
    if (m_name == "--field")
      options.field = value();
    else if (m_name == "--cones")
      options.cones = value();
    else if (m_name == "--loops")
      options.loops = integers(value());
    else if (m_name == "--align-curvature")
      options.curvature_alignment = number(value(), 0, 1e9);
    else if (m_name == "--tolerance-residual")
      options.residual_tolerance = number(value(), 1e-300, 1);
    else if (m_name == "--max-iterations")
      options.max_iterations = integer(value(), 1);
    else if (m_name == "--solver")
      options.solver = static_cast<Solver_choice>(choice(value(), {"ldlt", "cholmod"}));
    else if (m_name == "--flips")
      options.flips = static_cast<Flips_choice>(choice(value(), {"delaunay", "degeneracy", "degeneracy-only"}));
    else if (m_name == "--precision")
      options.precision = static_cast<Precision_choice>(choice(value(), {"double", "extended", "quad"}));
    else
      m_error = "unknown option " + m_name;
  }

  void parse_flag(bool& flag, const bool meaning = true)
  {
    flag = meaning;
    if (m_value)
      m_error = m_name + " takes no value";
  }

  std::string value()
  {
    if (!m_value && m_next < m_arguments.size())
      m_value = m_arguments[m_next++];
    if (!m_value || m_value->empty())
      m_error = m_name + " needs a value";
    return m_value.value_or("");
  }

  std::size_t choice(const std::string& text, const std::vector<std::string>& choices)
  {
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (text == choices[i])
        return i;
      list += (i == 0 ? "" : ", ") + choices[i];
    }
    fail(text, "one of " + list);
    return 0;
  }

  int integer(const std::string_view text, const int low)
  {
    int result = low;
    if (!parse_number(text, result) || result < low)
      fail(std::string(text), "an integer of at least " + std::to_string(low));
    return result;
  }

  double number(const std::string& text, const double low, const double high)
  {
    double result = low;
    if (!parse_number(std::string_view(text), result) || !(result >= low && result <= high))
      fail(text, low > 0 ? "a positive number" : "a number from 0 to 1");
    return result;
  }

  std::vector<int> integers(const std::string& text)
  {
    std::vector<int> result;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      result.push_back(0);
      if (!parse_number(std::string_view(text).substr(begin, end - begin), result.back()))
        fail(text, "integers separated by commas");
      begin = end + 1;
    }
    return result;
  }

  template <typename Number>
  static bool parse_number(const std::string_view text, Number& number)
  {
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), number);
    return result.ec == std::errc() && result.ptr == text.data() + text.size();
  }

  void fail(const std::string& text, const std::string& expected)
  {
    if (m_error.empty())
      m_error = m_name + " needs " + expected + ", not \"" + text + "\"";
  }

  std::vector<std::string> m_arguments;
  std::size_t m_next = 0;
  std::string m_name, m_error;
  std::string m_spline_option; ///< the last option about the T-spline; empty if there was none
  std::string m_map_option;    ///< the first option about the computation of the map; empty if there was none
  std::optional<std::string> m_value;
};

#endif // MESH_TO_T_SPLINE_OPTIONS_H
