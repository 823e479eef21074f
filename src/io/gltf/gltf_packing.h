// SPDX-License-Identifier: MIT
// The last step of writing glTF: drops the data of replaced accessors and joins all buffers into
// one. All other data keeps its bytes.
#pragma once

#include <set>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace remesher::io {

struct PackedGltf {
  Json tree;  // with one buffer, without a URI, or none
  Bytes data;
};

// Data that may be dropped: accessors of replaced primitives, buffer views of replaced images.
struct Abandoned {
  std::set<int> accessors, bufferViews;
};

// Drops abandoned data that nothing uses any more, and the buffer views that only dropped accessors
// used. If an unknown extension might name accessors or buffer views by number, all stay, with
// their numbers.
PackedGltf packGltf(Json tree, const std::vector<GltfBuffer>& buffers, const Abandoned& abandoned);

}  // namespace remesher::io
