// SPDX-License-Identifier: MIT
// Each list is written without repetitions: vertices at one position share a v, even if their
// texture coordinates or normals differ, so that the surface is as closed in the file as in the
// mesh.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/model/bake.h"
#include "io/model/companions.h"
#include "io/model/dropped.h"
#include "io/model/faces.h"
#include "io/text/obj.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

// A part, and the state that is written before its faces of group g.
struct ObjPart {
  const TriangleMesh* mesh;
  std::vector<ObjGroup> groups;
};

// Per vertex the number, from one, of its value in a list of the file.
using Numbers = std::vector<std::size_t>;

// A list without repetitions: the vertices whose values it holds, and per vertex its value's
// number.
struct DistinctValues {
  std::vector<Index> representatives;
  Numbers numbers;
};

template <class Value>
DistinctValues findDistinct(const std::vector<Value>& values, std::size_t firstNumber) {
  std::vector<Index> order(values.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  std::vector<Index> leader(values.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    leader[order[i]] =
        i > 0 && values[order[i - 1]] == values[order[i]] ? leader[order[i - 1]] : order[i];

  DistinctValues distinct;
  distinct.numbers.resize(values.size());
  for (Index i = 0; i < leader.size(); ++i) {
    if (leader[i] == i) {
      distinct.numbers[i] = firstNumber + distinct.representatives.size();
      distinct.representatives.push_back(i);
    } else {
      distinct.numbers[i] = distinct.numbers[leader[i]];
    }
  }
  return distinct;
}

// Names from other formats may contain line ends, behind which the rest would be a statement.
std::string inOneLine(std::string name) {
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) < ' ') letter = '_';
  return name;
}

class ObjWriter {
 public:
  explicit ObjWriter(Digits digits) : out_(digits) {}
  void writeLibrary(const std::string& library);
  void writePart(const ObjPart& part);
  std::vector<std::uint8_t> bytes() const { return out_.bytes(); }

 private:
  Numbers writePositions(const TriangleMesh& mesh);
  Numbers writeTexcoords(const TriangleMesh& mesh);
  Numbers writeNormals(const TriangleMesh& mesh);
  void writeState(const ObjGroup& group);
  void writeFaces(const ObjPart& part);

  TextWriter out_;
  std::size_t positionCount_ = 0;
  std::size_t texcoordCount_ = 0;
  std::size_t normalCount_ = 0;
  Numbers positions_;
  Numbers texcoords_;
  Numbers normals_;
  std::optional<ObjGroup> state_;
};

void ObjWriter::writeLibrary(const std::string& library) {
  out_.text("mtllib ").text(library).text("\n");
}

// A position's colour is the colour of the first vertex there: OBJ has no colour seams.
Numbers ObjWriter::writePositions(const TriangleMesh& mesh) {
  std::vector<std::array<double, 3>> values(mesh.positions.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vec3& position = mesh.positions[i];
    values[i] = {position.x(), position.y(), position.z()};
  }
  const Attribute* const color = findAttribute(mesh, "COLOR_0");
  const auto [written, numbers] = findDistinct(values, positionCount_ + 1);
  for (const Index i : written) {
    out_.text("v").coordinates(mesh.positions[i]);
    for (int channel = 0; color != nullptr && channel < 3; ++channel)
      out_.text(" ").number(color->values[std::size_t{i} * color->itemSize + channel]);
    out_.text("\n");
  }
  positionCount_ += written.size();
  return numbers;
}

