// SPDX-License-Identifier: MIT
#include "textures/charts/chart_relaxing.h"

#include <cmath>
#include <utility>
#include <vector>

#include "textures/charts/chart_growth.h"

namespace remesher {

namespace {

// Rounds before the first look at whether a chart is true, between later ones, and the most of all.
constexpr int kPlainRounds = 10, kRounds = 5, kMostRounds = 65;
// The share of an error that a round which is not accelerated leaves at most, about.
constexpr double kLeft = 0.95;
// How much more a triangle counts after each look that finds it untrue: few have the rest follow.
constexpr double kHeavier = 2;
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

// The rounds of one mesh.
class Rounds {
 public:
  // Lays the wanted triangles about the origin.
  explicit Rounds(PlaneMesh& mesh)
      : mesh_(mesh),
        weights_(mesh.wanted.size(), 0),
        totals_(mesh.vertices.size(), 0),
        before_(mesh.vertices) {
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      PlaneTriangle& wanted = mesh.wanted[t];
      const Vec2 middle = (wanted[0] + wanted[1] + wanted[2]) / 3;
      for (Vec2& p : wanted) p -= middle;
      addWeight(t, twiceArea(wanted));
    }
  }

  // Lets a triangle weigh `factor` times as much; what the rounds before aimed at is past.
  void multiplyWeight(std::size_t t, double factor) {
    addWeight(t, (factor - 1) * weights_[t]);
    round_ = 0;
  }

  // Each vertex goes to the mean of the places that its triangles ask for, and further on from
  // where it was before the last round.
  void relaxOnce() {
    ++round_;
    pace_ = round_ <= 1   ? 1
            : round_ == 2 ? 2 / (2 - kLeft * kLeft)
                          : 4 / (4 - kLeft * kLeft * pace_);
    sums_.assign(mesh_.vertices.size(), Vec2::Zero());
    for (std::size_t t = 0; t < weights_.size(); ++t) add(t);
    for (std::size_t v = 0; v < sums_.size(); ++v) {
      if (!(totals_[v] > 0)) continue;
      const Vec2 last = std::exchange(before_[v], mesh_.vertices[v]);
      mesh_.vertices[v] = last + pace_ * (sums_[v] / totals_[v] - last);
    }
  }

 private:
  void addWeight(std::size_t t, double more) {
    weights_[t] += more;
    for (const Index v : mesh_.triangles[t]) totals_[v] += more;
  }

  void add(std::size_t t) {
    const auto [p, q, r] = placed(mesh_, t);
    const PlaneTriangle& shape = mesh_.wanted[t];
    // The rotation that fits best; the shape's corners have the origin as their mean.
    const Vec2 along = q - p, across = r - p;
    Vec2 turn(shape[1].dot(along) + shape[2].dot(across),
              cross(shape[1], along) + cross(shape[2], across));
    const double length = turn.norm();
    turn = length > 0 ? Vec2(weights_[t] / length * turn) : Vec2(weights_[t], 0);
    const Vec2 middle = weights_[t] / 3 * (p + q + r);
    for (int k = 0; k < 3; ++k)
      sums_[mesh_.triangles[t][k]] +=
          middle + Vec2(turn.x() * shape[k].x() - turn.y() * shape[k].y(),
                        turn.y() * shape[k].x() + turn.x() * shape[k].y());
  }

  PlaneMesh& mesh_;
  std::vector<double> weights_;  // of triangles
  std::vector<double> totals_;   // per vertex, of its triangles' weights
  std::vector<Vec2> sums_, before_;
  int round_ = -kPlainRounds;  // since weights changed; easy charts are not accelerated
  double pace_ = 1;
};

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
  Rounds rounds(mesh);
  for (int i = 1; i <= kMostRounds; ++i) {
    rounds.relaxOnce();
    if (i < kPlainRounds || i % kRounds != 0) continue;
    const double enlarged = enlargementOf(mesh);
    bool areTrue = true;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (isTrue(mesh.wanted[t], placed(mesh, t), enlarged)) continue;
      rounds.multiplyWeight(t, kHeavier);
      areTrue = false;
    }
    if (!areTrue) continue;
    for (Vec2& p : mesh.vertices) p /= std::sqrt(enlarged);
    return true;
  }
  return false;
}

}  // namespace remesher
