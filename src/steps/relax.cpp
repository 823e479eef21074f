// SPDX-License-Identifier: MIT
#include "steps/relax.h"

#include <vector>

#include "steps/sweeps.h"

namespace remesher {

namespace {

// What moves by less than this share of its target length is settled; in large meshes, where a pass
// costs and few triangles are near any limit, sooner.
constexpr double kStillMoves = 0.004, kStillMovesInLarge = 0.01;

}  // namespace

void relax(Run& run, int passes) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double share = isLarge(run) ? kStillMovesInLarge : kStillMoves;
  std::vector<Vertex> active;
  PolarMap star;
  for (int pass = 0; pass < passes; ++pass) {
    active.clear();
    for (Index i = 0; i < mesh.vertexCapacity(); ++i)
      if (mesh.isAlive(Vertex(i)) && run.mesh.isUnsettled(Vertex(i))) active.emplace_back(i);
    for (const Vertex v : active) run.mesh.settle(v);
    for (const Vertex v : active) {
      const Vec3 before = run.mesh.position(v);
      if (!laplacianMove(run, star, v)) continue;
      const double still = share * run.scale * run.sizes.at(run.mesh.at(v));
      if ((run.mesh.position(v) - before).squaredNorm() >= still * still) run.mesh.unsettleStar(v);
    }
  }
}

}  // namespace remesher
