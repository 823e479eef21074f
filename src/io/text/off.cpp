// SPDX-License-Identifier: MIT
#include "io/text/off.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "io/model/bake.h"
#include "io/model/conventions.h"
#include "io/model/dropped.h"
#include "io/model/faces.h"
#include "io/model/polygon.h"
#include "io/text/text_scanner.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

// What the first word promises of each vertex: [ST][C][N]OFF.
struct OffHeader {
  bool hasTexcoords = false;
  bool hasColors = false;
  bool hasNormals = false;
};

std::optional<OffHeader> parseKeyword(std::string_view word) {
  OffHeader header;
  const auto take = [&](std::string_view prefix) {
    const bool found = word.substr(0, prefix.size()) == prefix;
    if (found) word.remove_prefix(prefix.size());
    return found;
  };
  header.hasTexcoords = take("ST");
  header.hasColors = take("C");
  header.hasNormals = take("N");
  if (word != "OFF") return std::nullopt;
  return header;
}

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name) : scanner_(text, name) {}
  TriangleMesh read();
  std::size_t coloredFaces() const { return coloredFaces_; }

 private:
  void requireMore(std::string_view what);
  double nextNumber(std::string_view what);
  std::size_t nextCount(std::string_view what);
  std::size_t readHeader();
  void readVertex();
  void readFace();

  TextScanner scanner_;
  OffHeader header_;
  std::size_t faceCount_ = 0;
  std::size_t coloredFaces_ = 0;
  bool haveAllFour_ = true;  // corners, the faces so far
  std::vector<float> normals_;
  std::vector<float> colors_;  // 4 each
  std::vector<float> texcoords_;
  TriangleMesh mesh_;
  std::vector<Index> polygon_;
  std::vector<Vec3> polygonPoints_;
};

void OffReader::requireMore(std::string_view what) {
  if (!scanner_.skipEmptyLines())
    scanner_.fail(ErrorCode::ParseError, "the file ends where " + std::string(what) + " should be.",
                  "Its first line promises more than follows.");
}

double OffReader::nextNumber(std::string_view what) {
  requireMore(what);
  return scanner_.number(what);
}

std::size_t OffReader::nextCount(std::string_view what) {
  constexpr double kLargest = 4294967294.0;
  const double value = nextNumber(what);
  if (!(value >= 0 && value <= kLargest) || value != static_cast<double>(static_cast<Index>(value)))
    scanner_.fail(ErrorCode::ParseError, std::string(what) + " is not a whole number from 0 on.");
  return static_cast<std::size_t>(value);
}

// Returns the number of vertices; the number of edges, which nobody keeps right, is passed over.
std::size_t OffReader::readHeader() {
  if (!scanner_.nextLine() || !scanner_.skipEmptyLines())
    scanner_.fail(ErrorCode::ParseError, "there is nothing but comments.");
  const std::string_view keyword = scanner_.word();
  const std::optional<OffHeader> header = parseKeyword(keyword);
  if (!header)
    scanner_.fail(ErrorCode::ParseError, "the file does not begin with OFF, COFF, NOFF or STOFF.",
                  "Other kinds of OFF (binary, 4 or n dimensions) are not read.");
  header_ = *header;
  const std::size_t vertexCount = nextCount("the number of vertices");
  faceCount_ = nextCount("the number of faces");
  if (!scanner_.atLineEnd()) scanner_.word();
  return vertexCount;
}

void OffReader::readVertex() {
  Vec3 position;
  for (double& coordinate : position) coordinate = nextNumber("the coordinate of a vertex");
  mesh_.positions.push_back(position);
  const auto readInto = [&](std::vector<float>& list, int count, std::string_view what) {
    for (int i = 0; i < count; ++i) {
      requireMore(what);
      list.push_back(scanner_.singleNumber(what));
    }
  };
  if (header_.hasNormals) readInto(normals_, 3, "the coordinate of a normal");
  if (header_.hasColors) readInto(colors_, 4, "the colour of a vertex");
  if (header_.hasTexcoords) readInto(texcoords_, 2, "a texture coordinate");
}

