// SPDX-License-Identifier: MIT
#include "schemes/remesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "accuracy/bound_error.h"
#include "accuracy/poor_regions.h"
#include "attributes/attribute_transfer.h"
#include "schemes/best.h"
#include "schemes/follow.h"
#include "schemes/plan.h"
#include "schemes/rounds.h"
#include "schemes/targets.h"
#include "steps/adapt.h"
#include "steps/apart.h"
#include "steps/split_obtuse.h"

namespace remesher {

namespace {

// Seams lie side by side and cross the surface as they please: of most triangles there two or three
// corners are on curves, and their angles are worth more than even steps along them.
constexpr double kStagger = 0.8;
constexpr double kBoundShare = 0.7;    // of a run's time, about, to keep an error bound
constexpr double kRoundsShare = 0.85;  // the rest mends what they leave poor
// Of the diagonal: half a pixel in a picture a thousand pixels wide.
constexpr double kSeen = 5e-4;
constexpr double kMuchNearer = 2;     // times, or
constexpr double kNearerSeen = 1e-3;  // of the diagonal: a pixel there
constexpr double kHopeless = 4;       // times: finishing makes nothing twice as near

// What a run leaves of the original.
struct Remeshed {
  WorkingMesh mesh;
  Stopped stopped;
  std::size_t coincident;  // see moveApart
};

// Those vertices of the original that its shape needs: taken where even triangles are visibly away
// from it and these much nearer, or where even triangles cannot be so few.
class Rival {
 public:
  Rival(const Prepared& original, const TriangleMesh& input)
      : original_(original), input_(input), seen_(kSeen * original.surface().diagonal()) {}

  // Whether even triangles that are not finished yet have lost.
  bool hasWon(const WorkingMesh& even) {
    const double distance = distanceOf(even);
    isSettled_ = distance <= seen_;
    if (isSettled_) return false;
    look();
    return isSettled_ = followed_ && distance > kHopeless * followed_->distance;
  }

  // What is taken, if not the even triangles.
  std::optional<Followed> winner(const WorkingMesh& even, bool isReached) {
    if (isSettled_ && isReached) return std::move(followed_);
    const double distance = distanceOf(even);
    if (isReached && distance <= seen_) return {};
    look();
    if (!isReached || !followed_) return std::move(followed_);
    const bool isMuchNearer = distance > kMuchNearer * followed_->distance ||
                              distance - followed_->distance > kNearerSeen / kSeen * seen_;
    return isMuchNearer ? std::move(followed_) : std::nullopt;
  }

 private:
  double distanceOf(const WorkingMesh& even) const {
    return distanceTo(even.mesh(), even.positions(), original_.surface().built());
  }

  void look() {
    if (!hasLooked_) followed_ = follow(original_.surface().built(), input_, original_.vertices());
    hasLooked_ = true;
  }

