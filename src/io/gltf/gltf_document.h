// SPDX-License-Identifier: MIT
// A glTF file taken apart but not yet interpreted: the JSON tree with all names and extensions,
// where the bytes of the buffers are, and tinygltf's typed view of the geometry's description. The
// promises of accessors are checked when accessors are read, not here.
#pragma once

#include <cstdint>
#include <deque>
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

// Bytes of a file, which are read where they are needed: of a scan they are most of the file.
struct GltfBuffer {
  const File* file = nullptr;
  std::uint64_t begin = 0;
  std::uint64_t size = 0;
  std::string name = {};  // of a file of its own
};

struct GltfDocument : Source {
  File original;
  std::vector<File> resources;
  std::deque<File> decoded;         // data URIs
  bool isGiven = true;              // the original is a file that somebody has
  bool isBinary = false;            // .glb
  bool isEmbedded = false;          // all buffers of a .gltf are data URIs
  Json tree;                        // without the URIs of buffers
  std::vector<GltfBuffer> buffers;  // in the files above
  tinygltf::Model typed;            // accessors, bufferViews, meshes, nodes, scenes, skins
  std::uint64_t bufferBytes = 0;    // of all buffers together
  // Per mesh the number of joints of the smallest skin that it is shown with.
  std::vector<std::size_t> jointCounts;

  // Throws an error with the message "name: what".
  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;
};

// Throws PARSE_ERROR, MISSING_RESOURCE, UNSUPPORTED.
std::shared_ptr<GltfDocument> openGltf(const File& file, const std::vector<File>& resources);

// Appends the bytes of a buffer that begin there.
void appendRange(Bytes& bytes, const GltfBuffer& buffer, std::uint64_t begin, std::uint64_t count);

// A binary glTF file of these two chunks; without the second if `data` is empty.
Bytes packGlb(const Json& tree, const Bytes& data);

}  // namespace remesher::io
