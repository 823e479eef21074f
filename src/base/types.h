// SPDX-License-Identifier: MIT
// The types that every layer uses: vectors, indices, angles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <numbers>

namespace remesher {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Index = std::uint32_t;
using Transform = Eigen::Affine3d;

inline constexpr Index kNone = ~Index{0};
// What rounding may make of numbers about 1 in some steps of double precision, and far more.
inline constexpr double kRoundOff = 1e-9;
// The same in single precision, in which most models are stored.
inline constexpr double kSingleRoundOff = 1e-6;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Signed area of the parallelogram that a and b span: positive where b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

inline constexpr double kQuarterTurn = std::numbers::pi / 2;

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace remesher
