// SPDX-License-Identifier: MIT
#include "textures/painting/occlusion.h"

#include <cmath>
#include <numbers>

#include "textures/painting/line_search.h"

namespace remesher {

namespace {

// Neighbours in squares of this side cast different rays.
constexpr Index kTile = 4;
constexpr Index kRays = 8;  // per texel
constexpr Index kSet = kTile * kTile * kRays;
// How far above the surface rays start, as a share of the diagonal.
constexpr double kLift = 1e-4;
// Neighbours are on the same surface if they are at most so many mean steps apart and their normals
// agree.
constexpr double kApart = 3, kAgree = 0.7;

// The n-th number of the van der Corput sequence to base 2.
double reversedBits(Index n) {
  double result = 0, digit = 0.5;
  for (; n > 0; n >>= 1, digit /= 2) result += (n & 1) * digit;
  return result;
}

// The n-th of the directions above a plane, spread by Lambert's law: z is up.
Vec3 lambertDirection(Index n) {
  const double along = (double(n) + 0.5) / kSet, turn = 2 * std::numbers::pi * reversedBits(n);
  const double radius = std::sqrt(along);
  return {radius * std::cos(turn), radius * std::sin(turn), std::sqrt(1 - along)};
}

}  // namespace

OcclusionMap::OcclusionMap(std::span<const Vec3> positions, std::span<const Index> indices)
    : tree_(positions, indices),
      reach_(kOcclusionReach * (tree_.box().high - tree_.box().low).norm()),
      lift_(kLift * (tree_.box().high - tree_.box().low).norm()) {}

double OcclusionMap::openness(const Vec3& place, const Vec3& normal, Index column,
                              Index row) const {
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vec3 from = place + lift_ * normal;
  const Index first = row % kTile * kTile + column % kTile;
  Index open = 0;
  for (Index i = 0; i < kRays; ++i) {
    const Vec3 way = lambertDirection(first + i * kTile * kTile);
    const Vec3 direction = way.x() * x + way.y() * y + way.z() * normal;
    open += !isBlocked(tree_, {from, direction, 0, reach_});
  }
  return double(open) / kRays;
}

std::vector<float> meansOver(std::span<const OccludedTexel> texels, std::span<const Index> owners,
                             Index size) {
  double step = 0;
  std::size_t steps = 0;
  for (Index i = 0; i + 1 < texels.size(); ++i) {
    if (i % size + 1 == size || owners[i] == kNone || owners[i + 1] != owners[i]) continue;
    step += double((texels[i].place - texels[i + 1].place).norm());
    ++steps;
  }
  const float farthest = steps > 0 ? float(kApart * kTile * step / double(steps)) : 0;
  std::vector<float> means(texels.size(), 1);
  for (Index i = 0; i < texels.size(); ++i) {
    if (owners[i] == kNone) continue;
    float sum = 0, count = 0;
    const Index column = i % size, row = i / size;
    for (Index dy = 0; dy < kTile; ++dy)
      for (Index dx = 0; dx < kTile; ++dx) {
        const Index x = column + dx - kTile / 2, y = row + dy - kTile / 2;  // -1 is huge
        if (x >= size || y >= size) continue;
        const Index j = y * size + x;
        const bool isBeside = owners[j] != kNone &&
                              (texels[i].place - texels[j].place).norm() <= farthest &&
                              texels[i].normal.dot(texels[j].normal) >= float(kAgree);
        if (!isBeside) continue;
        sum += texels[j].open;
        ++count;
      }
    means[i] = count > 0 ? sum / count : texels[i].open;
  }
  return means;
}

}  // namespace remesher
