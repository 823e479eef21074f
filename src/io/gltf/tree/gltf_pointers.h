// SPDX-License-Identifier: MIT
// What animations move: a member that a JSON pointer names (KHR_animation_pointer), or the weights
// of morph targets.
#pragma once

#include <functional>

#include "io/gltf/tree/gltf_extensions.h"
#include "io/gltf/tree/json.h"

namespace remesher::io {

// Calls with the number of each material that an animation names, and writes back what becomes of
// it.
void forEachMaterialPointer(Json& tree, const std::function<void(Json& number)>& visit);

// Channels go, and their animation with the last, whose material no primitive shows any more, or
// whose mesh has lost its morph targets. before: the tree as it was.
void settlePointers(const Json& before, Json& tree, LostExtensions& lost);

}  // namespace remesher::io
