// SPDX-License-Identifier: MIT
#include "textures/painting/canvas.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace remesher {

namespace {

double distanceToEdge(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0;
  return (p - a - t * (b - a)).norm();
}

// A texel belongs to a triangle that covers its middle or is no farther from its middle than a
// bilinear filter reaches.
constexpr double kReach = 1;

// A triangle prepared for measuring distances.
class Outline {
 public:
  explicit Outline(const TexelTriangle& triangle) : corners_(triangle) {
    for (std::size_t k = 0; k < 3; ++k) edges_[k] = triangle[(k + 1) % 3] - triangle[k];
    const bool isFlat = !(cross(edges_[0], edges_[1]) > 0);
    for (std::size_t k = 0; k < 3; ++k)
      beyond_[k] = isFlat ? -kInfinity : -kReach * 1.001 * edges_[k].norm();
  }

  // Infinite if the line of an edge already shows that p is beyond the reach.
  double distanceTo(const Vec2& p) const {
    bool isInside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = cross(edges_[k], p - corners_[k]);
      if (side < beyond_[k]) return kInfinity;
      isInside &= side >= 0;
    }
    if (isInside) return 0;
    return std::min({distanceToEdge(p, corners_[0], corners_[1]),
                     distanceToEdge(p, corners_[1], corners_[2]),
                     distanceToEdge(p, corners_[2], corners_[0])});
  }

 private:
  TexelTriangle corners_, edges_;
  std::array<double, 3> beyond_;  // per edge: nothing beyond this is within reach
};

// The eight texels around one, by number: the index steps to them.
class Beside {
 public:
  explicit Beside(Index size) : size_(size) {
    for (Index i = 0; i < 8; ++i) steps_[i] = (kRows[i] - 1) * size + kColumns[i] - 1;
  }

  Index operator()(Index texel, unsigned number) const { return texel + steps_[number]; }

  // A bit for each of them that exists and that isMeant accepts.
  template <class IsMeant>
  unsigned those(Index texel, const IsMeant& isMeant) const {
    const Index x = texel % size_, y = texel / size_;
    unsigned numbers = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const Index column = x + kColumns[i] - 1, row = y + kRows[i] - 1;  // -1 is huge
      if (column < size_ && row < size_ && isMeant(texel + steps_[i])) numbers |= 1u << i;
    }
    return numbers;
  }

 private:
  static constexpr std::array<Index, 8> kColumns = {0, 1, 2, 0, 2, 0, 1, 2};
  static constexpr std::array<Index, 8> kRows = {0, 0, 0, 1, 1, 2, 2, 2};

  Index size_;
  std::array<Index, 8> steps_;
};

// A texel to fill with the mean of some of its neighbours.
struct Gap {
  Index texel;
  std::uint8_t others;  // a bit per neighbour: see Beside
};

void setToMean(io::Image& image, const Gap& gap, const Beside& beside) {
  // Two bytes side by side, each with room for a sum of eight.
  constexpr std::uint32_t kPair = 0x00ff00ff;
  std::array<std::uint32_t, 2> sums{};
  for (unsigned others = gap.others; others != 0; others &= others - 1) {
    std::uint32_t bytes;
    const std::size_t other = beside(gap.texel, unsigned(std::countr_zero(others)));
    std::memcpy(&bytes, &image.texels[4 * other], sizeof bytes);
    sums[0] += bytes & kPair;
    sums[1] += bytes >> 8 & kPair;
  }
  const unsigned count = unsigned(std::popcount(gap.others));
  // For sums of at most eight bytes the multiplication gives the same result as the division.
  const unsigned inverse = 65536 / count + 1;
  const auto mean = [&](std::uint32_t sum) { return (sum + count / 2) * inverse >> 16; };
  const auto means = [&](std::uint32_t pair) {
    return mean(pair & 0xffff) | mean(pair >> 16) << 16;
  };
  const std::uint32_t bytes = means(sums[0]) | means(sums[1]) << 8;
  std::memcpy(&image.texels[4 * std::size_t{gap.texel}], &bytes, sizeof bytes);
}

// The gaps ring after ring; each ring lies beside texels that are covered or filled by then.
std::vector<Gap> gapsInRings(std::span<const Index> owners, const Beside& beside) {
  enum State : std::uint8_t { Empty, Done, Waiting };
  std::vector<std::uint8_t> states(owners.size());
  for (std::size_t i = 0; i < owners.size(); ++i) states[i] = owners[i] != kNone ? Done : Empty;
  const auto isDone = [&](Index i) { return states[i] == Done; };
  const auto isEmpty = [&](Index i) { return states[i] == Empty; };
  std::vector<Gap> gaps;
  for (Index i = 0; i < owners.size(); ++i)
    if (isEmpty(i) && beside.those(i, isDone) != 0) gaps.push_back({i, 0});
  for (const Gap& gap : gaps) states[gap.texel] = Waiting;
  for (std::size_t begin = 0, end = gaps.size(); begin < end; begin = end, end = gaps.size()) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index texel = gaps[k].texel;
      gaps[k].others = std::uint8_t(beside.those(texel, isDone));
      for (unsigned next = beside.those(texel, isEmpty); next != 0; next &= next - 1) {
        gaps.push_back({beside(texel, unsigned(std::countr_zero(next))), 0});
        states[gaps.back().texel] = Waiting;
      }
    }
    for (std::size_t k = begin; k < end; ++k) states[gaps[k].texel] = Done;
  }
  return gaps;
}

}  // namespace

std::vector<Index> coveredTexels(std::span<const TexelTriangle> triangles, Index size) {
  std::vector<Index> owners(std::size_t{size} * size, kNone);
  std::vector<float> distances(owners.size(), std::numeric_limits<float>::max());
  const auto clamped = [&](double x) { return Index(std::clamp(x, 0.0, double(size))); };
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Outline outline(triangles[t]);
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (Index y = clamped(low.y() - kReach - 0.5); y < clamped(high.y() + kReach + 0.5); ++y)
      for (Index x = clamped(low.x() - kReach - 0.5); x < clamped(high.x() + kReach + 0.5); ++x) {
        const auto distance = float(outline.distanceTo({x + 0.5, y + 0.5}));
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

RimmedTriangle::RimmedTriangle(const TexelTriangle& t, const std::array<char, 3>& rims) {
  // In texels, because the edge is not exactly the original's; of the height where this is less.
  constexpr double kInset = 0.25;
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!rims[k] || !(area > 0)) continue;
    const Vec2 edge = t[(k + 1) % 3] - t[k];
    const double length = edge.norm();
    rims_[count_++] = {t[k], edge, length, kInset * std::min(area / length, 1.0)};
  }
}

Vec2 RimmedTriangle::kept(const Vec2& point, const Rim& rim) {
  const double missing = rim.least - cross(rim.edge, point - rim.from) / rim.length;
  if (!(missing > 0)) return point;
  return point + missing / rim.length * Vec2(-rim.edge.y(), rim.edge.x());
}

// Image after image, because they do not all fit into a cache.
void fillGutters(std::span<io::Image* const> images, std::span<const Index> owners) {
  const Beside beside(images.front()->width);
  const std::vector<Gap> gaps = gapsInRings(owners, beside);
  for (io::Image* const image : images)
    for (const Gap& gap : gaps) setToMean(*image, gap, beside);
}

}  // namespace remesher
