// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/curve_following.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace remesher {

namespace {

// A way of more sides is none along the curve.
constexpr std::size_t kLongestWay = 4;

// The vertices on each chain, by how far along it they are.
using OnChain = std::vector<std::pair<double, Index>>;

std::vector<OnChain> verticesOnChains(const QuadMesh& quads, const WorkingMesh& mesh) {
  const auto& chains = mesh.surface().curves().chains();
  std::vector<OnChain> on(chains.size());
  std::map<Vertex, Index> corners;
  for (Index v = 0; v < quads.vertices.size(); ++v) {
    const Placement& place = quads.vertices[v];
    if (place.kind == VertexKind::Curve) on[place.on.chain].emplace_back(place.on.arc, v);
    if (place.kind == VertexKind::Corner) corners[mesh.originalCorner(place.at)] = v;
  }
  for (Index c = 0; c < chains.size(); ++c) {
    for (const bool isLast : {false, true}) {
      const auto corner =
          corners.find(isLast ? chains[c].vertices.back() : chains[c].vertices.front());
      if (corner != corners.end())
        on[c].emplace_back(isLast ? chains[c].length() : 0, corner->second);
    }
    std::sort(on[c].begin(), on[c].end());
  }
  return on;
}

// The vertices between two neighbours on a chain: a way along sides over vertices inside.
class CurveWays {
 public:
  CurveWays(QuadMesh& quads, const WorkingMesh& mesh)
      : quads_(quads), mesh_(mesh), neighbors_(quads.vertices.size()) {
    for (const Four<Index>& quad : quads.quads)
      for (std::size_t i = 0; i < 4; ++i) {
        neighbors_[quad[i]].push_back(quad[(i + 1) % 4]);
        neighbors_[quad[(i + 1) % 4]].push_back(quad[i]);
      }
    for (std::vector<Index>& around : neighbors_) {
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
    }
  }

  // Leads the quads along the chain where they leave it; false where they cannot be.
  bool close(Index chain, OnChain& on) {
    bool isWhole = on.size() >= 2 || on.empty();
    // A boundary is where the quads end, and no way inside is one.
    const bool isBoundary = mesh_.surface().curves().chains()[chain].boundary;
    for (std::size_t i = 0, count = on.size(); i + 1 < count; ++i)
      if (!areJoined(on[i].second, on[i + 1].second))
        isWhole &= !isBoundary &&
                   (lead(chain, on[i], on[i + 1], on) || divide(chain, on[i], on[i + 1], on));
    std::sort(on.begin(), on.end());
    return isWhole;
  }

 private:
  using Point = OnChain::value_type;

  bool areJoined(Index a, Index b) const {
    return std::binary_search(neighbors_[a].begin(), neighbors_[a].end(), b);
  }

  // Along the way that has to move least, if there is one.
  bool lead(Index chain, Point from, Point to, OnChain& found) {
    least_ = std::numeric_limits<double>::infinity();
    for (std::size_t inside = 1; inside < kLongestWay; ++inside) {
      targets_.clear();
      for (std::size_t i = 1; i <= inside; ++i) {
        const double share = double(i) / double(inside + 1);
        const double arc = (1 - share) * from.first + share * to.first;
        targets_.push_back(mesh_.onCurve({chain, arc}));
      }
      search(from.second, to.second, 0);
    }
    if (!(least_ < std::numeric_limits<double>::infinity())) return false;
    for (std::size_t i = 0; i < best_.size(); ++i) {
      quads_.vertices[best_[i]] = bestTargets_[i];
      found.emplace_back(bestTargets_[i].on.arc, best_[i]);
    }
    return true;
  }

