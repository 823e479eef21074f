// SPDX-License-Identifier: MIT
#include "io/model/companions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/legible.h"
#include "io/model/resources.h"

namespace remesher::io {
namespace {

// Of folders and name together: Windows and most other systems accept this length.
constexpr std::size_t kLongestName = 200;

// Windows reserves these names for devices in every folder, with any extension.
bool isDeviceName(std::string_view part) {
  constexpr std::array<std::string_view, 4> kDevices = {"con", "prn", "aux", "nul"};
  const std::string stem = lowerCase(part.substr(0, part.find('.')));
  const bool isPort = stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) &&
                      stem[3] >= '0' && stem[3] <= '9';
  return isPort || std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end();
}

// legible() changes invisible characters and invalid UTF-8, so an unchanged part has none.
bool isPlainPart(std::string_view part) {
  return !part.empty() && part.front() != '.' && part.back() != '.' && part.front() != ' ' &&
         part.back() != ' ' && !isDeviceName(part) && legible(part) == part &&
         part.find_first_of("\\:*?\"<>|") == std::string_view::npos;
}

bool isPlainSpelling(std::string_view name) {
  if (name.size() > kLongestName) return false;
  for (std::size_t begin = 0;;) {
    const std::size_t slash = name.find('/', begin);
    if (!isPlainPart(name.substr(begin, slash - begin))) return false;
    if (slash == std::string_view::npos) return true;
    begin = slash + 1;
  }
}

std::string withNumber(const std::string& name, int number) {
  const std::size_t lastPart = name.rfind('/') + 1;
  const std::size_t dot = name.rfind('.');
  const std::size_t end = dot == std::string::npos || dot < lastPart ? name.size() : dot;
  return name.substr(0, end) + "-" + std::to_string(number) + name.substr(end);
}

}  // namespace

bool isPlainName(std::string_view name) {
  for (std::string spelling(name);;) {
    if (!isPlainSpelling(spelling)) return false;
    const std::string decoded = percentDecoded(spelling);
    if (decoded == spelling) return true;
    spelling = decoded;
  }
}

std::string plainName(std::string_view path) {
  const std::string_view base = baseName(path);
  if (isPlainName(base)) return std::string(base);
  std::string name;
  // The end of a long name is kept, because it has the extension.
  for (const char c : base.substr(base.size() - std::min<std::size_t>(base.size(), 100))) {
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
    name += isLetter ? c : '_';
  }
  while (!name.empty() && name.back() == '.') name.pop_back();
  if (!isPlainName(name)) name = "_" + name;
  return name;
}

CompanionNames::CompanionNames(std::string_view result) { used_[lowerCase(result)] = 1; }

std::string CompanionNames::distinct(const std::string& name) {
  std::string result = name;
  for (int& number = used_[lowerCase(name)]; ++number > 1;) {
    result = withNumber(name, number);
    if (used_.emplace(lowerCase(result), 1).second) break;
  }
  return result;
}

std::string CompanionNames::nameForFile(std::string_view name) {
  return distinct(isPlainName(name) ? std::string(name) : plainName(name));
}

std::string CompanionNames::nameFor(std::string_view reference) {
  if (isPlainName(reference)) return distinct(percentDecoded(reference));
  // Decodes until nothing changes, so that a name hidden by repeated encoding does not come out.
  const std::size_t size = std::min<std::size_t>(reference.size(), 5 * kLongestName);
  std::string spelling(reference.substr(reference.size() - size));
  std::string decoded = percentDecoded(spelling);
  while (decoded != spelling) spelling = std::exchange(decoded, percentDecoded(decoded));
  return distinct(plainName(spelling));
}

std::string referenceTo(std::string_view name) {
  std::string reference;
  for (std::size_t begin = 0;;) {
    const std::size_t slash = name.find('/', begin);
    reference += percentEncoded(name.substr(begin, slash - begin));
    if (slash == std::string_view::npos) return reference;
    reference += '/';
    begin = slash + 1;
  }
}

}  // namespace remesher::io
