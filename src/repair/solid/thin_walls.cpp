// SPDX-License-Identifier: MIT
#include "repair/solid/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace remesher {

namespace {

// No cell becomes narrower, in widths of the lattice's cubes, and no thinner wall gets a plane.
constexpr double kNarrowest = 1.0 / 64;

// Where a line of the lattice passes through a wall between two neighbouring planes of it.
struct Pass {
  std::size_t axis, below;  // the number of the plane below
  double low, high;
};

struct WallPlane {
  std::size_t axis;
  double at;
  std::size_t walls;  // the number of passes that it divides
};

std::vector<Pass> passesOf(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                           const OrientedPatches& patches) {
  const double thinnest = kNarrowest * lattice.spacing();
  std::vector<Pass> passes;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const EdgeCrossing &in = crossings[i], &out = crossings[i + 1];
    if (in.edge != out.edge || in.up > 0 || out.up < 0 || out.at - in.at < thinnest) continue;
    if (patches.patches[in.triangle] != patches.patches[out.triangle]) continue;
    const std::size_t axis = in.edge % 3;
    passes.push_back({axis, lattice.place(in.edge / 3)[axis], in.at, out.at});
  }
  std::sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) {
    return std::tie(a.axis, a.below, a.high, a.low) < std::tie(b.axis, b.below, b.high, b.low);
  });
  return passes;
}

// The fewest planes that divide all passes, found from below: the first of those that are left ends
// lowest, and shares a plane with all that begin below its end.
std::vector<WallPlane> planesThrough(const Lattice& lattice, std::span<const Pass> passes) {
  const double narrowest = kNarrowest * lattice.spacing();
  std::vector<WallPlane> planes;
  for (std::size_t begin = 0, end = 0; begin < passes.size(); begin = end) {
    const Pass& first = passes[begin];
    double low = first.low;
    for (end = begin; end < passes.size(); ++end) {
      const Pass& next = passes[end];
      if (next.axis != first.axis || next.below != first.below || next.low >= first.high) break;
      low = std::max(low, next.low);
    }
    const double at = (low + first.high) / 2;
    const bool isClear = at - lattice.at(first.axis, first.below) >= narrowest &&
                         lattice.at(first.axis, first.below + 1) - at >= narrowest;
    if (isClear) planes.push_back({first.axis, at, end - begin});
  }
  return planes;
}

// Whether the plane divides as many walls as a quarter of the plane is wide, in cells. Fewer are
// not worth its points: beside its sharp edges each body is thin.
bool isWorthIt(const Lattice& lattice, const WallPlane& plane) {
  constexpr double kLeastShare = 0.25;
  const double across = double(lattice.size()) / double(lattice.count(plane.axis));
  return double(plane.walls) >= kLeastShare * std::sqrt(across);
}

}  // namespace

std::array<std::vector<double>, 3> planesInThinWalls(const Lattice& lattice,
                                                     std::span<const EdgeCrossing> crossings,
                                                     const OrientedPatches& patches,
                                                     std::size_t mostPoints) {
  std::vector<WallPlane> planes = planesThrough(lattice, passesOf(lattice, crossings, patches));
  std::sort(planes.begin(), planes.end(), [](const WallPlane& a, const WallPlane& b) {
    return std::tie(b.walls, a.axis, a.at) < std::tie(a.walls, b.axis, b.at);
  });
  std::array<std::vector<double>, 3> result;
  std::array<std::size_t, 3> counts = {lattice.count(0), lattice.count(1), lattice.count(2)};
  for (const WallPlane& plane : planes) {
    if (!isWorthIt(lattice, plane)) continue;
    std::array<std::size_t, 3> more = counts;
    ++more[plane.axis];
    if (more[0] * more[1] * more[2] > mostPoints) continue;
    counts = more;
    result[plane.axis].push_back(plane.at);
  }
  for (std::vector<double>& along : result) std::sort(along.begin(), along.end());
  return result;
}

}  // namespace remesher
