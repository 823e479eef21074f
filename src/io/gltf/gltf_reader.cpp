// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/legible.h"
#include "io/gltf/gltf.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_geometry.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/tree/gltf_levels.h"

namespace remesher::io {
namespace {

// Instances of all meshes. If the file shows no mesh at all, each mesh is shown once,
// untransformed.
std::vector<MeshInstances> placedMeshes(const GltfDocument& document) {
  std::vector<MeshInstances> instances = meshInstances(document);
  const bool isEmpty = std::all_of(instances.begin(), instances.end(),
                                   [](const MeshInstances& own) { return own.places.empty(); });
  if (isEmpty)
    for (MeshInstances& own : instances) own.places.push_back(Transform::Identity());
  return instances;
}

std::size_t trianglePrimitives(const GltfDocument& document, std::size_t mesh) {
  std::size_t count = 0;
  for (const VertexPool& pool : vertexPools(document, mesh)) count += pool.primitives.size();
  return count;
}

// Per primitive its group. A primitive lacks the semantics that only other primitives have.
std::vector<GroupInfo> groupInfos(const GltfDocument& document, std::size_t number,
                                  const TriangleMesh& triangles) {
  const tinygltf::Mesh& mesh = document.typed.meshes[number];
  std::vector<GroupInfo> infos(mesh.primitives.size());
  const auto& tree = document.tree;
  const std::size_t materialCount = tree.contains("materials") ? tree["materials"].size() : 0;
  for (const VertexPool& pool : vertexPools(document, number)) {
    for (const int primitive : pool.primitives) {
      GroupInfo& info = infos[primitive];
      for (const Attribute& attribute : triangles.attributes)
        if (pool.accessors.count(attribute.semantic) == 0) info.lacks.push_back(attribute.semantic);
      const int material = mesh.primitives[primitive].material;
      if (material >= 0 && static_cast<std::size_t>(material) < materialCount)
        info.material =
            tree["materials"][material].value("name", "material " + std::to_string(material));
      info.look = readMaterial(tree, material);
    }
  }
  return infos;
}

// Finds which parts are levels of others. By MSFT_lod only levels that no node shows by itself
// count: the others keep their own size.
void tellLevels(const Json& tree, std::vector<Part>& parts) {
  std::map<int, std::size_t> partOf;
  for (std::size_t i = 0; i < parts.size(); ++i) partOf[parts[i].source] = i;
  const auto tell = [&](std::size_t part, const std::set<int>& finest) {
    for (const int mesh : finest)
      if (partOf.count(mesh) == 1) parts[part].finer.push_back(partOf[mesh]);
  };
  for (const auto& [level, finest] : meshLevels(tree)) {
    const auto part = partOf.find(level);
    if (part != partOf.end() && parts[part->second].instances.empty()) tell(part->second, finest);
  }
  for (const auto& [level, finest] : meshLevelsByName(tree)) {
    const auto part = partOf.find(level);
    if (part != partOf.end() && parts[part->second].finer.empty()) tell(part->second, finest);
  }
}

// The transforms of nodes may overflow. Every place lies between the places of the box's corners.
void requireFinitePlaces(const GltfDocument& document, const Part& part) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : part.mesh.positions) box.extend(position);
  for (const Transform& instance : part.instances)
    for (int corner = 0; corner < 8; ++corner)
      if (!(instance * box.corner(Eigen::AlignedBox3d::CornerType(corner))).allFinite())
        document.fail(ErrorCode::NonFinite,
                      "its nodes put " + part.name + " at places that are not finite.",
                      "Repair the transforms of its nodes and joints.");
}

Model readDocument(const std::shared_ptr<GltfDocument>& document) {
  Model model;
  const std::vector<MeshInstances> instances = placedMeshes(*document);
  std::size_t untouched = 0;
  for (std::size_t i = 0; i < document->typed.meshes.size(); ++i) {
    const tinygltf::Mesh& mesh = document->typed.meshes[i];
    untouched += mesh.primitives.size() - trianglePrimitives(*document, i);
    TriangleMesh triangles = readGeometry(*document, static_cast<int>(i), model.warnings);
    if (triangles.indices.empty()) continue;
    const std::string name = mesh.name.empty() ? "mesh " + std::to_string(i) : mesh.name;
    std::vector<GroupInfo> groups = groupInfos(*document, i, triangles);
    model.parts.push_back({name, std::move(triangles), instances[i].places, std::move(groups)});
    requireFinitePlaces(*document, model.parts.back());
    model.parts.back().source = static_cast<int>(i);
    model.parts.back().hidden = instances[i].hidden;
  }
  tellLevels(document->tree, model.parts);
  if (untouched > 0)
    model.warnings.push_back({"NOT_TRIANGLES",
                              "Points, lines and primitives without positions are not remeshed.",
                              untouched});
  model.source = document;
  return model;
}

}  // namespace

Model readGltf(const File& file, const std::vector<File>& resources) {
  try {
    return readDocument(openGltf(file, resources));
  } catch (const Json::exception&) {
    throw Error(ErrorCode::ParseError, legible(file.name) + ": the glTF document is invalid.",
                "A glTF validator tells where.");
  }
}

}  // namespace remesher::io
