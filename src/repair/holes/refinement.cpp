// SPDX-License-Identifier: MIT
#include "repair/holes/refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/fires.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// The wanted edge length grows by this share of the distance. At 0.25 a loop of 3000 edges gets 6.6
// new vertices per edge; at 0 it would get 300. Holes of ten edges get the same vertices.
constexpr double kGrowth = 0.25;
constexpr int kMostRounds = 40;

class PlugMesh {
 public:
  PlugMesh(Plug& plug, const BuiltMesh& built, const Loop& loop)
      : plug_(plug), mesh_(built.mesh), loop_(loop) {
    for (const Corners3& t : plug.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
    twins_ = plainTwins(plug.points.size(), corners_);
    sizes_ = rimSizes(built);
    while (sizes_.size() < plug.points.size()) sizes_.push_back(sizeBetween(plug.parents[0]));
  }

  void run() {
    if (twins_.empty()) return;  // a vertex has too many edges
    relax();
    int round = 0;
    for (; round < kMostRounds && insertAll(); ++round) relax();
    if (round == kMostRounds) fires("hole refinement: most rounds");
    plug_.triangles.clear();
    for (std::size_t c = 0; c < corners_.size(); c += 3)
      plug_.triangles.push_back({corners_[c], corners_[c + 1], corners_[c + 2]});
  }

 private:
  const Vec3& at(Index v) const { return plug_.points[v]; }

  // Per loop vertex, the mean length of the surface's edges there.
  std::vector<double> rimSizes(const BuiltMesh& built) const {
    std::vector<double> sizes;
    for (const Vertex v : loop_.vertices) {
      double sum = 0;
      std::size_t count = 0;
      mesh_.forEachNeighbor(v, [&](Vertex w) {
        sum += distance(built.positions[v], built.positions[w]);
        ++count;
      });
      sizes.push_back(sum / double(count));
    }
    return sizes;
  }

  double sizeBetween(const Corners3& t) const {
    const Vec3 middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3;
    double size = sizes_[t[0]] + kGrowth * (middle - at(t[0])).norm();
    for (const Index v : {t[1], t[2]})
      size = std::min(size, sizes_[v] + kGrowth * (middle - at(v)).norm());
    return size;
  }

  // Splits a triangle only if its middle is far from all corners, compared with the wanted lengths.
  bool insertAll() {
    constexpr double kSpacing = std::numbers::sqrt2;
    bool isAny = false;
    const Index count = Index(corners_.size() / 3);
    for (Index t = 0; t < count; ++t) {
      const Corners3 v = {corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]};
      const Vec3 middle = (at(v[0]) + at(v[1]) + at(v[2])) / 3;
      const double size = sizeBetween(v);
      const bool isRoomy = std::all_of(v.begin(), v.end(), [&](Index c) {
        return kSpacing * (middle - at(c)).norm() > std::max(size, sizes_[c]);
      });
      if (!isRoomy) continue;
      sizes_.push_back(size);
      plug_.points.push_back(middle);
      plug_.parents.push_back(v);
      splitInThree(t);
      isAny = true;
    }
    return isAny;
  }

  // Triangle t keeps its first edge; the other two get a triangle each.
  void splitInThree(Index t) {
    const Index a = 3 * t, b = Index(corners_.size()), c = b + 3;
    const Index middle = Index(plug_.points.size() - 1);
    const Corners3 v = {corners_[a], corners_[a + 1], corners_[a + 2]};
    const Corners3 twins = {twins_[a], twins_[a + 1], twins_[a + 2]};
    corners_[a + 2] = middle;
    corners_.insert(corners_.end(), {v[1], v[2], middle, v[2], v[0], middle});
    twins_.resize(corners_.size());
    link(a, twins[0]), link(b, twins[1]), link(c, twins[2]);
    link(a + 1, b + 2), link(b + 1, c + 2), link(c + 1, a + 2);
  }

