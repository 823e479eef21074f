// SPDX-License-Identifier: MIT
#include "io/text/mtl.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// map_Kd, map_Bump, …; and those without the prefix. map_aat is a switch, not an image.
bool namesImage(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kOthers = {"bump", "disp", "decal", "refl", "norm"};
  return (keyword.starts_with("map_") && keyword != "map_aat") ||
         std::find(kOthers.begin(), kOthers.end(), keyword) != kOthers.end();
}

// -0.5 does, and -clamp does not.
bool beginsNumber(std::string_view word) {
  const std::size_t first = word.find_first_not_of("+-");
  return first < word.size() && std::string_view(".0123456789").find(word[first]) != word.npos;
}

// Offset, scale and turbulence take one to three numbers, -mm two, the other options one word.
void skipArguments(TextScanner& line, std::string_view option) {
  const bool isVector = option == "-o" || option == "-s" || option == "-t";
  const int most = isVector ? 3 : option == "-mm" ? 2 : 1;
  for (int i = 0; i < most; ++i) {
    TextScanner ahead = line;
    if (isVector && !beginsNumber(ahead.word())) return;
    line.word();
  }
}

// What follows the options of a statement, blanks and all.
std::string fileName(TextScanner& line) {
  for (;;) {
    TextScanner ahead = line;
    const std::string_view option = ahead.word();
    if (option.size() < 2 || option[0] != '-') return std::string(line.rest());
    line = ahead;
    skipArguments(line, option);
  }
}

}  // namespace

std::vector<std::string> imagesOf(const File& library) {
  TextScanner scanner({reinterpret_cast<const char*>(library.bytes.data()), library.bytes.size()},
                      library.name);
  std::vector<std::string> images;
  std::set<std::string> seen;
  while (scanner.nextLine()) {
    if (scanner.atLineEnd() || !namesImage(scanner.word())) continue;
    std::string name = fileName(scanner);
    if (!name.empty() && seen.insert(name).second) images.push_back(std::move(name));
  }
  return images;
}

}  // namespace remesher::io
