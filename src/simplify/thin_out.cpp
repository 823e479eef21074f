// SPDX-License-Identifier: MIT
#include "simplify/thin_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

#include "base/place.h"
#include "geometry/triangle.h"
#include "mesh/submesh.h"
#include "mesh/used_vertices.h"
#include "simplify/local_quadric.h"
#include "simplify/slabs.h"

namespace remesher {
namespace {

// See kSideways, kBorder and kTurned in simplify.cpp.
constexpr double kSidewaysWeight = 5e-6, kBorderWeight = 2, kLeastTurn = 0.5;
// A pass removes at most the first part of the vertices (1/2), the cheapest; the next one knows the
// new costs. Passes end when one removes less than the second part.
constexpr std::size_t kPassPart = 2, kLeastPart = 200;
// It takes them in so many slices, the cheaper one first.
constexpr std::size_t kSlices = 4;
// Below this share of the longest edge's square, twice the area of a triangle may not shrink.
constexpr double kThin = 0.05;
// Slabs are left with so many times the vertices wanted, since some parts of the surface need more.
constexpr std::size_t kLeftBySlabs = 2;
// A mesh of fewer triangles for each vertex that slabs would leave is thinned out whole.
constexpr double kLeastForSlabs = 2.5;

// A neighbour of a vertex: the triangles before and after the edge to it, and whether the edge is a
// border.
struct RingEdge {
  Index neighbor;
  int out = 0, in = 0;
  Index side = kNone;  // the group of a triangle at it, and whether that has a back
  bool isBorder = false;
  bool isOpen() const { return out + in == 1; }
};

// The kind of a vertex, which never changes, since the topology stays.
enum class Kind : char { Inner, OnBorder, Fixed };

// The neighbour that a vertex would collapse into, and the cost of that.
struct Going {
  Index into = kNone;
  float cost = 0;
};

class ThinningOut {
 public:
  ThinningOut(TriangleMesh& mesh, ThinOut wanted)
      : mesh_(mesh),
        borders_(wanted.borders),
        kinds_(mesh.positions.size(), Kind::Inner),
        isTouched_(mesh.positions.size(), 0) {
    joinEqual(std::move(wanted.first));
    setScale();
    const std::vector<Kind> kinds = kinds_;
    std::size_t unused = 0;
    bool isLess = false;
    do {
      kinds_ = kinds;
      gatherStars();
      measureVertices();
      isLess = isCrowded_ && dropTwins(wanted.repeated ? *wanted.repeated : unused);
    } while (isLess);
  }

  void run(std::size_t wanted) {
    while (count_ > wanted) {
      const std::size_t before = count_;
      pass(wanted);
      gatherStars();
      if (before - count_ < before / kLeastPart + 1) break;
    }
    giveBack();
  }

 private:
  // Vertices at one place that differ in an attribute stay.
  void joinEqual(std::vector<Index> first) {
    if (first.empty()) first = weld(mesh_.positions);
    std::vector<Index> number(first.size());
    for (Index v = 0; v < first.size(); ++v) {
      const bool isEqual = first[v] == v || haveSameAttributes(mesh_, v, first[v]);
      number[v] = isEqual ? first[v] : v;
      if (!isEqual) kinds_[v] = kinds_[first[v]] = Kind::Fixed;
    }
    for (Index& corner : mesh_.indices) corner = number[corner];
  }

  void setScale() {
    Vec3 low = mesh_.positions[mesh_.indices.front()], high = low;
    for (const Index v : mesh_.indices) {
      low = low.cwiseMin(mesh_.positions[v]);
      high = high.cwiseMax(mesh_.positions[v]);
    }
    const double edge = (high - low).norm() / std::sqrt(double(mesh_.triangleCount()));
    if (edge > 0) scale_ = std::exp2(-std::round(std::log2(edge)));
  }

