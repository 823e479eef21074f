// SPDX-License-Identifier: MIT
// The gate: decides whether a proposed change is accepted [DGP 2016, "Controlling Mesh Fidelity"].
// src/README.md lists the changes that do not pass it.
//
// With N_i the original's unit normal under a corner i of a triangle T and N_T the normal of T
// itself:
//   strict  every pair  N_i·N_j > cos θ1  and every  N_i·N_T > cos θ2  (the text of [DGP 2016])
//   loose   some pair and some corner pass  (its program)
//   fold    every  N_i·N_T > fold, or the worst is no worse than the worst of the triangles that
//           the operation replaces; and if the worst is kFold or less, no triangle faces away from
//           all that the operation replaces
//
// Besides, no mode lets the number of triangles without area grow or, with a guard, the number of
// intersecting pairs of triangles.
//
// With angles below 90° no triangle that turns over passes strict or loose.
#pragma once

#include "base/options.h"
#include "remesh/gate/crossing_guard.h"
#include "remesh/gate/error_bound.h"
#include "remesh/gate/quantum.h"
#include "remesh/operators/local_change.h"
#include "remesh/operators/star.h"

namespace remesher {

enum class Verdict { Accepted, FoldsOver, VertexAngle, TriangleAngle, MaxError, Crosses };

// A triangle may lean 78° against the surface before it counts as folding over. The limit is 107°
// where the surface itself folds more tightly than the triangles are large and nothing else would
// remove a cluster.
inline constexpr double kFold = 0.2;
inline constexpr double kTightFold = -0.3;

struct FidelityRule {
  Fidelity mode = Fidelity::Fold;
  double cosVertexAngle = 0;
  double cosTriangleAngle = 0;
  double fold = kFold;  // smallest N_i·N_T that is not a fold
  Quantum quantum = {};
  const ErrorBound* bound = nullptr;  // if any; the mesh must be within it
  CrossingGuard* guard = nullptr;     // if any; must be told of every change to its mesh
};

FidelityRule fidelityRule(const RemeshOptions& options);

// Whether a triangle is a line as written.
bool isLine(const Triangle& triangle, const Quantum& quantum);

// Whether a change makes more triangles that are lines, as written, than it replaces, or one with
// two corners at one place: a file would join these to one vertex and grow sheets together.
// Projections of different points may end in one corner of the original, or on one edge.
bool flattens(const WorkingMesh& mesh, const LocalChange& change, const Quantum& quantum);

// A quick test of a star that proves most moves of interior vertices allowed. A move that fails it
// has to be judged.
bool mayMove(const Star& star, const Placement& place, const FidelityRule& rule);

Verdict judge(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule);

}  // namespace remesher
