// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_FEATURE_FILE_PARSER_H
#define CGAL_T_SPLINES_IO_INTERNAL_FEATURE_FILE_PARSER_H

#include <CGAL/T_splines/IO/Feature_file_report.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Reads the edges that a file names as features. After the first failure nothing is read any more.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename TriangleMesh>
class Feature_file_parser {
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

public:
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  Feature_file_parser(const std::string_view text, const TriangleMesh& mesh, const Feature_file_format format)
    : m_scanner(without_byte_order_mark(text), format == Feature_file_format::OBJ_LINES
                                                   ? Text_scanner::Backslash::CONTINUES_LINE
                                                   : Text_scanner::Backslash::IS_TEXT),
      m_mesh(mesh),
      m_vertices(vertices(mesh).begin(), vertices(mesh).end())
  {
    switch (format) {
    case Feature_file_format::VERTEX_PAIRS: parse_pairs(); break;
    case Feature_file_format::SHARP: parse_sharp(); break;
    case Feature_file_format::OBJ_LINES: parse_obj_lines(); break;
    }
  }

  const Feature_file_report& report() const { return m_report; }

  /// One halfedge of each edge that is named, as often as it is.
  const std::vector<halfedge_descriptor>& halfedges() const { return m_halfedges; }

private:
  void parse_pairs()
  {
    while (m_report.success() && m_scanner.next_line()) {
      std::size_t v = 0, w = 0;
      if (has_columns(2) && read_index(Feature_file_status::VERTEX_OUT_OF_RANGE, m_vertices.size(), v) &&
          read_index(Feature_file_status::VERTEX_OUT_OF_RANGE, m_vertices.size(), w))
        add(v, w);
    }
  }

  // The number of features; then, per feature, its kind, 0 for concave and 1 for convex, a face, and which of its edges.
  void parse_sharp()
  {
    const std::vector<face_descriptor> face(faces(m_mesh).begin(), faces(m_mesh).end());
    constexpr std::size_t any = static_cast<std::size_t>(-1);
    std::size_t number = 0, kind = 0, f = 0, e = 0;
    if (!m_scanner.next_line()) {
      fail(Feature_file_status::TRUNCATED, 1, 0);
      return;
    }
    if (!has_columns(1) || !read_index(Feature_file_status::SYNTAX_ERROR, any, number))
      return;
    for (std::size_t i = 0; i < number; ++i) {
      if (!m_scanner.next_line()) {
        fail(Feature_file_status::TRUNCATED, number, i);
        return;
      }
      if (!has_columns(3) || !read_index(Feature_file_status::SYNTAX_ERROR, any, kind) ||
          !read_index(Feature_file_status::FACE_OUT_OF_RANGE, face.size(), f) ||
          !read_index(Feature_file_status::EDGE_OUT_OF_RANGE, 3, e))
        return;
      // Edge 0 goes from the first corner, where the halfedge of the face ends, to the second one.
      auto h = next(halfedge(face[f], m_mesh), m_mesh);
      for (std::size_t k = 0; k < e; ++k)
        h = next(h, m_mesh);
      m_halfedges.push_back(h);
    }
    if (m_scanner.next_line())
      fail(Feature_file_status::TRAILING_DATA, 0, 0, rest_of_line());
  }

  // Chains of vertices, counted from 1, or from the last one backwards if negative, each perhaps with a texture coordinate
  // behind a slash.
  void parse_obj_lines()
  {
    std::size_t number_of_vertices = 0;
    while (m_report.success() && m_scanner.next_line()) {
      std::string_view keyword, token;
      m_scanner.next_token(keyword);
      if (is_keyword(keyword, "l"))
        parse_chain(number_of_vertices);
      else {
        number_of_vertices += is_keyword(keyword, "v") ? 1 : 0;
        while (m_scanner.next_token(token)) // a backslash at the end continues any statement
          ;
      }
    }
  }

  void parse_chain(const std::size_t number_of_vertices)
  {
    const std::size_t n = m_scanner.count_tokens();
    if (n < 2) {
      fail(Feature_file_status::WRONG_NUMBER_OF_COLUMNS, 2, n);
      return;
    }
    std::size_t last = 0;
    for (std::size_t i = 0; i < n && m_report.success(); ++i) {
      std::string_view token;
      m_scanner.next_token(token);
      long long index = 0;
      if (!parse_integer(token.substr(0, token.find('/')), index)) {
        fail(Feature_file_status::SYNTAX_ERROR, 0, 0, token);
        return;
      }
      const long long from_0 = index < 0 ? static_cast<long long>(number_of_vertices) + index : index - 1;
      if (from_0 < 0 || static_cast<unsigned long long>(from_0) >= m_vertices.size()) {
        fail(Feature_file_status::VERTEX_OUT_OF_RANGE, m_vertices.size(), 0, token);
        return;
      }
      if (i > 0)
        add(last, static_cast<std::size_t>(from_0));
      last = static_cast<std::size_t>(from_0);
    }
  }

  bool has_columns(const std::size_t expected)
  {
    const std::size_t actual = m_scanner.count_tokens();
    return actual == expected || fail(Feature_file_status::WRONG_NUMBER_OF_COLUMNS, expected, actual);
  }

  // Reads an integer from 0 to `number` - 1.
  bool read_index(const Feature_file_status status_beyond, const std::size_t number, std::size_t& index)
  {
    std::string_view token;
    long long value = 0;
    m_scanner.next_token(token);
    if (!parse_integer(token, value))
      return fail(Feature_file_status::SYNTAX_ERROR, 0, 0, token);
    if (value < 0 || static_cast<unsigned long long>(value) >= number)
      return fail(status_beyond, number, 0, token);
    index = static_cast<std::size_t>(value);
    return true;
  }

  void add(const std::size_t v, const std::size_t w)
  {
    const auto found = halfedge(m_vertices[v], m_vertices[w], m_mesh);
    if (found.second && v != w) {
      m_halfedges.push_back(found.first);
      return;
    }
    fail(Feature_file_status::NOT_AN_EDGE, 0, 0);
    m_report.first_vertex = v;
    m_report.second_vertex = w;
  }

  bool fail(const Feature_file_status status, const std::size_t expected, const std::size_t actual,
            const std::string_view text = {})
  {
    m_report.status = status;
    m_report.line = m_scanner.line() == 0 ? 1 : m_scanner.line();
    m_report.expected = expected;
    m_report.actual = actual;
    m_report.text = quotable(text);
    return false;
  }

  std::string_view rest_of_line()
  {
    std::string_view token;
    m_scanner.next_token(token);
    return token;
  }

  Text_scanner m_scanner;
  const TriangleMesh& m_mesh;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
  Feature_file_report m_report;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_FEATURE_FILE_PARSER_H