  // Where both are corners of one quad a new vertex on its diagonal makes two of it.
  bool divide(Index chain, Point from, Point to, OnChain& found) {
    const Index a = from.second, b = to.second;
    for (Index q = 0; q < quads_.quads.size(); ++q)
      for (std::size_t i = 0; i < 4; ++i) {
        const Four<Index> quad = quads_.quads[q], curves = quads_.curves[q];
        if (quad[i] != a || quad[(i + 2) % 4] != b) continue;
        const auto middle = Index(quads_.vertices.size());
        const double arc = (from.first + to.first) / 2;
        quads_.vertices.push_back(mesh_.onCurve({chain, arc}));
        found.emplace_back(arc, middle);
        quads_.quads[q] = {a, quad[(i + 1) % 4], b, middle};
        quads_.curves[q] = {curves[i], curves[(i + 1) % 4], kNone, kNone};
        quads_.quads.push_back({a, middle, b, quad[(i + 3) % 4]});
        quads_.curves.push_back({kNone, kNone, curves[(i + 2) % 4], curves[(i + 3) % 4]});
        neighbors_.push_back({std::min(a, b), std::max(a, b)});
        neighbors_[a].push_back(middle);
        neighbors_[b].push_back(middle);
        return true;
      }
    return false;
  }

  void search(Index at, Index goal, double moved) {
    if (moved >= least_) return;
    if (way_.size() == targets_.size()) {
      if (!areJoined(at, goal)) return;
      least_ = moved;
      best_ = way_;
      bestTargets_ = targets_;
      return;
    }
    const Vec3& target = targets_[way_.size()].position;
    for (const Index next : neighbors_[at]) {
      const bool isInside = quads_.vertices[next].kind == VertexKind::Interior;
      if (!isInside || std::find(way_.begin(), way_.end(), next) != way_.end()) continue;
      way_.push_back(next);
      search(next, goal, moved + (quads_.position(next) - target).norm());
      way_.pop_back();
    }
  }

  QuadMesh& quads_;
  const WorkingMesh& mesh_;
  std::vector<std::vector<Index>> neighbors_;
  std::vector<Placement> targets_, bestTargets_;
  std::vector<Index> way_, best_;
  double least_ = 0;
};

void placeCorners(QuadMesh& quads, const WorkingMesh& mesh) {
  std::vector<char> isThere(mesh.surface().mesh().vertexCapacity(), 0);
  for (const Placement& place : quads.vertices)
    if (place.kind == VertexKind::Corner) isThere[mesh.originalCorner(place.at).index] = 1;
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v) {
    const Placement corner = mesh.placement(Vertex(v));
    if (corner.kind != VertexKind::Corner || mesh.mesh().isBoundary(Vertex(v))) continue;
    if (isThere[mesh.originalCorner(corner.at).index]) continue;
    Placement* nearest = nullptr;
    for (Placement& place : quads.vertices) {
      if (place.kind != VertexKind::Interior) continue;
      const auto distance = [&](const Placement& p) {
        return (p.position - corner.position).norm();
      };
      if (!nearest || distance(place) < distance(*nearest)) nearest = &place;
    }
    if (nearest) *nearest = corner;
  }
}

}  // namespace

std::size_t followCurves(QuadMesh& quads, const WorkingMesh& mesh) {
  placeCorners(quads, mesh);
  std::vector<OnChain> onChains = verticesOnChains(quads, mesh);
  CurveWays ways(quads, mesh);
  std::vector<char> isWhole(onChains.size(), 1);
  for (Index c = 0; c < onChains.size(); ++c) isWhole[c] = ways.close(c, onChains[c]);
  std::map<std::pair<Index, Index>, std::vector<Index>> sides;
  for (Index q = 0; q < quads.quads.size(); ++q)
    for (Index i = 0; i < 4; ++i)
      sides[std::minmax(quads.quads[q][i], quads.quads[q][(i + 1) % 4])].push_back(sideOf(q, i));
  for (Index c = 0; c < onChains.size(); ++c) {
    const OnChain& on = onChains[c];
    for (std::size_t i = 0; isWhole[c] && i + 1 < on.size(); ++i)
      for (const Index side : sides[std::minmax(on[i].second, on[i + 1].second)])
        quads.curves[side / 4][side % 4] = c;
    if (isWhole[c]) continue;
    for (const auto& [arc, v] : on) {
      Placement& place = quads.vertices[v];
      if (place.kind == VertexKind::Curve)
        place = {place.position, place.normal, place.at, {}, VertexKind::Interior, Vec3::Zero()};
    }
  }
  return std::size_t(std::count(isWhole.begin(), isWhole.end(), 0));
}

}  // namespace remesher
