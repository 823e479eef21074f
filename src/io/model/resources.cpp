// SPDX-License-Identifier: MIT
#include "io/model/resources.h"

#include <array>

namespace remesher::io {
namespace {

constexpr std::string_view kBase64Digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 0xFF;

constexpr std::array<std::uint8_t, 256> digitValues() {
  std::array<std::uint8_t, 256> values{};
  for (auto& value : values) value = kNoDigit;
  for (std::size_t i = 0; i < kBase64Digits.size(); ++i)
    values[static_cast<unsigned char>(kBase64Digits[i])] = static_cast<std::uint8_t>(i);
  return values;
}

std::optional<std::vector<std::uint8_t>> decodeBase64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> kValues = digitValues();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kNoDigit) return std::nullopt;
    bits = bits << 6 | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  return bytes;
}

int hexValue(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string_view baseName(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string lowerCase(std::string_view name) {
  std::string result(name);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string percentDecoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isEscape = text[i] == '%' && i + 2 < text.size() && hexValue(text[i + 1]) >= 0 &&
                          hexValue(text[i + 2]) >= 0;
    result +=
        isEscape ? static_cast<char>(16 * hexValue(text[i + 1]) + hexValue(text[i + 2])) : text[i];
    if (isEscape) i += 2;
  }
  return result;
}

std::string percentEncoded(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (kPlain.find(c) != std::string_view::npos)
      result += c;
    else
      result.append({'%', kHex[byte >> 4], kHex[byte & 15]});
  }
  return result;
}

Resources::Resources(const std::vector<File>& files) {
  for (const File& file : files) {
    byName_.emplace(file.name, &file);
    const auto [entry, isNew] = byBaseName_.emplace(baseName(file.name), &file);
    if (!isNew) entry->second = nullptr;
  }
}

const File* Resources::named(std::string_view name) const {
  const auto found = byName_.find(name);
  return found == byName_.end() ? nullptr : found->second;
}

const File* Resources::find(std::string_view reference) const {
  const std::string decoded = percentDecoded(reference);
  for (const std::string_view wanted : {reference, std::string_view(decoded)})
    if (const File* const file = named(wanted)) return file;
  const auto found = byBaseName_.find(baseName(decoded));
  return found == byBaseName_.end() ? nullptr : found->second;
}

bool isDataUri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

std::optional<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!isDataUri(uri) || comma == std::string_view::npos) return std::nullopt;
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return decodeBase64(data);
  const std::string plain = percentDecoded(data);
  return std::vector<std::uint8_t>(plain.begin(), plain.end());
}

std::string encodeDataUri(std::string_view mediaType, std::span<const std::uint8_t> bytes) {
  std::string uri = "data:" + std::string(mediaType) + ";base64,";
  uri.reserve(uri.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k)
      uri += k <= count ? kBase64Digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return uri;
}

}  // namespace remesher::io
