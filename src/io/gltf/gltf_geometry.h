// SPDX-License-Identifier: MIT
// Reads the triangles of one glTF mesh as one triangle mesh. Primitives that use the same accessors
// share their vertices; such a set is a vertex pool. The group of a triangle is its primitive's
// number. The writer uses the same pools to put vertices back.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "io/gltf/gltf_document.h"

namespace remesher::io {

// Accessors by semantic; those of morph targets as TARGET_0/POSITION.
using AccessorsBySemantic = std::map<std::string, int>;

struct VertexPool {
  AccessorsBySemantic accessors;
  std::vector<int> primitives;  // their numbers in the mesh
};

// Collects primitives that use the same accessors.
class PoolList {
 public:
  void add(AccessorsBySemantic accessors, int primitive);
  std::vector<VertexPool> take() { return std::move(pools_); }

 private:
  std::vector<VertexPool> pools_;
  std::map<AccessorsBySemantic, std::size_t> numbers_;
};

// The pools of the primitives that are triangles, strips or fans and have positions. Left out are
// attributes whose type glTF does not allow, attributes that need another one that is missing
// (JOINTS_n, WEIGHTS_n, targets of an attribute), and matrices of small integers, whose columns are
// padded; no file is known to have them.
std::vector<VertexPool> vertexPools(const GltfDocument& document, std::size_t mesh);

// Throws PARSE_ERROR, INDEX_OUT_OF_RANGE, NON_FINITE.
TriangleMesh readGeometry(const GltfDocument& document, int mesh, std::vector<Warning>& warnings);

}  // namespace remesher::io
