// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/legible.h"
#include "geometry/polygon.h"
#include "io/ply/corner_texcoords.h"
#include "io/ply/ply.h"
#include "io/ply/ply_body.h"
#include "io/ply/ply_faces.h"
#include "io/ply/ply_vertices.h"

namespace remesher::io {
namespace {

// The content of the file, element by element.
struct PlyContent {
  PlyVertices vertices;
  std::vector<PlyFaces> faces;
  std::vector<std::string> otherElements;
};

void skipElement(PlyBody& body, const PlyElement& element) {
  if (element.properties.empty()) return;
  body.requireRows(element);
  for (Index row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) body.skip(property);
}

// A file that is too short for what its header says is refused as such, where it ends.
void requireRoomOf(const std::vector<PlyElement>& elements, const PlyBody& body, const File& file) {
  SaidSize size = {0, 0};
  for (const PlyElement& element : elements) {
    if (element.name == "face") size.triangles = element.count;
    if (element.name != "vertex") continue;
    size.vertices = element.count;
    size.numbers = std::max(0.0, static_cast<double>(element.properties.size()) - 3);
  }
  if (3 * size.vertices + size.triangles <= static_cast<double>(body.left()))
    requireRoomFor(size, file);
}

// Elements may come in any order.
PlyContent readContent(const File& file, const ParsedPlyHeader& parsed) {
  const std::vector<PlyElement>& elements = parsed.header.elements;
  const auto vertices = std::find_if(elements.begin(), elements.end(),
                                     [](const PlyElement& e) { return e.name == "vertex"; });
  const Index vertexCount = vertices == elements.end() ? 0 : vertices->count;
  PlyBody body(file, parsed);
  requireRoomOf(elements, body, file);
  PlyContent content;
  for (const PlyElement& element : elements) {
    if (element.count == 0) continue;
    if (element.name == "vertex") {
      content.vertices = readVertices(body, element);
    } else if (element.name == "face") {
      content.faces.push_back(readFaces(body, element, vertexCount));
    } else if (element.name == "tristrips") {
      content.faces.push_back(readStrips(body, element, vertexCount));
    } else {
      skipElement(body, element);
      content.otherElements.push_back(element.name);
    }
  }
  return content;
}

// The triangles of faces. Per triangle corner its number among the corners of all faces. Both lists
// are empty if all faces are triangles: each is then its own.
struct Triangulation {
  std::vector<Index> corners;
  std::vector<Index> faces;  // per triangle

