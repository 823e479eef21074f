// SPDX-License-Identifier: MIT
#include "remesh/operators/smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/extremes.h"
#include "geometry/pattern_search.h"

namespace remesher {

namespace {

// The least-squares solution of rows (u, v)·p = w. Each row is rotated into the triangular factor R
// as it comes (Givens), so nothing but R and the rotated right side is kept.
class RowQr {
 public:
  void add(double u, double v, double w) {
    rotate(r00_, u, {&r01_, &q0_}, {&v, &w});
    rotate(r11_, v, {&q1_, nullptr}, {&w, nullptr});
  }

  Vec2 solve() const {
    if (!(std::abs(r11_) > kRoundOff * std::abs(r00_))) return Vec2::Zero();
    const double y = q1_ / r11_;
    return {(q0_ - r01_ * y) / r00_, y};
  }

 private:
  using Rest = std::array<double*, 2>;

  // Turns (pivot, entry) into (length, 0) and the rest of the two rows along with it.
  static void rotate(double& pivot, double entry, const Rest& upper, const Rest& lower) {
    const double length = std::sqrt(pivot * pivot + entry * entry);
    if (!(length > 0)) return;
    const double c = pivot / length, s = entry / length;
    pivot = length;
    for (int i = 0; i < 2 && upper[i]; ++i) {
      const double above = *upper[i], below = *lower[i];
      *upper[i] = c * above + s * below;
      *lower[i] = c * below - s * above;
    }
  }

  double r00_ = 0, r01_ = 0, r11_ = 0, q0_ = 0, q1_ = 0;
};

// The cost of a triangle, by the cosine of its smallest angle: by how much this exceeds that of
// kWideAngle, squared. Triangles that are wide enough differ by a trace.
double costOf(double cosine) {
  static const double most = std::cos(kWideAngle);
  const double over = greatest(0, cosine - most);
  return over * over + kRoundOff * cosine;
}

// The cost of all triangles if the vertex were at p; infinite if one would turn over or the sum
// reaches `limit`. Never inlined: it takes far longer than a call.
[[gnu::noinline]] double costAt(const PolarMap& star, const Vec2& p, double limit) {
  Vec2 a = star.rim(0) - p;
  double toA = a.norm(), sum = 0;
  for (int i = 0; i < star.size(); ++i) {
    const Vec2 b = star.rim(star.after(i)) - p, side = b - a;
    if (!(cross(a, b) > 0)) return kInfinity;
    const double toB = b.norm(), length = side.norm();
    sum += costOf(greatest(a.dot(b) / (toA * toB), -a.dot(side) / (toA * length),
                           b.dot(side) / (toB * length)));
    if (!(sum < limit)) return kInfinity;
    a = b;
    toA = toB;
  }
  return sum;
}

}  // namespace

Vec2 areaBasedTarget(const PolarMap& star, std::span<const double> mu) {
  double total = 0;
  for (int i = 0; i < star.size(); ++i) total += cross(star.rim(i), star.rim(star.after(i)));
  const double weights = std::accumulate(mu.begin(), mu.end(), 0.0);
  RowQr system;
  for (int i = 0; i < star.size(); ++i) {
    // Twice the area of (p, a, b) is linear in p: a×b + p×(a − b).
    const Vec2 &a = star.rim(i), &b = star.rim(star.after(i));
    const Vec2 edge = a - b;
    system.add(edge.y(), -edge.x(), mu[i] / weights * total - cross(a, b));
  }
  return system.solve();
}

Vec2 laplacianTarget(const PolarMap& star) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < star.size(); ++i) sum += star.rim(i);
  return sum / star.size();
}

Vec2 wideTarget(const PolarMap& star) {
  const double spoke = star.meanSpoke();
  Vec2 at = Vec2::Zero();
  double cost = costAt(star, at, kInfinity);
  searchPattern([&](double step) {
    const Vec2 from = at;
    for (const Vec2& way : planeDirections()) {
      const Vec2 to = from + step * spoke * way;
      const double own = costAt(star, to, cost);
      if (!(own < cost)) continue;
      cost = own;
      at = to;
    }
    return at != from;
  });
  return at;
}

}  // namespace remesher
