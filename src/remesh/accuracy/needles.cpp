// SPDX-License-Identifier: MIT
#include "remesh/accuracy/needles.h"

#include <algorithm>
#include <vector>

#include "geometry/pattern_search.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/shift.h"

namespace remesher {

namespace {

double smallestGone(const Run& run, const LocalChange& change) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const Grain& grain = run.asked.rule.grain;
  double smallest = smallestGoingAngle(run.mesh, change, grain);
  if (change.operation == Operation::Collapse)
    for (const Halfedge side : {change.halfedge, mesh.twin(change.halfedge)})
      if (side)  // a border has one
        smallest = std::min(smallest, smallestAngle(run.mesh, HalfedgeMesh::face(side), grain));
  return smallest;
}

// The proposal that widens the smallest angle around most.
class WidestAngle {
 public:
  explicit WidestAngle(double shift) : shift_(shift) {}

  // Normals at corners say too little of triangles this thin: whether they are lines, how far the
  // surface moves and whether it meets itself says enough.
  void offer(const Run& run) {
    const FidelityRule& rule = run.asked.rule;
    const LocalChange& change = run.scratch.change;
    const double angle = smallestComingAngle(run.mesh, change, rule.grain);
    const double gain = angle - smallestGone(run, change);
    if (gain <= gain_ || flattens(run.mesh, change, rule.grain)) return;
    if (shiftsBeyond(shift_, run.mesh, change)) return;
    if (!rule.guard->allows(change)) return;
    gain_ = gain, angle_ = angle, change_ = change;
  }

  double gain() const { return gain_; }
  // Whether it leaves no needle.
  bool mends() const { return !isNeedle(angle_); }

  bool carryOut(Run& run) const {
    if (gain_ <= 0) return false;
    if (change_.operation == Operation::Relocate) run.mesh.release(change_.vertex);
    if (change_.operation == Operation::Collapse &&
        !proposeCollapseInto(run.mesh, change_.halfedge, run.scratch.change))
      run.mesh.release(run.mesh.mesh().origin(change_.halfedge));
    remesher::carryOut(run, change_);
    return true;
  }

 private:
  double shift_;  // model units
  double gain_ = 0, angle_ = 0;
  LocalChange change_ = {};
};

// Offers to move v a step towards each neighbor, and between each two, on the surface.
void offerSteps(Run& run, Vertex v, double step, WidestAngle& widest) {
  std::vector<Halfedge> around;
  run.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { around.push_back(h); });
  for (const Halfedge h : around)
    for (const Vec3& weights : {Vec3(1 - step, step, 0), Vec3(1 - step, step / 2, step / 2)}) {
      const Placement place = run.projector.project(run.mesh, h, weights);
      proposePlacement(run.mesh, v, place, run.scratch.change);
      widest.offer(run);
    }
}

// The shortest step of a corner that leaves no needle; if there is none, that which gains most.
WidestAngle bestStep(Run& run, Face f, double shift) {
  WidestAngle best(shift);
  searchPattern([&](double step) {
    WidestAngle widest(shift);
    for (const Vertex v : run.mesh.mesh().vertices(f))
      if (mayBeReleased(run.mesh, v)) offerSteps(run, v, step, widest);
    if (widest.mends() || (!best.mends() && widest.gain() > best.gain())) best = widest;
    return false;
  });
  return best;
}

void offerAtEdges(Run& run, Face f, WidestAngle& widest) {
  for (int k = 0; k < 3; ++k) {
    const Halfedge h = HalfedgeMesh::halfedge(f, k);
    if (proposeFlip(run.mesh, h, run.scratch.change)) widest.offer(run);
    for (const Halfedge way : {h, run.mesh.mesh().twin(h)})
      if (way && (proposeCollapseInto(run.mesh, way, run.scratch.change) ||
                  proposeUnion(run.mesh, way, run.scratch.change)))
        widest.offer(run);
  }
}

bool mendNeedle(Run& run, Face f) {
  const Vertex v = run.mesh.mesh().vertices(f)[0];
  // A cell of the lattice that repair's surfaces follow is half an edge wide.
  WidestAngle widest = bestStep(run, f, 0.5 * run.asked.scale * run.sizes.at(run.mesh.at(v)));
  if (!widest.mends()) offerAtEdges(run, f, widest);
  return widest.carryOut(run);
}

}  // namespace

bool mendNeedles(Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  bool isAny = false;
  for (Face f(0); f.index < mesh.faceCapacity(); ++f.index)
    if (mesh.isAlive(f) && isNeedle(smallestAngle(run.mesh, f, run.asked.rule.grain)))
      isAny = mendNeedle(run, f) || isAny;
  return isAny;
}

}  // namespace remesher
