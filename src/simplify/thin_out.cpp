// SPDX-License-Identifier: MIT
#include "simplify/thin_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/place.h"
#include "geometry/triangle.h"
#include "mesh/used_vertices.h"

namespace remesher {
namespace {

// See kSideways, kBorder and kTurned in simplify.cpp.
constexpr double kSidewaysWeight = 5e-6, kBorderWeight = 2, kLeastTurn = 0.5;
// A pass lets go this part of the vertices at most, the cheapest; the next one knows their new
// costs. Passes end when one lets go less than its least part.
constexpr std::size_t kPassPart = 2, kLeastPart = 200;
// Below this share of the longest edge's square, twice the area of a triangle may not shrink.
constexpr double kThin = 0.05;

// The sum of weighted squared distances from planes, as seen from a vertex: numbers so small that
// single precision does.
struct LocalQuadric {
  std::array<float, 6> square{};  // xx, xy, xz, yy, yz, zz
  std::array<float, 3> linear{};
  float constant = 0, area = 0;

  void addPlane(const Vec3& normal, double weight) {
    const Vec3 n = normal;
    const std::array<double, 6> products = {n.x() * n.x(), n.x() * n.y(), n.x() * n.z(),
                                            n.y() * n.y(), n.y() * n.z(), n.z() * n.z()};
    for (std::size_t i = 0; i < 6; ++i) square[i] += float(weight * products[i]);
  }

  void addPlace(double weight) {
    for (const std::size_t i : {0, 3, 5}) square[i] += float(weight);
  }

  Vec3 times(const Vec3& p) const {
    const auto& s = square;
    return {s[0] * p.x() + s[1] * p.y() + s[2] * p.z(), s[1] * p.x() + s[3] * p.y() + s[4] * p.z(),
            s[2] * p.x() + s[4] * p.y() + s[5] * p.z()};
  }

  Vec3 slope() const { return {linear[0], linear[1], linear[2]}; }

  double at(const Vec3& p) const { return p.dot(times(p) + 2 * slope()) + constant; }

  // Adds another one, whose vertex is `way` from this one.
  void add(const LocalQuadric& other, const Vec3& way) {
    const Vec3 back = -way;
    const Vec3 moved = other.times(back) + other.slope();
    constant += float(other.at(back));
    area += other.area;
    for (std::size_t i = 0; i < 6; ++i) square[i] += other.square[i];
    for (std::size_t i = 0; i < 3; ++i) linear[i] += float(moved[Eigen::Index(i)]);
  }
};

// A neighbour of a vertex: the triangles before and after the edge to it, and whether the edge is a
// border.
struct RingEdge {
  Index neighbor;
  int out = 0, in = 0;
  Index group = kNone;
  bool isBorder = false;
  bool isOpen() const { return out + in == 1; }
};

// What a vertex would go into, and what that costs.
struct Going {
  Index into = kNone;
  float cost = 0;
};

class ThinningOut {
 public:
  ThinningOut(TriangleMesh& mesh, OpenBorders borders)
      : mesh_(mesh),
        borders_(borders),
        isFixed_(mesh.positions.size(), 0),
        next_(mesh.positions.size(), kNone),
        isTouched_(mesh.positions.size(), 0) {
    joinEqual();
    setScale();
    gatherStars();
    measureVertices();
  }

  void run(std::size_t wanted) {
    while (count_ > wanted) {
      const std::size_t before = count_;
      pass(wanted);
      gatherStars();
      if (before - count_ < before / kLeastPart + 1) break;
    }
  }