  Index faceOf(Index triangle) const { return faces.empty() ? triangle : faces[triangle]; }
  Index cornerOf(Index corner) const { return corners.empty() ? corner : corners[corner]; }
};

Triangulation triangulated(const PlyFaces& faces, const std::vector<Vec3>& positions) {
  Triangulation result;
  std::vector<Vec3> points;
  Index first = 0;
  for (Index face = 0; face < faces.sizes.size(); ++face) {
    const Index size = faces.sizes[face];
    points.clear();
    for (Index i = 0; size > 3 && i < size; ++i)
      points.push_back(positions[faces.corners[first + i]]);
    if (size == 3) {
      for (Index i = 0; i < 3; ++i) result.corners.push_back(first + i);
      result.faces.push_back(face);
    } else {
      for (const auto& triangle : triangulate(points)) {
        for (const Index i : triangle) result.corners.push_back(first + i);
        result.faces.push_back(face);
      }
    }
    first += size;
  }
  return result;
}

// Triangles with the same texture form a group; PlySource::textureNumbers holds each group's
// texture.
std::vector<Index> groupsByTexture(const PlyFaces& faces, const Triangulation& triangulation,
                                   std::vector<double>& textureNumbers) {
  std::map<double, Index> groupOf;
  for (const double number : faces.textureNumbers) groupOf.emplace(number, 0);
  Index next = 0;
  for (auto& [number, group] : groupOf) {
    group = next++;
    textureNumbers.push_back(number);
  }
  const std::size_t triangles =
      triangulation.faces.empty() ? faces.textureNumbers.size() : triangulation.faces.size();
  std::vector<Index> groups;
  for (Index t = 0; t < triangles; ++t)
    groups.push_back(groupOf.at(faces.textureNumbers[triangulation.faceOf(t)]));
  return groups;
}

// Adds the corners of the faces' triangles. Those of triangles alone are moved, not copied: of the
// largest files they are most of what is in memory.
void addTriangles(TriangleMesh& mesh, std::vector<Index>& corners, const Triangulation& cut) {
  if (mesh.indices.empty() && cut.corners.empty()) {
    mesh.indices = std::move(corners);
    return;
  }
  const std::size_t count = cut.corners.empty() ? corners.size() : cut.corners.size();
  mesh.indices.reserve(mesh.indices.size() + count);
  for (Index i = 0; i < count; ++i) mesh.indices.push_back(corners[cut.cornerOf(i)]);
}

TriangleMesh meshOf(PlyContent& content, PlySource& source) {
  TriangleMesh mesh = std::move(content.vertices.mesh);
  const bool isOfOneKind = content.faces.size() == 1;
  for (PlyFaces& faces : content.faces) {
    const Triangulation triangulation = triangulated(faces, mesh.positions);
    addTriangles(mesh, faces.corners, triangulation);
    mesh.isQuads =
        isOfOneKind && !faces.sizes.empty() &&
        std::all_of(faces.sizes.begin(), faces.sizes.end(), [](Index size) { return size == 4; }) &&
        arePairs(mesh);
    if (isOfOneKind && !faces.textureNumbers.empty())
      mesh.groups = groupsByTexture(faces, triangulation, source.textureNumbers);
    if (!isOfOneKind || faces.cornerTexcoords.empty()) continue;
    source.hasCornerTexcoords = true;
    std::vector<float> perCorner;
    perCorner.reserve(2 * mesh.indices.size());
    for (Index i = 0; i < mesh.indices.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        perCorner.push_back(faces.cornerTexcoords[2 * std::size_t{triangulation.cornerOf(i)} + k]);
    std::erase_if(mesh.attributes,
                  [](const Attribute& attribute) { return attribute.semantic == "TEXCOORD_0"; });
    mesh = splitByTexcoord(mesh, perCorner);
  }
  return mesh;
}

std::vector<Warning> warningsOn(const PlyContent& content) {
  std::vector<Warning> warnings;
  const auto warn = [&](const char* code, const std::string& message, std::size_t count) {
    if (count > 0) warnings.push_back({code, message, count});
  };
  std::vector<std::string> lost;
  for (const PlyField& field : content.vertices.fields)
    if (field.semantic.empty()) lost.push_back(field.property.name);
  warn("ATTRIBUTE_NOT_CARRIED",
       "Properties of vertices that are lists are not carried: " + legibleList(lost) + ".",
       lost.size());
  for (const PlyFaces& faces : content.faces) {
    warn("ATTRIBUTE_NOT_CARRIED",
         "Values of faces are not carried: " + legibleList(faces.ignored) + ".",
         faces.ignored.size());
    warn("NOT_TRIANGLES", "Faces of fewer than three corners are left out.", faces.degenerate);
  }
  warn("NOT_TRIANGLES",
       "Only faces are read; left out: " + legibleList(content.otherElements) + ".",
       content.otherElements.size());
  std::size_t notFinite = content.vertices.notFinite;
  for (const PlyFaces& faces : content.faces) notFinite += faces.notFinite;
  warn("NON_FINITE_ATTRIBUTE", "Values of attributes that are not finite are read as 0.",
       notFinite);
  return warnings;
}

std::size_t polygonsOf(const PlyFaces& faces) {
  return std::size_t(
      std::count_if(faces.sizes.begin(), faces.sizes.end(), [](Index size) { return size > 3; }));
}

// MeshLab names the images in remarks, ordered by texture number.
std::vector<GroupInfo> groupInfos(const PlySource& source) {
  constexpr std::string_view kImage = "comment TextureFile ";
  std::vector<std::string> images;
  for (const std::string& remark : source.header.remarks)
    if (remark.starts_with(kImage)) images.push_back(remark.substr(kImage.size()));
  std::vector<GroupInfo> infos;
  for (const double number : source.textureNumbers) {
    const bool isNamed = number >= 0 && number < static_cast<double>(images.size());
    infos.push_back({isNamed ? images[static_cast<std::size_t>(number)] : "", {}});
  }
  return infos;
}

}  // namespace

Model readPly(const File& file, const std::vector<File>&) {
  const File begin = file.source ? beginOf(file, kHeaderLooked) : File{};
  const ParsedPlyHeader parsed = parsePlyHeader(asText(file.source ? begin : file), file.name);
  PlyContent content = readContent(file, parsed);
  Model model;
  model.conventions = Conventions::Classic;
  model.warnings = warningsOn(content);
  const auto source = std::make_shared<PlySource>();
  source->fields = content.vertices.fields;
  source->header = parsed.header;
  TriangleMesh mesh = meshOf(content, *source);
  if (mesh.triangleCount() == 0)
    throw Error(ErrorCode::NoTriangles, legible(file.name) + " has no faces.",
                "Only surfaces can be remeshed, not points.");
  for (const PlyFaces& faces : content.faces)
    model.polygons += mesh.isQuads ? 0 : polygonsOf(faces);
  source->original = file;
  source->vertexCount = mesh.positions.size();
  source->triangleCount = mesh.triangleCount();
  model.parts.push_back({file.name, std::move(mesh), {Transform::Identity()}, groupInfos(*source)});
  model.source = source;
  return model;
}

}  // namespace remesher::io
