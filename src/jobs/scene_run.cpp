// SPDX-License-Identifier: MIT
#include "jobs/scene_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "jobs/checks/result_check.h"
#include "jobs/fewest_vertices.h"
#include "jobs/inspected_parts.h"
#include "jobs/part_run.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/parts/part_targets.h"
#include "jobs/parts/part_unions.h"
#include "jobs/run_guards.h"

namespace remesher {

namespace {

// The approximate share of a run's time.
constexpr double kMeasureShare = 0.15;

// Nothing is remeshed yet.
SceneRun begun(const InspectedParts& originals) {
  SceneRun run;
  for (const io::Part& part : originals.parts()) run.parts.push_back(withoutMesh(part));
  run.places.resize(run.parts.size());
  run.report.prefer.assign(run.parts.size(), Prefer::Even);
  run.report.input = originals.report();
  run.report.warnings = looseTriangles(run.report.input, originals.parts());
  return run;
}

void take(SceneRun& run, std::size_t part, RemeshOutcome& outcome, RoundedMesh rounded) {
  if (const std::size_t count = std::max(rounded.coincident, outcome.coincident); count > 0)
    outcome.warnings.push_back({"VERTICES_COINCIDE",
                                "Vertices of the result lie where others do: parts of the surface "
                                "are nearer to each other than its coordinates can tell apart.",
                                count});
  run.parts[part].mesh = std::move(rounded.mesh);
  run.places[part] = std::move(outcome.places);
  run.report.warnings = joined(std::move(run.report.warnings), outcome.warnings);
  if (outcome.stopped != Stopped::Target) run.report.stopped = outcome.stopped;
  run.report.prefer[part] = outcome.prefer;
  run.mirrors += outcome.mirrors;
}

// Remeshes each part, and parts with coincident borders as one. Returns the last part's tree.
std::optional<ListedTree> remeshSurfaces(SceneRun& run, const InspectedParts& originals,
                                         const RemeshOptions& options, const Progress& progress) {
  const PartUnions unions(originals.parts(), options);
  const std::vector<io::Part>& surfaces = unions.surfaces();
  const std::vector<PartPlace> places = placesOf(surfaces);
  PartTargets targets(surfaces, places, options);
  double total = 0;
  for (const io::Part& part : surfaces)
    total += double(part.mesh.triangleCount()) / (1 - kMeasureShare);
  double done = 0;
  std::optional<ListedTree> tree;
  for (const std::size_t i : targets.order()) {
    const std::vector<std::size_t>& members = unions.membersOf(i);
    const TriangleMesh& mesh = surfaces[i].mesh;
    const double share = double(mesh.triangleCount()) / total;
    Welding welding = members.size() > 1 ? Welding(mesh) : originals.weldings()[members.front()];
    RemeshOutcome outcome = remeshAsShown({mesh, std::move(welding), places[i]},
                                          {targets, unions, i}, progress.part(done, done + share));
    targets.given(i, outcome.vertices);
    tree = std::move(outcome.tree);
    std::vector<RemeshOutcome> parted = unions.parted(i, std::move(outcome));
    for (std::size_t k = 0; k < parted.size(); ++k)
      take(run, members[k], parted[k],
           roundedOutcome(originals.parts()[members[k]].mesh, parted[k], options.repair));
    done += share;
  }
  return tree;
}

void measure(SceneRun& run, const InspectedParts& originals, const RemeshOptions& options,
             std::optional<ListedTree> tree) {
  run.report.output = inspectParts(run.parts, weldingsOf(run.parts), placesOf(run.parts));
  if (run.report.output->quads) run.report.output->quads->symmetry = run.mirrors;
  if (run.parts.empty()) return;
  // Only the two-sided distance shows whether a bound is kept.
  const bool isGlimpsed = options.quality == Quality::Draft && !options.maxError;
  run.report.fidelity =
      fidelityOf({originals.parts(), run.parts, originals.places()},
                 isGlimpsed ? Maximum::Glimpsed : Maximum::Sampled, std::move(tree));
}

SceneRun remeshInspected(const InspectedParts& originals, const RemeshOptions& wanted,
                         const Progress& progress) {
  const RemeshOptions options = originals.scaled(wanted);
  SceneRun run = begun(originals);
  std::optional<ListedTree> tree = remeshSurfaces(run, originals, options, progress);
  progress.phase("measure", 1 - kMeasureShare, 1);
  measure(run, originals, options, std::move(tree));
  run.parts = originals.unscaled(std::move(run.parts));
  run.report.warnings =
      joined(std::move(run.report.warnings), resultWarnings(run.report, run.parts, wanted));
  return run;
}

// The options of a level of detail: a share of the whole's target, raised to the fewest vertices
// that the surface needs.
RemeshOptions optionsOfLevel(RemeshOptions options, double share) {
  options.lods.clear();
  options.tooFew = TooFew::Raise;
  if (options.vertices)
    options.vertices = Index(std::max(1LL, std::llround(share * double(*options.vertices))));
  else if (options.edgeLength)
    *options.edgeLength /= std::sqrt(share);
  else
    options.ratio = share * options.ratio.value_or(1);
  return options;
}

// The coarser levels that were asked for.
std::vector<SceneRun> remeshCoarser(const InspectedParts& originals, const RemeshOptions& options,
                                    const Progress& progress) {
  std::vector<SceneRun> runs;
  const double count = double(options.lods.size());
  for (const double share : options.lods) {
    PhaseClock clock;
    const double begin = double(runs.size()) / count;
    const Progress part = progress.part(begin, begin + 1 / count).timedBy(clock);
    runs.push_back(remeshInspected(originals, optionsOfLevel(options, share), part));
    runs.back().report = timed(std::move(runs.back().report), clock);
  }
  return runs;
}

}  // namespace

SceneRun remeshParts(const std::vector<io::Part>& originals, const RemeshOptions& options,
                     const Progress& progress) {
  progress.phase("inspect", 0, 0);
  return withinMemory(
      [&] { return remeshInspected(InspectedParts(originals), options, progress); });
}

std::vector<SceneRun> remeshLevels(const std::vector<io::Part>& originals,
                                   const RemeshOptions& options, const Progress& progress) {
  progress.phase("inspect", 0, 0);
  return withinMemory([&] {
    const InspectedParts inspected(originals);
    const double share = 1 / double(1 + options.lods.size());
    std::vector<SceneRun> runs = {remeshInspected(inspected, options, progress.part(0, share))};
    if (options.lods.empty()) return runs;
    progress.phase("levels of detail", share, share);
    for (SceneRun& run : remeshCoarser(inspected, optionsOfLevels(options, runs.front().report),
                                       progress.part(share, 1))) {
      runs.front().report.lods.push_back(run.report);
      runs.push_back(std::move(run));
    }
    return runs;
  });
}

}  // namespace remesher
