// SPDX-License-Identifier: MIT
// Source: Extensible Markup Language (XML) 1.0, fifth edition.
#include "io/text/xml_scanner.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "base/legible.h"

namespace remesher::io {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view withoutPrefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

void appendUtf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6);
    byte(0x80 | (code & 63));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12);
    byte(0x80 | (code >> 6 & 63));
    byte(0x80 | (code & 63));
  } else {
    byte(0xF0 | code >> 18);
    byte(0x80 | (code >> 12 & 63));
    byte(0x80 | (code >> 6 & 63));
    byte(0x80 | (code & 63));
  }
}

// The character that an entity, without & and ;, stands for; none if it is unknown.
std::optional<std::string> entity(std::string_view name) {
  constexpr std::pair<std::string_view, char> kNamed[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (const auto& [known, letter] : kNamed)
    if (name == known) return std::string(1, letter);
  if (name.size() < 2 || name[0] != '#') return std::nullopt;
  const bool isHex = name[1] == 'x';
  const std::string_view digits = name.substr(isHex ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, isHex ? 16 : 10);
  constexpr std::uint32_t kLargest = 0x10FFFF;
  if (error != std::errc() || end != digits.data() + digits.size() || code > kLargest)
    return std::nullopt;
  std::string text;
  appendUtf8(text, code);
  return text;
}

std::string unescaped(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find('&'), text.size());
    plain += text.substr(0, begin);
    text.remove_prefix(begin);
    const std::size_t end = text.find(';');
    if (text.empty() || end == text.npos) break;
    const std::optional<std::string> meant = entity(text.substr(1, end - 1));
    plain += meant ? *meant : std::string(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return plain + std::string(text);
}

}  // namespace

const std::string* XmlTag::find(std::string_view wanted) const {
  for (const auto& [key, value] : attributes)
    if (key == wanted) return &value;
  return nullptr;
}

std::string XmlTag::get(std::string_view wanted) const {
  const std::string* const value = find(wanted);
  return value == nullptr ? "" : *value;
}

XmlScanner::XmlScanner(std::string_view text, std::string fileName)
    : text_(text), fileName_(std::move(fileName)) {}

void XmlScanner::fail(ErrorCode code, const std::string& what, std::string hint) const {
  const auto line = std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n') + 1;
  throw Error(code, legible(fileName_) + ", line " + std::to_string(line) + ": " + what,
              std::move(hint));
}

bool XmlScanner::skip(std::string_view begin, std::string_view end) {
  if (!text_.substr(at_).starts_with(begin)) return false;
  const std::size_t last = text_.find(end, at_ + begin.size());
  if (last == text_.npos)
    fail(ErrorCode::ParseError, "the file ends within " + std::string(begin) + ".",
         "Was it copied completely?");
  at_ = last + end.size();
  return true;
}

XmlTag XmlScanner::tagIn(std::string_view inner) {
  XmlTag tag;
  tag.closes = inner.starts_with('/') || inner.ends_with('/');
  tag.opens = !inner.starts_with('/');
  if (inner.starts_with('/')) inner.remove_prefix(1);
  if (inner.ends_with('/')) inner.remove_suffix(1);
  const std::size_t end = std::min(inner.find_first_of(kBlanks), inner.size());
  tag.name = withoutPrefix(inner.substr(0, end));
  inner.remove_prefix(end);
  while (true) {
    const std::size_t equal = inner.find('=');
    if (equal == inner.npos) return tag;
    const std::size_t open = inner.find_first_of("\"'", equal);
    const std::size_t close = open == inner.npos ? open : inner.find(inner[open], open + 1);
    if (close == inner.npos) fail(ErrorCode::ParseError, "an attribute's value has no end.");
    std::string_view key = inner.substr(0, equal);
    key.remove_prefix(std::min(key.find_first_not_of(kBlanks), key.size()));
    key = key.substr(0, std::min(key.find_first_of(kBlanks), key.size()));
    tag.attributes.emplace_back(withoutPrefix(key),
                                unescaped(inner.substr(open + 1, close - open - 1)));
    inner.remove_prefix(close + 1);
  }
}

std::optional<XmlTag> XmlScanner::next() {
  while (true) {
    at_ = text_.find('<', at_);
    if (at_ == text_.npos) {
      at_ = text_.size();
      return std::nullopt;
    }
    if (skip("<!--", "-->") || skip("<?", "?>") || skip("<![CDATA[", "]]>") || skip("<!", ">"))
      continue;
    std::size_t end = at_ + 1;
    for (char quote = 0; end < text_.size() && (quote != 0 || text_[end] != '>'); ++end) {
      if (quote != 0) {
        if (text_[end] == quote) quote = 0;
      } else if (text_[end] == '"' || text_[end] == '\'') {
        quote = text_[end];
      }
    }
    if (end == text_.size())
      fail(ErrorCode::ParseError, "the file ends within a tag.", "Was it copied completely?");
    const std::string_view inner = text_.substr(at_ + 1, end - at_ - 1);
    XmlTag tag = tagIn(inner);
    at_ = end + 1;
    return tag;
  }
}

std::string_view XmlScanner::text() const {
  return text_.substr(at_, std::min(text_.find('<', at_), text_.size()) - at_);
}

}  // namespace remesher::io
