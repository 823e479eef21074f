// SPDX-License-Identifier: MIT
// The words every layer speaks: vectors, indices, angles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <numbers>

namespace remesher {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Index = std::uint32_t;
using Transform = Eigen::Affine3d;

inline constexpr Index kNone = ~Index{0};

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace remesher
