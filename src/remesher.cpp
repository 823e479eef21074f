// SPDX-License-Identifier: MIT
#include "remesher.h"

#include <utility>

#include "io/formats.h"
#include "io/model/levels.h"
#include "io/model/same_mesh.h"
#include "jobs/baking.h"
#include "jobs/checks/option_checks.h"
#include "jobs/inspected_model.h"
#include "jobs/inspected_parts.h"
#include "jobs/level_files.h"
#include "jobs/mending.h"
#include "jobs/parts/bare_materials.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_report.h"
#include "jobs/prepared_parts.h"
#include "jobs/region_run.h"
#include "jobs/run_guards.h"
#include "jobs/scene_run.h"

namespace remesher {
namespace {

// Reads the model and prepares its coordinates for the output format.
io::Model readFor(const std::string& outputName, const FileBundle& input,
                  const RemeshOptions& options) {
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  if (options.textures == Textures::Drop) dropTextures(model);
  if (model.parts.empty())
    model.warnings.push_back(
        {"NOTHING_TO_REMESH", "There are no triangles: the file is passed on as it came."});
  return model;
}

void requireUnpainted(const RemeshOptions& options) {
  if (options.textures != Textures::Bake) return;
  throw Error(ErrorCode::InvalidOption, "Textures can be baked only for files, not for arrays.",
              "Give the file, with its images, to remeshFile or repairFile.");
}

// The result of one slab: its thinned-out triangles, not remeshed.
SceneRun slabRun(std::vector<io::Part>& parts) {
  SceneRun run;
  run.parts = std::move(parts);
  run.report.input = PlainInspection(run.parts).report;
  run.report.output = run.report.input;
  run.report.fidelity.emplace();
  return run;
}

// The meshes that are left, and an empty one for each that is gone.
std::vector<TriangleMesh> withEmpty(std::vector<TriangleMesh>& left,
                                    const std::vector<char>& isGone) {
  std::vector<TriangleMesh> meshes;
  std::size_t next = 0;
  for (const char gone : isGone) meshes.push_back(gone ? TriangleMesh{} : std::move(left[next++]));
  return meshes;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  RemeshSceneResult run = remeshScene({{mesh, {}}}, options, progress);
  RemeshResult result{std::move(run.meshes.front()), std::move(run.report), {}};
  for (std::vector<TriangleMesh>& lod : run.lods) result.lods.push_back(std::move(lod.front()));
  return result;
}

RemeshSceneResult remeshScene(std::vector<PlacedMesh> scene, const RemeshOptions& asked,
                              const Progress& progress) {
  requireUnpainted(asked);
  checkTogether(asked);
  PhaseClock clock;
  std::vector<io::Part> parts;
  for (PlacedMesh& placed : scene) {
    parts.push_back({"", std::move(placed.mesh), std::move(placed.places)});
    parts.back().finer = std::move(placed.finer);
    if (asked.textures == Textures::Drop) dropTexcoords(parts.back().mesh);
  }
  PartOptions inPercent = withPercents(asked, parts);
  limitEdges(inPercent);
  const RegionRun region(parts, inPercent);
  const PartOptions options = region.applied(inPercent);
  const std::vector<Warning> settled = settleAttributes(parts);
  const Progress stretch = progress.timedBy(clock);
  const double mended = mendShare(options);
  const PreparedParts prepared({parts}, options, stretch.part(0, mended));
  std::vector<SceneRun> runs = region.within([&] {
    return remeshLevels(prepared.parts(), Held::Apart, prepared.options(), stretch.part(mended, 1));
  });
  prepared.finish(runs, Held::Apart);
  region.finish(runs);
  runs.front().report.warnings = mergedByCode(settled, runs.front().report.warnings);
  std::vector<std::vector<TriangleMesh>> levels;
  for (SceneRun& run : runs) {
    levels.emplace_back();
    for (io::Part& part : run.parts) levels.back().push_back(std::move(part.mesh));
  }
  for (std::vector<TriangleMesh>& level : levels)
    level = withEmpty(level, prepared.mending().isGone());
  RemeshSceneResult result{
      std::move(levels.front()), timed(std::move(runs.front().report), clock), {}};
  result.lods.assign(levels.begin() + 1, levels.end());
  return result;
}

RepairResult repair(const TriangleMesh& mesh, const RemeshOptions& asked,
                    const Progress& progress) {
  PhaseClock clock;
  requireUnpainted(asked);
  std::vector<io::Part> parts = {io::Part{"", mesh, {}}};
  const PartOptions options = withPercents(asked, parts);
  if (options.textures == Textures::Drop) dropTexcoords(parts.front().mesh);
  const std::vector<Warning> settled = settleAttributes(parts);
  RepairedParts repaired =
      repairOnly(parts, Held::Apart, IfSound::IsRounded, options, progress.timedBy(clock));
  repaired.report.warnings = mergedByCode(settled, repaired.report.warnings);
  return {std::move(parts.front().mesh), timed(std::move(repaired.report), clock)};
}

RemeshFileResult remeshFile(FileBundle input, const std::string& outputName,
                            const RemeshOptions& asked, const Progress& progress) {
  io::requireWritable(outputName);
  checkTogether(asked);
  if (asked.textures == Textures::Bake) requireTextured(outputName);
  requireRoomForLevels(outputName, asked);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = readFor(outputName, input, asked);
  input.file = {input.file.name, {}};
  input.resources = {};
  PartOptions inPercent = withPercents(asked, model.parts);
  limitEdges(inPercent);
  const RegionRun region(model.parts, inPercent);
  const PartOptions options = region.applied(inPercent);
  model.isExact = options.repair != Repair::Off;
  if (options.unite)
    io::uniteAll(model, outputName);
  else if (model.isExact)
    io::unite(model, outputName);
  if (!options.lods.empty()) io::replaceLevels(model);
  std::vector<SceneRun> runs = inFile(input.file.name, [&]() -> std::vector<SceneRun> {
    whole.phase("inspect", kReadShare, kReadShare);
    const Progress stretch = whole.part(kReadShare, 1);
    const double mended = mendShare(options);
    const bool isPainted = !input.pictures.empty();
    const PreparedParts prepared(
        {model.parts, input.slabs, isPainted && options.repair != Repair::Off}, options,
        stretch.part(0, mended));
    const Mending& mending = prepared.mending();
    model.leftOut = mending.leftOut();
    model.sharesNodes = options.conform;
    PartOptions chosen = prepared.options();
    if (mending.isRemade() && isPainted && io::canHold(outputName, io::kHoldsImages))
      chosen = chooseBaking(std::move(chosen), model);
    const Progress body = stretch.part(mended, 1);
    std::vector<SceneRun> all;
    if (input.slabs.only > 0)
      all.push_back(slabRun(model.parts));
    else if (chosen.textures == Textures::Bake)
      all = remeshBaked(model, {prepared.given(), std::move(input.pictures)}, chosen, body);
    else
      all = region.within(
          [&] { return remeshLevels(prepared.parts(), heldIn(outputName), chosen, body); });
    prepared.finish(all, heldIn(outputName));
    region.finish(all);
    return all;
  });
  whole.phase("write", 1, 1);
  io::WrittenFiles written =
      inFile(input.file.name, [&] { return writeLevels(model, runs, outputName, options); });
  Report report = std::move(runs.front().report);
  report.warnings = mergedByCode(mergedByCode(model.warnings, report.warnings), written.warnings);
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(report), clock)};
}

ConvertFileResult convertFile(const FileBundle& input, const std::string& outputName) {
  io::requireWritable(outputName);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  io::WrittenFiles written = io::write(model, outputName);
  if (written.isUntouched) model.warnings = io::saidOfWhole(std::move(model.warnings));
  const std::vector<Warning> lost = mergedByCode(written.warnings, io::polygonsCut(model, written));
  return {std::move(written.files), mergedByCode(model.warnings, lost)};
}

Report inspect(const TriangleMesh& mesh) { return inspectedMesh(mesh).report; }

Report inspectFile(const FileBundle& input, const Progress& progress) {
  return inspectedFile(input.file, input.resources, Inspection::Brief, progress).report;
}

}  // namespace remesher
