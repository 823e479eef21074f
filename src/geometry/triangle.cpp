// SPDX-License-Identifier: MIT
#include "geometry/triangle.h"

#include <algorithm>
#include <cmath>

namespace remesher {

Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = areaVector(a, b, c);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

std::array<double, 3> angles(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twiceArea = areaVector(a, b, c).norm();
  return {std::atan2(twiceArea, (b - a).dot(c - a)), std::atan2(twiceArea, (c - b).dot(a - b)),
          std::atan2(twiceArea, (a - c).dot(b - c))};
}

double minAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Opposite the shortest edge.
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double shortest = std::min({ab, bc, ca});
  return std::atan2(areaVector(a, b, c).norm(), 0.5 * (ab + bc + ca - 2 * shortest));
}

double maxAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double longest = std::max({ab, bc, ca});
  return std::atan2(areaVector(a, b, c).norm(), 0.5 * (ab + bc + ca - 2 * longest));
}

namespace {

Vec3 closestOnEdge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return {1 - t, t, 0};
}

Vec3 closestOnAnyEdge(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = closestOnEdge(p, a, b), bc = closestOnEdge(p, b, c), ca = closestOnEdge(p, c, a);
  const std::array<Vec3, 3> candidates = {Vec3(ab[0], ab[1], 0), Vec3(0, bc[0], bc[1]),
                                          Vec3(ca[1], 0, ca[0])};
  return *std::min_element(candidates.begin(), candidates.end(), [&](const Vec3& x, const Vec3& y) {
    const auto distance = [&](const Vec3& w) {
      return (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
    };
    return distance(x) < distance(y);
  });
}

}  // namespace

Vec3 closestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = areaVector(a, b, c);
  const double n2 = n.squaredNorm();
  if (n2 > 0) {
    const double wa = areaVector(p, b, c).dot(n) / n2, wb = areaVector(a, p, c).dot(n) / n2;
    const double wc = 1 - wa - wb;
    if (wa >= 0 && wb >= 0 && wc >= 0) return {wa, wb, wc};
  }
  return closestOnAnyEdge(p, a, b, c);
}

}  // namespace remesher
