// SPDX-License-Identifier: MIT
#include "io/text/off.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "geometry/polygon.h"
#include "io/model/bake.h"
#include "io/model/conventions.h"
#include "io/model/dropped.h"
#include "io/model/faces.h"
#include "io/text/text_scanner.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

// The vertex data that the first word promises: [ST][C][N][4][n]OFF, in any order.
struct OffHeader {
  bool hasTexcoords = false;
  bool hasColors = false;
  bool hasNormals = false;
  bool isHomogeneous = false;  // a fourth coordinate divides the others
  bool saysDimension = false;  // the number of coordinates is given
  bool isNormalFirst = true;   // by the letters; MeshLab's `NC` puts colours first
};

std::optional<OffHeader> parseKeyword(std::string_view word) {
  if (!word.ends_with("OFF")) return std::nullopt;
  word.remove_suffix(3);
  OffHeader header;
  const auto take = [&](std::string_view letters, bool& field) {
    if (!word.starts_with(letters) || field) return false;
    word.remove_prefix(letters.size());
    return field = true;
  };
  while (!word.empty()) {
    const bool isColor = take("C", header.hasColors);
    if (isColor && header.hasNormals) header.isNormalFirst = false;
    if (!isColor && !take("ST", header.hasTexcoords) && !take("N", header.hasNormals) &&
        !take("4", header.isHomogeneous) && !take("n", header.saysDimension))
      return std::nullopt;
  }
  return header;
}

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name) : scanner_(text, name) {}
  TriangleMesh read();
  std::size_t polygons() const { return polygons_; }
  std::size_t coloredFaces() const { return coloredFaces_; }
  std::vector<Warning> warnings() const { return scanner_.warnings(); }

 private:
  void requireMore(std::string_view what);
  double nextNumber(std::string_view what);
  std::size_t nextCount(std::string_view what);
  std::size_t readHeader();
  OffHeader readKeyword();
  void readDimension();
  void readVertex();
  Vec3 readPosition();
  void readColor();
  std::size_t wordsInLine() const;
  bool hasPlainColors(std::size_t vertexCount) const;
  bool areDirections(const std::vector<float>& rows) const;
  void settleOrder();
  void readFace();

  TextScanner scanner_;
  OffHeader header_;
  int dimension_ = 3;
  std::size_t faceCount_ = 0;
  std::size_t coloredFaces_ = 0;
  bool haveAllFour_ = true;   // corners, the faces so far
  std::size_t polygons_ = 0;  // of more corners than three
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

// The keyword may be missing: then the first word is the first count.
OffHeader OffReader::readKeyword() {
  if (!scanner_.nextLine() || !scanner_.skipEmptyLines())
    scanner_.fail(ErrorCode::ParseError, "there is nothing but comments.");
  const TextScanner before = scanner_;
  const std::string_view keyword = scanner_.word();
  if (TextScanner::leadingInteger(keyword).rest.empty()) {
    scanner_ = before;
    return {};
  }
  const std::optional<OffHeader> header = parseKeyword(keyword);
  if (!header)
    scanner_.fail(ErrorCode::ParseError,
                  "the file does not begin with OFF, nor with that behind ST, C, N, 4 or n.",
                  "Is it of another format?");
  TextScanner ahead = scanner_;
  if (ahead.word() == "BINARY")
    scanner_.fail(ErrorCode::Unsupported, "the file is binary OFF.", "Save it as text.");
  return *header;
}

void OffReader::readDimension() {
  if (!header_.saysDimension) return;
  const std::size_t dimension = nextCount("the number of dimensions");
  if (dimension > 3 || dimension == 0)
    scanner_.fail(ErrorCode::Unsupported,
                  "its vertices have " + std::to_string(dimension) + " dimensions.",
                  "Only surfaces in three dimensions, or two, can be remeshed.");
  dimension_ = static_cast<int>(dimension);
}

// Returns the number of vertices; the number of edges is skipped, because it is often wrong.
std::size_t OffReader::readHeader() {
  header_ = readKeyword();
  readDimension();
  const std::size_t vertexCount = nextCount("the number of vertices");
  faceCount_ = nextCount("the number of faces");
  if (!scanner_.atLineEnd()) scanner_.word();
  if (!header_.hasColors) header_.hasColors = hasPlainColors(vertexCount);
  return vertexCount;
}

std::size_t OffReader::wordsInLine() const {
  TextScanner ahead = scanner_;
  std::size_t words = 0;
  while (!ahead.word().empty()) ++words;
  return words;
}

// Some programs write colours without announcing them. Then each vertex has its own line with three
// or four extra numbers; otherwise several vertices may share a line.
bool OffReader::hasPlainColors(std::size_t vertexCount) const {
  TextScanner ahead = scanner_;
  if (vertexCount == 0 || !ahead.skipEmptyLines()) return false;
  std::size_t words = 0, lines = 1;
  while (!ahead.word().empty()) ++words;
  const std::size_t needed = std::size_t(dimension_) + header_.isHomogeneous +
                             3 * header_.hasNormals + 2 * header_.hasTexcoords;
  if (words != needed + 3 && words != needed + 4) return false;
  for (; lines < vertexCount + faceCount_ && ahead.skipEmptyLines(); ++lines)
    while (!ahead.word().empty()) {
    }
  return lines == vertexCount + faceCount_;
}

