// SPDX-License-Identifier: MIT
// tests/legible.test.js holds the package's own to the same cases.
#include "base/legible.h"

#include <doctest/doctest.h>

#include <array>
#include <utility>

using namespace remesher;

TEST_CASE("legible: what can be read stays as it is") {
  for (const char* text : {"", "wood.png", "a b/ä-日本.obj", "C:\\x", "🦊 %20", "~^`"})
    CHECK(legible(text) == text);
  const std::string longest(120, 'x');
  CHECK(legible(longest) == longest);
}

TEST_CASE("legible: what a terminal obeys is spelled out") {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kCases = {{
      {"\x1b[2J"sv, R"(\u{1b}[2J)"sv},
      {"a\r\nb\tc"sv, R"(a\u{d}\u{a}b\u{9}c)"sv},
      {"\0end"sv, R"(\u{0}end)"sv},
      {"\x7f"sv, R"(\u{7f})"sv},
      {"\xc2\x9b"sv, R"(\u{9b})"sv},
      {"gnp.\xe2\x80\xae"sv, R"(gnp.\u{202e})"sv},
      {"\xef\xbb\xbf"sv, R"(\u{feff})"sv},
      {"\xf3\xa0\x81\x81"sv, R"(\u{e0041})"sv},
  }};
  for (const auto& [text, shown] : kCases) CHECK(legible(text) == shown);
}

TEST_CASE("legible: bytes that are not UTF-8 are replaced, one by one") {
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(legible("a\xff") == "a" + mark);
  CHECK(legible("\xc0\xae") == mark + mark);             // longer than it need be
  CHECK(legible("\xed\xa0\x80") == mark + mark + mark);  // half a pair
  CHECK(legible("\xe2\x82") == mark + mark);             // cut short
  CHECK(legible("\xf4\x90\x80\x80") == mark + mark + mark + mark);
}

TEST_CASE("legible: of many names the first few are shown") {
  CHECK(legibleList({}).empty());
  CHECK(legibleList({"a"}) == "a");
  CHECK(legibleList({"a", "\n"}) == R"(a, \u{a})");
  const std::string shown = legibleList(std::vector<std::string>(1000, std::string(1000, 'x')));
  CHECK(shown.size() < 8 * 130);
  CHECK(shown.ends_with("x and 992 more"));
}

TEST_CASE("legible: of a long text the two ends are shown") {
  for (const std::size_t length : {121UL, 500UL, 5000UL, 1000000UL}) {
    const std::string shown = legible("begin" + std::string(length - 9, 'x') + ".png");
    CHECK(shown.size() == 119 + 3);  // the mark has three bytes
    CHECK(shown.substr(0, 6) == "beginx");
    CHECK(shown.substr(shown.size() - 5) == "x.png");
  }
  // What is spelled out is long as it is shown.
  for (const std::size_t length : {31UL, 100UL, 100000UL})
    CHECK(legible(std::string(length, '\0')).size() == 119 + 3);
}
