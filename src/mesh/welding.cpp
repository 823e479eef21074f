// SPDX-License-Identifier: MIT
#include "mesh/welding.h"

#include "base/place.h"

namespace remesher {

Welding::Welding(const TriangleMesh& mesh, Twins wanted) : first(weld(mesh.positions)) {
  corners.reserve(mesh.indices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Index a = first[mesh.indices[i]], b = first[mesh.indices[i + 1]],
                c = first[mesh.indices[i + 2]];
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
  }
  if (wanted == Twins::Found) twins = plainTwins(first.size(), corners);
}

}  // namespace remesher
