// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OPTIONS_PARSER_H
#define MESH_TO_T_SPLINE_OPTIONS_PARSER_H

#include "Options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

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
    const bool has_guidance = !options.field.empty() || !options.cones.empty();
    if (!options.uv.empty())
      check_given_map(options);
    else if (options.mesh.empty())
      m_error = "no mesh is given";
    else if (!options.is_merged && (options.merge_distance || options.is_repaired))
      m_error = std::string("--no-merge and ") + (options.is_repaired ? "--repair" : "--merge") + " exclude each other";
    else if (!options.field.empty() && !options.cones.empty())
      m_error = "--field and --cones exclude each other";
    else if (options.largest_hole && !options.field.empty())
      m_error = "--fill-holes and --field exclude each other: the field has no crosses where holes are filled";
    else if (options.loops && options.cones.empty())
      m_error = "--loops goes with --cones: a field has turning numbers of its own";
    else if (!options.corners.empty() && (options.corner_angle || !options.has_corners))
      m_error = std::string("--corners and ") + (options.has_corners ? "--corner-angle" : "--no-corners") +
                " exclude each other";
    else if (options.corner_angle && !options.has_corners)
      m_error = "--corner-angle and --no-corners exclude each other";
    else if (options.is_border_aligned && options.field.empty())
      m_error = "--align-boundary goes with --field: the computed field follows the border";
    else if (!options.features.empty() && options.feature_angle)
      m_error = "--features and --feature-angle exclude each other";
    else if (!options.has_features && options.asks_for_features())
      m_error = std::string("--no-features and ") + (options.features.empty() ? "--feature-angle" : "--features") +
                " exclude each other";
    else if (options.largest_hole && options.asks_for_features())
      m_error = std::string("--fill-holes and ") + (options.features.empty() ? "--feature-angle" : "--features") +
                " exclude each other: what fills holes meets features anywhere";
    else if (!m_computed_field_option.empty() && has_guidance)
      m_error = m_computed_field_option + " is for the computed field";
    else if (!options.are_cones_reduced && (options.cone_energy || options.largest_number_of_cones))
      m_error = std::string("--all-cones and ") + (options.cone_energy ? "--cone-energy" : "--max-cones") +
                " exclude each other";
    else if (!m_spline_option.empty() && (options.is_map_only || !options.has_spline))
      m_error = m_spline_option + " goes with a T-spline";
  }

  void check_given_map(const Options& options)
  {
    if (!options.mesh.empty())
      m_error = "--uv and a mesh exclude each other: the file of the map has the mesh";
    else if (options.is_map_only)
      m_error = "--uv and --map-only leave nothing to do";
    else if (!m_mesh_option.empty())
      m_error = m_mesh_option + " does not go with --uv: maps are read as they are";
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
    if (parse_general_option(options) || parse_spline_option(options) || parse_mesh_option(options))
      return;
    if (parse_computed_field_option(options))
      m_computed_field_option = m_name;
    else if (!parse_map_option(options))
      m_error = "unknown option " + m_name;
    if (m_map_option.empty())
      m_map_option = m_name;
  }

  bool parse_general_option(Options& options)
  {
    if (m_name == "--help" && m_value == "markdown")
      options.asks_help = options.asks_table = true;
    else if (m_name == "--help" || m_name == "-h")
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
    else if (m_name == "--solver")
      options.solver = static_cast<Solver_choice>(choice(value(), {"ldlt", "cholmod"}));
    else
      return false;
    return true;
  }

  /// How the mesh is read.
  bool parse_mesh_option(Options& options)
  {
    if (m_name == "--merge")
      options.merge_distance = number(value());
    else if (m_name == "--no-merge")
      parse_flag(options.is_merged, false);
    else if (m_name == "--repair")
      parse_flag(options.is_repaired);
    else if (m_name == "--fill-holes")
      options.largest_hole = integer<std::size_t>(value(), 1);
    else
      return false;
    m_mesh_option = m_name;
    return true;
  }

  bool parse_spline_option(Options& options)
  {
    if (m_name == "--tolerance")
      options.tolerance = positive_number(value(), 1e6);
    else if (m_name == "--max-control-points")
      options.largest_number_of_control_points = integer<std::size_t>(value(), 1);
    else if (m_name == "--fairness")
      options.fairness = number(value());
    else if (m_name == "--levels")
      parse_flag(options.has_levels);
    else if (m_name == "--resolution")
      options.resolution = integer(value(), 2);
    else if (m_name == "--mesh-format")
      options.mesh_format = static_cast<Mesh_format>(choice(value(), {"obj", "ply"}));
    else
      return false;
    m_spline_option = m_name;
    return true;
  }

  bool parse_computed_field_option(Options& options)
  {
    if (m_name == "--features")
      options.features = value();
    else if (m_name == "--feature-angle")
      options.feature_angle = positive_number(value(), 180);
    else if (m_name == "--no-features")
      parse_flag(options.has_features, false);
    else if (m_name == "--align-curvature")
      options.curvature_alignment = number(value());
    else if (m_name == "--cone-energy")
      options.cone_energy = number(value());
    else if (m_name == "--max-cones")
      options.largest_number_of_cones = integer(value(), 0);
    else if (m_name == "--all-cones")
      parse_flag(options.are_cones_reduced, false);
    else
      return false;
    return true;
  }

  /// What else says how the map is computed.
  bool parse_map_option(Options& options)
  {
    if (m_name == "--field")
      options.field = value();
    else if (m_name == "--cones")
      options.cones = value();
    else if (m_name == "--loops")
      options.loops = integers(value());
    else if (m_name == "--corners")
      options.corners = value();
    else if (m_name == "--corner-angle")
      options.corner_angle = positive_number(value(), 180);
    else if (m_name == "--no-corners")
      parse_flag(options.has_corners, false);
    else if (m_name == "--align-boundary")
      parse_flag(options.is_border_aligned);
    else if (m_name == "--scale")
      options.scale_policy = scale_policy(value());
    else if (m_name == "--tolerance-residual")
      options.residual_tolerance = positive_number(value(), 1);
    else if (m_name == "--max-iterations")
      options.max_iterations = integer(value(), 1);
    else if (m_name == "--flips")
      options.flips = static_cast<Flips_choice>(choice(value(), {"delaunay", "degeneracy", "degeneracy-only"}));
    else if (m_name == "--precision")
      options.precision = static_cast<Precision_choice>(choice(value(), {"double", "extended", "quad"}));
    else
      return false;
    return true;
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

  CGAL::T_splines::Scale_policy scale_policy(const std::string& text)
  {
    using Policy = CGAL::T_splines::Scale_policy;
    constexpr std::array<Policy, 4> policies = {Policy::UNIT_IF_CONSTRAINED, Policy::AS_IS, Policy::UNIT,
                                                Policy::DYADIC};
    return policies[choice(text, {"auto", "as-is", "unit", "dyadic"})];
  }

  template <typename Integer>
  Integer integer(const std::string& text, const Integer low)
  {
    Integer result = low;
    if (!parse_number(text, result) || result < low)
      fail(text, "an integer of at least " + std::to_string(low));
    return result;
  }

  /// At most `high`, which no one should need.
  double positive_number(const std::string& text, const double high)
  {
    double result = high;
    if (!parse_number(text, result) || !(result >= std::numeric_limits<double>::min() && result <= high))
      fail(text, "a positive number");
    return result;
  }

  double number(const std::string& text)
  {
    double result = 0;
    if (!parse_number(text, result) || !(result >= 0 && result <= std::numeric_limits<double>::max()))
      fail(text, "a number that is not negative");
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
  std::optional<std::string> m_value;
  std::string m_spline_option;         ///< the last option about the T-spline; empty if there was none
  std::string m_mesh_option;           ///< the last option about reading the mesh; likewise
  std::string m_map_option;            ///< the first option about the computation of the map; likewise
  std::string m_computed_field_option; ///< the last option about the computed field; likewise
};

#endif // MESH_TO_T_SPLINE_OPTIONS_PARSER_H
