// SPDX-License-Identifier: MIT
// Edits a glTF tree. New geometry goes into new accessors, buffer views and a new buffer behind the
// existing ones, so that every number in the tree keeps its meaning.
#pragma once

#include <map>
#include <set>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_geometry.h"
#include "io/gltf/gltf_pool.h"
#include "io/gltf/tree/gltf_extensions.h"

namespace remesher::io {

class GltfEditor {
 public:
  // document: holds the old accessors; null if there are none and every pool names -1 for each
  // accessor.
  GltfEditor(Json tree, const GltfDocument* document);

  // Gives the primitives of the pools the triangles of their groups; removes primitives without
  // any.
  void replaceGeometry(std::size_t meshNumber, const TriangleMesh& mesh,
                       const std::vector<VertexPool>& pools, Texcoords texcoords = Texcoords::Kept);

  // The same for several meshes with the same primitives, whose triangles have one set of vertices:
  // the groups of the k-th mesh are raised by k times the number of primitives.
  void replaceGeometries(std::span<const std::size_t> meshes, const TriangleMesh& mesh,
                         const std::vector<VertexPool>& pools, Texcoords texcoords);

  // Adds a file as a buffer view; returns its number.
  std::size_t addFile(const Bytes& bytes);

  Json& tree() { return tree_; }
  GltfBuffer newData() const { return {&data_, 0, data_.bytes.size()}; }
  // The accessors that replaced primitives used.
  const std::set<int>& abandoned() const { return abandoned_; }
  // The parts of extensions that were lost.
  LostExtensions& lost() { return lost_; }

 private:
  std::size_t addBufferView(const EncodedAccessor& encoded, int target);
  std::size_t addAccessor(Json accessor);
  Json describe(int oldAccessor, const Encoding& encoding, std::size_t count);
  AccessorsBySemantic addAttributes(const EncodedPool& encoded, const VertexPool& pool);
  std::size_t addIndices(const Json& primitive, const std::vector<Index>& indices,
                         std::size_t vertexCount);
  void abandon(const Json& primitive);
  std::size_t addStill(const Json& positions);
  std::size_t addZeros(const Json& positions);
  void dropForeignWeights(std::size_t meshNumber);
  void rewritePrimitive(Json& primitive, const AccessorsBySemantic& accessors, std::size_t indices,
                        Texcoords texcoords);

  Json tree_;
  const GltfDocument* document_;
  std::size_t newBuffer_;  // the number of the buffer that data_ will be
  File data_;
  std::map<std::size_t, std::vector<std::size_t>> weightedNodes_;  // by mesh, as the file came
  std::set<int> abandoned_;
  LostExtensions lost_;
};

}  // namespace remesher::io
