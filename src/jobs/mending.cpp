// SPDX-License-Identifier: MIT
#include "jobs/mending.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/model/same_mesh.h"
#include "jobs/checks/precision.h"
#include "jobs/face_budget.h"
#include "jobs/inspected_parts.h"
#include "jobs/part_run.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "remesh/schemes/chooser.h"

namespace remesher {

double mendShare(const RemeshOptions& options) { return options.repair == Repair::Off ? 0 : 0.1; }

namespace {

// Whether the number of vertices depends on the input's number.
bool isByInput(const RemeshOptions& options) {
  return !options.vertices && !options.faces && !options.edgeLength &&
         (options.ratio || !options.maxError);
}

}  // namespace

Mending::Mending(std::vector<io::Part>& parts, const RemeshOptions& options,
                 const Progress& progress, Purpose purpose) {
  if (options.repair == Repair::Off) return;
  input_ = inspectScaled(parts);
  RemeshOptions sized = options;
  if (options.faces) sized.vertices = verticesFor(*options.faces, options, {});
  const bool isSized = purpose == Purpose::Remeshing && isByInput(options);
  const double target = options.ratio.value_or(1) * double(input_.vertices);
  if (isSized) sized.vertices = Index(std::max(1.0, std::round(target)));
  repair_ = withinMemory(
      [&] { return repairParts(std::move(parts), sized, progress.phase("repair", 0, 1)); });
  parts = std::move(repair_->parts);
  const double mended = isSized ? double(inspectScaled(parts).vertices) : 0;
  if (mended > 0) ratio_ = target / mended;
}

RemeshOptions Mending::chosen(RemeshOptions options) const {
  if (repair_ && (options.repair == Repair::Auto || options.repair == Repair::Solid))
    options.repair = repair_->isRemade ? Repair::Solid : Repair::Holes;
  if (ratio_) {
    if (!options.ratio) options.tooFew = TooFew::Raise;
    options.ratio = ratio_;
  }
  return options;
}

RemeshOptions Mending::withPaint(RemeshOptions options, io::Model& model) const {
  const bool isImplied = repair_ && repair_->isRemade && options.textures == Textures::Auto &&
                         model.conventions == io::Conventions::Gltf;
  if (!isImplied) return options;
  options.textures = Textures::Bake;
  model.warnings.push_back(
      {"TEXTURES_PAINTED", "Repair has made another surface, so its textures were baked onto it."});
  return options;
}

void Mending::note(Report& report) const {
  if (!repair_) return;
  report.input = input_;
  report.repair = repair_->report;
  report.warnings = joined(repair_->warnings, report.warnings);
}

RepairedParts repairOnly(std::vector<io::Part>& parts, const RemeshOptions& options,
                         const Progress& progress) {
  const std::vector<io::Part> given = parts;
  parts = joinedPlaces(std::move(parts), options.weld);
  const std::vector<io::Part> originals = parts;
  const Mending mending(parts, options, progress, Mending::Purpose::Itself);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i].mesh = inPrecisionOf(originals[i].mesh, std::move(parts[i].mesh)).mesh;
  progress.phase("measure", 1, 1);
  Report report;
  report.output = inspectScaled(parts);
  mending.note(report);
  for (const io::Part& part : parts)
    if (parts.size() > 1 && !isSurface(part.mesh))
      report.warnings =
          joined(std::move(report.warnings), {passedOn(part, "No triangle has an area.")});
  bool isUnchanged = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool isSame = io::isSame(parts[i].mesh, given[i].mesh);
    report.chosen.push_back(inReport(choose(
        Decision::RepairOnly, [&](Fact fact) { return fact == Fact::Unchanged && isSame; })));
    isUnchanged = isUnchanged && isSame;
  }
  return {std::move(report), isUnchanged};
}

}  // namespace remesher
