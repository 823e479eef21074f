// SPDX-License-Identifier: MIT
// The star of an interior vertex, gathered once for several queries: its neighbours' positions,
// counterclockwise, and the original's normals there. Valid until a neighbour moves. One object
// serves many vertices and keeps its buffers. Functions that several places call are never inlined:
// one copy is enough.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

class Star {
 public:
  void gather(const WorkingMesh& mesh, Vertex center) {
    spokes_.clear();
    const auto add = [&](Vertex v) { spokes_.push_back({&mesh.position(v), &mesh.normal(v)}); };
    mesh.mesh().forEachNeighbor(center, add);
  }

  std::size_t size() const { return spokes_.size(); }
  const Vec3& position(std::size_t i) const { return *spokes_[i].position; }
  const Vec3& normal(std::size_t i) const { return *spokes_[i].normal; }

  // The sum of the triangles' area vectors if the centre were at `center`.
  [[gnu::noinline]] Vec3 areaVector(const Vec3& center) const {
    Vec3 sum = Vec3::Zero(), before = position(size() - 1) - center;
    for (std::size_t i = 0; i < size(); ++i) {
      const Vec3 spoke = position(i) - center;
      sum += before.cross(spoke);
      before = spoke;
    }
    return sum;
  }

 private:
  struct Spoke {
    const Vec3 *position, *normal;
  };

  std::vector<Spoke> spokes_;
};

}  // namespace remesher
