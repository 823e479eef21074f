// SPDX-License-Identifier: MIT
// One change to the JSON of a glTF file: of any tree, or of what this format has.
#pragma once

#include <nlohmann/json.hpp>

#include "support/soups.h"

namespace remesher::fuzz {

using Json = nlohmann::ordered_json;

// Where the tree lacks what is to be changed it stays as it is.
void changeTree(Json& tree, soups::Random& random);

}  // namespace remesher::fuzz
