// SPDX-License-Identifier: MIT
#include "original/curves/feature_curves.h"

#include <algorithm>
#include <utility>

namespace remesher {

FeatureCurves::FeatureCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                             const CurveRules& rules)
    : chainOf_(mesh.halfedgeCapacity(), kNone) {
  TracedChains traced = traceChains(mesh, positions, rules);
  chains_ = std::move(traced.chains);
  corner_ = std::move(traced.corners);
  for (const Vertex v : rules.tips) corner_[v] = 1;
  nameChains(mesh);
}

FeatureCurves::FeatureCurves(const HalfedgeMesh& mesh, const FeatureCurves& other,
                             const VertexData<Vertex>& collapseMap)
    : chains_(other.chains_),
      chainOf_(mesh.halfedgeCapacity(), kNone),
      corner_(mesh.vertexCapacity(), 0) {
  for (Chain& chain : chains_) {
    for (Vertex& v : chain.vertices) v = collapseMap[v];
    for (std::size_t i = 0; i < chain.halfedges.size(); ++i) {
      const Vertex from = chain.vertices[i], to = chain.vertices[i + 1];
      const Halfedge h = mesh.find(from, to);
      chain.halfedges[i] = h ? h : mesh.find(to, from);
    }
  }
  for (Index i = 0; i < collapseMap.size(); ++i)
    if (other.corner_[Vertex(i)]) corner_[collapseMap[Vertex(i)]] = 1;
  nameChains(mesh);
}

void FeatureCurves::nameChains(const HalfedgeMesh& mesh) {
  for (Index c = 0; c < chains_.size(); ++c)
    for (const Halfedge h : chains_[c].halfedges) {
      chainOf_[h] = c;
      if (mesh.twin(h)) chainOf_[mesh.twin(h)] = c;
    }
}

// The chain's edge at a point; where two edges meet, the edge in the direction `towards`.
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
  const double atTip = 1 - atOrigin;
  return {HalfedgeMesh::face(h), corner == 0   ? Vec3(atOrigin, atTip, 0)
                                 : corner == 1 ? Vec3(0, atOrigin, atTip)
                                               : Vec3(atTip, 0, atOrigin)};
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
  // Compares vertices, not arcs: beside a far longer edge a short one may add nothing to the arc. A
  // boundary edge has a face on one side only.
  const bool isLeft = mesh.origin(edge) == start || mesh.isBoundary(edge);
  const Halfedge left = isLeft ? edge : mesh.twin(edge);
  const double atStart = isBack ? t : 1 - t;
  return onEdge(left, mesh.origin(left) == start ? atStart : 1 - atStart);
}

CurvePoint FeatureCurves::atCorner(Index chain, Vertex v) const {
  return {chain, chains_[chain].vertices.front() == v ? 0.0 : chains_[chain].length()};
}

}  // namespace remesher
