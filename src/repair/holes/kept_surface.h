// SPDX-License-Identifier: MIT
// The part of a mesh whose open loops can be closed: where open fans of triangles touch in a point,
// only the widest stays, and small open components go. Closed fans stay, wherever they touch.
#pragma once

#include <vector>

#include "base/input_place.h"
#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct KeptSurface {
  TriangleMesh mesh;                  // all vertices of the input; the triangles kept, in order
  BuiltMesh built;                    // of `mesh`: its triangles and wedges are that mesh's
  std::vector<InputTriangle> inputs;  // per triangle of `mesh` the input's, ascending
  std::size_t islands = 0;            // small open components removed
  std::vector<Vec3> removedAt;        // a corner of each of them, and of what goes at pinches
  std::size_t trianglesRemoved = 0;   // of debris, at pinches, given twice; not built.lines
};

// What becomes of small open components.
enum class Debris { Removed, Kept };

// Throws Error as buildMesh does; NO_TRIANGLES if no triangle stays.
KeptSurface keptSurface(const TriangleMesh& input, Debris debris = Debris::Removed);

}  // namespace remesher
