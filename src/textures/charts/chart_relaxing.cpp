// SPDX-License-Identifier: MIT
#include "textures/charts/chart_relaxing.h"

#include <cmath>

#include "textures/charts/chart_growth.h"

namespace remesher {

namespace {

// Rounds between looks at whether a chart is true, and the most of them.
constexpr int kRounds = 10, kMostRounds = 80;
// How much more a triangle counts after each look that finds it untrue: few have the rest follow.
constexpr double kHeeded = 2;
// Bounds on an area's ratio to its true size: areas are even to within 1 / cos(kMostTilt).
const double kMostArea = 1 / std::sqrt(std::cos(kMostTilt)), kLeastArea = 1 / kMostArea;
// Largest ratio of the longest to the shortest axis of a circle drawn on the surface: that of a
// triangle laid down at that tilt.
const double kMostStretch = 1 / std::cos(kMostTilt);

double twiceArea(const PlaneTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

PlaneTriangle placed(const PlaneMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

// Uses the singular values of the map: their product is the ratio of areas, and the sum of their
// squares is the squared norm of the map. enlarged: areas of the whole chart, by their true sizes.
bool isTrue(const PlaneTriangle& wanted, const PlaneTriangle& t, double enlarged) {
  const double area = twiceArea(wanted);
  if (!(area > 0)) return false;
  const double product = twiceArea(t) / area;
  if (!(product >= kLeastArea * enlarged && product <= kMostArea * enlarged)) return false;
  Eigen::Matrix2d from, to;
  from << wanted[1] - wanted[0], wanted[2] - wanted[0];
  to << t[1] - t[0], t[2] - t[0];
  const double squares = (to * from.inverse()).squaredNorm();
  return squares <= product * (kMostStretch + 1 / kMostStretch);
}

double enlargementOf(const PlaneMesh& mesh) {
  double made = 0, wanted = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    made += twiceArea(placed(mesh, t));
    wanted += twiceArea(mesh.wanted[t]);
  }
  return made / wanted;
}

// One round: each vertex goes to the mean of the places that its triangles ask for.
void relaxOnce(PlaneMesh& mesh, std::span<const double> weights) {
  std::vector<Vec2> sums(mesh.vertices.size(), Vec2::Zero());
  std::vector<double> totals(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const PlaneTriangle& wanted = mesh.wanted[t];
    const PlaneMotion motion(wanted, placed(mesh, t));
    for (int k = 0; k < 3; ++k) {
      sums[mesh.triangles[t][k]] += weights[t] * motion(wanted[k]);
      totals[mesh.triangles[t][k]] += weights[t];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (totals[v] > 0) mesh.vertices[v] = sums[v] / totals[v];
}

}  // namespace

PlaneMotion::PlaneMotion(std::span<const Vec2> from, std::span<const Vec2> to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    from_ += from[i] / double(from.size());
    to_ += to[i] / double(from.size());
  }
  Vec2 turn = Vec2::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec2 a = from[i] - from_, b = to[i] - to_;
    turn += Vec2(a.dot(b), cross(a, b));
  }
  if (turn.norm() > 0) turn_ = turn.normalized();
}

Vec2 PlaneMotion::operator()(const Vec2& p) const {
  const Vec2 way = p - from_;
  return to_ +
         Vec2(turn_.x() * way.x() - turn_.y() * way.y(), turn_.y() * way.x() + turn_.x() * way.y());
}

PlaneTriangle laidDown(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double length = (b - a).norm();
  if (!(length > 0)) return {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  const Vec3 along = (b - a) / length;
  return {Vec2::Zero(), Vec2(length, 0), Vec2(along.dot(c - a), along.cross(c - a).norm())};
}

bool relax(PlaneMesh& mesh) {
  std::vector<double> weights;
  for (const PlaneTriangle& wanted : mesh.wanted) weights.push_back(twiceArea(wanted));
  for (int i = 1; i <= kMostRounds; ++i) {
    relaxOnce(mesh, weights);
    if (i % kRounds != 0) continue;
    const double enlarged = enlargementOf(mesh);
    bool areTrue = true;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      if (isTrue(mesh.wanted[t], placed(mesh, t), enlarged)) continue;
      weights[t] *= kHeeded;
      areTrue = false;
    }
    if (!areTrue) continue;
    for (Vec2& p : mesh.vertices) p /= std::sqrt(enlarged);
    return true;
  }
  return false;
}

}  // namespace remesher
