// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/triangulated.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/quad.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

bool areJoined(const QuadSides& sides, Index a, Index b) {
  bool found = false;
  sides.forEachOutgoing(
      a, [&](Index side) { found |= sides.tip(side) == b || sides.origin(prevSide(side)) == b; });
  return found;
}

using Pairs = std::map<std::pair<Index, Index>, std::size_t>;

// The same, but no edge that is elsewhere already. used: how often each diagonal is.
Index diagonalBeside(const QuadMesh& mesh, const QuadSides& sides, const Four<Index>& quad,
                     Pairs& used) {
  const Index nearer = diagonalOf(mesh, quad);
  const auto ends = [&](Index k) { return std::minmax(quad[k], quad[k + 2]); };
  const bool isElsewhere =
      areJoined(sides, quad[nearer], quad[nearer + 2]) || used.find(ends(nearer)) != used.end();
  const Index k = isElsewhere ? 1 - nearer : nearer;
  ++used[ends(k)];
  return k;
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
  Pairs used;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    Index first = diagonalBeside(mesh, sides, quads[i], used);
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

// The first corner of half a turn or more, nearly: 0 to 3, or 4.
Index straightCorner(const QuadMesh& mesh, const Four<Index>& quad) {
  Quad places;
  for (std::size_t i = 0; i < 4; ++i) places[i] = mesh.position(quad[i]);
  const Quad normals = cornerNormals(places);
  const Vec3 own = areaVector(places).normalized();
  for (Index i = 0; i < 4; ++i) {
    const Vec3 out = places[(i + 1) % 4] - places[i], in = places[(i + 3) % 4] - places[i];
    if (normals[i].dot(own) < kLeastSine && out.dot(in) < 0) return i;
  }
  return 4;
}

}  // namespace

// A line bulges over a surface by an eighth of its length times the change of the normals along it.
Index diagonalOf(const QuadMesh& mesh, const Four<Index>& quad) {
  if (const Index straight = straightCorner(mesh, quad); straight < 4) return straight % 2;
  const bool hasNormals = std::all_of(quad.begin(), quad.end(), [&](Index v) {
    return mesh.vertices[v].kind == VertexKind::Interior;
  });
  const auto badness = [&](Index k) {
    const Placement &a = mesh.vertices[quad[k]], &b = mesh.vertices[quad[k + 2]];
    const Vec3 along = b.position - a.position;
    return hasNormals ? std::abs(along.dot(b.normal - a.normal)) : along.norm();
  };
  return badness(1) < badness(0) ? 1 : 0;
}

std::vector<Index> trianglesOf(const QuadMesh& mesh) {
  std::vector<Index> corners;
  for (const Four<Index>& quad : mesh.quads) {
    const Index k = diagonalOf(mesh, quad), a = quad[k], c = quad[k + 2];
    corners.insert(corners.end(), {a, quad[k + 1], c, a, c, quad[(k + 3) % 4]});
  }
  return corners;
}

double meanSide(const QuadMesh& mesh) {
  double sum = 0;
  for (const Four<Index>& quad : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i)
      sum += (mesh.position(quad[(i + 1) % 4]) - mesh.position(quad[i])).norm();
  return sum / double(4 * mesh.quads.size());
}

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
