// SPDX-License-Identifier: MIT
#include "remesh/accuracy/needles.h"

#include <algorithm>

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
    const double gain =
        smallestComingAngle(run.mesh, change, rule.grain) - smallestGone(run, change);
    if (gain <= gain_ || flattens(run.mesh, change, rule.grain)) return;
    if (shiftsBeyond(shift_, run.mesh, change)) return;
    if (!rule.guard->allows(change)) return;
    gain_ = gain, change_ = change;
  }

  bool carryOut(Run& run) const {
    if (gain_ <= 0) return false;
    if (change_.operation == Operation::Collapse &&
        !proposeCollapseInto(run.mesh, change_.halfedge, run.scratch.change))
      run.mesh.release(run.mesh.mesh().origin(change_.halfedge));
    remesher::carryOut(run, change_);
    return true;
  }

 private:
  double shift_;  // model units
  double gain_ = 0;
  LocalChange change_ = {};
};

bool mendNeedle(Run& run, Face f) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  // A cell of the lattice that repair's surfaces follow is half an edge wide.
  WidestAngle widest(0.5 * run.asked.scale * run.sizes.at(run.mesh.at(mesh.vertices(f)[0])));
  for (int k = 0; k < 3; ++k) {
    const Halfedge h = HalfedgeMesh::halfedge(f, k);
    if (proposeFlip(run.mesh, h, run.scratch.change)) widest.offer(run);
    for (const Halfedge way : {h, mesh.twin(h)})
      if (way && (proposeCollapseInto(run.mesh, way, run.scratch.change) ||
                  proposeUnion(run.mesh, way, run.scratch.change)))
        widest.offer(run);
  }
  return widest.carryOut(run);
}

}  // namespace

bool mendNeedles(Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  bool isAny = false;
  for (Face f(0); f.index < mesh.faceCapacity(); ++f.index)
    if (mesh.isAlive(f) && smallestAngle(run.mesh, f, run.asked.rule.grain) < 2 * kSliver)
      isAny = mendNeedle(run, f) || isAny;
  return isAny;
}

}  // namespace remesher