  // Drops triangles that have no three vertices, and lists those at each vertex.
  void gatherStars() {
    std::size_t kept = 0;
    std::vector<Index>& corners = mesh_.indices;
    begins_.assign(mesh_.positions.size() + 1, 0);
    for (std::size_t t = 0; t < mesh_.triangleCount(); ++t) {
      const Index a = corners[3 * t], b = corners[3 * t + 1], c = corners[3 * t + 2];
      if (a == b || b == c || c == a) continue;
      for (const Index v : {a, b, c}) ++begins_[v];
      if (!mesh_.groups.empty()) mesh_.groups[kept] = mesh_.groups[t];
      if (!hasBack_.empty()) hasBack_[kept] = hasBack_[t];
      corners[3 * kept] = a, corners[3 * kept + 1] = b, corners[3 * kept + 2] = c;
      ++kept;
    }
    corners.resize(3 * kept);
    if (!mesh_.groups.empty()) mesh_.groups.resize(kept);
    if (!hasBack_.empty()) hasBack_.resize(kept);
    count_ = 0;
    Index sum = 0;
    for (Index& begin : begins_) {
      count_ += begin > 0 ? 1 : 0;
      sum += begin;
      begin = sum;
    }
    triangles_.resize(corners.size());
    for (std::size_t i = corners.size(); i-- > 0;) triangles_[--begins_[corners[i]]] = Index(i / 3);
  }

  // Of triangles with the same corners the first stays. Those in its order repeat it; the first in
  // the other order, of the same group, is its back. Returns whether any went.
  bool dropTwins(std::size_t& repeated) {
    bool isLess = false;
    hasBack_.resize(mesh_.triangleCount(), 0);
    for (Index t = 0; t < hasBack_.size(); ++t) {
      Index* const corners = &mesh_.indices[std::size_t{3} * t];
      Index same = kNone, turned = kNone;
      forEachAt(corners[0], [&](Index b, Index c, Index other) {
        if (other >= t) return;
        if (b == corners[1] && c == corners[2]) same = other;
        if (c == corners[1] && b == corners[2] && groupOf(other) == groupOf(t)) turned = other;
      });
      if (same == kNone && turned == kNone) continue;
      if (same != kNone || hasBack_[turned])
        ++repeated;
      else
        hasBack_[turned] = 1;
      std::fill(corners, corners + 3, kNone);
      isLess = true;
    }
    return isLess;
  }

  // The backs again, of the triangles that are left.
  void giveBack() {
    for (std::size_t t = 0; t < hasBack_.size(); ++t) {
      if (!hasBack_[t]) continue;
      const Index* const corners = &mesh_.indices[3 * t];
      const Index a = corners[0], b = corners[1], c = corners[2];
      mesh_.indices.insert(mesh_.indices.end(), {a, c, b});
      if (!mesh_.groups.empty()) mesh_.groups.push_back(mesh_.groups[t]);
    }
  }

  Index groupOf(Index t) const { return mesh_.groups.empty() ? 0 : mesh_.groups[t]; }

  // Visits the triangles at a vertex as (b, c, number), counterclockwise after the vertex. What
  // came to it in this pass is not listed yet.
  template <class Visit>
  void forEachAt(Index v, Visit visit) const {
    for (Index i = begins_[v]; i < begins_[v + 1]; ++i) {
      const Index* const t = &mesh_.indices[std::size_t{3} * triangles_[i]];
      if (t[0] == v)
        visit(t[1], t[2], triangles_[i]);
      else if (t[1] == v)
        visit(t[2], t[0], triangles_[i]);
      else if (t[2] == v)  // of a triangle that is gone it is none
        visit(t[0], t[1], triangles_[i]);
    }
  }

  Vec3 at(Index v) const { return mesh_.positions[v]; }
  Vec3 way(Index from, Index to) const { return scale_ * (at(to) - at(from)); }

  RingEdge& ringEdge(Index neighbor) {
    for (RingEdge& edge : ring_)
      if (edge.neighbor == neighbor) return edge;
    ring_.push_back({neighbor});
    return ring_.back();
  }

