// SPDX-License-Identifier: MIT
// A glTF file taken apart but not yet interpreted: the JSON tree with all names and extensions, the
// bytes of the buffers, and tinygltf's typed view of the geometry's description. The promises of
// accessors are checked when accessors are read, not here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
// Must come before tinygltf includes its own.
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
  std::vector<File> bufferFiles;  // buffers that were files of their own
  tinygltf::Model typed;          // accessors, bufferViews, meshes, nodes, scenes, skins
  std::size_t bufferBytes = 0;    // of all buffers together
  // Per mesh the number of joints of the smallest skin that it is shown with.
  std::vector<std::size_t> jointCounts;

  // Throws an error with the message "name: what".
  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;
};

// Throws PARSE_ERROR, MISSING_RESOURCE, UNSUPPORTED.
std::shared_ptr<GltfDocument> openGltf(const File& file, const std::vector<File>& resources);

// A binary glTF file of these two chunks; without the second if `data` is empty.
Bytes packGlb(const Json& tree, const Bytes& data);

}  // namespace remesher::io
