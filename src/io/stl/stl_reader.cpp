// SPDX-License-Identifier: MIT
// Tells the two kinds apart. A file is binary if its length matches its facet count, even if it
// begins with `solid`, as many do. It is text if it begins with `solid` and its first 512 bytes
// have no zero.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "base/legible.h"
#include "io/model/byte_reader.h"
#include "io/model/corner_weld.h"
#include "io/stl/stl.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

bool isText(const File& file) {
  constexpr std::size_t kLooked = 512;
  const std::string_view start = asText(file).substr(0, kLooked);
  const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return false;
  std::string word(start.substr(first, 5));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word != "solid" || start.find('\0') != std::string_view::npos) return false;
  return file.bytes.size() < kFacetsAt ||
         file.bytes.size() !=
             kFacetsAt + std::uint64_t{kFacetBytes} *
                             littleEndianAt<std::uint32_t>(&file.bytes[kHeaderBytes]);
}

struct Facets {
  TriangleMesh mesh;
  std::vector<GroupInfo> solids;
  std::size_t colored = 0;
  std::vector<Warning> warnings = {};
};

class StlText {
 public:
  explicit StlText(const File& file) : scanner_(asText(file), file.name) {}
  Facets read();

 private:
  void beginSolid();
  void readVertex();
  void endLoop();

  TextScanner scanner_;
  CornerWeld weld_;
  Facets facets_;
  std::map<std::string, Index, std::less<>> solidNumbers_;
  Index solid_ = 0;
  std::array<Index, 3> loop_{};
  std::size_t corners_ = 0;  // read in this loop
};

void StlText::beginSolid() {
  const std::string name(scanner_.rest());
  const auto [entry, isNew] =
      solidNumbers_.emplace(name, static_cast<Index>(facets_.solids.size()));
  if (isNew) facets_.solids.push_back({name, {}});
  solid_ = entry->second;
}

void StlText::readVertex() {
  Vec3 position;
  for (double& coordinate : position) {
    if (!scanner_.skipEmptyLines())
      scanner_.fail(ErrorCode::ParseError, "the file ends within a vertex.",
                    "Was it copied completely?");
    coordinate = scanner_.number("the coordinate of a vertex");
  }
  if (corners_ == loop_.size())
    scanner_.fail(ErrorCode::ParseError, "a facet has more than three corners.");
  loop_[corners_++] = weld_.vertexAt(position);
}

void StlText::endLoop() {
  if (corners_ != loop_.size())
    scanner_.fail(ErrorCode::ParseError, "a facet has fewer than three corners.");
  facets_.mesh.indices.insert(facets_.mesh.indices.end(), loop_.begin(), loop_.end());
  facets_.mesh.groups.push_back(solid_);
  corners_ = 0;
}

Facets StlText::read() {
  scanner_.nextLine();
  while (scanner_.skipEmptyLines()) {
    std::string keyword(scanner_.word());
    for (char& c : keyword) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (keyword == "vertex") {
      readVertex();
    } else if (keyword == "endloop") {
      endLoop();
    } else if (keyword == "solid") {
      beginSolid();
    } else if (keyword == "normal") {  // ignored: it follows from the corners
      for (int i = 0; i < 3; ++i) scanner_.word();
    } else if (keyword == "endsolid") {
      scanner_.rest();
    } else if (keyword != "facet" && keyword != "outer" && keyword != "loop" &&
               keyword != "endfacet") {
      scanner_.fail(ErrorCode::ParseError, "an STL knows no \"" + legible(keyword) + "\".");
    }
  }
  if (corners_ > 0)
    scanner_.fail(ErrorCode::ParseError, "the file ends within a facet.",
                  "Was it copied completely?");
  facets_.mesh.positions = std::move(weld_.positions());
  return std::move(facets_);
}

void warnOfCount(const File& file, const std::string& what, std::uint64_t count,
                 std::vector<Warning>& warnings) {
  warnings.push_back({"COUNT_CONTRADICTS", legible(file.name) + what, std::size_t(count)});
}

