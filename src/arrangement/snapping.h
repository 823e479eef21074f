// SPDX-License-Identifier: MIT
// Parts of a closed surface that lie on each other but for a few roundings get the same points, and
// so the same edges and triangles: then they cancel, or count as one. This is done only near
// triangles that intersect, in the manner of snap rounding.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "arrangement/cells.h"

namespace remesher {

struct SnapRule {
  double tolerance = 0;                      // nearer points, edges and facets are brought together
  std::function<Vec3(const Vec3&)> rounded;  // a place in numbers that can be written
  // Steps, as of the arrangement. Where the tolerance is as wide as facets, any point divides all
  // facets around it, and these are divided again.
  std::size_t mostWork = std::numeric_limits<std::size_t>::max();
};

// crossing: facets that intersect others. New points follow the given ones; no point moves, but
// corners become other points within the tolerance. False if it would take more than the most work:
// then the facets are left halfway.
bool snapTogether(std::vector<Vec3>& positions, KeptFacets& facets, std::span<const Index> crossing,
                  const SnapRule& rule);

}  // namespace remesher
