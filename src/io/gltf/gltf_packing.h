// SPDX-License-Identifier: MIT
// The last step of writing glTF: what replaced accessors have left behind is dropped, and all
// buffers become one. Everything else keeps its bytes.
#pragma once

#include <set>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace remesher::io {

struct PackedGltf {
  Json tree;  // with one buffer, without a URI, or none
  Bytes data;
};

// What may go: accessors that replaced primitives named, buffer views of images that were replaced.
struct Abandoned {
  std::set<int> accessors, bufferViews;
};

// What is abandoned and nothing names any more goes, and with accessors the buffer views that only
// they used. Where an unknown extension might name accessors
// or buffer views by number, all stay, at their numbers.
PackedGltf packGltf(Json tree, const std::vector<Bytes>& buffers, const Abandoned& abandoned);

}  // namespace remesher::io
