// SPDX-License-Identifier: MIT
#include "remesh/schemes/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "mesh/hubs.h"
#include "original/surface/original_tree.h"
#include "remesh/accuracy/bound_error.h"
#include "remesh/accuracy/fit.h"
#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/accuracy/poor_regions.h"
#include "remesh/quads/mesh/triangulated.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/best.h"
#include "remesh/schemes/bodies.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/mirror_door.h"
#include "remesh/schemes/number_note.h"
#include "remesh/schemes/plan.h"
#include "remesh/schemes/rival.h"
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
// three corners on curves, and their angles are worth more than even steps along the curves. With 0
// 3 cases of the helmet at 7 neighboring counts have 6.3 points fewer triangles above 50°, with 1.6
// .4 more, and worst angles are 1.1° smaller with either, means of medians.
constexpr double kStagger = 0.8;
constexpr double kBoundShare = 0.7;    // of a run's time, about, to keep an error bound
constexpr double kRoundsShare = 0.85;  // the rest mends the poor regions they leave

// The result of a run on the original.
struct Remeshed {
  WorkingMesh mesh;
  Stopped stopped;
  std::size_t coincident;  // see moveApart
};

// Whether a result may intersect itself.
enum class CrossingRule { Leave, Mend };

CrossingRule crossingsAfter(const RemeshOptions& options) {
  return options.repair == Repair::Off ? CrossingRule::Leave : CrossingRule::Mend;
}

// The settings of a run besides its original.
struct Manner {
  const RemeshOptions& options;
  double stagger;  // see Run
  Grain grain;
  Rival* rival;  // a mesh that may be taken instead, or null
  OriginalTree& tree;
  const Bodies& bodies;
  CrossingRule crossings = CrossingRule::Leave;
};

// Results in double precision are made as if they had to be single: a mesh is the same in every
// format of file, up to its last digits.
Grain grainOf(const TriangleMesh& input) {
  constexpr double kHalfUlp = 0x1p-24, kHalfLeast = 0x1p-150;
  double farthest = 0;
  for (const Vec3& p : input.positions) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return {std::max(kHalfUlp * farthest, kHalfLeast * input.scale), input.scale};
}

bool runScheme(Run& run, std::size_t vertices, const Manner& manner, const Progress& progress) {
  const RemeshOptions& options = manner.options;
  if (options.scheme == Scheme::Rounds) {
    const bool reached =
        runRounds(run, {vertices, options.splitObtuse}, progress.part(0, kRoundsShare));
    const Progress mending = progress.phase("mend", kRoundsShare, 1);
    if (run.asked.rule.mode != Fidelity::Strict) mendPoorRegions(run);
    return reached;
  }
  const bool reached = runBest(run, {vertices, options.quality, manner.rival}, progress);
  if (options.splitObtuse) splitObtuse(run);
  return reached;
}

// Makes as many vertices as the sizes for the bound need, even beyond the target; some are then
// removed as the bound allows. Sizes that need more vertices than the original has measure its
// facets, not its shape: then, and where the number itself is looked for, only the target is made.
bool runWithin(Run& run, const BoundGoal& goal, const Manner& manner, const Progress& progress) {
  const bool splitsObtuse = manner.options.splitObtuse;
  const std::size_t original = run.mesh.mesh().vertexCount();
  const double wanted = run.sizes.vertices();
  const bool isBeyond = wanted > double(std::max(goal.vertices, original));
  const bool isFewest = goal.outOfBound == OutOfBound::GiveUp;
  const std::size_t aim = isBeyond || isFewest ? goal.vertices : std::size_t(std::lround(wanted));
  runScheme(run, aim, manner, progress.part(0, 1 - kBoundShare));
  const std::size_t most = splitsObtuse ? run.mesh.mesh().vertexCount() : goal.vertices;
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
    if (missed >= least || (!matchCount(run, aim) && !fillUp(run, aim))) return {false, coincident};
    least = missed;
    coincident = moveApart(run);
  }
}

// With many vertices projection walks: over short edges the straight way leads to the same place as
// patches. Projection also walks if there are hubs, for patches hold whole stars, and each patch at
// a hub would hold all of its triangles: at 20,000 triangles 400 million together.
Projector projectorFor(const Prepared& original, const RemeshOptions& options) {
  const bool walks = options.scheme == Scheme::Best && options.projection == Projection::Patches &&
                     original.vertices() >= kMany;
  const bool hasHubs =
      options.projection == Projection::Patches && !Hubs(original.ground().mesh()).empty();
  if (walks || hasHubs) return Projector(original.ground());
  return Projector(original.ground(), options.projection, original.longestEdges());
}

