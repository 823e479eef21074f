// SPDX-License-Identifier: MIT
// Parts of a closed surface that lie on each other but for a few roundings get the same points, and
// so the same edges and triangles: then they cancel, or count as one. This is done only near
// triangles that intersect, in the manner of snap rounding.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "arrangement/cells.h"

namespace remesher {

struct SnapRule {
  double tolerance = 0;                      // nearer points, edges and facets are brought together
  std::function<Vec3(const Vec3&)> rounded;  // a place in numbers that can be written
};

// crossing: facets that intersect others. New points follow the given ones; no point moves, but
// corners become other points within the tolerance.
void snapTogether(std::vector<Vec3>& positions, KeptFacets& facets, std::span<const Index> crossing,
                  const SnapRule& rule);

}  // namespace remesher
