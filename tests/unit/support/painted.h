// SPDX-License-Identifier: MIT
// A flat sheet of square cells of side 1, the middle one of which has a place of its own in the
// texture.
#pragma once

#include <utility>

#include "base/triangle_mesh.h"

namespace remesher::shapes {

// u is below 1 everywhere but in the middle cell, where it is `middle`.
inline TriangleMesh paintedSheet(Index side, float middle) {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (Index x = 0; x < side; ++x)
    for (Index y = 0; y < side; ++y) {
      const bool isMiddle = x == side / 2 && y == side / 2;
      const Index a = Index(mesh.positions.size());
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        mesh.positions.emplace_back(x + dx, y + dy, 0);
        uv.values.push_back(isMiddle ? middle : float(x + dx) / float(side));
        uv.values.push_back(float(y + dy) / float(side));
      }
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 2, a, a + 2, a + 3});
    }
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

}  // namespace remesher::shapes
