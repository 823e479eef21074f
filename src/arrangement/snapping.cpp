// SPDX-License-Identifier: MIT
#include "arrangement/snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/patience.h"
#include "geometry/divided_edges.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

constexpr int kMostSnaps = 24;

constexpr double kStepsPerFacet = 16;  // to gather or to make one

using Corners = std::array<Index, 3>;
using Ends = std::array<Index, 2>;
using Cell = std::array<double, 3>;

// Where two segments are nearest to each other, as shares of both; none at an end of either.
std::optional<std::array<double, 2>> nearestShares(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   const Vec3& d) {
  constexpr double kParallel = 1e-12;
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double area = uu * vv - uv * uv;
  if (area <= kParallel * uu * vv) return std::nullopt;
  const double s = (uv * vw - vv * uw) / area, t = (uu * vw - uv * uw) / area;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return std::nullopt;
  return std::array{s, t};
}

class Snapping {
 public:
  Snapping(std::vector<Vec3>& positions, KeptFacets& facets, const SnapRule& rule)
      : positions_(positions), facets_(facets), rule_(rule), budget_(double(rule.mostWork)) {}

  bool run(std::span<const Index> crossing) {
    markNear(crossing);
    // Edges meet once: parts of facets have edges of their own, which would meet others again.
    bool isDivided = true, isMet = false;
    for (int pass = 0; pass < kMostSnaps && isDivided && !budget_.isSpent(); ++pass) {
      weldNear();
      gather();
      isDivided =
          divideAtPoints() || divideInside() || (!std::exchange(isMet, true) && divideAtEdges());
    }
    dropVanished();
    return !budget_.isSpent();
  }

 private:
  Corners corners(Index f) const {
    return {facets_.corners[3 * f], facets_.corners[3 * f + 1], facets_.corners[3 * f + 2]};
  }
  std::size_t size() const { return facets_.from.size(); }
  const Vec3& at(Index point) const { return positions_[point]; }
  bool areNear(const Vec3& p, const Vec3& q) const {
    return (p - q).squaredNorm() <= rule_.tolerance * rule_.tolerance;
  }
  Box around(std::initializer_list<Vec3> points) const {
    Box box;
    for (const Vec3& p : points) {
      box.extend(p - Vec3::Constant(rule_.tolerance));
      box.extend(p + Vec3::Constant(rule_.tolerance));
    }
    return box;
  }

  // The facets that intersect others, and those at their corners.
  void markNear(std::span<const Index> crossing) {
    std::vector<std::uint8_t> isAt(positions_.size(), 0);
    for (const Index f : crossing)
      for (const Index p : corners(f)) isAt[p] = 1;
    isNear_.assign(size(), 0);
    for (Index f = 0; f < size(); ++f)
      for (const Index p : corners(f)) isNear_[f] |= isAt[p];
  }

  static bool hasTwins(const Corners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }

  void dropVanished() {
    Index kept = 0;
    for (Index f = 0; f < size(); ++f) {
      const Corners c = corners(f);
      if (hasTwins(c)) continue;
      std::copy(c.begin(), c.end(), facets_.corners.begin() + std::ptrdiff_t{3} * kept);
      facets_.from[kept++] = facets_.from[f];
    }
    facets_.from.resize(kept);
    facets_.corners.resize(std::size_t{3} * kept);
  }

  // The near facets that have three corners, and their corners.
  void gather() {
    near_.clear(), nearCorners_.clear(), points_.clear();
    for (Index f = 0; f < size(); ++f) {
      const Corners c = corners(f);
      if (!isNear_[f] || hasTwins(c)) continue;
      near_.push_back(f);
      nearCorners_.insert(nearCorners_.end(), c.begin(), c.end());
    }
    budget_.spend(kStepsPerFacet * double(near_.size()));
    points_ = nearCorners_;
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    asTriangles_.clear();
    for (const Index p : points_) asTriangles_.insert(asTriangles_.end(), {p, p, p});
  }

