// SPDX-License-Identifier: MIT
#include "original/curves/chain_tracing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace remesher {

namespace {

// A curve has a corner where it turns by more than this; a regular octagon (45°) has none.
constexpr double kCornerTurn = radians(50);

double turn(const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 in = at - before, out = after - at;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

struct CurveEdge {
  Halfedge halfedge;
  Vertex other;
};

// Finds chains by walking along marked edges; corners may be added between two walks.
class ChainTracer {
 public:
  ChainTracer(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, const CurveRules& rules)
      : mesh_(mesh),
        positions_(positions),
        rules_(rules),
        curve_(mesh.halfedgeCapacity(), 0),
        kept_(mesh.halfedgeCapacity(), 0),
        corner_(mesh.vertexCapacity(), 0) {}

  std::vector<Chain> trace() {
    markEdges();
    markJunctions();
    for (const Chain& path : walkAll()) markBends(path);
    for (const Chain& path : walkAll())
      if (path.vertices.front() == path.vertices.back()) divideLoop(path);
    return walkAll();
  }

  const VertexData<char>& corners() const { return corner_; }

 private:
  void markEdges() {
    for (const Halfedge h : rules_.edges) mark(h);
    for (const Halfedge h : rules_.kept) {
      mark(h);
      kept_[h] = 1;
      if (mesh_.twin(h)) kept_[mesh_.twin(h)] = 1;
    }
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (mesh_.isBoundary(Halfedge(i))) mark(Halfedge(i));
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      if (!curve_[Halfedge(i)] || !mesh_.isEdge(Halfedge(i))) continue;
      edges_.push_back(Halfedge(i));
    }
  }

  void mark(Halfedge h) {
    curve_[h] = 1;
    if (mesh_.twin(h)) curve_[mesh_.twin(h)] = 1;
  }

  std::vector<CurveEdge> curveEdges(Vertex v) const {
    std::vector<CurveEdge> result;
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      if (curve_[h]) result.push_back({h, mesh_.tip(h)});
      const Halfedge back = mesh_.prev(h);
      if (mesh_.isBoundary(back)) result.push_back({back, mesh_.origin(back)});
    });
    return result;
  }

  void markJunctions() {
    for (const Vertex v : rules_.corners) corner_[v] = 1;
    for (const Halfedge h : edges_)
      for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)}) {
        const bool kept = kept_[h] || (rules_.keepBoundary && mesh_.isBoundary(v));
        if (kept || curveEdges(v).size() != 2) corner_[v] = 1;
      }
  }

  // All maximal paths between corners, then the loops without a corner.
  std::vector<Chain> walkAll() {
    walked_.assign(mesh_.halfedgeCapacity(), 0);
    std::vector<Chain> chains;
    for (const bool fromCorners : {true, false})
      for (const Halfedge h : edges_)
        for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)})
          if (!walked_[h] && (!fromCorners || corner_[v])) chains.push_back(walk(v, h));
    return chains;
  }

  Chain walk(Vertex start, Halfedge first) {
    Chain chain;
    chain.vertices = {start};
    chain.arcs = {0};
    chain.boundary = mesh_.isBoundary(first);
    chain.kept = kept_[first] || (chain.boundary && rules_.keepBoundary);
    CurveEdge edge{first, mesh_.origin(first) == start ? mesh_.tip(first) : mesh_.origin(first)};
    while (true) {
      walked_[edge.halfedge] = 1;
      if (mesh_.twin(edge.halfedge)) walked_[mesh_.twin(edge.halfedge)] = 1;
      const double step = (positions_[edge.other] - positions_[chain.vertices.back()]).norm();
      chain.halfedges.push_back(edge.halfedge);
      chain.arcs.push_back(chain.arcs.back() + step);
      chain.vertices.push_back(edge.other);
      if (corner_[edge.other] || edge.other == start) return chain;
      for (const CurveEdge& next : curveEdges(edge.other))
        if (!walked_[next.halfedge]) {
          edge = next;
          break;
        }
    }
  }

  // The first vertex at least `reach` along the path from i, and at least the next vertex at
  // another place; in a loop the search continues past the loop's start. Bisection, because a rim
  // of a hundred thousand edges may be shorter than the reach.
  std::size_t reachFrom(const Chain& path, std::size_t i, int direction, double reach) const {
    const std::size_t last = path.vertices.size() - 1;
    const bool loop = path.vertices.front() == path.vertices.back() && !corner_[path.vertices[0]];
    const std::size_t straight = direction > 0 ? ahead(path, i, reach) : behind(path, i, reach);
    const double gone = std::abs(path.arcs[straight] - path.arcs[i]);
    if (!loop || (gone > 0 && gone >= reach)) return straight;
    // The search goes around the loop once at most.
    const double rest = std::min(reach, path.length()) - gone;
    return direction > 0 ? std::min(ahead(path, 0, rest), i)
                         : std::max(behind(path, last, rest), i);
  }

  static std::size_t ahead(const Chain& path, std::size_t i, double reach) {
    const auto& arcs = path.arcs;
    const auto first = arcs.begin() + std::ptrdiff_t(i);
    const auto at = std::max(std::lower_bound(first, arcs.end(), arcs[i] + reach),
                             std::upper_bound(first, arcs.end(), arcs[i]));
    return std::min(std::size_t(at - arcs.begin()), arcs.size() - 1);
  }

  static std::size_t behind(const Chain& path, std::size_t i, double reach) {
    const auto& arcs = path.arcs;
    const auto end = arcs.begin() + std::ptrdiff_t(i);
    const auto at = std::min(std::upper_bound(arcs.begin(), end, arcs[i] - reach),
                             std::lower_bound(arcs.begin(), end, arcs[i]));
    return at == arcs.begin() ? 0 : std::size_t(at - arcs.begin()) - 1;
  }

  double bend(const Chain& path, std::size_t i, double reach) const {
    return turn(positions_[path.vertices[reachFrom(path, i, -1, reach)]],
                positions_[path.vertices[i]],
                positions_[path.vertices[reachFrom(path, i, +1, reach)]]);
  }

  // A corner turns sharply both from edge to edge and over half a target length. Scan noise does
  // only the first, a round arc neither. Of several bends within that reach only the sharpest
  // becomes a corner; where curves meet there is one already.
  void markBends(const Chain& path) {
    const double reach = 0.5 * rules_.size;
    std::vector<std::pair<double, std::size_t>> bends;
    for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i) {
      if (corner_[path.vertices[i]]) continue;
      if (!(bend(path, i, 0) > kCornerTurn)) continue;
      const double wide = bend(path, i, reach);
      if (wide > kCornerTurn) bends.emplace_back(-wide, i);
    }
    std::sort(bends.begin(), bends.end());
    std::set<double> taken;
    if (corner_[path.vertices.front()]) taken.insert(0);
    if (corner_[path.vertices.back()]) taken.insert(path.length());
    for (const auto& [sharpness, i] : bends) {
      const double arc = path.arcs[i];
      const auto next = taken.lower_bound(arc);
      if (next != taken.end() && *next - arc < reach) continue;
      if (next != taken.begin() && arc - *std::prev(next) < reach) continue;
      taken.insert(arc);
      corner_[path.vertices[i]] = 1;
    }
  }

  // The number of corners to set, about evenly spaced: three on a boundary loop, up to six on a
  // wide hole's rim. With three such a rim would stay a triangle, because the mesh close around it
  // lets no more vertices in.
  std::size_t cornersOf(const Chain& loop) const {
    // kEdges: original edges per corner.
    constexpr std::size_t kMost = 6, kEdges = 4;
    if (loop.boundary || !(rules_.size > 0)) return 3;
    return std::clamp<std::size_t>(loop.vertices.size() / kEdges, 3, kMost);
  }

  void divideLoop(const Chain& path) {
    const std::size_t last = path.vertices.size() - 1, corners = cornersOf(path);
    corner_[path.vertices[0]] = 1;
    std::size_t previous = 0;
    for (std::size_t part = 1; part < corners; ++part) {
      const double arc = path.length() * double(part) / double(corners);
      std::size_t i = std::lower_bound(path.arcs.begin(), path.arcs.end(), arc) - path.arcs.begin();
      i = std::clamp(i, previous + 1, last - (corners - part));
      corner_[path.vertices[i]] = 1;
      previous = i;
    }
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  const CurveRules& rules_;
  HalfedgeData<char> curve_;
  HalfedgeData<char> kept_;
  HalfedgeData<char> walked_;
  VertexData<char> corner_;
  std::vector<Halfedge> edges_;
};

}  // namespace

TracedChains traceChains(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                         const CurveRules& rules) {
  ChainTracer tracer(mesh, positions, rules);
  std::vector<Chain> chains = tracer.trace();
  return {std::move(chains), tracer.corners()};
}

}  // namespace remesher
