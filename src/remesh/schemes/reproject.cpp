// SPDX-License-Identifier: MIT
#include "remesh/schemes/reproject.h"

#include <utility>

namespace remesher {

void reproject(Run& run) {
  if (!run.grounds.proxy) return;
  const Proxy& proxy = *std::exchange(run.grounds.proxy, nullptr);
  const HalfedgeMesh& mesh = run.mesh.mesh();
  VertexData<SurfacePoint> places(mesh.vertexCapacity(), SurfacePoint{});
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v)) continue;
    if (run.mesh.kind(v) == VertexKind::Corner)
      places[v] = proxy.original().at(proxy.onOriginal(run.mesh.originalCorner(run.mesh.at(v))));
    else if (run.mesh.kind(v) == VertexKind::Interior)
      places[v] = proxy.onOriginal(run.mesh.at(v));
  }
  run.mesh.moveOnto(proxy.original(), places);
  run.projector.moveOnto(proxy.original());
  run.sizes.moveOnto(proxy.original(), proxy.collapseMap());
  run.grounds.thinned = proxy.thinned();
}

}  // namespace remesher
