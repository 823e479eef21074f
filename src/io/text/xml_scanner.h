// SPDX-License-Identifier: MIT
// Reads the tags of an XML file one after the other, and the text behind each. Passes over
// comments, declarations and processing instructions; knows CDATA, the five named entities and
// characters by number. Namespaces' prefixes are left off the names of elements and attributes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace remesher::io {

struct XmlTag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string>> attributes;
  bool opens = false, closes = false;  // both: an empty element

  // Null if there is none of this name.
  const std::string* find(std::string_view name) const;
  std::string get(std::string_view name) const;  // empty if there is none
};

class XmlScanner {
 public:
  // `text` must outlive the scanner. `fileName` is for error messages.
  XmlScanner(std::string_view text, std::string fileName);

  // None at the end of the text. Throws PARSE_ERROR for a tag that does not end.
  std::optional<XmlTag> next();
  // The bytes between the last tag and the next, as they are.
  std::string_view text() const;
  // All bytes that follow.
  std::string_view left() const { return text_.substr(at_); }
  std::size_t place() const { return at_; }

  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;

 private:
  bool skip(std::string_view begin, std::string_view end);
  XmlTag tagIn(std::string_view inner);

  std::string_view text_;
  std::string fileName_;
  std::size_t at_ = 0;
};

}  // namespace remesher::io
