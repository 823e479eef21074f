// SPDX-License-Identifier: MIT
// Vertices of a thousand triangles and more, such as the middle of a cap. An algorithm that looks
// at the whole star for each of its triangles hardly ends there.
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

  // For algorithms that begin a walk over the whole star at each of its triangles: there a tenth as
  // many triangles take as long.
  static Hubs ofWalks(const HalfedgeMesh& mesh) { return Hubs(mesh, kFewestSpokes / 10); }

  bool empty() const { return hubs_.empty(); }

  bool contains(Vertex v) const { return std::binary_search(hubs_.begin(), hubs_.end(), v); }

 private:
  std::vector<Vertex> hubs_;  // ascending
};

}  // namespace remesher
