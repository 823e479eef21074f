// SPDX-License-Identifier: MIT
#include "geometry/triangle.h"

#include <algorithm>

#include "geometry/extremes.h"
#include "geometry/fast_trigonometry.h"

namespace remesher {

double distance(const Vec3& a, const Vec3& b) { return (b - a).norm(); }

Vec3 areaVector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

double area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * areaVector(a, b, c).norm();
}

bool hasTwins(const Vec3& a, const Vec3& b, const Vec3& c) { return a == b || b == c || c == a; }

Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = areaVector(a, b, c);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double flatness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      greatest((b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm());
  return longest > 0 ? areaVector(a, b, c).norm() / longest : 0;
}

std::array<double, 3> angles(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twiceArea = areaVector(a, b, c).norm();
  return {angleOf(twiceArea, (b - a).dot(c - a)), angleOf(twiceArea, (c - b).dot(a - b)),
          angleOf(twiceArea, (a - c).dot(b - c))};
}

double minAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  // The smallest angle lies opposite the shortest edge.
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double shortest = least(ab, bc, ca);
  return angleOf(areaVector(a, b, c).norm(), 0.5 * (ab + bc + ca - 2 * shortest));
}

namespace {

double squaredDistance(const Vec3& p, const Vec3& w, const Triangle& t) {
  return (w[0] * t[0] + w[1] * t[1] + w[2] * t[2] - p).squaredNorm();
}

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
    return squaredDistance(p, x, {a, b, c}) < squaredDistance(p, y, {a, b, c});
  });
}

}  // namespace

// Tests corners, then the interior, then the edges: cheapest first.
Vec3 closestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Below this squared sine of the angle at a, the interior answer may be rounding: it is taken
  // only if it is nearer than the edges' answer.
  constexpr double kThin = 1e-10;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double abA = ab.dot(ap), acA = ac.dot(ap);
  if (abA <= 0 && acA <= 0) return {1, 0, 0};
  const Vec3 bp = p - b, cp = p - c;
  const double abB = ab.dot(bp), acB = ac.dot(bp);
  if (abB >= 0 && acB <= abB) return {0, 1, 0};
  const double abC = ab.dot(cp), acC = ac.dot(cp);
  if (acC >= 0 && abC <= acC) return {0, 0, 1};

  // The sub-areas, times the whole area, from the products above (Lagrange's identity).
  const double wa = abB * acC - abC * acB, wb = abC * acA - abA * acC, wc = abA * acB - abB * acA;
  if (!(wa > 0 && wb > 0 && wc > 0)) {
    // Distances along bc from b and from c, times the length of bc.
    const double bcB = acB - abB, cbC = abC - acC;
    if (wc <= 0 && abA >= 0 && abB <= 0 && abA > abB) return Vec3(-abB, abA, 0) / (abA - abB);
    if (wb <= 0 && acA >= 0 && acC <= 0 && acA > acC) return Vec3(-acC, 0, acA) / (acA - acC);
    if (wa <= 0 && bcB >= 0 && cbC >= 0 && bcB + cbC > 0) return Vec3(0, cbC, bcB) / (bcB + cbC);
    return closestOnAnyEdge(p, a, b, c);
  }
  const double sum = wa + wb + wc;
  const Vec3 inside = Vec3(wa, wb, wc) / sum;
  // abA - abB is |ab|², acA - acC is |ac|²; the sum is their product times the squared sine at a.
  if (sum > kThin * (abA - abB) * (acA - acC)) return inside;
  const Vec3 outline = closestOnAnyEdge(p, a, b, c);
  return squaredDistance(p, inside, {a, b, c}) < squaredDistance(p, outline, {a, b, c}) ? inside
                                                                                        : outline;
}

Vec3 closestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 w = closestBarycentric(p, a, b, c);
  return w[0] * a + w[1] * b + w[2] * c;
}

}  // namespace remesher
