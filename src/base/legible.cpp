// SPDX-License-Identifier: MIT
#include "base/legible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace remesher {
namespace {

constexpr std::size_t kLongest = 120;  // characters
constexpr std::size_t kHead = 80;      // a longer text keeps these, a mark, and its end
constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kEllipsis = 0x2026;

struct Range {
  char32_t first;
  char32_t last;
};

// Characters that show nothing but have an effect: controls, direction marks, line ends, tags.
constexpr std::array<Range, 11> kInvisible = {{{0x00, 0x1F},
                                               {0x7F, 0x9F},
                                               {0xAD, 0xAD},
                                               {0x61C, 0x61C},
                                               {0x180E, 0x180E},
                                               {0x200B, 0x200F},
                                               {0x2028, 0x202E},
                                               {0x2060, 0x206F},
                                               {0xFEFF, 0xFEFF},
                                               {0xFFF9, 0xFFFB},
                                               {0xE0000, 0xE007F}}};

bool isInvisible(char32_t c) {
  return std::any_of(kInvisible.begin(), kInvisible.end(),
                     [c](const Range& range) { return range.first <= c && c <= range.last; });
}

// The length in bytes of the character that begins with this byte; 0 if none does.
std::size_t lengthFrom(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

// Removes the first character of the text and returns it.
char32_t takeCharacter(std::string_view& text) {
  const auto first = static_cast<std::uint8_t>(text[0]);
  const std::size_t length = lengthFrom(first);
  char32_t value = length == 1 ? first : first & (0x7FU >> length);
  bool isValid = length > 0 && length <= text.size();
  for (std::size_t i = 1; isValid && i < length; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    isValid = (byte & 0xC0U) == 0x80U;
    value = value << 6U | (byte & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool isSurrogate = value >= 0xD800 && value <= 0xDFFF;
  isValid = isValid && value >= kLeast[length] && value <= 0x10FFFF && !isSurrogate;
  text.remove_prefix(isValid ? length : 1);
  return isValid ? value : kReplacement;
}

std::string escaped(char32_t c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string digits;
  for (; c > 0 || digits.empty(); c >>= 4) digits += kHex[c & 15];
  std::reverse(digits.begin(), digits.end());
  return "\\u{" + digits + "}";
}

// The characters as shown. Of a very long text only the two ends can be shown, so only they are
// read.
std::vector<char32_t> charactersOf(std::string_view text) {
  constexpr std::size_t kEnd = 8 * kLongest;
  std::string ends;
  if (text.size() > 2 * kEnd) {
    ends = std::string(text.substr(0, kEnd)) + std::string(text.substr(text.size() - kEnd));
    text = ends;
  }
  std::vector<char32_t> characters;
  while (!text.empty()) {
    const char32_t c = takeCharacter(text);
    const std::string spelled = isInvisible(c) ? escaped(c) : "";
    characters.insert(characters.end(), spelled.begin(), spelled.end());
    if (spelled.empty()) characters.push_back(c);
  }
  return characters;
}

void append(std::string& text, char32_t c) {
  if (c < 0x80) {
    text += static_cast<char>(c);
    return;
  }
  const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  text += static_cast<char>((0xFFU << (7 - more) & 0xFFU) | c >> 6 * more);
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80U | (c >> 6 * i & 0x3FU));
}

// Smaller numbers get an exponent, as do those with more digits before the point than `digits`.
constexpr int kSmallestExponent = -4;

// Multiplies in steps of at most 10^22, the largest power of ten that a double holds exactly.
double timesTenTo(double x, int power) {
  double factor = 1;
  for (int i = std::abs(power); i > 0; --i) {
    factor *= 10;
    if (i % 22 != 1) continue;
    x = power > 0 ? x * factor : x / factor;
    factor = 1;
  }
  return x;
}

// x ≥ 0 rounded to an integer of `digits` digits, with its exponent: d.ddd × 10^exponent.
struct Scaled {
  std::uint64_t whole = 0;
  int exponent = 0;
};

Scaled scaled(double x, int digits) {
  Scaled result;
  for (double size = x; size >= 10; size /= 10) ++result.exponent;
  for (double size = x; size < 1; size *= 10) --result.exponent;
  const auto tooMany = std::uint64_t(timesTenTo(1, digits));
  const auto roundedAt = [&](int exponent) {
    return std::uint64_t(std::floor(timesTenTo(x, digits - 1 - exponent) + 0.5));
  };
  result.whole = roundedAt(result.exponent);
  if (result.whole >= tooMany) result.whole = roundedAt(++result.exponent);
  return result;
}

std::string withExponent(std::string text, int exponent) {
  if (text.size() > 1) text.insert(1, ".");
  const std::string size = std::to_string(std::abs(exponent));
  return text + (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" : "") + size;
}

}  // namespace

std::string legible(std::string_view text) {
  std::vector<char32_t> characters = charactersOf(text);
  if (characters.size() > kLongest) {
    const auto cut = characters.begin() + kHead;
    *cut = kEllipsis;
    characters.erase(cut + 1, characters.end() - (kLongest - kHead - 1));
  }
  std::string result;
  for (const char32_t c : characters) append(result, c);
  return result;
}

std::string legibleList(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i)
    list += (i == 0 ? "" : ", ") + legible(names[i]);
  if (names.size() > kMost) list += " and " + std::to_string(names.size() - kMost) + " more";
  return list;
}

std::string inDigits(double x, int digits) {
  const std::string sign = std::signbit(x) ? "-" : "";
  if (std::isnan(x)) return sign + "nan";
  if (std::isinf(x)) return sign + "inf";
  if (x == 0) return sign + "0";
  const auto [whole, exponent] = scaled(std::abs(x), digits);
  std::string text = std::to_string(whole);
  text.erase(text.find_last_not_of('0') + 1);
  if (exponent < kSmallestExponent || exponent >= digits)
    return sign + withExponent(std::move(text), exponent);
  if (exponent < 0) return sign + "0." + std::string(std::size_t(-exponent - 1), '0') + text;
  const std::size_t before = std::size_t(exponent) + 1;
  if (text.size() <= before) return sign + text + std::string(before - text.size(), '0');
  return sign + text.insert(before, ".");
}

}  // namespace remesher
