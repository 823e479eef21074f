// SPDX-License-Identifier: MIT
// Where a vertex should go, in the plane of its polar map (the vertex itself is the origin).
#pragma once

#include <span>

#include "geometry/polar_map.h"

namespace remesher {

// The point p that minimises Σ (A_i(p) − μ_i ΣA)² over the star's triangles [DGP 2016, "Area Based
// Vertex Relocation"], by QR decomposition. μ: one weight per triangle of the map, any positive
// scale.
Vec2 areaBasedTarget(const PolarMap& star, std::span<const double> mu);

// The mean of the neighbours [DGP 2016, "Laplacian Smoothing"].
Vec2 laplacianTarget(const PolarMap& star);

// A smallest angle below this is penalised more than other triangles gain by it. Of seven triangles
// around a vertex not all can have one much larger.
inline constexpr double kWideAngle = radians(50.3);

// A vertex on a curve stays this share of the way between its neighbours along the curve away from
// either.
inline constexpr double kRoom = 0.33;

// A point, found by search, that raises the smallest angles of the star's triangles on the whole
// and leaves none far below kWideAngle; the origin if no point is better.
Vec2 wideTarget(const PolarMap& star);

}  // namespace remesher
