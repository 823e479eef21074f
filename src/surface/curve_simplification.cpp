// SPDX-License-Identifier: MIT
#include "surface/curve_simplification.h"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// Both in target edge lengths. Between two curves nearer than this there is no row of triangles
// that are any good; a chain shorter than this cannot be one edge of one.
constexpr double kNarrow = 0.5;
constexpr double kShort = 0.7;

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
    for (const Halfedge h : curves.free) mark(h, Role::Free);
    for (const Halfedge h : curves.fixed) mark(h, Role::Fixed);
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (mesh_.isBoundary(Halfedge(i))) mark(Halfedge(i), Role::Fixed);
    mergeNarrowRegions();
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
    double rim = 0;                     // length of its border
    std::map<Index, double> neighbors;  // length of the free border shared with each
    double width() const { return rim > 0 ? 2 * area / rim : 0; }
  };

  void mark(Halfedge h, Role role) {
    role_[h] = role;
    if (mesh_.twin(h)) role_[mesh_.twin(h)] = role;
  }

  double length(Halfedge h) const {
    return (positions_[mesh_.tip(h)] - positions_[mesh_.origin(h)]).norm();
  }

  // Numbers the parts into which the curves divide the surface.
  Index labelRegions() {
    region_.assign(mesh_.faceCapacity(), kNone);
    Index count = 0;
    std::vector<Face> stack;
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      if (region_[Face(f)] != kNone) continue;
      region_[Face(f)] = count;
      stack.push_back(Face(f));
      while (!stack.empty()) {
        const Halfedge first = HalfedgeMesh::halfedge(stack.back());
        stack.pop_back();
        for (const Halfedge h : {first, HalfedgeMesh::next(first), HalfedgeMesh::prev(first)}) {
          if (role_[h] != Role::None || region_[mesh_.face(mesh_.twin(h))] != kNone) continue;
          region_[mesh_.face(mesh_.twin(h))] = count;
          stack.push_back(mesh_.face(mesh_.twin(h)));
        }
      }
      ++count;
    }
    return count;
  }

  std::vector<Region> measureRegions() {
    std::vector<Region> regions(labelRegions());
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      const auto [a, b, c] = mesh_.vertices(Face(f));
      regions[region_[Face(f)]].area +=
          0.5 * areaVector(positions_[a], positions_[b], positions_[c]).norm();
    }
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (role_[h] == Role::None) continue;
      const Index own = region_[mesh_.face(h)];
      const Index other = role_[h] == Role::Free ? region_[mesh_.face(mesh_.twin(h))] : kNone;
      if (own == other) continue;
      regions[own].rim += length(h);
      if (other != kNone) regions[own].neighbors[other] += length(h);
    }
    return regions;
  }

  // The narrowest first, each into the neighbour with which it shares most of its border.
  void mergeNarrowRegions() {
    std::vector<Region> regions = measureRegions();
    std::vector<double> areas;
    std::vector<Index> into;
    std::set<std::pair<double, Index>> narrow;
    const auto enter = [&](Index r) {
      if (regions[r].width() < kNarrow * size_ && !regions[r].neighbors.empty())
        narrow.emplace(regions[r].width(), r);
    };
    for (Index r = 0; r < regions.size(); ++r) {
      areas.push_back(regions[r].area);
      into.push_back(r);
      enter(r);
    }
    while (!narrow.empty()) {
      const Index small = narrow.begin()->second;
      const Index large = widestBorder(regions[small]);
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

  // Of the regions that became one, all but the largest.
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

  static Index widestBorder(const Region& region) {
    auto best = region.neighbors.begin();
    for (auto n = region.neighbors.begin(); n != region.neighbors.end(); ++n)
      if (n->second > best->second) best = n;
    return best->first;
  }

  static void merge(std::vector<Region>& regions, Index small, Index large) {
    Region &from = regions[small], &to = regions[large];
    to.area += from.area;
    to.rim += from.rim - 2 * from.neighbors[large];
    to.neighbors.erase(small);
    for (const auto& [other, shared] : from.neighbors) {
      if (other == large) continue;
      to.neighbors[other] += shared;
      regions[other].neighbors.erase(small);
      regions[other].neighbors[large] += shared;
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

  // From a junction or a loose end to the next; empty if the chain is fixed or long enough.
  std::vector<Halfedge> shortChain(Halfedge first) const {
    std::vector<Halfedge> chain;
    double sum = 0;
    Halfedge h = first;
    while (role_[h] == Role::Free) {
      chain.push_back(h);
      sum += length(h);
      if (sum >= kShort * size_) return {};
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

SimplifiedCurves simplifyCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                const CurveEdges& curves, double size) {
  return Simplification(mesh, positions, size).run(curves);
}

}  // namespace remesher
