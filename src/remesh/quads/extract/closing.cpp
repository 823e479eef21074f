// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/closing.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "mesh/topology.h"
#include "remesh/quads/extract/short_cycles.h"

namespace remesher {

namespace {

using Loop = std::vector<Halfedge>;

// Closes loops by cutting off ears, the one with the shortest third side first.
class LoopClosing {
 public:
  explicit LoopClosing(const WorkingMesh& mesh) : mesh_(mesh) {
    const HalfedgeMesh& m = mesh.mesh();
    for (Index i = 0; i < m.vertexCapacity(); ++i)
      parts_.places.push_back(mesh.placement(Vertex(i)));
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      parts_.triangles.push_back(m.origin(Halfedge(i)).index);
      parts_.twins.push_back(m.twin(Halfedge(i)).index);
      parts_.curves.push_back(mesh.curve(Halfedge(i)));
    }
  }

  WorkingMesh run() { return WorkingMesh(mesh_.surface(), parts_); }

  void close(const Loop& loop) {
    std::vector<Side> sides;
    for (auto h = loop.rbegin(); h != loop.rend(); ++h) {
      sides.push_back({originOf(HalfedgeMesh::next(*h)), h->index});
      parts_.curves[h->index] = kNone;
      Placement& place = parts_.places[sides.back().from];
      const SurfacePoint at = mesh_.cornerPoint(HalfedgeMesh::next(*h));
      place = {place.position, place.normal, at, {}, VertexKind::Interior, Vec3::Zero()};
    }
    while (sides.size() > 3) cutEar(sides, shortestEar(sides));
    addTriangle({sides[0], sides[1], sides[2]});
  }

  // Cuts along a cycle; new vertices are on its left side.
  void cut(const Loop& cycle) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Halfedge before = cycle[(i + cycle.size() - 1) % cycle.size()];
      const auto copy = Index(parts_.places.size());
      parts_.places.push_back(parts_.places[originOf(cycle[i])]);
      Halfedge h = cycle[i];
      for (; HalfedgeMesh::prev(h) != before; h = mesh_.mesh().twin(HalfedgeMesh::prev(h)))
        parts_.triangles[h.index] = copy;
      parts_.triangles[h.index] = copy;
    }
    Loop right;
    for (auto h = cycle.rbegin(); h != cycle.rend(); ++h) right.push_back(mesh_.mesh().twin(*h));
    for (const Halfedge h : right)
      parts_.twins[h.index] = parts_.twins[mesh_.mesh().twin(h).index] = kNone;
    close(cycle);
    close(right);
  }

 private:
  // A side of what is still open, from `from` on: `outside` is its halfedge in the triangle beyond.
  struct Side {
    Index from, outside;
  };

  Index originOf(Halfedge h) const { return parts_.triangles[h.index]; }

  double distance(Index a, Index b) const {
    return (parts_.places[a].position - parts_.places[b].position).norm();
  }

  // The place of the middle corner of the ear.
  std::size_t shortestEar(const std::vector<Side>& sides) const {
    const auto across = [&](std::size_t i) {
      return distance(sides[(i + sides.size() - 1) % sides.size()].from,
                      sides[(i + 1) % sides.size()].from);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (across(i) < across(best)) best = i;
    return best;
  }

  void cutEar(std::vector<Side>& sides, std::size_t i) {
    std::rotate(sides.begin(),
                sides.begin() + std::ptrdiff_t((i + sides.size() - 1) % sides.size()), sides.end());
    const Side last = {sides[2].from, kNone};
    addTriangle({sides[0], sides[1], last});
    sides[0].outside = Index(parts_.twins.size()) - 1;
    sides.erase(sides.begin() + 1);
  }

  void addTriangle(const std::array<Side, 3>& sides) {
    for (const Side& side : sides) {
      if (side.outside != kNone) parts_.twins[side.outside] = Index(parts_.twins.size());
      parts_.triangles.push_back(side.from);
      parts_.twins.push_back(side.outside);
      parts_.curves.push_back(kNone);
    }
  }

  const WorkingMesh& mesh_;
  WorkingMesh::Parts parts_;
};

// Whether the loop may be closed: no edge of it must stay, and no other curve ends on it.
bool mayClose(const WorkingMesh& mesh, const Loop& loop) {
  const HalfedgeMesh& m = mesh.mesh();
  return std::none_of(loop.begin(), loop.end(), [&](Halfedge h) {
    bool isBound = mesh.isKept(h);
    m.forEachOutgoing(m.origin(h),
                      [&](Halfedge out) { isBound |= m.twin(out) && mesh.isCurve(out); });
    return isBound;
  });
}

Simpler withoutSmallLoops(const WorkingMesh& mesh, double side, double most) {
  LoopClosing closing(mesh);
  std::size_t added = 0;
  for (const Loop& loop : boundaryLoops(mesh.mesh())) {
    const double length = lengthOf(mesh, loop);
    if (length >= most || !mayClose(mesh, loop)) continue;
    closing.close(loop);
    if (isWithinQuad(length, side)) added += 4;
  }
  return {closing.run(), {}, side, added};
}

CutHandle handleAt(const WorkingMesh& mesh, const Loop& cycle) {
  CutHandle handle;
  for (const Halfedge h : cycle) {
    const Vec3 &a = mesh.position(mesh.mesh().origin(h)), &b = mesh.position(mesh.mesh().tip(h));
    handle.middle += a / double(cycle.size());
    handle.facing -= a.cross(b);
  }
  return handle;
}

}  // namespace

Simpler withoutSmall(const WorkingMesh& mesh, double side, double most) {
  Simpler simpler = withoutSmallLoops(mesh, side, most);
  for (Loop cycle = shortestCycle(simpler.mesh, most); !cycle.empty();
       cycle = shortestCycle(simpler.mesh, most)) {
    simpler.handles.push_back(handleAt(simpler.mesh, cycle));
    simpler.added += 8;
    LoopClosing closing(simpler.mesh);
    closing.cut(cycle);
    simpler.mesh = closing.run();
  }
  return simpler;
}

void smoothBorders(WorkingMesh& mesh, double side) {
  constexpr int kPasses = 2;
  constexpr double kFarthest = 0.15, kSquaredCosine = 0.5;
  const VertexData<Vec3> first = mesh.positions();
  const std::vector<Loop> loops = boundaryLoops(mesh.mesh());
  for (int pass = 0; pass < kPasses; ++pass)
    for (const Loop& loop : loops) {
      std::set<Index> rough;
      std::vector<std::pair<Vertex, Vec3>> moves;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Halfedge h = loop[i], before = loop[(i + loop.size() - 1) % loop.size()];
        const Vertex v = mesh.mesh().origin(h);
        if (mesh.kind(v) != VertexKind::Curve) continue;
        const Vec3& here = mesh.position(v);
        const Vec3 in = here - mesh.position(mesh.mesh().origin(before));
        const Vec3 out = mesh.position(mesh.mesh().tip(h)) - here;
        const double along = std::max(0.0, in.dot(out));
        if (along * along < kSquaredCosine * in.squaredNorm() * out.squaredNorm())
          rough.insert(mesh.on(v).chain);
        moves.emplace_back(v, here + (out - in) / 4 - first[v]);
      }
      for (const auto& [v, move] : moves) {
        if (!rough.contains(mesh.on(v).chain)) continue;
        Placement place = mesh.placement(v);
        place.position = first[v] + std::min(1.0, kFarthest * side / move.norm()) * move;
        mesh.move(v, place);
      }
    }
}

}  // namespace remesher
