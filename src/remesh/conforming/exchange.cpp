// SPDX-License-Identifier: MIT
#include "remesh/conforming/exchange.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "remesh/conforming/facet_flips.h"
#include "remesh/conforming/refinement.h"
#include "remesh/conforming/smoothing_facets.h"

namespace remesher {

namespace {

// The share of the vertices that is exchanged at once, halved each time that this does not help,
// and the most times.
constexpr double kExchanged = 0.08, kLeastExchanged = 0.02;
constexpr int kMostExchanges = 5;

// Wider angles on average are not worth the time. If they are narrower, the facets are too narrow
// for so few vertices, wherever these are.
constexpr double kWideEnough = radians(48), kTooNarrow = radians(35);
// The narrowest angle may become narrower if it is still so wide.
constexpr double kSoundLeast = radians(20);

constexpr double kWidest = std::numbers::pi / 3;

class VertexRemoval {
 public:
  explicit VertexRemoval(FacetedMesh& mesh) : mesh_(mesh), m_(mesh.mesh()) {}

  // Removes up to so many vertices, those first whose loss widens the angles most or narrows them
  // least. Returns how many.
  std::size_t run(std::size_t most) {
    std::vector<std::pair<double, Index>> order;
    for (Index i = 0; i < m_.vertexCapacity(); ++i)
      if (const std::optional<Way> way = bestWay(Vertex(i))) order.emplace_back(way->loss, i);
    std::sort(order.begin(), order.end());
    VertexData<char> isTouched(m_.vertexCapacity(), 0);
    std::size_t gone = 0;
    for (const auto& [loss, i] : order) {
      if (gone == most) break;
      if (isTouched[Vertex(i)]) continue;
      const std::optional<Way> way = bestWay(Vertex(i));
      if (!way) continue;
      const Vertex to = m_.tip(way->along);
      m_.forEachNeighbor(Vertex(i), [&](Vertex w) { isTouched[w] = 1; });
      if (!mesh_.collapse(way->along)) continue;
      ++gone;
      std::vector<Halfedge> rim;
      m_.forEachOutgoing(to, [&](Halfedge h) {
        for (const Halfedge e : {h, m_.next(h), m_.prev(h)}) rim.push_back(e);
      });
      flipFacets(mesh_, std::move(rim), DeepEdges::Flipped, [](Face) {});
    }
    return gone;
  }

 private:
  struct Way {
    Halfedge along;
    double loss;  // of angles, in sum
  };

  double lack(Vertex a, Vertex b, Vertex c, Index facet) const {
    return kWidest -
           smallestFlatAngle(mesh_.flat(a, facet), mesh_.flat(b, facet), mesh_.flat(c, facet));
  }

  std::optional<Way> bestWay(Vertex v) const {
    if (!m_.isAlive(v) || mesh_.role(v) == FacetRole::Corner || m_.isHub(v)) return {};
    double now = 0;
    m_.forEachOutgoing(
        v, [&](Halfedge h) { now += lack(v, m_.tip(h), m_.opposite(h), mesh_.facet(m_.face(h))); });
    std::optional<Way> best;
    m_.forEachOutgoing(v, [&](Halfedge h) {
      if ((mesh_.role(v) == FacetRole::OnLine) != mesh_.isLine(h)) return;
      if (mesh_.isLine(h) && mesh_.isKept(h)) return;
      const double then = lackAfter(v, h);
      if (!best || then - now < best->loss) best = Way{h, then - now};
    });
    if (!best || best->loss == kInfinity) return {};
    return best;
  }

  // Infinite where that is impossible.
  double lackAfter(Vertex v, Halfedge along) const {
    const Vertex to = m_.tip(along);
    double sum = 0;
    m_.forEachOutgoing(v, [&](Halfedge h) {
      const Vertex b = m_.tip(h), c = m_.opposite(h);
      if (b == to || c == to) return;
      const Index facet = mesh_.facet(m_.face(h));
      if (mesh_.turn(to, b, c, facet) <= 0 || mesh_.isDeep(to, b, facet) ||
          mesh_.isDeep(to, c, facet))
        sum = kInfinity;
      else
        sum += lack(to, b, c, facet);
    });
    return sum;
  }

  FacetedMesh& mesh_;
  const HalfedgeMesh& m_;
};

struct Angles {
  double sum = 0, least = kWidest;
};

Angles anglesOf(const FacetedMesh& mesh) {
  Angles angles;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.faceCapacity(); ++i) {
    const Face f(i);
    if (!m.isAlive(f)) continue;
    const auto [a, b, c] = m.vertices(f);
    const Index facet = mesh.facet(f);
    const double angle =
        smallestFlatAngle(mesh.flat(a, facet), mesh.flat(b, facet), mesh.flat(c, facet));
    angles.sum += angle;
    angles.least = std::min(angles.least, angle);
  }
  return angles;
}

}  // namespace

std::unique_ptr<FacetedMesh> exchangeVertices(std::unique_ptr<FacetedMesh> mesh) {
  Angles before = anglesOf(*mesh);
  double share = kExchanged;
  for (int i = 0; i < kMostExchanges && share >= kLeastExchanged; ++i) {
    const double mean = before.sum / double(mesh->mesh().faceCount());
    if (mean >= kWideEnough || mean < kTooNarrow) break;
    auto other = std::make_unique<FacetedMesh>(*mesh);
    const auto wanted = std::size_t(share * double(mesh->mesh().vertexCount()));
    const std::size_t gone = VertexRemoval(*other).run(wanted);
    if (gone == 0 || !refineFacets(*other, gone) || !other->isSound()) break;
    smoothFacets(*other, 1);
    const Angles after = anglesOf(*other);
    if (after.sum > before.sum && after.least >= std::min(before.least, kSoundLeast)) {
      mesh = std::move(other);
      before = after;
    } else {
      share /= 2;
    }
  }
  return mesh;
}

}  // namespace remesher
