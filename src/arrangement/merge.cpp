// SPDX-License-Identifier: MIT
#include "arrangement/merge.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// Larger stars are left as they are: filling them takes the cube of this number.
constexpr std::size_t kLargestStar = 48;
constexpr int kPasses = 8;
// Radians. Angles that differ by less are the same, rounded: compilers sum in different orders.
constexpr double kSameAngle = 1e-9;

// A side of a polygon: from this point to the next side's, along a facet with this origin.
struct PolygonSide {
  Index point;
  FacetParent from;
};
using Polygon = std::vector<PolygonSide>;

struct NewFacet {
  std::array<Index, 3> corners;
  FacetParent from;
};

class Merging {
 public:
  Merging(const PointPool& points, const ArrangedTriangles& triangles,
          std::span<const Index> classes, const Facets& all, InsideBoundary boundary)
      : points_(points),
        triangles_(triangles),
        classes_(classes),
        all_(all),
        facets_(std::move(boundary.kept)),
        before_(std::move(boundary.facets)) {}

  KeptFacets run() {
    std::vector<Index> candidates = gather();
    for (int pass = 0; pass < kPasses && !candidates.empty(); ++pass) {
      std::vector<Index> left;
      for (const Index point : candidates)
        if (!remove(point)) left.push_back(point);
      if (left.size() == candidates.size()) break;
      candidates = std::move(left);
    }
    compact();
    return std::move(facets_);
  }

 private:
  std::array<Index, 3> corners(Index f) const {
    return {facets_.corners[3 * f], facets_.corners[3 * f + 1], facets_.corners[3 * f + 2]};
  }
  bool isAlive(Index f) const { return facets_.corners[3 * f] != kNone; }

  // The points that were brought into triangles, by position; and the facets at them and their
  // neighbours.
  std::vector<Index> gather() {
    std::vector<std::uint8_t> isNear(points_.size(), 0), isFound(points_.size(), 0);
    std::vector<Index> found;
    for (Index f = 0; f < facets_.from.size(); ++f) {
      const std::array<Index, 3> c = corners(f);
      for (const Index p : c) {
        if (!originOf(f, p)) continue;
        if (!isFound[p]) found.push_back(p);
        isFound[p] = 1;
        for (const Index q : c) isNear[q] = 1;
      }
    }
    facetsAt_.resize(points_.size());
    for (Index f = 0; f < facets_.from.size(); ++f)
      for (const Index p : corners(f))
        if (isNear[p]) facetsAt_[p].push_back(f);
    std::sort(found.begin(), found.end(),
              [this](Index p, Index q) { return points_.isBefore(p, q); });
    return found;
  }

  // A triangle that the facet is a part of and that has no corner at the point.
  std::optional<FacetParent> originOf(Index f, Index point) const {
    const auto isFree = [&](const FacetParent& p) {
      const GivenPlane c = triangles_[p.triangle];
      return std::find(c.begin(), c.end(), point) == c.end();
    };
    if (isFree(facets_.from[f])) return facets_.from[f];
    if (before_[f] == kNone) return std::nullopt;
    const FacetParent& from = facets_.from[f];
    for (const FacetParent& p : all_.parentsOf(before_[f]))
      if (p.sign == signOf(f) * from.sign && isFree(p)) return FacetParent{p.triangle, from.sign};
    return std::nullopt;
  }

  // 1 if the facet is still oriented as it was before some were kept.
  int signOf(Index f) const {
    for (const FacetParent& p : all_.parentsOf(before_[f]))
      if (p.triangle == facets_.from[f].triangle) return p.sign * facets_.from[f].sign;
    return 1;
  }

