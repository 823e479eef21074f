// SPDX-License-Identifier: MIT
#include "painting/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace remesher {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double distanceToEdge(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0;
  return (p - a - t * (b - a)).norm();
}

double distanceTo(const TexelTriangle& t, const Vec2& p) {
  const bool isInside = cross(t[1] - t[0], p - t[0]) >= 0 && cross(t[2] - t[1], p - t[1]) >= 0 &&
                        cross(t[0] - t[2], p - t[2]) >= 0;
  if (isInside) return 0;
  return std::min({distanceToEdge(p, t[0], t[1]), distanceToEdge(p, t[1], t[2]),
                   distanceToEdge(p, t[2], t[0])});
}

// The texels beside one, as far as there are any.
template <class Visit>
void forEachBeside(std::size_t texel, Index size, const Visit& visit) {
  const long x = long(texel % size), y = long(texel / size);
  for (long j = std::max(0L, y - 1); j <= std::min(long(size) - 1, y + 1); ++j)
    for (long i = std::max(0L, x - 1); i <= std::min(long(size) - 1, x + 1); ++i)
      if (i != x || j != y) visit(std::size_t(j) * size + std::size_t(i));
}

}  // namespace

std::vector<Index> coveredTexels(std::span<const TexelTriangle> triangles, Index size) {
  constexpr double kReach = 1;
  std::vector<Index> owners(std::size_t{size} * size, kNone);
  std::vector<float> distances(owners.size(), std::numeric_limits<float>::max());
  const auto clamped = [&](double x) { return Index(std::clamp(x, 0.0, double(size))); };
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (Index y = clamped(low.y() - kReach - 0.5); y < clamped(high.y() + kReach + 0.5); ++y)
      for (Index x = clamped(low.x() - kReach - 0.5); x < clamped(high.x() + kReach + 0.5); ++x) {
        const auto distance = float(distanceTo(triangles[t], Vec2(x + 0.5, y + 0.5)));
        const std::size_t at = std::size_t{y} * size + x;
        if (distance > float(kReach) || distance >= distances[at]) continue;
        distances[at] = distance;
        owners[at] = t;
      }
  }
  return owners;
}

Vec3 weightsAt(const TexelTriangle& t, const Vec2& p) {
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  if (!(area > 0)) return Vec3::Constant(1.0 / 3);
  const double b = cross(p - t[0], t[2] - t[0]) / area, c = cross(t[1] - t[0], p - t[0]) / area;
  return {1 - b - c, b, c};
}

void fillGutters(io::Image& image, std::span<const Index> owners) {
  const Index size = image.width;
  std::vector<std::uint8_t> isDone(owners.size());
  std::vector<std::size_t> ring, next;
  for (std::size_t i = 0; i < owners.size(); ++i) isDone[i] = owners[i] != kNone;
  for (std::size_t i = 0; i < owners.size(); ++i) {
    bool isBeside = false;
    if (!isDone[i]) forEachBeside(i, size, [&](std::size_t j) { isBeside |= isDone[j] != 0; });
    if (isBeside) ring.push_back(i);
  }
  constexpr std::uint8_t kWaiting = 2;
  for (const std::size_t i : ring) isDone[i] = kWaiting;
  while (!ring.empty()) {
    for (const std::size_t i : ring) {
      std::array<unsigned, 4> sum{};
      unsigned count = 0;
      forEachBeside(i, size, [&](std::size_t j) {
        if (isDone[j] != 1) return;
        ++count;
        for (std::size_t c = 0; c < 4; ++c) sum[c] += image.texels[4 * j + c];
      });
      for (std::size_t c = 0; c < 4; ++c)
        image.texels[4 * i + c] = std::uint8_t((sum[c] + count / 2) / count);
    }
    for (const std::size_t i : ring) isDone[i] = 1;
    next.clear();
    for (const std::size_t i : ring)
      forEachBeside(i, size, [&](std::size_t j) {
        if (isDone[j] != 0) return;
        isDone[j] = kWaiting;
        next.push_back(j);
      });
    ring.swap(next);
  }
}

}  // namespace remesher
