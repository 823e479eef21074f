// SPDX-License-Identifier: MIT
// Words and numbers of a text file, line by line, for the readers of the text formats. Knows
// comments (from # to the end of the line), all three line endings and the continuation of a line
// by a backslash at its end. Numbers do not depend on the machine's locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace remesher::io {

class TextScanner {
 public:
  // Looks at `text`, which must outlive the scanner. `fileName` is for error messages.
  TextScanner(std::string_view text, std::string fileName);

  // To the next line; false at the end of the text. The first call enters the first line.
  bool nextLine();

  // Of the current line: the next word, empty when there is none left.
  std::string_view word();
  // Of the current line: what is left, without blanks around it; a # in it is an ordinary letter.
  std::string_view rest();
  bool atLineEnd();

  // The next number of the current line. Throws PARSE_ERROR when there is none, NON_FINITE when it
  // is not finite. `what` names it for the message.
  double number(std::string_view what);
  // The same where NaN and infinity are numbers too.
  double anyNumber(std::string_view what);
  // The same in single precision; NON_FINITE also for what is too large for that.
  float singleNumber(std::string_view what);

  // Goes on to the next line that has a word left; false at the end of the text.
  bool skipEmptyLines();

  // How many bytes follow.
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  // All of `text` as a number: infinity or zero where no double is as large or as small.
  static std::optional<double> numberIn(std::string_view text);

  // The number at the start of `text`, and what follows it; nothing read when rest == text.
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
  std::size_t line_ = 0;
};

}  // namespace remesher::io