// The vertices that repaired surfaces of many pieces or handles are made of, where those asked for
// do not suffice; otherwise 0.
std::size_t enoughInstead(const Prepared& original, const RemeshOptions& options) {
  if (options.repair == Repair::Off || original.bound() || options.splitObtuse) return 0;
  const std::size_t enough = fewestVertices(original.surface().mesh()).enough;
  return original.vertices() < enough ? enough : 0;
}

struct Made {
  bool isReached;  // the number of vertices
  Uncrossed uncrossed = {};
};

Made makeMesh(Run& run, const Prepared& original, const Manner& manner, const Progress& progress) {
  const RemeshOptions& options = manner.options;
  if (const std::size_t enough = enoughInstead(original, options)) {
    progress.phase("polish", 0, 0);
    return {false, makeUncrossed(run, enough)};
  }
  const std::size_t vertices = original.vertices();
  const bool isReached =
      original.bound()
          ? runWithin(run, {*original.bound(), vertices, options.outOfBound}, manner, progress)
          : runScheme(run, vertices, manner, progress);
  const bool isGivenUp = !isReached && original.bound() && options.outOfBound == OutOfBound::GiveUp;
  if (manner.crossings == CrossingRule::Leave || isGivenUp) return {isReached};
  Uncrossed uncrossed = keepUncrossed(run, vertices);
  const bool isStillReached = isReached && uncrossed.isReached;
  return {isStillReached, std::move(uncrossed)};
}

Remeshed remeshOriginal(const Prepared& original, const Manner& manner, const Progress& progress) {
  const RemeshOptions& options = manner.options;
  Projector projector = projectorFor(original, options);
  WorkingMesh mesh(original.ground());
  SizeField sizes = original.sizes();
  Run run{mesh, projector, sizes, {fidelityRule(options)}};
  run.asked.rule.grain = manner.grain;
  run.grounds.standIn = original.standIn();
  run.grounds.tree = &manner.tree;
  run.asked.stagger = manner.stagger;
  const std::size_t vertices = original.vertices();
  const std::size_t places = options.inBodies.value_or(Index(vertices));
  run.asked.effort = effortOf(options.quality, Level::Finest, vertices);
  const Made made = makeMesh(run, original, manner, progress);
  const bool mayMatch =
      !options.splitObtuse && (made.isReached || manner.bodies.countPlaces(mesh) < places);
  const Places matched = mayMatch ? matchPositions(run, places, manner.bodies)
                                  : Places{made.isReached, moveApart(run)};
  const bool byBound = run.verdicts[std::size_t(Verdict::MaxError)] > 0;
  return {std::move(mesh),
          matched.areReached ? Stopped::Target
          : byBound          ? Stopped::MaxError
                             : Stopped::Fidelity,
          matched.coincident};
}

// Whether the vertices of the original that its shape needs may be taken instead of even triangles:
// not if the caller sets sizes, bounds or edges. With repair only on demand, for no collapse there
// looks for crossings: the caller must.
bool mayFollow(const RemeshOptions& options) {
  return options.prefer != Prefer::Even && options.scheme == Scheme::Best &&
         options.density.empty() && options.featureEdges.empty() && options.bodies.empty() &&
         !options.maxError && !options.splitObtuse && options.boundary == Boundary::Resample &&
         (options.repair == Repair::Off || options.prefer == Prefer::Shape);
}

// The share of a run's time for the triangles of the map; each mesh of pairs takes a quarter of it.
constexpr double kMapShare = 0.4;

// Options for the even triangles that quads are made of: quick, and without the options that only
// triangles have.
RemeshOptions optionsForQuads(RemeshOptions options) {
  options.quality = Quality::Draft;
  options.scheme = Scheme::Best;
  options.adaptivity = options.adaptivity.value_or(0);
  options.splitObtuse = false;
  options.edgeLength.reset();
  options.maxError.reset();
  options.tooFew = TooFew::Raise;
  return options;
}

Warning pairedWarning(const MadeQuads& quads) {
  return {"QUADS_PAIRED",
          "No map to squares was found for " + std::to_string(quads.paired) + " of " +
              std::to_string(quads.parts) +
              " connected parts: their quads are pairs of triangles, divided, with more irregular "
              "vertices.",
          quads.paired};
}

