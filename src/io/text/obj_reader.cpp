// SPDX-License-Identifier: MIT
// OBJ keeps positions, texture coordinates and normals in three lists; a face's corner names one of
// each. Each combination that occurs becomes a mesh vertex, in the order of positions, so that a
// file without vt and vn keeps its vertex numbers.
#include <algorithm>
#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "base/legible.h"
#include "geometry/polygon.h"
#include "io/model/byte_reader.h"
#include "io/model/conventions.h"
#include "io/model/resources.h"
#include "io/model/wedges.h"
#include "io/text/mtl.h"
#include "io/text/obj.h"
#include "io/text/text_blocks.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// Indices into the three lists; texcoord and normal may be kNone.
struct Corner {
  Index position = kNone;
  Index texcoord = kNone;
  Index normal = kNone;

  auto operator<=>(const Corner&) const = default;
};
using CornerField = Index Corner::*;

// Corners of many faces, most of which have neither texture coordinates nor normals.
class CornerList {
 public:
  std::size_t size() const { return positions_.size(); }
  // Whether each corner has a position alone.
  bool arePositions() const { return texcoords_.empty() && normals_.empty(); }

  Corner operator[](std::size_t i) const {
    return {positions_[i], texcoords_.empty() ? kNone : texcoords_[i],
            normals_.empty() ? kNone : normals_[i]};
  }

  void add(const Corner& corner) {
    addTo(texcoords_, corner.texcoord);
    addTo(normals_, corner.normal);
    positions_.push_back(corner.position);
  }

  std::vector<Index> takePositions() { return std::move(positions_); }

 private:
  // Lists begin with the first number in them.
  void addTo(std::vector<Index>& list, Index number) {
    if (list.empty() && number == kNone) return;
    list.resize(positions_.size(), kNone);
    list.push_back(number);
  }

  std::vector<Index> positions_, texcoords_, normals_;
};

struct ObjContent {
  std::vector<Vec3> positions;
  std::vector<float> colors;     // 3 per position; fewer if the last positions have none
  std::vector<float> texcoords;  // 2 each
  std::vector<float> normals;    // 3 each
  CornerList corners;            // 3 per triangle
  std::vector<Index> groups;     // 1 per triangle
  std::size_t skippedElements = 0;
  bool haveAllFour = true;   // corners, the faces so far
  std::size_t polygons = 0;  // of more corners than three
};

class ObjReader {
 public:
  explicit ObjReader(const File& file)
      : blocks_(file),
        scanner_(blocks_.next(), file.name),
        source_(std::make_shared<ObjSource>()) {}

  ObjContent read();
  std::shared_ptr<ObjSource> source() { return source_; }
  std::vector<Warning> warnings() const { return scanner_.warnings(); }

 private:
  void readStatement(std::string_view keyword);
  void readPosition();
  void readNumbers(std::vector<float>& list, int count, std::string_view what);
  void readFace();
  Corner readCorner(std::string_view word);
  Index resolve(std::string_view& word, std::size_t listed, std::string_view what);
  Index groupOf(const Corner& corner);

  TextBlocks blocks_;
  TextScanner scanner_;
  std::shared_ptr<ObjSource> source_;
  ObjContent content_;
  ObjGroup state_;
  std::optional<Index> group_;  // the number of state_, once looked up
  std::map<ObjGroup, Index> groupNumbers_;
  std::vector<Corner> polygon_;
  std::vector<Vec3> polygonPoints_;
};

void ObjReader::readPosition() {
  Vec3 position;
  for (double& coordinate : position) coordinate = scanner_.number("the coordinate of a vertex");
  content_.positions.push_back(position);
  std::array<float, 4> extra{};
  std::size_t extras = 0;
  while (extras < extra.size() && !scanner_.atLineEnd())
    extra[extras++] = scanner_.attribute("the colour of a vertex");
  // A single extra number is the weight of a rational curve, which triangles do not need.
  if (extras < 3) return;
  content_.colors.resize(3 * (content_.positions.size() - 1), kUncolored);
  content_.colors.insert(content_.colors.end(), extra.begin(), extra.begin() + 3);
}

void ObjReader::readNumbers(std::vector<float>& list, int count, std::string_view what) {
  for (int i = 0; i < count; ++i) {
    const bool isOptional = i > 0 && scanner_.atLineEnd();
    list.push_back(isOptional ? 0.0F : scanner_.attribute(what));
  }
}

