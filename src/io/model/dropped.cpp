// SPDX-License-Identifier: MIT
#include "io/model/dropped.h"

#include <algorithm>
#include <set>

#include "base/legible.h"

namespace remesher::io {
namespace {

std::size_t groupsIn(const Model& model) {
  std::size_t groups = 0;
  for (const Part& part : model.parts) groups += std::max<std::size_t>(part.groups.size(), 1);
  return groups;
}

std::size_t materialsIn(const Model& model) {
  std::set<std::string> names;
  for (const Part& part : model.parts)
    for (const GroupInfo& group : part.groups)
      if (!group.material.empty() || group.look.number >= 0) names.insert(group.material);
  return names.size();
}

// Morph targets have up to three attributes each: a list of them would hide the others.
std::string kindOf(const std::string& semantic) {
  return semantic.starts_with("TARGET_") ? "morph targets" : semantic;
}

}  // namespace

std::vector<Warning> droppedAttributes(const Model& model, const std::vector<std::string>& kept,
                                       const std::string& format) {
  std::set<std::string> lost, dropped;
  for (const std::string& semantic : model.lost) lost.insert(kindOf(semantic));
  for (const Part& part : model.parts)
    for (const Attribute& attribute : part.mesh.attributes)
      if (std::find(kept.begin(), kept.end(), attribute.semantic) == kept.end())
        dropped.insert(kindOf(attribute.semantic));
  const bool keepsMaterials = std::find(kept.begin(), kept.end(), kMaterial) != kept.end();
  if (groupsIn(model) == 1 && materialsIn(model) > 0 && !keepsMaterials) dropped.insert(kMaterial);
  std::vector<Warning> warnings;
  const auto warn = [&](const std::string& why, const std::set<std::string>& semantics) {
    if (semantics.empty()) return;
    const std::string list = legibleList({semantics.begin(), semantics.end()});
    warnings.push_back({"ATTRIBUTE_NOT_CARRIED", why + list + ".", semantics.size()});
  };
  warn("The " + format + " has no place for ", dropped);
  warn("Parts that become one surface do not keep their ", lost);
  return warnings;
}

std::vector<Warning> mergedParts(const Model& model) {
  const std::size_t groups = groupsIn(model);
  if (groups < 2) return {};
  return {{"PARTS_MERGED",
           "A file of this format is one solid: parts and materials are merged into it.", groups}};
}

std::vector<Warning> namedMaterials(const Model& model) {
  const std::size_t count = materialsIn(model);
  if (count == 0) return {};
  return {{"MATERIALS_BY_NAME",
           "The materials keep their names, and the result refers to no .mtl: write a .glb to keep "
           "their colours.",
           count}};
}

}  // namespace remesher::io
