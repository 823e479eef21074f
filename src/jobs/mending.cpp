// SPDX-License-Identifier: MIT
#include "jobs/mending.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/place.h"
#include "jobs/angle_number.h"
#include "jobs/checks/precision.h"
#include "jobs/checks/repair_room.h"
#include "jobs/checks/result_check.h"
#include "jobs/face_budget.h"
#include "jobs/inspected_parts.h"
#include "jobs/part_run.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/chooser.h"

namespace remesher {

namespace {

bool leavesOut(const PartOptions& options) {
  return options.dropBelow || options.dropFloaters || options.dropHidden;
}

// Takes out the parts without triangles; says which. Other parts' numbers in `finer` follow.
std::vector<char> withoutEmpty(std::vector<io::Part>& parts) {
  std::vector<char> isEmpty;
  std::vector<std::size_t> numbers;
  std::size_t left = 0;
  for (const io::Part& part : parts) {
    isEmpty.push_back(char(part.mesh.indices.empty()));
    numbers.push_back(left);
    left += std::size_t(!isEmpty.back());
  }
  for (io::Part& part : parts) {
    std::erase_if(part.finer, [&](std::size_t p) { return isEmpty[p] != 0; });
    for (std::size_t& p : part.finer) p = numbers[p];
  }
  std::erase_if(parts, [](const io::Part& part) { return part.mesh.indices.empty(); });
  return isEmpty;
}

// Whether the number of vertices depends on the input's number.
bool isByInput(const PartOptions& options) {
  return !options.vertices && !options.faces && !options.edgeLength && !leadsByEdges(options) &&
         (options.ratio || !options.maxError);
}

// Rounds to single precision what will be written so, so that rounding cannot undo the repair.
void roundToSingle(std::vector<io::Part>& parts) {
  for (io::Part& part : parts)
    for (Vec3& p : part.mesh.positions)
      if (part.mesh.isSingle) p = inSingle(p, part.mesh.frame);
}

// The triangles of each part that intersect others of the same part.
std::size_t crossingsWithin(const std::vector<io::Part>& parts) {
  std::size_t count = 0;
  for (const io::Part& part : parts) count += selfIntersections(part.mesh).size();
  return count;
}

// Counts the self-intersections of the result anew, for the report and its warning.
void recountCrossings(Report& report, const std::vector<io::Part>& result) {
  const std::size_t count = crossingsWithin(result);
  report.repair->selfIntersections[1] = count;
  std::erase_if(report.warnings, [&](const Warning& warning) {
    return count == 0 && warning.code == "CROSSINGS_LEFT";
  });
  for (Warning& warning : report.warnings)
    if (warning.code == "CROSSINGS_LEFT") warning.count = count;
}

// Renews PARTS_MEET for the result. Intersections that remeshing made have a warning of their own.
void recountMeeting(Report& report, const std::vector<io::Part>& result) {
  const auto ofMeeting = [](const Warning& warning) { return warning.code == "PARTS_MEET"; };
  const auto said = std::find_if(report.warnings.begin(), report.warnings.end(), ofMeeting);
  if (said == report.warnings.end()) return;
  const std::vector<Warning> now = warningsOfMeeting(result);
  if (now.empty())
    report.warnings.erase(said);
  else
    *said = now.front();
}

// Angles are no concern of a repair.
std::vector<Warning> damageIn(const Report& report, const std::vector<io::Part>& result) {
  const BeforeAndAfter figures{report.input, *report.output};
  std::vector<Warning> warnings =
      mergedByCode(worseThanGiven(figures, result), lostToRounding(report, result));
  if (report.repair) warnings = mergedByCode(std::move(warnings), touchesLeft(figures, result));
  std::erase_if(warnings, [](const Warning& warning) { return warning.code == "ANGLES_WORSE"; });
  return warnings;
}

// Whether the vertices that share a place after joining and rounding were equal, bit for bit, as
// given.
bool joinsOnlyEqual(const TriangleMesh& given, const TriangleMesh& joined) {
  const std::vector<Index> first = weld(joined.positions);
  if (given.positions.size() != first.size()) return false;
  for (Index v = 0; v < first.size(); ++v)
    if (given.positions[v] != given.positions[first[v]]) return false;
  return true;
}

// If the surface is sound only because vertices were joined, the reason is "joined", not "sound".
void sayJoined(Report& report, const std::vector<io::Part>& given,
               const std::vector<io::Part>& originals) {
  if (!report.repair || report.repair->reason != "sound") return;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!joinsOnlyEqual(given[i].mesh, originals[i].mesh)) report.repair->reason = "joined";
  if (report.repair->reason == "joined")
    report.warnings = mergedByCode(std::move(report.warnings), placesRounded(given));
}

bool areSame(const std::vector<io::Part>& some, const std::vector<io::Part>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const io::Part& one, const io::Part& other) {
                      return one.mesh.isQuads == other.mesh.isQuads &&
                             haveSameContent(one.mesh, other.mesh);
                    });
}

}  // namespace

