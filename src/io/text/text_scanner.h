// SPDX-License-Identifier: MIT
// Reads words and numbers of a text file, line by line. Knows comments (from # to the end of the
// line), all three line endings and the continuation of a line by a backslash at its end. Numbers
// do not depend on the machine's locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/report.h"

namespace remesher::io {

class TextScanner {
 public:
  // `text` must outlive the scanner. `fileName` is for error messages.
  TextScanner(std::string_view text, std::string fileName);

  // Goes on with the text that follows, which begins a line.
  void goOn(std::string_view text);

  // Enters the next line; false at the end of the text. The first call enters the first line.
  bool nextLine();

  // The next word of the current line; empty if none is left.
  std::string_view word();
  // The rest of the current line without blanks around it; a # in it is an ordinary letter.
  std::string_view rest();
  bool atLineEnd();

  // The next number of the current line. Throws PARSE_ERROR when there is none, NON_FINITE when it
  // is not finite. `what` names it for the message.
  double number(std::string_view what);
  // The same, but NaN and infinity are allowed.
  double anyNumber(std::string_view what);
  // The value of an attribute, in single precision: 0 for what is not finite there, which is noted.
  float attribute(std::string_view what);
  // NON_FINITE_ATTRIBUTE for such values; none if there were none.
  std::vector<Warning> warnings() const;

  // Goes on to the next line with a word left; false at the end of the text.
  bool skipEmptyLines();

  // The number of bytes that follow.
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  // The whole `text` as a number; infinity or zero beyond double's range.
  static std::optional<double> numberIn(std::string_view text);

  // The integer at the start of `text` and the text behind it; nothing was read if rest == text.
  struct IntegerAndRest {
    long long value;
    std::string_view rest;
  };
  static IntegerAndRest leadingInteger(std::string_view text);

  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;

 private:
  void skipBlanks();

  std::string fileName_;
  const char* at_;
  const char* end_;
  bool isBefore_ = true;  // whether no line of this text was entered yet
  std::size_t line_ = 0;
  std::size_t notFinite_ = 0;       // values of attributes
  std::size_t firstNotFinite_ = 0;  // its line
};

}  // namespace remesher::io
