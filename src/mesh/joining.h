// SPDX-License-Identifier: MIT
// Joins places that are meant to be one: those that differ by rounding around zero, and those
// nearer than a distance that the caller gives.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"
#include "mesh/welding.h"

namespace remesher {

// The rounding error that programs leave instead of zero beside coordinates of this size, in the
// mesh's precision. A reader may take a number no larger for zero.
double noiseBeside(double size, const TriangleMesh& mesh);

// Sets coordinates to zero that are rounding beside the model's size, so that vertices come to one
// place; not where a triangle would lose a corner.
void joinNoise(TriangleMesh& mesh);

// Gives vertices at one place but for noise (see base/place.h) the coordinates of the first.
void unifyPlaces(std::vector<Vec3>& positions);

// Moves vertices no farther apart than this to the place of the first.
void joinNear(TriangleMesh& mesh, double distance);
// The same for some vertices only. isMovable: one per vertex.
void joinNear(TriangleMesh& mesh, double distance, std::span<const char> isMovable);

// Per vertex whether it lies on an open edge.
std::vector<char> openVerticesOf(const TriangleMesh& mesh, const Welding& welding);

// The diagonal of the box around all corners of triangles.
double diagonalOf(const TriangleMesh& mesh);

// Whether there are several triangles and none shares an edge with another.
bool isLoose(const TriangleMesh& mesh);

// The smallest of a few distances, in percent of the diagonal, that joins most edges of a loose
// mesh; then the next ones, as long as each joins more edges and no triangle vanishes.
std::optional<double> percentThatJoins(const TriangleMesh& mesh);

}  // namespace remesher
