// SPDX-License-Identifier: MIT
// Makes a new, plain glTF document from a model of another format: a mesh for each part, a node for
// each instance.
#pragma once

#include "io/gltf/gltf_packing.h"
#include "io/model/model.h"

namespace remesher::io {

// Throws Error: NO_TRIANGLES.
PackedGltf plainGltf(const Model& model);

}  // namespace remesher::io
