// SPDX-License-Identifier: MIT
// The boundary of all that is inside, exactly: closed surfaces are cut along each other, and the
// winding number of each operand says which parts bound the inside. So the union of bodies, their
// intersection or difference is found, and the outside of a surface that intersects itself
// [Zhou et al. 2016]. What nothing cuts comes back bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/cells.h"
#include "base/frame.h"
#include "base/types.h"

namespace remesher {

// For surfaces of one operand: outside is where the winding number is 0 or less.
bool isWound(std::span<const int> windings);

struct ArrangementInput {
  std::vector<Vec3> positions;  // all different
  std::vector<Index> indices;   // three per triangle; every triangle has an area (see hasArea)
  std::vector<Index> operands;  // one per triangle
  // One per triangle, or empty: facets are merged only with those of the same class.
  std::vector<Index> classes;
  KnownMeetings known;
};

struct ArrangementOptions {
  InsideRule isInside = isWound;
  bool isSingle = false;     // new points in single precision of the written coordinates
  Frame frame = {};          // of the coordinates, as in TriangleMesh
  bool wantsWeights = true;  // of corners that are not their parent's; else these are 0
  std::size_t mostWork = std::size_t{1} << 31;  // steps: pairs of triangles, points, flips, signs
};

struct ArrangedTriangle {
  Index parent = kNone;   // the triangle of the input in whose plane it lies
  bool isTurned = false;  // over, against its parent
  // Per corner its weights at the parent's corners. In the parent's plane, but outside the parent
  // where facets of several triangles were merged.
  std::array<Vec3, 3> weights;
  bool isUntouched = false;  // it met no other triangle, and is as it was given
};

struct ArrangementResult {
  enum class Outcome {
    Done,
    NotClosed,  // the edges of an operand do not cancel, each against one of the other direction
    GaveUp,     // it would take more than the most work
  };
  Outcome outcome = Outcome::Done;
  std::vector<Vec3> positions;  // first those of the input; not all of them need be used
  std::vector<Index> indices;
  std::vector<ArrangedTriangle> triangles;
  std::size_t cut = 0;      // triangles of the input that met others
  std::size_t dropped = 0;  // triangles of the input that the result has no part of
  // Whether parts of triangles went that have no inside on either side: all others are hidden.
  bool isOutsideDropped = false;
  // Triangles of the result that meet others beyond common corners and edges, by rounding.
  std::vector<Index> selfIntersections;
  std::size_t work = 0;
};

ArrangementResult arrange(const ArrangementInput& input, const ArrangementOptions& options);

}  // namespace remesher
