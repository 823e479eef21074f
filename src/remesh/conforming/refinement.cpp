// SPDX-License-Identifier: MIT
#include "remesh/conforming/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/versioned_queue.h"
#include "geometry/predicates.h"
#include "remesh/conforming/facet_flips.h"

namespace remesher {

namespace {

// The shares of a line at which it may be split.
constexpr std::array<double, 3> kShares = {0.5, 0.4, 0.6};

// Triangles away from the original count so much more. Not more than that: vertices that only bring
// triangles nearer would leave needles between them.
constexpr double kDeepMore = 3;
// So do those with longer edges than there are to be.
constexpr double kLongMore = 3;

struct FacetCorners {
  std::array<Vec2, 3> at;

  Vec2 centre() const { return (at[0] + at[1] + at[2]) / 3; }
  double length(std::size_t k) const { return (at[(k + 1) % 3] - at[k]).norm(); }

  // The centre of the circle through the corners.
  Vec2 circumcentre() const {
    const Vec2 b = at[1] - at[0], c = at[2] - at[0];
    const double twice = 2 * cross(b, c);
    const double bb = b.squaredNorm(), cc = c.squaredNorm();
    return at[0] + Vec2(c.y() * bb - b.y() * cc, b.x() * cc - c.x() * bb) / twice;
  }
};

class FacetRefinement {
 public:
  explicit FacetRefinement(FacetedMesh& mesh) : mesh_(mesh), m_(mesh.mesh()) {}

  bool run(std::size_t count) {
    flipFacets(mesh_, edgesOf(m_), DeepEdges::Left, [](Face) {});
    for (Index i = 0; i < m_.faceCapacity(); ++i)
      if (m_.isAlive(Face(i))) enter(Face(i));
    while (count > 0) {
      const Index worst = worst_.pop();
      if (worst == kNone) break;
      if (m_.isAlive(Face(worst)) && improve(Face(worst))) --count;
    }
    return count == 0;
  }

 private:
  FacetCorners cornersOf(Face f) const {
    const auto [a, b, c] = m_.vertices(f);
    const Index facet = mesh_.facet(f);
    return {{mesh_.flat(a, facet), mesh_.flat(b, facet), mesh_.flat(c, facet)}};
  }

  // Large triangles and needles are bad; narrow facets have small ones, which are needles as well.
  // A needle between two lines that meet at an acute angle stays one, and counts by its size only.
  double badness(Face f) const {
    const FacetCorners corners = cornersOf(f);
    const double radius = (corners.circumcentre() - corners.at[0]).norm();
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (corners.length(k) < corners.length(least)) least = k;
    double size = radius * (isDeep(f) ? kDeepMore : 1);
    for (std::size_t k = 0; k < 3; ++k)
      if (corners.length(k) > mesh_.longest()) size *= kLongMore;
    const auto isLine = [&](std::size_t k) {
      return mesh_.isLine(HalfedgeMesh::halfedge(f, int(k % 3)));
    };
    if (isLine(least + 1) && isLine(least + 2)) return size;
    const double thin = radius / corners.length(least);
    return size * thin * std::sqrt(thin);
  }

  bool isDeep(Face f) const {
    const auto [a, b, c] = m_.vertices(f);
    const Index facet = mesh_.facet(f);
    return mesh_.isDeep(a, b, facet) || mesh_.isDeep(b, c, facet) || mesh_.isDeep(c, a, facet);
  }

  void enter(Face f) {
    const double score = badness(f);
    if (std::isfinite(score)) worst_.push(f.index, score);
  }

  // Enters the triangles around a new vertex, after flips.
  void settle(Vertex v) {
    std::vector<Halfedge> rim;
    m_.forEachOutgoing(v, [&](Halfedge h) {
      for (const Halfedge e : {h, m_.next(h), m_.prev(h)}) rim.push_back(e);
    });
    std::vector<Face> changed;
    flipFacets(mesh_, std::move(rim), DeepEdges::Left, [&](Face f) { changed.push_back(f); });
    m_.forEachOutgoing(v, [&](Halfedge h) { changed.push_back(m_.face(h)); });
    for (const Face f : changed) enter(f);
  }

  // The end of the straight way from the middle of a triangle to a place: the triangle there,
  // or a line before it.
  struct Met {
    Face face;
    Halfedge line;
  };

  Met wayTo(Face f, const Vec2& place) const {
    const Vec2 from = cornersOf(f).centre();
    const Index facet = mesh_.facet(f);
    for (std::size_t steps = 0; steps <= m_.faceCount(); ++steps) {
      Halfedge out;
      for (int k = 0; k < 3 && !out; ++k) {
        const Halfedge h = HalfedgeMesh::halfedge(f, k);
        const Vec2 a = mesh_.flat(m_.origin(h), facet), b = mesh_.flat(m_.tip(h), facet);
        if (orient2d(a, b, place) >= 0 || orient2d(a, b, from) < 0) continue;
        if (orient2d(from, place, a) <= 0 && orient2d(from, place, b) >= 0) out = h;
      }
      if (!out) return {f, {}};
      if (mesh_.isLine(out)) return {{}, out};
      const Halfedge beyond = m_.twin(out);
      if (!beyond) return {f, {}};  // the border of a facet too narrow to have a line
      f = m_.face(beyond);
    }
    return {f, {}};
  }

  // A line of the triangle that would see the place at an obtuse angle.
  Halfedge besieged(Face f, const Vec2& place) const {
    const Index facet = mesh_.facet(f);
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      if (!mesh_.isLine(h)) continue;
      const Vec2 a = mesh_.flat(m_.origin(h), facet), b = mesh_.flat(m_.tip(h), facet);
      if ((a - place).dot(b - place) < 0) return h;
    }
    return {};
  }

  // Where to split a line: in the middle or to one side of it, as far as possible from being
  // opposite to a vertex, so that rows of vertices along narrow facets come to stand alternately.
  double shareOf(Halfedge line) const {
    std::vector<double> opposite;
    for (const Halfedge h : {line, m_.twin(line)}) {
      if (!h) continue;
      const Vec3& from = mesh_.positions()[m_.origin(line)];
      const Vec3 way = mesh_.positions()[m_.tip(line)] - from;
      opposite.push_back((mesh_.positions()[m_.opposite(h)] - from).dot(way) / way.squaredNorm());
    }
    double best = 0.5, widest = -1;
    for (const double share : kShares) {
      double gap = 1;
      for (const double o : opposite) gap = std::min(gap, std::abs(o - share));
      if (gap > widest + kRoundOff) widest = gap, best = share;
    }
    return best;
  }

  // Returns whether that was possible. A triangle beside a line that must stay is left as it is.
  bool improve(Face f) {
    const Vec2 centre = cornersOf(f).circumcentre();
    auto [face, line] = wayTo(f, centre);
    if (!line) line = besieged(face, centre);
    if (line && mesh_.isKept(line)) return false;
    Vertex v = line ? mesh_.split(line, shareOf(line)) : mesh_.divide(face, centre);
    if (!v && !line) v = mesh_.divide(face, cornersOf(face).centre());
    if (!v) return false;
    settle(v);
    return true;
  }

  FacetedMesh& mesh_;
  const HalfedgeMesh& m_;
  VersionedQueue worst_;  // faces by badness
};

}  // namespace

bool refineFacets(FacetedMesh& mesh, std::size_t count) { return FacetRefinement(mesh).run(count); }

}  // namespace remesher