  // Of points near each other the one with the lowest number stays. Those that stay are in a grid:
  // few of them are near any place, where thousands of points may be.
  void weldNear() {
    gather();
    std::map<Cell, std::vector<Index>> staying;
    bool isAny = false;
    std::vector<Index> stays(positions_.size(), kNone);
    for (const Index p : points_) {
      const Cell cell = cellOf(at(p));
      Index best = p;
      for (int i = 0; i < 27; ++i) {
        const auto found =
            staying.find({cell[0] + (i % 3 - 1), cell[1] + (i / 3 % 3 - 1), cell[2] + (i / 9 - 1)});
        if (found == staying.end()) continue;
        for (const Index q : found->second)
          if (q < best && areNear(at(p), at(q))) best = q;
      }
      stays[p] = best;
      isAny |= best != p;
      if (best == p) staying[cell].push_back(p);
    }
    if (!isAny) return;
    for (Index& corner : facets_.corners)
      if (stays[corner] != kNone) corner = stays[corner];
  }

  // As wide as the tolerance, or a little more.
  Cell cellOf(const Vec3& p) const {
    constexpr double kWider = 1.001;
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = std::floor(p[Eigen::Index(k)] / (kWider * rule_.tolerance));
    return cell;
  }

  // The share of the way from a to b where p lies on the edge between them; 0 if it does not.
  double shareOn(const Vec3& a, const Vec3& b, const Vec3& p) const {
    if (areNear(p, a) || areNear(p, b)) return 0;
    const Vec3 edge = b - a;
    const double share = (p - a).dot(edge) / edge.squaredNorm();
    return share > 0 && share < 1 && areNear(p, a + share * edge) ? share : 0;
  }

  std::set<Ends> nearEdges() const {
    std::set<Ends> edges;
    for (std::size_t i = 0; i < nearCorners_.size(); ++i) {
      const Index a = nearCorners_[i], b = nearCorners_[i % 3 == 2 ? i - 2 : i + 1];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
    return edges;
  }

  bool divideAtPoints() {
    const TriangleTree tree(positions_, asTriangles_);
    DividedEdges edges;
    for (const auto& [a, b] : nearEdges())
      tree.visitOverlapping(around({at(a), at(b)}), [&, a = a, b = b](Index i) {
        budget_.spend(1);
        const Index p = points_[i];
        if (p == a || p == b) return;
        const double share = shareOn(at(a), at(b), at(p));
        if (share > 0 && isDivided_.insert({a, b, p}).second) edges.add(a, b, share, p);
      });
    return divide(edges);
  }

  bool divideAtEdges() {
    const std::set<Ends> all = nearEdges();
    const std::vector<Ends> list(all.begin(), all.end());
    std::vector<Index> asTriangles;
    for (const auto& [a, b] : list) asTriangles.insert(asTriangles.end(), {a, b, b});
    std::vector<std::array<Index, 2>> pairs;
    const TriangleTree tree(positions_, asTriangles);
    for (Index e = 0; e < list.size(); ++e)
      tree.visitOverlapping(around({at(list[e][0]), at(list[e][1])}), [&](Index g) {
        if (e < g) pairs.push_back({e, g});
      });
    std::sort(pairs.begin(), pairs.end());
    DividedEdges edges;
    for (const auto& [e, g] : pairs) meet(list[e], list[g], edges);
    return divide(edges);
  }

  // A common point where two edges pass each other.
  void meet(const Ends& one, const Ends& other, DividedEdges& edges) {
    const auto [a, b] = one;
    const auto [c, d] = other;
    if (a == c || a == d || b == c || b == d) return;
    const auto shares = nearestShares(at(a), at(b), at(c), at(d));
    if (!shares) return;
    const auto [s, t] = *shares;
    const Vec3 p = at(a) + s * (at(b) - at(a)), q = at(c) + t * (at(d) - at(c));
    if (!areNear(p, q)) return;
    const Vec3 place = rule_.rounded((p + q) / 2);
    for (const Index end : {a, b, c, d})
      if (areNear(place, at(end))) return;
    positions_.push_back(place);
    const Index made = Index(positions_.size() - 1);
    edges.add(a, b, s, made);
    edges.add(c, d, t, made);
  }

  // Points on facets divide these into three, one in each.
  bool divideInside() {
    const TriangleTree tree(positions_, asTriangles_);
    bool isAny = false;
    for (const Index f : near_) {
      if (budget_.isSpent()) break;
      const Corners c = corners(f);
      Index best = kNone;
      tree.visitOverlapping(around({at(c[0]), at(c[1]), at(c[2])}), [&](Index i) {
        budget_.spend(1);
        const Index p = points_[i];
        if (p < best && std::find(c.begin(), c.end(), p) == c.end() && isOn(c, at(p))) best = p;
      });
      if (best == kNone) continue;
      isAny = true;
      const FacetParent from = facets_.from[f];
      facets_.corners[3 * f + 2] = best;
      append({c[1], c[2], best}, from);
      append({c[2], c[0], best}, from);
    }
    return isAny;
  }

  bool isOn(const Corners& c, const Vec3& p) const {
    const Vec3 w = closestBarycentric(p, at(c[0]), at(c[1]), at(c[2]));
    return w.minCoeff() > 0 && areNear(p, w[0] * at(c[0]) + w[1] * at(c[1]) + w[2] * at(c[2]));
  }

  void append(const Corners& c, const FacetParent& from) {
    facets_.corners.insert(facets_.corners.end(), c.begin(), c.end());
    facets_.from.push_back(from);
    isNear_.push_back(1);
    budget_.spend(kStepsPerFacet);
  }

  // All facets at divided edges. Returns whether there are any.
  bool divide(const DividedEdges& edges) {
    if (edges.empty()) return false;
    const std::size_t before = size();
    std::vector<std::uint8_t> isEnd(positions_.size(), 0);  // of an edge that may be divided
    for (const Index p : points_) isEnd[p] = 1;
    for (Index f = 0; f < before; ++f) {
      const Corners c = corners(f);
      if (isEnd[c[0]] + isEnd[c[1]] + isEnd[c[2]] < 2) continue;
      const std::vector<Corners> made = parts(c, edges);
      if (made.size() == 1 && made.front() == c) continue;
      const FacetParent from = facets_.from[f];
      // A facet that vanishes gets one corner twice.
      const Corners first = made.empty() ? Corners{c[0], c[0], c[0]} : made.front();
      std::copy(first.begin(), first.end(), facets_.corners.begin() + std::ptrdiff_t{3} * f);
      isNear_[f] = 1;
      for (std::size_t i = 1; i < made.size(); ++i) append(made[i], from);
    }
    return true;
  }

  std::vector<Corners> parts(const Corners& c, const DividedEdges& edges) const {
    std::vector<Index> outline;
    for (std::size_t k = 0; k < 3; ++k) {
      outline.push_back(c[k]);
      const std::vector<Index> between = edges.between(c[k], c[(k + 1) % 3]);
      outline.insert(outline.end(), between.begin(), between.end());
    }
    if (outline.size() == 3) return {c};
    std::vector<Index> sorted = outline;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end())
      return divided(c, edges, positions_);
    std::vector<Corners> result;
    fill(std::move(outline), result);
    return result;
  }

