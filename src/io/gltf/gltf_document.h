// SPDX-License-Identifier: MIT
// A glTF file taken apart, not yet understood: the JSON tree with every name and extension it
// has, the bytes of its buffers, and tinygltf's typed view of what describes geometry. Whatever
// the accessors promise is checked where they are read, not here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
// First, before tinygltf brings the same.
#include "io/gltf/library/tinygltf.h"
#include "io/gltf/tree/json.h"
#include "io/model/model.h"

namespace remesher::io {

using Bytes = std::vector<std::uint8_t>;

struct GltfDocument : Source {
  File original;
  std::vector<File> resources;
  bool isBinary = false;    // .glb
  bool isEmbedded = false;  // all buffers of a .gltf are data URIs
  Json tree;                // without the URIs of buffers
  std::vector<Bytes> buffers;
  std::vector<File> bufferFiles;  // those of them that lay beside the file
  tinygltf::Model typed;          // accessors, bufferViews, meshes, nodes, scenes, skins

  // "name: what".
  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;
};

// Throws PARSE_ERROR, MISSING_RESOURCE, UNSUPPORTED.
std::shared_ptr<GltfDocument> openGltf(const File& file, const std::vector<File>& resources);

// A binary glTF file of these two chunks; without a second one when `data` is empty.
Bytes packGlb(const Json& tree, const Bytes& data);

}  // namespace remesher::io
