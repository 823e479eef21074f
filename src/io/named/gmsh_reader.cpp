// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "io/named/gmsh.h"
#include "io/named/named_faces.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

// Gmsh's types of elements that are faces: triangles and quads with nodes at corners, then on
// sides, then inside.
constexpr std::size_t kFaceCorners[] = {0, 0, 3, 4, 0, 0, 0, 0, 0, 3, 4, 0, 0, 0, 0, 0, 4};

std::size_t cornersOfType(std::size_t type) {
  return type < std::size(kFaceCorners) ? kFaceCorners[type] : 0;
}

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& name) : scanner_(text, name), name_(name) {}
  Model read();

 private:
  void readVersion();
  void readNames();
  void readEntities();
  void readNodes();
  void readNodesOfVersion2();
  void readElements();
  void readElementsOfVersion2();
  void addFace(std::size_t type, Index set);
  std::size_t whole(std::string_view what);
  void skip(std::size_t words, std::string_view what);
  void skipSection(const std::string& name);
  Index setOf(std::size_t dimension, std::size_t entity);
  Index setNamed(const std::string& name);

  TextScanner scanner_;
  std::string name_;
  bool isVersion4_ = true;
  std::map<std::size_t, std::string> names_;          // of physical surfaces
  std::map<std::size_t, std::size_t> groupOfEntity_;  // physical, of surfaces
  std::map<std::size_t, Index> nodes_;                // by their numbers in the file
  std::map<std::string, Index> sets_;
  std::size_t others_ = 0;  // elements that are no faces
  NamedFaces surface_;
};

std::size_t GmshReader::whole(std::string_view what) {
  if (!scanner_.skipEmptyLines())
    scanner_.fail(ErrorCode::ParseError, "the file ends where " + std::string(what) + " should be.",
                  "Was it copied completely?");
  const auto [value, rest] = TextScanner::leadingInteger(scanner_.word());
  if (!rest.empty() || value < 0)
    scanner_.fail(ErrorCode::ParseError, std::string(what) + " is not a whole number from 0 on.");
  return static_cast<std::size_t>(value);
}

void GmshReader::skip(std::size_t words, std::string_view what) {
  for (std::size_t i = 0; i < words; ++i) {
    if (!scanner_.skipEmptyLines()) whole(what);
    scanner_.word();
  }
}

void GmshReader::skipSection(const std::string& name) {
  while (scanner_.skipEmptyLines()) {
    const bool isEnd = scanner_.word() == "$End" + name;
    scanner_.rest();
    if (isEnd) return;
  }
}

void GmshReader::readVersion() {
  const std::string version(scanner_.skipEmptyLines() ? scanner_.word() : "");
  const std::size_t kind = whole("the kind of file");
  if (kind != 0)
    scanner_.fail(ErrorCode::Unsupported, "the file is a binary Gmsh file.",
                  "Save it as text: Mesh.Binary = 0.");
  if (!version.starts_with("4.1") && !version.starts_with("2"))
    scanner_.fail(ErrorCode::Unsupported,
                  "the file is of version " + legible(version) + " of Gmsh's format.",
                  "Save it as version 4.1 or 2.2.");
  isVersion4_ = version[0] == '4';
}

void GmshReader::readNames() {
  const std::size_t count = whole("the number of physical names");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t dimension = whole("a dimension"), number = whole("the number of a group");
    const std::string_view rest = scanner_.rest();
    const std::size_t first = rest.find('"'), last = rest.rfind('"');
    if (dimension != 2 || first == last) continue;
    names_[number] = std::string(rest.substr(first + 1, last - first - 1));
  }
}

void GmshReader::readEntities() {
  std::array<std::size_t, 4> counts{};
  for (std::size_t& count : counts) count = whole("the number of entities");
  for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const std::size_t entity = whole("the number of an entity");
      skip(dimension == 0 ? 3 : 6, "the box of an entity");
      const std::size_t groups = whole("the number of physical groups");
      for (std::size_t k = 0; k < groups; ++k) {
        const std::size_t group = whole("a physical group");
        if (dimension == 2 && k == 0) groupOfEntity_[entity] = group;
      }
      if (dimension > 0) skip(whole("the number of bounding entities"), "a bounding entity");
    }
  }
}

Index GmshReader::setNamed(const std::string& name) {
  const auto [entry, isNew] = sets_.emplace(name, static_cast<Index>(surface_.names.size()));
  if (isNew) surface_.names.push_back(name);
  return entry->second;
}

Index GmshReader::setOf(std::size_t dimension, std::size_t entity) {
  if (dimension != 2) return 0;
  const auto group = groupOfEntity_.find(entity);
  if (group == groupOfEntity_.end())
    return setNamed(groupOfEntity_.empty() ? "" : "surface_" + std::to_string(entity));
  const auto name = names_.find(group->second);
  return setNamed(name == names_.end() ? "group_" + std::to_string(group->second) : name->second);
}

