// SPDX-License-Identifier: MIT
#include "remesh/conforming/smoothing_facets.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "geometry/fast_trigonometry.h"
#include "geometry/pattern_search.h"
#include "geometry/predicates.h"
#include "remesh/conforming/facet_flips.h"

namespace remesher {

namespace {

// Wider angles elsewhere are worth no triangle of a star whose smallest angle is less than this.
constexpr double kLeastKept = radians(30);
// No angle is kept as it is to the last digit.
constexpr double kRounded = 1 - 1e-9;

// An angle is computed to within this.
constexpr double kAngleError = 1e-7;

// The shares of a way that are tried where its end is too far from the original.
constexpr std::array<double, 3> kSharesOfWay = {1, 0.5, 0.25};

// First triangles become round, which also widens needles; then the smallest angles
// become as wide as possible on average.
enum class Aim { Round, Wide };

// 1 for an equilateral triangle, and infinite for a line: the inverse of the mean ratio, squared.
double thinness(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (orient2d(a, b, c) <= 0) return kInfinity;
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double ratio = squares / (2 * std::numbers::sqrt3 * cross(b - a, c - a));
  return ratio * ratio;
}

class StarSmoothing {
 public:
  StarSmoothing(FacetedMesh& mesh, Aim aim) : mesh_(mesh), m_(mesh.mesh()), aim_(aim) {}

  void smooth(Vertex v) {
    gather(v);
    isDeep_ = hasDeepSpoke(v);
    if (aim_ == Aim::Wide) keepAngles(v);
    mesh_.role(v) == FacetRole::Free ? smoothFree(v) : smoothOnLine(v);
  }

 private:
  // The side of a star opposite to its vertex, in its facet's plane.
  struct Side {
    Index facet;
    Vec2 from, to;
  };

  void gather(Vertex v) {
    sides_.clear();
    m_.forEachOutgoing(v, [&](Halfedge h) {
      const Index facet = mesh_.facet(m_.face(h));
      sides_.push_back({facet, mesh_.flat(m_.tip(h), facet), mesh_.flat(m_.opposite(h), facet)});
    });
  }

  // The loss of a star is a sum over its triangles: of their thinness, or of what their smallest
  // angles lack. Infinite if one is turned over, or narrower than what is kept.
  double lossOf(const Vec2& a, const Vec2& b, const Vec2& c) const {
    if (aim_ == Aim::Round) return thinness(a, b, c);
    if (orient2d(a, b, c) <= 0) return kInfinity;
    const double angle = smallestFlatAngle(a, b, c);
    return angle < kept_ ? kInfinity : std::numbers::pi / 3 - angle;
  }

  // Not summed up to the end where it is more than that.
  double lossAt(const Vec2& p, double most = kInfinity) const {
    most += kAngleError * double(sides_.size());
    double sum = 0;
    for (const Side& side : sides_) {
      sum += lossOf(p, side.from, side.to);
      if (sum > most) break;
    }
    return sum;
  }

  // Calls visit(p, side) for each side, p being the vertex in its plane.
  template <class Visit>
  void forEachSide(Vertex v, Visit visit) const {
    Index facet = kNone;
    Vec2 p = Vec2::Zero();
    for (const Side& side : sides_) {
      if (side.facet != facet) p = mesh_.flat(v, facet = side.facet);
      if (!visit(p, side)) return;
    }
  }

  // Sets what is kept by the star as it is.
  void keepAngles(Vertex v) {
    kept_ = kLeastKept;
    forEachSide(v, [&](const Vec2& p, const Side& side) {
      kept_ = std::min(kept_, kRounded * smallestFlatAngle(p, side.from, side.to));
      return true;
    });
  }

