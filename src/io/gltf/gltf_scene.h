// SPDX-License-Identifier: MIT
// Where a glTF scene shows its meshes.
#pragma once

#include <vector>

#include "io/gltf/gltf_document.h"
#include "io/model/model.h"

namespace remesher::io {

// The local-to-world transforms of a mesh.
struct MeshInstances {
  std::vector<Transform> places;
  std::size_t hidden = 0;  // the last ones, which KHR_node_visibility hides
};

// Per mesh: of the nodes of the default scene that have it; of all nodes where the file has no
// scene. Throws PARSE_ERROR for nodes that are not there or not a tree.
std::vector<MeshInstances> meshInstances(const GltfDocument& document);

}  // namespace remesher::io
