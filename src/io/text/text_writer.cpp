// SPDX-License-Identifier: MIT
#include "io/text/text_writer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "io/model/json.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// WebAssembly's standard library cannot write floating point numbers with the fewest digits; the
// JSON library's inner routine can.
template <class Float>
std::string_view shortest(std::array<char, 64>& buffer, Float value) {
  char* const end = nlohmann::detail::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  if (text.ends_with(".0")) text.remove_suffix(2);
  return text;
}

}  // namespace

TextWriter& TextWriter::text(std::string_view text) {
  text_ += text;
  return *this;
}

TextWriter& TextWriter::number(double value) {
  std::array<char, 64> buffer{};
  const auto single = static_cast<float>(value);
  text_ +=
      static_cast<double>(single) == value ? shortest(buffer, single) : shortest(buffer, value);
  return *this;
}

TextWriter& TextWriter::doubleNumber(double value) {
  std::array<char, 64> buffer{};
  text_ += shortest(buffer, value);
  return *this;
}

TextWriter& TextWriter::coordinate(double value) {
  return digits_ == Digits::Fewest ? number(value) : doubleNumber(value);
}

TextWriter& TextWriter::integer(std::size_t value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text_.append(buffer.data(), end);
  return *this;
}

TextWriter& TextWriter::coordinates(const Vec3& values) {
  for (const double value : values) text(" ").coordinate(value);
  return *this;
}

Digits digitsFor(const std::vector<const TriangleMesh*>& meshes, Digits wanted) {
  for (const TriangleMesh* mesh : meshes)
    for (const Vec3& p : mesh->positions)
      if (inSingle(p, {}) != p) return Digits::OfDoubles;
  return wanted;
}

double singleWrittenAs(double value) {
  std::array<char, 64> buffer{};
  const auto single = static_cast<float>(value);
  if (!std::isfinite(single)) return value;
  const bool isWrittenSo = TextScanner::numberIn(shortest(buffer, single)) == value;
  return isWrittenSo ? static_cast<double>(single) : value;
}

}  // namespace remesher::io
