// SPDX-License-Identifier: MIT
#include "curves/feature_curves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace remesher {

namespace {

// A curve that turns by more than this has a corner there; a regular octagon (45°) has none.
constexpr double kCornerTurn = radians(50);

double turn(const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 in = at - before, out = after - at;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

struct CurveEdge {
  Halfedge halfedge;
  Vertex other;
};

// Finds chains by walking over marked edges; corners may be added between two walks.
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

  // Every maximal path between corners, then the loops without any.
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

  // The first vertex at least `reach` along the path from i, in any case the next one whose place
  // is another; around the start of a loop if need be. Found by bisection: a rim of a hundred
  // thousand edges may be shorter than the reach.
  std::size_t reachFrom(const Chain& path, std::size_t i, int direction, double reach) const {
    const std::size_t last = path.vertices.size() - 1;
    const bool loop = path.vertices.front() == path.vertices.back() && !corner_[path.vertices[0]];
    const std::size_t straight = direction > 0 ? ahead(path, i, reach) : behind(path, i, reach);
    const double gone = std::abs(path.arcs[straight] - path.arcs[i]);
    if (!loop || (gone > 0 && gone >= reach)) return straight;
    // Once around is as far as there is.
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

  // A corner turns sharply both from edge to edge and over half a target length: scan noise does
  // only the first, a round arc neither. Of several within that reach the sharpest is it, and where
  // curves meet there is one already.
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

  // Three corners in all, about evenly spaced.
  void divideLoop(const Chain& path) {
    const std::size_t last = path.vertices.size() - 1;
    corner_[path.vertices[0]] = 1;
    std::size_t previous = 0;
    for (const std::size_t part : {1, 2}) {
      const double arc = path.length() * double(part) / 3;
      std::size_t i = std::lower_bound(path.arcs.begin(), path.arcs.end(), arc) - path.arcs.begin();
      i = std::clamp(i, previous + 1, last - (3 - part));
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

FeatureCurves::FeatureCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                             const CurveRules& rules)
    : chainOf_(mesh.halfedgeCapacity(), kNone) {
  ChainTracer tracer(mesh, positions, rules);
  chains_ = tracer.trace();
  corner_ = tracer.corners();
  for (const Vertex v : rules.tips) corner_[v] = 1;
  nameChains(mesh);
}

FeatureCurves::FeatureCurves(const HalfedgeMesh& mesh, const FeatureCurves& other,
                             const VertexData<Vertex>& heirs)
    : chains_(other.chains_),
      chainOf_(mesh.halfedgeCapacity(), kNone),
      corner_(mesh.vertexCapacity(), 0) {
  for (Chain& chain : chains_) {
    for (Vertex& v : chain.vertices) v = heirs[v];
    for (std::size_t i = 0; i < chain.halfedges.size(); ++i) {
      const Vertex from = chain.vertices[i], to = chain.vertices[i + 1];
      const Halfedge h = mesh.find(from, to);
      chain.halfedges[i] = h ? h : mesh.find(to, from);
    }
  }
  for (Index i = 0; i < heirs.size(); ++i)
    if (other.corner_[Vertex(i)]) corner_[heirs[Vertex(i)]] = 1;
  nameChains(mesh);
}

void FeatureCurves::nameChains(const HalfedgeMesh& mesh) {
  for (Index c = 0; c < chains_.size(); ++c)
    for (const Halfedge h : chains_[c].halfedges) {
      chainOf_[h] = c;
      if (mesh.twin(h)) chainOf_[mesh.twin(h)] = c;
    }
}

// The edge of the chain at a point; where two meet, the one that leads `towards` that arc.
FeatureCurves::Step FeatureCurves::step(const CurvePoint& point, double towards) const {
  const Chain& chain = chains_[point.chain];
  const auto first = chain.arcs.begin() + 1, last = chain.arcs.end() - 1;
  const auto above = towards < point.arc ? std::lower_bound(first, last, point.arc)
                                         : std::upper_bound(first, last, point.arc);
  const std::size_t i = above - chain.arcs.begin() - 1;
  const double span = chain.arcs[i + 1] - chain.arcs[i];
  const double t = span > 0 ? std::clamp((point.arc - chain.arcs[i]) / span, 0.0, 1.0) : 0.0;
  return {chain.halfedges[i], t, i};
}

namespace {

SurfacePoint onEdge(Halfedge h, double atOrigin) {
  const int corner = int(h.index % 3);
  Vec3 weights = Vec3::Zero();
  weights[corner] = atOrigin;
  weights[(corner + 1) % 3] = 1 - atOrigin;
  return {HalfedgeMesh::face(h), weights};
}

}  // namespace

FeatureCurves::Place FeatureCurves::locate(const HalfedgeMesh& mesh,
                                           const VertexData<Vec3>& positions,
                                           const CurvePoint& point) const {
  const auto [h, t, i] = step(point, point.arc);
  const Chain& chain = chains_[point.chain];
  const Vec3 &from = positions[chain.vertices[i]], &to = positions[chain.vertices[i + 1]];
  const bool along = mesh.origin(h) == chain.vertices[i];
  return {t == 0   ? from
          : t == 1 ? to
                   : Vec3(from + t * (to - from)),
          onEdge(h, along ? 1 - t : t), h};
}

SurfacePoint FeatureCurves::leftOf(const HalfedgeMesh& mesh, const CurvePoint& here,
                                   const CurvePoint& there) const {
  const auto [edge, t, i] = step(here, there.arc);
  const bool isBack = there.arc < here.arc;
  const Vertex start = chains_[here.chain].vertices[isBack ? i + 1 : i];
  // Beside a far longer edge a short one may add nothing to the arc, which then does not tell which
  // way leads on; a boundary has a face on one side only.
  const bool isLeft = mesh.origin(edge) == start || mesh.isBoundary(edge);
  const Halfedge left = isLeft ? edge : mesh.twin(edge);
  const double atStart = isBack ? t : 1 - t;
  return onEdge(left, mesh.origin(left) == start ? atStart : 1 - atStart);
}

CurvePoint FeatureCurves::atCorner(Index chain, Vertex v) const {
  return {chain, chains_[chain].vertices.front() == v ? 0.0 : chains_[chain].length()};
}

}  // namespace remesher
