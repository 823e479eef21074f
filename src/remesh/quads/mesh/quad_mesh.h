// SPDX-License-Identifier: MIT
// A pure quad mesh on the original surface, as a plain value. Each vertex has its place on the
// original, like the vertices of the working mesh; each side knows the feature curve that it
// follows.
#pragma once

#include <array>
#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

// Four of something, one for each corner of a quad, counterclockwise. Side i goes from corner i to
// corner i + 1.
template <class T>
using Four = std::array<T, 4>;

struct QuadMesh {
  std::vector<Placement> vertices;
  std::vector<Four<Index>> quads;
  std::vector<Four<Index>> curves;  // per quad: the chain that each side follows, or kNone

  const Vec3& position(Index v) const { return vertices[v].position; }
};

// A corner with a smaller sine (12°) is nearly straight.
constexpr double kLeastSine = 0.2;

// Of sizes, of vertices in holes, and of all vertices. Twice as many take up to a tenth of the
// time.
constexpr int kSmoothingSweeps = 24;

// A side of a quad as one number.
inline Index sideOf(Index quad, Index corner) { return 4 * quad + corner; }
inline Index nextSide(Index side) { return side % 4 == 3 ? side - 3 : side + 1; }
inline Index prevSide(Index side) { return side % 4 == 0 ? side + 3 : side - 1; }

}  // namespace remesher
