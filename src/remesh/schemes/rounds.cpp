// SPDX-License-Identifier: MIT
#include "remesh/schemes/rounds.h"

#include <algorithm>
#include <cmath>

#include "base/patience.h"
#include "mesh/star_passes.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/boundaries.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/lengths.h"
#include "remesh/steps/split_obtuse.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

constexpr int kAreaSweeps = 3;
constexpr int kAreaRounds = 10;
constexpr int kLaplacianRounds = 10;
// Where sizes are graded, rounds of splits and collapses come first, for edges much longer or
// shorter than their target, until none is left that may change.
constexpr int kGradingRounds = 12;
constexpr double kGradingShare = 0.4;  // of the time
constexpr double kMostGraded = 4;      // of the vertices asked for, or present: else slivers go on

// The length of an edge, in units of its target edge length if sizes differ.
double length(const Run& run, Halfedge h) {
  return run.sizes.isEven() ? run.mesh.edgeLength(h) : relativeLength(run, h);
}

bool isLongest(const Run& run, Halfedge side) {
  const double own = length(run, side);
  return own >= length(run, HalfedgeMesh::next(side)) &&
         own >= length(run, HalfedgeMesh::prev(side));
}

// How bad the triangles of an edge are; boundary edges come before all others.
double badness(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  const double most = radians(60) * radians(60);  // of a triangle
  const auto shortfall = [&](Face f) {
    const double missing = radians(60) - smallestAngle(mesh, f);
    return missing * missing;
  };
  if (m.isBoundary(h)) return 2 * most + shortfall(m.face(h));
  return shortfall(m.face(h)) + shortfall(m.face(m.twin(h)));
}

double goodness(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  if (m.isBoundary(h)) return smallestAngle(mesh, m.face(h));
  return std::max(smallestAngle(mesh, m.face(h)), smallestAngle(mesh, m.face(m.twin(h))));
}

EdgeQueue longestFirst(const Run& run) {
  return {run.mesh.mesh(), [&](Halfedge h) { return length(run, h); }};
}

EdgeQueue shortestFirst(const Run& run) {
  return {run.mesh.mesh(), [&](Halfedge h) { return -length(run, h); }};
}

// The order of insertion: the edges of the worst triangles first; with graded sizes the edges that
// exceed their target most, for bad angles say nothing about sizes.
EdgeQueue splitOrder(const Run& run) {
  if (!run.sizes.isEven()) return longestFirst(run);
  return {run.mesh.mesh(), [&](Halfedge h) { return badness(run.mesh, h); }};
}

// The order of collapses: the edges of the best triangles first; with graded sizes the edges
// shortest for their target.
EdgeQueue collapseOrder(const Run& run) {
  if (!run.sizes.isEven()) return shortestFirst(run);
  return {run.mesh.mesh(), [&](Halfedge h) { return goodness(run.mesh, h); }};
}

// When a round ends: at a number of vertices, or where no key is above a limit.
struct RoundGoal {
  std::size_t vertices;
  double above = -kInfinity;
};

// One round of changes, no triangle twice. tryChange: whether an edge was split or collapsed.
std::size_t roundOf(Run& run, EdgeQueue edges, const RoundGoal& goal,
                    bool (*tryChange)(Run&, Halfedge)) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  StarPasses passes(mesh);
  const auto goesOn = [&] {
    return edges.largestKey() > goal.above && mesh.vertexCount() != goal.vertices;
  };
  return passes.run(edges, goesOn, [&](Halfedge h) {
    return !passes.hasTouchedFace(h) && tryChange(run, h) ? run.scratch.result : Vertex();
  });
}

// Only edges that are the longest of their triangles are split.
bool trySplit(Run& run, Halfedge h) {
  for (const Halfedge side : {h, run.mesh.mesh().twin(h)})
    if (side && !isLongest(run, side)) return false;
  return proposeSplit(run.mesh, run.projector, h, run.scratch.change) && commitUnlessFlat(run);
}

// Where one end may not leave its place, the other may.
bool tryCollapse(Run& run, Halfedge h) {
  for (const Halfedge direction : {h, run.mesh.mesh().twin(h)})
    if (direction && proposeCollapse(run.mesh, run.projector, direction, run.scratch.change))
      return commit(run);
  return false;
}

void areaBasedRound(Run& run) {
  for (int i = 0; i < kAreaSweeps; ++i) areaBasedSweep(run);
  delaunayFlips(run.mesh, run.asked.rule);
}

// Splits edges that are too long and collapses edges that are too short, until the sizes are about
// the target sizes; the number of vertices then follows within a few percent. If the caller's
// density asks for triangles too large to lie as the surface does, they are not refused for that.
void grade(Run& run, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const FidelityRule rule = run.asked.rule;
  if (run.sizes.isWished() && rule.mode == Fidelity::Loose) run.asked.rule.mode = Fidelity::Fold;
  const auto most =
      std::size_t(kMostGraded * std::max(run.sizes.vertices(), double(mesh.vertexCount())));
  for (int i = 0; i < kGradingRounds; ++i) {
    progress.at(double(i) / kGradingRounds);
    std::size_t changes = roundOf(run, longestFirst(run), {most, kLong}, trySplit);
    changes += roundOf(run, shortestFirst(run), {0, -kShort}, tryCollapse);
    areaBasedRound(run);
    if (changes == 0) break;
  }
  run.asked.rule = rule;
}

// Most of the time goes into the rounds that change the number of vertices, if there are any.
double changingShare(std::size_t from, std::size_t to) {
  const double rounds = 4 * std::abs(std::log2(double(to) / double(from)));
  return rounds / (rounds + kAreaRounds + 0.3 * kLaplacianRounds);
}

}  // namespace

bool runRounds(Run& run, const RoundsGoal& goal, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double grading = run.sizes.isEven() ? 0 : kGradingShare;
  if (grading > 0) grade(run, progress.phase("grade", 0, grading));
  const Progress rest = progress.phase("rounds", grading, 1);
  const double start = double(mesh.vertexCount()), way = double(goal.vertices) - start;
  const double share = changingShare(mesh.vertexCount(), goal.vertices);
  Patience patience;
  std::size_t missing = 1, changes = 1;
  while (mesh.vertexCount() != goal.vertices && patience.after(changes, missing)) {
    rest.at(share * (double(mesh.vertexCount()) - start) / way);
    changes = mesh.vertexCount() < goal.vertices
                  ? roundOf(run, splitOrder(run), {goal.vertices}, trySplit)
                  : roundOf(run, collapseOrder(run), {goal.vertices}, tryCollapse);
    missing =
        std::max(mesh.vertexCount(), goal.vertices) - std::min(mesh.vertexCount(), goal.vertices);
    areaBasedRound(run);
  }
  bool reached = mesh.vertexCount() == goal.vertices;
  if (reached || changes > 0) {
    followBoundaries(run);
    reached = matchCount(run, goal.vertices);
  }
  if (goal.splitObtuse) splitObtuse(run);
  const Progress finish = rest.phase("smooth", share, 1);
  for (int i = 0; i < kAreaRounds; ++i) {
    finish.at(0.8 * i / kAreaRounds);
    areaBasedRound(run);
  }
  for (int i = 0; i < kLaplacianRounds; ++i) {
    finish.at(0.8 + 0.2 * i / kLaplacianRounds);
    laplacianSweep(run);
  }
  settleBoundaries(run);
  return reached;
}

}  // namespace remesher
