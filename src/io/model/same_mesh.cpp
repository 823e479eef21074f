// SPDX-License-Identifier: MIT
#include "io/model/same_mesh.h"

#include <algorithm>

namespace remesher::io {

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
