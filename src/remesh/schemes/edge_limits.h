// SPDX-License-Identifier: MIT
// Limits of every edge and triangle: what they mean for sizes, for the number of vertices where
// none is asked for, and for the end of a run.
#pragma once

#include "base/part_options.h"
#include "base/unmet.h"
#include "remesh/steps/wanted.h"

namespace remesher {

struct SizeBounds {
  double shortest = 0, longest = kInfinity;
};

// The bounds on sizes with which about all edges are as long as wanted; where too little lies
// between the two, the size between them.
SizeBounds sizeBounds(const PartOptions& options);

// As few vertices as the longest edge allows, of a surface of such an area; without a longest edge
// `own`, the input's number, or as many as the shortest allows.
double numberByEdges(const PartOptions& options, double area, double own);

// See keepWanted and unmetOf; without limits they do nothing.
void keepLimits(Run& run, const PartOptions& options, Number number);
Unmet unmetLimits(const Run& run, const PartOptions& options);

}  // namespace remesher
