// SPDX-License-Identifier: MIT
#include "jobs/scene_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/formats.h"
#include "jobs/checks/crossing_check.h"
#include "jobs/checks/quad_checks.h"
#include "jobs/checks/result_check.h"
#include "jobs/checks/wanted_check.h"
#include "jobs/face_budget.h"
#include "jobs/fewest_vertices.h"
#include "jobs/inspected_parts.h"
#include "jobs/level_switches.h"
#include "jobs/part_run.h"
#include "jobs/parts/drawing_order.h"
#include "jobs/parts/part_guides.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/parts/part_targets.h"
#include "jobs/parts/part_unions.h"
#include "jobs/pixel_levels.h"
#include "jobs/run_guards.h"
#include "remesh/schemes/chooser.h"

namespace remesher {

namespace {

// The share of a run's time that measuring takes, about.
constexpr double kMeasureShare = 0.15;

// Nothing is remeshed yet.
SceneRun begun(const InspectedParts& originals) {
  SceneRun run;
  for (const io::Part& part : originals.parts()) run.parts.push_back(withoutMesh(part));
  run.places.resize(run.parts.size());
  run.crossings.resize(run.parts.size());
  run.report.prefer.assign(run.parts.size(), Prefer::Even);
  run.report.chosen.resize(run.parts.size());
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
  run.report.warnings = mergedByCode(std::move(run.report.warnings), outcome.warnings);
  if (outcome.stopped != Stopped::Target) run.report.stopped = outcome.stopped;
  run.report.prefer[part] = outcome.prefer;
  run.report.chosen[part] = outcome.chosen;
  run.mirrors += outcome.mirrors.size();
  run.quadParts += outcome.quadParts;
  run.unmet.add(outcome.unmet);
}

// Keeps a part that is no surface.
void passOn(SceneRun& run, std::size_t number, const io::Part& original, const Error& reason) {
  run.parts[number].mesh = original.mesh;
  run.places[number] = ownPlaces(original.mesh);
  run.report.chosen[number] = inReport(choose(Decision::Part, {}));
  run.report.warnings =
      mergedByCode(std::move(run.report.warnings), {passedOn(original, reason.what())});
}

// The inspected parts, and how the output file holds their results.
struct SceneInput {
  const InspectedParts& originals;
  Held held;
};

// Remeshes the surfaces of a scene one by one.
class SurfaceRuns {
 public:
  SurfaceRuns(SceneRun& run, const SceneInput& input, const PartOptions& options)
      : run_(run),
        originals_(input.originals),
        options_(options),
        unions_(originals_.parts(), input.held, options),
        places_(placesOf(unions_.surfaces())),
        targets_(unions_.surfaces(), places_, options),
        guides_(sharedGuides(unions_.surfaces(), options)) {
    run_.report.warnings = mergedByCode(std::move(run_.report.warnings), guides_.warnings);
  }

  // Returns the last surface's tree.
  std::optional<ListedTree> all(const Progress& progress) {
    double total = 0, done = 0;
    for (const io::Part& part : unions_.surfaces())
      total += double(part.mesh.triangleCount()) / (1 - kMeasureShare);
    for (const std::size_t i : targets_.order()) {
      const double share = double(unions_.surfaces()[i].mesh.triangleCount()) / total;
      tree_.reset();
      remeshIfPossible(i, progress.part(done, done + share));
      done += share;
    }
    return std::move(tree_);
  }

 private:
  // A mesh that is no surface does not keep others from being remeshed.
  void remeshIfPossible(std::size_t surface, const Progress& progress) {
    try {
      one(surface, progress);
      isAny_ = true;
    } catch (const Error& error) {
      const bool isLast = surface == targets_.order().back();
      if (error.code != ErrorCode::NoTriangles || (isLast && !isAny_)) throw;
      for (const std::size_t m : unions_.membersOf(surface))
        passOn(run_, m, originals_.parts()[m], error);
      targets_.given(surface, 0);
    }
  }