Vec3 OffReader::readPosition() {
  Vec3 position = Vec3::Zero();
  for (int axis = 0; axis < dimension_; ++axis)
    position[axis] = nextNumber("the coordinate of a vertex");
  if (!header_.isHomogeneous) return position;
  const double weight = nextNumber("the coordinate of a vertex");
  if (!(position / weight).allFinite())
    scanner_.fail(ErrorCode::NonFinite, "a vertex is infinitely far away.",
                  "Its last coordinate, by which the others are divided, must not be 0.");
  return position / weight;
}

// Reads red, green, blue and alpha: all numbers left in the line except texture coordinates.
void OffReader::readColor() {
  const std::size_t left = wordsInLine(), others = header_.hasTexcoords ? 2 : 0;
  const int count = left == 3 + others ? 3 : 4;
  for (int i = 0; i < count; ++i) {
    requireMore("the colour of a vertex");
    colors_.push_back(scanner_.attribute("the colour of a vertex"));
  }
  if (count == 3) colors_.push_back(kUncolored);
}

void OffReader::readVertex() {
  mesh_.positions.push_back(readPosition());
  const auto readInto = [&](std::vector<float>& list, int count, std::string_view what) {
    for (int i = 0; i < count; ++i) {
      requireMore(what);
      list.push_back(scanner_.attribute(what));
    }
  };
  if (header_.hasNormals) readInto(normals_, 3, "the coordinate of a normal");
  if (header_.hasColors) readColor();
  if (header_.hasTexcoords) readInto(texcoords_, 2, "a texture coordinate");
}

bool OffReader::areDirections(const std::vector<float>& rows) const {
  constexpr double kDigits = 0.01;  // tolerance for normals written with two digits
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
    const double length = Vec3(rows[i], rows[i + 1], rows[i + 2]).norm();
    if (std::abs(length - 1) > kDigits && length > 0) return false;
  }
  return true;
}

// For `NC`: decides whether the normal or the colour comes first, by which numbers are directions.
void OffReader::settleOrder() {
  if (header_.isNormalFirst || !header_.hasColors || areDirections(normals_)) return;
  for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
    const std::array<float, 3> first = {normals_[3 * v], normals_[3 * v + 1], normals_[3 * v + 2]};
    const std::array<float, 4> last = {colors_[4 * v], colors_[4 * v + 1], colors_[4 * v + 2],
                                       colors_[4 * v + 3]};
    const bool hasAlpha = last[3] != kUncolored;
    for (std::size_t k = 0; k < 3; ++k) {
      colors_[4 * v + k] = first[k];
      normals_[3 * v + k] = last[k + (hasAlpha ? 1 : 0)];
    }
    if (hasAlpha) colors_[4 * v + 3] = last[0];
  }
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
  polygons_ += corners > 3 ? 1 : 0;
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
  settleOrder();
  for (std::size_t i = 0; i < faceCount_; ++i) readFace();
  mesh_.isQuads = haveAllFour_ && arePairs(mesh_);
  if (header_.hasNormals) mesh_.attributes.push_back({"NORMAL", 3, std::move(normals_)});
  if (header_.hasTexcoords) mesh_.attributes.push_back({"TEXCOORD_0", 2, std::move(texcoords_)});
  if (header_.hasColors)
    mesh_.attributes.push_back({"COLOR_0", 4, fractionsOf(std::move(colors_))});
  return std::move(mesh_);
}

// The attributes in OFF's order.
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
  out.coordinate(mesh.positions[vertex].x());
  for (int axis = 1; axis < 3; ++axis) out.text(" ").coordinate(mesh.positions[vertex][axis]);
  for (const Attribute* attribute : attributes) {
    const int width = attribute->semantic == "COLOR_0" ? 4 : attribute->itemSize;
    for (int i = 0; i < width; ++i)
      out.text(" ").number(
          i < attribute->itemSize ? attribute->values[vertex * attribute->itemSize + i] : 1.0);
  }
  out.text("\n");
}

std::vector<std::uint8_t> offBytes(const TriangleMesh& mesh, Digits digits) {
  const std::vector<const Attribute*> attributes = writableAttributes(mesh);
  TextWriter out(digits);
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

bool beginsAsOff(std::string_view text) {
  TextScanner scanner(text, "");
  return scanner.nextLine() && scanner.skipEmptyLines() && parseKeyword(scanner.word());
}

Model readOff(const File& file, const std::vector<File>&) {
  OffReader reader(asText(file), file.name);
  Model model;
  model.conventions = Conventions::Classic;
  TriangleMesh mesh = reader.read();
  model.warnings = reader.warnings();
  model.polygons = mesh.isQuads ? 0 : reader.polygons();
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
  const TriangleMesh merged = mergeParts(bakeInstances(model));
  const Digits wanted = model.isExact ? Digits::OfDoubles : Digits::Fewest;
  std::vector<std::string> kept;
  for (const Attribute* attribute : writableAttributes(merged)) kept.push_back(attribute->semantic);
  return {{{outputName, offBytes(merged, digitsFor({&merged}, wanted))}},
          droppedAttributes(model, kept, "OFF")};
}

}  // namespace remesher::io
