// SPDX-License-Identifier: MIT
#include "io/ply/ply_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "base/legible.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

constexpr char kHint[] = "Its header promises more than follows: was it copied completely?";

}  // namespace

PlyBody::PlyBody(const File& file, const ParsedPlyHeader& parsed)
    : name_(file.name),
      encoding_(parsed.header.encoding),
      scanner_(asText(file), file.name),
      reader_(file) {
  reader_.goTo(parsed.size);
  if (encoding_ != PlyEncoding::Ascii) return;
  for (std::size_t i = 0; i <= parsed.lines; ++i) scanner_.nextLine();
}

void PlyBody::fail(ErrorCode code, const std::string& what, std::string hint) const {
  if (encoding_ == PlyEncoding::Ascii) scanner_.fail(code, what, std::move(hint));
  throw Error(code, legible(name_) + ", byte " + std::to_string(reader_.at()) + ": " + what,
              std::move(hint));
}

std::uint64_t PlyBody::left() const {
  return encoding_ == PlyEncoding::Ascii ? scanner_.left() : reader_.left();
}

// In text a number takes at least a digit and a separator.
std::uint64_t PlyBody::smallestRow(const PlyElement& element) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes +=
        encoding_ == PlyEncoding::Ascii ? 2 : sizeOf(property.countType.value_or(property.type));
  return bytes;
}

void PlyBody::requireRows(const PlyElement& element) const {
  const std::uint64_t needed = element.count * smallestRow(element);
  const std::uint64_t unparted = encoding_ == PlyEncoding::Ascii ? 1 : 0;
  if (needed <= left() + unparted) return;
  fail(ErrorCode::ParseError,
       "the header promises " + std::to_string(element.count) + " of the element \"" +
           legible(element.name) + "\", at least " + std::to_string(needed) + " bytes, but " +
           std::to_string(left()) + " follow.",
       "Was it copied completely?");
}

template <class Number>
double PlyBody::load() {
  std::array<std::uint8_t, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), reader_.next(sizeof(Number)), sizeof(Number));
  static_assert(std::endian::native == std::endian::little);
  if (encoding_ == PlyEncoding::BigEndian) std::reverse(bytes.begin(), bytes.end());
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(Number));
  return static_cast<double>(number);
}

double PlyBody::nextBinary(PlyType type, std::string_view what) {
  if (left() < sizeOf(type))
    fail(ErrorCode::ParseError, "the file ends where " + legible(what) + " should be.", kHint);
  switch (type) {
    case PlyType::Int8:
      return load<std::int8_t>();
    case PlyType::UInt8:
      return load<std::uint8_t>();
    case PlyType::Int16:
      return load<std::int16_t>();
    case PlyType::UInt16:
      return load<std::uint16_t>();
    case PlyType::Int32:
      return load<std::int32_t>();
    case PlyType::UInt32:
      return load<std::uint32_t>();
    case PlyType::Float32:
      return load<float>();
    default:
      return load<double>();
  }
}

double PlyBody::next(PlyType type, std::string_view what) {
  if (encoding_ != PlyEncoding::Ascii) return nextBinary(type, what);
  if (!scanner_.skipEmptyLines())
    fail(ErrorCode::ParseError, "the file ends where " + legible(what) + " should be.", kHint);
  const double value = scanner_.anyNumber(what);
  return type == PlyType::Float32 ? singleWrittenAs(value) : value;
}

Index PlyBody::nextCount(const PlyProperty& list, std::string_view what) {
  const double value = next(*list.countType, what);
  if (!(value >= 0 && value < kNone) || value != static_cast<double>(static_cast<Index>(value)))
    fail(ErrorCode::ParseError, legible(what) + " is not a whole number from 0 on.");
  const auto count = static_cast<Index>(value);
  const std::uint64_t size = encoding_ == PlyEncoding::Ascii ? 1 : sizeOf(list.type);
  if (count * size > left())
    fail(ErrorCode::ParseError,
         legible(what) + " is " + std::to_string(count) + ", which is beyond the file's end.",
         kHint);
  return count;
}

void PlyBody::skip(const PlyProperty& property) {
  constexpr std::string_view kWhat = "a value of no interest";
  const Index count = property.countType ? nextCount(property, "the length of a list") : 1;
  for (Index i = 0; i < count; ++i) next(property.type, kWhat);
}

}  // namespace remesher::io
