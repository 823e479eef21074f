// SPDX-License-Identifier: MIT
#include "remesh/schemes/land.h"

#include <utility>

namespace remesher {

void land(Run& run) {
  if (!run.grounds.standIn) return;
  const StandIn& standIn = *std::exchange(run.grounds.standIn, nullptr);
  const HalfedgeMesh& mesh = run.mesh.mesh();
  VertexData<SurfacePoint> places(mesh.vertexCapacity(), SurfacePoint{});
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v)) continue;
    if (run.mesh.kind(v) == VertexKind::Corner)
      places[v] =
          standIn.original().at(standIn.onOriginal(run.mesh.originalCorner(run.mesh.at(v))));
    else if (run.mesh.kind(v) == VertexKind::Interior)
      places[v] = standIn.onOriginal(run.mesh.at(v));
  }
  run.mesh.moveOnto(standIn.original(), places);
  run.projector.moveOnto(standIn.original());
  run.sizes.moveOnto(standIn.original(), standIn.collapseMap());
  run.grounds.thinned = standIn.thinned();
}

}  // namespace remesher
