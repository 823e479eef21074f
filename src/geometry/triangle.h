// SPDX-License-Identifier: MIT
// A triangle in space and its measures. Angles in radians.
#pragma once

#include <array>

#include "base/types.h"

namespace remesher {

using Triangle = std::array<Vec3, 3>;

// Out of line for files compiled for size: inlined there, each vector operator would be a call.
double distance(const Vec3& a, const Vec3& b);
// Twice the area times the unit normal.
Vec3 areaVector(const Vec3& a, const Vec3& b, const Vec3& c);
double area(const Vec3& a, const Vec3& b, const Vec3& c);
// Whether two of the corners lie in one place.
bool hasTwins(const Vec3& a, const Vec3& b, const Vec3& c);

// The unit normal; zero for a triangle without area.
Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c);

// Twice the area over the longest edge squared: at most 0.87, and 0 for a line.
double flatness(const Vec3& a, const Vec3& b, const Vec3& c);
// A triangle of this flatness or less counts as a line: a few hundred roundings of double.
inline constexpr double kFlattest = 1e-13;

// The angles at a, b and c. A triangle without area has angles 0 and π.
std::array<double, 3> angles(const Vec3& a, const Vec3& b, const Vec3& c);
double minAngle(const Vec3& a, const Vec3& b, const Vec3& c);

// Barycentric coordinates of the point of the closed triangle nearest to p [Ericson, Real-Time
// Collision Detection, §5.1.5]. Works for triangles without area.
Vec3 closestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
Vec3 closestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace remesher
