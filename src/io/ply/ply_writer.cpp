// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/model/bake.h"
#include "io/model/byte_reader.h"
#include "io/model/dropped.h"
#include "io/model/faces.h"
#include "io/model/same_mesh.h"
#include "io/ply/corner_texcoords.h"
#include "io/ply/ply.h"
#include "io/ply/ply_sink.h"

namespace remesher::io {
namespace {

// Whether the mesh equals the one in the file. The file is read again: no copy of its mesh is kept.
bool isUntouched(const PlySource& source, const Model& model) {
  if (model.parts.size() != 1) return false;
  const TriangleMesh& mesh = model.parts[0].mesh;
  if (mesh.positions.size() != source.vertexCount || mesh.triangleCount() != source.triangleCount)
    return false;
  const Model read = readPly(source.original, {});
  return !isMended(read.warnings) && haveSameContent(mesh, read.parts[0].mesh);
}

// How the file is written: encoding, remarks, and the values in each row.
struct Layout {
  PlyEncoding encoding = PlyEncoding::LittleEndian;
  std::vector<std::string> remarks = {"comment written by remesher"};
  std::vector<PlyField> fields;
  PlyProperty corners = {"vertex_indices", PlyType::Int32, PlyType::UInt8};
  bool hasCornerTexcoords = false;
  std::vector<double> textureNumbers;
};

// Whether a type holds a coordinate: it is in the type's range, and whole if that has to be.
bool canHold(PlyType type, double x) {
  if (type == PlyType::Float64) return true;
  if (type == PlyType::Float32) return std::abs(x) <= double{std::numeric_limits<float>::max()};
  return x == std::round(x) && x >= smallestOf(type) && x <= largestOf(type);
}

// Positions get a wider type if theirs does not hold the mesh's coordinates: floats if these are
// single, else doubles.
void widenPositions(std::vector<PlyField>& fields, const TriangleMesh& mesh) {
  for (PlyField& field : fields) {
    const auto holds = [&](PlyType type) {
      return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                         [&](const Vec3& p) { return canHold(type, p[field.component]); });
    };
    if (field.semantic != "POSITION" || holds(field.property.type)) continue;
    const bool isEnough = mesh.isSingle && holds(PlyType::Float32);
    field.property.type = isEnough ? PlyType::Float32 : PlyType::Float64;
  }
}

// The layout of the file that the mesh comes from.
Layout layoutLike(const PlySource& source, const TriangleMesh& mesh) {
  Layout layout;
  layout.encoding = source.header.encoding;
  layout.remarks = source.header.remarks;
  layout.hasCornerTexcoords = source.hasCornerTexcoords;
  layout.textureNumbers = source.textureNumbers;
  const auto isWritten = [&](const PlyField& field) {
    const bool isElsewhere = source.hasCornerTexcoords && field.semantic == "TEXCOORD_0";
    return field.semantic == "POSITION" ||
           (!isElsewhere && findAttribute(mesh, field.semantic) != nullptr);
  };
  std::copy_if(source.fields.begin(), source.fields.end(), std::back_inserter(layout.fields),
               isWritten);
  widenPositions(layout.fields, mesh);
  for (const PlyElement& element : source.header.elements) {
    if (element.name != "face") continue;
    for (const PlyProperty& property : element.properties) {
      const bool isList = property.name == "vertex_indices" || property.name == "vertex_index";
      const bool holdsAll = !isFloating(property.type) &&
                            static_cast<double>(mesh.positions.size()) <= largestOf(property.type);
      if (isList && property.countType) layout.corners = property;
      if (isList && !holdsAll) layout.corners.type = PlyType::Int32;
    }
  }
  return layout;
}

Layout layoutFor(const TriangleMesh& mesh) {
  Layout layout;
  layout.fields = fieldsFor(mesh);
  return layout;
}

PlyHeader headerOf(const Layout& layout, const TriangleMesh& mesh) {
  PlyElement vertex{"vertex", static_cast<Index>(mesh.positions.size()), {}};
  for (const PlyField& field : layout.fields) vertex.properties.push_back(field.property);
  PlyElement face{"face", static_cast<Index>(Faces(mesh).count()), {layout.corners}};
  if (layout.hasCornerTexcoords)
    face.properties.push_back({"texcoord", PlyType::Float32, PlyType::UInt8});
  if (!layout.textureNumbers.empty()) face.properties.push_back({"texnumber", PlyType::Int32});
  return {layout.encoding, layout.remarks, {std::move(vertex), std::move(face)}};
}

void putVertices(PlySink& sink, const Layout& layout, const TriangleMesh& mesh) {
  std::vector<const Attribute*> attributes;
  for (const PlyField& field : layout.fields)
    attributes.push_back(findAttribute(mesh, field.semantic));
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      const PlyField& field = layout.fields[i];
      const Attribute* const attribute = attributes[i];
      const double value = attribute == nullptr
                               ? mesh.positions[vertex][field.component]
                               : attribute->values[vertex * attribute->itemSize + field.component];
      sink.put(field.property.type, value * field.one);
    }
    sink.endRow();
  }
}

