// SPDX-License-Identifier: MIT
// Which mesh comes out of a run: one ordered table of rules. Strategies make candidates; a rule
// asks for facts about the request and the candidates, and takes one of them. src/README.md lists
// the rows.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string_view>

#include "base/report.h"

namespace remesher {

// The decisions of a run, in order. Each has rows of its own; a later one may replace the mesh that
// an earlier one took.
enum class Decision {
  Surface,     // triangles of one surface
  Quads,       // quads of one surface
  Bound,       // the fewest vertices within an error bound
  OpenNumber,  // neither a number of vertices nor a bound was given
  Corners,     // a budget of vertices or faces, of a part with corners
  Limits,      // a number of vertices, and limits of angles or of edges as well
  OpenLimits,  // a smallest angle, which decides the number of vertices
  Repaired,    // a simplified mesh of a surface that was repaired
  Crossings,   // a result that intersects itself where the input does not
  Written,     // a result rounded to the digits that are written
  Budget,      // a scene with a budget of triangles
  Part,        // a mesh of a file that is no surface
  RepairOnly,  // repair without remeshing
};

enum class Candidate {
  AsMade,      // the mesh that is there already
  Isotropic,   // isotropic triangles of the number asked for
  Bounded,     // isotropic triangles within a distance that is not seen, proven
  Simplified,  // the vertices of the original that its shape needs most, or its triangles divided
  Conforming,  // triangles within the original's facets, on its shape exactly, or unrolled
  Uncrossed,   // isotropic triangles, made again by steps that add no self-intersection
  Own,         // of the input's own vertices those that the shape needs
  More,        // the mesh with the raised number of vertices
  Unlimited,   // the mesh made without regard to the limits
  MirroredQuads,
  Quads,
  Repaired,  // the surface that repair made
  Input,     // the mesh as it was given
};

// A fact is answered by the owner of the candidates, which are made on first use.
enum class Fact {
  Always,
  // About the request.
  RoundsAsked,
  IsotropicAsked,
  ShapeAsked,
  QuadsAsked,
  VerticesPlaced,  // by an option: density, edges, a bound, kept boundaries, repair …
  MoreThanInput,   // more vertices are wanted than the input has
  // About the candidates for one surface. A distance is seen if it is above kSeen.
  CornersExceedNumber,  // more corners of curves than vertices, where textures are baked or colours
                        // would raise the number; of a budget: more sharp corners
  SimplifiedToNumber,   // simplification reaches the number asked for
  SimplifiedOrDivided,  // simplification reaches it, or the original's triangles can be divided
  NumberReached,        // by the isotropic triangles
  FacetsMeshed,         // facet by facet, with the number asked for
  FacetsBetter,         // the mesh of facets is worth more than the isotropic one
  FacetsUnrolled,       // narrow facets were unrolled and meshed together
  IsotropicInstead,     // the facets' triangles are poorly shaped; isotropic ones keep edges,
                        // volume and distance
  UnfinishedFar,        // the unfinished isotropic triangles are hopelessly farther away
  UnfinishedNear,       // the unfinished isotropic triangles are not seen to be away: on parts of
                        // about their own number or more nowhere, else on average
  IsotropicFar,         // the finished isotropic triangles are seen to be away
  SimplifiedNearer,     // the simplified mesh is so much nearer that it is worth its angles
  FlatSidesRefined,     // more vertices than the input's are wanted, and flat sides show dents
  BoundedReached,       // the number, within the bound
  CornersDented,        // the number is too small for the part's corners, and dents it visibly
  // About quads.
  MirrorsKept,  // planes mirror the input, and quads that they mirror reach the number
  PartsPaired,  // some connected part has no map to squares
  // About the result.
  OwnWithinBound,      // the input's own vertices keep the bound
  SimplifiedTaken,     // instead of isotropic triangles
  InputIsotropic,      // the angles of the input's own triangles are wide on average
  ResultIsotropic,     // the same of the result, which is nowhere seen to be away
  MoreSuffice,         // with at most four times the input's vertices the triangles are so
  UnlimitedKeeps,      // the mesh made without regard to the limits keeps them
  FacetsKeep,          // facets keep the limits, if with more vertices than their mean length takes
  LimitsDent,          // triangles within the limits are far away, the others are not
  NumberFound,         // some number of vertices was tried for the angle
  ResultUnsound,       // open, not a 2-manifold, degenerate or self-intersecting
  OriginalSound,       // none of these, or closed where the result is open
  CrossingsMade,       // by a run that may mend them, of an input without any
  UncrossedReplaces,   // same number, hardly farther away, angles hardly worse, no crossing
  SimplifiedReplaces,  // same number, hardly farther away, no crossing
  BudgetExceeded,      // by what the parts of the scene need at least
  SimplifiedWithin,    // simplification keeps the budget, or exceeds it by less
  Unchanged,           // repair left every coordinate and triangle as it was
};

struct Condition {
  Fact fact = Fact::Always;
  bool holds = true;
};

struct Rule {
  Decision decision;
  std::string_view name;
  std::array<Condition, 5> when;  // all of them must hold
  Candidate taken;
  std::string_view reason;
};

// The table. The last row of each decision has no condition.
std::span<const Rule> chooserRules();

// The first row of the decision whose conditions all hold. A row's conditions are asked in order,
// and only until one fails.
const Rule& choose(Decision decision, const std::function<bool(Fact)>& isSo);

// The row as the report has it.
Chosen inReport(const Rule& rule);

}  // namespace remesher
