// SPDX-License-Identifier: MIT
#include "io/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/legible.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// Indexed by PlyType. A file may use either name; the first is written.
struct TypeTraits {
  std::string_view name;
  std::string_view alias;
  std::size_t size;
  double smallest;
  double largest;
};

constexpr std::array<TypeTraits, 8> kTypes = {{
    {"char", "int8", 1, -128, 127},
    {"uchar", "uint8", 1, 0, 255},
    {"short", "int16", 2, -32768, 32767},
    {"ushort", "uint16", 2, 0, 65535},
    {"int", "int32", 4, -2147483648.0, 2147483647.0},
    {"uint", "uint32", 4, 0, 4294967295.0},
    {"float", "float32", 4, 0, 0},
    {"double", "float64", 8, 0, 0},
}};

const TypeTraits& traits(PlyType type) { return kTypes[static_cast<std::size_t>(type)]; }

constexpr std::array<std::string_view, 3> kEncodings = {"ascii", "binary_little_endian",
                                                        "binary_big_endian"};

// The size up to the end of the end_header line. The first line tells the line ending: a binary
// body behind a lone \r may begin with the byte of \n.
std::size_t headerSize(std::string_view file, const std::string& fileName) {
  const std::size_t firstEnd = file.find_first_of("\r\n");
  if (firstEnd != std::string_view::npos) {
    const bool isPair = file.substr(firstEnd, 2) == "\r\n";
    const std::string lineEnd(file.substr(firstEnd, isPair ? 2 : 1));
    constexpr std::string_view kLast = "end_header";
    const std::size_t last = file.find(lineEnd + std::string(kLast));
    if (last != std::string_view::npos) {
      const std::size_t behind = last + lineEnd.size() + kLast.size();
      const std::size_t end = file.find(lineEnd, behind);
      return end == std::string_view::npos ? file.size() : end + lineEnd.size();
    }
  }
  throw Error(ErrorCode::ParseError,
              legible(fileName) + ": the header of the PLY has no end_header.",
              "Was it copied completely?");
}

// Limit on elements of a file and on properties of an element: each name is compared with all names
// before it and searched again by every step of reading.
constexpr std::size_t kMostNames = 1000;

class HeaderParser {
 public:
  HeaderParser(std::string_view header, const std::string& fileName) : scanner_(header, fileName) {}
  ParsedPlyHeader parse();

 private:
  void addRemark(std::string_view begin);
  void parseLine(std::string_view keyword);
  void parseEncoding();
  void parseElement();
  void parseProperty();
  PlyType parseType();

  TextScanner scanner_;
  PlyHeader header_;
  bool hasEncoding_ = false;
};

void HeaderParser::parseEncoding() {
  const std::string_view name = scanner_.word();
  const auto found = std::find(kEncodings.begin(), kEncodings.end(), name);
  if (found == kEncodings.end())
    scanner_.fail(ErrorCode::ParseError,
                  "a PLY's format is ascii, binary_little_endian or binary_big_endian, not \"" +
                      legible(name) + "\".");
  header_.encoding = static_cast<PlyEncoding>(found - kEncodings.begin());
  hasEncoding_ = true;
}

void HeaderParser::parseElement() {
  PlyElement element{std::string(scanner_.word()), 0, {}};
  const std::string_view word = scanner_.word();
  const auto [count, rest] = TextScanner::leadingInteger(word);
  if (rest.size() == word.size() || !rest.empty() || count < 0 || count >= kNone)
    scanner_.fail(ErrorCode::ParseError, "the number of the element \"" + legible(element.name) +
                                             "\" is not a whole number from 0 to 4294967294: \"" +
                                             legible(word) + "\".");
  element.count = static_cast<Index>(count);
  if (header_.elements.size() == kMostNames)
    scanner_.fail(ErrorCode::Unsupported, "the header has more than 1000 elements.");
  for (const PlyElement& other : header_.elements)
    if (other.name == element.name)
      scanner_.fail(ErrorCode::ParseError,
                    "there is a second element \"" + legible(element.name) + "\" in the header.");
  header_.elements.push_back(std::move(element));
}

PlyType HeaderParser::parseType() {
  const std::string_view word = scanner_.word();
  for (std::size_t i = 0; i < kTypes.size(); ++i)
    if (word == kTypes[i].name || word == kTypes[i].alias) return static_cast<PlyType>(i);
  scanner_.fail(ErrorCode::ParseError, "\"" + legible(word) +
                                           "\" is no type of a PLY: char, uchar, short, ushort, " +
                                           "int, uint, float or double.");
}

