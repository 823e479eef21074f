// SPDX-License-Identifier: MIT
// The one gate that every operation passes [report, "Controlling Mesh Fidelity"].
//
// With N_i the original's unit normal under a corner i of a triangle T and N_T the normal of T
// itself:
//   strict  every pair  N_i·N_j > cos θ1  and every  N_i·N_T > cos θ2  (the report's text)
//   loose   some pair and some corner pass  (the report's program)
//   fold    every  N_i·N_T > fold, or the worst of them is no worse than it was before: than the
//           worst of the triangles that the operation replaces; and no triangle that leans so
//           far faces away from all of them
//
// Besides, no mode lets through more triangles without area than there are, and where there is a
// guard none more pairs of triangles that meet.
//
// With angles below 90° no triangle that turns over passes strict or loose.
#pragma once

#include "base/options.h"
#include "remesh/gate/crossing_guard.h"
#include "remesh/gate/error_bound.h"
#include "remesh/gate/grain.h"
#include "remesh/operators/local_change.h"
#include "remesh/operators/star.h"

namespace remesher {

enum class Verdict { Accepted, FoldsOver, VertexAngle, TriangleAngle, MaxError, Crosses };

// A triangle may lean 78° against the surface before it counts as folding over; 107° where the
// surface itself folds more tightly than the triangles are large, and nothing else would remove a
// cluster.
inline constexpr double kFold = 0.2;
inline constexpr double kTightFold = -0.3;

struct FidelityRule {
  Fidelity mode = Fidelity::Fold;
  double cosVertexAngle = 0;
  double cosTriangleAngle = 0;
  double fold = kFold;  // smallest N_i·N_T that is not a fold
  Grain grain = {};
  const ErrorBound* bound = nullptr;  // if any, of a mesh that is within it
  CrossingGuard* guard = nullptr;     // if any, to be told of all that is done to its mesh
};

FidelityRule fidelityRule(const RemeshOptions& options);

// Whether a triangle is a line in the numbers that are written.
bool isLine(const Triangle& triangle, const Grain& grain);

// Whether more triangles would be lines, in the numbers that are written, than are; or one have two
// corners at one place, which in a file would be one vertex, and sheets grown together. Projections
// of different points may end in one corner of the original, or on one edge.
bool flattens(const WorkingMesh& mesh, const LocalChange& change, const Grain& grain);

// Whether a vertex inside may surely move there, by a first look at its star, which is all that
// most moves need. What fails has to be judged.
bool mayMove(const Star& star, const Placement& place, const FidelityRule& rule);

Verdict judge(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule);

}  // namespace remesher
