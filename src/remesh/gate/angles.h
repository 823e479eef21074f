// SPDX-License-Identifier: MIT
// The smallest angles, in radians, of the triangles that a change makes or replaces: they decide
// whether it is worthwhile. With a quantum a triangle that is a line as written has angle 0.
#pragma once

#include "remesh/gate/fidelity.h"
#include "remesh/operators/star.h"

namespace remesher {

// The one ladder of smallest angles. sliver: such a triangle is made only for want of a better one.
// poor, fair: what a lost tip or a bound is worth until the triangle is mended. sound: what a move
// that lowers distances must leave, since polishing lifts it to fine. fine: polishing leaves such a
// triangle alone. good: what a move that lowers distances leaves where it cannot leave kWideAngle.
// Changing `sound` changes the bytes of `rounds`.
inline constexpr double kSliver = radians(8), kPoor = radians(20), kFair = radians(30),
                        kSound = radians(33.2), kFine = radians(35), kGood = radians(42);

// Whether a smallest angle is one that the end of repair mends.
inline bool isNeedle(double smallest) { return smallest < 2 * kSliver; }

double smallestAngle(const WorkingMesh& mesh, Face f, const Quantum& quantum = {});

// A limit up to 60° for the angles of triangles. Most triangles prove to be above it without
// computing their angles.
class AngleLimit {
 public:
  explicit AngleLimit(double angle);

  // Whether the smallest angle of f is less.
  bool isAbove(const WorkingMesh& mesh, Face f, const Quantum& quantum = {}) const;
  // Whether a triangle of the star would have a smaller angle, or a hardly larger one, if the
  // centre were at `center`.
  bool isAboveAround(const Star& star, const Vec3& center) const;

 private:
  bool isSurelyBelow(const Vec3& ab, const Vec3& ac) const;

  double angle_, squaredTangent_;
};

// The smallest angle of the triangles that a proposal makes, and of those that it replaces. The
// search among coming triangles stops at an angle that does not exceed `beyond`.
double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change,
                           const Quantum& quantum = {}, double beyond = -1);
double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change,
                          const Quantum& quantum = {});

// The smallest angle of the triangles around v if v were at `position`.
double smallestAngleAround(const WorkingMesh& mesh, Vertex v, const Vec3& position);

}  // namespace remesher
