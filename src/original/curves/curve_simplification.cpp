// SPDX-License-Identifier: MIT
#include "original/curves/curve_simplification.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/components.h"

namespace remesher {

namespace {

// Both in target edge lengths. A row of triangles in a narrower region costs more than it shows; a
// shorter chain cannot be one edge of a good triangle.
constexpr double kNarrow = 0.5;
constexpr double kShortestChain = 0.7;
// A curve that bends the surface is worth thinner triangles, because without it the surface moves.
// At a bend of 90° the narrowest width shrinks by half of this share.
constexpr double kWorthOfBends = 0.8;
// A wall, as of sheet metal, between surfaces at least kWide target lengths wide may be thinner
// still: a surface that loses its walls is dented all along its rim.
constexpr double kWorthOfWalls = 1.6, kWide = 1.5;
// The bend of 90°; sharper bends count no more. A chain that bends so much may be as short as a
// wall is narrow, so that a wall as high as the chain is long stays, with the region between such
// walls.
constexpr double kRight = 0.5;
// Neighbours whose border is at least this share of the longest border are equally good partners.
constexpr double kAlike = 0.8;

double narrowestWall(double size, double bend) {
  return kNarrow * size * (1 - kWorthOfWalls * std::min(bend, kRight));
}

enum class Role : char { None, Free, Fixed };

class Simplification {
 public:
  Simplification(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double size)
      : mesh_(mesh),
        positions_(positions),
        size_(size),
        role_(mesh.halfedgeCapacity(), Role::None),
        absorbed_(mesh.faceCapacity(), 0) {}

  SimplifiedCurves run(const CurveEdges& curves) {
    if (curves.free.empty()) return {{}, absorbed_};
    for (const Halfedge h : curves.free) mark(h, Role::Free);
    for (const Halfedge h : curves.fixed) mark(h, Role::Fixed);
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (mesh_.isBoundary(Halfedge(i))) mark(Halfedge(i), Role::Fixed);
    mergeNarrowRegions(curves.flats);
    // Releasing a chain may make the chain beside it short, so all chains are checked again.
    while (releaseShortChains()) {
    }
    std::vector<Halfedge> kept;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (mesh_.isEdge(Halfedge(i)) && role_[Halfedge(i)] == Role::Free) kept.emplace_back(i);
    return {kept, absorbed_};
  }

 private:
  struct Region {
    double area = 0;
    double flat = 0;                    // area that lies in planes
    double rim = 0;                     // length of its border
    std::map<Index, Border> neighbors;  // per region the free border shared with it
    double width() const { return rim > 0 ? 2 * area / rim : 0; }
  };

  void mark(Halfedge h, Role role) {
    role_[h] = role;
    if (mesh_.twin(h)) role_[mesh_.twin(h)] = role;
  }

  double length(Halfedge h) const {
    return (positions_[mesh_.tip(h)] - positions_[mesh_.origin(h)]).norm();
  }

  // Numbers the regions into which the curves divide the surface.
  Index labelRegions() {
    FaceRegions regions = regionsOf(mesh_, [&](Halfedge h) { return role_[h] == Role::None; });
    region_ = std::move(regions.of);
    return regions.count;
  }

  std::vector<Region> measureRegions(const FlatRegions& flats) {
    std::vector<Region> regions(labelRegions());
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      const auto [a, b, c] = mesh_.vertices(Face(f));
      const double area = 0.5 * areaVector(positions_[a], positions_[b], positions_[c]).norm();
      regions[region_[Face(f)]].area += area;
      if (flats.at(Face(f)) != kNone) regions[region_[Face(f)]].flat += area;
    }
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (role_[h] == Role::None) continue;
      const Index own = region_[mesh_.face(h)];
      const Index other = role_[h] == Role::Free ? region_[mesh_.face(mesh_.twin(h))] : kNone;
      if (own == other) continue;
      regions[own].rim += length(h);
      if (other != kNone) regions[own].neighbors[other].add(borderAlong(mesh_, positions_, h));
    }
    return regions;
  }

  static double longestBorder(const Region& region) {
    double longest = 0;
    for (const auto& [other, border] : region.neighbors) longest = std::max(longest, border.length);
    return longest;
  }

  // Whether the regions along its sides are wide.
  bool isWall(const Region& region, const std::vector<Region>& regions) const {
    const double along = kAlike * longestBorder(region);
    return std::all_of(region.neighbors.begin(), region.neighbors.end(), [&](const auto& shared) {
      return shared.second.length < along || regions[shared.first].width() >= kWide * size_;
    });
  }

  bool isNarrow(const std::vector<Region>& regions, Index r) const {
    const Region& region = regions[r];
    if (region.neighbors.empty()) return false;
    const double bend = region.neighbors.at(partnerOf(regions, r)).meanBend();
    const double narrowest =
        isWall(region, regions) ? narrowestWall(size_, bend) : narrowestWidth(size_, bend);
    return region.width() < narrowest;
  }