void GmshReader::readNodes() {
  const std::size_t blocks = whole("the number of blocks of nodes");
  skip(3, "the numbers of nodes");
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t dimension = whole("a dimension");
    skip(1, "an entity");
    const std::size_t isParametric = whole("whether nodes have parameters");
    const std::size_t count = whole("the number of nodes");
    if (count > scanner_.left())
      scanner_.fail(ErrorCode::ParseError, "it promises more nodes than bytes follow.",
                    "Was it copied completely?");
    for (std::size_t i = 0; i < count; ++i)
      nodes_[whole("the number of a node")] = static_cast<Index>(surface_.positions.size() + i);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 position;
      for (double& coordinate : position) {
        if (!scanner_.skipEmptyLines()) whole("a coordinate");
        coordinate = scanner_.number("the coordinate of a node");
      }
      surface_.positions.push_back(position);
      if (isParametric != 0) skip(dimension, "a parameter");
    }
  }
}

void GmshReader::readNodesOfVersion2() {
  const std::size_t count = whole("the number of nodes");
  for (std::size_t i = 0; i < count; ++i) {
    nodes_[whole("the number of a node")] = static_cast<Index>(surface_.positions.size());
    Vec3 position;
    for (double& coordinate : position) coordinate = scanner_.number("the coordinate of a node");
    surface_.positions.push_back(position);
  }
}

// The corners are the first words that follow; the other nodes are passed over.
void GmshReader::addFace(std::size_t type, Index set) {
  NamedFaces::Face face{{}, static_cast<Index>(cornersOfType(type)), set};
  for (Index corner = 0; corner < face.count; ++corner) {
    const std::size_t node = whole("a node of an element");
    const auto found = nodes_.find(node);
    if (found == nodes_.end())
      scanner_.fail(ErrorCode::IndexOutOfRange,
                    "an element names node " + std::to_string(node) + ", which is not there.",
                    "Repair the file: every element may name only nodes that are there.");
    face.corners[corner] = found->second;
  }
  surface_.faces.push_back(face);
}

void GmshReader::readElements() {
  const std::size_t blocks = whole("the number of blocks of elements");
  skip(3, "the numbers of elements");
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t dimension = whole("a dimension"), entity = whole("an entity");
    const std::size_t type = whole("a type of elements"), count = whole("the number of elements");
    const bool areFaces = cornersOfType(type) > 0;
    if (dimension > 1 && !areFaces) others_ += count;
    const Index set = areFaces ? setOf(dimension, entity) : 0;
    for (std::size_t i = 0; i < count; ++i) {
      whole("the number of an element");
      if (areFaces) addFace(type, set);
      scanner_.rest();
    }
  }
}

void GmshReader::readElementsOfVersion2() {
  constexpr std::size_t kPoint = 15, kLine = 1;
  const std::size_t count = whole("the number of elements");
  for (std::size_t i = 0; i < count; ++i) {
    whole("the number of an element");
    const std::size_t type = whole("a type of element"), tags = whole("the number of tags");
    const std::size_t group = tags > 0 ? whole("a tag") : 0;
    if (tags > 1) skip(tags - 1, "a tag");
    if (cornersOfType(type) == 0) {
      others_ += type != kPoint && type != kLine;
    } else {
      const auto name = names_.find(group);
      addFace(type, setNamed(name != names_.end() ? name->second
                             : group == 0         ? ""
                                                  : "group_" + std::to_string(group)));
    }
    scanner_.rest();
  }
}

Model GmshReader::read() {
  scanner_.nextLine();
  while (scanner_.skipEmptyLines()) {
    const std::string section(scanner_.word());
    if (section == "$MeshFormat") {
      readVersion();
    } else if (section == "$PhysicalNames") {
      readNames();
    } else if (section == "$Entities") {
      readEntities();
    } else if (section == "$Nodes") {
      isVersion4_ ? readNodes() : readNodesOfVersion2();
    } else if (section == "$Elements") {
      isVersion4_ ? readElements() : readElementsOfVersion2();
    } else if (section.starts_with("$") && !section.starts_with("$End")) {
      skipSection(section.substr(1));
    }
  }
  Model model = modelOf(std::move(surface_), name_);
  if (others_ > 0)
    model.warnings.push_back({"ELEMENTS_LEFT_OUT",
                              "Elements that are no triangles or quads, such as tetrahedra, are "
                              "left out: only surfaces are remeshed.",
                              others_});
  return model;
}

}  // namespace

Model readGmsh(const File& file, const std::vector<File>&) {
  return GmshReader(asText(file), file.name).read();
}

}  // namespace remesher::io
