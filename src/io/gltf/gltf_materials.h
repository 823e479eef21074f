// SPDX-License-Identifier: MIT
// Materials of a glTF tree: read as sources for painting, and replaced by painted ones.
#pragma once

#include <set>

#include "io/gltf/gltf_document.h"
#include "io/model/material.h"
#include "io/model/model.h"

namespace remesher::io {

// The material of this number, or glTF's default if there is none. Its maps name images by their
// number in the tree.
Material readMaterial(const Json& tree, int number);

// A material without maps, as JSON.
Json plainMaterial(Material material);

// Appends the model's paintings to the tree's materials; returns the first one's number. Their
// images refer to the model's images as `painting:n`.
std::size_t addPaintings(Json& tree, const Model& model);

// Drops the materials, textures, samplers and images that nothing uses any more. If an unknown
// extension might name one by number, all stay, with their numbers. Returns the buffer views that
// only dropped images used.
std::set<int> dropUnusedLooks(Json& tree);

}  // namespace remesher::io