void HeaderParser::parseProperty() {
  if (header_.elements.empty())
    scanner_.fail(ErrorCode::ParseError, "a property stands before the first element.");
  PlyProperty property;
  TextScanner ahead = scanner_;
  if (ahead.word() == "list") {
    scanner_.word();
    property.countType = parseType();
    if (isFloating(*property.countType))
      scanner_.fail(ErrorCode::ParseError, "the length of a list must be of an integer type.");
  }
  property.type = parseType();
  property.name = scanner_.word();
  if (property.name.empty()) scanner_.fail(ErrorCode::ParseError, "a property has no name.");
  std::vector<PlyProperty>& properties = header_.elements.back().properties;
  if (properties.size() == kMostNames)
    scanner_.fail(ErrorCode::Unsupported, "an element has more than 1000 properties.");
  for (const PlyProperty& other : properties)
    if (other.name == property.name)
      scanner_.fail(ErrorCode::ParseError, "there is a second property \"" +
                                               legible(property.name) + "\" of the element \"" +
                                               legible(header_.elements.back().name) + "\".");
  properties.push_back(std::move(property));
}

void HeaderParser::addRemark(std::string_view begin) {
  const std::string_view text = scanner_.rest();
  header_.remarks.push_back(std::string(begin) + (text.empty() ? "" : " ") + std::string(text));
}

void HeaderParser::parseLine(std::string_view keyword) {
  if (keyword == "format") {
    parseEncoding();
  } else if (keyword == "element") {
    parseElement();
  } else if (keyword == "property") {
    parseProperty();
  } else if (keyword == "comment" || keyword == "obj_info") {
    addRemark(keyword);
  } else if (header_.elements.empty() && keyword != "end_header" && !keyword.empty()) {
    addRemark("comment " + std::string(keyword));  // exporters sign there without saying so
  } else if (keyword != "end_header" && !keyword.empty()) {
    scanner_.fail(ErrorCode::ParseError, "a PLY's header knows no \"" + legible(keyword) + "\".");
  }
}

ParsedPlyHeader HeaderParser::parse() {
  if (!scanner_.nextLine() || scanner_.word() != "ply")
    scanner_.fail(ErrorCode::ParseError, "the file does not begin with ply.");
  std::size_t lines = 1;
  for (; scanner_.nextLine(); ++lines) parseLine(scanner_.word());
  if (!hasEncoding_) scanner_.fail(ErrorCode::ParseError, "the header says no format.");
  return {std::move(header_), 0, lines};
}

}  // namespace

std::size_t sizeOf(PlyType type) { return traits(type).size; }
bool isFloating(PlyType type) { return type == PlyType::Float32 || type == PlyType::Float64; }
double largestOf(PlyType type) { return traits(type).largest; }
double smallestOf(PlyType type) { return traits(type).smallest; }

ParsedPlyHeader parsePlyHeader(std::string_view file, const std::string& fileName) {
  if (!file.starts_with("ply"))
    throw Error(ErrorCode::ParseError,
                legible(fileName) + ", line 1: the file does not begin with ply.", "Is it a PLY?");
  const std::size_t size = headerSize(file, fileName);
  ParsedPlyHeader parsed = HeaderParser(file.substr(0, size), fileName).parse();
  parsed.size = size;
  return parsed;
}

bool isBinaryPly(std::string_view begin) {
  try {
    const ParsedPlyHeader parsed = parsePlyHeader(begin, "");
    return parsed.header.encoding != PlyEncoding::Ascii && parsed.size < begin.size();
  } catch (const Error&) {
    return false;
  }
}

std::string writtenHeader(const PlyHeader& header) {
  std::string text = "ply\nformat ";
  text += kEncodings[static_cast<std::size_t>(header.encoding)];
  text += " 1.0\n";
  for (const std::string& remark : header.remarks) text += remark + "\n";
  for (const PlyElement& element : header.elements) {
    text += "element " + element.name + " " + std::to_string(element.count) + "\n";
    for (const PlyProperty& property : element.properties) {
      text += "property ";
      if (property.countType) text += "list " + std::string(traits(*property.countType).name) + " ";
      text += std::string(traits(property.type).name) + " " + property.name + "\n";
    }
  }
  return text + "end_header\n";
}

}  // namespace remesher::io
