// SPDX-License-Identifier: MIT
// Keeps the result free of self-intersections where the original has none and it must have none.
#pragma once

#include <memory>

#include "remesh/steps/run.h"

namespace remesher {

struct Uncrossed {
  std::unique_ptr<CrossingGuard> guard;  // the run's rule points to it
  bool isReached = true;                 // whether the number of vertices was reached
  std::size_t crossing = 0;              // triangles that intersect others
};

// Mends the scheme's mesh where it intersects itself. If that fails, makes the mesh anew from the
// original by steps that add no intersection, so that none is left that the original lacks. Each
// needle is mended that takes moving the surface by no more than `farthest`.
Uncrossed keepUncrossed(Run& run, std::size_t vertices, double farthest);

// The same without making the mesh anew, which may take long: triangles that cannot be mended where
// they are still meet, as all do where a large share of the mesh does.
Uncrossed mendUncrossed(Run& run, std::size_t vertices);

// As keepUncrossed in place of a scheme, from the original or its proxy, with steps that allow
// tighter folds: for surfaces with so many components and handles that a scheme would run for
// minutes and fail.
Uncrossed makeUncrossed(Run& run, std::size_t vertices, double farthest);

// The same without looking for crossings.
void makeThinned(Run& run, std::size_t vertices);

}  // namespace remesher
