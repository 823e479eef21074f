// SPDX-License-Identifier: MIT
#include "repair/solid/inside.h"

#include <algorithm>

namespace remesher {

namespace {

constexpr int kHalfLines = 6;

// Per point, the number of half lines that find it enclosed once or more.
std::vector<std::uint8_t> votesOf(const Lattice& lattice, std::span<const EdgeCrossing> crossings) {
  std::vector<std::uint8_t> votes(lattice.size(), 0);
  forEachCrossedLine(lattice, crossings, [&](const CrossedLine& line) {
    int above = 0, below = 0;
    for (const EdgeCrossing& c : line.crossings) above += c.up;
    std::size_t next = 0;
    const std::size_t stride = lattice.stride(line.axis);
    for (std::size_t i = 0; i < lattice.count(line.axis); ++i) {
      const std::size_t point = line.first + i * stride;
      // A crossing of this point's edge lies above it.
      for (; next < line.crossings.size() && line.crossings[next].edge / 3 < point; ++next) {
        above -= line.crossings[next].up;
        below -= line.crossings[next].up;
      }
      votes[point] = std::uint8_t(votes[point] + (above > 0) + (below > 0));
    }
  });
  return votes;
}

std::vector<char> crossedEdges(const Lattice& lattice, std::span<const EdgeCrossing> crossings) {
  std::vector<char> crossed(lattice.size(), 0);  // bit by axis
  for (const EdgeCrossing& c : crossings)
    crossed[c.edge / 3] = char(crossed[c.edge / 3] | (1 << (c.edge % 3)));
  return crossed;
}

// Each share becomes the mean of itself and of the neighbours that no surface separates from it.
void diffuse(const Lattice& lattice, const std::vector<char>& crossed, std::vector<float>& shares) {
  std::vector<float> next(shares.size(), 0);
  lattice.forEachPoint([&](std::size_t p, const std::array<std::size_t, 3>& place) {
    if (lattice.isOnBorder(place)) return;
    float sum = shares[p], count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t up = p + lattice.stride(axis), down = p - lattice.stride(axis);
      if (!(crossed[p] >> axis & 1)) sum += shares[up], count += 1;
      if (!(crossed[down] >> axis & 1)) sum += shares[down], count += 1;
    }
    next[p] = sum / count;
  });
  shares = std::move(next);
}

}  // namespace

void fillCavities(const Lattice& lattice, std::span<const std::size_t> kept,
                  std::vector<char>& isInside) {
  std::vector<char> isReached(isInside.size(), 0);
  std::vector<std::size_t> front = {0};
  isReached[0] = 1;
  // Beyond the lattice's border the numbers continue at the opposite border, which is outside, too.
  const auto visit = [&](std::size_t q) {
    if (q >= isInside.size() || isInside[q] || isReached[q]) return;
    isReached[q] = 1;
    front.push_back(q);
  };
  for (const std::size_t p : kept) visit(p);
  while (!front.empty()) {
    const std::size_t p = front.back();
    front.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      visit(p - lattice.stride(axis));
      visit(p + lattice.stride(axis));
    }
  }
  for (std::size_t p = 0; p < isInside.size(); ++p) isInside[p] = !isReached[p];
}

InsideField insideField(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                        std::span<const std::size_t> kept) {
  constexpr int kRounds = 6;  // a hole six cells wide has no say beyond itself
  const std::vector<std::uint8_t> votes = votesOf(lattice, crossings);
  const std::vector<char> crossed = crossedEdges(lattice, crossings);
  InsideField field;
  field.shares.reserve(votes.size());
  std::size_t disputed = 0, asked = 0;
  lattice.forEachPoint([&](std::size_t p, const std::array<std::size_t, 3>& place) {
    field.shares.push_back(lattice.isOnBorder(place) ? 0 : float(votes[p]) / kHalfLines);
    if (!crossed[p]) return;
    ++asked;
    disputed += votes[p] != 0 && votes[p] != kHalfLines;
  });
  field.unsure = asked > 0 ? double(disputed) / double(asked) : 1;
  for (int round = 0; round < kRounds && disputed > 0; ++round)
    diffuse(lattice, crossed, field.shares);
  for (const float share : field.shares) field.isInside.push_back(share > 0.5F);
  fillCavities(lattice, kept, field.isInside);
  return field;
}

}  // namespace remesher
