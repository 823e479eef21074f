// SPDX-License-Identifier: MIT
// A vertex pool ready to be written: the vertices of a mesh that it needs, with their attributes
// and triangles in the encodings of the file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/triangle_mesh.h"
#include "io/gltf/gltf_encoder.h"
#include "io/gltf/gltf_geometry.h"

namespace remesher::io {

struct EncodedAttribute {
  Encoding encoding;
  EncodedAccessor values;  // no bytes: all zeros
};

struct EncodedPool {
  std::size_t vertexCount = 0;
  std::map<std::string, EncodedAttribute> attributes;  // by semantic
  std::map<int, std::vector<Index>> triangles;         // per primitive that has any
};

// document: holds the pool's accessors; null if there are none and the pool names -1 for each.
// Semantics that the mesh lacks are left out, except morph targets, which become zeros because
// animations count them.
EncodedPool encodePool(const TriangleMesh& mesh, const VertexPool& pool,
                       const GltfDocument* document);

}  // namespace remesher::io
