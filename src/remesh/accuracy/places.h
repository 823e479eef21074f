// SPDX-License-Identifier: MIT
// Places spread over the original, and how far the mesh is from each.
#pragma once

#include <vector>

#include "remesh/steps/run.h"

namespace remesher {

// A walk may end in a local minimum: for places farther than this, in target edge lengths, more is
// looked through.
inline constexpr double kDoubtful = 0.2;

struct Place {
  SurfacePoint original;
  Vec3 position;    // of the point of the original
  Face nearest;     // of the mesh, where a walk from vertices around the place ends
  double distance;  // to that triangle
};

// Samples the original: its vertices and, in large triangles, points no farther apart than half a
// target edge. Returns the samples that are not nearer to the mesh than `enough` target lengths. A
// walk stays on the sheet it starts on, so a distance can only be too large. Samples nearer than
// `surely` target lengths to a tangent plane of the mesh are skipped.
std::vector<Place> measurePlaces(const Run& run, double enough, double surely);

}  // namespace remesher
