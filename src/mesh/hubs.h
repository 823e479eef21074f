// SPDX-License-Identifier: MIT
// Vertices of a thousand triangles and more, as in the middle of a cap. Whatever looks at a whole
// star for each of its triangles does not end there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

class Hubs {
 public:
  static constexpr std::size_t kFewestSpokes = 1000;

  explicit Hubs(const HalfedgeMesh& mesh, std::size_t fewestSpokes = kFewestSpokes);

  // Where each triangle of a star begins walks that look at all the others, a tenth as many
  // triangles take as long.
  static Hubs ofWalks(const HalfedgeMesh& mesh) { return Hubs(mesh, kFewestSpokes / 10); }

  bool empty() const { return hubs_.empty(); }

  bool contains(Vertex v) const { return std::binary_search(hubs_.begin(), hubs_.end(), v); }

 private:
  std::vector<Vertex> hubs_;  // ascending
};

}  // namespace remesher
