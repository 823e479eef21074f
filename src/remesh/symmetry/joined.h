// SPDX-License-Identifier: MIT
// Joins quads of a half and their mirror images to the quads of a whole, which has the attributes
// of the input on all sides.
#pragma once

#include <optional>

#include "remesh/symmetry/half.h"
#include "remesh/transfer/input_attributes.h"

namespace remesher {

// A mesh of quads, and the place on the original of each corner of its triangles.
struct PlacedQuads {
  TriangleMesh mesh;
  std::vector<InputPlace> places;
};

// Whether the images must make a surface of the input's kind, or of any.
enum class Kind { AsGiven, Any };

struct JoinGoal {
  const Mirrors& mirrors;
  Kind kind = Kind::AsGiven;
};

// made: quads of the half; whole: of the input that was cut. None if the images do not join to a
// surface of the kind.
std::optional<PlacedQuads> joinedImages(const PlacedQuads& made, const Half& half,
                                        const JoinGoal& goal, const InputAttributes& whole);

}  // namespace remesher
