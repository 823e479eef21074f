// SPDX-License-Identifier: MIT
#include "io/model/dropped.h"

#include <algorithm>
#include <set>

#include "base/legible.h"

namespace remesher::io {

std::vector<Warning> droppedAttributes(const Model& model, const std::vector<std::string>& kept,
                                       const std::string& format) {
  std::set<std::string> dropped;
  for (const Part& part : model.parts)
    for (const Attribute& attribute : part.mesh.attributes)
      if (std::find(kept.begin(), kept.end(), attribute.semantic) == kept.end())
        dropped.insert(attribute.semantic);
  if (dropped.empty()) return {};
  return {
      {"ATTRIBUTE_NOT_CARRIED",
       "The " + format + " has no place for " + legibleList({dropped.begin(), dropped.end()}) + ".",
       dropped.size()}};
}

}  // namespace remesher::io