  const Prepared& original_;
  const TriangleMesh& input_;
  double seen_;  // what is no farther is not seen
  bool isSettled_ = false, hasLooked_ = false;
  std::optional<Followed> followed_;
};

// What decides how the mesh is treated.
struct Manner {
  double stagger;  // see Run
  Grain grain;
  Rival* rival = nullptr;  // what may be taken in its stead
};

Manner mannerFor(const TriangleMesh& input) {
  const double stagger = input.attributes.empty() ? 0 : kStagger;
  if (!input.isSingle) return {stagger, {}};
  constexpr double kHalfUlp = 0x1p-24, kHalfLeast = 0x1p-150;
  double farthest = 0;
  for (const Vec3& p : input.positions) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return {stagger, {std::max(kHalfUlp * farthest, kHalfLeast * input.scale), input.scale}};
}

bool runScheme(Run& run, std::size_t vertices, const RemeshOptions& options,
               const Progress& progress) {
  if (options.scheme == Scheme::Rounds) {
    const bool reached =
        runRounds(run, {vertices, options.splitObtuse}, progress.part(0, kRoundsShare));
    const Progress mending = progress.phase("mend", kRoundsShare, 1);
    if (run.rule.mode != Fidelity::Strict) mendPoorRegions(run);
    return reached;
  }
  const bool reached = runBest(run, vertices, progress);
  if (options.splitObtuse) splitObtuse(run);
  return reached;
}

// Where the bound asks for more vertices than there are to be, and than the original has, which
// keeps every bound, no scheme is a way there.
bool runWithin(Run& run, const BoundGoal& goal, const RemeshOptions& options,
               const Progress& progress) {
  constexpr double kBeyondAll = 1e15;  // a bound near nothing may ask for any number
  const std::size_t aim = std::size_t(std::lround(std::min(run.sizes.vertices(), kBeyondAll)));
  const std::size_t original = run.mesh.mesh().vertexCount();
  if (std::max(goal.vertices, original) < aim) {
    const bool reached = boundError(run, goal, progress);
    if (options.splitObtuse) splitObtuse(run);
    return reached;
  }
  runScheme(run, aim, options, progress.part(0, 1 - kBoundShare));
  const std::size_t most = options.splitObtuse ? run.mesh.mesh().vertexCount() : goal.vertices;
  return boundError(run, {goal.bound, most}, progress.part(1 - kBoundShare, 1));
}

std::size_t countDistinct(const WorkingMesh& mesh) {
  return distinctPositions(mesh.mesh(), mesh.positions());
}

struct Places {
  bool areReached;
  std::size_t coincident;  // see moveApart
};

// Where the builder cut the input apart, several vertices may share a place; what was promised is a
// number of places.
Places matchPositions(Run& run, std::size_t vertices) {
  constexpr int kTries = 4;
  std::size_t coincident = moveApart(run);
  for (int i = 0; i < kTries; ++i) {
    const std::size_t now = countDistinct(run.mesh);
    if (now == vertices) return {true, coincident};
    const std::size_t aim = run.mesh.mesh().vertexCount() + vertices - now;
    if (!matchCount(run, aim) && !fillUp(run, aim)) return {false, coincident};
    coincident = moveApart(run);
  }
  return {countDistinct(run.mesh) == vertices, coincident};
}

// Of many vertices each walks: over short edges the straight way leads to where patches do.
Projector projectorFor(const Prepared& original, const RemeshOptions& options) {
  constexpr std::size_t kMany = 8000;
  const bool walks = options.scheme == Scheme::Best && options.projection == Projection::Patches &&
                     original.vertices() >= kMany;
  if (walks) return Projector(original.ground());
  return Projector(original.ground(), options.projection, original.longestEdges());
}

Remeshed remeshOriginal(const Prepared& original, const RemeshOptions& options,
                        const Manner& manner, const Progress& progress) {
  Projector projector = projectorFor(original, options);
  WorkingMesh mesh(original.ground());
  SizeField sizes = original.sizes();
  Run run{mesh, projector, sizes, fidelityRule(options)};
  run.rule.grain = manner.grain;
  run.standIn = original.standIn();
  run.stagger = manner.stagger;
  run.quality = options.quality;
  if (manner.rival && options.quality == Quality::Best)
    run.isInVain = [&] { return manner.rival->hasWon(mesh); };
  const std::size_t vertices = original.vertices();
  const bool reached = original.bound()
                           ? runWithin(run, {*original.bound(), vertices}, options, progress)
                           : runScheme(run, vertices, options, progress);
  const bool mayMatch = !options.splitObtuse && (reached || countDistinct(mesh) < vertices);
  const Places places = mayMatch ? matchPositions(run, vertices) : Places{reached, moveApart(run)};
  const bool byBound = run.verdicts[std::size_t(Verdict::MaxError)] > 0;
  return {std::move(mesh),
          places.areReached ? Stopped::Target
          : byBound         ? Stopped::MaxError
                            : Stopped::Fidelity,
          places.coincident};
}

// Where textures are painted anew seams hold no vertices, but neither do they keep a shape that
// even triangles are too large for.
bool mayFollow(const RemeshOptions& options) {
  return options.textures == Textures::Bake && options.scheme == Scheme::Best &&
         options.density.empty() && !options.maxError && !options.splitObtuse;
}

RemeshOutcome outcomeOf(Followed followed, std::size_t vertices, std::vector<Warning> warnings) {
  return {std::move(followed.mesh), std::move(followed.places), Stopped::Target, vertices,
          std::move(warnings)};
}

}  // namespace

RemeshOutcome remeshSurface(const TriangleMesh& input, const RemeshOptions& options,
                            const Progress& progress) {
  checkOptions(options, input.positions.size());
  Plan plan = planRun(input, options, progress);
  if (mayFollow(options) && countCorners(plan.curves, plan.built.mesh) > plan.vertices)
    if (std::optional<Followed> followed = follow(plan.built, input, plan.vertices))
      return outcomeOf(std::move(*followed), plan.vertices, std::move(plan.warnings));
  const Prepared original(std::move(plan), options, progress);
  Rival rival(original, input);
  Manner manner = mannerFor(input);
  if (mayFollow(options)) manner.rival = &rival;
  const Remeshed remeshed = remeshOriginal(original, options, manner, progress);
  if (mayFollow(options))
    if (std::optional<Followed> followed =
            rival.winner(remeshed.mesh, remeshed.stopped == Stopped::Target))
      return outcomeOf(std::move(*followed), original.vertices(), original.warnings());
  progress.phase("extract", 1, 1);
  std::vector<InputPlace> places;
  if (options.textures == Textures::Bake) places = cornerPlaces(remeshed.mesh, input);
  const std::size_t vertices =
      options.splitObtuse ? original.vertices() : countDistinct(remeshed.mesh);
  return {extractMesh(remeshed.mesh, input, original.transfer()),
          std::move(places),
          remeshed.stopped,
          vertices,
          original.warnings(),
          remeshed.coincident};
}

}  // namespace remesher
