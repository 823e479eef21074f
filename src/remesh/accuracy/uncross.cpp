// SPDX-License-Identifier: MIT
#include "remesh/accuracy/uncross.h"

#include <algorithm>
#include <vector>

#include "base/patience.h"
#include "remesh/gate/angles.h"

namespace remesher {

namespace {

// The proposal that leaves the fewest intersecting pairs; among equals, the one with the widest
// smallest angle.
class FewestPairs {
 public:
  explicit FewestPairs(const Run& run) : rule_(lenient(run)) { rule_.guard = nullptr; }

  void offer(const Run& run) {
    const std::ptrdiff_t growth = run.asked.rule.guard->growth(run.scratch.change);
    if (growth >= 0 || growth > growth_) return;
    const double angle = smallestComingAngle(run.mesh, run.scratch.change);
    if (growth == growth_ && angle <= angle_) return;
    if (judge(run.mesh, run.scratch.change, rule_) != Verdict::Accepted) return;
    growth_ = growth, angle_ = angle, change_ = run.scratch.change;
  }

  bool carryOut(Run& run) const {
    if (growth_ >= 0) return false;
    run.scratch.change = change_;
    remesher::carryOut(run, change_);
    return true;
  }

 private:
  FidelityRule rule_;  // without the guard, which is asked separately
  LocalChange change_ = {};
  std::ptrdiff_t growth_ = 0;
  double angle_ = 0;
};

// Offers to put v back on the surface, and to move it towards the middles of the triangles around.
void offerMoves(Run& run, Vertex v, FewestPairs& best) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  if (run.mesh.kind(v) != VertexKind::Interior) return;
  proposePlacement(run.mesh, v, run.mesh.onSurface(run.mesh.at(v)), run.scratch.change);
  best.offer(run);
  std::vector<Halfedge> around;
  mesh.forEachOutgoing(v, [&](Halfedge h) { around.push_back(h); });
  for (const Halfedge h : around)
    for (const double step : {0.15, 0.3, 0.6})
      if (proposeRelocation(run.mesh, run.projector, {h, {1 - step, step / 2, step / 2}},
                            run.scratch.change))
        best.offer(run);
}

void offerAtEdge(Run& run, Halfedge h, FewestPairs& best) {
  if (proposeFlip(run.mesh, h, run.scratch.change)) best.offer(run);
  if (proposeSplit(run.mesh, run.projector, h, run.scratch.change)) best.offer(run);
  for (const Halfedge way : {h, run.mesh.mesh().twin(h)}) {
    if (!way) continue;
    if (proposeCollapseInto(run.mesh, way, run.scratch.change)) best.offer(run);
    if (proposeCollapse(run.mesh, run.projector, way, run.scratch.change)) best.offer(run);
  }
}

double lengthOf(const Run& run, Halfedge h) {
  return (run.mesh.position(run.mesh.mesh().tip(h)) - run.mesh.position(run.mesh.mesh().origin(h)))
      .norm();
}

bool mendCrossed(Run& run, Face f) {
  FewestPairs best(run);
  for (int k = 0; k < 3; ++k) offerAtEdge(run, HalfedgeMesh::halfedge(f, k), best);
  for (const Vertex v : run.mesh.mesh().vertices(f)) offerMoves(run, v, best);
  return best.carryOut(run);
}

// Halves a triangle for which nothing helps at once: a finer mesh is nearer to the original, which
// does not meet itself. Normals have no say: where sheets are near to each other, those at corners
// may be the other sheet's. Both halves may meet what the whole does.
bool halve(Run& run, Face f) {
  std::array<Halfedge, 3> sides = {HalfedgeMesh::halfedge(f, 0), HalfedgeMesh::halfedge(f, 1),
                                   HalfedgeMesh::halfedge(f, 2)};
  std::stable_sort(sides.begin(), sides.end(),
                   [&](Halfedge a, Halfedge b) { return lengthOf(run, a) > lengthOf(run, b); });
  for (const Halfedge side : sides) {
    if (!proposeSplit(run.mesh, run.projector, side, run.scratch.change)) continue;
    if (flattens(run.mesh, run.scratch.change, run.asked.rule.grain)) continue;
    carryOut(run, run.scratch.change);
    return true;
  }
  return false;
}

// The triangles that the last change has left or made.
void addChanged(const Run& run, std::vector<Face>& faces) {
  faces.insert(faces.end(), run.scratch.change.going.begin(), run.scratch.change.going.end());
  if (const Vertex v = run.scratch.result)
    run.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { faces.push_back(HalfedgeMesh::face(h)); });
}

// Those of the triangles that meet others, and the others.
std::vector<Face> stillCrossed(const Run& run, std::vector<Face> suspects) {
  const auto makeUnique = [](std::vector<Face>& faces) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  };
  makeUnique(suspects);
  std::vector<Face> crossed;
  for (const Face f : suspects) {
    if (!run.mesh.mesh().isAlive(f)) continue;
    const std::vector<Face> met = run.asked.rule.guard->metBy(f);
    if (!met.empty()) crossed.push_back(f);
    crossed.insert(crossed.end(), met.begin(), met.end());
  }
  makeUnique(crossed);
  return crossed;
}

}  // namespace

std::size_t uncross(Run& run, std::vector<Face> crossed) {
  // Mending one triangle takes as long as so many triangles of the original take when all is made
  // anew.
  constexpr std::size_t kWorthMending = 64;
  std::size_t budget = run.mesh.surface().mesh().faceCount() / kWorthMending;
  Prospect prospect(2 * run.asked.effort.polishRounds);
  while (!crossed.empty() && crossed.size() <= budget && prospect.isGood(double(crossed.size()))) {
    budget -= crossed.size();
    std::vector<Face> suspects = crossed;
    for (const Face f : crossed)
      if (run.mesh.mesh().isAlive(f) && !run.asked.rule.guard->metBy(f).empty() &&
          (mendCrossed(run, f) || halve(run, f)))
        addChanged(run, suspects);
    crossed = stillCrossed(run, std::move(suspects));
  }
  return crossed.size();
}

}  // namespace remesher
