// SPDX-License-Identifier: MIT
#include "io/named/named_faces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "io/model/bake.h"
#include "io/model/corner_weld.h"
#include "io/model/faces.h"
#include "io/text/obj.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

// The name that the file gives to a group: the most specific of its own names.
std::string nameOfGroup(const Part& part, const ObjSource* source, std::size_t group) {
  if (source != nullptr && group < source->groups.size()) {
    const ObjGroup& state = source->groups[group];
    for (const std::string& name : {state.material, state.groups, state.object})
      if (!name.empty()) return name;
  }
  if (group < part.groups.size() && !part.groups[group].material.empty())
    return part.groups[group].material;
  return part.name;
}

class SetNames {
 public:
  Index numberOf(const std::string& name) {
    const std::string known = name.empty() ? "surface" : name;
    const auto [entry, isNew] = numbers_.emplace(known, static_cast<Index>(names_.size()));
    if (isNew) names_.push_back(known);
    return entry->second;
  }
  std::vector<std::string>& names() { return names_; }

 private:
  std::map<std::string, Index> numbers_;
  std::vector<std::string> names_;
};

// The nodes of the part are those of `weld`, which follow the nodes that are there.
void appendFaces(const Part& part, const std::vector<Index>& setOfGroup, CornerWeld& weld,
                 NamedFaces& all) {
  const TriangleMesh& mesh = part.mesh;
  const auto first = static_cast<Index>(all.positions.size());
  std::vector<Index> points;  // by vertex
  for (const Vec3& position : mesh.positions) points.push_back(first + weld.vertexAt(position));
  const Faces faces(mesh);
  for (std::size_t f = 0; f < faces.count(); ++f) {
    NamedFaces::Face face{{}, static_cast<Index>(faces.corners()), 0};
    for (std::size_t corner = 0; corner < faces.corners(); ++corner)
      face.corners[corner] = points[mesh.indices[faces.place(f, corner)]];
    face.set = setOfGroup[mesh.groups.empty() ? 0 : mesh.groups[faces.triangle(f)]];
    all.faces.push_back(face);
  }
}

void appendNodes(const std::vector<Vec3>& nodes, NamedFaces& all) {
  all.positions.insert(all.positions.end(), nodes.begin(), nodes.end());
}

}  // namespace

NamedFaces namedFacesOf(const Model& model) {
  const auto* const source = dynamic_cast<const ObjSource*>(model.source.get());
  const std::vector<Part> bodies = bakeInstances(model);
  NamedFaces all;
  SetNames sets;
  std::vector<const TriangleMesh*> meshes;
  CornerWeld shared;
  for (const Part& body : bodies) {
    std::vector<Index> setOfGroup;
    for (std::size_t g = 0; g < std::max<std::size_t>(groupCount(body.mesh), 1); ++g)
      setOfGroup.push_back(sets.numberOf(nameOfGroup(body, source, g)));
    CornerWeld own;
    appendFaces(body, setOfGroup, model.sharesNodes ? shared : own, all);
    appendNodes(own.positions(), all);
    meshes.push_back(&body.mesh);
  }
  appendNodes(shared.positions(), all);
  std::stable_sort(all.faces.begin(), all.faces.end(), [](const auto& a, const auto& b) {
    return a.set != b.set ? a.set < b.set : a.count < b.count;
  });
  all.names = std::move(sets.names());
  all.isExact =
      digitsFor(meshes, model.isExact ? Digits::OfDoubles : Digits::Fewest) == Digits::OfDoubles;
  return all;
}

std::vector<std::span<const NamedFaces::Face>> runsOf(const NamedFaces& surface) {
  std::vector<std::span<const NamedFaces::Face>> runs;
  const std::span<const NamedFaces::Face> all(surface.faces);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].set == all[begin].set && all[end].count == all[begin].count)
      ++end;
    runs.push_back(all.subspan(begin, end - begin));
  }
  return runs;
}

Model modelOf(NamedFaces faces, const std::string& fileName) {
  if (faces.faces.empty())
    throw Error(ErrorCode::NoTriangles,
                legible(fileName) + " has no triangles or quads of a surface.",
                "Only surfaces can be remeshed, not points, lines or volumes.");
  Part part{fileName, {}, {Transform::Identity()}};
  TriangleMesh& mesh = part.mesh;
  mesh.positions = std::move(faces.positions);
  bool areAllQuads = true;
  for (const NamedFaces::Face& face : faces.faces) {
    const auto& c = face.corners;
    mesh.indices.insert(mesh.indices.end(), {c[0], c[1], c[2]});
    if (face.count == 4) mesh.indices.insert(mesh.indices.end(), {c[0], c[2], c[3]});
    mesh.groups.insert(mesh.groups.end(), face.count - 2, face.set);
    areAllQuads &= face.count == 4;
  }
  mesh.isQuads = areAllQuads && arePairs(mesh);
  for (std::string& name : faces.names) part.groups.push_back({std::move(name), {}});
  if (part.groups.size() == 1 && part.groups[0].material.empty()) {
    part.groups.clear();
    mesh.groups.clear();
  }
  Model model;
  model.conventions = Conventions::Classic;
  if (!mesh.isQuads) model.polygons = mesh.triangleCount() - faces.faces.size();
  model.parts.push_back(std::move(part));
  return model;
}

}  // namespace remesher::io