Numbers ObjWriter::writeTexcoords(const TriangleMesh& mesh) {
  const Attribute* const texcoord = findAttribute(mesh, "TEXCOORD_0");
  if (texcoord == nullptr) return {};
  std::vector<std::array<float, 2>> values(mesh.positions.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = {texcoord->values[2 * i], texcoord->values[2 * i + 1]};
  const auto [written, numbers] = findDistinct(values, texcoordCount_ + 1);
  for (const Index i : written)
    out_.text("vt ").number(values[i][0]).text(" ").number(values[i][1]).text("\n");
  texcoordCount_ += written.size();
  return numbers;
}

Numbers ObjWriter::writeNormals(const TriangleMesh& mesh) {
  const Attribute* const normal = findAttribute(mesh, "NORMAL");
  if (normal == nullptr) return {};
  std::vector<std::array<float, 3>> values(mesh.positions.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    std::copy_n(normal->values.begin() + 3 * static_cast<std::ptrdiff_t>(i), 3, values[i].begin());
  const auto [written, numbers] = findDistinct(values, normalCount_ + 1);
  for (const Index i : written) {
    out_.text("vn");
    for (const float coordinate : values[i]) out_.text(" ").number(coordinate);
    out_.text("\n");
  }
  normalCount_ += written.size();
  return numbers;
}

// Writes the differences from the state before.
void ObjWriter::writeState(const ObjGroup& group) {
  const ObjGroup before = state_.value_or(ObjGroup{});
  const auto say = [&](std::string_view keyword, const std::string& now, const std::string& then) {
    if (now != then) out_.text(keyword).text(" ").text(inOneLine(now)).text("\n");
  };
  say("o", group.object, before.object);
  say("g", group.groups, before.groups);
  say("usemtl", group.material, before.material);
  say("s", group.smoothing.empty() ? "off" : group.smoothing,
      before.smoothing.empty() ? "off" : before.smoothing);
  state_ = group;
}

void ObjWriter::writeFaces(const ObjPart& part) {
  const TriangleMesh& mesh = *part.mesh;
  const Faces faces(mesh);
  std::vector<Index> order(faces.count());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  const auto groupOf = [&](Index face) {
    return mesh.groups.empty() ? Index{0} : mesh.groups[faces.triangle(face)];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return groupOf(a) < groupOf(b); });
  for (const Index face : order) {
    ObjGroup group = part.groups[groupOf(face)];
    group.hasTexcoords = group.hasTexcoords && !texcoords_.empty();
    group.hasNormals = group.hasNormals && !normals_.empty();
    if (!state_ || *state_ != group) writeState(group);
    out_.text("f");
    for (std::size_t corner = 0; corner < faces.corners(); ++corner) {
      const Index vertex = mesh.indices[faces.place(face, corner)];
      out_.text(" ").integer(positions_[vertex]);
      if (group.hasTexcoords || group.hasNormals) out_.text("/");
      if (group.hasTexcoords) out_.integer(texcoords_[vertex]);
      if (group.hasNormals) out_.text("/").integer(normals_[vertex]);
    }
    out_.text("\n");
  }
}

void ObjWriter::writePart(const ObjPart& part) {
  positions_ = writePositions(*part.mesh);
  texcoords_ = writeTexcoords(*part.mesh);
  normals_ = writeNormals(*part.mesh);
  writeFaces(part);
}

std::vector<ObjGroup> groupsFor(const Part& part, const ObjSource* source) {
  if (source != nullptr) return source->groups;
  std::vector<ObjGroup> groups(groupCount(part.mesh));
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const GroupInfo info = i < part.groups.size() ? part.groups[i] : GroupInfo{};
    const auto has = [&](std::string_view semantic) {
      return findAttribute(part.mesh, semantic) != nullptr &&
             std::find(info.lacks.begin(), info.lacks.end(), semantic) == info.lacks.end();
    };
    groups[i].object = part.name;
    if (groups.size() > 1) groups[i].groups = "primitive_" + std::to_string(i);
    groups[i].material = info.material;
    groups[i].hasTexcoords = has("TEXCOORD_0");
    groups[i].hasNormals = has("NORMAL");
  }
  return groups;
}

// The given libraries, under the names that the result uses. Libraries not given keep their names.
std::vector<File> passLibrariesOn(const ObjSource& source, const std::string& outputName,
                                  ObjWriter& writer) {
  CompanionNames names(outputName);
  std::vector<File> files;
  std::map<std::string, std::string> written;
  for (const File& file : source.libraryFiles) {
    files.push_back({names.nameForFile(file.name), file.bytes});
    written[file.name] = files.back().name;
  }
  for (const std::string& library : source.libraries) {
    const auto given = written.find(library);
    writer.writeLibrary(given == written.end() ? library : given->second);
  }
  return files;
}

}  // namespace

WrittenFiles writeObj(const Model& model, const std::string& outputName) {
  const auto* const source = dynamic_cast<const ObjSource*>(model.source.get());
  const std::vector<Part> bodies = bakeInstances(model);
  std::vector<const TriangleMesh*> meshes;
  for (const Part& body : bodies) meshes.push_back(&body.mesh);
  ObjWriter writer(digitsFor(meshes, model.isExact ? Digits::OfDoubles : Digits::Fewest));
  std::vector<File> libraries;
  if (source != nullptr) libraries = passLibrariesOn(*source, outputName, writer);
  for (const Part& part : bodies) {
    std::vector<ObjGroup> groups = groupsFor(part, source);
    if (model.hasNewTexcoords)
      for (ObjGroup& group : groups) group.hasTexcoords = true;
    writer.writePart({&part.mesh, std::move(groups)});
  }
  WrittenFiles written;
  written.files.push_back({outputName, writer.bytes()});
  written.files.insert(written.files.end(), libraries.begin(), libraries.end());
  if (source != nullptr) return written;
  written.warnings =
      droppedAttributes(model, {"NORMAL", "COLOR_0", "TEXCOORD_0", kMaterial}, "OBJ");
  const std::vector<Warning> names = namedMaterials(model);
  written.warnings.insert(written.warnings.end(), names.begin(), names.end());
  return written;
}

}  // namespace remesher::io
