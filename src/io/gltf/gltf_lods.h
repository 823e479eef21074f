// SPDX-License-Identifier: MIT
// Writes coarser levels of detail into a glTF tree with the extension MSFT_lod: as meshes and nodes
// of their own that use the same materials.
#pragma once

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
};

// Each level becomes a copy of the mesh with the level's geometry. Each node that shows the mesh
// gets level nodes, which have the same transform and animation and show the levels. levels: the
// finest first.
void addLods(GltfEditor& editor, const FinestLevel& finest,
             const std::vector<TriangleMesh>& levels);

}  // namespace remesher::io
