// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_ARGUMENTS_H
#define T_SPLINES_BENCHMARK_ARGUMENTS_H

#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// The command line of a benchmark: file names, flags, and options that are followed by a value.
class Arguments {
public:
  /// \param usage what `--help` prints
  Arguments(std::string usage, std::set<std::string> flags, std::set<std::string> options)
    : m_usage(std::move(usage)),
      m_flags(std::move(flags)),
      m_options(std::move(options))
  {
  }

  /// says that the program has an input of its own if no file is given.
  void allow_no_files() { m_needs_files = false; }

  /// reads the command line. \return `false` if the program has to end, with `exit_code()`.
  bool parse(const int argc, const char* const* argv)
  {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--help" || word == "-h") {
        std::cout << m_usage;
        return false;
      }
      if (m_flags.count(word) != 0)
        m_values[word];
      else if (m_options.count(word) != 0 && i + 1 < argc)
        m_values[word] = argv[++i];
      else if (word[0] == '-')
        return fail(word + (m_options.count(word) != 0 ? " needs a value" : " is not an option"));
      else
        m_files.push_back(word);
    }
    return !m_files.empty() || !m_needs_files || fail("no mesh is given");
  }

  int exit_code() const { return m_exit_code; }
  const std::vector<std::string>& files() const { return m_files; }
  bool has(const std::string& name) const { return m_values.count(name) != 0; }

  std::string text(const std::string& name, const std::string& otherwise) const
  {
    const auto found = m_values.find(name);
    return found == m_values.end() ? otherwise : found->second;
  }
  int integer(const std::string& name, const int otherwise) const
  {
    return has(name) ? std::atoi(text(name, "").c_str()) : otherwise;
  }
  double real(const std::string& name, const double otherwise) const
  {
    return has(name) ? std::atof(text(name, "").c_str()) : otherwise;
  }

private:
  bool fail(const std::string& message)
  {
    std::cerr << message << "\n\n" << m_usage;
    m_exit_code = 2;
    return false;
  }

  std::string m_usage;
  std::set<std::string> m_flags, m_options;
  std::map<std::string, std::string> m_values;
  std::vector<std::string> m_files;
  bool m_needs_files = true;
  int m_exit_code = 0;
};

#endif // T_SPLINES_BENCHMARK_ARGUMENTS_H
