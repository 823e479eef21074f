// SPDX-License-Identifier: MIT
// The smallest angles of the triangles that a change is about, in radians: what decides whether it
// is worth it. What is a line in the numbers that are written has none, where a grain is given.
#pragma once

#include "remesh/gate/fidelity.h"
#include "remesh/operators/star.h"

namespace remesher {

// The one ladder of smallest angles, rung by rung: a triangle that is made only for want of a
// better one (sliver); that a lost tip or a bound is worth until it is mended (poor, fair); that a
// move for the sake of distances must leave (sound), for polishing lifts it to where it is left
// alone (fine); that such a move leaves if it can (good, even). The rung `sound` cannot move
// without changing the bytes of `rounds`.
inline constexpr double kSliver = radians(8), kPoor = radians(20), kFair = radians(30),
                        kSound = radians(33.2), kFine = radians(35), kGood = radians(42),
                        kEven = radians(50);

double smallestAngle(const WorkingMesh& mesh, Face f, const Grain& grain = {});

// An angle up to 60° that all triangles are compared with: most are seen to be wider without
// working theirs out.
class AngleLimit {
 public:
  explicit AngleLimit(double angle);

  // Whether the smallest angle of f is less.
  bool isAbove(const WorkingMesh& mesh, Face f, const Grain& grain = {}) const;
  // Whether that of a triangle around the star's centre is, or is hardly more, were it there.
  bool isAboveAround(const Star& star, const Vec3& center) const;

 private:
  bool isSurelyBelow(const Vec3& ab, const Vec3& ac) const;

  double angle_, squaredTangent_;
};

// Of the triangles that a proposal makes, and of those that it takes away. An angle that is not
// `beyond` answers for all that come.
double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change,
                           const Grain& grain = {}, double beyond = -1);
double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change,
                          const Grain& grain = {});

// Of the triangles around v, were v at `position`.
double smallestAngleAround(const WorkingMesh& mesh, Vertex v, const Vec3& position);

}  // namespace remesher