void putFaces(PlySink& sink, const Layout& layout, const WeldedMesh& welded) {
  const TriangleMesh& mesh = welded.mesh;
  const Faces faces(mesh);
  for (std::size_t face = 0; face < faces.count(); ++face) {
    sink.put(*layout.corners.countType, double(faces.corners()));
    for (std::size_t i = 0; i < faces.corners(); ++i)
      sink.put(layout.corners.type, mesh.indices[faces.place(face, i)]);
    if (layout.hasCornerTexcoords) {
      sink.put(PlyType::UInt8, double(2 * faces.corners()));
      for (std::size_t i = 0; i < 2 * faces.corners(); ++i)
        sink.put(PlyType::Float32, welded.perCorner[2 * faces.place(face, i / 2) + i % 2]);
    }
    if (!layout.textureNumbers.empty())
      sink.put(PlyType::Int32, layout.textureNumbers[mesh.groups[faces.triangle(face)]]);
    sink.endRow();
  }
}

std::vector<std::string> semanticsOf(const Layout& layout) {
  std::vector<std::string> semantics;
  for (const PlyField& field : layout.fields) semantics.push_back(field.semantic);
  if (layout.hasCornerTexcoords) semantics.emplace_back("TEXCOORD_0");
  if (!layout.textureNumbers.empty()) semantics.emplace_back(kMaterial);
  return semantics;
}

bool isSingleIn(const std::vector<PlyField>& fields) {
  return std::none_of(fields.begin(), fields.end(), [](const PlyField& field) {
    return field.semantic == "POSITION" && field.property.type == PlyType::Float64;
  });
}

}  // namespace

bool becomesSingle(const Model& model) {
  if (model.parts.empty() || dynamic_cast<const PlySource*>(model.source.get()) != nullptr)
    return false;
  return isSingleIn(fieldsFor(mergeParts(model.parts)));
}

WrittenFiles writePly(const Model& model, const std::string& outputName) {
  const auto* const source = dynamic_cast<const PlySource*>(model.source.get());
  if (source != nullptr && isUntouched(*source, model))
    return {{{outputName, whole(source->original).bytes}}, {}, {}, true};
  std::vector<Part> parts = bakeInstances(model);
  const TriangleMesh mesh = source == nullptr ? mergeParts(parts) : std::move(parts[0].mesh);
  const bool isLikeSource = source != nullptr && !model.hasNewTexcoords;
  Layout layout = isLikeSource ? layoutLike(*source, mesh) : layoutFor(mesh);
  if (source != nullptr) layout.encoding = source->header.encoding;
  const WeldedMesh written =
      layout.hasCornerTexcoords ? weldedAcrossTexcoords(mesh) : WeldedMesh{mesh, {}};
  PlySink sink(headerOf(layout, written.mesh));
  putVertices(sink, layout, written.mesh);
  putFaces(sink, layout, written);
  return {{{outputName, sink.bytes()}}, droppedAttributes(model, semanticsOf(layout), "PLY")};
}

}  // namespace remesher::io
