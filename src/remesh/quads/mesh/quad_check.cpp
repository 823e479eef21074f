// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_check.h"

#include <vector>

#include "base/disjoint_sets.h"
#include "mesh/topology.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

bool hasFourCorners(const Four<Index>& quad, std::size_t vertexCount) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (quad[i] >= vertexCount) return false;
    for (std::size_t k = i + 1; k < 4; ++k)
      if (quad[i] == quad[k]) return false;
  }
  return true;
}

std::size_t countLoops(const QuadSides& sides) {
  std::size_t count = 0;
  std::vector<char> seen(sides.size(), 0);
  for (Index i = 0; i < sides.size(); ++i) {
    if (sides.across(i) != kNone || seen[i]) continue;
    ++count;
    for (Index side = i; !seen[side]; side = sides.outgoing(sides.tip(side))) seen[side] = 1;
  }
  return count;
}

}  // namespace

SurfaceKind kindOf(const HalfedgeMesh& mesh) {
  return {eulerCharacteristic(mesh), componentCount(mesh), boundaryLoopCount(mesh)};
}

SurfaceKind kindOf(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  DisjointSets pieces(mesh.vertices.size());
  std::size_t edges = 0, components = mesh.vertices.size();
  for (Index side = 0; side < sides.size(); ++side) {
    edges += sides.across(side) == kNone || side < sides.across(side);
    components -= pieces.unite(sides.origin(side), sides.tip(side));
  }
  const long euler = long(mesh.vertices.size()) - long(edges) + long(mesh.quads.size());
  return {euler, components, countLoops(sides)};
}

std::string check(const QuadMesh& mesh) {
  if (mesh.curves.size() != mesh.quads.size()) return "not every quad has its curves";
  for (const Four<Index>& quad : mesh.quads)
    if (!hasFourCorners(quad, mesh.vertices.size())) return "a quad has not four corners";
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  for (Index v = 0; v < mesh.vertices.size(); ++v)
    if (sides.outgoing(v) == kNone) return "a vertex is in no quad";
  if (!sides.isManifold()) return "the quads are no manifold";
  for (Index v = 0; v < mesh.vertices.size(); ++v)
    if (!sides.isBoundary(v) && sides.valence(v) < 3) return "two quads share two sides";
  for (Index side = 0; side < sides.size(); ++side) {
    const Index other = sides.across(side);
    if (other != kNone && mesh.curves[side / 4][side % 4] != mesh.curves[other / 4][other % 4])
      return "the two sides of an edge are on different curves";
  }
  return {};
}

}  // namespace remesher
