// SPDX-License-Identifier: MIT
#include "io/ply/ply_sink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace remesher::io {

PlySink::PlySink(const PlyHeader& header) : encoding_(header.encoding) {
  const std::string text = writtenHeader(header);
  if (encoding_ == PlyEncoding::Ascii)
    text_.text(text);
  else
    bytes_.assign(text.begin(), text.end());
}

template <class Number>
void PlySink::store(double value) {
  const auto number = static_cast<Number>(value);
  std::array<std::uint8_t, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if (encoding_ == PlyEncoding::BigEndian) std::reverse(bytes.begin(), bytes.end());
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void PlySink::putBinary(PlyType type, double value) {
  switch (type) {
    case PlyType::Int8:
      return store<std::int8_t>(value);
    case PlyType::UInt8:
      return store<std::uint8_t>(value);
    case PlyType::Int16:
      return store<std::int16_t>(value);
    case PlyType::UInt16:
      return store<std::uint16_t>(value);
    case PlyType::Int32:
      return store<std::int32_t>(value);
    case PlyType::UInt32:
      return store<std::uint32_t>(value);
    case PlyType::Float32:
      return store<float>(value);
    default:
      return store<double>(value);
  }
}

void PlySink::put(PlyType type, double value) {
  if (!isFloating(type))
    value = std::clamp(std::round(value), smallestOf(type), largestOf(type));
  else if (type == PlyType::Float32)
    value = static_cast<double>(static_cast<float>(value));
  if (encoding_ != PlyEncoding::Ascii) return putBinary(type, value);
  text_.text(isRowBegun_ ? " " : "");
  isRowBegun_ = true;
  if (type == PlyType::Float64)
    text_.doubleNumber(value);
  else if (!isFloating(type) && value >= 0)
    text_.integer(static_cast<std::size_t>(value));
  else
    text_.number(value);
}

void PlySink::endRow() {
  if (encoding_ == PlyEncoding::Ascii) text_.text("\n");
  isRowBegun_ = false;
}

std::vector<std::uint8_t> PlySink::bytes() const {
  return encoding_ == PlyEncoding::Ascii ? text_.bytes() : bytes_;
}

}  // namespace remesher::io
