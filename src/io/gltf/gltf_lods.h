// SPDX-License-Identifier: MIT
// Writes coarser levels of detail into a glTF tree with the extension MSFT_lod: as meshes and nodes
// of their own that use the same materials.
#pragma once

#include <map>
#include <vector>

#include "base/triangle_mesh.h"
#include "io/gltf/gltf_editor.h"
#include "io/gltf/gltf_geometry.h"

namespace remesher::io {

// A mesh of the tree before its geometry is replaced.
struct FinestLevel {
  std::size_t number;
  Json mesh;
  std::vector<VertexPool> pools;
  Texcoords texcoords = Texcoords::Kept;
  std::vector<double> coverages = {};  // see Part
};

class LodWriter {
 public:
  explicit LodWriter(GltfEditor& editor);

  // Each level becomes a copy of the mesh with the level's geometry. Each node that shows the mesh
  // gets level nodes, which have the same transform and animation and show the levels. levels: the
  // finest first.
  void add(const FinestLevel& finest, const std::vector<TriangleMesh>& levels);

  // The same in two steps, for levels that share the finest one's vertices: first the geometry of
  // the mesh and its levels, if they do. Returns the meshes of the levels, or none.
  std::vector<std::size_t> addShared(const FinestLevel& finest, const TriangleMesh& mesh,
                                     const std::vector<TriangleMesh>& levels);
  void addNodes(const FinestLevel& finest, const std::vector<std::size_t>& meshes);

 private:
  // A channel of an animation.
  struct Channel {
    std::size_t animation, number;
  };

  void index();
  std::vector<std::size_t> addMeshes(const FinestLevel& finest, std::size_t levels);
  void addNodesOf(std::size_t node, const std::vector<std::size_t>& meshes,
                  const std::vector<double>& coverages);
  void moveAlike(std::size_t node, std::size_t other);

  GltfEditor& editor_;
  bool isIndexed_ = false;
  std::map<std::size_t, std::vector<std::size_t>> nodesOf_;  // by mesh, as the file came
  std::map<std::size_t, std::vector<Channel>> channelsOf_;   // by node, as the file came
};

}  // namespace remesher::io
