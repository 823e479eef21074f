// SPDX-License-Identifier: MIT
#include "remesh/steps/delaunay.h"

#include <algorithm>

#include "geometry/polar_map.h"
#include "remesh/operators/local_operators.h"

namespace remesher {

namespace {

// The stack of Algorithm 1, with the marks that keep an edge from lying on it twice.
class EdgeStack {
 public:
  explicit EdgeStack(const HalfedgeMesh& mesh) : mesh_(mesh), marked_(mesh.halfedgeCapacity(), 0) {
    for (Index i = Index(mesh.halfedgeCapacity()); i-- > 0;)
      if (mesh.isEdge(Halfedge(i))) push(Halfedge(i));
  }

  void push(Halfedge h) {
    if (mesh_.isBoundary(h)) return;
    const Halfedge edge = std::min(h, mesh_.twin(h));
    if (marked_[edge]) return;
    marked_[edge] = 1;
    stack_.push_back(edge);
  }

  bool empty() const { return stack_.empty(); }

  Halfedge pop() {
    const Halfedge h = stack_.back();
    stack_.pop_back();
    marked_[h] = 0;
    return h;
  }

 private:
  const HalfedgeMesh& mesh_;
  HalfedgeData<char> marked_;
  std::vector<Halfedge> stack_;
};

// Whether neither of the two angles opposite to an edge is obtuse: so they sum to no more than π.
bool isPlainlyDelaunay(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  const Vec3 &a = mesh.position(m.origin(h)), &b = mesh.position(m.tip(h));
  const Vec3 &c = mesh.position(m.opposite(h)), &d = mesh.position(m.opposite(m.twin(h)));
  return (a - c).dot(b - c) >= 0 && (a - d).dot(b - d) >= 0;
}

}  // namespace

std::size_t delaunayFlips(WorkingMesh& mesh, const FidelityRule& rule) {
  const HalfedgeMesh& m = mesh.mesh();
  EdgeStack stack(m);
  LocalChange change;
  std::size_t flips = 0;
  // Flips in three dimensions need not end as they do in the plane; this bound is never met in
  // practice.
  const std::size_t limit = 10 * m.halfedgeCapacity();
  while (!stack.empty() && flips < limit) {
    const Halfedge h = stack.pop();
    if (m.isBoundary(h) || isPlainlyDelaunay(mesh, h)) continue;
    if (isLocallyDelaunay(unfold(m, mesh.positions(), h))) continue;
    if (!proposeFlip(mesh, h, change)) continue;
    if (judge(mesh, change, rule) != Verdict::Accepted) continue;
    const Halfedge edge = mesh.flip(h);
    if (rule.guard) rule.guard->update(change, {});
    ++flips;
    for (const Halfedge side : {edge, m.twin(edge)}) {
      stack.push(m.next(side));
      stack.push(m.prev(side));
    }
  }
  return flips;
}

}  // namespace remesher
