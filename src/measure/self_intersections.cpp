// SPDX-License-Identifier: MIT
#include "measure/self_intersections.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

#include "base/place.h"
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
  std::vector<Index> order(isApart.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_partition(order.begin(), order.end(), [&](Index t) { return isApart[t] != 0; });
  TriangleMesh sorted;
  sorted.positions = mesh.positions;
  for (const Index t : order) {
    const Index* const v = &mesh.indices[std::size_t{3} * t];
    sorted.indices.insert(sorted.indices.end(), v, v + 3);
  }
  std::vector<Index> found = Search(sorted, Index(apart)).runBeside();
  for (Index& t : found) t = order[t];
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace remesher
