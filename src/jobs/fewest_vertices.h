// SPDX-License-Identifier: MIT
// Remeshes to a bound on the distance without a number: to as few vertices as the bound allows.
#pragma once

#include <cmath>

#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// A search for the smallest number that suffices, where each number must be tried: the numbers
// between which it lies. From some number on nearly all suffice; where one beyond does not, the
// search ends all the same, at a number that suffices, beside one that does not.
struct Bracket {
  double fails = 0;  // the largest known not to suffice; 0 if none is known
  double does = 0;   // the smallest known to suffice; 0 if none is known

  bool isClosed() const { return fails > 0 && does > 0; }

  // Whether the number that suffices is at most so many times the other.
  bool isWithin(double ratio) const { return isClosed() && does <= ratio * fails; }

  // Whether no whole number lies between them.
  bool isEmpty() const { return isClosed() && does - fails <= 1; }

  // The number to try next: the geometric mean of both, or `step` times smaller or larger than the
  // one that is known.
  double next(double step) const {
    if (isClosed()) return std::sqrt(fails * does);
    return does > 0 ? does / step : fails * step;
  }
};

// Whether the options give a number of vertices, in any way.
bool hasNumber(const PartOptions& options);

// Whether the options give a bound and no number (scheme best). For quads and for a shape that is
// preferred they may give a number, which is raised as the bound needs: neither is made within a
// bound, but measured.
bool asksForFewest(const PartOptions& options);

// Drafts find the number within a tenth; if no draft keeps the bound, the vertices that the shape
// needs are taken, or if they may not be, the input's own number.
// Of a raised number the outcome says MaxError, also if no number is enough. ISOTROPIC_TAKES_MORE,
// if the input's own triangles are taken, and uneven. Throws the Errors of remeshSurface.
RemeshOutcome remeshToFewest(const TriangleMesh& input, Welding welding, const PartOptions& options,
                             const Progress& progress);

// The options that levels of detail take shares of. If the finest level's number was searched for,
// or is above the input's because none was given, they have that number and no bound, which fewer
// vertices would not keep.
PartOptions optionsOfLevels(PartOptions options, const Report& finest);

}  // namespace remesher
