// SPDX-License-Identifier: MIT
#include "steps/relax.h"

#include <vector>

#include "steps/sweeps.h"

namespace remesher {

namespace {

// What moves by less than this share of its target length is settled; on a coarse level, where a
// pass costs little and spares many on the next, later.
constexpr double kStill = 0.01, kStillOnCoarse = 0.004;

}  // namespace

void relax(Run& run, int passes) { relax(run, passes, isCoarse(run) ? kStillOnCoarse : kStill); }

void relax(Run& run, int passes, double still) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
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
      const double least = still * run.scale * run.sizes.at(run.mesh.at(v));
      if ((run.mesh.position(v) - before).squaredNorm() >= least * least) run.mesh.unsettleStar(v);
    }
  }
}

}  // namespace remesher
