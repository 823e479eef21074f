// SPDX-License-Identifier: MIT
#include "measure/hausdorff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

// Samples by area, per side: two per triangle, within these limits. The rms of N samples is off by
// about 1/√N of itself.
constexpr std::size_t kFewestSamples = 20'000, kMostSamples = 200'000;
// A maximum this much larger than the one found is not looked for: a share of it, and a share of
// the diagonal (where the surfaces agree, the first share is of nothing).
constexpr double kRelativeTolerance = 2e-3, kAbsoluteTolerance = 1e-5;
// Points to look at while proving the maximum. Surfaces so far apart, or so coarse, that these do
// not suffice leave the largest distance found without its proof.
constexpr std::size_t kMostProbes = 2'000'000;

struct Surface {
  const TriangleMesh& mesh;
  TriangleTree tree;

  explicit Surface(const TriangleMesh& m) : mesh(m), tree(m.positions, m.indices) {}

  Triangle triangle(Index t) const {
    const std::size_t corner = std::size_t{3} * t;
    return {mesh.positions[mesh.indices[corner]], mesh.positions[mesh.indices[corner + 1]],
            mesh.positions[mesh.indices[corner + 2]]};
  }

  double area() const {
    double sum = 0;
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      const auto [a, b, c] = triangle(t);
      sum += remesher::area(a, b, c);
    }
    return sum;
  }
};

// The points of the R2 sequence, which fill the unit square evenly whatever their number, folded
// onto the triangle below its diagonal.
class EvenPoints {
 public:
  Vec3 next() {
    u_ += kStepU, v_ += kStepV;
    if (u_ >= 1) u_ -= 1;
    if (v_ >= 1) v_ -= 1;
    const double u = u_ + v_ > 1 ? 1 - u_ : u_, v = u_ + v_ > 1 ? 1 - v_ : v_;
    return {1 - u - v, u, v};
  }

 private:
  // 1/p and 1/p² for the plastic number p = 1.3247…, the root of p³ = p + 1.
  static constexpr double kStepU = 0.7548776662466927, kStepV = 0.5698402909980532;
  double u_ = 0.5, v_ = 0.5;
};

// One direction. Walks `from` in its tree's order, so that the answer for one point is a good start
// for the next.
class Measurement {
 public:
  Measurement(const Surface& from, const Surface& to, double diagonal)
      : from_(from),
        to_(to),
        hits_(from.mesh.positions.size(), kNone),
        absoluteTolerance_(kAbsoluteTolerance * diagonal) {}

  Deviation run() {
    sample();
    for (const Index t : from_.tree.order()) prove(t);
    const double maximum = std::sqrt(squaredMaximum_);
    return {maximum, sampleCount_ > 0 ? std::sqrt(sumOfSquares_ / static_cast<double>(sampleCount_))
                                      : maximum};
  }

 private:
  // A point of `from` and the triangle of `to` nearest to it.
  struct Probe {
    Vec3 point;
    Index hit;
  };

  double look(const Vec3& p) {
    const TriangleTree::Nearest nearest =
        last_ == kNone ? to_.tree.nearest(p) : to_.tree.nearest(p, last_);
    last_ = nearest.triangle;
    squaredMaximum_ = std::max(squaredMaximum_, nearest.squaredDistance);
    return nearest.squaredDistance;
  }

  Probe probe(const Vec3& p, Index start) {
    ++probes_;
    last_ = start;
    look(p);
    return {p, last_};
  }

  void sample() {
    const std::size_t wanted =
        std::clamp(2 * from_.mesh.triangleCount(), kFewestSamples, kMostSamples);
    const double total = from_.area();
    const double perArea = total > 0 ? static_cast<double>(wanted) / total : 0;
    EvenPoints points;
    double due = 0;
    for (const Index t : from_.tree.order()) {
      const auto [a, b, c] = from_.triangle(t);
      for (int k = 0; k < 3; ++k) {
        const Index v = from_.mesh.indices[std::size_t{3} * t + k];
        if (hits_[v] != kNone) continue;
        look(from_.mesh.positions[v]);
        hits_[v] = last_;
      }
      for (due += area(a, b, c) * perArea; due >= 1; due -= 1) {
        const Vec3 w = points.next();
        sumOfSquares_ += look(w[0] * a + w[1] * b + w[2] * c);
        ++sampleCount_;
      }
    }
  }

