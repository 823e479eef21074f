// SPDX-License-Identifier: MIT
// When two vertices are at one place: when their canonicalPlace() is equal. Programs that compute a
// full turn seldom end exactly where the turn began.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Rounds tiny coordinates to zero: the sine of a full turn comes out as -2.4e-16. A coordinate is
// tiny if it is at most a few such roundings of the place's largest coordinate.
inline Vec3 canonicalPlace(const Vec3& p) {
  constexpr double kRounding = 0x1p-50;
  const double nothing = kRounding * std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  const auto rounded = [nothing](double c) { return std::abs(c) <= nothing ? 0 : c; };
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

// Per vertex the first vertex at its place. Positions must be finite.
std::vector<Index> weld(std::span<const Vec3> positions);

// The number of different places.
std::size_t countPlaces(std::span<const Vec3> positions);

}  // namespace remesher
