// SPDX-License-Identifier: MIT
#include "steps/subdivide.h"

#include <algorithm>
#include <cstdint>

namespace remesher {

namespace {

std::size_t countEdges(const HalfedgeMesh& mesh) {
  std::size_t boundary = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    boundary += mesh.isAlive(Halfedge(i)) && mesh.isBoundary(Halfedge(i));
  return (3 * mesh.faceCount() + boundary) / 2;
}

}  // namespace

void subdivide(Run& run) {
  run.mesh.compact();
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::vector<Placement> midpoints;
  midpoints.reserve(countEdges(mesh));
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isEdge(Halfedge(i)))
      midpoints.push_back(midpoint(run.mesh, run.projector, Halfedge(i)));
  run.mesh.subdivide(midpoints);
  run.scale /= 2;
}

std::size_t coarseCount(const HalfedgeMesh& mesh, std::size_t vertices, int levels) {
  const std::size_t fewest = vertices >> (2 * levels);
  // One vertex more brings three edges and two faces, by Euler's formula; signed, for many small
  // parts have fewer vertices to lose than that takes away.
  const std::int64_t more = std::int64_t(fewest) - std::int64_t(mesh.vertexCount());
  std::int64_t v = std::int64_t(fewest), e = std::int64_t(countEdges(mesh)) + 3 * more;
  std::int64_t f = std::int64_t(mesh.faceCount()) + 2 * more;
  for (int i = 0; i < levels; ++i) {
    v += e;
    e = 2 * e + 3 * f;
    f *= 4;
  }
  // And each becomes four to the power of the levels.
  const std::int64_t missing = std::max(std::int64_t{0}, std::int64_t(vertices) - v),
                     each = std::int64_t{1} << (2 * levels);
  return fewest + std::size_t((missing + each - 1) / each);
}

}  // namespace remesher
