// SPDX-License-Identifier: MIT
#include "gate/angles.h"

#include <algorithm>
#include <limits>

#include "geometry/triangle.h"

namespace remesher {

double smallestAngle(const WorkingMesh& mesh, Face f) {
  const auto [a, b, c] = mesh.mesh().vertices(f);
  return minAngle(mesh.position(a), mesh.position(b), mesh.position(c));
}

double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change, double beyond) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : change.coming) {
    smallest = std::min(smallest, minAngle(at(a), at(b), at(c)));
    if (smallest <= beyond) break;
  }
  return smallest;
}

double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Face f : change.going) smallest = std::min(smallest, smallestAngle(mesh, f));
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