void OffReader::readFace() {
  const std::size_t corners = nextCount("the number of corners of a face");
  polygon_.clear();
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t vertex = nextCount("a corner of a face");
    if (vertex >= mesh_.positions.size())
      scanner_.fail(ErrorCode::IndexOutOfRange,
                    "a face names vertex " + std::to_string(vertex) + ", but there are " +
                        std::to_string(mesh_.positions.size()) + ", counted from 0.",
                    "Repair the file: every face may name only vertices that are there.");
    polygon_.push_back(static_cast<Index>(vertex));
  }
  haveAllFour_ &= corners == 4;
  if (!scanner_.atLineEnd()) ++coloredFaces_;
  while (!scanner_.atLineEnd()) scanner_.word();
  if (corners == 3) {
    mesh_.indices.insert(mesh_.indices.end(), polygon_.begin(), polygon_.end());
    return;
  }
  polygonPoints_.clear();
  for (const Index vertex : polygon_) polygonPoints_.push_back(mesh_.positions[vertex]);
  for (const auto& triangle : triangulate(polygonPoints_))
    for (const Index i : triangle) mesh_.indices.push_back(polygon_[i]);
}

TriangleMesh OffReader::read() {
  const std::size_t vertexCount = readHeader();
  for (std::size_t i = 0; i < vertexCount; ++i) readVertex();
  for (std::size_t i = 0; i < faceCount_; ++i) readFace();
  mesh_.isQuads = haveAllFour_ && arePairs(mesh_);
  if (header_.hasNormals) mesh_.attributes.push_back({"NORMAL", 3, std::move(normals_)});
  if (header_.hasTexcoords) mesh_.attributes.push_back({"TEXCOORD_0", 2, std::move(texcoords_)});
  if (header_.hasColors)
    mesh_.attributes.push_back({"COLOR_0", 4, fractionsOf(std::move(colors_))});
  return std::move(mesh_);
}

// In the order in which OFF lists them.
std::vector<const Attribute*> writableAttributes(const TriangleMesh& mesh) {
  std::vector<const Attribute*> found;
  for (const std::string_view semantic : {"NORMAL", "COLOR_0", "TEXCOORD_0"})
    for (const Attribute& attribute : mesh.attributes)
      if (attribute.semantic == semantic) found.push_back(&attribute);
  return found;
}

std::string keywordFor(const std::vector<const Attribute*>& attributes) {
  const auto has = [&](std::string_view semantic) {
    return std::any_of(attributes.begin(), attributes.end(),
                       [&](const Attribute* attribute) { return attribute->semantic == semantic; });
  };
  return std::string(has("TEXCOORD_0") ? "ST" : "") + (has("COLOR_0") ? "C" : "") +
         (has("NORMAL") ? "N" : "") + "OFF";
}

void writeVertex(TextWriter& out, const TriangleMesh& mesh, std::size_t vertex,
                 const std::vector<const Attribute*>& attributes) {
  out.number(mesh.positions[vertex].x());
  for (int axis = 1; axis < 3; ++axis) out.text(" ").number(mesh.positions[vertex][axis]);
  for (const Attribute* attribute : attributes) {
    const int width = attribute->semantic == "COLOR_0" ? 4 : attribute->itemSize;
    for (int i = 0; i < width; ++i)
      out.text(" ").number(
          i < attribute->itemSize ? attribute->values[vertex * attribute->itemSize + i] : 1.0);
  }
  out.text("\n");
}

std::vector<std::uint8_t> offBytes(const TriangleMesh& mesh) {
  const std::vector<const Attribute*> attributes = writableAttributes(mesh);
  TextWriter out;
  out.text(keywordFor(attributes)).text("\n");
  const Faces faces(mesh);
  out.integer(mesh.positions.size()).text(" ").integer(faces.count()).text(" 0\n");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) writeVertex(out, mesh, i, attributes);
  for (std::size_t face = 0; face < faces.count(); ++face) {
    out.integer(faces.corners());
    for (std::size_t corner = 0; corner < faces.corners(); ++corner)
      out.text(" ").integer(mesh.indices[faces.place(face, corner)]);
    out.text("\n");
  }
  return out.bytes();
}

}  // namespace

Model readOff(const File& file, const std::vector<File>&) {
  OffReader reader({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()},
                   file.name);
  Model model;
  model.conventions = Conventions::Classic;
  TriangleMesh mesh = reader.read();
  if (mesh.triangleCount() == 0)
    throw Error(ErrorCode::NoTriangles, legible(file.name) + " has no faces.",
                "Only surfaces can be remeshed, not points.");
  if (reader.coloredFaces() > 0)
    model.warnings.push_back(
        {"ATTRIBUTE_NOT_CARRIED", "The colours of faces are not carried.", reader.coloredFaces()});
  model.parts.push_back({file.name, std::move(mesh), {Transform::Identity()}});
  return model;
}

WrittenFiles writeOff(const Model& model, const std::string& outputName) {
  return {{{outputName, offBytes(mergeParts(bakeInstances(model)))}},
          droppedAttributes(model, {"NORMAL", "COLOR_0", "TEXCOORD_0"}, "OFF")};
}

}  // namespace remesher::io