// OBJ numbers from one; negative numbers count back from the end.
Index ObjReader::resolve(std::string_view& word, std::size_t listed, std::string_view what) {
  const auto [number, rest] = TextScanner::leadingInteger(word);
  if (rest.size() == word.size())
    scanner_.fail(ErrorCode::ParseError, "a face has no number where its " + std::string(what) +
                                             " should be: \"" + legible(word) + "\".");
  word = rest;
  const auto count = static_cast<long long>(listed);
  if (number == 0 || number > count || number < -count)
    scanner_.fail(ErrorCode::IndexOutOfRange,
                  "a face names " + std::string(what) + " " + std::to_string(number) + ", but " +
                      (count == 0 ? "there is none" : "there are " + std::to_string(count)) + ".",
                  "Repair the file: a face may name only what stands before it.");
  return static_cast<Index>(number > 0 ? number - 1 : count + number);
}

// v, v/vt, v//vn or v/vt/vn.
Corner ObjReader::readCorner(std::string_view word) {
  const std::string_view whole = word;
  Corner corner;
  corner.position = resolve(word, content_.positions.size(), "vertex");
  if (!word.empty() && word[0] == '/') {
    word.remove_prefix(1);
    if (!word.empty() && word[0] != '/')
      corner.texcoord = resolve(word, content_.texcoords.size() / 2, "texture coordinate");
    if (!word.empty() && word[0] == '/') {
      word.remove_prefix(1);
      if (!word.empty()) corner.normal = resolve(word, content_.normals.size() / 3, "normal");
    }
  }
  if (!word.empty())
    scanner_.fail(
        ErrorCode::ParseError,
        "a face has a corner that is not v, v/vt, v//vn or v/vt/vn: \"" + legible(whole) + "\".");
  return corner;
}

Index ObjReader::groupOf(const Corner& corner) {
  const bool hasTexcoords = corner.texcoord != kNone;
  const bool hasNormals = corner.normal != kNone;
  if (!group_ || hasTexcoords != state_.hasTexcoords || hasNormals != state_.hasNormals) {
    state_.hasTexcoords = hasTexcoords;
    state_.hasNormals = hasNormals;
    const auto next = static_cast<Index>(source_->groups.size());
    const auto [entry, isNew] = groupNumbers_.emplace(state_, next);
    if (isNew) source_->groups.push_back(state_);
    group_ = entry->second;
  }
  return *group_;
}

void ObjReader::readFace() {
  polygon_.clear();
  while (!scanner_.atLineEnd()) polygon_.push_back(readCorner(scanner_.word()));
  if (polygon_.size() < 3)
    scanner_.fail(ErrorCode::ParseError, "a face has fewer than three corners.");
  // If any corner of a face lacks a texture coordinate or normal, the whole face has none.
  const auto lacks = [&](CornerField field) {
    return std::any_of(polygon_.begin(), polygon_.end(),
                       [&](const Corner& corner) { return corner.*field == kNone; });
  };
  for (const CornerField field : {&Corner::texcoord, &Corner::normal})
    if (lacks(field))
      for (Corner& corner : polygon_) corner.*field = kNone;

  content_.haveAllFour &= polygon_.size() == 4;
  content_.polygons += polygon_.size() > 3 ? 1 : 0;
  const Index group = groupOf(polygon_[0]);
  if (polygon_.size() == 3) {
    for (const Corner& corner : polygon_) content_.corners.add(corner);
    content_.groups.push_back(group);
    return;
  }
  polygonPoints_.clear();
  for (const Corner& corner : polygon_)
    polygonPoints_.push_back(content_.positions[corner.position]);
  for (const auto& triangle : triangulate(polygonPoints_)) {
    for (const Index i : triangle) content_.corners.add(polygon_[i]);
    content_.groups.push_back(group);
  }
}

void ObjReader::readStatement(std::string_view keyword) {
  const auto setState = [&](std::string& field) {
    field = scanner_.rest();
    group_.reset();
  };
  if (keyword == "v") {
    readPosition();
  } else if (keyword == "vt") {
    readNumbers(content_.texcoords, 2, "a texture coordinate");
  } else if (keyword == "vn") {
    readNumbers(content_.normals, 3, "the coordinate of a normal");
  } else if (keyword == "f") {
    readFace();
  } else if (keyword == "o") {
    setState(state_.object);
  } else if (keyword == "g") {
    setState(state_.groups);
  } else if (keyword == "s") {
    setState(state_.smoothing);
  } else if (keyword == "usemtl") {
    setState(state_.material);
  } else if (keyword == "mtllib") {
    source_->libraries.emplace_back(scanner_.rest());
  } else if (keyword == "l" || keyword == "p" || keyword == "curv" || keyword == "surf") {
    ++content_.skippedElements;
  }
}

