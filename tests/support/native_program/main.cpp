// SPDX-License-Identifier: MIT
#include <cstdio>

#include "remesher.h"

int main() {
  remesher::TriangleMesh octahedron;
  octahedron.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  remesher::RemeshOptions options;
  options.vertices = 100;
  const remesher::TriangleMesh mesh = remesher::remesh(octahedron, options).mesh;
  std::printf("%zu vertices, %zu triangles\n", mesh.positions.size(), mesh.indices.size() / 3);
}
