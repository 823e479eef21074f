// SPDX-License-Identifier: MIT
#include "gate/angles.h"

#include <algorithm>
#include <limits>

#include "geometry/triangle.h"

namespace remesher {

namespace {

double angleAsWritten(const Triangle& t, const Grain& grain) {
  return grain.size > 0 && isLine(t, grain) ? 0 : minAngle(t[0], t[1], t[2]);
}

}  // namespace

double smallestAngle(const WorkingMesh& mesh, Face f, const Grain& grain) {
  return angleAsWritten(mesh.corners(f), grain);
}

double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change, const Grain& grain,
                           double beyond) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : change.coming) {
    smallest = std::min(smallest, angleAsWritten({at(a), at(b), at(c)}, grain));
    if (smallest <= beyond) break;
  }
  return smallest;
}

double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change, const Grain& grain) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Face f : change.going) smallest = std::min(smallest, smallestAngle(mesh, f, grain));
  return smallest;
}

double smallestAngleAround(const WorkingMesh& mesh, Vertex v, const Vec3& position) {
  double smallest = std::numeric_limits<double>::infinity();
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    smallest = std::min(smallest, minAngle(position, mesh.position(mesh.mesh().tip(h)),
                                           mesh.position(mesh.mesh().opposite(h))));
  });
  return smallest;
}

}  // namespace remesher