// Vertices that lie on a curved surface leave their quads on its inner side: they move to where the
// quads fit, and then the few around the largest distances to where these are smallest.
void bringNearer(WorkingMesh& mesh, const Prepared& original, const RemeshOptions& options,
                 const Grain& grain) {
  Projector projector = projectorFor(original, options);
  SizeField sizes = original.sizes();
  if (const StandIn* standIn = original.standIn()) {
    projector.moveOnto(original.surface());
    sizes.moveOnto(original.surface(), standIn->heirs());
  }
  Run run{mesh, projector, sizes, {fidelityRule(options)}};
  run.asked.rule.grain = grain;
  run.asked.areQuads = true;
  run.asked.effort = effortOf(Quality::Best, Level::Finest, mesh.mesh().vertexCount());
  fit(run, {});
  // Distances are lowered beside the sides of the quads: those of the map's triangles may be a
  // quarter as long, and lines of quads would be bent for little.
  sizes = SizeField(original.surface(), {double(mesh.mesh().vertexCount()), *options.adaptivity});
  lowerHausdorff(run);
}

RemeshOutcome remeshToQuads(Plan plan, const TriangleMesh& input, const RemeshOptions& wanted,
                            const Progress& progress) {
  const RemeshOptions options = optionsForQuads(wanted);
  std::vector<std::unique_ptr<Prepared>> originals;  // all of the same surface
  // The map is made on the first mesh, pairs on the meshes that may follow.
  const auto triangles = [&](std::size_t vertices) {
    const double begin = originals.empty() ? 0 : kMapShare * (1 + double(originals.size()) / 4);
    const double end = originals.empty() ? kMapShare : begin + kMapShare / 4;
    const Progress stretch = progress.part(begin, std::min(end, 1.0));
    Plan copy = plan;
    copy.vertices = vertices;
    originals.push_back(std::make_unique<Prepared>(std::move(copy), options, stretch));
    OriginalTree tree(originals.back()->surface(), &input);
    const Bodies bodies(input, options.bodies);
    const Manner manner{options, 0, grainOf(input), nullptr, tree, bodies, crossingsAfter(options)};
    Remeshed remeshed = remeshOriginal(*originals.back(), manner, stretch);
    remeshed.mesh.compact();
    stretch.phase("quads", 1, 1);
    return std::move(remeshed.mesh);
  };
  const bool isHalf = !options.mirrors.planes.empty();
  const std::size_t aim = isHalf ? options.mirrors.vertices : plan.vertices;
  const bool isGraded = *options.adaptivity > 0 || !options.density.empty();
  const MadeQuads quads = makeQuads(
      {aim, wanted.exact, options.mirrors, isGraded, wanted.quality == Quality::Draft}, triangles);
  progress.phase("extract", 1, 1);
  const Prepared& original = *originals.front();
  WorkingMesh mesh = triangulated(quads.mesh, original.surface());
  if (wanted.quality != Quality::Draft) bringNearer(mesh, original, options, grainOf(input));
  std::vector<InputPlace> places;
  if (options.textures == Textures::Bake || isHalf) places = cornerPlaces(mesh, input);
  std::vector<Warning> warnings = original.warnings();
  if (quads.paired > 0) warnings.push_back(pairedWarning(quads));
  TriangleMesh result = extractMesh(mesh, input, original.transfer());
  result.isQuads = true;
  const std::size_t vertices = isHalf ? wholeCount(quads.mesh, options.mirrors)
                                      : distinctPositions(mesh.mesh(), mesh.positions());
  const double off = std::abs(double(vertices) - double(aim));
  // Quads removed from a half are missing in all its images, so that the whole is better made.
  const bool isReached =
      wanted.exact ? off == 0
                   : off <= kFreeTolerance * double(aim) && !(isHalf && quads.collapsed > 0);
  RemeshOutcome outcome{std::move(result), std::move(places),
                        isReached ? Stopped::Target : Stopped::Fidelity, vertices,
                        std::move(warnings)};
  if (!isHalf) noteNumber(outcome, {aim, wanted.exact});
  return outcome;
}

RemeshOutcome outcomeOf(Followed followed, std::size_t vertices, std::vector<Warning> warnings) {
  return {std::move(followed.mesh),
          std::move(followed.places),
          Stopped::Target,
          vertices,
          std::move(warnings),
          0,
          {},
          Prefer::Shape};
}

// More vertices keep more curves, which have more corners: a number named in a message must do when
// it is asked for.
std::size_t enoughForCurves(const TriangleMesh& input, RemeshOptions options,
                            std::size_t vertices) {
  options.ratio.reset();
  options.edgeLength.reset();
  for (;;) {
    options.vertices = Index(vertices);
    try {
      const Prepared prepared(planRun(input, Welding(input), options, {}), options, {});
      return vertices;
    } catch (const TooFewVertices& error) {
      constexpr std::size_t kAtLeast = 16;  // a sixteenth more each time
      vertices = std::max(error.needed, vertices + vertices / kAtLeast + 1);
    }
  }
}

