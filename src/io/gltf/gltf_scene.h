// SPDX-License-Identifier: MIT
// Where a glTF scene shows its meshes.
#pragma once

#include <vector>

#include "io/gltf/gltf_document.h"
#include "io/model/model.h"

namespace remesher::io {

// Per mesh: the local-to-world transforms of the nodes of the default scene that show it; of all
// nodes where the file has no scene. Throws PARSE_ERROR for nodes that are not there or not a tree.
std::vector<std::vector<Transform>> meshInstances(const GltfDocument& document);

}  // namespace remesher::io