ObjContent ObjReader::read() {
  for (bool isMore = true; isMore;) {
    while (scanner_.nextLine())
      if (!scanner_.atLineEnd()) readStatement(scanner_.word());
    const std::string_view text = blocks_.next();
    scanner_.goOn(text);
    isMore = !text.empty();
  }
  return std::move(content_);
}

struct Wedges {
  std::vector<Corner> corners;
  std::vector<Index> ofCorner;  // per corner of the content: its wedge
};

Wedges distinctCorners(const ObjContent& content) {
  WedgeChains<Corner> chains(content.positions.size());
  std::vector<Index> ofCorner;
  ofCorner.reserve(content.corners.size());
  for (std::size_t i = 0; i < content.corners.size(); ++i) {
    const Corner corner = content.corners[i];
    ofCorner.push_back(chains.wedgeAt(corner.position, corner));
  }

  // Renumbered in the order of positions; a position without a face gets a vertex, too.
  Wedges wedges;
  std::vector<Index> renumbered(chains.count());
  for (Index position = 0; position < content.positions.size(); ++position) {
    if (chains.first(position) == kNone) wedges.corners.push_back({position, kNone, kNone});
    for (Index wedge = chains.first(position); wedge != kNone; wedge = chains.next(wedge)) {
      renumbered[wedge] = static_cast<Index>(wedges.corners.size());
      wedges.corners.push_back(chains.value(wedge));
    }
  }
  for (Index& wedge : ofCorner) wedge = renumbered[wedge];
  wedges.ofCorner = std::move(ofCorner);
  return wedges;
}

// One of the file's lists as an attribute; `field` of a corner gives the number of its value.
struct ListedValues {
  const char* semantic;
  int itemSize;
  const std::vector<float>& values;
  CornerField field;
};

Attribute gathered(const ListedValues& list, const Wedges& wedges) {
  Attribute attribute{list.semantic, list.itemSize, {}};
  attribute.values.resize(list.itemSize * wedges.corners.size(), 0.0F);
  for (std::size_t i = 0; i < wedges.corners.size(); ++i) {
    const Index entry = wedges.corners[i].*list.field;
    if (entry != kNone)
      std::copy_n(list.values.begin() + std::ptrdiff_t{list.itemSize} * entry, list.itemSize,
                  attribute.values.begin() + list.itemSize * static_cast<std::ptrdiff_t>(i));
  }
  return attribute;
}

// Per position; none if the file has none.
std::vector<float> takeColors(ObjContent& content) {
  if (content.colors.empty()) return {};
  content.colors.resize(3 * content.positions.size(), kUncolored);
  return fractionsOf(std::move(content.colors));
}

// Vertices are positions: of the many numbers of a scan none is held twice.
TriangleMesh meshOfPositions(ObjContent content) {
  TriangleMesh mesh;
  mesh.indices = content.corners.takePositions();
  std::vector<float> colors = takeColors(content);
  if (!colors.empty()) mesh.attributes.push_back({"COLOR_0", 3, std::move(colors)});
  mesh.positions = std::move(content.positions);
  return mesh;
}

TriangleMesh meshOfWedges(ObjContent content, const std::vector<ObjGroup>& groups) {
  Wedges wedges = distinctCorners(content);
  TriangleMesh mesh;
  mesh.indices = std::move(wedges.ofCorner);
  mesh.positions.reserve(wedges.corners.size());
  for (const Corner& corner : wedges.corners)
    mesh.positions.push_back(content.positions[corner.position]);

  const auto anyGroup = [&](auto field) {
    return std::any_of(groups.begin(), groups.end(),
                       [&](const ObjGroup& group) { return group.*field; });
  };
  if (anyGroup(&ObjGroup::hasNormals))
    mesh.attributes.push_back(gathered({"NORMAL", 3, content.normals, &Corner::normal}, wedges));
  if (anyGroup(&ObjGroup::hasTexcoords))
    mesh.attributes.push_back(
        gathered({"TEXCOORD_0", 2, content.texcoords, &Corner::texcoord}, wedges));
  const std::vector<float> colors = takeColors(content);
  if (!colors.empty())
    mesh.attributes.push_back(gathered({"COLOR_0", 3, colors, &Corner::position}, wedges));
  return mesh;
}

