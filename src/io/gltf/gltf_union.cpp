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

bool isOfMotion(const std::string& semantic) {
  return semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_") ||
         semantic.starts_with("TARGET_");
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

Union unionOf(const Model& model) {
  Union all;
  all.part.instances = {Transform::Identity()};
  all.part.mesh.isSingle = true;
  std::set<std::string> dropped;
  std::vector<std::size_t> ends;             // per place the end of its groups
  std::vector<std::set<std::string>> owned;  // and its semantics
  for (const Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    if (all.part.name.empty()) all.part.name = part.name;
    const std::size_t shown = part.instances.size() - std::min(part.instances.size(), part.hidden);
    for (std::size_t i = 0; i < shown; ++i) {
      TriangleMesh mesh = part.mesh;
      std::erase_if(mesh.attributes, [&](const Attribute& attribute) {
        return isOfMotion(attribute.semantic) && (dropped.insert(attribute.semantic), true);
      });
      transformMesh(mesh, part.instances[i]);
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

// The primitives of these meshes, as those of one that does not move.
Json primitivesOf(const Json& tree, const std::vector<int>& meshes) {
  Json primitives = Json::array();
  for (const int mesh : meshes)
    for (Json primitive : tree["meshes"][std::size_t(mesh)]["primitives"]) {
      primitive.erase("targets");
      Json attributes = Json::object();
      for (const auto& [semantic, accessor] : primitive["attributes"].items())
        if (!isOfMotion(semantic)) attributes[semantic] = accessor;
      primitive["attributes"] = std::move(attributes);
      primitives.push_back(std::move(primitive));
    }
  return primitives;
}

// Returns the number of the new mesh.
std::size_t addMesh(Json& tree, const std::vector<int>& meshes, const std::string& name) {
  const std::size_t before = tree["meshes"].size();
  tree["meshes"].push_back({{"name", name}, {"primitives", primitivesOf(tree, meshes)}});
  std::set<std::size_t> old;
  for (std::size_t m = 0; m < before; ++m) old.insert(m);
  const std::size_t node = tree["nodes"].size();
  tree["nodes"].push_back({{"name", name}, {"mesh", before}});
  const std::size_t scene = tree.value("scene", std::size_t{0});
  tree["scenes"][scene]["nodes"].push_back(node);
  dropMeshes(tree, old);
  return tree["nodes"][node]["mesh"].get<std::size_t>();
}

}  // namespace

void uniteGltf(Model& model) {
  const auto* const document = dynamic_cast<const GltfDocument*>(model.source.get());
  Union all = unionOf(model);
  if (all.sources.size() < 2) return;
  Json tree = document->tree;
  all.part.source = int(addMesh(tree, all.sources, all.part.name));
  PackedGltf packed = packGltf(std::move(tree), document->buffers, {});
  const File file{document->original.name, packGlb(packed.tree, packed.data)};
  const std::shared_ptr<GltfDocument> united = openGltf(file, document->resources);
  united->isBinary = document->isBinary, united->isEmbedded = document->isEmbedded;
  united->original.bytes.clear();  // these are no file that anyone has given
  model.source = united;
  model.parts.clear();
  model.parts.push_back(std::move(all.part));
  if (all.dropped > 0)
    model.warnings.push_back({"ATTRIBUTE_NOT_CARRIED",
                              "Joints, weights and morph targets are not carried: the united mesh "
                              "does not move.",
                              all.dropped});
}

void uniteParts(Model& model) {
  Union all = unionOf(model);
  if (all.sources.size() < 2) return;
  model.source = nullptr;
  model.parts.clear();
  model.parts.push_back(std::move(all.part));
}

}  // namespace remesher::io
