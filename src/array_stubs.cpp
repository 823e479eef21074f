// SPDX-License-Identifier: MIT
// Link-time stubs of repair, quads and whole steps for the engine for arrays. The package loads the
// whole engine for a job that needs one of these.
#include "base/error.h"
#include "jobs/angle_number.h"
#include "jobs/checks/quad_checks.h"
#include "jobs/checks/wanted_check.h"
#include "jobs/checks/whole_steps.h"
#include "jobs/dropping.h"
#include "jobs/part_repair.h"
#include "jobs/parts/drawing_order.h"
#include "jobs/parts/part_guides.h"
#include "jobs/pixel_levels.h"
#include "jobs/region_run.h"
#include "jobs/thinned_parts.h"
#include "jobs/touching_parts.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/as_quads.h"
#include "remesh/schemes/edge_limits.h"

namespace remesher {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorCode::Unsupported,
              std::string(what) + " is not in the engine for arrays, remesher_arrays.wasm.",
              "Load remesher.wasm.");
}

}  // namespace

PartsRepair repairParts(std::vector<io::Part>, const PartOptions&, const Progress&) {
  refuse("Repair");
}

Dropped dropSmallPieces(std::vector<io::Part>&, const PartOptions&) { refuse("Leaving out"); }
Dropped dropHiddenTriangles(std::vector<io::Part>&, Hidden) { refuse("Leaving out"); }

void keepDrawingOrder(std::vector<io::Part>&, const std::vector<io::Part>&) {}

SceneRun withinPixels(double, const Report&, const RunOfLevel&) { refuse("A level by pixels"); }

RoundedMesh inSoundPrecisionOf(const TriangleMesh&, RemeshOutcome&) { refuse("Repair"); }
bool isSound(const TriangleMesh&) { refuse("Repair"); }
std::vector<Warning> warningsOfMeeting(const std::vector<io::Part>&) { refuse("Repair"); }

SharedGuides sharedGuides(const std::vector<io::Part>&, const PartOptions&) { return {}; }

std::vector<Warning> bordersOffGiven(const std::vector<io::Part>&, const std::vector<io::Part>&) {
  return {};
}

void keepLimits(Run&, const PartOptions&, Number) {}
Unmet unmetLimits(const Run&, const PartOptions&) { return {}; }
SizeBounds sizeBounds(const PartOptions&) { return {}; }
double numberByEdges(const PartOptions&, double, double own) { return own; }
void checkWanted(const RemeshOptions&) {}
std::optional<WantedReport> wantedOf(const std::vector<io::Part>&, const RemeshOptions&) {
  return {};
}
std::vector<Warning> wantedMissed(const MeshReport&, const std::vector<io::Part>&,
                                  const RemeshOptions&, const Unmet&) {
  return {};
}

bool leadsByAngle(const PartOptions&) { return false; }
bool limitsAngle(const PartOptions&) { return false; }
RemeshOutcome remeshAtAngle(const TriangleMesh&, Welding, const PartOptions&, const Progress&) {
  refuse("A smallest angle");
}
RemeshOutcome remeshToAngle(const TriangleMesh&, Welding, const PartOptions&, const Progress&) {
  refuse("A smallest angle");
}

TouchingParts::TouchingParts(const std::vector<io::Part>& given, const PartOptions& options)
    : given_(given) {
  if (options.conform) refuse("Common faces");
}
PartOptions TouchingParts::applied(PartOptions options) const { return options; }
void TouchingParts::finish(std::vector<SceneRun>&) const {}

RegionRun::RegionRun(std::vector<io::Part>&, const PartOptions& options) {
  if (!options.region.empty()) refuse("A region");
}
PartOptions RegionRun::applied(PartOptions options) const { return options; }
void RegionRun::finish(std::vector<SceneRun>&) const {}

std::unique_ptr<const ThinnedParts> thinnedParts(std::vector<io::Part>&, const PartOptions&,
                                                 const ScanSlabs&) {
  return nullptr;
}
PartOptions ThinnedParts::applied(PartOptions options) const { return options; }
void ThinnedParts::note(std::vector<SceneRun>&) const {}

std::vector<Warning> pairedParts(const QuadReport&, const std::vector<io::Part>&) { return {}; }
std::vector<Warning> lostToQuads(const std::vector<io::Part>&, const std::vector<io::Part>&) {
  return {};
}
std::vector<Warning> turnedFromGiven(const std::vector<io::Part>&, const std::vector<io::Part>&) {
  return {};
}

MadeQuads makeQuads(const QuadGoal&, const TriangleMaker&) { refuse("The making of quads"); }

std::size_t wholeCount(const QuadMesh&, const Mirrors&) { return 0; }

RemeshOutcome remeshAsQuads(const TriangleMesh&, const Welding&, const PartOptions&,
                            const PlainRemesher&, const Progress&) {
  refuse("The making of quads");
}

std::optional<std::vector<Vec3>> inWholeSteps(const TriangleMesh&, const WholeSteps&) { return {}; }

}  // namespace remesher
