// SPDX-License-Identifier: MIT
// Places that are meant to be one: what differs by rounding around zero, and what the caller calls
// near.
#pragma once

#include <optional>

#include "base/triangle_mesh.h"

namespace remesher {

// What programs leave of zero in coordinates of this size, in the mesh's precision: what is no
// larger may be one to whoever reads them.
double noiseBeside(double size, const TriangleMesh& mesh);

// Vertices that differ in coordinates which are nothing beside the model's size come to one place,
// where no triangle loses a corner by it.
void joinNoise(TriangleMesh& mesh);

// Vertices no farther apart than this come to the place of the first.
void joinNear(TriangleMesh& mesh, double distance);

// Of the box around all corners of triangles.
double diagonalOf(const TriangleMesh& mesh);

// Whether none of several triangles shares an edge with another.
bool isLoose(const TriangleMesh& mesh);

// The smallest of a few distances, in percent of the diagonal, that joins most edges of what is
// loose; the next, as long as that joins more and no triangle goes.
std::optional<double> percentThatJoins(const TriangleMesh& mesh);

}  // namespace remesher
