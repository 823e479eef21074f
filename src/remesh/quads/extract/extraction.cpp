// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/extraction.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

#include "original/surface/surface_walk.h"
#include "remesh/quads/extract/map_walk.h"

namespace remesher {

namespace {

// The way to a corner bends at a point of the square that hardly any line through corners meets.
// Its coordinates, as parts of the square's side: along the way to the corner, and to the left.
constexpr Fixed kForth = kUnit / 5 + 1234, kLeft = kUnit / 17 + 321;

Fixed floorOf(Fixed x) { return x >= 0 ? x / kUnit : -((-x + kUnit - 1) / kUnit); }

class MapExtraction {
 public:
  MapExtraction(const WorkingMesh& mesh, const SeamlessMap& map)
      : mesh_(mesh), map_(map), walk_(mesh.mesh(), map) {}

  QuadMesh run() {
    for (Index f = 0; f < mesh_.mesh().faceCapacity(); ++f)
      if (map_.area(Face(f)) > 0) addSquaresOf(Face(f));
    return std::move(result_);
  }

 private:
  // Adds the squares whose middle is in the triangle. A middle on an edge belongs to the triangle
  // of the lower halfedge.
  void addSquaresOf(Face f) {
    MapPoint low = map_.corners[HalfedgeMesh::halfedge(f)], high = low;
    for (int corner = 1; corner < 3; ++corner) {
      const MapPoint& p = map_.corners[HalfedgeMesh::halfedge(f, corner)];
      low = {std::min(low.u, p.u), std::min(low.v, p.v)};
      high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
    for (Fixed i = floorOf(low.u); i * kUnit <= high.u; ++i)
      for (Fixed k = floorOf(low.v); k * kUnit <= high.v; ++k) {
        const MapPlace middle{f, {i * kUnit + kUnit / 2, k * kUnit + kUnit / 2}};
        if (!walk_.isIn(middle)) continue;
        const MapSpot spot = walk_.spot(middle);
        if (!spot.edge || HalfedgeMesh::face(spot.edge) == f) addSquare(middle);
      }
  }

  void addSquare(const MapPlace& middle) {
    constexpr Fixed kHalf = kUnit / 2;
    const Four<MapPoint> ways = {
        {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}}};
    Four<Index> quad{};
    for (std::size_t i = 0; i < 4; ++i) {
      quad[i] = cornerOf(middle, ways[i]);
      if (quad[i] == kNone) return;
    }
    result_.quads.push_back(quad);
    result_.curves.push_back({kNone, kNone, kNone, kNone});
  }

  Index cornerOf(const MapPlace& middle, const MapPoint& way) {
    const Fixed u = way.u > 0 ? 1 : -1, v = way.v > 0 ? 1 : -1;
    const MapPoint bend = {u * kForth - v * kLeft, v * kForth + u * kLeft};
    const auto first = walk_.go(middle, middle.point + bend);
    if (!first) return kNone;
    const auto second = walk_.go(first->place, first->way(middle.point + way));
    return second ? vertexAt(walk_.spot(second->place)) : kNone;
  }

  Index vertexAt(const MapSpot& spot) {
    const Index vertex = spot.vertex.index, edge = spot.vertex ? kNone : spot.edge.index;
    const Index face = vertex != kNone || edge != kNone ? kNone : spot.place.face.index;
    const MapPoint point = spot.vertex ? MapPoint{} : spot.place.point;
    const auto [known, isNew] =
        known_.try_emplace({vertex, edge, face, point.u, point.v}, Index(result_.vertices.size()));
    if (isNew) result_.vertices.push_back(placeOf(spot));
    return known->second;
  }