  void one(std::size_t surface, const Progress& progress) {
    const std::vector<std::size_t>& members = unions_.membersOf(surface);
    const TriangleMesh& mesh = unions_.surfaces()[surface].mesh;
    PartTarget target = {targets_, unions_, surface};
    if (!guides_.ofSurface.empty()) target.guides = guides_.ofSurface[surface];
    Welding welding = members.size() > 1 ? Welding(mesh) : originals_.weldings()[members.front()];
    RemeshOutcome outcome =
        remeshAsShown({mesh, std::move(welding), places_[surface]}, target, progress);
    UncrossedOutcome made =
        uncrossedAsShown({mesh, places_[surface]}, target, std::move(outcome), progress);
    targets_.given(surface, made.outcome.vertices);
    tree_ = std::move(made.outcome.tree);
    std::vector<RemeshOutcome> parted = unions_.parted(surface, std::move(made.outcome));
    for (std::size_t k = 0; k < parted.size(); ++k) {
      const TriangleMesh& original = originals_.parts()[members[k]].mesh;
      for (const PairedPart& paired : parted[k].paired)
        run_.paired.push_back({originals_.given(members[k], paired.at), paired.quads});
      for (Warning& warning : parted[k].warnings)
        if (warning.at) place(warning, members[k]);
      take(run_, members[k], parted[k], roundedOutcome(original, parted[k], options_.repair));
      const bool isKnown = parted.size() == 1 && options_.repair == Repair::Off;
      run_.crossings[members[k]] = isKnown ? std::move(made.crossings)
                                           : crossingsMade(original, run_.parts[members[k]].mesh);
    }
  }

  // Says in the world of the file where the first is.
  void place(Warning& warning, std::size_t part) const {
    const io::Part& given = originals_.given()[part];
    *warning.at = originals_.given(part, *warning.at);
    if (!given.instances.empty()) *warning.at = given.instances.front() * *warning.at;
    warning.message +=
        " The first is near (" + placeInWords(*warning.at, originals_.given()) + ").";
  }

