// SPDX-License-Identifier: MIT
// Where triangles around one corner of a surface intersect each other, as in a fold, the outside
// meets itself in that corner: its triangles make several fans there.
#pragma once

#include <functional>

#include "arrangement/arrangement.h"

namespace remesher {

struct PartRule {
  std::function<Vec3(const Vec3&)> rounded;  // a place in numbers that can be written
  std::function<std::vector<Index>(const ArrangementResult&)> crossings;
};

// All but the largest of such fans get a corner of their own, a little further into the fan, if
// nothing intersects then. Bodies that touch in a corner stay as they are. The result's
// self-intersections are known.
void partFans(ArrangementResult& result, const ArrangementInput& input, const PartRule& rule);

}  // namespace remesher
