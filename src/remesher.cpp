// SPDX-License-Identifier: MIT
#include "remesher.h"

#include <utility>

#include "io/formats.h"
#include "io/model/levels.h"
#include "jobs/baking.h"
#include "jobs/checks/option_checks.h"
#include "jobs/inspected_parts.h"
#include "jobs/level_files.h"
#include "jobs/mending.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "jobs/scene_run.h"

namespace remesher {
namespace {

// Reads the model and prepares its coordinates for the output format.
io::Model readFor(const std::string& outputName, const FileBundle& input) {
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  if (model.parts.empty())
    model.warnings.push_back(
        {"NOTHING_TO_REMESH", "There are no triangles: the file is passed on as it came."});
  return model;
}

std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images) {
  std::vector<Picture> pictures;
  for (io::PaintedImage& image : images)
    pictures.push_back({std::move(image.name), std::move(image.type), image.image.width,
                        image.image.height, std::move(image.image.texels)});
  return pictures;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  RemeshSceneResult run = remeshScene({{mesh, {}}}, options, progress);
  RemeshResult result{std::move(run.meshes.front()), std::move(run.report), {}};
  for (std::vector<TriangleMesh>& lod : run.lods) result.lods.push_back(std::move(lod.front()));
  return result;
}

RemeshSceneResult remeshScene(std::vector<PlacedMesh> scene, const RemeshOptions& options,
                              const Progress& progress) {
  if (options.textures == Textures::Bake)
    throw Error(ErrorCode::InvalidOption, "textures can be baked of files only.",
                "Give the file, with its images, to remeshFile.");
  checkTogether(options);
  PhaseClock clock;
  std::vector<io::Part> parts;
  for (PlacedMesh& placed : scene) {
    parts.push_back({"", std::move(placed.mesh), std::move(placed.places)});
    parts.back().finer = std::move(placed.finer);
  }
  parts = joinedPlaces(std::move(parts), options.weld);
  const std::vector<Warning> settled = settleAttributes(parts);
  const Progress whole = progress.timedBy(clock);
  const double mended = mendShare(options);
  const Mending mending(parts, options, whole.part(0, mended));
  std::vector<SceneRun> runs = remeshLevels(parts, mending.chosen(options), whole.part(mended, 1));
  mending.note(runs.front().report);
  runs.front().report.warnings = joined(settled, runs.front().report.warnings);
  std::vector<std::vector<TriangleMesh>> levels;
  for (SceneRun& run : runs) {
    levels.emplace_back();
    for (io::Part& part : run.parts) levels.back().push_back(std::move(part.mesh));
  }
  RemeshSceneResult result{
      std::move(levels.front()), timed(std::move(runs.front().report), clock), {}};
  result.lods.assign(levels.begin() + 1, levels.end());
  return result;
}

RepairResult repair(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  PhaseClock clock;
  std::vector<io::Part> parts = {io::Part{"", mesh, {}}};
  const std::vector<Warning> settled = settleAttributes(parts);
  RepairedParts repaired = repairOnly(parts, options, progress.timedBy(clock));
  repaired.report.warnings = joined(settled, repaired.report.warnings);
  return {std::move(parts.front().mesh), timed(std::move(repaired.report), clock)};
}

RemeshFileResult remeshFile(FileBundle input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  checkTogether(options);
  if (options.textures == Textures::Bake) requireTextured(outputName);
  requireRoomForLevels(outputName, options);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = readFor(outputName, input);
  model.isExact = options.repair != Repair::Off;
  if (model.isExact) io::unite(model, outputName);
  if (!options.lods.empty()) io::replaceLevels(model);
  std::vector<SceneRun> runs = inFile(input.file.name, [&]() -> std::vector<SceneRun> {
    model.parts = joinedPlaces(std::move(model.parts), options.weld);
    std::vector<io::Part> given;
    if (options.repair != Repair::Off && !input.pictures.empty()) given = model.parts;
    const double mended = kReadShare + (1 - kReadShare) * mendShare(options);
    const Mending mending(model.parts, options, whole.part(kReadShare, mended));
    const Progress body = whole.part(mended, 1);
    std::vector<SceneRun> all;
    RemeshOptions chosen = mending.chosen(options);
    if (!input.pictures.empty() && io::canHold(outputName, io::kHoldsImages))
      chosen = mending.withPaint(std::move(chosen), model);
    if (chosen.textures == Textures::Bake)
      all = remeshBaked(model, {std::move(given), std::move(input.pictures)}, chosen, body);
    else
      all = remeshLevels(model.parts, chosen, body);
    mending.note(all.front().report);
    return all;
  });
  whole.phase("write", 1, 1);
  io::WrittenFiles written =
      inFile(input.file.name, [&] { return writeLevels(model, runs, outputName, options); });
  Report report = std::move(runs.front().report);
  report.warnings = joined(joined(model.warnings, report.warnings), written.warnings);
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(report), clock)};
}

ConvertFileResult convertFile(const FileBundle& input, const std::string& outputName) {
  io::requireWritable(outputName);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  io::WrittenFiles written = io::write(model, outputName);
  return {std::move(written.files), joined(model.warnings, written.warnings)};
}

Report inspect(const TriangleMesh& mesh) {
  PhaseClock clock;
  clock.enter("inspect");
  Report report;
  std::vector<io::Part> parts = joinedPlaces({io::Part{"", mesh, {}}}, {});
  const std::vector<Warning> settled = settleAttributes(parts);
  report.input = inspectScaled(parts);
  report.warnings = joined(settled, looseTriangles(report.input, parts));
  return timed(std::move(report), clock);
}

Report inspectFile(const FileBundle& input) {
  PhaseClock clock;
  clock.enter("read");
  io::Model model = io::read(input.file, input.resources);
  clock.enter("inspect");
  Report report;
  report.input = inFile(input.file.name, [&] {
    model.parts = joinedPlaces(std::move(model.parts), {});
    return inspectScaled(model.parts);
  });
  report.warnings = joined(model.warnings, looseTriangles(report.input, model.parts));
  return timed(std::move(report), clock);
}

}  // namespace remesher