 private:
  // Vertices at one place that differ in an attribute stay.
  void joinEqual() {
    const std::vector<Index> first = weld(mesh_.positions);
    std::vector<Index> number(first.size());
    for (Index v = 0; v < first.size(); ++v) {
      const bool isEqual = first[v] == v || haveSameAttributes(mesh_, v, first[v]);
      number[v] = isEqual ? first[v] : v;
      if (!isEqual) isFixed_[v] = isFixed_[first[v]] = 1;
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
      corners[3 * kept] = a, corners[3 * kept + 1] = b, corners[3 * kept + 2] = c;
      ++kept;
    }
    corners.resize(3 * kept);
    if (!mesh_.groups.empty()) mesh_.groups.resize(kept);
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

  bool isGone(Index t) const { return mesh_.indices[std::size_t{3} * t] == kNone; }

  // Visits the triangles at a vertex as (b, c, number), counterclockwise after the vertex; also
  // those that came to it in this pass.
  template <class Visit>
  void forEachAt(Index v, Visit visit) const {
    for (const Index part : {v, next_[v]}) {
      if (part == kNone) continue;
      for (Index i = begins_[part]; i < begins_[part + 1]; ++i) {
        if (isGone(triangles_[i])) continue;
        const Index* const t = &mesh_.indices[std::size_t{3} * triangles_[i]];
        const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        visit(t[(k + 1) % 3], t[(k + 2) % 3], triangles_[i]);
      }
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
    const Index group = mesh_.groups.empty() ? 0 : mesh_.groups[t];
    edge.isBorder |= edge.group != kNone && edge.group != group;
    edge.group = group;
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
      if (edge.out > 1 || edge.in > 1) return false;
      edge.isBorder |= edge.isOpen();
      if (edge.isOpen() && borders_ == OpenBorders::Keep) return false;
      borders += edge.isBorder ? 1 : 0;
    }
    isOnBorder_ = borders > 0;
    return borders == 0 || borders == 2;
  }

  void measureVertices() {
    quadrics_.resize(mesh_.positions.size());
    for (Index v = 0; v < quadrics_.size(); ++v) {
      if (!gatherRing(v)) isFixed_[v] = 1;
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

  Going cheapest(Index v) {
    Going best;
    if (isFixed_[v] || begins_[v] == begins_[v + 1] || !gatherRing(v)) return best;
    for (const RingEdge& edge : ring_) {
      if (isOnBorder_ && !edge.isBorder) continue;
      const Index u = edge.neighbor;
      const double sum = quadrics_[v].at(way(v, u)) + quadrics_[u].constant;
      const double area = double{quadrics_[v].area} + quadrics_[u].area;
      const float cost = float(std::max(sum, 0.0) * std::sqrt(area));
      if (best.into == kNone || cost < best.cost || (cost == best.cost && u < best.into))
        best = {u, cost};
    }
    return best;
  }

  void pass(std::size_t wanted) {
    goings_.resize(mesh_.positions.size());
    order_.clear();
    order_.reserve(count_);
    for (Index v = 0; v < goings_.size(); ++v) {
      goings_[v] = cheapest(v);
      if (goings_[v].into != kNone) order_.push_back(v);
    }
    const auto isCheaper = [&](Index v, Index w) {
      const float cost = goings_[v].cost, other = goings_[w].cost;
      return cost != other ? cost < other : v < w;
    };
    const std::size_t most = std::min(order_.size(), std::max<std::size_t>(count_ / kPassPart, 1));
    const auto end = order_.begin() + std::ptrdiff_t(most);
    std::nth_element(order_.begin(), end, order_.end(), isCheaper);
    std::sort(order_.begin(), end, isCheaper);
    order_.resize(most);
    for (const Index v : order_) {
      if (count_ <= wanted) break;
      const Index u = goings_[v].into;
      if (isTouched_[v] || isTouched_[u] || !mayGo(v, u)) continue;
      go(v, u);
    }
    std::fill(isTouched_.begin(), isTouched_.end(), 0);
    std::fill(next_.begin(), next_.end(), kNone);
  }

  // Whether the topology stays and no triangle turns too far.
  bool mayGo(Index v, Index u) {
    if (!gatherRing(v)) return false;
    int shared = 0;
    bool isAllowed = true;
    forEachAt(v, [&](Index b, Index c, Index) {
      const bool isShared = b == u || c == u;
      shared += isShared ? 1 : 0;
      isAllowed = isAllowed && (isShared ? !isTip(b == u ? c : b) : !turnsTooFar({v, b, c}, u));
    });
    if (!isAllowed || shared == 0) return false;
    others_.clear();
    forEachAt(u, [&](Index b, Index c, Index) {
      if (b == v || c == v) return;
      others_.insert(others_.end(), {b, c});
      isAllowed = isAllowed && !hasTriangle(v, b, c);
    });
    return isAllowed && commonNeighbors(v, u) == shared;
  }

  // Whether both edges of the ring's vertex in a triangle are borders, of which that to w would
  // come to lie on the third edge.
  bool isTip(Index w) const {
    return isOnBorder_ && std::any_of(ring_.begin(), ring_.end(), [&](const RingEdge& edge) {
             return edge.isBorder && edge.neighbor == w;
           });
  }

  bool hasTriangle(Index v, Index x, Index y) const {
    bool result = false;
    forEachAt(v,
              [&](Index b, Index c, Index) { result |= (b == x && c == y) || (b == y && c == x); });
    return result;
  }

  // The ring is that of v, the others are u's, without triangles that both have.
  int commonNeighbors(Index v, Index u) {
    forEachAt(v, [&](Index b, Index c, Index) {
      if (b == u) others_.push_back(c);
      if (c == u) others_.push_back(b);
    });
    int common = 0;
    for (const RingEdge& edge : ring_)
      common += std::find(others_.begin(), others_.end(), edge.neighbor) != others_.end() ? 1 : 0;
    return common;
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
    next_[u] = v;
    isTouched_[u] = isTouched_[v] = 1;
    --count_;
  }

  TriangleMesh& mesh_;
  const OpenBorders borders_;
  double scale_ = 1;  // a power of two: edges are about 1 long
  std::size_t count_ = 0;
  std::vector<char> isFixed_;
  std::vector<Index> next_;  // per vertex the one that went into it in this pass
  std::vector<char> isTouched_;
  std::vector<Index> begins_, triangles_;
  std::vector<LocalQuadric> quadrics_;
  std::vector<Going> goings_;  // per vertex
  std::vector<Index> order_;   // the cheapest vertices
  std::vector<RingEdge> ring_;
  std::vector<Index> others_;
  bool isOnBorder_ = false;  // of the last ring gathered
};

}  // namespace

TriangleMesh thinnedOut(TriangleMesh mesh, const ThinOut& wanted) {
  mesh.isQuads = false;
  if (!mesh.indices.empty()) ThinningOut(mesh, wanted.borders).run(wanted.vertices);
  keepUsedVertices(mesh);
  return mesh;
}

}  // namespace remesher
