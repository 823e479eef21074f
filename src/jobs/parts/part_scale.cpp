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

void scale(std::vector<Vec3>& positions, double factor) {
  for (Vec3& p : positions) p *= factor;
}

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
  for (const io::Part& part : parts) {
    const HalfBox box = halfBox(part.mesh, nullptr);
    world.extend(part.instances.empty() ? box : halfBox(part.mesh, &part.instances.front()));
    const double own = unitScale(box);
    local_.push_back(own != 1 && fits(part, own) ? own : 1);
  }
  world_ = unitScale(world);
}

bool PartScale::isNeeded() const {
  return world_ != 1 || std::any_of(local_.begin(), local_.end(), [](double s) { return s != 1; });
}

std::vector<io::Part> PartScale::applied(std::vector<io::Part> parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    scale(parts[i].mesh.positions, local_[i]);
    // Only small numbers have fewer digits, so a scale below 1 does not matter.
    parts[i].mesh.scale = std::max(local_[i], 1.0);
    if (parts[i].mesh.steps) parts[i].mesh.steps->perUnit /= local_[i];
    if (parts[i].instances.empty()) parts[i].instances.push_back(Transform::Identity());
    for (Transform& place : parts[i].instances) place.prescale(world_).scale(1 / local_[i]);
  }
  return parts;
}

RemeshOptions PartScale::applied(RemeshOptions options) const {
  if (options.edgeLength) *options.edgeLength *= world_;
  return options;
}

std::vector<io::Part> PartScale::undone(std::vector<io::Part> parts,
                                        const std::vector<io::Part>& originals) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    scale(parts[i].mesh.positions, 1 / local_[i]);
    parts[i].mesh.scale = 1;
    parts[i].mesh.steps = originals[i].mesh.steps;
    parts[i].instances = originals[i].instances;
  }
  return parts;
}

Vec3 PartScale::inWorld(const io::Part& part, const Vec3& p) const {
  return part.instances.empty() ? p : part.instances.front() * p / world_;
}

}  // namespace remesher
