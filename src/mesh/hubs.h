// SPDX-License-Identifier: MIT
// Hubs: vertices of very high valence (1000 triangles or more), such as the middle of a cap. An
// algorithm that visits the whole star for each of its triangles takes quadratic time there.
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

  // With a tenth of that valence, for algorithms that start a walk over the whole star at each of
  // its triangles: they take as long there.
  static Hubs ofWalks(const HalfedgeMesh& mesh) { return Hubs(mesh, kFewestSpokes / 10); }

  bool empty() const { return hubs_.empty(); }

  bool contains(Vertex v) const { return std::binary_search(hubs_.begin(), hubs_.end(), v); }

 private:
  std::vector<Vertex> hubs_;  // ascending
};

}  // namespace remesher