  // Merges narrow regions, narrowest first, each into a neighbour.
  void mergeNarrowRegions(const FlatRegions& flats) {
    std::vector<Region> regions = measureRegions(flats);
    std::vector<double> areas;
    std::vector<Index> into;
    std::set<std::pair<double, Index>> narrow;
    const auto enter = [&](Index r) {
      if (isNarrow(regions, r)) narrow.emplace(regions[r].width(), r);
    };
    for (Index r = 0; r < regions.size(); ++r) {
      areas.push_back(regions[r].area);
      into.push_back(r);
      enter(r);
    }
    while (!narrow.empty()) {
      const Index small = narrow.begin()->second;
      const Index large = partnerOf(regions, small);
      narrow.erase(narrow.begin());
      narrow.erase({regions[large].width(), large});
      merge(regions, small, large);
      into[small] = large;
      enter(large);
    }
    for (Index& r : into)
      while (into[r] != r) r = into[r];
    absorb(into, areas);
    releaseWithin(into);
  }

  // Marks the faces of merged regions, except those of the largest region of each merger.
  void absorb(const std::vector<Index>& into, const std::vector<double>& areas) {
    std::vector<Index> largest = into;
    for (Index r = 0; r < into.size(); ++r)
      if (areas[r] > areas[largest[into[r]]]) largest[into[r]] = r;
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      const Index r = region_[Face(f)];
      absorbed_[Face(f)] = r != largest[into[r]];
    }
  }

  void releaseWithin(const std::vector<Index>& into) {
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh_.isEdge(h) || role_[h] != Role::Free) continue;
      const Index own = region_[mesh_.face(h)], other = region_[mesh_.face(mesh_.twin(h))];
      if (own != other && into[own] == into[other]) mark(h, Role::None);
    }
  }

  // The neighbour with the longest border to r. Among similar borders the least flat neighbour,
  // because it bends already. Then the narrowest, so that strips side by side join each other
  // before a wide region swallows them one by one.
  static Index partnerOf(const std::vector<Region>& regions, Index r) {
    const double along = kAlike * longestBorder(regions[r]);
    Index best = kNone;
    for (const auto& [other, border] : regions[r].neighbors)
      if (border.length >= along &&
          (best == kNone || std::pair(regions[other].flat, regions[other].width()) <
                                std::pair(regions[best].flat, regions[best].width())))
        best = other;
    return best;
  }

  static void merge(std::vector<Region>& regions, Index small, Index large) {
    Region &from = regions[small], &to = regions[large];
    to.area += from.area;
    to.flat += from.flat;
    to.rim += from.rim - 2 * from.neighbors[large].length;
    to.neighbors.erase(small);
    for (const auto& [other, shared] : from.neighbors) {
      if (other == large) continue;
      to.neighbors[other].add(shared);
      regions[other].neighbors.erase(small);
      regions[other].neighbors[large].add(shared);
    }
    from.neighbors.clear();
  }

  std::vector<Halfedge> curveEdges(Vertex v) const {
    std::vector<Halfedge> edges;  // halfedges that leave v, or the one that enters along a boundary
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      if (role_[h] != Role::None) edges.push_back(h);
      if (mesh_.isBoundary(mesh_.prev(h))) edges.push_back(mesh_.prev(h));
    });
    return edges;
  }

  // The chain from a junction or loose end to the next; empty if it is fixed or long enough.
  std::vector<Halfedge> shortChain(Halfedge first) const {
    std::vector<Halfedge> chain;
    Border sum;
    Halfedge h = first;
    while (role_[h] == Role::Free) {
      chain.push_back(h);
      sum.add(borderAlong(mesh_, positions_, h));
      if (sum.length >= shortestChain(size_, sum.meanBend())) return {};
      const std::vector<Halfedge> on = curveEdges(mesh_.tip(h));
      if (on.size() != 2) return chain;
      h = on[on[0] == mesh_.twin(h) ? 1 : 0];
    }
    return {};
  }

  bool releaseShortChains() {
    bool released = false;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (role_[h] != Role::Free || curveEdges(mesh_.origin(h)).size() == 2) continue;
      for (const Halfedge edge : shortChain(h)) {
        mark(edge, Role::None);
        released = true;
      }
    }
    return released;
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  double size_;
  HalfedgeData<Role> role_;
  FaceData<Index> region_;
  FaceData<char> absorbed_;
};

}  // namespace

Border borderAlong(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h) {
  const Vec3 &a = positions[mesh.origin(h)], &b = positions[mesh.tip(h)];
  const Vec3 here = unitNormal(a, b, positions[mesh.opposite(h)]);
  const Vec3 beyond = unitNormal(b, a, positions[mesh.opposite(mesh.twin(h))]);
  const double length = (b - a).norm();
  return {length, length * (0.5 - 0.5 * here.dot(beyond))};
}

double narrowestWidth(double size, double bend) {
  return kNarrow * size * (1 - kWorthOfBends * bend);
}

double shortestChain(double size, double bend) {
  return std::lerp(kShortestChain, narrowestWall(1, bend), std::min(1.0, bend / kRight)) * size;
}

SimplifiedCurves simplifyCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                const CurveEdges& curves, double size) {
  return Simplification(mesh, positions, size).run(curves);
}

}  // namespace remesher
