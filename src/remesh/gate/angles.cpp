// SPDX-License-Identifier: MIT
#include "remesh/gate/angles.h"

#include <algorithm>

#include "geometry/extremes.h"
#include "geometry/fast_trigonometry.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

double angleAsWritten(const Triangle& t, const Quantum& quantum) {
  return quantum.size > 0 && isLine(t, quantum) ? 0 : minAngle(t[0], t[1], t[2]);
}

}  // namespace

double smallestAngle(const WorkingMesh& mesh, Face f, const Quantum& quantum) {
  return angleAsWritten(mesh.corners(f), quantum);
}

AngleLimit::AngleLimit(double angle) : angle_(angle) {
  constexpr double kSurely = 1 + 1e-5;  // rounding changes no answer
  const Vec2 at = onUnitCircle(angle);
  squaredTangent_ = kSurely * at.y() * at.y() / (at.x() * at.x());
}

bool AngleLimit::isSurelyBelow(const Vec3& ab, const Vec3& ac) const {
  const double b = ab.squaredNorm(), c = ac.squaredNorm(), a = (ac - ab).squaredNorm();
  // The cosine of the angle opposite the shortest side times its two sides; the sine times them
  // follows.
  const double cosine = 0.5 * (a + b + c) - least(a, b, c);
  return ab.cross(ac).squaredNorm() > squaredTangent_ * cosine * cosine;
}

bool AngleLimit::isAbove(const WorkingMesh& mesh, Face f, const Quantum& quantum) const {
  const Triangle t = mesh.corners(f);
  const bool isFlat = quantum.size > 0 && isLine(t, quantum);
  return isFlat ||
         (!isSurelyBelow(t[1] - t[0], t[2] - t[0]) && minAngle(t[0], t[1], t[2]) < angle_);
}

bool AngleLimit::isAboveAround(const Star& star, const Vec3& center) const {
  Vec3 before = star.position(star.size() - 1) - center;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec3 spoke = star.position(i) - center;
    if (!isSurelyBelow(before, spoke)) return true;
    before = spoke;
  }
  return false;
}

double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change,
                           const Quantum& quantum, double beyond) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  double smallest = kInfinity;
  for (const auto& [a, b, c] : change.coming) {
    smallest = std::min(smallest, angleAsWritten({at(a), at(b), at(c)}, quantum));
    if (smallest <= beyond) break;
  }
  return smallest;
}

double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change,
                          const Quantum& quantum) {
  double smallest = kInfinity;
  for (const Face f : change.going) smallest = std::min(smallest, smallestAngle(mesh, f, quantum));
  return smallest;
}

double smallestAngleAround(const WorkingMesh& mesh, Vertex v, const Vec3& position) {
  double smallest = kInfinity;
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    smallest = std::min(smallest, minAngle(position, mesh.position(mesh.mesh().tip(h)),
                                           mesh.position(mesh.mesh().opposite(h))));
  });
  return smallest;
}

}  // namespace remesher
