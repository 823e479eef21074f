// SPDX-License-Identifier: MIT
#include "remesh/schemes/isotropic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "mesh/hubs.h"
#include "remesh/accuracy/bound_error.h"
#include "remesh/accuracy/poor_regions.h"
#include "remesh/schemes/best.h"
#include "remesh/schemes/edge_limits.h"
#include "remesh/schemes/rounds.h"
#include "remesh/schemes/targets.h"
#include "remesh/schemes/uncrossed.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/apart.h"
#include "remesh/steps/split_obtuse.h"
#include "remesh/transfer/attribute_transfer.h"

namespace remesher {

namespace {

// Seams lie side by side and cross the surface as they please: most triangles there have two or
// three corners on curves, and their angles are worth more than even steps along the curves.
constexpr double kStagger = 0.8;
constexpr double kBoundShare = 0.7;    // of a run's time, about, to keep an error bound
constexpr double kRoundsShare = 0.85;  // the rest mends the poor regions they leave

bool runScheme(Run& run, std::size_t vertices, const RunSettings& settings,
               const Progress& progress) {
  const PartOptions& options = settings.options;
  if (options.scheme == Scheme::Rounds) {
    const bool reached =
        runRounds(run, {vertices, options.splitObtuse}, progress.part(0, kRoundsShare));
    const Progress mending = progress.phase("mend", kRoundsShare, 1);
    if (run.asked.rule.mode != Fidelity::Strict) mendPoorRegions(run);
    return reached;
  }
  const bool reached = runBest(run, {vertices, options.quality, settings.comparison}, progress);
  if (options.splitObtuse) splitObtuse(run);
  return reached;
}

// Makes as many vertices as the sizes for the bound need, even beyond the target; some are then
// removed as the bound allows. Sizes that need more vertices than the original has measure its
// facets, not its shape: then, and where the number itself is looked for, only the target is made.
bool runWithin(Run& run, const BoundGoal& goal, const RunSettings& settings,
               const Progress& progress) {
  const bool splitsObtuse = settings.options.splitObtuse;
  const std::size_t original = run.mesh.mesh().vertexCount();
  const double wanted = run.sizes.vertices();
  const bool isBeyond = wanted > double(std::max(goal.vertices, original));
  const bool isFewest = goal.outOfBound == OutOfBound::GiveUp;
  const std::size_t aim = isBeyond || isFewest ? goal.vertices : std::size_t(std::lround(wanted));
  runScheme(run, aim, settings, progress.part(0, 1 - kBoundShare));
  const bool mayAdd = splitsObtuse || leadsByEdges(settings.options);
  const std::size_t most = mayAdd ? run.mesh.mesh().vertexCount() : goal.vertices;
  return boundError(run, {goal.bound, most, goal.outOfBound}, progress.part(1 - kBoundShare, 1));
}

struct Places {
  bool areReached;
  std::size_t coincident;  // see moveApart
};

// Where the builder cut the input apart, several vertices may share a place; the target is a number
// of places, which is aimed at as long as it comes nearer.
Places matchPositions(Run& run, std::size_t vertices, const Bodies& bodies) {
  std::size_t coincident = moveApart(run);
  for (std::size_t least = std::numeric_limits<std::size_t>::max();;) {
    const std::size_t now = bodies.countPlaces(run.mesh);
    if (now == vertices) return {true, coincident};
    const std::size_t missed = std::max(now, vertices) - std::min(now, vertices);
    const std::size_t aim = run.mesh.mesh().vertexCount() + vertices - now;
    if (missed >= least || (!matchCount(run, aim) && !fillUp(run, aim))) {
      fires("isotropic: number of positions not met");
      return {false, coincident};
    }
    least = missed;
    coincident = moveApart(run);
  }
}

// By how much mending a needle may move the surface. That of a lattice has no shape within half an
// edge; any other one must not be seen to change, such as a thin blade between two sharp edges,
// also where several steps add up. A smallest angle that is asked for is worth more.
double farthestOfNeedles(const Prepared& original, const PartOptions& options) {
  constexpr double kUnseenStep = kSeen / 4;
  return isRemade(options.repair) || options.minAngle ? kInfinity
                                                      : kUnseenStep * original.surface().diagonal();
}

struct Made {
  bool isReached;  // the number of vertices
  Uncrossed uncrossed = {};
};

Made makeMesh(Run& run, const Prepared& original, const RunSettings& settings,
              const Progress& progress) {
  const PartOptions& options = settings.options;
  const double farthest = farthestOfNeedles(original, options);
  if (const std::size_t enough = enoughInstead(original, options)) {
    fires("isotropic: more pieces or handles than the number allows");
    progress.phase("polish", 0, 0);
    if (settings.crossings == CrossingRule::Mend)
      return {false, makeUncrossed(run, enough, farthest)};
    makeThinned(run, enough);
    return {false};
  }
  const std::size_t vertices = original.vertices();
  const bool isReached =
      original.bound()
          ? runWithin(run, {*original.bound(), vertices, options.outOfBound}, settings, progress)
          : runScheme(run, vertices, settings, progress);
  const bool isGivenUp = !isReached && original.bound() && options.outOfBound == OutOfBound::GiveUp;
  if (settings.crossings == CrossingRule::Leave || isGivenUp) return {isReached};
  Uncrossed uncrossed = settings.crossings == CrossingRule::Mend
                            ? keepUncrossed(run, vertices, farthest)
                            : mendUncrossed(run, vertices);
  const bool isStillReached = isReached && uncrossed.isReached;
  return {isStillReached, std::move(uncrossed)};
}

}  // namespace

// Results in double precision are made as if they had to be single, so that formats of files make
// hardly a difference. They are rounded where they are worked on: else a model of flat sides, whose
// triangles nearly meet, would get another mesh elsewhere or in another unit of length.
Quantum quantumOf(const TriangleMesh& input) {
  constexpr double kHalfUlp = 0x1p-24, kHalfLeast = 0x1p-150;
  const Frame frame = input.isSingle ? input.frame : Frame{};
  double farthest = 0;
  for (const Vec3& p : input.positions)
    farthest = std::max(farthest, frame.written(p).cwiseAbs().maxCoeff());
  return {std::max(kHalfUlp * farthest, kHalfLeast) * frame.scale(), frame};
}

// With many vertices projection walks: over short edges the straight way leads to the same place as
// patches. Projection also walks if there are hubs, for patches hold whole stars, and each patch at
// a hub would hold all of its triangles: at 20,000 triangles 400 million together.
Projector projectorFor(const Prepared& original, const PartOptions& options) {
  const bool walks = options.scheme == Scheme::Best && options.projection == Projection::Patches &&
                     original.vertices() >= kMany;
  const bool hasHubs =
      options.projection == Projection::Patches && !Hubs(original.ground().mesh()).empty();
  if (hasHubs) fires("isotropic: hubs, so projection walks");
  if (walks || hasHubs) return Projector(original.ground());
  return Projector(original.ground(), options.projection, original.longestEdges());
}

std::size_t enoughInstead(const Prepared& original, const PartOptions& options) {
  if (options.repair == Repair::Off || original.bound() || options.splitObtuse) return 0;
  const std::size_t enough = fewestVertices(original.surface().mesh()).enough;
  return original.vertices() < enough ? enough : 0;
}

Remeshed remeshOriginal(const Prepared& original, const RunSettings& settings,
                        const Progress& progress) {
  const PartOptions& options = settings.options;
  Projector projector = projectorFor(original, options);
  WorkingMesh mesh(original.ground());
  SizeField sizes = original.sizes();
  Run run{mesh, projector, sizes, {fidelityRule(options)}};
  run.asked.rule.quantum = settings.quantum;
  run.grounds.proxy = original.proxy();
  run.grounds.tree = &settings.tree;
  run.asked.stagger = settings.stagger;
  const std::size_t vertices = original.vertices();
  const std::size_t places = options.inBodies.value_or(Index(original.places()));
  run.asked.effort = effortOf(options.quality, Level::Finest, vertices);
  const Made made = makeMesh(run, original, settings, progress);
  const bool isFree = !options.vertices && !options.faces && !options.ratio;
  keepLimits(run, options, isFree ? Number::Free : Number::Matched);
  const bool mayMatch = !options.splitObtuse && !(wantsOfEach(options) && isFree) &&
                        (made.isReached || settings.bodies.countPlaces(mesh) < places);
  const Places matched = mayMatch ? matchPositions(run, places, settings.bodies)
                                  : Places{made.isReached, moveApart(run)};
  if (!isFree) keepLimits(run, options, Number::Kept);
  const Unmet unmet = unmetLimits(run, options);
  const bool byBound = run.verdicts[std::size_t(Verdict::MaxError)] > 0;
  return {std::move(mesh),
          matched.areReached ? Stopped::Target
          : byBound          ? Stopped::MaxError
                             : Stopped::Fidelity,
          matched.coincident, unmet};
}

void Isotropic::make(CrossingRule crossings, ShapeComparison* comparison,
                     const Progress& progress) {
  const RunSettings settings{options_,
                             input_.attributes.empty() ? 0 : kStagger,
                             quantumOf(input_),
                             comparison,
                             tree_,
                             bodies_,
                             crossings};
  made_ = remeshOriginal(original_, settings, progress);
}

RemeshOutcome Isotropic::outcome(Prefer prefer, const Progress& progress) {
  progress.phase("extract", 1, 1);
  std::vector<InputPlace> places;
  if (options_.textures == Textures::Bake) places = cornerPlaces(mesh(), input_);
  const std::size_t vertices =
      options_.splitObtuse ? original_.places() : bodies_.countPlaces(mesh());
  RemeshOutcome outcome{extractMesh(mesh(), input_, original_.transfer()),
                        std::move(places),
                        made_->stopped,
                        vertices,
                        original_.warnings(),
                        made_->coincident,
                        tree_.ofInput(),
                        prefer};
  outcome.unmet = made_->unmet;
  return outcome;
}

}  // namespace remesher
