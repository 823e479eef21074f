// SPDX-License-Identifier: MIT
#include "mesh/used_vertices.h"

#include <algorithm>
#include <vector>

namespace remesher {

void keepUsedVertices(TriangleMesh& mesh) {
  std::vector<Index> numbers(mesh.positions.size(), kNone);
  for (const Index v : mesh.indices) numbers[v] = 0;
  Index used = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == kNone) continue;
    numbers[v] = used;
    mesh.positions[used] = mesh.positions[v];
    for (Attribute& attribute : mesh.attributes)
      for (std::size_t k = 0; k < std::size_t(attribute.itemSize); ++k)
        attribute.values[used * attribute.itemSize + k] =
            attribute.values[v * attribute.itemSize + k];
    ++used;
  }
  mesh.positions.resize(used);
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(std::size_t{used} * attribute.itemSize);
  for (Index& v : mesh.indices) v = numbers[v];
}

}  // namespace remesher
