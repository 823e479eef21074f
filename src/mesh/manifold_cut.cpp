// SPDX-License-Identifier: MIT
#include "mesh/manifold_cut.h"

#include <algorithm>
#include <utility>

#include "base/fires.h"

namespace remesher {

namespace {

// An edge with more triangles than this has no sensible pairs: all are cut apart.
constexpr std::size_t kMaxTrianglesPaired = 64;

// Triangles by their corners, grouped by edge.
struct Corners {
  std::span<const Vec3> positions;
  std::span<const Index> corners;
  const EdgeGroups& edges;

  bool upward(Index h) const { return corners[h] < corners[nextCorner(h)]; }
  // Whether two triangles at one edge are the two sides of one triangle.
  bool mirrored(Index h, Index other) const {
    return upward(h) != upward(other) && corners[prevCorner(h)] == corners[prevCorner(other)];
  }
};

struct Pair {
  double bend;
  Index up, down;
  bool operator<(const Pair& other) const {
    if (bend != other.bend) return bend < other.bend;
    return up != other.up ? up < other.up : down < other.down;
  }
};

Vec3 normalAt(const Corners& soup, Index h) {
  const Vec3& a = soup.positions[soup.corners[h]];
  const Vec3& b = soup.positions[soup.corners[nextCorner(h)]];
  const Vec3& c = soup.positions[soup.corners[prevCorner(h)]];
  return (b - a).cross(c - a).stableNormalized();
}

// 0 for a flat continuation, 2 for a fold. Of two equal bends the convex one counts as smaller, so
// that two solids that touch along an edge are separated.
double bend(const Corners& soup, Index h, Index other) {
  const Vec3 normal = normalAt(soup, h);
  const Vec3 away =
      soup.positions[soup.corners[prevCorner(other)]] - soup.positions[soup.corners[other]];
  // The penalty of a reflex angle is beyond rounding, and below any angle that matters.
  return 1 - normal.dot(normalAt(soup, other)) + (normal.dot(away) > 0 ? kSingleRoundOff : 0);
}

// Per triangle whether it belongs to a sheet given with both sides: one of its edges has several
// triangles, and each of these has a mirror image.
std::vector<char> findTwoSided(const Corners& soup) {
  std::vector<char> twoSided(soup.corners.size() / 3, 0);
  for (std::size_t e = 0; e < soup.edges.size(); ++e) {
    const std::span<const Index> group = soup.edges[e];
    if (group.size() < 4 || group.size() > kMaxTrianglesPaired) continue;
    const bool all = std::all_of(group.begin(), group.end(), [&](Index h) {
      return std::any_of(group.begin(), group.end(), [&](Index k) { return soup.mirrored(h, k); });
    });
    for (std::size_t i = 0; all && i < group.size(); ++i) twoSided[group[i] / 3] = 1;
  }
  return twoSided;
}

// The two sides of such a sheet are not joined at its rim: they would share every edge between two
// rim vertices.
bool canJoin(const Corners& soup, const std::vector<char>& twoSided, Index h, Index other) {
  return soup.upward(h) != soup.upward(other) &&
         !(soup.mirrored(h, other) && twoSided[h / 3] && twoSided[other / 3]);
}

void join(Index h, Index other, std::vector<Index>& mates) {
  mates[h] = other;
  mates[other] = h;
}

// Per halfedge the one it stays joined to, or kNone. Joined halfedges run in opposite directions.
std::vector<Index> pairHalfedges(const Corners& soup) {
  const std::vector<char> twoSided = findTwoSided(soup);
  std::vector<Index> mates(soup.corners.size(), kNone);
  std::vector<Pair> pairs;
  for (std::size_t e = 0; e < soup.edges.size(); ++e) {
    const std::span<const Index> group = soup.edges[e];
    if (group.size() == 2 && canJoin(soup, twoSided, group[0], group[1]))
      join(group[0], group[1], mates);
    if (group.size() > kMaxTrianglesPaired) fires("manifold cut: edge with too many triangles");
    if (group.size() <= 2 || group.size() > kMaxTrianglesPaired) continue;
    pairs.clear();
    for (const Index up : group)
      for (const Index down : group)
        if (soup.upward(up) && canJoin(soup, twoSided, up, down))
          pairs.push_back({bend(soup, up, down), up, down});
    std::sort(pairs.begin(), pairs.end());
    for (const Pair& pair : pairs)
      if (mates[pair.up] == kNone && mates[pair.down] == kNone) join(pair.up, pair.down, mates);
  }
  return mates;
}

// Two edges cut apart may still share both end vertices, if a fan connects them at each end. Then
// their pairs are cut too, which separates these fans. One pass suffices: separating fans never
// merges vertices, and a fan has only one end in each direction.
bool cutDoubleEdges(const Corners& soup, const ManifoldCut& cut, std::vector<Index>& mates) {
  bool any = false;
  std::vector<Index> doubled;
  for (std::size_t e = 0; e < soup.edges.size(); ++e) {
    const std::span<const Index> group = soup.edges[e];
    if (group.size() <= 2 || group.size() > kMaxTrianglesPaired) continue;
    const auto ends = [&](Index h) {
      const Index from = cut.corners[h], to = cut.corners[nextCorner(h)];
      return soup.upward(h) ? std::pair(from, to) : std::pair(to, from);
    };
    doubled.clear();
    for (const Index h : group)
      for (const Index other : group)
        if (other != h && other != mates[h] && ends(other) == ends(h)) doubled.push_back(h);
    for (const Index h : doubled) {
      any = any || mates[h] != kNone;
      mates[h] = kNone;
    }
  }
  return any;
}

void countCuts(const Corners& soup, std::span<const Index> mates, ManifoldCut& cut) {
  std::vector<char> counted(soup.positions.size(), 0);
  for (std::size_t e = 0; e < soup.edges.size(); ++e) {
    const std::span<const Index> group = soup.edges[e];
    const bool apart = group.size() == 2 && mates[group[0]] == kNone;
    if (group.size() <= 2 && !apart) continue;
    cut.edges += group.size() > 2;
    counted[soup.corners[group[0]]] = counted[soup.corners[nextCorner(group[0])]] = 1;
  }
  countVertices(std::move(counted), cut);
}

}  // namespace

ManifoldCut cutToManifold(std::span<const Vec3> positions, std::span<const Index> corners,
                          const EdgeGroups& edges) {
  const Corners soup{positions, corners, edges};
  ManifoldCut cut;
  std::vector<Index> mates = pairHalfedges(soup);
  splitFans(corners, positions.size(), mates, cut);
  if (cutDoubleEdges(soup, cut, mates)) splitFans(corners, positions.size(), mates, cut);
  countCuts(soup, mates, cut);
  return cut;
}

}  // namespace remesher
