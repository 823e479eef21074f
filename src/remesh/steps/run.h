// SPDX-License-Identifier: MIT
// The state that every step of a scheme works with, and the one way to change the mesh: propose,
// judge, apply.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "base/progress.h"
#include "original/surface/size_field.h"
#include "remesh/gate/fidelity.h"
#include "remesh/ground/stand_in.h"
#include "remesh/operators/local_operators.h"
#include "remesh/steps/effort.h"

namespace remesher {

// How the vertices of open boundaries slide: by sizes alone, or to suit their inner neighbours too.
enum class Boundaries { Even, Staggered };

class OriginalTree;

struct Run {
  WorkingMesh& mesh;
  Projector& projector;
  SizeField& sizes;
  FidelityRule rule;
  Effort effort = kUsual;
  double scale = 1;    // of the sizes at the present level
  double stagger = 0;  // how far curve vertices follow all their neighbours: see curveSweep
  Boundaries boundaries = Boundaries::Even;
  const StandIn* standIn = nullptr;  // what the mesh lies on until it lands, if not on the original
  OriginalTree* tree = nullptr;      // of the original, if the caller wants it afterwards
  std::optional<Thinned> thinned = {};  // the stand-in before the mesh landed, if it has
  LocalChange change = {};              // the proposal at hand
  Star star = {};                       // the star at hand
  Vertex result = {};  // what the last change made, moved or kept; none after a flip
  std::array<std::size_t, 6> verdicts = {};  // how often the gate gave each
};

// Carries out a change that has been judged.
inline void carryOut(Run& run, const LocalChange& change) {
  run.result = apply(run.mesh, change);
  if (run.rule.guard) run.rule.guard->update(change, run.result);
}

// Judges the proposal at hand by `rule` and carries it out if it is accepted.
inline bool commit(Run& run, const FidelityRule& rule) {
  const Verdict verdict = judge(run.mesh, run.change, rule);
  ++run.verdicts[std::size_t(verdict)];
  if (verdict != Verdict::Accepted) return false;
  carryOut(run, run.change);
  return true;
}

inline bool commit(Run& run) { return commit(run, run.rule); }

// Moves an interior vertex, whose star is at hand, if the gate accepts it. Never inlined: one copy
// is enough.
[[gnu::noinline]] inline bool commitMove(Run& run, Vertex v, const Placement& place) {
  if (!mayMove(run.star, place, run.rule)) {
    proposePlacement(run.mesh, v, place, run.change);
    return commit(run);
  }
  ++run.verdicts[std::size_t(Verdict::Accepted)];
  run.mesh.move(v, place);
  run.result = v;
  return true;
}

// For changes that are made even if they fold the mesh over: carries out the proposal at hand
// unless triangles become lines or more of them intersect.
inline bool commitUnlessFlat(Run& run) {
  if (flattens(run.mesh, run.change, run.rule.grain)) return false;
  if (run.rule.guard && !run.rule.guard->allows(run.change)) return false;
  carryOut(run, run.change);
  return true;
}

// With an error bound proofs are the main work. From now on `perTriangle` pieces of surface may be
// looked at for each triangle of the mesh; then no change is allowed. A usual triangle needs less
// than a hundred, a needle as many as there are places to try.
inline void grantProofs(const Run& run, std::size_t perTriangle) {
  constexpr std::size_t kLeast = 1 << 16;
  if (!run.rule.bound) return;
  run.rule.bound->grant(std::max(kLeast, perTriangle * run.mesh.mesh().faceCount()));
}

inline bool areProofsSpent(const Run& run) { return run.rule.bound && run.rule.bound->isSpent(); }

// The run's rule, but more tolerant of folds: for changes that are worth one.
inline FidelityRule lenient(const Run& run) {
  FidelityRule rule = run.rule;
  rule.fold = kTightFold;
  return rule;
}

}  // namespace remesher
