// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/triangulated.h"

#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

bool areJoined(const QuadSides& sides, Index a, Index b) {
  bool found = false;
  sides.forEachOutgoing(
      a, [&](Index side) { found |= sides.tip(side) == b || sides.origin(prevSide(side)) == b; });
  return found;
}

// The corner where the diagonal begins: 0 or 1.
Index diagonalOf(const QuadMesh& mesh, const QuadSides& sides, const Four<Index>& quad) {
  const auto length = [&](Index k) {
    return (mesh.position(quad[k + 2]) - mesh.position(quad[k])).norm();
  };
  const Index shorter = length(1) < length(0) ? 1 : 0;
  return areJoined(sides, quad[shorter], quad[shorter + 2]) ? 1 - shorter : shorter;
}

template <class T>
Four<T> turned(const Four<T>& four, Index first) {
  return {four[first % 4], four[(first + 1) % 4], four[(first + 2) % 4], four[(first + 3) % 4]};
}

// Turns each quad to begin at an end of its diagonal.
QuadMesh turnedToDiagonals(QuadMesh mesh) {
  const std::vector<Four<Index>> quads = mesh.quads;
  const QuadSides sides(mesh.vertices.size(), quads);
  Index last = kNone;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    Index first = diagonalOf(mesh, sides, quads[i]);
    if (quads[i][first] == last) first += 2;
    last = quads[i][first];
    mesh.quads[i] = turned(quads[i], first);
    mesh.curves[i] = turned(mesh.curves[i], first);
  }
  return mesh;
}

// The halfedge of a quad's two triangles that is this side.
Index halfedgeOf(Index side) {
  constexpr Four<Index> kOfSide = {0, 1, 4, 5};
  return side / 4 * 6 + kOfSide[side % 4];
}

}  // namespace

WorkingMesh triangulated(const QuadMesh& mesh, const OriginalSurface& surface) {
  const QuadMesh turned = turnedToDiagonals(mesh);
  const QuadSides sides(turned.vertices.size(), turned.quads);
  WorkingMesh::Parts parts;
  parts.places = turned.vertices;
  parts.twins.assign(6 * turned.quads.size(), kNone);
  parts.curves.assign(6 * turned.quads.size(), kNone);
  for (Index i = 0; i < turned.quads.size(); ++i) {
    const auto& [a, b, c, d] = turned.quads[i];
    parts.triangles.insert(parts.triangles.end(), {a, b, c, a, c, d});
    parts.twins[6 * i + 2] = 6 * i + 3;
    parts.twins[6 * i + 3] = 6 * i + 2;
  }
  for (Index side = 0; side < sides.size(); ++side) {
    const Index h = halfedgeOf(side), other = sides.across(side);
    parts.curves[h] = turned.curves[side / 4][side % 4];
    if (other != kNone) parts.twins[h] = halfedgeOf(other);
  }
  return WorkingMesh(surface, parts);
}

}  // namespace remesher
