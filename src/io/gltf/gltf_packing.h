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

// abandoned: accessors that replaced primitives named. Those that nothing names any more go, and
// with them the buffer views that only they used. Where an unknown extension might name accessors
// or buffer views by number, all stay, at their numbers.
PackedGltf packGltf(Json tree, const std::vector<Bytes>& buffers, const std::set<int>& abandoned);

}  // namespace remesher::io
