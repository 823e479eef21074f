// SPDX-License-Identifier: MIT
// Widens angles: vertices move within their facets and along lines, and edges flip.
#pragma once

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// So many passes draw needles apart and even a mesh out.
inline constexpr int kSmoothingPasses = 4;

void smoothFacets(FacetedMesh& mesh, int passes = kSmoothingPasses);

// The smallest angle of a triangle in a plane, in radians.
double smallestFlatAngle(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace remesher
