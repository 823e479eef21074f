// SPDX-License-Identifier: MIT
// What tells places apart: two vertices are at one place if what is here made of them is equal.
// What programs make of a full turn seldom meets its beginning.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// The sine of a whole turn comes out as -2.4e-16: beside the largest coordinate of its place, what
// is no more than a few such roundings is zero.
inline Vec3 canonicalPlace(const Vec3& p) {
  constexpr double kRounding = 0x1p-50;
  const double nothing = kRounding * std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  const auto rounded = [nothing](double c) { return std::abs(c) <= nothing ? 0 : c; };
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

// Per vertex the first vertex at its place. Positions must be finite.
std::vector<Index> weld(std::span<const Vec3> positions);

// How many places there are.
std::size_t countPlaces(std::span<const Vec3> positions);

}  // namespace remesher
