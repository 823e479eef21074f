// SPDX-License-Identifier: MIT
#include "remesh/schemes/chooser.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "base/fires.h"

namespace remesher {

namespace {

constexpr Condition is(Fact fact) { return {fact, true}; }
constexpr Condition no(Fact fact) { return {fact, false}; }

// Rows are ordered: a row is read with the knowledge that none above it in its decision holds.
constexpr std::array kRules = {
    Rule{Decision::Surface,
         "rounds",
         {is(Fact::RoundsAsked)},
         Candidate::Isotropic,
         "The scheme `rounds` was asked for."},
    Rule{Decision::Surface,
         "isotropic-asked",
         {is(Fact::IsotropicAsked)},
         Candidate::Isotropic,
         "Isotropic triangles were asked for."},
    Rule{Decision::Surface,
         "vertices-placed",
         {is(Fact::VerticesPlaced)},
         Candidate::Isotropic,
         "Simplification does not keep all that the options ask for, such as a bound, limits of "
         "edges, "
         "density or repair."},
    Rule{Decision::Surface,
         "shape-conforming",
         {is(Fact::ShapeAsked), is(Fact::FacetsMeshed)},
         Candidate::Conforming,
         "The shape was preferred: each facet was meshed in its own plane."},
    Rule{Decision::Surface,
         "shape-refined",
         {is(Fact::ShapeAsked), is(Fact::MoreThanInput)},
         Candidate::Bounded,
         "The shape was preferred, with more vertices than the input has: isotropic triangles that "
         "are nowhere visibly away."},
    Rule{Decision::Surface,
         "shape-asked",
         {is(Fact::ShapeAsked), is(Fact::SimplifiedToNumber)},
         Candidate::Simplified,
         "The shape was preferred."},
    Rule{Decision::Surface,
         "corners-exceed-number",
         {is(Fact::CornersExceedNumber), is(Fact::SimplifiedToNumber)},
         Candidate::Simplified,
         "The number of vertices is too small for the corners of all curves."},
    Rule{Decision::Surface,
         "facets-unrolled",
         {is(Fact::FacetsBetter), is(Fact::FacetsUnrolled)},
         Candidate::Conforming,
         "Facets of round walls and fillets, too narrow for well-shaped triangles, were unrolled "
         "and meshed together: the triangles there are hardly seen to be away."},
    Rule{Decision::Surface,
         "facets-conforming",
         {is(Fact::FacetsBetter)},
         Candidate::Conforming,
         "Each facet was meshed in its own plane, so that the shape is exactly the input's; other "
         "isotropic triangles would change it, or miss the number of vertices."},
    Rule{Decision::Surface,
         "isotropic-instead",
         {is(Fact::IsotropicInstead)},
         Candidate::Isotropic,
         "The triangles of the facets would be poorly shaped; isotropic ones keep the sharp edges "
         "and the volume, and are hardly seen to be away."},
    Rule{Decision::Surface,
         "isotropic-far-unfinished",
         {is(Fact::NumberReached), is(Fact::UnfinishedFar)},
         Candidate::Simplified,
         "Isotropic triangles would change the shape far more than simplification does."},
    Rule{Decision::Surface,
         "number-missed",
         {no(Fact::NumberReached), is(Fact::SimplifiedOrDivided)},
         Candidate::Simplified,
         "Isotropic triangles did not reach the number of vertices; simplification did."},
    Rule{Decision::Surface,
         "simplified-nearer",
         {no(Fact::UnfinishedNear), is(Fact::IsotropicFar), is(Fact::SimplifiedNearer)},
         Candidate::Simplified,
         "Isotropic triangles would visibly change the shape; simplification is much nearer."},
    Rule{Decision::Surface,
         "flat-sides-refined",
         {is(Fact::FlatSidesRefined), is(Fact::IsotropicFar), is(Fact::BoundedReached)},
         Candidate::Bounded,
         "Plain isotropic triangles would dent flat sides: those taken are nowhere visibly away."},
    Rule{Decision::Surface,
         "isotropic-near-unfinished",
         {is(Fact::UnfinishedNear)},
         Candidate::Isotropic,
         "Isotropic triangles are on average not visibly away from the original."},
    Rule{Decision::Surface,
         "isotropic-near",
         {no(Fact::IsotropicFar)},
         Candidate::Isotropic,
         "Isotropic triangles are on average not visibly away from the original."},
    Rule{
        Decision::Surface,
        "resampled",
        {is(Fact::MoreThanInput)},
        Candidate::Isotropic,
        "With more vertices than the input has, isotropic triangles replace its own and visibly "
        "leave its facets. `prefer: shape` or the input's number of vertices keeps its triangles."},
    Rule{Decision::Surface,
         "isotropic",
         {},
         Candidate::Isotropic,
         "No simplified mesh is near enough to be worth its uneven triangles."},

    Rule{Decision::Quads,
         "quads-mirrored",
         {is(Fact::MirrorsKept)},
         Candidate::MirroredQuads,
         "Quads were asked for, and planes mirror the input: quads of one side were mirrored."},
    Rule{Decision::Quads,
         "quads-paired",
         {is(Fact::PartsPaired)},
         Candidate::Quads,
         "Quads were asked for; where no map to squares was found they are pairs of triangles."},
    Rule{Decision::Quads, "quads", {}, Candidate::Quads, "Quads were asked for."},

    Rule{Decision::Bound,
         "own-triangles",
         {no(Fact::QuadsAsked), no(Fact::IsotropicAsked), is(Fact::MoreThanInput),
          is(Fact::OwnWithinBound)},
         Candidate::Own,
         "The vertices that the shape needs keep the error bound; isotropic triangles would take "
         "more than the input has."},
    Rule{Decision::Bound, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::OpenNumber,
         "more-vertices",
         {is(Fact::SimplifiedTaken), no(Fact::InputIsotropic), no(Fact::ResultIsotropic),
          is(Fact::MoreSuffice)},
         Candidate::More,
         "No number of vertices was given: isotropic triangles need this many."},
    Rule{Decision::OpenNumber,
         "own-number",
         {is(Fact::SimplifiedTaken), no(Fact::InputIsotropic), no(Fact::ResultIsotropic)},
         Candidate::Own,
         "No number of vertices was given, and isotropic triangles would visibly change the shape, "
         "or be too many."},
    Rule{Decision::OpenNumber, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::Corners,
         "corners-kept",
         {is(Fact::CornersExceedNumber), is(Fact::CornersDented)},
         Candidate::More,
         "The budget would visibly dent the part: there are as many vertices as its corners need."},
    Rule{Decision::Corners, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::Limits,
         "unlimited-keeps",
         {is(Fact::UnlimitedKeeps)},
         Candidate::Unlimited,
         "Without the limits the mesh keeps them, too, but for one in a thousand at most."},
    Rule{Decision::Limits,
         "facets-keep",
         {is(Fact::FacetsKeep)},
         Candidate::More,
         "Facets keep the limits and the shape, with as many vertices as that takes."},
    Rule{Decision::Limits,
         "limits-dent",
         {is(Fact::LimitsDent)},
         Candidate::Unlimited,
         "Triangles within the limits would visibly dent the part."},
    Rule{Decision::Limits, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::OpenLimits,
         "angle-kept-anyway",
         {is(Fact::UnlimitedKeeps)},
         Candidate::Unlimited,
         "Without the limit the mesh keeps it, too."},
    Rule{Decision::OpenLimits,
         "vertices-for-angle",
         {is(Fact::NumberFound)},
         Candidate::More,
         "The vertices are as many as the smallest angle needs."},
    Rule{Decision::OpenLimits, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::Repaired,
         "simplified-unsound",
         {is(Fact::SimplifiedTaken), is(Fact::ResultUnsound), is(Fact::OriginalSound)},
         Candidate::Isotropic,
         "Simplification would make the repaired surface intersect itself."},
    Rule{Decision::Repaired, "as-made", {}, Candidate::AsMade, "The mesh is isotropic, or sound."},

    Rule{Decision::Crossings,
         "uncrossed",
         {is(Fact::CrossingsMade), no(Fact::ShapeAsked), is(Fact::UncrossedReplaces)},
         Candidate::Uncrossed,
         "Isotropic triangles intersected each other, and were made again without that."},
    Rule{Decision::Crossings,
         "uncrossed-simplified",
         {is(Fact::CrossingsMade), no(Fact::SimplifiedTaken), no(Fact::ShapeAsked),
          no(Fact::IsotropicAsked), is(Fact::SimplifiedReplaces)},
         Candidate::Simplified,
         "Isotropic triangles intersect each other; the simplified mesh does not."},
    Rule{Decision::Crossings,
         "as-made",
         {},
         Candidate::AsMade,
         "The mesh has no self-intersection of its own, or no other candidate is better."},

    Rule{Decision::Written,
         "only-repaired",
         {no(Fact::QuadsAsked), is(Fact::ResultUnsound), is(Fact::OriginalSound)},
         Candidate::Repaired,
         "Rounded to the digits that are written, the remeshed surface would not be sound: the "
         "repaired surface is written."},
    Rule{Decision::Written, "as-made", {}, Candidate::AsMade, "The rounded mesh is as sound."},

    Rule{Decision::Budget,
         "budget-simplified",
         {is(Fact::BudgetExceeded), is(Fact::SimplifiedWithin)},
         Candidate::Simplified,
         "Isotropic triangles would exceed the budget; simplification keeps it, or comes nearer to "
         "it."},
    Rule{Decision::Budget, "as-made", {}, Candidate::AsMade, "The mesh stays."},

    Rule{Decision::Part,
         "no-surface",
         {},
         Candidate::Input,
         "No triangle has an area: the mesh is passed on as it came."},

    Rule{Decision::RepairOnly,
         "kept",
         {is(Fact::Unchanged)},
         Candidate::Input,
         "Nothing was to be repaired: every vertex and triangle is as it was."},
    Rule{Decision::RepairOnly, "repaired", {}, Candidate::Repaired, "Repair changed the surface."},
};

}  // namespace

std::span<const Rule> chooserRules() { return kRules; }

const Rule& choose(Decision decision, const std::function<bool(Fact)>& isSo) {
  const auto isMet = [&](const Condition& condition) {
    return condition.fact == Fact::Always || isSo(condition.fact) == condition.holds;
  };
  const auto* const row = std::find_if(kRules.begin(), kRules.end(), [&](const Rule& rule) {
    return rule.decision == decision && std::all_of(rule.when.begin(), rule.when.end(), isMet);
  });
  assert(row != kRules.end());
  fires(row->name);
  return *row;
}

Chosen inReport(const Rule& rule) { return {std::string(rule.name), std::string(rule.reason)}; }

}  // namespace remesher
