// SPDX-License-Identifier: MIT
#include "measure/self_intersections.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/place.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

class Search {
 public:
  // first: the number from which on triangles are looked for.
  explicit Search(const TriangleMesh& mesh, Index first = 0)
      : positions_(mesh.positions),
        corners_(cornerPlaces(mesh)),
        first_(first),
        tree_(positions_, std::span(corners_).subspan(std::size_t{3} * first)),
        counts_(mesh.triangleCount()),
        isHit_(mesh.triangleCount(), 0) {
    for (Index t = 0; t < counts_.size(); ++t) counts_[t] = hasArea(triangle(t).at);
  }

  // groups: one per triangle; those of one group do not count. Or empty.
  std::vector<Index> run(std::span<const Index> groups) {
    tree_.visitPairs([&](Index s, Index t) {
      if (!counts_[s] || !counts_[t] || (isHit_[s] && isHit_[t])) return;
      if (!groups.empty() && groups[s] == groups[t]) return;
      if (trianglesMeet(triangle(s), triangle(t))) isHit_[s] = isHit_[t] = 1;
    });
    return hits();
  }

  // Few are looked for among many: a tree of the few, in which each triangle looks for them.
  std::vector<Index> runFrom() {
    for (Index t = 0; t < counts_.size(); ++t)
      lookAround(t, [&](Index s) {
        if (s != t && !isHit_[s] && trianglesMeet(triangle(s), triangle(t))) isHit_[s] = 1;
      });
    return hits();
  }

  // Those that are looked for and those that meet them.
  std::vector<Index> runBeside() {
    for (Index t = 0; t < counts_.size(); ++t)
      lookAround(t, [&](Index s) {
        if (s <= t && t >= first_) return;  // each pair once
        if (!(isHit_[s] && isHit_[t]) && trianglesMeet(triangle(s), triangle(t)))
          isHit_[s] = isHit_[t] = 1;
      });
    return hits();
  }

 private:
  static std::vector<Index> cornerPlaces(const TriangleMesh& mesh) {
    const std::vector<Index> first = weld(mesh.positions);
    std::vector<Index> corners = mesh.indices;
    for (Index& v : corners) v = first[v];
    return corners;
  }

  NamedTriangle triangle(Index t) const {
    const Index* const v = &corners_[std::size_t{3} * t];
    return {{v[0], v[1], v[2]}, {positions_[v[0]], positions_[v[1]], positions_[v[2]]}};
  }

  template <class Visit>
  void lookAround(Index t, Visit visit) const {
    if (!counts_[t]) return;
    Box box;
    for (const Vec3& p : triangle(t).at) box.extend(p);
    const auto visitCounted = [&](Index found) {
      if (counts_[first_ + found]) visit(first_ + found);
    };
    tree_.visitOverlapping(box, visitCounted);
  }

  std::vector<Index> hits() const {
    std::vector<Index> result;
    for (Index t = 0; t < isHit_.size(); ++t)
      if (isHit_[t]) result.push_back(t);
    return result;
  }

  const std::vector<Vec3>& positions_;
  const std::vector<Index> corners_;  // the first vertex at each corner's place
  const Index first_;
  TriangleTree tree_;
  std::vector<std::uint8_t> counts_;  // per triangle whether it has an area
  std::vector<std::uint8_t> isHit_;
};

// The cells of a grid that the boxes of a few triangles reach into: most triangles of a large mesh
// reach into none.
class ReachedCells {
 public:
  ReachedCells(const TriangleMesh& mesh, std::span<const Index> few) : mesh_(mesh) {
    for (const Index t : few)
      for (const Vec3& p : cornersOf(mesh, t)) box_.extend(p);
    scale_ = kCells / (box_.high - box_.low).array().max(kLeastSide);
    isReached_.assign(std::size_t{kCells} * kCells * kCells, 0);
    std::size_t left = mesh.triangleCount() + isReached_.size();
    for (const Index t : few) {
      const Range cells = cellsOf(boxOf(t));
      const auto count = std::size_t((cells.high - cells.low + 1).prod());
      if (count > left) {
        isReached_.clear();
        return;
      }
      left -= count;
      visit(cells, [](char& isReached) { return !(isReached = 1); });
    }
  }

  bool isNear(Index t) {
    const Box box = boxOf(t);
    if (!box.overlaps(box_)) return false;
    return isReached_.empty() || visit(cellsOf(box), [](char isReached) { return isReached != 0; });
  }

 private:
  static constexpr int kCells = 64;
  static constexpr double kLeastSide = 1e-300;
  struct Range {
    Eigen::Array3i low, high;
  };

  Box boxOf(Index t) const {
    Box box;
    for (const Vec3& p : cornersOf(mesh_, t)) box.extend(p);
    return box;
  }

  Range cellsOf(const Box& box) const {
    const auto cell = [&](const Vec3& p) -> Eigen::Array3i {
      const Eigen::Array3d place = (p - box_.low).array() * scale_;
      return place.max(0).min(kCells - 1).cast<int>();
    };
    return {cell(box.low), cell(box.high)};
  }

  // Until a visit returns true; returns whether one did.
  template <class Visit>
  bool visit(const Range& cells, Visit visit) {
    for (int x = cells.low[0]; x <= cells.high[0]; ++x)
      for (int y = cells.low[1]; y <= cells.high[1]; ++y)
        for (int z = cells.low[2]; z <= cells.high[2]; ++z)
          if (visit(isReached_[std::size_t((x * kCells + y) * kCells + z)])) return true;
    return false;
  }

  const TriangleMesh& mesh_;
  Box box_;
  Eigen::Array3d scale_;
  std::vector<char> isReached_;  // empty: they reach too far to say
};

// These triangles, without the vertices that they do not use.
TriangleMesh onlyOf(const TriangleMesh& mesh, std::span<const Index> triangles) {
  std::vector<Index> numbers(mesh.positions.size(), kNone);
  for (const Index t : triangles)
    for (std::size_t k = 0; k < 3; ++k) numbers[mesh.indices[3 * std::size_t{t} + k]] = 0;
  TriangleMesh only;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == kNone) continue;
    numbers[v] = Index(only.positions.size());
    only.positions.push_back(mesh.positions[v]);
  }
  for (const Index t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      only.indices.push_back(numbers[mesh.indices[3 * std::size_t{t} + k]]);
  return only;
}

}  // namespace

std::vector<Index> selfIntersections(const TriangleMesh& mesh) { return Search(mesh).run({}); }

std::vector<Index> intersectionsOfGroups(const TriangleMesh& mesh) {
  return Search(mesh).run(mesh.groups);
}

std::vector<Index> selfIntersectionsFrom(const TriangleMesh& mesh, Index first) {
  return Search(mesh, first).runFrom();
}

std::vector<Index> selfIntersectionsBeside(const TriangleMesh& mesh,
                                           std::span<const std::uint8_t> isApart) {
  const auto apart = std::size_t(std::count(isApart.begin(), isApart.end(), std::uint8_t{1}));
  if (2 * apart < isApart.size()) return selfIntersections(mesh);
  std::vector<Index> few, order;
  for (Index t = 0; t < isApart.size(); ++t)
    if (!isApart[t]) few.push_back(t);
  if (few.empty()) return {};
  ReachedCells cells(mesh, few);
  for (Index t = 0; t < isApart.size(); ++t)
    if (isApart[t] && cells.isNear(t)) order.push_back(t);
  const auto first = Index(order.size());
  order.insert(order.end(), few.begin(), few.end());
  std::vector<Index> found = Search(onlyOf(mesh, order), first).runBeside();
  for (Index& t : found) t = order[t];
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace remesher
