// SPDX-License-Identifier: MIT
// The parts of space that facets separate, each with its winding number for each operand.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/facets.h"

namespace remesher {

// Whether a place is inside, by the winding number of each operand there: how often its surface
// goes round the place, counterclockwise seen from outside.
using InsideRule = std::function<bool(std::span<const int>)>;

struct KeptFacets {
  std::vector<Index> corners;     // three per facet, counterclockwise seen from outside
  std::vector<FacetParent> from;  // per facet: a triangle that contains it
};

struct InsideBoundary {
  KeptFacets kept;
  std::vector<Index> facets;      // per kept facet its number among all
  bool isOutsideDropped = false;  // whether some went that have no inside on either side
  std::size_t work = 0;
};

// The facets that have the inside on one of their sides only, in their order.
InsideBoundary boundaryOfInside(PointPool& points, const ArrangedTriangles& triangles,
                                const Facets& facets, const InsideRule& isInside);

}  // namespace remesher