  Placement placeOf(const MapSpot& spot) const {
    if (spot.vertex) return mesh_.placement(spot.vertex);
    const Halfedge h = spot.edge ? spot.edge : HalfedgeMesh::halfedge(spot.place.face);
    const HalfedgeMesh& m = mesh_.mesh();
    const MapPoint &a = map_.corners[h], &b = map_.corners[HalfedgeMesh::next(h)],
                   &c = map_.corners[HalfedgeMesh::prev(h)], &p = spot.place.point;
    if (spot.edge) {
      const MapPoint all = b - a, gone = p - a;
      const bool isAlongU = std::abs(all.u) > std::abs(all.v);
      return onEdge(h, isAlongU ? double(gone.u) / double(all.u) : double(gone.v) / double(all.v));
    }
    const double whole = double(orientation(a, b, c));
    const Vec3 weights(double(orientation(b, c, p)) / whole, double(orientation(c, a, p)) / whole,
                       double(orientation(a, b, p)) / whole);
    const Vec3 q = weights[0] * mesh_.position(m.origin(h)) +
                   weights[1] * mesh_.position(m.tip(h)) +
                   weights[2] * mesh_.position(m.opposite(h));
    int nearest = 0;
    weights.maxCoeff(&nearest);
    return near(HalfedgeMesh::halfedge(spot.place.face, nearest), q);
  }

  Placement onEdge(Halfedge h, double share) const {
    const Vertex a = mesh_.mesh().origin(h), b = mesh_.mesh().tip(h);
    if (mesh_.isCurve(h)) {
      const Index chain = mesh_.curve(h);
      const double from = mesh_.onChain(a, chain).arc, to = mesh_.onChain(b, chain).arc;
      return mesh_.onCurve({chain, from + share * (to - from)});
    }
    const Vec3 p = (1 - share) * mesh_.position(a) + share * mesh_.position(b);
    return near(share < 0.5 ? h : HalfedgeMesh::next(h), p);
  }

  // The point of the original nearest to p, from the corner at the origin of h.
  Placement near(Halfedge h, const Vec3& p) const {
    return mesh_.onSurface(closestPointFrom(mesh_.surface(), mesh_.cornerPoint(h), p));
  }

  const WorkingMesh& mesh_;
  const SeamlessMap& map_;
  const MapWalk walk_;
  std::map<std::tuple<Index, Index, Index, Fixed, Fixed>, Index> known_;
  QuadMesh result_;
};

// The vertices on each chain, sorted by their arc length along it.
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

}  // namespace

QuadMesh extractQuads(const WorkingMesh& mesh, const SeamlessMap& map) {
  return MapExtraction(mesh, map).run();
}

std::size_t followCurves(QuadMesh& quads, const WorkingMesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Index>> sides;
  for (Index q = 0; q < quads.quads.size(); ++q)
    for (Index i = 0; i < 4; ++i) {
      const Index a = quads.quads[q][i], b = quads.quads[q][(i + 1) % 4];
      sides[std::minmax(a, b)].push_back(sideOf(q, i));
    }
  std::size_t left = 0;
  const std::vector<OnChain> onChains = verticesOnChains(quads, mesh);
  for (Index c = 0; c < onChains.size(); ++c) {
    const OnChain& on = onChains[c];
    bool isWhole = on.size() >= 2 || on.empty();
    for (std::size_t i = 0; i + 1 < on.size(); ++i)
      isWhole &= sides.contains(std::minmax(on[i].second, on[i + 1].second));
    left += isWhole ? 0 : 1;
    // A border is where the quads end: its vertices stay on it even where the chain has gaps.
    const bool isBorder = mesh.surface().curves().chains()[c].boundary;
    for (std::size_t i = 0; (isWhole || isBorder) && i + 1 < on.size(); ++i)
      if (const auto found = sides.find(std::minmax(on[i].second, on[i + 1].second));
          found != sides.end())
        for (const Index side : found->second) quads.curves[side / 4][side % 4] = c;
    if (!isWhole && !isBorder)
      for (const auto& [arc, v] : on) {
        Placement& place = quads.vertices[v];
        if (place.kind == VertexKind::Curve)
          place = {place.position, place.normal, place.at, {}, VertexKind::Interior, Vec3::Zero()};
      }
  }
  return left;
}

}  // namespace remesher
