// SPDX-License-Identifier: MIT
// Materials of a glTF tree: read to be painted anew, and what was painted put in their place.
#pragma once

#include <set>

#include "io/gltf/gltf_document.h"
#include "io/model/material.h"
#include "io/model/model.h"

namespace remesher::io {

// The material of this number; glTF's default where there is none. Its maps' images are called by
// their number in the tree.
Material readMaterial(const Json& tree, int number);

// The model's paintings behind the tree's materials; returns the first one's number. Their images
// refer to the model's as `painting:n`.
std::size_t addPaintings(Json& tree, const Model& model);

// Drops the materials, textures and images that nothing uses any more; where an unknown extension
// might name one by number, all stay, at their numbers. Returns the buffer views that only images
// used which went.
std::set<int> dropUnusedImages(Json& tree);

}  // namespace remesher::io