double mendShare(const PartOptions& options) {
  return options.repair == Repair::Off && !leavesOut(options) ? 0 : 0.1;
}

Mending::Mending(std::vector<io::Part>& parts, const PartOptions& options, const Progress& progress,
                 Purpose purpose)
    : isGone_(parts.size(), 0) {
  for (const io::Part& part : parts) sources_.push_back(part.source);
  if (options.repair == Repair::Off && !leavesOut(options)) return;
  // Options that leave parts out may leave out most of the model: repair() looks again.
  if (!leavesOut(options)) requireRoomToRepair(parts);
  input_ = inspectScaled(parts);
  if (leavesOut(options)) dropped_.emplace();
  // Only here: remeshing rounds at the end, so that all formats get the same mesh.
  if (purpose == Purpose::Itself) roundToSingle(parts);
  withinMemory([&] {
    dropPieces(parts, options);
    repair(parts, options, progress, purpose);
    dropHidden(parts, options);
  });
}

void Mending::dropPieces(std::vector<io::Part>& parts, const PartOptions& options) {
  if (!options.dropBelow && !options.dropFloaters) return;
  take(dropSmallPieces(parts, options));
  isGone_ = withoutEmpty(parts);
}

void Mending::repair(std::vector<io::Part>& parts, const PartOptions& options,
                     const Progress& progress, Purpose purpose) {
  if (options.repair == Repair::Off) return;
  requireRoomToRepair(parts);
  PartOptions sized = options;
  if (options.faces) sized.vertices = verticesFor(*options.faces, options, {});
  const bool isSized = purpose == Purpose::Remeshing && isByInput(options);
  const MeshReport given = dropped_ ? inspectScaled(parts) : input_;
  const double target = options.ratio.value_or(1) * double(given.vertices);
  if (isSized) sized.vertices = Index(std::max(1.0, std::round(target)));
  repair_ = repairParts(std::move(parts), sized, progress.phase("repair", 0, 1));
  parts = std::move(repair_->parts);
  if (!isSized) return;
  const std::size_t mended = inspectScaled(parts).vertices;
  // With a smallest angle, and triangles that no lattice replaced, the number is searched for
  // later.
  const bool isFound = leadsByAngle(options) && !isRemade();
  if (mended > 0 && (options.ratio || (mended != given.vertices && !isFound)))
    ratio_ = target / double(mended);
}

void Mending::dropHidden(std::vector<io::Part>& parts, const PartOptions& options) {
  if (!options.dropHidden) return;
  take(dropHiddenTriangles(parts, repair_ ? Hidden::Pieces : Hidden::Triangles));
  const std::vector<char> isEmpty = withoutEmpty(parts);
  std::size_t p = 0;
  for (char& isGone : isGone_)
    if (!isGone) isGone = isEmpty[p++];
}

std::vector<int> Mending::leftOut() const {
  std::vector<int> numbers;
  for (std::size_t p = 0; p < isGone_.size(); ++p)
    if (isGone_[p] && sources_[p] >= 0) numbers.push_back(sources_[p]);
  return numbers;
}

void Mending::take(Dropped dropped) {
  DropReport& sum = dropped_->report;
  sum.pieces += dropped.report.pieces;
  sum.hidden += dropped.report.hidden;
  sum.lost += dropped.report.lost;
  if (!dropped.report.piecesAt.empty()) sum.piecesAt = std::move(dropped.report.piecesAt);
  if (!dropped.report.hiddenAt.empty()) sum.hiddenAt = std::move(dropped.report.hiddenAt);
  dropped_->warnings = mergedByCode(std::move(dropped_->warnings), dropped.warnings);
}

