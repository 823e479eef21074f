// SPDX-License-Identifier: MIT
#include "jobs/parts/part_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {
namespace {

// Sizes up to this power of two, and down to its inverse, are not scaled.
constexpr int kUsual = 30;
// The largest exponent whose power of two and inverse are both normal doubles.
constexpr int kFarthest = 1022;

// What is farther from the origin than this many times its diagonal is moved there.
constexpr double kFar = 4;

// The points' box at half its size: the full size of the largest doubles would be infinite.
using HalfBox = Eigen::AlignedBox3d;

// The box of triangles that are no lines; stray vertices do not count. Indices are not checked yet.
// Without a place, in the part's own space.
HalfBox halfBox(const TriangleMesh& mesh, const Transform* place) {
  Box box;
  const std::vector<Vec3>& positions = mesh.positions;
  std::vector<char> isIn(positions.size(), 0);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Index* const t = &mesh.indices[i];
    if (std::max({t[0], t[1], t[2]}) >= positions.size()) continue;
    if (isIn[t[0]] && isIn[t[1]] && isIn[t[2]]) continue;
    if (hasTwins(positions[t[0]], positions[t[1]], positions[t[2]])) continue;
    for (const Index v : {t[0], t[1], t[2]}) {
      if (std::exchange(isIn[v], 1)) continue;
      box.extend(place ? Vec3(*place * positions[v]) : positions[v]);
    }
  }
  return {0.5 * box.low, 0.5 * box.high};
}

// Whether all scaled positions are finite: a stray vertex may lie far outside the box.
bool fits(const io::Part& part, double scale) {
  return std::all_of(part.mesh.positions.begin(), part.mesh.positions.end(),
                     [&](const Vec3& p) { return (p * scale).allFinite(); });
}

// The box's middle, in few digits, on the axes on which the box is several times as far away as it
// is large: both are then so near to each other that their difference is exact.
Vec3 originOf(const HalfBox& box) {
  constexpr double kTimes = 4;
  if (box.isEmpty()) return Vec3::Zero();
  const Vec3 low = box.min(), high = box.max();
  const double half = (high - low).maxCoeff(), diagonal = 2 * (high - low).stableNorm();
  const double farthest = 2 * high.cwiseAbs().cwiseMax(low.cwiseAbs()).maxCoeff();
  if (!(half > 0) || !std::isfinite(diagonal) || !(farthest > kFar * diagonal)) return Vec3::Zero();
  const double step = std::ldexp(1.0, std::ilogb(half) + 1);
  Vec3 origin = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = low[axis] + high[axis];
    if (!(std::abs(middle) > kTimes * half)) continue;
    origin[axis] = std::round(middle / step) * step;
  }
  return origin.allFinite() ? origin : Vec3::Zero();
}

HalfBox movedBy(const HalfBox& box, const Vec3& origin) {
  return box.isEmpty() ? box : HalfBox(box.min() - origin / 2, box.max() - origin / 2);
}

bool isMoved(const Transform& place) { return !place.translation().isZero(0); }

// The factor that brings the longest side of the box to between 1 and 2, or below if the box is so
// far away that products of four coordinates would be infinite.
double unitScale(const HalfBox& box) {
  constexpr int kFarAway = 200;
  if (box.isEmpty()) return 1;
  const double half = (box.max() - box.min()).maxCoeff();
  const double farthest = box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()).maxCoeff();
  if (!std::isfinite(half) || farthest == 0) return 1;
  const int bySize = half > 0 ? std::ilogb(half) + 1 : 0;
  const int power = std::max(bySize, std::ilogb(farthest) + 1 - kFarAway);
  if (std::abs(power) <= kUsual) return 1;
  return std::ldexp(1.0, -std::clamp(power, -kFarthest, kFarthest));
}

}  // namespace

PartScale::PartScale(const std::vector<io::Part>& parts) {
  HalfBox world;
  bool isWorldMoved = false;
  for (const io::Part& part : parts) {
    const HalfBox box = halfBox(part.mesh, nullptr);
    world.extend(part.instances.empty() ? box : halfBox(part.mesh, &part.instances.front()));
    const Vec3 origin = part.mesh.isSingle || part.mesh.steps ? Vec3(Vec3::Zero()) : originOf(box);
    origins_.push_back(origin);
    isWorldMoved = isWorldMoved || !origin.isZero(0) ||
                   (!part.instances.empty() && isMoved(part.instances.front()));
    const double own = unitScale(movedBy(box, origin));
    local_.push_back(own != 1 && fits(part, own) ? own : 1);
  }
  if (isWorldMoved) worldOrigin_ = originOf(world);
  world_ = unitScale(movedBy(world, worldOrigin_));
}

bool PartScale::isNeeded() const {
  return world_ != 1 || !worldOrigin_.isZero(0) ||
         std::any_of(local_.begin(), local_.end(), [](double s) { return s != 1; }) ||
         std::any_of(origins_.begin(), origins_.end(), [](const Vec3& p) { return !p.isZero(0); });
}

std::vector<io::Part> PartScale::applied(std::vector<io::Part> parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (Vec3& p : parts[i].mesh.positions) p = (p - origins_[i]) * local_[i];
    // Only small numbers have fewer digits, so a scale below 1 does not matter.
    parts[i].mesh.scale = std::max(local_[i], 1.0);
    if (parts[i].mesh.steps) parts[i].mesh.steps->perUnit /= local_[i];
    if (parts[i].instances.empty()) parts[i].instances.push_back(Transform::Identity());
    for (Transform& place : parts[i].instances) {
      place.pretranslate(-worldOrigin_).translate(origins_[i]);
      place.prescale(world_).scale(1 / local_[i]);
    }
  }
  return parts;
}

RemeshOptions PartScale::applied(RemeshOptions options) const {
  Lengths& lengths = options.lengths;
  for (std::optional<double>* const length : {&options.edgeLength, &lengths.maxError})
    if (*length) **length *= world_;
  return options;
}

std::vector<io::Part> PartScale::undone(std::vector<io::Part> parts,
                                        const std::vector<io::Part>& originals) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (Vec3& p : parts[i].mesh.positions) p = p / local_[i] + origins_[i];
    parts[i].mesh.scale = 1;
    parts[i].mesh.steps = originals[i].mesh.steps;
    parts[i].instances = originals[i].instances;
  }
  return parts;
}

Vec3 PartScale::inWorld(const io::Part& part, const Vec3& p) const {
  return part.instances.empty() ? p : part.instances.front() * p / world_ + worldOrigin_;
}

double PartScale::growth(const io::Part& part) const {
  if (part.instances.empty()) return 1;
  return std::cbrt(std::abs(part.instances.front().linear().determinant())) / world_;
}

}  // namespace remesher
