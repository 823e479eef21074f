// SPDX-License-Identifier: MIT
// The places at which a glTF scene shows its meshes.
#pragma once

#include <vector>

#include "io/gltf/gltf_document.h"
#include "io/model/model.h"

namespace remesher::io {

// The local-to-world transforms of a mesh.
struct MeshInstances {
  std::vector<Transform> places;
  std::size_t hidden = 0;  // number of the last ones, which KHR_node_visibility hides
};

// Per mesh the transforms of the nodes that show it: of the default scene, or of all nodes if the
// file has no scene. Throws PARSE_ERROR for nodes that do not exist or form no tree.
std::vector<MeshInstances> meshInstances(const GltfDocument& document);

}  // namespace remesher::io