  // An outline that has a point twice: that of a needle, a corner of which lies on the side across.
  static void fill(std::vector<Index> outline, std::vector<Corners>& result) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      for (std::size_t k = i + 1; k < outline.size(); ++k) {
        if (outline[i] != outline[k]) continue;
        const auto from = outline.begin() + std::ptrdiff_t(i),
                   to = outline.begin() + std::ptrdiff_t(k);
        fill({from, to}, result);
        outline.erase(from, to);
        fill(std::move(outline), result);
        return;
      }
    for (std::size_t i = 2; i < outline.size(); ++i)
      result.push_back({outline[0], outline[i - 1], outline[i]});
  }

  std::vector<Vec3>& positions_;
  KeptFacets& facets_;
  const SnapRule& rule_;
  WorkBudget budget_;
  std::vector<std::uint8_t> isNear_;  // per facet
  // Edges with points that divided them: once, because a needle that is flipped may leave another,
  // which would be flipped back.
  std::set<std::array<Index, 3>> isDivided_;
  std::vector<Index> near_, nearCorners_;  // three corners per near facet
  std::vector<Index> points_;              // their corners, in order
  std::vector<Index> asTriangles_;         // for trees: each point three times
};

}  // namespace

bool snapTogether(std::vector<Vec3>& positions, KeptFacets& facets, std::span<const Index> crossing,
                  const SnapRule& rule) {
  return Snapping(positions, facets, rule).run(crossing);
}

}  // namespace remesher