  bool isWithinMaximum(double squaredDistance) const {
    const double most = std::sqrt(squaredMaximum_) * (1 + kRelativeTolerance) + absoluteTolerance_;
    return squaredDistance <= most * most;
  }

  // The distance to a convex set is a convex function, so over a triangle it is largest at a
  // corner: one triangle of `to` near enough to all three corners is near enough to every point.
  bool isNear(const std::array<Probe, 3>& corners, Index target) const {
    const auto triangle = to_.triangle(target);
    return std::all_of(corners.begin(), corners.end(), [&](const Probe& p) {
      const Vec3 closest = closestPoint(p.point, triangle[0], triangle[1], triangle[2]);
      return isWithinMaximum((closest - p.point).squaredNorm());
    });
  }

  bool isProven(const std::array<Probe, 3>& corners) const {
    return isNear(corners, corners[0].hit) ||
           (corners[1].hit != corners[0].hit && isNear(corners, corners[1].hit)) ||
           (corners[2].hit != corners[0].hit && corners[2].hit != corners[1].hit &&
            isNear(corners, corners[2].hit));
  }

  void prove(Index t) {
    const Triangle points = from_.triangle(t);
    std::array<Probe, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {points[k], hits_[from_.mesh.indices[std::size_t{3} * t + k]]};
    if (isProven(corners)) return;
    const Probe centre = probe((points[0] + points[1] + points[2]) / 3, corners[0].hit);
    if (isNear(corners, centre.hit)) return;
    pending_.assign(1, corners);
    while (!pending_.empty() && probes_ < kMostProbes) {
      const std::array<Probe, 3> next = pending_.back();
      pending_.pop_back();
      if (!isProven(next)) subdivide(next, centre.hit);
    }
  }

  //        2
  //       / \       Midpoints opposite to the corners; a tie goes to `start`, so that a midpoint on
  //      1 - 0      an edge of `to` does not fall to the other side's triangle.
  //     / \ / \ .
  //    0 - 2 - 1
  void subdivide(const std::array<Probe, 3>& corners, Index start) {
    std::array<Probe, 3> middles;
    for (std::size_t k = 0; k < 3; ++k)
      middles[k] = probe(0.5 * (corners[(k + 1) % 3].point + corners[(k + 2) % 3].point), start);
    pending_.push_back(middles);
    for (std::size_t k = 0; k < 3; ++k)
      pending_.push_back({corners[k], middles[(k + 2) % 3], middles[(k + 1) % 3]});
  }

  const Surface& from_;
  const Surface& to_;
  std::vector<Index> hits_;  // per vertex of `from`: the triangle of `to` nearest to it
  double absoluteTolerance_;
  Index last_ = kNone;
  double squaredMaximum_ = 0;
  double sumOfSquares_ = 0;
  std::size_t sampleCount_ = 0;
  std::size_t probes_ = 0;
  std::vector<std::array<Probe, 3>> pending_;
};

double diagonalOf(const TriangleMesh& mesh) {
  Box box;
  for (const Index v : mesh.indices) box.extend(mesh.positions[v]);
  return (box.high - box.low).norm();
}

}  // namespace

DeviationBothWays measureDeviation(const TriangleMesh& original, const TriangleMesh& result) {
  const Surface first(original), second(result);
  const double diagonal = diagonalOf(original);
  return {Measurement(first, second, diagonal).run(), Measurement(second, first, diagonal).run(),
          diagonal};
}

FidelityReport measureFidelity(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result);
  if (d.diagonal == 0) return {};
  return {100 * std::max(d.toResult.maximum, d.toOriginal.maximum) / d.diagonal,
          100 * std::max(d.toResult.rms, d.toOriginal.rms) / d.diagonal};
}

}  // namespace remesher
