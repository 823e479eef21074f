// SPDX-License-Identifier: MIT
#include "repair/holes/nested_loops.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "repair/holes/rims.h"

namespace remesher {

namespace {

// A loop at which walls end in a plane.
struct Ring {
  std::size_t loop;
  RimPlane plane;
  bool isOuter = true;
};

class Nesting {
 public:
  Nesting(const BuiltMesh& built, const std::vector<Loop>& loops) : built_(built), loops_(loops) {
    for (std::size_t l = 0; l < loops.size(); ++l)
      if (std::optional<RimPlane> plane = wallPlane(built, loops[l])) rings_.push_back({l, *plane});
    std::stable_sort(rings_.begin(), rings_.end(), [](const Ring& one, const Ring& other) {
      return one.plane.area > other.plane.area;
    });
  }

  // Per loop the outer loop of its lid. Around material the outer loop turns left, seen from
  // outside, and an inner loop turns right; within that other material may begin.
  std::vector<std::size_t> outerLoops() {
    std::vector<std::size_t> outer(loops_.size());
    for (std::size_t l = 0; l < outer.size(); ++l) outer[l] = l;
    for (std::size_t i = 1; i < rings_.size(); ++i) {
      const Ring* around = nearestAround(i);
      if (!around || !around->isOuter) continue;
      if (around->plane.normal.dot(rings_[i].plane.normal) > 0) continue;
      rings_[i].isOuter = false;
      outer[rings_[i].loop] = around->loop;
    }
    return outer;
  }

 private:
  const Ring* nearestAround(std::size_t i) const {
    for (std::size_t k = i; k-- > 0;)
      if (isAround(rings_[k], rings_[i])) return &rings_[k];
    return nullptr;
  }

  Vec3 point(std::size_t loop, std::size_t i) const {
    const std::vector<Vertex>& vertices = loops_[loop].vertices;
    return built_.positions[vertices[i % vertices.size()]];
  }

  bool isAround(const Ring& outer, const Ring& inner) const {
    constexpr double kFlattest = 0.005;  // of the outer loop's width
    const auto& [at, across] = outer.plane.place;
    const Vec3& normal = outer.plane.normal;
    if ((inner.plane.place.at - at).norm() > across / 2) return false;
    for (std::size_t i = 0; i < loops_[inner.loop].vertices.size(); ++i)
      if (std::abs((point(inner.loop, i) - at).dot(normal)) > kFlattest * across) return false;
    return turnsAround(outer, point(inner.loop, 0));
  }

  // By the edges that a half line in the plane crosses.
  bool turnsAround(const Ring& outer, const Vec3& p) const {
    Eigen::Index axis = 0;
    outer.plane.normal.cwiseAbs().maxCoeff(&axis);
    const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    bool isInside = false;
    for (std::size_t i = 0; i < loops_[outer.loop].vertices.size(); ++i) {
      const Vec3 a = point(outer.loop, i), b = point(outer.loop, i + 1);
      if ((a[v] > p[v]) == (b[v] > p[v])) continue;
      if (p[u] < a[u] + (p[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u])) isInside = !isInside;
    }
    return isInside;
  }

  const BuiltMesh& built_;
  const std::vector<Loop>& loops_;
  std::vector<Ring> rings_;  // the largest first
};

}  // namespace

std::vector<std::vector<std::size_t>> lidsOf(const BuiltMesh& built,
                                             const std::vector<Loop>& loops) {
  const std::vector<std::size_t> outer = Nesting(built, loops).outerLoops();
  std::vector<std::size_t> numbers(loops.size());
  std::vector<std::vector<std::size_t>> lids;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (outer[l] != l) continue;
    numbers[l] = lids.size();
    lids.push_back({l});
  }
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (outer[l] != l) lids[numbers[outer[l]]].push_back(l);
  return lids;
}

Loop joined(const std::vector<Loop>& loops, const std::vector<std::size_t>& lid) {
  Loop all = loops[lid.front()];
  for (std::size_t i = 1; i < lid.size(); ++i) {
    const Loop& loop = loops[lid[i]];
    all.inner.push_back(Index(all.vertices.size()));
    all.vertices.insert(all.vertices.end(), loop.vertices.begin(), loop.vertices.end());
    all.across.insert(all.across.end(), loop.across.begin(), loop.across.end());
    all.length += loop.length;
  }
  return all;
}

}  // namespace remesher