  SceneRun& run_;
  const InspectedParts& originals_;
  const PartOptions& options_;
  const PartUnions unions_;
  const std::vector<PartPlace> places_;  // per surface
  PartTargets targets_;
  const SharedGuides guides_;
  bool isAny_ = false;  // whether a surface has been remeshed
  std::optional<ListedTree> tree_;
};

// What only the making of quads knows of them.
void addMaking(QuadReport& quads, const SceneRun& run) {
  quads.symmetry = run.mirrors;
  quads.parts = run.quadParts;
  quads.paired = run.paired;
}

void measure(SceneRun& run, const InspectedParts& originals, const PartOptions& options,
             std::optional<ListedTree> tree) {
  run.report.output = inspectParts(run.parts, weldingsOf(run.parts), placesOf(run.parts));
  if (std::optional<QuadReport>& quads = run.report.output->quads) addMaking(*quads, run);
  if (run.parts.empty()) return;
  // Only the two-sided distance shows whether a bound is kept.
  const bool isGlimpsed = options.quality == Quality::Draft && !options.maxError;
  run.report.fidelity =
      fidelityOf({originals.parts(), run.parts, originals.places()},
                 isGlimpsed ? Maximum::Glimpsed : Maximum::Sampled, std::move(tree));
}

// Adds the warnings on a result, both as the file holds them.
void warnOf(Report& report, const PartPairs& parts, const MadeCrossings& crossings,
            const PartOptions& wanted) {
  for (const std::vector<Warning>& more :
       {warningsOf(crossings, parts.results), resultWarnings(report, parts.results, wanted),
        bordersOffGiven(parts.originals, parts.results)})
    report.warnings = mergedByCode(std::move(report.warnings), more);
  std::vector<Warning> lost;
  if (report.output->quads) {
    for (const std::vector<Warning>& more : {pairedParts(*report.output->quads, parts.results),
                                             turnedFromGiven(parts.originals, parts.results)})
      report.warnings = mergedByCode(std::move(report.warnings), more);
    lost = lostToQuads(parts.originals, parts.results);
  }
  if (lost.empty()) lost = dentedPart(report, parts, wanted);
  report.warnings = mergedByCode(std::move(report.warnings), lost);
}

// Measures what was wanted of each edge and triangle, and warns where it is not so.
void certify(SceneRun& run, const std::vector<io::Part>& results, const PartOptions& wanted) {
  run.report.output->wanted = wantedOf(results, wanted);
  run.report.warnings = mergedByCode(std::move(run.report.warnings),
                                     wantedMissed(*run.report.output, results, wanted, run.unmet));
}

// Describes several parts as the one surface that they are in the file.
void describeAsOne(SceneRun& run, const InspectedParts& originals, const PartOptions& wanted) {
  const std::vector<io::Part> given = asHeld(originals.given(), Held::AsOne);
  const std::vector<io::Part> made = asHeld(run.parts, Held::AsOne);
  const std::vector<PartPlace> places = placesOf(given);
  run.report.output = inspectScaled(made);
  if (std::optional<QuadReport>& quads = run.report.output->quads) addMaking(*quads, run);
  const PartPairs parts = {given, made, places};
  const std::vector<Index> crossings = crossingsMade(given.front().mesh, made.front().mesh);
  warnOf(run.report, parts, crossingsMade(parts, {crossings}), wanted);
  certify(run, made, wanted);
}

SceneRun remeshInspected(const SceneInput& input, const PartOptions& wanted,
                         const Progress& progress) {
  const InspectedParts& originals = input.originals;
  const PartOptions options = originals.applied(wanted);
  SceneRun run = begun(originals);
  std::optional<ListedTree> tree = SurfaceRuns(run, input, options).all(progress);
  progress.phase("measure", 1 - kMeasureShare, 1);
  measure(run, originals, options, std::move(tree));
  for (std::size_t i = 0; i < run.places.size(); ++i)
    run.places[i] = originals.given(i, std::move(run.places[i]));
  if (input.held == Held::AsOne && run.parts.size() > 1) {
    run.parts = originals.undone(std::move(run.parts));
    describeAsOne(run, originals, wanted);
    return run;
  }
  const MadeCrossings crossings =
      crossingsMade({originals.parts(), run.parts, originals.places()}, run.crossings);
  run.parts = originals.undone(std::move(run.parts));
  warnOf(run.report, {originals.given(), run.parts, originals.places()}, crossings, wanted);
  certify(run, run.parts, wanted);
  return run;
}

// Whether simplification, the nearest for a number of vertices, may make a scene or a level. Where
// it is asked for, it finds the number within a bound itself.
bool maySimplify(const PartOptions& options) {
  PartOptions shape = options;
  shape.prefer = Prefer::Shape;
  shape.maxError.reset();
  return options.prefer == Prefer::Auto && !options.quads && mayFollow(shape);
}

// Remeshes with one number of vertices after the other, until the result has as many faces as the
// budget allows. Most results meet it at once; later tries show no progress.
SceneRun remeshTowards(const SceneInput& input, PartOptions options, const Progress& progress) {
  FaceSearch search(options, input.originals.report());
  std::optional<SceneRun> best;
  while (!search.isSettled()) {
    options.vertices = search.vertices();
    SceneRun run = remeshInspected(input, options, best ? progress.part(1, 1) : progress);
    const bool areCornersKept =
        std::any_of(run.report.chosen.begin(), run.report.chosen.end(),
                    [](const Chosen& chosen) { return chosen.rule == "corners-kept"; });
    const bool isHeld = run.report.stopped == Stopped::MaxError ||
                        (areCornersKept && facesOf(*run.report.output) > *options.faces);
    if (search.take(*run.report.output)) best = std::move(run);
    if (isHeld) break;
  }
  // This warning names a number of vertices that was only tried.
  std::erase_if(best->report.warnings,
                [](const Warning& w) { return w.code == "QUADS_NUMBER_MISSED"; });
  return std::move(*best);
}

// Simplification takes no more triangles than are given: the budget is the most that there may be.
SceneRun remeshInBudget(const SceneInput& input, const PartOptions& wanted,
                        const Progress& progress) {
  if (!wanted.faces) return remeshInspected(input, wanted, progress);
  PartOptions options = wanted;
  const std::size_t given = input.originals.report().triangles;
  if (options.prefer == Prefer::Shape && !options.quads)
    options.faces = Index(std::min(std::size_t{*options.faces}, given));
  SceneRun made = remeshTowards(input, options, progress);
  SceneRun simplified;
  const auto isSimplifiedWithin = [&] {
    if (!maySimplify(options)) return false;
    PartOptions shape = options;
    shape.prefer = Prefer::Shape;
    simplified = remeshTowards(input, shape, progress.part(1, 1));
    return facesOf(*simplified.report.output) < facesOf(*made.report.output);
  };
  const Rule& rule = choose(Decision::Budget, [&](Fact fact) {
    if (fact == Fact::BudgetExceeded) return facesOf(*made.report.output) > *options.faces;
    return fact == Fact::SimplifiedWithin && isSimplifiedWithin();
  });
  if (rule.taken == Candidate::AsMade) return made;
  for (Chosen& chosen : simplified.report.chosen) chosen = inReport(rule);
  return simplified;
}

// The options of a level of detail: a share of the whole's target, raised to the fewest vertices
// that the surface needs. A budget may be more than the finest level has.
PartOptions optionsOfLevel(PartOptions options, double share, const Report& finest) {
  options.lods.clear();
  options.tooFew = TooFew::Raise;
  if (options.faces) {
    const double most = std::min(double(*options.faces), double(facesOf(*finest.output)));
    options.faces = Index(std::max(1.0, std::floor(share * most)));
  } else if (options.vertices) {
    options.vertices = Index(std::max(1LL, std::llround(share * double(*options.vertices))));
  } else if (options.edgeLength) {
    *options.edgeLength /= std::sqrt(share);
  } else {
    options.ratio = share * options.ratio.value_or(1);
  }
  return options;
}

// The options of a level of so many vertices, whose distance decides.
PartOptions optionsOfPixels(PartOptions options, Index vertices) {
  if (maySimplify(options)) options.prefer = Prefer::Shape;
  options.lods.clear();
  options.tooFew = TooFew::Raise;
  options.faces.reset();
  options.ratio.reset();
  options.edgeLength.reset();
  options.maxError.reset();
  options.lengths.maxError.reset();
  options.vertices = vertices;
  return options;
}

// The coarser levels that were asked for, each by levelOf(share of the vertices, or their number;
// the level before it, progress).
template <class LevelOf>
std::vector<SceneRun> coarserLevels(const SceneRun& finest, const PartOptions& options,
                                    const Progress& progress, LevelOf levelOf) {
  std::vector<SceneRun> runs;
  const double count = double(options.lods.size());
  for (const double wanted : options.lods) {
    PhaseClock clock;
    const double begin = double(runs.size()) / count;
    const Progress part = progress.part(begin, begin + 1 / count).timedBy(clock);
    const SceneRun& finer = runs.empty() ? finest : runs.back();
    const auto at = [&](double amount) { return levelOf(amount, finer, part); };
    SceneRun run =
        options.lodsBy == LodsBy::Shares ? at(wanted) : withinPixels(wanted, finer.report, at);
    run.report.takesOver = switchTo(run.report, finer.report);
    run.report = timed(std::move(run.report), clock);
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<SceneRun> remeshCoarser(const SceneInput& input, const PartOptions& options,
                                    const SceneRun& finest, const Progress& progress) {
  return coarserLevels(
      finest, options, progress, [&](double amount, const SceneRun&, const Progress& part) {
        if (options.lodsBy == LodsBy::Pixels)
          return remeshInspected(input, optionsOfPixels(options, Index(amount)), part);
        return remeshInBudget(input, optionsOfLevel(options, amount, finest.report), part);
      });
}

// The options of a level that is simplified from the finest one.
PartOptions optionsOfSimplified(const PartOptions& wanted, double share, const Report& finest) {
  PartOptions options;
  options.prefer = Prefer::Shape;
  options.textures = Textures::Keep;
  options.quality = wanted.quality;
  options.tooFew = TooFew::Raise;
  if (wanted.lodsBy == LodsBy::Pixels)
    options.vertices = Index(share);
  else if (wanted.faces)
    options.faces = Index(std::max(1.0, std::floor(share * double(finest.output->triangles))));
  else
    options.vertices = Index(std::max(1LL, std::llround(share * double(finest.output->vertices))));
  return options;
}

// A level simplified from the finest one; a copy of the level before it if that cannot be made.
SceneRun simplified(const InspectedParts& finest, const PartOptions& options,
                    const SceneRun& levelBefore, const Progress& progress) {
  try {
    return remeshInBudget({finest, Held::Apart}, options, progress);
  } catch (const Error& error) {
    if (error.code != ErrorCode::TargetBelowCurves && error.code != ErrorCode::TargetTooSmall)
      throw;
  }
  SceneRun same;
  same.parts = levelBefore.parts;
  same.report = levelBefore.report;
  same.report.lods.clear();
  same.report.warnings.clear();
  return same;
}

}  // namespace

Held heldIn(const std::string& outputName) {
  return io::canHold(outputName, io::kHoldsMeshes) ? Held::Apart : Held::AsOne;
}

SceneRun remeshParts(const std::vector<io::Part>& originals, const PartOptions& options,
                     const Progress& progress) {
  progress.phase("inspect", 0, 0);
  return withinMemory([&] {
    const InspectedParts inspected(originals);
    return remeshInBudget({inspected, Held::Apart}, options, progress);
  });
}

std::vector<SceneRun> remeshLevels(const std::vector<io::Part>& originals, Held held,
                                   const PartOptions& options, const Progress& progress) {
  progress.phase("inspect", 0, 0);
  return withinMemory([&] {
    const InspectedParts inspected(originals);
    const SceneInput input = {inspected, held};
    const double share = 1 / double(1 + options.lods.size());
    std::vector<SceneRun> runs = {remeshInBudget(input, options, progress.part(0, share))};
    keepDrawingOrder(runs.front().parts, originals);
    if (options.lods.empty()) return runs;
    progress.phase("levels of detail", share, share);
    const SceneRun& finest = runs.front();
    for (SceneRun& run : remeshCoarser(input, optionsOfLevels(options, finest.report), finest,
                                       progress.part(share, 1))) {
      runs.front().report.lods.push_back(run.report);
      keepDrawingOrder(run.parts, originals);
      runs.push_back(std::move(run));
    }
    return runs;
  });
}

std::vector<SceneRun> simplifiedLevels(const std::vector<io::Part>& originals,
                                       const SceneRun& finest, const PartOptions& options,
                                       const Progress& progress) {
  return withinMemory([&] {
    const InspectedParts inspected(finest.parts);
    return coarserLevels(
        finest, options, progress, [&](double amount, const SceneRun& finer, const Progress& part) {
          SceneRun run = simplified(inspected, optionsOfSimplified(options, amount, finest.report),
                                    finer, part);
          keepDrawingOrder(run.parts, finest.parts);
          run.report.input = finest.report.input;
          run.report.fidelity =
              fidelityOf({originals, run.parts, placesOf(originals)}, Maximum::Sampled, {});
          return run;
        });
  });
}

}  // namespace remesher
