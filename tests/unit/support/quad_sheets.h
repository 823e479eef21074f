// SPDX-License-Identifier: MIT
// Quads in rows and columns, open or closed around, for tests of what quads are.
#pragma once

#include <functional>

#include "remesh/quads/mesh/quad_mesh.h"
#include "support/shapes.h"

namespace remesher::shapes {

inline Placement placed(const Vec3& position) {
  Placement place;
  place.position = position;
  place.normal = {0, 0, 1};
  return place;
}

// columns × rows quads; the last column meets the first where `wraps`, and the last row, too.
enum class Wraps { No, Around, BothWays };

inline QuadMesh quadSheet(Index columns, Index rows, Wraps wraps,
                          const std::function<Vec3(double, double)>& place) {
  QuadMesh mesh;
  const Index width = wraps == Wraps::No ? columns + 1 : columns;
  const Index height = wraps == Wraps::BothWays ? rows : rows + 1;
  for (Index y = 0; y < height; ++y)
    for (Index x = 0; x < width; ++x) mesh.vertices.push_back(placed(place(x, y)));
  const auto at = [&](Index x, Index y) { return (y % height) * width + x % width; };
  for (Index y = 0; y < rows; ++y)
    for (Index x = 0; x < columns; ++x) {
      mesh.quads.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      mesh.curves.push_back({kNone, kNone, kNone, kNone});
    }
  return mesh;
}

inline Vec3 flat(double x, double y) { return {x, y, 0}; }

// The six sides of a cube.
inline QuadMesh quadCube() {
  QuadMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back(placed(Vec3(i & 1, i >> 1 & 1, i >> 2 & 1)));
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  mesh.curves.assign(6, {kNone, kNone, kNone, kNone});
  return mesh;
}

}  // namespace remesher::shapes
