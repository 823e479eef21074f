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

// Encodes the pools of a mesh one by one, each in time proportional to its own size: a mesh may
// have thousands. The mesh must outlive the encoder.
class PoolEncoder {
 public:
  // document: holds the pools' accessors; null if there are none and the pools name -1 for each.
  PoolEncoder(const TriangleMesh& mesh, const GltfDocument* document);

  // Semantics that the mesh lacks are left out, except morph targets, which become zeros because
  // animations count them.
  EncodedPool encode(const VertexPool& pool);

 private:
  std::vector<Index> trianglesOf(int primitive);

  const TriangleMesh& mesh_;
  const GltfDocument* document_;
  std::vector<std::size_t> firsts_;  // per group, and the end: its place in order_
  std::vector<Index> order_;         // all triangles by their groups
  std::vector<Index> numbers_;       // per vertex its number in the pool; kNone between calls
  std::vector<Index> vertices_;      // of the pool
};

}  // namespace remesher::io
