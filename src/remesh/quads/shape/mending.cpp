// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/mending.h"

#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

// Joins the two quads at a vertex; false if the quads share one more corner.
bool joinAt(QuadMesh& mesh, const QuadSides& sides, Index v, std::vector<char>& isGone) {
  const Index out = sides.outgoing(v), other = sides.across(out);
  const Index first = out / 4, second = other / 4;
  if (isGone[first] || isGone[second] || first == second) return false;
  const Index across = prevSide(other);  // it leaves the corner across from v
  const Index corner = sides.origin(across);
  for (const Index w : mesh.quads[first])
    if (w == corner) return false;
  // The corner takes the place of v, with the sides that end and begin there.
  mesh.quads[first][out % 4] = corner;
  mesh.curves[first][out % 4] = mesh.curves[second][across % 4];
  mesh.curves[first][prevSide(out) % 4] = mesh.curves[second][prevSide(across) % 4];
  isGone[second] = 1;
  return true;
}

bool isOnCurve(const QuadMesh& mesh, const QuadSides& sides, Index v) {
  bool isFound = false;
  sides.forEachOutgoing(v,
                        [&](Index side) { isFound |= mesh.curves[side / 4][side % 4] != kNone; });
  return isFound;
}

}  // namespace

void removeDoublets(QuadMesh& mesh) {
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    const std::vector<Four<Index>> quads = mesh.quads;
    const QuadSides sides(mesh.vertices.size(), quads);
    std::vector<char> isGone(quads.size(), 0), isTouched(quads.size(), 0);
    for (Index v = 0; v < mesh.vertices.size(); ++v) {
      if (sides.outgoing(v) == kNone || sides.isBoundary(v) || sides.valence(v) != 2) continue;
      if (isOnCurve(mesh, sides, v)) continue;
      const Index a = sides.outgoing(v) / 4, b = sides.across(sides.outgoing(v)) / 4;
      if (isTouched[a] || isTouched[b]) continue;
      isTouched[a] = isTouched[b] = 1;
      isChanged |= joinAt(mesh, sides, v, isGone);
    }
    dropQuads(mesh, isGone);
  }
}

}  // namespace remesher
