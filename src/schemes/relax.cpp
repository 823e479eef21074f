// SPDX-License-Identifier: MIT
#include "schemes/relax.h"

#include "schemes/sweeps.h"

namespace remesher {

namespace {

constexpr double kStillMoves = 0.01;  // of the target edge length

}  // namespace

void relax(Run& run, int passes) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  VertexData<char> active(mesh.vertexCapacity(), 1), next(mesh.vertexCapacity(), 0);
  PolarMap star;
  for (int pass = 0; pass < passes; ++pass) {
    next.assign(mesh.vertexCapacity(), 0);
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh.isAlive(v) || !active[v]) continue;
      const Vec3 before = run.mesh.position(v);
      if (!laplacianMove(run, star, v)) continue;
      const double still = kStillMoves * run.scale * run.sizes.at(run.mesh.at(v));
      if ((run.mesh.position(v) - before).squaredNorm() < still * still) continue;
      next[v] = 1;
      mesh.forEachNeighbor(v, [&](Vertex w) { next[w] = 1; });
    }
    std::swap(active, next);
  }
}

}  // namespace remesher