  // The sides across from the point, one after the other around it, from the least point on; none
  // if its facets are no disk.
  Polygon linkOf(Index point) const {
    Polygon sides;
    std::vector<Index> ends;
    for (const Index f : facetsAt_[point]) {
      const std::array<Index, 3> c = corners(f);
      const auto k = static_cast<std::size_t>(std::find(c.begin(), c.end(), point) - c.begin());
      const std::optional<FacetParent> from = originOf(f, point);
      if (!from) return {};
      sides.push_back({c[(k + 1) % 3], *from});
      ends.push_back(c[(k + 2) % 3]);
    }
    if (sides.size() < 3 || sides.size() > kLargestStar) return {};
    std::size_t at = 0;
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (points_.isBefore(sides[i].point, sides[at].point)) at = i;
    Polygon link;
    const Index first = sides[at].point;
    for (;;) {
      link.push_back(sides[at]);
      const Index end = ends[at];
      if (end == first || link.size() == sides.size()) {
        return end == first && link.size() == sides.size() ? link : Polygon{};
      }
      std::size_t next = sides.size();
      for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i].point == end) {
          if (next != sides.size()) return {};  // more than two facets at an edge
          next = i;
        }
      if (next == sides.size()) return {};
      at = next;
    }
  }

  bool remove(Index point) {
    const Polygon link = linkOf(point);
    std::vector<std::size_t> borders;
    for (std::size_t i = 0; i < link.size(); ++i)
      if (!areJoinable(link[(i + link.size() - 1) % link.size()].from, link[i].from))
        borders.push_back(i);
    if (link.empty() || borders.size() == 1 || borders.size() > 2) return false;
    std::vector<NewFacet> filling;
    if (borders.empty()) {
      if (!fill(link, filling)) return false;
    } else {
      const Index from = link[borders[0]].point, to = link[borders[1]].point;
      if (!isBetween(point, from, to)) return false;
      if (!fill(part(link, borders[0], borders[1]), filling)) return false;
      if (!fill(part(link, borders[1], borders[0]), filling)) return false;
      if (isEdgeBeside(point, from, to)) return false;
    }
    for (const NewFacet& facet : filling)
      for (std::size_t k = 0; k < 3; ++k)
        if (isNewEdge(link, facet.corners[k], facet.corners[(k + 1) % 3]) &&
            isEdgeBeside(point, facet.corners[k], facet.corners[(k + 1) % 3]))
          return false;
    replace(point, filling);
    return true;
  }

  // From one corner to another, both included, and closed by the straight side between them.
  static Polygon part(const Polygon& link, std::size_t from, std::size_t to) {
    Polygon result;
    for (std::size_t i = from; i != to; i = (i + 1) % link.size()) result.push_back(link[i]);
    result.push_back({link[to].point, result.back().from});
    return result;
  }

  bool areJoinable(const FacetParent& a, const FacetParent& b) {
    if (a.triangle == b.triangle) return true;
    if (!classes_.empty() && classes_[a.triangle] != classes_[b.triangle]) return false;
    const auto [known, isNew] = joinable_.emplace(std::minmax(a.triangle, b.triangle), false);
    if (!isNew) return known->second;
    const GivenPlane p = triangles_[a.triangle], q = triangles_[b.triangle];
    if (std::any_of(q.begin(), q.end(), [&](Index c) { return points_.above(p, c) != 0; }))
      return false;
    const FlatView view = points_.viewOf(p);
    const int turns = points_.turn(p[0], p[1], p[2], view) * points_.turn(q[0], q[1], q[2], view);
    return known->second = turns * a.sign * b.sign > 0;
  }

  bool isBetween(Index point, Index a, Index b) const {
    for (Eigen::Index left = 0; left < 3; ++left)
      if (points_.turn(a, point, b, FlatView{left}) != 0) return false;
    const Vec3 &p = points_.position(a), &q = points_.position(b), &x = points_.position(point);
    Eigen::Index axis = 0;
    (q - p).cwiseAbs().maxCoeff(&axis);
    return (x[axis] - p[axis]) * (q[axis] - x[axis]) > 0;
  }

  // Cuts off the ear with the widest smallest angle, again and again. False if that cannot be done
  // without turning a facet over.
  bool fill(Polygon polygon, std::vector<NewFacet>& filling) const {
    const GivenPlane plane = triangles_[polygon.front().from.triangle];
    const FlatView view = points_.viewOf(plane);
    const int sign = polygon.front().from.sign * points_.turn(plane[0], plane[1], plane[2], view);
    while (polygon.size() >= 3) {
      const std::size_t n = polygon.size();
      std::size_t best = n;
      double widest = -1;
      for (std::size_t i = 0; i < n; ++i) {
        const Index a = polygon[(i + n - 1) % n].point, b = polygon[i].point,
                    c = polygon[(i + 1) % n].point;
        const double angle =
            minAngle(points_.position(a), points_.position(b), points_.position(c));
        if (angle > widest + kSameAngle && isEar(polygon, i, view, sign)) widest = angle, best = i;
      }
      if (best == n) return false;
      PolygonSide& before = polygon[(best + n - 1) % n];
      const PolygonSide& ear = polygon[best];
      if (ear.from.triangle < before.from.triangle) before.from = ear.from;
      filling.push_back({{before.point, ear.point, polygon[(best + 1) % n].point}, before.from});
      polygon.erase(polygon.begin() + std::ptrdiff_t(best));
    }
    return true;
  }

  bool isEar(const Polygon& polygon, std::size_t i, FlatView view, int sign) const {
    const std::size_t n = polygon.size();
    const std::array<Index, 3> c = {polygon[(i + n - 1) % n].point, polygon[i].point,
                                    polygon[(i + 1) % n].point};
    if (sign * points_.turn(c[0], c[1], c[2], view) <= 0) return false;
    for (const PolygonSide& side : polygon) {
      if (std::find(c.begin(), c.end(), side.point) != c.end()) continue;
      bool isWithin = true;
      for (std::size_t k = 0; k < 3 && isWithin; ++k)
        isWithin = sign * points_.turn(c[k], c[(k + 1) % 3], side.point, view) >= 0;
      if (isWithin) return false;
    }
    return true;
  }

  static bool isNewEdge(const Polygon& link, Index a, Index b) {
    for (std::size_t i = 0; i < link.size(); ++i) {
      const Index from = link[i].point, to = link[(i + 1) % link.size()].point;
      if ((a == from && b == to) || (a == to && b == from)) return false;
    }
    return true;
  }

  // Whether the two are joined by an edge of a facet that is not at the point.
  bool isEdgeBeside(Index point, Index a, Index b) const {
    return std::any_of(facetsAt_[a].begin(), facetsAt_[a].end(), [&](Index f) {
      const std::array<Index, 3> c = corners(f);
      return std::find(c.begin(), c.end(), b) != c.end() &&
             std::find(c.begin(), c.end(), point) == c.end();
    });
  }

  void replace(Index point, const std::vector<NewFacet>& filling) {
    const std::vector<Index> old = std::exchange(facetsAt_[point], {});
    for (const Index f : old) {
      for (const Index p : corners(f))
        if (p != point) std::erase(facetsAt_[p], f);
      facets_.corners[3 * f] = kNone;
    }
    // The filling has two facets less.
    for (std::size_t i = 0; i < filling.size(); ++i) {
      std::copy(filling[i].corners.begin(), filling[i].corners.end(),
                facets_.corners.begin() + std::ptrdiff_t{3} * old[i]);
      facets_.from[old[i]] = filling[i].from;
      before_[old[i]] = kNone;
      for (const Index p : filling[i].corners) facetsAt_[p].push_back(old[i]);
    }
  }

  void compact() {
    std::size_t kept = 0;
    for (Index f = 0; f < facets_.from.size(); ++f) {
      if (!isAlive(f)) continue;
      const std::array<Index, 3> c = corners(f);
      std::copy(c.begin(), c.end(), facets_.corners.begin() + std::ptrdiff_t(3 * kept));
      facets_.from[kept++] = facets_.from[f];
    }
    facets_.from.resize(kept);
    facets_.corners.resize(3 * kept);
  }

  const PointPool& points_;
  const ArrangedTriangles& triangles_;
  std::span<const Index> classes_;
  const Facets& all_;
  KeptFacets facets_;
  std::vector<Index> before_;  // per facet its number among all; kNone for one that was made since
  std::vector<std::vector<Index>> facetsAt_;  // per point, near new points
  std::map<std::pair<Index, Index>, bool> joinable_;
};

}  // namespace

KeptFacets mergedFacets(const PointPool& points, const ArrangedTriangles& triangles,
                        std::span<const Index> classes, const Facets& all,
                        InsideBoundary boundary) {
  return Merging(points, triangles, classes, all, std::move(boundary)).run();
}

}  // namespace remesher
