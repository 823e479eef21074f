// SPDX-License-Identifier: MIT
#include "remesh/gate/sharp_tips.h"

#include "geometry/fast_trigonometry.h"

namespace remesher {

bool isSharpTip(const WorkingMesh& mesh, Vertex v, double angle) {
  const HalfedgeMesh& m = mesh.mesh();
  const double least = (m.isBoundary(v) ? 1 : 3) * angle;
  double sum = 0;
  m.forEachOutgoing(v, [&](Halfedge h) {
    if (sum >= least) return;
    const Vec3 a = mesh.position(m.tip(h)) - mesh.position(v);
    const Vec3 b = mesh.position(m.opposite(h)) - mesh.position(v);
    sum += angleOf(a.cross(b).norm(), a.dot(b));
  });
  return sum < least;
}

bool blunts(const WorkingMesh& mesh, const LocalChange& change, double angle) {
  if (change.operation == Operation::Relocate) return isSharpTip(mesh, change.vertex, angle);
  if (change.operation != Operation::Collapse) return false;
  const Vertex gone = mesh.mesh().origin(change.halfedge), kept = mesh.mesh().tip(change.halfedge);
  return isSharpTip(mesh, gone, angle) ||
         (change.place.position != mesh.position(kept) && isSharpTip(mesh, kept, angle));
}

}  // namespace remesher