// With more vertices than the original has, a bound too small to be seen gives them to the shape.
RemeshOptions withOwnShape(RemeshOptions options) {
  options.maxError = 100 * kSeen;
  return options;
}

RemeshOutcome remeshPlanned(const TriangleMesh& input, Welding welding, const RemeshOptions& asked,
                            CrossingRule crossings, const Progress& progress) {
  Plan plan = planRun(input, std::move(welding), asked, progress);
  if (asked.quads) return remeshToQuads(std::move(plan), input, asked, progress);
  const bool isWished = asked.prefer == Prefer::Shape;
  const bool isFiner =
      isWished && mayFollow(asked) && plan.vertices > plan.built.mesh.vertexCount();
  const RemeshOptions options = isFiner ? withOwnShape(asked) : asked;
  const bool isRivalled = mayFollow(options);
  const auto isForced = [&] {
    return options.textures == Textures::Bake &&
           countCorners(plan.curves, plan.built.mesh) > plan.vertices &&
           isWorthFollowing(plan.built, plan.vertices);
  };
  if (isRivalled && (isWished || isForced()))
    if (std::optional<Followed> followed =
            follow(plan.built, input, plan.vertices, options.textures))
      return outcomeOf(std::move(*followed), plan.vertices, std::move(plan.warnings));
  const Prepared original(std::move(plan), options, progress);
  Rival rival(original, input, options.textures);
  const bool mayMiss = isRivalled && rival.mayMiss();
  OriginalTree tree(original.surface(), &input);
  const Bodies bodies(input, options.bodies);
  const Manner manner{options,        input.attributes.empty() ? 0 : kStagger,
                      grainOf(input), isRivalled ? &rival : nullptr,
                      tree,           bodies,
                      crossings};
  const Remeshed remeshed =
      remeshOriginal(original, manner, mayMiss ? progress.part(0, 0.5) : progress);
  if (isRivalled)
    if (std::optional<Followed> followed =
            rival.winner(remeshed.mesh, remeshed.stopped == Stopped::Target))
      return outcomeOf(std::move(*followed), original.vertices(), original.warnings());
  if (mayMiss && rival.isMissedBy(remeshed.mesh)) {
    RemeshOptions nearer = options;
    nearer.prefer = Prefer::Shape;
    RemeshOutcome outcome =
        remeshPlanned(input, Welding(input), nearer, crossings, progress.part(0.5, 1));
    if (outcome.stopped == Stopped::Target) return outcome;
  }
  progress.phase("extract", 1, 1);
  std::vector<InputPlace> places;
  if (options.textures == Textures::Bake) places = cornerPlaces(remeshed.mesh, input);
  const std::size_t vertices =
      options.splitObtuse ? original.vertices() : bodies.countPlaces(remeshed.mesh);
  return {extractMesh(remeshed.mesh, input, original.transfer()),
          std::move(places),
          remeshed.stopped,
          vertices,
          original.warnings(),
          remeshed.coincident,
          tree.ofInput(),
          isFiner ? Prefer::Shape : Prefer::Even};
}

}  // namespace

RemeshOutcome remeshSurface(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress) {
  checkOptions(options, input.positions.size());
  const auto remeshHalf = [&](const TriangleMesh& half, const RemeshOptions& own) {
    return remeshPlanned(half, Welding(half), own, crossingsAfter(own), progress);
  };
  if (options.quads)
    if (std::optional<RemeshOutcome> mirrored = remeshIfMirrored(input, options, remeshHalf))
      return std::move(*mirrored);
  try {
    return remeshPlanned(input, std::move(welding), options, crossingsAfter(options), progress);
  } catch (const TooFewVertices& error) {
    if (error.code != ErrorCode::TargetBelowCurves) throw;
    const std::size_t enough = enoughForCurves(input, options, error.needed);
    throw TooFewVertices(error.code, {error.target, enough, enough});
  }
}

RemeshOutcome remeshUncrossed(const TriangleMesh& input, Welding welding,
                              const RemeshOptions& options, const Progress& progress) {
  RemeshOptions even = options;
  even.prefer = Prefer::Even;
  return remeshPlanned(input, std::move(welding), even, CrossingRule::Mend, progress);
}

}  // namespace remesher
