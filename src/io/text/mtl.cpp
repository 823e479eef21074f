// SPDX-License-Identifier: MIT
#include "io/text/mtl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "io/model/conventions.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// map_Kd, map_Bump and so on, and the names without the prefix. map_aat is a switch, not an image.
bool namesImage(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kOthers = {"bump", "disp", "decal", "refl", "norm"};
  return (keyword.starts_with("map_") && keyword != "map_aat") ||
         std::find(kOthers.begin(), kOthers.end(), keyword) != kOthers.end();
}

// True for -0.5, false for -clamp.
bool beginsNumber(std::string_view word) {
  const std::size_t first = word.find_first_not_of("+-");
  return first < word.size() && std::string_view(".0123456789").find(word[first]) != word.npos;
}

std::optional<double> numberIn(std::string_view word) {
  const std::optional<double> value = TextScanner::numberIn(word);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// Reads one to three numbers; missing ones keep their value.
Vec3 vectorIn(TextScanner& line, Vec3 value) {
  for (double& coordinate : value) {
    TextScanner ahead = line;
    const std::string_view word = ahead.word();
    if (!beginsNumber(word)) break;
    coordinate = numberIn(word).value_or(coordinate);
    line = ahead;
  }
  return value;
}

// A colour in linear light; white if it is missing or in another notation.
Vec3 colorIn(TextScanner& line) { return vectorIn(line, Vec3::Ones()).unaryExpr(&linearFromSrgb); }

// The rest of a map's statement: its options, then the image's name, blanks included. Offset, scale
// and turbulence take one to three numbers, -mm two, the other options one word.
Map mapIn(TextScanner& line) {
  Map map;
  Vec3 offset = Vec3::Zero(), scale = Vec3::Ones();
  for (;;) {
    TextScanner ahead = line;
    const std::string_view option = ahead.word();
    if (option.size() < 2 || option[0] != '-') break;
    line = ahead;
    if (option == "-o") {
      offset = vectorIn(line, offset);
    } else if (option == "-s") {
      scale = vectorIn(line, scale);
    } else if (option == "-t") {
      vectorIn(line, {});
    } else {
      if (option == "-mm") line.word();
      if (line.word() == "on" && option == "-clamp") map.wrap = {Wrap::Clamp, Wrap::Clamp};
    }
  }
  map.image = std::string(line.rest());
  map.transform << scale.x(), 0, offset.x(), 0, scale.y(), 1 - scale.y() - offset.y();
  return map;
}

// Exporters translate Phong's shininess, 0 to 1000, in this way.
double roughnessOf(double shininess) {
  constexpr double kMost = 1000;
  return 1 - std::sqrt(std::clamp(shininess / kMost, 0.0, 1.0));
}

void setOpacity(Material& material, double opacity) {
  material.baseColor[3] = std::clamp(opacity, 0.0, 1.0);
  material.isOpaque = material.baseColor[3] >= 1;
  material.rest = material.isOpaque ? "" : "BLEND";
}

void readNumbers(Material& material, std::string_view keyword, TextScanner& line) {
  if (keyword == "Kd") material.baseColor.head<3>() = colorIn(line);
  if (keyword == "Ke") material.emissive = colorIn(line);
  const std::optional<double> number = numberIn(line.word());
  if (!number) return;
  if (keyword == "d") setOpacity(material, *number);
  if (keyword == "Tr") setOpacity(material, 1 - *number);
  if (keyword == "Ns") material.roughness = roughnessOf(*number);
  if (keyword == "Pr") material.roughness = std::clamp(*number, 0.0, 1.0);
  if (keyword == "Pm") material.metallic = std::clamp(*number, 0.0, 1.0);
}

void readMap(Material& material, std::string_view keyword, TextScanner& line) {
  Map map = mapIn(line);
  if (!map) return;
  if (keyword == "map_Kd") {
    material.baseColorMap = std::move(map);
  } else if (keyword == "norm" || keyword == "map_Kn") {
    material.normalMap = std::move(map);
  } else if (keyword == "map_Ke") {
    material.emissiveMap = std::move(map);
    if (material.emissive.isZero()) material.emissive.setOnes();
  } else {
    material.unpaintable.emplace_back(keyword);
  }
}

TextScanner scannerOf(const File& library) { return {asText(library), library.name}; }

}  // namespace

std::vector<std::string> imagesOf(const File& library) {
  TextScanner scanner = scannerOf(library);
  std::vector<std::string> images;
  std::set<std::string> seen;
  while (scanner.nextLine()) {
    if (scanner.atLineEnd() || !namesImage(scanner.word())) continue;
    std::string name = mapIn(scanner).image;
    if (!name.empty() && seen.insert(name).second) images.push_back(std::move(name));
  }
  return images;
}

std::map<std::string, Material> materialsOf(const File& library) {
  TextScanner scanner = scannerOf(library);
  std::map<std::string, Material> materials;
  Material* current = nullptr;
  while (scanner.nextLine()) {
    if (scanner.atLineEnd()) continue;
    const std::string_view keyword = scanner.word();
    if (keyword == "newmtl") {
      std::string name(scanner.rest());
      current = &materials[name];
      current->name = std::move(name);
    } else if (current != nullptr && namesImage(keyword)) {
      readMap(*current, keyword, scanner);
    } else if (current != nullptr) {
      readNumbers(*current, keyword, scanner);
    }
  }
  return materials;
}

}  // namespace remesher::io
