// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/error.h"
#include "base/fires.h"
#include "base/place.h"
#include "geometry/extent.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "mesh/given_order.h"
#include "mesh/joining.h"
#include "mesh/submesh.h"
#include "repair/body_union.h"
#include "repair/diagnosis.h"
#include "repair/exact_repair.h"
#include "repair/findings.h"
#include "repair/fineness.h"
#include "repair/holes/close_holes.h"
#include "repair/ladder.h"
#include "repair/one_sided.h"
#include "repair/solid/solid.h"
#include "repair/stitch.h"

namespace remesher {

namespace {

bool makesBodies(const PartOptions& options) { return options.thickness || options.base; }

LoopRule loopRule(const TriangleMesh& input, const PartOptions& options, double mostDisk) {
  LoopRule rule;
  if (options.holesUpTo) rule.longest = *options.holesUpTo / 100 * diagonalOf(input);
  rule.mostDisk = makesBodies(options) ? std::min(mostDisk, ladder::kMostDiskOfBody) : mostDisk;
  rule.keepsRims = options.keepRims;
  rule.keepsSheets = makesBodies(options);
  return rule;
}

std::optional<BodyRule> bodyRule(const TriangleMesh& input, const PartOptions& options) {
  constexpr double kUsualBase = 0.02;  // of the diagonal
  if (options.base)
    return BodyRule{BodyRule::Kind::Base,
                    options.thickness.value_or(kUsualBase * diagonalOf(input))};
  if (options.thickness) return BodyRule{BodyRule::Kind::Thick, *options.thickness};
  return std::nullopt;
}

RepairedMesh withHolesClosed(const TriangleMesh& input, const PartOptions& options) {
  LoopRule rule = loopRule(input, options, options.keepRims ? ladder::kMostDisk : kInfinity);
  rule.keepsSheets |= options.keepRims;
  return asRepaired(closedOnly(input, rule), "holes");
}

RepairedMesh wrapped(const TriangleMesh& input, const PartOptions& options) {
  const SolidRule rule = ruleFor(input, options, InsideBy::Reach);
  RepairedMesh result = asRepaired(solidOf(input, rule), input, rule);
  if (!result.mesh.indices.empty()) return result;
  if (rule.sheets == Sheets::Drop)
    throw Error(ErrorCode::NoTriangles, "There are only sheets, which were to be left out.",
                "Thicken them: --sheets thicken.");
  throw Error(
      ErrorCode::NoTriangles, "The triangles are too small to be wrapped.",
      "Was the mesh scaled to zero in one direction, or does it lie too far from the origin?");
}

// A surface that encloses nothing is wrapped instead.
RepairedMesh solidified(Solid solid, const TriangleMesh& input, const PartOptions& options) {
  if (solid.mesh.indices.empty()) {
    fires("repair: nothing is enclosed, so wrapped");
    return wrapped(input, options);
  }
  return asRepaired(std::move(solid), input, ruleFor(input, options, InsideBy::Enclosure));
}

// Whether the surface bounds bodies: beside a body nearly all half lines agree which side is
// inside, beside an open sheet most do not; and a lattice of bodies loses hardly any visible
// surface.
bool isClear(const Enclosure& enclosure) {
  return enclosure.unsure < ladder::kMostUnsure && enclosure.lost < ladder::kMostLost &&
         enclosure.isAny;
}

// How many triangles intersect others, without those of cards (flat open pieces of several
// triangles).
std::size_t countCrossed(const Diagnosis& diagnosis) {
  const std::vector<Index> cards = trianglesOf(diagnosis, isCard);
  std::size_t crossed = 0;
  for (const Index t : diagnosis.crossings)
    crossed += std::size_t(!std::binary_search(cards.begin(), cards.end(), t));
  return crossed;
}

// The lattice of a repair alone. What is decided on it does not depend on how many vertices the
// surface gets afterwards: otherwise a thin strip is a body for one number and a sheet for the
// next.
SolidRule ruleOfRepairAlone(const TriangleMesh& input, const PartOptions& options) {
  PartOptions alone;
  alone.gap = options.gap;
  alone.sheets = options.sheets;
  return ruleFor(input, alone, InsideBy::Reach);
}

// Whether hardly anything but sheets is there, such as cards or a terrain: open pieces that are
// seen from both sides. Loose triangles, and surfaces most of whose triangles intersect others, do
// not count as sheets.
bool isOfSheets(const TriangleMesh& input, const PartOptions& options) {
  const Diagnosis diagnosis = diagnose(input);
  const double crossed = double(countCrossed(diagnosis));
  if (isLoose(input) || crossed > ladder::kMostSheetsCrossed * double(input.triangleCount()) ||
      openShare(diagnosis) < ladder::kNearlyAllSheets)
    return false;
  const SolidRule rule = ruleOfRepairAlone(input, options);
  return enclosureOf(input, rule).sheetShare > ladder::kNearlyAllSheets;
}

RepairedMesh withReason(const char* reason, RepairedMesh result) {
  result.report.reason = reason;
  return result;
}

const char* modeOf(const ExactRepair& exact) {
  return exact.way == ExactRepair::Way::United || exact.way == ExactRepair::Way::Made ? "solid"
                                                                                      : "holes";
}

const char* reasonOf(const ExactRepair& exact) {
  switch (exact.way) {
    case ExactRepair::Way::Unchanged:
      return "sound";
    case ExactRepair::Way::Closed:
      return "closed";
    case ExactRepair::Way::Made:
      return "made";
    default:
      return "united";
  }
}

// What exact repair cannot decide: bodies from a lattice, sheets left as they are, or a wrap.
RepairedMesh remadeOrLeft(const TriangleMesh& input, const PartOptions& options) {
  std::optional<SolidGround> ground(std::in_place, input,
                                    ruleFor(input, options, InsideBy::Enclosure));
  fires("repair: lattice, since there is no exact outside");
  if (isClear(ground->enclosure())) {
    fires("repair: bodies made by a lattice");
    return withReason("enclosed", solidified(ground->solid(), input, options));
  }
  ground.reset();  // a wrap takes as much memory again
  if (isOfSheets(input, options)) {
    fires("repair: sheets left as they are");
    return withReason("sheets", asRepaired(leftAlone(input), "holes"));
  }
  fires("repair: wrapped");
  return withReason("open", wrapped(input, options));
}

// Warns of options that a lattice's surface, or one left alone, does not fulfil.
RepairedMesh withUnmetOptions(const PartOptions& options, RepairedMesh result) {
  if (options.keepRims && result.isRemade)
    addWarning(result, {"RIMS_NOT_KEPT",
                        "The surface was made anew by a lattice, which leaves no loop open."});
  if (makesBodies(options))
    addWarning(result,
               {"SHEETS_NOT_MADE_BODIES",
                "Sheets did not become bodies as asked: their sides intersect in ways that cannot "
                "be cut exactly. Ask for less thickness."});
  return result;
}

double areaOfAll(const TriangleMesh& mesh) { return extentOf(mesh).area; }

// The gap is a share of the diagonal of all, not of the part.
PartOptions forPart(const TriangleMesh& part, const TriangleMesh& all, PartOptions options) {
  const double ratio = diagonalOf(all) / diagonalOf(part);
  if (std::isfinite(ratio)) options.gap = usualGap(options) * ratio;
  return options;
}

// Adds the second report to the first: losses by area, shells and triangles turned. The counts of
// loops and sheets stay the first one's, and the places of losses become the second one's.
void addReport(RepairedMesh& result, const RepairedMesh& rest, double restShare) {
  RepairReport& sum = result.report;
  sum.lost = (1 - restShare) * sum.lost + restShare * rest.report.lost;
  sum.shells += rest.report.shells;
  sum.turned += rest.report.turned;
  sum.lostAt = rest.report.lostAt;
  if (rest.isRemade) {
    sum.mode = rest.report.mode;
    sum.reason = "partly";
  }
  result.warnings.insert(result.warnings.end(), rest.warnings.begin(), rest.warnings.end());
}

// Warns of all self-intersections of a mesh joined from two, including those between the two.
void warnOfAllCrossings(RepairedMesh& result, const std::vector<Index>& crossings) {
  std::erase_if(result.warnings,
                [](const PlacedWarning& own) { return own.warning.code == "CROSSINGS_LEFT"; });
  warnOfCrossings(result, crossings);
}

// The triangles as welded vertex numbers, each rotated so that its smallest number comes first;
// sorted.
std::vector<std::array<Index, 3>> sortedTriangles(std::span<const Index> corners,
                                                  const std::vector<Index>& positionOf) {
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    std::array<Index, 3> t = {positionOf[corners[i]], positionOf[corners[i + 1]],
                              positionOf[corners[i + 2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Whether both have the same triangles, in whichever order.
bool haveSameTriangles(const TriangleMesh& one, const TriangleMesh& other) {
  if (one.indices.size() != other.indices.size()) return false;
  TriangleMesh both = one;
  append(both, other);
  const std::vector<Index> first = weld(both.positions);
  const auto corners = std::span<const Index>(both.indices);
  return sortedTriangles(corners.first(one.indices.size()), first) ==
         sortedTriangles(corners.subspan(one.indices.size()), first);
}

// What was mended exactly together with what a lattice made of the rest, or with sheets as they
// were. None if both cannot be united.
std::optional<RepairedMesh> withRest(RepairedMesh result, const TriangleMesh& rest,
                                     const TriangleMesh& input, const PartOptions& options) {
  RepairedMesh made = remadeOrLeft(rest, forPart(rest, input, options));
  const double decided = areaOfAll(result.mesh), undecided = areaOfAll(rest);
  addReport(result, made, undecided / (decided + undecided));
  result.report.lostBeyond = made.report.lostBeyond * diagonalOf(rest) / diagonalOf(input);
  result.isRemade = made.isRemade;
  append(result.mesh, made.mesh);
  if (!made.isRemade) {
    if (haveSameTriangles(result.mesh, input)) {
      result.mesh = input;
      result.report.reason = made.report.reason;
    }
    warnOfAllCrossings(result, selfIntersections(result.mesh));
    return result;
  }
  std::optional<ExactRepair> joined = exactlyRepaired(result.mesh);
  if (!joined || !joined->undecided.indices.empty()) {
    fires("repair: the lattice's bodies cannot be united with the others");
    return std::nullopt;
  }
  if (!options.cavities) fillCavities(*joined, Filled::Made);
  result.mesh = std::move(joined->mesh);
  result.report.shells += joined->hiddenAt.size();
  warnOfHidden(result, joined->hiddenAt);
  addWarning(
      result,
      {"REMADE_IN_PART",
       "Bodies whose outside could not be found exactly were rebuilt on a lattice. All other "
       "triangles are as they were, or were repaired exactly.",
       rest.triangleCount()},
      centreOfFirst(rest, {0}));
  warnOfAllCrossings(result, joined->crossings);
  return result;
}

RepairedMesh automatic(const TriangleMesh& input, const PartOptions& options) {
  std::optional<ExactRepair> exact = exactlyRepaired(
      input, {loopRule(input, options, ladder::kMostDisk), bodyRule(input, options)});
  if (!exact) return withUnmetOptions(options, remadeOrLeft(input, options));
  if (!options.cavities) fillCavities(*exact, Filled::Made);
  const TriangleMesh rest = std::move(exact->undecided);
  // Which sheets are left out is decided by the lattice around everything.
  if (!rest.indices.empty() && options.sheets == Sheets::Drop)
    return withUnmetOptions(options, remadeOrLeft(input, options));
  const char* const reason = reasonOf(*exact);
  const char* const mode = modeOf(*exact);
  RepairedMesh result = withReason(reason, asRepaired(std::move(*exact), mode));
  if (rest.indices.empty()) return result;
  std::optional<RepairedMesh> whole = withRest(std::move(result), rest, input, options);
  return withUnmetOptions(options, whole ? std::move(*whole) : remadeOrLeft(input, options));
}

// The exact steps where they decide everything.
std::optional<ExactRepair> whollyRepaired(const TriangleMesh& input) {
  std::optional<ExactRepair> exact = exactlyRepaired(input);
  if (exact && !exact->undecided.indices.empty()) return std::nullopt;
  return exact;
}

RepairedMesh solid(const TriangleMesh& input, const PartOptions& options) {
  if (std::optional<ExactRepair> exact = whollyRepaired(input)) {
    if (exact->sheetsAt.empty()) {
      if (!options.cavities) fillCavities(*exact, Filled::All);
      return asRepaired(std::move(*exact), "solid");
    }
  }
  return solidified(solidOf(input, ruleFor(input, options, InsideBy::Enclosure)), input, options);
}

RepairedMesh repaired(const TriangleMesh& input, const PartOptions& options) {
  const char* const asked = "asked";
  switch (options.repair) {
    case Repair::Holes:
      return withReason(asked, withHolesClosed(input, options));
    case Repair::Solid:
      return withReason(asked, solid(input, options));
    case Repair::Wrap:
      return withReason(asked, wrapped(input, options));
    default:
      return automatic(input, options);
  }
}

// Whether repair has not helped: the result has more self-intersections or non-manifold edges than
// the input, is open and no less so, or still has one side only.
bool failsToMend(const RepairedMesh& result, const TriangleMesh& input) {
  const MeshReport before = inspectMesh(input), after = inspectMesh(result.mesh);
  return result.report.selfIntersections[1] > result.report.selfIntersections[0] ||
         after.nonManifoldEdges > before.nonManifoldEdges ||
         (after.boundaryEdges > 0 && after.boundaryEdges >= before.boundaryEdges) ||
         oneSidedOf(result.mesh).edges > 0;
}

// Whether only a tear makes the part one-sided, so that cutting its few edges open and closing them
// mends it. The seam of a Möbius strip or a Klein bottle grows with the square root of the number
// of triangles.
bool isFlaw(const OneSided& found) {
  constexpr std::size_t kTrianglesPerSquare = 50;
  return kTrianglesPerSquare * found.edges * found.edges < found.triangles.size();
}

// Parts with one side only have no outside: but for flaws that repair mends they stay as they are.
RepairedMesh keepingOneSided(RepairedMesh whole, const TriangleMesh& input,
                             const PartOptions& options) {
  const OneSided found = oneSidedOf(input);
  if (found.edges == 0 || (isFlaw(found) && !failsToMend(whole, input))) return whole;
  fires("repair: surface of one side left as it is");
  std::vector<Index> marks(input.triangleCount(), 0);
  for (const Index t : found.triangles) marks[t] = 1;
  ExactRepair kept = leftAlone(selected(input, marks, 1).mesh);
  kept.sheetsAt.clear();
  RepairedMesh result = withReason("sheets", asRepaired(std::move(kept), "holes"));
  if (found.triangles.size() < input.triangleCount()) {
    const TriangleMesh oneSided = std::move(result.mesh);
    result = repaired(selected(input, marks, 0).mesh, options);
    append(result.mesh, oneSided);
    warnOfAllCrossings(result, selfIntersections(result.mesh));
    result.report.selfIntersections[0] = selfIntersections(input).size();
  }
  warnOfOneSided(result, found);
  return result;
}

// Of a surface in canonical order what repair leaves with one side.
OneSided leftOneSidedOf(const TriangleMesh& ordered) {
  PartOptions alone;
  alone.repair = Repair::Auto;
  const OneSided found = oneSidedOf(ordered);
  if (!isFlaw(found) || failsToMend(repaired(ordered, alone), ordered)) return found;
  return {};
}

// With cracks and T-junctions stitched, and without triangles whose corners are on a line: what
// such a triangle joined, the cuts at T-junctions join instead.
TriangleMesh stitched(const TriangleMesh& input) {
  TriangleMesh mesh = atOnePosition(input);
  if (countUnbalancedEdges(mesh) > 0) weldOpenVertices(mesh);
  stitchOpenEdges(mesh);
  return mesh;
}

// The repair that `auto` would choose with default options, without building the lattice's surface.
// Off where all would be left as sheets.
Repair repairFor(const TriangleMesh& input) {
  const PartOptions alone;
  std::optional<ExactRepair> exact =
      exactlyRepaired(input, {loopRule(input, alone, ladder::kMostDisk), std::nullopt});
  if (exact) fillCavities(*exact, Filled::Made);
  TriangleMesh rest = exact ? exact->undecided : input;
  if (!rest.indices.empty()) {
    const PartOptions own = exact ? forPart(rest, input, alone) : alone;
    if (isClear(enclosureOf(rest, ruleFor(rest, own, InsideBy::Enclosure)))) return Repair::Solid;
    if (!isOfSheets(rest, own)) return Repair::Wrap;
  }
  if (!exact) return Repair::Off;
  append(rest, exact->mesh);
  if (haveSameTriangles(rest, input)) return Repair::Off;
  return exact->way == ExactRepair::Way::United ? Repair::Solid : Repair::Holes;
}

}  // namespace

OneSided leftOneSided(const TriangleMesh& input) { return leftOneSidedOf(inCanonicalOrder(input)); }

FaultReport faultsOf(const TriangleMesh& input) {
  requireValid(input);
  requireMemory(input, {});
  const Diagnosis diagnosis = diagnose(input);
  FaultReport faults;
  const double diagonal = diagonalOf(input);
  for (const Opening& opening : openingsOf(diagnosis.built)) {
    faults.openLoops.push_back(100 * opening.length / diagonal);
    faults.places.openLoops.push_back(opening.at);
  }
  faults.selfIntersections = diagnosis.crossings.size();
  faults.places.selfIntersections = centreOfFirst(input, diagnosis.crossings);
  faults.places.innerShells = cornersOf(diagnosis, isShell);
  faults.innerShells = faults.places.innerShells.size();
  faults.places.insideOut = cornersOf(diagnosis, isInsideOut);
  faults.insideOut = faults.places.insideOut.size();
  if (isSound(diagnosis)) return faults;
  PartOptions alone;
  const TriangleMesh ordered = inCanonicalOrder(input);
  const bool isLeft = leftOneSidedOf(ordered).triangles.size() == ordered.triangleCount();
  faults.repair = isLeft ? Repair::Off : repairFor(ordered);
  alone.repair = faults.repair;
  if (faults.repair == Repair::Off) return faults;
  if (faults.repair != Repair::Wrap)
    for (const Vec3& place : facingInwards(diagnosis)) faults.places.insideOut.push_back(place);
  faults.insideOut = faults.places.insideOut.size();
  faults.needs = needsOf(input, alone);
  return faults;
}

std::optional<RepairedMesh> exactBodies(const TriangleMesh& input) {
  const TriangleMesh mesh = haveAreas(input) ? input : stitched(input);
  if (mesh.indices.empty()) return std::nullopt;
  std::optional<ExactRepair> exact = whollyRepaired(mesh);
  if (!exact || !exact->sheetsAt.empty()) return std::nullopt;
  const bool isSound = exact->way == ExactRepair::Way::Unchanged;
  if (!isSound && countUnbalancedEdges(exact->mesh) > 0) return std::nullopt;
  const char* const reason = reasonOf(*exact);
  return withReason(reason, asRepaired(std::move(*exact), "solid"));
}

std::vector<Vec3> openPieces(const TriangleMesh& input) {
  const TriangleMesh mesh = stitched(input);
  if (mesh.indices.empty()) return {};
  const std::optional<ExactRepair> exact = exactlyRepaired(mesh);
  if (exact && !exact->sheetsAt.empty()) return exact->sheetsAt;
  const bool isPart = exact && !exact->undecided.indices.empty();
  return cornersOf(diagnose(isPart ? exact->undecided : mesh), isSheet);
}

RepairedMesh repairSurface(const TriangleMesh& input, const PartOptions& options) {
  requireValid(input);
  requireMemory(input, options);
  const TriangleMesh ordered = inCanonicalOrder(input);
  RepairedMesh result = repaired(ordered, options);
  const bool makesThick = options.repair == Repair::Auto && options.thickness && !options.base;
  const bool mayLeaveOneSided = options.repair == Repair::Holes || options.repair == Repair::Auto;
  if (mayLeaveOneSided && !makesThick && result.report.reason != "sound")
    result = keepingOneSided(std::move(result), ordered, options);
  if (result.isRemade) {
    result.report.selfIntersections[0] = selfIntersections(input).size();
    // A body of a few triangles, thinner than single precision tells, may come out inside out.
    if (faceOutwards(result.mesh)) fires("repair: the lattice's bodies turned");
  }
  result.mesh = haveSameContent(result.mesh, ordered) ? input : inGivenOrder(result.mesh, input);
  return result;
}

}  // namespace remesher
