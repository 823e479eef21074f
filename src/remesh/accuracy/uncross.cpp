// SPDX-License-Identifier: MIT
#include "remesh/accuracy/uncross.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "base/patience.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/local_search.h"

namespace remesher {

namespace {

// How many intersecting pairs fewer the proposal at hand leaves, and less than one more the wider
// its smallest angle. rule: without the guard, which is asked separately.
double pairsMended(const Run& run, const FidelityRule& rule, double least) {
  const LocalChange& change = run.scratch.change;
  const auto fewer = -double(run.asked.rule.guard->growth(change));
  if (fewer <= 0 || fewer + 1 <= least) return 0;
  const double gain = fewer + smallestComingAngle(run.mesh, change) / std::numbers::pi;
  return gain > least && judge(run.mesh, change, rule) == Verdict::Accepted ? gain : 0;
}

// Offers to put v back on the surface, and to move it between its neighbours.
void offerMoves(Run& run, Vertex v, LocalSearch& search) {
  if (run.mesh.kind(v) != VertexKind::Interior) return;
  proposePlacement(run.mesh, v, run.mesh.onSurface(run.mesh.at(v)), run.scratch.change);
  search.offer();
  for (const double step : {0.15, 0.3, 0.6}) search.offerStepsBetween(v, step);
}

bool mendCrossed(Run& run, Face f) {
  FidelityRule rule = lenient(run);
  rule.guard = nullptr;
  LocalSearch search(run, [&](double least) { return pairsMended(run, rule, least); });
  search.offerAtEdges(
      f, {EdgeMove::Flip, EdgeMove::Split, EdgeMove::CollapseInto, EdgeMove::Collapse});
  for (const Vertex v : run.mesh.mesh().vertices(f)) offerMoves(run, v, search);
  return search.carryOut();
}

// Halves a triangle for which nothing helps at once: a finer mesh is nearer to the original, which
// does not meet itself. Normals have no say: where sheets are near to each other, those at corners
// may be the other sheet's. Both halves may meet what the whole does.
bool halve(Run& run, Face f) {
  std::array<Halfedge, 3> sides = {HalfedgeMesh::halfedge(f, 0), HalfedgeMesh::halfedge(f, 1),
                                   HalfedgeMesh::halfedge(f, 2)};
  std::stable_sort(sides.begin(), sides.end(), [&](Halfedge a, Halfedge b) {
    return run.mesh.edgeLength(a) > run.mesh.edgeLength(b);
  });
  for (const Halfedge side : sides) {
    if (!proposeSplit(run.mesh, run.projector, side, run.scratch.change)) continue;
    if (flattens(run.mesh, run.scratch.change, run.asked.rule.quantum)) continue;
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
    const auto isCrossed = [&](Face f) {
      return run.mesh.mesh().isAlive(f) && !run.asked.rule.guard->metBy(f).empty();
    };
    mendEach(crossed, 1, isCrossed, [&](Face f) {
      const bool isMended = mendCrossed(run, f) || halve(run, f);
      if (isMended) addChanged(run, suspects);
      return isMended;
    });
    crossed = stillCrossed(run, std::move(suspects));
  }
  return crossed.size();
}

}  // namespace remesher
