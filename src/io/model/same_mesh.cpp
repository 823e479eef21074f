// SPDX-License-Identifier: MIT
#include "io/model/same_mesh.h"

#include <algorithm>

namespace remesher::io {

bool isSame(const TriangleMesh& a, const TriangleMesh& b) {
  const auto sameAttribute = [](const Attribute& x, const Attribute& y) {
    return x.semantic == y.semantic && x.itemSize == y.itemSize && x.values == y.values;
  };
  return a.indices == b.indices && a.groups == b.groups && a.positions == b.positions &&
         std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(), sameAttribute);
}

bool isMended(const std::vector<Warning>& warnings) {
  return std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.code == "NON_FINITE_ATTRIBUTE" || warning.code == "JOINT_NOT_IN_SKIN" ||
           warning.code == "COUNT_CONTRADICTS";
  });
}

std::vector<Warning> saidOfWhole(std::vector<Warning> warnings) {
  std::erase_if(warnings, [](const Warning& warning) {
    return warning.code == "ATTRIBUTE_NOT_CARRIED" || warning.code == "NOT_TRIANGLES" ||
           warning.code == "ELEMENTS_LEFT_OUT";
  });
  return warnings;
}

}  // namespace remesher::io
