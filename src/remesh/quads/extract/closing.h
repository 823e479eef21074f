// SPDX-License-Identifier: MIT
// What is smaller than a quad, as torn scans have much: a map takes it to points. So the map is
// made on a mesh without it.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

// A handle that was cut: the middle of the cut, and the normal of one of its two ends, which are
// closed; the other's is opposite. Of any length.
struct CutHandle {
  Vec3 middle = Vec3::Zero(), facing = Vec3::Zero();
};

struct Simpler {
  WorkingMesh mesh;
  std::vector<CutHandle> handles;
};

// A compact, connected mesh with its small boundary loops closed, if no other curve ends at them,
// and its thin handles cut. length: of a quad's sides. Triangles that close something follow the
// others.
Simpler withoutSmall(const WorkingMesh& mesh, double length);

}  // namespace remesher
