// SPDX-License-Identifier: MIT
// A model that did not come from glTF as a new, plain document: a mesh for each part, a node for
// each place.
#pragma once

#include "io/gltf/gltf_packing.h"
#include "io/model/model.h"

namespace remesher::io {

// Throws Error: NO_TRIANGLES.
PackedGltf plainGltf(const Model& model);

}  // namespace remesher::io
