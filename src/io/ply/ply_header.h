// SPDX-License-Identifier: MIT
// The header of a PLY file: its elements, their counts, and their properties. [Turk 1994] The PLY
// polygon file format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace remesher::io {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

std::size_t sizeOf(PlyType type);
bool isFloating(PlyType type);
double largestOf(PlyType type);   // of an integer type
double smallestOf(PlyType type);  // likewise

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> countType = {};  // of a list's length; none: not a list
};

struct PlyElement {
  std::string name;
  Index count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::LittleEndian;
  std::vector<std::string> remarks;  // whole lines, beginning with `comment` or `obj_info`
  std::vector<PlyElement> elements;
};

struct ParsedPlyHeader {
  PlyHeader header;
  std::size_t size = 0;   // bytes
  std::size_t lines = 0;  // the line of end_header included
};

// Throws PARSE_ERROR with the line's number.
ParsedPlyHeader parsePlyHeader(std::string_view file, const std::string& fileName);

// Whether a file begins with the whole header of a binary PLY.
bool isBinaryPly(std::string_view begin);

std::string writtenHeader(const PlyHeader& header);

}  // namespace remesher::io
