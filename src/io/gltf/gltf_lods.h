// SPDX-License-Identifier: MIT
// Coarser levels of detail in a glTF tree, as the extension MSFT_lod has them: meshes and nodes of
// their own, which name the same materials.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"
#include "io/gltf/gltf_editor.h"
#include "io/gltf/gltf_geometry.h"

namespace remesher::io {

// A mesh of the tree as it was before its geometry was replaced.
struct FinestLevel {
  std::size_t number;
  Json mesh;
  std::vector<VertexPool> pools;
};

// Each level becomes a copy of the mesh with its geometry; each node that shows the mesh is told of
// nodes that stand where it does, move as it does, and show the levels. Levels: the finest first.
void addLods(GltfEditor& editor, const FinestLevel& finest,
             const std::vector<TriangleMesh>& levels);

}  // namespace remesher::io