PartOptions Mending::chosen(PartOptions options) const {
  if (repair_ && (options.repair == Repair::Auto || options.repair == Repair::Solid))
    options.repair = repair_->isRemade ? Repair::Solid : Repair::Holes;
  if (ratio_) {
    if (!options.ratio) options.tooFew = TooFew::Raise;
    options.ratio = ratio_;
  }
  return options;
}

void Mending::note(Report& report) const {
  if (!repair_ && !dropped_) return;
  report.input = input_;
  if (repair_) {
    report.repair = repair_->report;
    report.warnings = mergedByCode(repair_->warnings, report.warnings);
  }
  if (!dropped_) return;
  report.dropped = dropped_->report;
  report.warnings = mergedByCode(dropped_->warnings, report.warnings);
  if (report.repair) report.repair->lost += dropped_->report.lost;
}

void Mending::note(SceneRun& run, Held held) const {
  note(run.report);
  if (!repair_) return;
  recountCrossings(run.report, asHeld(run.parts, held));
  recountMeeting(run.report, run.parts);
}

PartOptions chooseBaking(PartOptions options, io::Model& model) {
  if (options.textures != Textures::Auto || model.conventions != io::Conventions::Gltf)
    return options;
  options.textures = Textures::Bake;
  model.warnings.push_back(
      {"TEXTURES_PAINTED", "Repair has made another surface, so its textures were baked onto it."});
  return options;
}

std::vector<io::Part> Mending::kept(std::vector<io::Part> given) const {
  std::vector<io::Part> left;
  for (std::size_t p = 0; p < given.size(); ++p)
    if (!isGone_[p]) left.push_back(std::move(given[p]));
  return left;
}

RepairedParts repairOnly(std::vector<io::Part>& parts, Held held, IfSound ifSound,
                         const PartOptions& options, const Progress& progress) {
  const std::vector<io::Part> given = parts;
  parts = joinedPlaces(std::move(parts), options);
  const std::vector<io::Part> originals = parts;
  const Mending mending(parts, options, progress, Mending::Purpose::Itself);
  const std::vector<io::Part> left = mending.kept(originals), asGiven = mending.kept(given);
  std::vector<io::Part> rounded = left;  // what repair started from
  roundToSingle(rounded);
  bool isRounded =
      false;  // whether the vertices differ from those that repair counted crossings on
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& own = asGiven[i].mesh;
    if (ifSound == IfSound::FileStays && haveSameContent(parts[i].mesh, rounded[i].mesh) &&
        joinsOnlyEqual(own, rounded[i].mesh)) {
      isRounded = isRounded || !haveSameContent(own, rounded[i].mesh);
      parts[i].mesh = own;
      continue;
    }
    const std::vector<Vec3> exact = parts[i].mesh.positions;
    parts[i].mesh = inPrecisionOf(left[i].mesh, std::move(parts[i].mesh)).mesh;
    isRounded = isRounded || parts[i].mesh.positions != exact;
  }
  progress.phase("measure", 1, 1);
  Report report;
  const std::vector<io::Part> shown = asHeld(parts, held);
  mending.note(report);
  report.output = areSame(shown, originals) ? report.input : inspectScaled(shown);
  sayJoined(report, given, originals);
  if (report.repair && (isRounded || shown.size() < parts.size())) recountCrossings(report, shown);
  report.warnings = mergedByCode(std::move(report.warnings), damageIn(report, shown));
  for (const io::Part& part : parts)
    if (parts.size() > 1 && !isSurface(part.mesh))
      report.warnings =
          mergedByCode(std::move(report.warnings), {passedOn(part, "No triangle has an area.")});
  // False as soon as a part was removed or lost pieces.
  bool isUnchanged = parts.size() == given.size();
  std::size_t quadsCut = 0;
  for (std::size_t i = 0, p = 0; i < given.size(); ++i) {
    if (mending.isGone()[i]) continue;
    const TriangleMesh& before = given[i].mesh;
    const TriangleMesh& after = parts[p++].mesh;
    if (before.isQuads && !after.isQuads) quadsCut += before.triangleCount() / 2;
    const bool isSame = haveSameContent(after, before);
    report.chosen.push_back(inReport(choose(
        Decision::RepairOnly, [&](Fact fact) { return fact == Fact::Unchanged && isSame; })));
    isUnchanged = isUnchanged && isSame;
  }
  return {std::move(report), mending.isRemade(), isUnchanged, mending.leftOut(), quadsCut};
}

}  // namespace remesher
