// SPDX-License-Identifier: MIT
#include "io/text/text_scanner.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "base/legible.h"

namespace remesher::io {
namespace {

constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

// The place behind the line ending at `at`, which may be \n, \r or \r\n.
const char* afterLineEnd(const char* at, const char* end) {
  const bool isPair = *at == '\r' && at + 1 < end && at[1] == '\n';
  return at + (isPair ? 2 : 1);
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string fileName)
    : fileName_(std::move(fileName)), at_(text.data()), end_(text.data() + text.size()) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ += kByteOrderMark.size();
}

void TextScanner::goOn(std::string_view text) {
  at_ = text.data();
  end_ = text.data() + text.size();
  isBefore_ = true;
}

bool TextScanner::nextLine() {
  if (!isBefore_) {
    while (at_ < end_ && !isLineEnd(*at_)) ++at_;
    if (at_ < end_) at_ = afterLineEnd(at_, end_);
  }
  if (at_ == end_) return false;
  isBefore_ = false;
  ++line_;
  return true;
}

void TextScanner::skipBlanks() {
  while (at_ < end_) {
    if (isBlank(*at_)) {
      ++at_;
    } else if (*at_ == '\\' && at_ + 1 < end_ && isLineEnd(at_[1])) {
      at_ = afterLineEnd(at_ + 1, end_);
      ++line_;
    } else {
      break;
    }
  }
  if (at_ < end_ && *at_ == '#')
    while (at_ < end_ && !isLineEnd(*at_)) ++at_;
}

std::string_view TextScanner::word() {
  skipBlanks();
  const char* const begin = at_;
  while (at_ < end_ && !isBlank(*at_) && !isLineEnd(*at_)) {
    if (*at_ == '\\' && at_ + 1 < end_ && isLineEnd(at_[1])) break;
    ++at_;
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::rest() {
  while (at_ < end_ && isBlank(*at_)) ++at_;
  const char* const begin = at_;
  while (at_ < end_ && !isLineEnd(*at_)) ++at_;
  const char* last = at_;
  while (last > begin && isBlank(last[-1])) --last;
  return {begin, static_cast<std::size_t>(last - begin)};
}

bool TextScanner::atLineEnd() {
  skipBlanks();
  return at_ == end_ || isLineEnd(*at_);
}

bool TextScanner::skipEmptyLines() {
  while (atLineEnd())
    if (!nextLine()) return false;
  return true;
}

double TextScanner::anyNumber(std::string_view what) {
  const std::string_view text = word();
  const char* const begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* const end = text.data() + text.size();
  const std::optional<double> value = numberIn({begin, static_cast<std::size_t>(end - begin)});
  if (!value)
    fail(ErrorCode::ParseError,
         text.empty() ? legible(what) + " is missing."
                      : legible(what) + " is not a number: \"" + legible(text) + "\".");
  return *value;
}

double TextScanner::number(std::string_view what) {
  const double value = anyNumber(what);
  if (!std::isfinite(value))
    fail(ErrorCode::NonFinite, legible(what) + " is not finite.",
         "Repair the file: every coordinate must be a finite number.");
  return value;
}

float TextScanner::attribute(std::string_view what) {
  const double value = anyNumber(what);
  if (std::abs(value) <= double(std::numeric_limits<float>::max()))
    return static_cast<float>(value);
  if (notFinite_++ == 0) firstNotFinite_ = line_;
  return 0;
}

std::vector<Warning> TextScanner::warnings() const {
  if (notFinite_ == 0) return {};
  return {{"NON_FINITE_ATTRIBUTE",
           "Values of normals, texture coordinates or colours that are not finite are read as 0, "
           "the first in line " +
               std::to_string(firstNotFinite_) + ".",
           notFinite_}};
}

std::optional<double> TextScanner::numberIn(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = fast_float::from_chars(text.data(), end, value);
  // Newer versions report numbers beyond double's range; all versions return infinity or zero for
  // them.
  const bool isRead = problem == std::errc() || problem == std::errc::result_out_of_range;
  if (!isRead || stop != end) return {};
  return value;
}

TextScanner::IntegerAndRest TextScanner::leadingInteger(std::string_view text) {
  const std::size_t skipped = !text.empty() && text[0] == '+' ? 1 : 0;
  long long value = 0;
  const auto [stop, problem] =
      std::from_chars(text.data() + skipped, text.data() + text.size(), value);
  if (problem != std::errc()) return {0, text};
  return {value, text.substr(static_cast<std::size_t>(stop - text.data()))};
}

void TextScanner::fail(ErrorCode code, const std::string& what, std::string hint) const {
  throw Error(code, legible(fileName_) + ", line " + std::to_string(line_) + ": " + what,
              std::move(hint));
}

}  // namespace remesher::io