  // Whether an edge to a neighbor is farther from the original than it may be. A move may not bring
  // that about.
  bool hasDeepSpoke(Vertex v) const {
    bool isDeep = false;
    m_.forEachOutgoing(v, [&](Halfedge h) {
      const Index facet = mesh_.facet(m_.face(h));
      isDeep =
          isDeep || mesh_.isDeep(v, m_.tip(h), facet) || mesh_.isDeep(v, m_.opposite(h), facet);
    });
    return isDeep;
  }

  void smoothFree(Vertex v) {
    const Index facet = sides_[0].facet;
    const Vec2 start = mesh_.flat(v, facet);
    double spoke = 0;
    for (const Side& side : sides_) spoke += (side.from - start).norm() / double(sides_.size());
    Vec2 best = start;
    const double before = lossAt(start);
    double least = before;
    searchPattern([&](double step) {
      const Vec2 from = best;
      for (const Vec2& way : planeDirections()) {
        const Vec2 p = from + step * spoke * way;
        const double sum = lossAt(p, least);
        if (sum < least) least = sum, best = p;
      }
      return best != from;
    });
    if (best == start) return;
    for (const double share : kSharesOfWay) {
      const Vec2 p = start + share * (best - start);
      if (share < 1 && !(lossAt(p) < before)) continue;
      mesh_.move(v, p, facet);
      if (isDeep_ || !hasDeepSpoke(v)) return;
    }
    mesh_.move(v, start, facet);
  }

  double lossOnLine(Vertex v, double most = kInfinity) const {
    most += kAngleError * double(sides_.size());
    double sum = 0;
    forEachSide(v, [&](const Vec2& p, const Side& side) {
      sum += lossOf(p, side.from, side.to);
      return sum <= most;
    });
    return sum;
  }

  void smoothOnLine(Vertex v) {
    const FacetedMesh::Reach reach = mesh_.reach(v);
    const double low = std::min(reach.from, reach.to), high = std::max(reach.from, reach.to);
    const double before = lossOnLine(v);
    double best = reach.at, least = before;
    searchPattern([&](double step) {
      const double start = best;
      for (const double way : {step, -step}) {
        const double arc = start + way * (high - low) / 2;
        if (!(low < arc && arc < high)) continue;
        mesh_.slide(v, arc);
        const double sum = lossOnLine(v, least);
        if (sum < least) least = sum, best = arc;
      }
      return best != start;
    });
    for (const double share : kSharesOfWay) {
      mesh_.slide(v, reach.at + share * (best - reach.at));
      if (share < 1 && !(lossOnLine(v) < before)) continue;
      if (isDeep_ || !hasDeepSpoke(v)) return;
    }
    mesh_.slide(v, reach.at);
  }

  FacetedMesh& mesh_;
  const HalfedgeMesh& m_;
  const Aim aim_;
  double kept_ = 0;
  bool isDeep_ = false;
  std::vector<Side> sides_;
};

}  // namespace

// Opposite to the shortest side.
double smallestFlatAngle(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, bc = c - b, ca = a - c;
  const double first = ab.squaredNorm(), second = bc.squaredNorm(), third = ca.squaredNorm();
  const bool isSecond = second < first, isThird = third < (isSecond ? second : first);
  const Vec2& one = isThird ? ab : isSecond ? ca : bc;
  const Vec2& other = isThird ? bc : isSecond ? ab : ca;
  return angleOf(cross(one, other), -one.dot(other));
}

void smoothFacets(FacetedMesh& mesh, int passes) {
  const HalfedgeMesh& m = mesh.mesh();
  for (const Aim aim : {Aim::Round, Aim::Wide}) {
    StarSmoothing star(mesh, aim);
    for (int pass = 0; pass < passes; ++pass) {
      for (Index i = 0; i < m.vertexCapacity(); ++i)
        if (m.isAlive(Vertex(i)) && mesh.role(Vertex(i)) != FacetRole::Corner)
          star.smooth(Vertex(i));
      flipFacets(mesh, edgesOf(m), DeepEdges::Flipped, [](Face) {});
    }
  }
}

}  // namespace remesher
