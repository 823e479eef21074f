// SPDX-License-Identifier: MIT
// The share of the visible surface of bodies that their union has lost. Beyond a self-intersection
// a surface may be inverted, and the union has no inside behind it.
#pragma once

#include <span>

#include "base/triangle_mesh.h"

namespace remesher {

// A ratio of the bodies' area: of triangles that the union has no part of, is away from, and that
// are seen from outside. parents: per triangle of the union one of the bodies.
double seenShareLost(const TriangleMesh& bodies, const TriangleMesh& outside,
                     std::span<const Index> parents);

}  // namespace remesher