// The bytes decide: some programs write the number before they know it.
std::uint64_t facetsIn(const File& file, std::uint64_t promised, std::vector<Warning>& warnings) {
  const std::uint64_t behind = fileSize(file) - (kFacetsAt + kFacetBytes * promised);
  if (behind == 0) return promised;
  const std::string said = " says that it has " + std::to_string(promised) + " facets, but ";
  if (behind % kFacetBytes != 0) {
    warnOfCount(file,
                said + "has more bytes than these take: the last " + std::to_string(behind) +
                    " are left out.",
                behind, warnings);
    return promised;
  }
  const std::uint64_t held = promised + behind / kFacetBytes;
  warnOfCount(file, said + "its bytes hold " + std::to_string(held) + ": all are read.",
              behind / kFacetBytes, warnings);
  return held;
}

[[noreturn]] void failShort(const File& file, std::uint64_t count) {
  throw Error(ErrorCode::ParseError,
              legible(file.name) + ": it promises " + std::to_string(count) + " facets in " +
                  std::to_string(kFacetsAt + kFacetBytes * count) + " bytes, but has " +
                  std::to_string(fileSize(file)) + ".",
              "Was it copied completely?");
}

Vec3 cornerAt(const std::uint8_t* bytes, const File& file, std::size_t facet) {
  Vec3 position;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    position[static_cast<Eigen::Index>(axis)] = littleEndianAt<float>(bytes + 4 * axis);
    if (!position.array().isFinite()[static_cast<Eigen::Index>(axis)])
      throw Error(
          ErrorCode::NonFinite,
          legible(file.name) + ": a corner of facet " + std::to_string(facet) + " is not finite.",
          "Repair the file: every coordinate must be a finite number.");
  }
  return position;
}

Facets readBinary(const File& file) {
  const std::uint64_t size = fileSize(file);
  if (size < kFacetsAt)
    throw Error(ErrorCode::ParseError,
                legible(file.name) +
                    ": it is shorter than the header of an STL, and does not begin with \"solid\".",
                "Was it copied completely?");
  ByteReader reader(file);
  const std::string header(reinterpret_cast<const char*>(reader.next(kHeaderBytes)), kHeaderBytes);
  const std::uint64_t promised =
      littleEndianAt<std::uint32_t>(reader.next(kFacetsAt - kHeaderBytes));
  if (size < kFacetsAt + kFacetBytes * promised) failShort(file, promised);
  Facets facets;
  const std::uint64_t count = facetsIn(file, promised, facets.warnings);
  requireRoomFor({double(count) / 2, double(count)}, file);
  // Two conventions for colours: VisCAM and SolidView set the highest bit of a coloured facet;
  // Magics announces colours in the header and clears the bit.
  const bool isMagics = header.find("COLOR=") != std::string::npos;
  CornerWeld weld(static_cast<std::size_t>(count));
  facets.mesh.indices.reserve(3 * static_cast<std::size_t>(count));
  for (std::size_t facet = 0; facet < count; ++facet) {
    const std::uint8_t* const bytes = reader.next(kFacetBytes);
    for (std::size_t corner = 1; corner <= 3; ++corner)
      facets.mesh.indices.push_back(weld.vertexAt(cornerAt(bytes + 12 * corner, file, facet)));
    const bool hasHighBit = (littleEndianAt<std::uint16_t>(bytes + kFacetBytes - 2) & 0x8000U) != 0;
    if (hasHighBit != isMagics) ++facets.colored;
  }
  facets.mesh.positions = std::move(weld.positions());
  facets.mesh.isSingle = true;
  return facets;
}

}  // namespace

Model readStl(const File& file, const std::vector<File>&) {
  Facets facets = !file.source && isText(file) ? StlText(file).read() : readBinary(file);
  if (facets.mesh.triangleCount() == 0)
    throw Error(ErrorCode::NoTriangles, legible(file.name) + " has no facets.",
                "Only surfaces can be remeshed.");
  Model model;
  model.conventions = Conventions::Classic;
  model.warnings = std::move(facets.warnings);
  if (facets.colored > 0)
    model.warnings.push_back({"ATTRIBUTE_NOT_CARRIED",
                              "The colours of facets are not carried: other formats have colours "
                              "that tools agree on.",
                              facets.colored});
  if (facets.solids.size() < 2) {
    facets.mesh.groups.clear();
    facets.solids.clear();
  }
  model.parts.push_back(
      {file.name, std::move(facets.mesh), {Transform::Identity()}, std::move(facets.solids)});
  return model;
}

}  // namespace remesher::io
