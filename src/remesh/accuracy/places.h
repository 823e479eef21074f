// SPDX-License-Identifier: MIT
// Places spread over the original, and how far the mesh is from each.
#pragma once

#include <vector>

#include "remesh/steps/run.h"

namespace remesher {

struct Place {
  SurfacePoint original;
  Vec3 position;    // of the point of the original
  Face nearest;     // of the mesh, where a walk from the vertices that lie around the place ends
  double distance;  // to that triangle
};

// The original's vertices and, where its triangles are large, points inside them, no farther apart
// than half a target edge; of these the ones that are not nearer to the mesh than `enough` target
// lengths. A walk stays on the sheet it starts on, so a distance can only be too large. What is
// `surely` as near to a tangent plane of the mesh is not looked at.
std::vector<Place> measurePlaces(const Run& run, double enough, double surely);

// Where the place is now, by a walk from the triangle that was nearest.
void measureAgain(const WorkingMesh& mesh, Place& place);

}  // namespace remesher
