// SPDX-License-Identifier: MIT
#include "steps/subdivide.h"

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

std::size_t subdividedCount(const HalfedgeMesh& mesh, std::size_t vertices, int levels) {
  // One vertex more brings three edges and two faces, by Euler's formula.
  const std::size_t more = vertices - mesh.vertexCount();
  std::size_t v = vertices, e = countEdges(mesh) + 3 * more, f = mesh.faceCount() + 2 * more;
  for (int i = 0; i < levels; ++i) {
    v += e;
    e = 2 * e + 3 * f;
    f *= 4;
  }
  return v;
}

}  // namespace remesher
