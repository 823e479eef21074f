// SPDX-License-Identifier: MIT
// tests/formats/legible.test.js holds the package's own to the same cases.
#include "base/legible.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "base/random.h"

using namespace remesher;

namespace {

std::string printed(double x, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

}  // namespace

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

TEST_CASE("legible: numbers, as printf tells them, which rounds nothing differently there") {
  for (const double x : {0.0, -0.0, 1.0, -1.0, 9.9996, 0.0001, 0.00001, 123456.0, 1e6, 999999.5e3,
                         0.3, 1e22, 1e23, 1.7e308, 2.3e-308, 33.75, 1e-4, 99995e-9, 12e15}) {
    for (int digits = 1; digits <= 15; ++digits) {
      CAPTURE(x);
      CAPTURE(digits);
      // Halves, which printf rounds to the even digit, go up.
      const std::string text = inDigits(x, digits);
      const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
      const bool isHalf = std::abs(std::abs(std::remainder(x / unit, 1)) - 0.5) < 1e-6;
      if (!isHalf) CHECK(text == printed(x, digits));
    }
  }
  CHECK(inDigits(std::numeric_limits<double>::infinity(), 4) == "inf");
  CHECK(inDigits(-std::numeric_limits<double>::infinity(), 4) == "-inf");
  CHECK(inDigits(std::abs(std::numeric_limits<double>::quiet_NaN()), 4) == "nan");
}

TEST_CASE("legible: any number is written to half of the last digit, but for the last bits") {
  Random random(1);
  for (int k = 0; k < 20000; ++k) {
    const double x = (random.uniform() - 0.5) * std::pow(10, 600 * random.uniform() - 300);
    const int digits = 1 + k % 17;
    CAPTURE(x);
    CAPTURE(digits);
    const double written = std::strtod(inDigits(x, digits).c_str(), nullptr);
    const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
    CHECK(std::abs(written - x) <= 0.5001 * unit + 16 * std::abs(x) * 0x1p-53);
  }
}