  void link(Index h, Index other) {
    twins_[h] = other;
    if (other != kNone) twins_[other] = h;
  }

  double angleAcross(Index h) const {
    return angles(at(corners_[prevCorner(h)]), at(corners_[h]), at(corners_[nextCorner(h)]))[0];
  }

  // Flips edges until the two angles opposite each edge sum to half a turn at most. The rounds are
  // limited, because on a surface that is not flat flipping may never end.
  void relax() {
    constexpr int kRounds = 20;
    for (int round = 0; round < kRounds; ++round) {
      bool isAny = false;
      for (Index h = 0; h < corners_.size(); ++h)
        if (twins_[h] != kNone && h < twins_[h] && mayFlip(h)) flip(h), isAny = true;
      if (!isAny) return;
    }
  }

  bool mayFlip(Index h) const {
    constexpr double kOnCircle = 1e-9;  // radians: four vertices on a circle are not flipped
    if (angleAcross(h) + angleAcross(twins_[h]) <= std::numbers::pi + kOnCircle) return false;
    const Index a = corners_[prevCorner(h)], b = corners_[prevCorner(twins_[h])];
    if (a == b || areJoined(prevCorner(h), b)) return false;
    return facesAlike(h);
  }

  // Both new triangles face the side that the old ones face.
  bool facesAlike(Index h) const {
    const Index g = twins_[h], a = corners_[prevCorner(h)], b = corners_[prevCorner(g)];
    const Vec3 old = areaVector(at(corners_[h]), at(corners_[nextCorner(h)]), at(a)) +
                     areaVector(at(corners_[g]), at(corners_[nextCorner(g)]), at(b));
    return areaVector(at(a), at(corners_[h]), at(b)).dot(old) > 0 &&
           areaVector(at(b), at(corners_[g]), at(a)).dot(old) > 0;
  }

  // Whether the origin of h is joined to b, in the plug or outside of it.
  bool areJoined(Index h, Index b) const {
    const Index rim = Index(loop_.vertices.size()), a = corners_[h];
    if (a < rim && b < rim && mesh_.adjacent(loop_.vertices[a], loop_.vertices[b])) return true;
    return turnFinds(h, b);
  }

  // Looks for b around the origin of h, in both directions up to the loop.
  bool turnFinds(Index first, Index b) const {
    for (Index h = first;;) {
      if (corners_[nextCorner(h)] == b || corners_[prevCorner(h)] == b) return true;
      const Index next = twins_[prevCorner(h)];
      if (next == first) return false;
      if (next == kNone) break;
      h = next;
    }
    for (Index h = first; twins_[h] != kNone;) {
      h = nextCorner(twins_[h]);
      if (corners_[nextCorner(h)] == b || corners_[prevCorner(h)] == b) return true;
    }
    return false;
  }

  //      q                 q
  //    / | \             /   \       h runs from p to q,
  //   d  h  c   flip    d --- c      its twin g back
  //    \ | /             \   /       .
  //      p                 p
  void flip(Index h) {
    const Index g = twins_[h];
    const Index hNext = nextCorner(h), hPrev = prevCorner(h);
    const Index gNext = nextCorner(g), gPrev = prevCorner(g);
    const Index c = corners_[gPrev], d = corners_[hPrev];
    const Index overNext = twins_[hNext], overGNext = twins_[gNext];
    // The triangle of h becomes (p, c, d), the triangle of g (q, d, c).
    corners_[hNext] = c;
    corners_[gNext] = d;
    link(h, overGNext);
    link(g, overNext);
    link(hNext, gNext);
  }

  Plug& plug_;
  const HalfedgeMesh& mesh_;
  const Loop& loop_;
  std::vector<Index> corners_, twins_;
  std::vector<double> sizes_;  // per vertex: the edge length wanted there
};

}  // namespace

void refine(Plug& plug, const BuiltMesh& built, const Loop& loop) {
  PlugMesh(plug, built, loop).run();
}

}  // namespace remesher
