// SPDX-License-Identifier: MIT
// The smallest angles of the triangles that a change is about, in radians: what decides whether it
// is worth it.
#pragma once

#include "operators/local_change.h"

namespace remesher {

double smallestAngle(const WorkingMesh& mesh, Face f);

// Of the triangles that a proposal makes, and of those that it takes away. An angle that is not
// `beyond` answers for all that come.
double smallestComingAngle(const WorkingMesh& mesh, const LocalChange& change, double beyond = -1);
double smallestGoingAngle(const WorkingMesh& mesh, const LocalChange& change);

// Of the triangles around v, were v at `position`.
double smallestAngleAround(const WorkingMesh& mesh, Vertex v, const Vec3& position);

}  // namespace remesher
