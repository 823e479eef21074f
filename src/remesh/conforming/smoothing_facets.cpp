// SPDX-License-Identifier: MIT
#include "remesh/conforming/smoothing_facets.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/pattern_search.h"
#include "geometry/predicates.h"
#include "remesh/conforming/facet_flips.h"

namespace remesher {

namespace {

constexpr int kPasses = 6;

// 1 for an equilateral triangle, and infinite for a line: the inverse of the mean ratio, squared.
double thinness(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (orient2d(a, b, c) <= 0) return kInfinity;
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double ratio = squares / (2 * std::numbers::sqrt3 * cross(b - a, c - a));
  return ratio * ratio;
}

class StarSmoothing {
 public:
  explicit StarSmoothing(FacetedMesh& mesh) : mesh_(mesh), m_(mesh.mesh()) {}

  void smooth(Vertex v) { mesh_.role(v) == FacetRole::Free ? smoothFree(v) : smoothOnLine(v); }

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

  double thinnessAt(const Vec2& p) const {
    double sum = 0;
    for (const Side& side : sides_) sum += thinness(p, side.from, side.to);
    return sum;
  }

  void smoothFree(Vertex v) {
    gather(v);
    const Index facet = sides_[0].facet;
    const Vec2 start = mesh_.flat(v, facet);
    double spoke = 0;
    for (const Side& side : sides_) spoke += (side.from - start).norm() / double(sides_.size());
    Vec2 best = start;
    double least = thinnessAt(start);
    searchPattern([&](double step) {
      const Vec2 from = best;
      for (const Vec2& way : planeDirections()) {
        const Vec2 p = from + step * spoke * way;
        const double sum = thinnessAt(p);
        if (sum < least) least = sum, best = p;
      }
      return best != from;
    });
    if (best != start) mesh_.move(v, best, facet);
  }

  double thinnessOnLine(Vertex v) const {
    double sum = 0;
    m_.forEachOutgoing(v, [&](Halfedge h) {
      const Index facet = mesh_.facet(m_.face(h));
      sum += thinness(mesh_.flat(v, facet), mesh_.flat(m_.tip(h), facet),
                      mesh_.flat(m_.opposite(h), facet));
    });
    return sum;
  }

  void smoothOnLine(Vertex v) {
    const FacetedMesh::Reach reach = mesh_.reach(v);
    const double low = std::min(reach.from, reach.to), high = std::max(reach.from, reach.to);
    double best = reach.at, least = thinnessOnLine(v);
    searchPattern([&](double step) {
      const double start = best;
      for (const double way : {step, -step}) {
        const double arc = start + way * (high - low) / 2;
        if (!(low < arc && arc < high)) continue;
        mesh_.slide(v, arc);
        const double sum = thinnessOnLine(v);
        if (sum < least) least = sum, best = arc;
      }
      return best != start;
    });
    mesh_.slide(v, best);
  }

  FacetedMesh& mesh_;
  const HalfedgeMesh& m_;
  std::vector<Side> sides_;
};

}  // namespace

void smoothFacets(FacetedMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  StarSmoothing star(mesh);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (Index i = 0; i < m.vertexCapacity(); ++i)
      if (m.isAlive(Vertex(i)) && mesh.role(Vertex(i)) != FacetRole::Corner) star.smooth(Vertex(i));
    flipFacets(mesh, edgesOf(m), [](Face) {});
  }
}

}  // namespace remesher
