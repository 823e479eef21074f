// SPDX-License-Identifier: MIT
#include "jobs/parts/bare_materials.h"

#include <algorithm>
#include <utility>

namespace remesher {

bool hasImages(const io::Material& look) {
  return look.baseColorMap || look.metalRoughMap || look.occlusionMap || look.emissiveMap ||
         look.normalMap;
}

io::Material withoutImages(io::Material look, const std::string& name) {
  look.name = name, look.number = -1;
  look.baseColorMap = look.metalRoughMap = look.occlusionMap = look.emissiveMap =
      look.normalMap = {};
  return look;
}

std::size_t numberOf(const io::Material& look, std::vector<io::Material>& all) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const io::Material& known) {
    return known.name == look.name && known.baseColor == look.baseColor &&
           known.metallic == look.metallic && known.roughness == look.roughness &&
           known.emissive == look.emissive && known.isOpaque == look.isOpaque;
  });
  if (same != all.end()) return std::size_t(same - all.begin());
  all.push_back(look);
  return all.size() - 1;
}

void dropTexcoords(TriangleMesh& mesh) {
  std::erase_if(mesh.attributes, [](const Attribute& attribute) {
    return attribute.semantic.starts_with("TEXCOORD_") || attribute.semantic == "TANGENT";
  });
}

void dropTextures(io::Model& model) {
  for (io::Part& part : model.parts) {
    dropTexcoords(part.mesh);
    for (io::GroupInfo& group : part.groups) {
      const bool isPainted = model.conventions == io::Conventions::Gltf && hasImages(group.look);
      if (isPainted)
        group.painted = int(numberOf(
            withoutImages(group.look, group.look.name.empty() ? group.material : group.look.name),
            model.paintings));
    }
  }
}

}  // namespace remesher
