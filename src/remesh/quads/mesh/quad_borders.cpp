// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_borders.h"

#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

bool isBorderCurved(const OriginalSurface& surface) {
  const HalfedgeMesh& original = surface.mesh();
  std::size_t edges = 0, onCurves = 0;
  for (Index i = 0; i < original.halfedgeCapacity(); ++i)
    edges += original.isAlive(Halfedge(i)) && original.isBoundary(Halfedge(i));
  for (const Chain& chain : surface.curves().chains())
    onCurves += chain.boundary ? chain.halfedges.size() : 0;
  return edges == onCurves;
}

}  // namespace

std::vector<Index> sidesOffBorder(const QuadMesh& mesh, const OriginalSurface& surface) {
  std::vector<Index> found;
  if (!isBorderCurved(surface)) return found;
  const auto isOnBorder = [&](Index v) {
    const Placement& place = mesh.vertices[v];
    if (place.kind == VertexKind::Curve) return surface.curves().chains()[place.on.chain].boundary;
    if (place.kind == VertexKind::Interior) return false;
    int corner = 0;
    place.at.barycentric.maxCoeff(&corner);
    return surface.mesh().isBoundary(surface.mesh().vertices(place.at.face)[std::size_t(corner)]);
  };
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  for (Index side = 0; side < sides.size(); ++side)
    if (sides.across(side) == kNone &&
        !(isOnBorder(sides.origin(side)) && isOnBorder(sides.tip(side))))
      found.push_back(side);
  return found;
}

}  // namespace remesher