  void note(RingEdge& edge, Index t) const {
    const Index side = 2 * groupOf(t) + (hasBack_.empty() ? 0 : Index(hasBack_[t]));
    edge.isBorder |= edge.side != kNone && edge.side != side;
    edge.side = side;
  }

  // The neighbours of a vertex, and whether it may go at all.
  bool gatherRing(Index v) {
    ring_.clear();
    forEachAt(v, [&](Index b, Index c, Index t) {
      ++ringEdge(b).out;
      note(ringEdge(b), t);
      ++ringEdge(c).in;
      note(ringEdge(c), t);
    });
    std::size_t borders = 0;
    for (RingEdge& edge : ring_) {
      isCrowded_ |= edge.out > 1 || edge.in > 1;
      if (edge.out > 1 || edge.in > 1) return false;
      edge.isBorder |= edge.isOpen();
      if (edge.isOpen() && borders_ == OpenBorders::Keep) return false;
      borders += edge.isBorder ? 1 : 0;
    }
    return borders == 0 || borders == 2;
  }

  Kind kindOf(Index v) {
    if (kinds_[v] == Kind::Fixed || !gatherRing(v)) return Kind::Fixed;
    const bool isOnBorder =
        std::any_of(ring_.begin(), ring_.end(), [](const RingEdge& edge) { return edge.isBorder; });
    return isOnBorder ? Kind::OnBorder : Kind::Inner;
  }

  void measureVertices() {
    quadrics_.assign(mesh_.positions.size(), {});
    for (Index v = 0; v < quadrics_.size(); ++v) {
      kinds_[v] = kindOf(v);
      LocalQuadric& quadric = quadrics_[v];
      forEachAt(v, [&](Index b, Index c, Index) {
        const Vec3 first = way(v, b), second = way(v, c);
        const Vec3 normal = first.cross(second);
        const double own = normal.norm() / 2;
        if (!(own > 0)) return;
        quadric.addPlane(normal / (2 * own), own);
        quadric.addPlace(kSidewaysWeight * own);
        quadric.area += float(own);
        for (const RingEdge& edge : ring_)
          if (edge.isBorder && (edge.neighbor == b || edge.neighbor == c))
            addEdge(quadric, way(v, edge.neighbor), normal);
      });
    }
  }

  // The distance from a border edge within the plane of a triangle at it.
  static void addEdge(LocalQuadric& quadric, const Vec3& edge, const Vec3& normal) {
    quadric.addPlane(edge.cross(normal).stableNormalized(), kBorderWeight * edge.squaredNorm());
    quadric.area += float(edge.squaredNorm());
  }

  // Around an inner vertex each neighbour comes first in one triangle.
  Going cheapest(Index v) {
    Going best;
    const LocalQuadric& own = quadrics_[v];
    const auto consider = [&](Index u) {
      const double sum = own.at(way(v, u)) + quadrics_[u].constant;
      const double area = double{own.area} + quadrics_[u].area;
      const float cost = float(std::max(sum, 0.0) * std::sqrt(area)) + 0.0F;  // -0 + 0 is 0
      if (best.into == kNone || cost < best.cost || (cost == best.cost && u < best.into))
        best = {u, cost};
    };
    if (kinds_[v] == Kind::Inner) {
      forEachAt(v, [&](Index b, Index, Index) { consider(b); });
    } else if (kinds_[v] == Kind::OnBorder && gatherRing(v)) {
      for (const RingEdge& edge : ring_)
        if (edge.isBorder) consider(edge.neighbor);
    }
    return best;
  }

  void pass(std::size_t wanted) {
    goings_.resize(mesh_.positions.size());
    for (Index v = 0; v < goings_.size(); ++v) goings_[v] = cheapest(v);
    sortByCost();
    for (const Index v : order_) {
      if (count_ <= wanted) break;
      const Index u = goings_[v].into;
      if (isTouched_[v] || isTouched_[u] || !mayGo(v, u)) continue;
      go(v, u);
    }
    std::fill(isTouched_.begin(), isTouched_.end(), 0);
  }

