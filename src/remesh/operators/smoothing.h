// SPDX-License-Identifier: MIT
// Where a vertex should go, in the plane of its polar map (the vertex itself is the origin).
#pragma once

#include <span>

#include "geometry/polar_map.h"

namespace remesher {

// The point p that minimises Σ (A_i(p) − μ_i ΣA)² over the star's triangles [report, "Area Based
// Vertex Relocation"], by QR decomposition. μ: one weight per triangle of the map, any positive
// scale.
Vec2 areaBasedTarget(const PolarMap& star, std::span<const double> mu);

// The mean of the neighbours [report, "Laplacian Smoothing"].
Vec2 laplacianTarget(const PolarMap& star);

// An angle below this costs a triangle more than others gain by it: of the seven at a vertex none
// can have a larger one.
inline constexpr double kWideAngle = radians(50.3);

// A place, found by search, where the smallest angles of the triangles are larger on the whole, and
// none far below kWideAngle; the origin where none is better.
Vec2 wideTarget(const PolarMap& star);

}  // namespace remesher
