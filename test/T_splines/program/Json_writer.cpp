// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_to_t_spline/Json_writer.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace Json_writer_test {

namespace {

std::string string_as_json(const std::string& text)
{
  return Json_writer().value(text).text();
}

template <typename Number>
std::string number_as_json(const Number number)
{
  return Json_writer().value(number).text();
}

} // namespace

TEST_CASE("structure, commas and indentation")
{
  Json_writer json;
  json.begin_object().member("a", 1).array_member("b", std::vector<int>{2, 3});
  json.key("c").begin_object().end_object();
  json.key("d").begin_array().end_array().end_object();
  CHECK(json.text() == "{\n  \"a\": 1,\n  \"b\": [\n    2,\n    3\n  ],\n  \"c\": {},\n  \"d\": []\n}");
}

TEST_CASE("strings are escaped, and safe inside a script element")
{
  CHECK(string_as_json("a\"b\\c\n\t") == "\"a\\\"b\\\\c\\u000a\\u0009\"");
  CHECK(string_as_json("</script>") == "\"\\u003c/script>\"");
  CHECK(string_as_json("gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x90\x98") ==
        "\"gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x90\x98\"");
}

TEST_CASE("bytes that are not UTF-8 are replaced one by one")
{
  CHECK(string_as_json("\xff.off") == "\"\\ufffd.off\"");
  CHECK(string_as_json("\xc3") == "\"\\ufffd\"");                       // cut off
  CHECK(string_as_json("\xc0\xaf") == "\"\\ufffd\\ufffd\"");            // overlong
  CHECK(string_as_json("\xed\xa0\x80") == "\"\\ufffd\\ufffd\\ufffd\""); // a surrogate
}

TEST_CASE("numbers read back as the same, and what is not finite is null")
{
  for (const double x : {0.1, -1. / 3, 1e-300, 5e-324, 123456789.123456789, 0.})
    CHECK(std::strtod(number_as_json(x).c_str(), nullptr) == x);
  CHECK(number_as_json(std::numeric_limits<double>::quiet_NaN()) == "null");
  CHECK(number_as_json(-std::numeric_limits<double>::infinity()) == "null");
  CHECK(number_as_json(true) == "true");
  CHECK(number_as_json(18446744073709551615ull) == "18446744073709551615");
}

} // namespace Json_writer_test
