// SPDX-License-Identifier: MIT
// The state that every step of a scheme works with, and the usual way to change the mesh: propose,
// judge, apply.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "base/progress.h"
#include "original/surface/size_field.h"
#include "remesh/gate/fidelity.h"
#include "remesh/ground/proxy.h"
#include "remesh/operators/local_operators.h"
#include "remesh/steps/effort.h"

namespace remesher {

// How the vertices of open boundaries slide: by sizes alone, or to suit their inner neighbours too.
enum class Boundaries { Even, Staggered };

class OriginalTree;

// The request to the steps, which the scheme sets. Steps only change `scale` (adaptToSizes,
// boundError).
struct Asked {
  FidelityRule rule;
  Effort effort = kUsual;
  double scale = 1;    // of the sizes at the present level
  double stagger = 0;  // how far curve vertices follow all their neighbours: see curveSweep
  Boundaries boundaries = Boundaries::Even;
  bool areQuads = false;  // triangles 2q and 2q + 1, from the same first corner, are quad q
};

// What there is of the original besides the surface that the mesh lies on.
struct Grounds {
  const Proxy* proxy = nullptr;    // the surface of the mesh until it is reprojected, or null
  std::optional<Thinned> thinned;  // the proxy that the mesh was reprojected from, if any
  OriginalTree* tree = nullptr;    // of the original, if the caller wants it afterwards
};

// Where the change at hand is put together: one at a time, without memory of the change before.
struct Scratch {
  LocalChange change;  // the proposal
  Star star;
  Vertex result;  // the vertex that the last change made, moved or kept; none after a flip
};

// The mesh that is worked on, with all that steps need to work on it.
struct Run {
  WorkingMesh& mesh;
  Projector& projector;
  SizeField& sizes;
  Asked asked;
  Grounds grounds = {};
  Scratch scratch = {};
  std::array<std::size_t, 6> verdicts = {};  // how often the gate gave each
};

// Carries out a change that has been judged.
inline void carryOut(Run& run, const LocalChange& change) {
  run.scratch.result = apply(run.mesh, change);
  if (run.asked.rule.guard) run.asked.rule.guard->update(change, run.scratch.result);
}

// Judges the proposal at hand by `rule` and carries it out if it is accepted.
inline bool commit(Run& run, const FidelityRule& rule) {
  const Verdict verdict = judge(run.mesh, run.scratch.change, rule);
  ++run.verdicts[std::size_t(verdict)];
  if (verdict != Verdict::Accepted) return false;
  carryOut(run, run.scratch.change);
  return true;
}

inline bool commit(Run& run) { return commit(run, run.asked.rule); }

// Moves an interior vertex, whose star is at hand, if the gate accepts it. Never inlined: one copy
// is enough.
[[gnu::noinline]] inline bool commitMove(Run& run, Vertex v, const Placement& place) {
  if (!mayMove(run.scratch.star, place, run.asked.rule)) {
    proposePlacement(run.mesh, v, place, run.scratch.change);
    return commit(run);
  }
  ++run.verdicts[std::size_t(Verdict::Accepted)];
  run.mesh.move(v, place);
  run.scratch.result = v;
  return true;
}

// For changes that are made even if they fold the mesh over: carries out the proposal at hand
// unless triangles become lines or more of them intersect.
inline bool commitUnlessFlat(Run& run) {
  if (flattens(run.mesh, run.scratch.change, run.asked.rule.quantum)) return false;
  if (run.asked.rule.guard && !run.asked.rule.guard->allows(run.scratch.change)) return false;
  carryOut(run, run.scratch.change);
  return true;
}

// With an error bound proofs are the main work. So many pieces of surface may be looked at for each
// triangle of the mesh. A usual triangle needs less than a hundred, a needle as many as there are
// places to try.
inline constexpr std::size_t kProofs = 1000;

// Once the pieces are spent that are granted here, no change is allowed.
inline void grantProofs(const Run& run) {
  if (!run.asked.rule.bound) return;
  run.asked.rule.bound->grant(kProofs * run.mesh.mesh().faceCount());
}

inline bool areProofsSpent(const Run& run) {
  return run.asked.rule.bound && run.asked.rule.bound->isSpent();
}

// The run's rule, but more tolerant of folds: for changes that are worth one.
inline FidelityRule lenient(const Run& run) {
  FidelityRule rule = run.asked.rule;
  rule.fold = -kFold;
  return rule;
}

}  // namespace remesher
