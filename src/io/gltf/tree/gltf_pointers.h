// SPDX-License-Identifier: MIT
// Animations of other things than nodes' transforms: of members named by a JSON pointer
// (KHR_animation_pointer), and of the weights of morph targets.
#pragma once

#include <functional>

#include "io/gltf/tree/gltf_extensions.h"
#include "io/gltf/tree/json.h"

namespace remesher::io {

// Calls visit with the number of each material that an animation names, and writes the visited
// number back.
void forEachMaterialPointer(Json& tree, const std::function<void(Json& number)>& visit);

// Drops channels whose material no primitive shows any more, or whose mesh has lost its morph
// targets, and animations that lose their last channel. before: the original tree.
void settlePointers(const Json& before, Json& tree, LostExtensions& lost);

}  // namespace remesher::io