  // Lists the cheapest vertices in slices, and those of a slice by their numbers: neighbours in
  // memory are mostly neighbours on the surface, and distant memory takes long to get.
  void sortByCost() {
    // Floats that are not negative are in the order of their bits. The lowest ones are ignored.
    constexpr int kIgnored = 15;
    const auto bucketOf = [&](Index v) { return bitsOf(goings_[v].cost) >> kIgnored; };
    std::vector<Index> ranks((std::size_t{1} << (32 - kIgnored)) + 1, 0);
    for (Index v = 0; v < goings_.size(); ++v)
      if (goings_[v].into != kNone) ++ranks[bucketOf(v) + 1];
    std::partial_sum(ranks.begin(), ranks.end(), ranks.begin());
    const std::size_t most =
        std::min<std::size_t>(ranks.back(), std::max<std::size_t>(count_ / kPassPart, 1));
    const auto sliceOf = [&](Index v) { return kSlices * std::size_t{ranks[bucketOf(v)]} / most; };
    std::array<std::size_t, kSlices + 1> ends{};
    for (Index v = 0; v < goings_.size(); ++v)
      if (goings_[v].into != kNone && sliceOf(v) < kSlices) ++ends[sliceOf(v) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    order_.resize(ends.back());
    for (Index v = 0; v < goings_.size(); ++v)
      if (goings_[v].into != kNone && sliceOf(v) < kSlices) order_[ends[sliceOf(v)]++] = v;
  }

  static std::uint32_t bitsOf(float cost) {
    std::uint32_t bits;
    std::memcpy(&bits, &cost, sizeof bits);
    return bits;
  }

  // Whether the topology stays and no triangle turns too far.
  bool mayGo(Index v, Index u) {
    if (kinds_[v] == Kind::OnBorder && !gatherRing(v)) return false;
    around_.clear();
    int shared = 0;
    bool isAllowed = true;
    forEachAt(v, [&](Index b, Index c, Index) {
      const bool isShared = b == u || c == u;
      shared += isShared ? 1 : 0;
      around_.insert(around_.end(), {b, c});
      isAllowed = isAllowed && (isShared ? !isTip(v, b == u ? c : b) : !turnsTooFar({v, b, c}, u));
    });
    return isAllowed && shared > 0 && commonNeighbors(v, u) == shared;
  }

  // Whether both edges of a border's vertex in a triangle are borders, of which that to w would
  // come to lie on the third edge. The ring is that of v.
  bool isTip(Index v, Index w) const {
    return kinds_[v] == Kind::OnBorder &&
           std::any_of(ring_.begin(), ring_.end(),
                       [&](const RingEdge& edge) { return edge.isBorder && edge.neighbor == w; });
  }

  bool isAround(Index w) const {
    return std::find(around_.begin(), around_.end(), w) != around_.end();
  }

  // The number of vertices that both have edges to; -1 if an edge between two of them closes a
  // triangle with either.
  int commonNeighbors(Index v, Index u) {
    common_.clear();
    bool isApart = true;
    forEachAt(u, [&](Index b, Index c, Index) {
      const bool hasB = b != v && isAround(b), hasC = c != v && isAround(c);
      for (const Index w : {hasB ? b : kNone, hasC ? c : kNone})
        if (w != kNone && std::find(common_.begin(), common_.end(), w) == common_.end())
          common_.push_back(w);
      if (!hasB || !hasC) return;
      for (std::size_t i = 0; i < around_.size(); i += 2)
        isApart = isApart && !(around_[i] == b && around_[i + 1] == c) &&
                  !(around_[i] == c && around_[i + 1] == b);
    });
    return isApart ? int(common_.size()) : -1;
  }

  bool turnsTooFar(const std::array<Index, 3>& t, Index u) const {
    const Vec3 b = way(t[0], t[1]), c = way(t[0], t[2]), place = way(t[0], u);
    const Vec3 before = b.cross(c), after = (b - place).cross(c - place);
    const double size = after.norm();
    const double longest =
        std::max({(b - place).squaredNorm(), (c - place).squaredNorm(), (c - b).squaredNorm()});
    if (size < kThin * longest && size < before.norm()) return true;
    return !(before.dot(after) > kLeastTurn * before.norm() * size) && !before.isZero();
  }

  void go(Index v, Index u) {
    forEachAt(v, [&](Index b, Index c, Index t) {
      Index* const corners = &mesh_.indices[std::size_t{3} * t];
      if (b == u || c == u)
        std::fill(corners, corners + 3, kNone);
      else
        std::replace(corners, corners + 3, v, u);
    });
    quadrics_[u].add(quadrics_[v], way(u, v));
    isTouched_[u] = isTouched_[v] = 1;
    --count_;
  }

  TriangleMesh& mesh_;
  const OpenBorders borders_;
  double scale_ = 1;  // a power of two: edges are about 1 long
  std::size_t count_ = 0;
  bool isCrowded_ = false;     // some triangles have an edge of the same direction
  std::vector<char> hasBack_;  // per triangle, or empty: whether another has its corners, turned
  std::vector<Kind> kinds_;
  std::vector<char> isTouched_;  // in this pass
  std::vector<Index> begins_, triangles_;
  std::vector<LocalQuadric> quadrics_;
  std::vector<Going> goings_;  // per vertex
  std::vector<Index> order_;   // the cheapest vertices
  std::vector<RingEdge> ring_;
  std::vector<Index> around_;  // the edges opposite a vertex in its triangles, two ends each
  std::vector<Index> common_;
};

void thinOut(TriangleMesh& mesh, ThinOut wanted) {
  const std::size_t count = wanted.vertices;
  if (!mesh.indices.empty()) ThinningOut(mesh, std::move(wanted)).run(count);
  keepUsedVertices(mesh);
}

// Slabs are left with so few vertices that all of them can be thinned out at once.
double leftBySlabs(const ThinOut& wanted) {
  return double(std::max(kLeftBySlabs * wanted.vertices, wanted.atOnce / 4));
}

SlabToThin slabToThin(const TriangleMesh& mesh, const std::vector<Index>& triangles,
                      const ThinOut& wanted) {
  const double share = double(triangles.size()) / double(mesh.triangleCount());
  const auto left = std::size_t(share * leftBySlabs(wanted));
  return {submeshOf(mesh, triangles).mesh,
          {left, OpenBorders::Keep, {}, triangles.size(), wanted.repeated}};
}

// What slabs have left, some two triangles for each vertex, would hardly get smaller by slabs.
bool needsSlabs(const TriangleMesh& mesh, const ThinOut& wanted) {
  const auto count = double(mesh.triangleCount());
  return count > double(wanted.atOnce) && count > kLeastForSlabs * leftBySlabs(wanted);
}

}  // namespace

SlabToThin slabToThin(const TriangleMesh& mesh, std::size_t number, std::size_t count,
                      const ThinOut& wanted) {
  return slabToThin(mesh, Slabs(mesh, count)[number], wanted);
}

TriangleMesh thinnedBySlabs(const TriangleMesh& mesh, std::size_t count, const ThinOut& wanted) {
  const Slabs slabs(mesh, count);
  TriangleMesh all;
  for (std::size_t i = 0; i < count; ++i) {
    auto [slab, own] = slabToThin(mesh, slabs[i], wanted);
    thinOut(slab, std::move(own));
    if (i == 0)
      all = std::move(slab);
    else
      append(all, slab);
  }
  return all;
}

TriangleMesh thinnedOut(TriangleMesh mesh, ThinOut wanted) {
  mesh.isQuads = false;
  if (needsSlabs(mesh, wanted)) {
    mesh = thinnedBySlabs(mesh, mesh.triangleCount() / wanted.atOnce + 1, wanted);
    wanted.first.clear();
  }
  thinOut(mesh, std::move(wanted));
  return mesh;
}

}  // namespace remesher
