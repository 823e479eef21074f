// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_union.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_packing.h"
#include "io/gltf/tree/gltf_levels.h"
#include "io/model/appending.h"
#include "io/model/bake.h"

namespace remesher::io {
namespace {

bool isOfSkin(const std::string& semantic) {
  return semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_");
}

// Whether the united mesh has none of it. skin: its number, below 0 if it has none.
bool isDropped(const std::string& semantic, int skin) {
  return semantic.starts_with("TARGET_") || (skin < 0 && isOfSkin(semantic));
}

// All shown places of all parts, but coarser levels of detail, as one part; and the numbers in the
// file of the meshes in their order.
struct Union {
  Part part;
  std::vector<int> sources;
  std::size_t dropped = 0;  // attributes
};

std::set<std::string> namesOf(const TriangleMesh& mesh) {
  std::set<std::string> names;
  for (const Attribute& attribute : mesh.attributes) names.insert(attribute.semantic);
  return names;
}

// Groups lack the attributes that only other places have.
void noteLacks(Part& part, const std::vector<std::size_t>& ends,
               const std::vector<std::set<std::string>>& owned) {
  std::size_t group = 0;
  for (std::size_t place = 0; place < ends.size(); ++place)
    for (; group < ends[place]; ++group)
      for (const Attribute& attribute : part.mesh.attributes)
        if (owned[place].count(attribute.semantic) == 0)
          part.groups[group].lacks.push_back(attribute.semantic);
}

// The skin that moves all shown meshes; below 0 if there is none, or more than one.
int commonSkin(const Model& model, const Json& tree) {
  std::set<int> skins;
  std::set<int> meshes;
  for (const Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    if (namesOf(part.mesh).count("JOINTS_0") == 0) return -1;
    meshes.insert(part.source);
  }
  for (const Json& node : tree.value("nodes", Json::array()))
    if (meshes.count(node.value("mesh", -1)) > 0) skins.insert(node.value("skin", -1));
  return skins.size() == 1 ? *skins.begin() : -1;
}

// Meshes of one skin are placed by it, all alike: they stay in their own space.
Union unionOf(const Model& model, int skin) {
  Union all;
  all.part.instances = {Transform::Identity()};
  all.part.mesh.isSingle = true;
  std::set<std::string> dropped;
  std::vector<std::size_t> ends;             // per place the end of its groups
  std::vector<std::set<std::string>> owned;  // and its semantics
  for (const Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    if (all.part.name.empty()) all.part.name = part.name;
    std::size_t shown = part.instances.size() - std::min(part.instances.size(), part.hidden);
    if (skin >= 0 && shown > 0) {
      shown = 1;
      all.part.instances = {part.instances.front()};
    }
    for (std::size_t i = 0; i < shown; ++i) {
      TriangleMesh mesh = part.mesh;
      std::erase_if(mesh.attributes, [&](const Attribute& attribute) {
        return isDropped(attribute.semantic, skin) && (dropped.insert(attribute.semantic), true);
      });
      if (skin < 0) transformMesh(mesh, part.instances[i]);
      appendGroups(all.part.mesh.groups, mesh, Index(all.part.groups.size()));
      all.part.mesh.isSingle = all.part.mesh.isSingle && mesh.isSingle;
      appendMesh(all.part.mesh, mesh);
      std::vector<GroupInfo> groups = part.groups;
      groups.resize(std::max(groups.size(), groupCount(mesh)));
      ends.push_back(all.part.groups.size() + groups.size());
      owned.push_back(namesOf(mesh));
      all.part.groups.insert(all.part.groups.end(), groups.begin(), groups.end());
      all.sources.push_back(part.source);
    }
  }
  noteLacks(all.part, ends, owned);
  all.dropped = dropped.size();
  return all;
}

// The primitives of these meshes, as those of one.
Json primitivesOf(const Json& tree, const std::vector<int>& meshes, int skin) {
  Json primitives = Json::array();
  for (const int mesh : meshes)
    for (Json primitive : tree["meshes"][std::size_t(mesh)]["primitives"]) {
      primitive.erase("targets");
      Json attributes = Json::object();
      for (const auto& [semantic, accessor] : primitive["attributes"].items())
        if (!isDropped(semantic, skin)) attributes[semantic] = accessor;
      primitive["attributes"] = std::move(attributes);
      primitives.push_back(std::move(primitive));
    }
  return primitives;
}

// Returns the number of the new mesh.
std::size_t addMesh(Json& tree, const std::vector<int>& meshes, const std::string& name, int skin) {
  const std::size_t before = tree["meshes"].size();
  tree["meshes"].push_back({{"name", name}, {"primitives", primitivesOf(tree, meshes, skin)}});
  std::set<std::size_t> old;
  for (std::size_t m = 0; m < before; ++m) old.insert(m);
  const std::size_t node = tree["nodes"].size();
  tree["nodes"].push_back({{"name", name}, {"mesh", before}});
  if (skin >= 0) tree["nodes"].back()["skin"] = skin;
  const std::size_t scene = tree.value("scene", std::size_t{0});
  tree["scenes"][scene]["nodes"].push_back(node);
  dropMeshes(tree, old);
  return tree["nodes"][node]["mesh"].get<std::size_t>();
}

}  // namespace

void uniteGltf(Model& model) {
  const auto* const document = dynamic_cast<const GltfDocument*>(model.source.get());
  const int skin = commonSkin(model, document->tree);
  Union all = unionOf(model, skin);
  if (all.sources.size() < 2) return;
  Json tree = document->tree;
  all.part.source = int(addMesh(tree, all.sources, all.part.name, skin));
  PackedGltf packed = packGltf(std::move(tree), document->buffers, {});
  const File file{document->original.name, packGlb(packed.tree, packed.data)};
  const std::shared_ptr<GltfDocument> united = openGltf(file, document->resources);
  united->isBinary = document->isBinary, united->isEmbedded = document->isEmbedded;
  united->isGiven = false;
  model.source = united;
  model.parts.clear();
  model.parts.push_back(std::move(all.part));
  if (all.dropped > 0)
    model.warnings.push_back({"ATTRIBUTE_NOT_CARRIED",
                              skin < 0 ? "Joints, weights and morph targets are not carried: the "
                                         "united mesh does not move."
                                       : "Morph targets are not carried.",
                              all.dropped});
}

void uniteParts(Model& model) {
  Union all = unionOf(model, -1);
  if (all.sources.size() < 2) return;
  model.source = nullptr;
  model.parts.clear();
  model.parts.push_back(std::move(all.part));
}

}  // namespace remesher::io
