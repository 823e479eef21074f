// SPDX-License-Identifier: MIT
#include "remesh/steps/relax.h"

#include <cmath>
#include <utility>

#include "remesh/gate/angles.h"
#include "remesh/operators/smoothing.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

constexpr double kNeighbors = 6;  // of most vertices

bool isAtRest(const Run& run, Vertex v, double share) {
  const double unrest = run.mesh.unrest(v);
  return unrest == 0 || (std::isfinite(unrest) && unrest < kNeighbors * share * run.asked.scale *
                                                               run.sizes.at(run.mesh.at(v)));
}

VertexData<char> narrowCorners(const Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const AngleLimit limit(kWideAngle);
  VertexData<char> found(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.faceCapacity(); ++i)
    if (mesh.isAlive(Face(i)) && limit.isAbove(run.mesh, Face(i)))
      for (const Vertex v : mesh.vertices(Face(i))) found[v] = 1;
  return found;
}

}  // namespace

void relax(Run& run, int passes) { relax(run, passes, run.asked.effort.rest); }

void relax(Run& run, int passes, double share) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  // The vertices of small meshes would never quite come to rest.
  const double part = run.projector.walks() ? kBeyondMean : 1;
  PolarMap star;
  bool isStill = false;
  for (int pass = 0; pass < passes && !isStill; ++pass) {
    isStill = true;
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh.isAlive(v) || isAtRest(run, v, share)) continue;
      isStill = false;
      run.mesh.settle(v);
      const Vec3 before = run.mesh.position(v);
      if (laplacianMove(run, star, v, part))
        run.mesh.stirNeighbors(v, (run.mesh.position(v) - before).norm());
    }
  }
}

void widenAngles(Run& run) {
  PolarMap star;
  // A search that was in vain is not repeated until something has moved around the vertex.
  VertexData<char> isNew(run.mesh.mesh().vertexCapacity(), 1);
  for (int pass = 0; pass < run.asked.effort.widenings; ++pass) {
    const VertexData<char> narrow = narrowCorners(run);
    for (Index i = 0; i < narrow.size(); ++i) {
      const Vertex v(i);
      if (!narrow[v] || !std::exchange(isNew[v], 0) || !widenAround(run, star, v)) continue;
      isNew[v] = 1;
      run.mesh.mesh().forEachNeighbor(v, [&](Vertex w) { isNew[w] = 1; });
    }
  }
}

}  // namespace remesher
