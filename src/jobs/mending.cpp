// SPDX-License-Identifier: MIT
#include "jobs/mending.h"

#include <utility>

#include "jobs/part_report.h"
#include "jobs/part_run.h"
#include "jobs/precision.h"
#include "jobs/run_guards.h"

namespace remesher {

double mendShare(const RemeshOptions& options) { return options.repair == Repair::Off ? 0 : 0.1; }

Mending::Mending(std::vector<io::Part>& parts, const RemeshOptions& options,
                 const Progress& progress) {
  if (options.repair == Repair::Off) return;
  input_ = inspectScaled(parts);
  repair_ = withinMemory(
      [&] { return repairParts(std::move(parts), options, progress.phase("repair", 0, 1)); });
  parts = std::move(repair_->parts);
}

RemeshOptions Mending::chosen(RemeshOptions options) const {
  if (options.repair == Repair::Auto && repair_)
    options.repair = repair_->report.mode == "holes" ? Repair::Holes : Repair::Solid;
  return options;
}

RemeshOptions Mending::withPaint(RemeshOptions options, io::Model& model) const {
  const bool isImplied = repair_ && repair_->report.mode != "holes" && options.lods.empty() &&
                         options.textures == Textures::Auto &&
                         model.conventions == io::Conventions::Gltf;
  if (!isImplied) return options;
  options.textures = Textures::Bake;
  model.warnings.push_back(
      {"TEXTURES_PAINTED", "Repair has made another surface, so its textures were painted anew."});
  return options;
}

void Mending::note(Report& report) const {
  if (!repair_) return;
  report.input = input_;
  report.repair = repair_->report;
  report.warnings = joined(repair_->warnings, report.warnings);
}

Report repairOnly(std::vector<io::Part>& parts, const RemeshOptions& options,
                  const Progress& progress) {
  const std::vector<io::Part> originals = parts;
  const Mending mending(parts, options, progress);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i].mesh = inPrecisionOf(originals[i].mesh, std::move(parts[i].mesh)).mesh;
  progress.phase("measure", 1, 1);
  Report report;
  report.output = inspectScaled(parts);
  mending.note(report);
  return report;
}

}  // namespace remesher
