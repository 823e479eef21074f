// SPDX-License-Identifier: MIT
#include "io/text/text_scanner.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <string_view>

#include "io/files.h"
#include "io/text/text_writer.h"

using namespace remesher;
using namespace remesher::test;
using io::TextScanner;
using io::TextWriter;

namespace {

std::string digitsOf(double value) {
  const auto bytes = TextWriter().number(value).bytes();
  return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("text_scanner: lines are counted whatever ends them, continued ones too") {
  for (const char* text : {"a\nb\\\nc\nx", "a\r\nb\\\r\nc\r\nx", "a\rb\\\rc\rx"}) {
    TextScanner scanner(text, "t");
    CHECK(scanner.nextLine());
    CHECK(scanner.word() == "a");
    CHECK(scanner.nextLine());
    CHECK(scanner.word() == "b");
    CHECK(scanner.word() == "c");
    CHECK(scanner.word().empty());
    CHECK(scanner.nextLine());
    CHECK(failureOf([&] { scanner.number("it"); }).find("t, line 4: it is not a number") !=
          std::string::npos);
    CHECK_FALSE(scanner.nextLine());
  }
}

TEST_CASE("text_scanner: a # begins a comment between words, and is a letter within names") {
  TextScanner scanner("# all of it\n1 # rest\nname with #1 in it  ", "t");
  CHECK(scanner.nextLine());
  CHECK(scanner.atLineEnd());
  CHECK(scanner.skipEmptyLines());
  CHECK(scanner.number("it") == 1);
  CHECK(scanner.atLineEnd());
  CHECK(scanner.nextLine());
  CHECK(scanner.rest() == "name with #1 in it");
}

TEST_CASE("text_scanner: numbers in every notation, and nothing else") {
  TextScanner scanner("+1.5 -2e-3 .5 7. 1,5", "t");
  CHECK(scanner.nextLine());
  for (const double expected : {1.5, -2e-3, 0.5, 7.0}) CHECK(scanner.number("it") == expected);
  CHECK(failureOf([&] { scanner.number("it"); }).find("PARSE_ERROR") == 0);
  CHECK(failureOf([&] { scanner.number("it"); }).find("it is missing") != std::string::npos);
}

TEST_CASE("text_scanner: what no double holds is infinite or zero in all of fast_float") {
  TextScanner scanner("1e999 -1e999 1e-999 1e999x", "t");
  CHECK(scanner.nextLine());
  CHECK(failureOf([&] { scanner.number("it"); }).find("NON_FINITE") == 0);
  CHECK(scanner.anyNumber("it") == -std::numeric_limits<double>::infinity());
  CHECK(scanner.number("it") == 0);
  CHECK(failureOf([&] { scanner.number("it"); }).find("PARSE_ERROR") == 0);
}

TEST_CASE("text_scanner: names that a file gives are quoted legibly, to the end of the sentence") {
  using namespace std::string_view_literals;
  TextScanner scanner("x", "t");
  CHECK(scanner.nextLine());
  CHECK(failureOf([&] { scanner.number("a\0b"sv); }).find("a\\u{0}b is not a number: \"x\".") !=
        std::string::npos);
  CHECK(failureOf([&] { scanner.number("a\0b"sv); }).find("a\\u{0}b is missing.") !=
        std::string::npos);
}

TEST_CASE("text_writer: a single is found again by its digits, and more digits stay") {
  for (const float single : {0.1F, 1.2345678e29F, -3.4028235e38F, 1e-45F, 16777216.0F}) {
    const double read = *TextScanner::numberIn(digitsOf(double(single)));
    CHECK(io::singleWrittenAs(read) == double(single));
  }
  for (const double survey : {4512345.678, 512345.678, 1e200, 0.1234567891})
    CHECK(io::singleWrittenAs(survey) == survey);
}

TEST_CASE("text_writer: numbers have as few digits as read back to the same value") {
  CHECK(digitsOf(0.1F) == "0.1");
  CHECK(digitsOf(0.1) == "0.1");
  CHECK(digitsOf(-2) == "-2");
  CHECK(digitsOf(1.0 / 3) == "0.3333333333333333");
  CHECK(digitsOf(static_cast<double>(1.0F / 3)) == "0.33333334");
  for (const double value : {1e-300, 123456789.123, -1e20, 5e-324, 1.7976931348623157e308}) {
    const std::string text = digitsOf(value);
    TextScanner scanner(text, "t");
    CHECK(scanner.nextLine());
    CHECK(scanner.number("it") == value);
  }
}
