// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/side_places.h"

#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// A point in the quad's part of the original, near p. No way within the part leads across curves.
SurfacePoint startIn(const QuadMesh& mesh, Index quad, const Vec3& p, const WorkingMesh& ground) {
  const Placement* nearest = nullptr;
  for (const Index v : mesh.quads[quad]) {
    const Placement& place = mesh.vertices[v];
    if (place.kind != VertexKind::Interior) continue;
    if (!nearest || (place.position - p).norm() < (nearest->position - p).norm()) nearest = &place;
  }
  if (nearest) return nearest->at;
  for (Index i = 0; i < 4; ++i) {
    const Index chain = mesh.curves[quad][i];
    if (chain == kNone) continue;
    const CurvePoint here = onChain(mesh.vertices[mesh.quads[quad][i]], chain, ground);
    const CurvePoint there = onChain(mesh.vertices[mesh.quads[quad][(i + 1) % 4]], chain, ground);
    return ground.surface().curves().leftOf(ground.surface().mesh(), here, there);
  }
  return mesh.vertices[mesh.quads[quad][0]].at;
}

}  // namespace

CurvePoint onChain(const Placement& place, Index chain, const WorkingMesh& ground) {
  if (place.kind == VertexKind::Curve) return place.on;
  return ground.surface().curves().atCorner(chain, ground.originalCorner(place.at));
}

Placement middleOf(const QuadMesh& mesh, Index side, const WorkingMesh& ground) {
  const Index quad = side / 4, a = mesh.quads[quad][side % 4], b = mesh.quads[quad][(side + 1) % 4];
  const Index chain = mesh.curves[quad][side % 4];
  const Placement &from = mesh.vertices[a], &to = mesh.vertices[b];
  if (chain != kNone) {
    const double arcs = onChain(from, chain, ground).arc + onChain(to, chain, ground).arc;
    return ground.onCurve({chain, arcs / 2});
  }
  const Vec3 p = (from.position + to.position) / 2;
  return placeWithin(mesh, quad, p, ground);
}

Placement placeWithin(const QuadMesh& mesh, Index quad, const Vec3& p, const WorkingMesh& ground) {
  return ground.onSurface(closestPointFrom(ground.surface(), startIn(mesh, quad, p, ground), p));
}

}  // namespace remesher