TriangleMesh meshOf(ObjContent content, const std::vector<ObjGroup>& groups) {
  std::vector<Index> numbers = std::move(content.groups);
  const bool haveAllFour = content.haveAllFour;
  TriangleMesh mesh = content.corners.arePositions() ? meshOfPositions(std::move(content))
                                                     : meshOfWedges(std::move(content), groups);
  mesh.groups = std::move(numbers);
  mesh.isQuads = haveAllFour && arePairs(mesh);
  return mesh;
}

std::vector<GroupInfo> groupInfos(const TriangleMesh& mesh, const ObjSource& source) {
  std::map<std::string, Material> materials;
  for (const File& library : source.libraryFiles) materials.merge(materialsOf(library));
  std::vector<GroupInfo> infos;
  for (const ObjGroup& group : source.groups) {
    GroupInfo info{group.material, {}};
    const auto look = materials.find(group.material);
    if (look != materials.end()) info.look = look->second;
    for (const Attribute& attribute : mesh.attributes)
      if ((attribute.semantic == "NORMAL" && !group.hasNormals) ||
          (attribute.semantic == "TEXCOORD_0" && !group.hasTexcoords))
        info.lacks.push_back(attribute.semantic);
    infos.push_back(std::move(info));
  }
  return infos;
}

// Images are not passed on: the user moves them along with the result.
void warnOfImages(const File& library, std::vector<Warning>& warnings) {
  const std::vector<std::string> images = imagesOf(library);
  if (images.empty()) return;
  warnings.push_back(
      {"MATERIAL_IMAGES_NOT_READ",
       "The material library " + legible(library.name) +
           " names images, which are not passed on: " + legibleList(images) +
           ". Lay them beside an .obj; a .glb gets them painted with --textures bake.",
       images.size()});
}

// The operand of mtllib is one name, which may have blanks, or several.
std::vector<std::string> libraryNames(const std::string& operand, const Resources& given) {
  std::vector<std::string> words;
  TextScanner scanner(operand, "");
  for (scanner.nextLine(); !scanner.atLineEnd();) words.emplace_back(scanner.word());
  const bool areGiven = !given.named(operand) &&
                        std::any_of(words.begin(), words.end(),
                                    [&](const auto& word) { return given.named(word) != nullptr; });
  return areGiven ? words : std::vector<std::string>{operand};
}

void findLibraries(ObjSource& source, const std::vector<File>& resources,
                   std::vector<Warning>& warnings) {
  std::set<std::string> seen;
  const Resources given(resources);
  for (const std::string& operand : std::exchange(source.libraries, {})) {
    for (const std::string& library : libraryNames(operand, given)) {
      if (!seen.insert(library).second) continue;
      source.libraries.push_back(library);
      if (const File* const found = given.named(library)) {
        source.libraryFiles.push_back(whole(*found));
        warnOfImages(source.libraryFiles.back(), warnings);
        continue;
      }
      warnings.push_back({"RESOURCE_NOT_GIVEN",
                          "The material library " + legible(library) +
                              " was not given: the result refers to it, but it is not passed on.",
                          1});
    }
  }
}

}  // namespace

Model readObj(const File& file, const std::vector<File>& resources) {
  ObjReader reader(file);
  ObjContent content = reader.read();
  const std::shared_ptr<ObjSource> source = reader.source();

  Model model;
  model.conventions = Conventions::Classic;
  model.warnings = reader.warnings();
  findLibraries(*source, resources, model.warnings);
  if (content.skippedElements > 0)
    model.warnings.push_back({"NOT_TRIANGLES",
                              "Only faces are read; points, lines and curves are left out.",
                              content.skippedElements});
  if (content.corners.size() == 0)
    throw Error(ErrorCode::NoTriangles, legible(file.name) + " has no faces.",
                "Only surfaces can be remeshed, not points or lines.");
  const std::size_t polygons = content.polygons;
  TriangleMesh mesh = meshOf(std::move(content), source->groups);
  model.polygons = mesh.isQuads ? 0 : polygons;
  std::vector<GroupInfo> groups = groupInfos(mesh, *source);
  model.parts.push_back({file.name, std::move(mesh), {Transform::Identity()}, std::move(groups)});
  model.source = source;
  return model;
}

}  // namespace remesher::io
