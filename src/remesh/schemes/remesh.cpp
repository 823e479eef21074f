// SPDX-License-Identifier: MIT
#include "remesh/schemes/remesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "original/surface/original_tree.h"
#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/quads/mesh/joint_sides.h"
#include "remesh/quads/mesh/triangulated.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/as_quads.h"
#include "remesh/schemes/bodies.h"
#include "remesh/schemes/chooser.h"
#include "remesh/schemes/conformed.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/isotropic.h"
#include "remesh/schemes/number_note.h"
#include "remesh/schemes/plan.h"
#include "remesh/schemes/targets.h"
#include "remesh/transfer/attribute_transfer.h"

namespace remesher {

namespace {

// The share of a run's time for the triangles of the map; each mesh of pairs takes a quarter of it.
constexpr double kMapShare = 0.4;

// Options for the isotropic triangles that quads are made of: quick, and without the options that
// only triangles have.
PartOptions optionsForQuads(PartOptions options) {
  options.quality = Quality::Draft;
  options.scheme = Scheme::Best;
  options.adaptivity = options.adaptivity.value_or(0);
  options.splitObtuse = false;
  options.edgeLength.reset();
  options.maxError.reset();
  options.tooFew = TooFew::Raise;
  return options;
}

// The few vertices around the largest distances move to where these are smallest.
void bringNearer(WorkingMesh& mesh, const Prepared& original, const PartOptions& options,
                 const Quantum& quantum) {
  Projector projector = projectorFor(original, options);
  SizeField sizes = original.sizes();
  if (const Proxy* proxy = original.proxy()) {
    projector.moveOnto(original.surface());
    sizes.moveOnto(original.surface(), proxy->collapseMap());
  }
  Run run{mesh, projector, sizes, {fidelityRule(options)}};
  run.asked.rule.quantum = quantum;
  run.asked.areQuads = true;
  run.asked.effort = effortOf(Quality::Best, Level::Finest, mesh.mesh().vertexCount());
  // Distances are lowered beside the sides of the quads: those of the map's triangles may be a
  // quarter as long, and lines of quads would be bent for little.
  sizes = SizeField(original.surface(), {double(mesh.mesh().vertexCount()), *options.adaptivity});
  lowerHausdorff(run);
}

struct QuadRun {
  Scope scope;
  const Progress& progress;
};

RemeshOutcome remeshToQuads(Plan plan, const TriangleMesh& input, const PartOptions& wanted,
                            const QuadRun& run) {
  const Progress& progress = run.progress;
  const PartOptions options = optionsForQuads(wanted);
  std::vector<std::unique_ptr<Prepared>> originals;  // all of the same surface
  // Where pieces or handles need more vertices, all smaller numbers make the same mesh.
  struct {
    std::size_t most = 0;
    std::optional<WorkingMesh> mesh = {};
  } raised;
  // The map is made on the first mesh, pairs on the meshes that may follow.
  const auto triangles = [&](std::size_t vertices) {
    if (raised.mesh && vertices <= raised.most) return *raised.mesh;
    const double begin = originals.empty() ? 0 : kMapShare * (1 + double(originals.size()) / 4);
    const double end = originals.empty() ? kMapShare : begin + kMapShare / 4;
    const Progress stretch = progress.part(begin, std::min(end, 1.0));
    Plan copy = plan;
    copy.vertices = vertices;
    originals.push_back(std::make_unique<Prepared>(std::move(copy), options, stretch));
    OriginalTree tree(originals.back()->surface(), &input);
    const Bodies bodies(input, options.bodies);
    // Quads are made on the surface, not of its triangles: where too many of these meet, they stay.
    const CrossingRule crossings =
        options.repair == Repair::Off ? CrossingRule::Leave : CrossingRule::MendInPlace;
    const RunSettings settings{options, 0, quantumOf(input), nullptr, tree, bodies, crossings};
    Remeshed remeshed = remeshOriginal(*originals.back(), settings, stretch);
    remeshed.mesh.compact();
    stretch.phase("quads", 1, 1);
    if (enoughInstead(*originals.back(), options) > 0) raised = {vertices, remeshed.mesh};
    return std::move(remeshed.mesh);
  };
  const bool isHalf = !options.mirrors.planes.empty();
  const std::size_t aim = isHalf ? options.mirrors.vertices : plan.vertices;
  const bool isGraded = *options.adaptivity > 0 || !options.density.empty();
  QuadGoal goal{aim, wanted.exact, options.mirrors, isGraded, wanted.quality == Quality::Draft};
  goal.isPart = run.scope.isPart;
  goal.share = run.scope.share;
  goal.isForced = isHalf && isForced(options.symmetry);
  goal.guides = options.guides;
  const MadeQuads quads = makeQuads(goal, triangles);
  progress.phase("extract", 1, 1);
  const Prepared& original = *originals.front();
  WorkingMesh mesh = triangulated(quads.mesh, original.surface());
  if (wanted.quality != Quality::Draft) bringNearer(mesh, original, options, quantumOf(input));
  if (!wanted.exact) meetAtJoints(mesh);  // vertices at one place would count once
  std::vector<InputPlace> places;
  if (options.textures == Textures::Bake || isHalf) places = cornerPlaces(mesh, input);
  std::vector<Warning> warnings = original.warnings();
  TransferRules transfer = original.transfer();
  transfer.areQuads = true;
  TriangleMesh result = extractMesh(mesh, input, transfer);
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
  outcome.quadParts = quads.parts;
  outcome.removed = quads.collapsed;
  outcome.paired = quads.paired;
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
std::size_t enoughForCurves(const TriangleMesh& input, PartOptions options, std::size_t vertices) {
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

// The candidates for the triangles of a surface, each made when the chooser first asks for it.
class SurfaceCandidates {
 public:
  SurfaceCandidates(const TriangleMesh& input, Welding welding, const PartOptions& options,
                    CrossingRule crossings, const Progress& progress)
      : input_(input),
        options_(options),
        crossings_(crossings),
        progress_(progress),
        mayFollow_(mayFollow(options)),
        plan_(planRun(input, std::move(welding), options, progress)),
        vertices_(plan_.vertices),
        isRefined_(options.bodies.empty() && vertices_ > plan_.built.mesh.vertexCount()) {}

  RemeshOutcome chosen() {
    const Rule& rule = choose(Decision::Surface,
                              [this](Fact fact) { return isOfRequest(fact) || isOfMesh(fact); });
    RemeshOutcome outcome = taken(rule.taken);
    outcome.chosen = inReport(rule);
    return outcome;
  }

 private:
  bool isOfRequest(Fact fact) {
    if (fact == Fact::RoundsAsked) return options_.scheme == Scheme::Rounds;
    if (fact == Fact::IsotropicAsked) return options_.prefer == Prefer::Even;
    if (fact == Fact::ShapeAsked) return options_.prefer == Prefer::Shape;
    if (fact == Fact::VerticesPlaced)
      return !mayFollow_ || (!options_.bodies.empty() && !isSimplified());
    return fact == Fact::MoreThanInput && isRefined_;
  }

  bool isOfMesh(Fact fact) {
    if (fact == Fact::CornersExceedNumber)
      return (options_.textures == Textures::Bake || isRaised()) &&
             countCorners(plan_.curves, plan_.built.mesh) > vertices_ &&
             isWorthFollowing(plan_.built, vertices_);
    if (fact == Fact::SimplifiedToNumber) return isSimplified();
    if (fact == Fact::FacetsMeshed) return areFacetsMeshed();
    if (fact == Fact::FacetsBetter)
      return prepared().comparison().areFacetsFine() ||
             (isotropic().isReached()
                  ? isotropic().comparison().isConformingBetter(isotropic().mesh())
                  : isotropic().comparison().hasConforming());
    if (fact == Fact::FacetsUnrolled) return prepared().comparison().isUnrolled();
    if (fact == Fact::IsotropicInstead)
      return isotropic().isReached() &&
             isotropic().comparison().isIsotropicInstead(isotropic().mesh());
    if (fact == Fact::NumberReached) return isotropic().isReached();
    if (fact == Fact::FlatSidesRefined) return isotropic().comparison().refinesFlatSides();
    if (fact == Fact::UnfinishedFar) return isotropic().comparison().isUnfinishedFar();
    if (fact == Fact::UnfinishedNear) return isotropic().comparison().isUnfinishedNear();
    if (fact == Fact::SimplifiedOrDivided) return isotropic().comparison().hasSimplified();
    if (fact == Fact::IsotropicFar) return isotropic().comparison().isSeen(isotropic().mesh());
    if (fact == Fact::SimplifiedNearer)
      return isotropic().comparison().isSimplifiedNearer(isotropic().mesh());
    return fact == Fact::BoundedReached && bounded().isReached();
  }

  // Whether corners of colours raise the number, for which no facets are meshed. With textures more
  // vertices keep each texel in its place.
  bool isRaised() const {
    const auto isTexcoord = [](const Attribute& attribute) {
      return attribute.semantic.starts_with("TEXCOORD");
    };
    return options_.tooFew == TooFew::Raise && !input_.attributes.empty() &&
           std::none_of(input_.attributes.begin(), input_.attributes.end(), isTexcoord);
  }

  bool isSimplified() {
    // Where the shape is asked for, no other candidate is nearer or has fewer vertices.
    const bool isAsked = options_.prefer == Prefer::Shape;
    if (!simplified_)
      simplified_ = follow(plan_.built, input_, options_.inBodies.value_or(Index(vertices_)),
                           {options_.textures, isAsked, isAsked ? options_.tooFew : TooFew::Refuse,
                            options_.bodies});
    return simplified_->has_value();
  }

  bool areFacetsMeshed() {
    if (!conformed_)
      conformed_ = options_.bodies.empty() && isFaceted(plan_.built)
                       ? conformed(plan_.built, input_, vertices_, options_.textures,
                                   {0, options_.longestOfFacets})
                       : std::nullopt;
    return conformed_->has_value();
  }

  // For isotropic triangles, which are still to be made.
  Isotropic& prepared() {
    if (!isotropic_)
      isotropic_ = std::make_unique<Isotropic>(std::move(plan_), input_, options_, progress_);
    return *isotropic_;
  }

  // If it may have to be made within a bound, it takes half of the progress.
  Isotropic& isotropic() {
    if (prepared().isMade()) return *isotropic_;
    const bool isCompared = mayFollow_ && options_.bodies.empty();
    ShapeComparison* const comparison = isCompared ? &isotropic_->comparison() : nullptr;
    const bool mayRefine = comparison && comparison->refinesFlatSides();
    isotropic_->make(crossings_, comparison, mayRefine ? progress_.part(0, kHalf) : progress_);
    return *isotropic_;
  }

  // With more vertices than the original has, a bound too small to be seen gives them to the shape.
  Isotropic& bounded() {
    if (bounded_) return *bounded_;
    PartOptions options = options_;
    options.maxError = 100 * kSeen;
    const Progress progress = isotropic_ ? progress_.part(kHalf, 1) : progress_;
    Plan plan =
        isotropic_ ? planRun(input_, Welding(input_), options_, progress) : std::move(plan_);
    bounded_ = std::make_unique<Isotropic>(std::move(plan), input_, options, progress);
    bounded_->make(crossings_, nullptr, progress);
    return *bounded_;
  }

  RemeshOutcome taken(Candidate candidate) {
    if (candidate == Candidate::Bounded) return bounded().outcome(Prefer::Shape, progress_);
    if (candidate == Candidate::Isotropic) return isotropic().outcome(Prefer::Even, progress_);
    const bool conforms = candidate == Candidate::Conforming;
    if (!isotropic_) {
      Followed& made = conforms ? **conformed_ : **simplified_;
      const std::size_t vertices = conforms ? vertices_ : made.positions;
      return outcomeOf(std::move(made), vertices, std::move(plan_.warnings));
    }
    const Prepared& original = prepared().original();
    ShapeComparison& comparison = prepared().comparison();
    return outcomeOf(conforms ? comparison.takeConforming() : comparison.takeSimplified(),
                     original.places(), original.warnings());
  }

  static constexpr double kHalf = 0.5;

  const TriangleMesh& input_;
  const PartOptions& options_;
  const CrossingRule crossings_;
  const Progress& progress_;
  const bool mayFollow_;
  Plan plan_;  // empty once a candidate was made of it
  const std::size_t vertices_;
  const bool isRefined_;  // whether more vertices are wanted than the input has
  std::optional<std::optional<Followed>> simplified_, conformed_;  // of the plan
  std::unique_ptr<Isotropic> isotropic_, bounded_;
};

RemeshOutcome chosenQuads(const TriangleMesh& input, const Welding& welding,
                          const PartOptions& options, const Progress& progress) {
  const auto plain = [](const TriangleMesh& part, const PartOptions& own, Scope scope,
                        const Progress& stretch) {
    return remeshToQuads(planRun(part, Welding(part), own, stretch), part, own, {scope, stretch});
  };
  RemeshOutcome made = remeshAsQuads(input, welding, options, plain, progress);
  const Rule& rule = choose(Decision::Quads, [&](Fact fact) {
    if (fact == Fact::MirrorsKept) return !made.mirrors.empty();
    return fact == Fact::PartsPaired && !made.paired.empty();
  });
  made.chosen = inReport(rule);
  return made;
}

}  // namespace

bool mayFollow(const PartOptions& options) {
  return options.prefer != Prefer::Even && options.scheme == Scheme::Best &&
         options.density.empty() && options.featureEdges.empty() && !options.maxError &&
         !wantsOfEach(options) && !options.splitObtuse && options.boundary == Boundary::Resample &&
         ((options.bodies.empty() && !isRemade(options.repair)) || options.prefer == Prefer::Shape);
}

RemeshOutcome remeshSurface(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress) {
  checkOptions(options, input.positions.size());
  try {
    if (options.quads) return chosenQuads(input, welding, options, progress);
    return SurfaceCandidates(input, std::move(welding), options, crossingsAfter(options), progress)
        .chosen();
  } catch (const TooFewVertices& error) {
    if (error.code != ErrorCode::TargetBelowCurves) throw;
    const std::size_t enough = enoughForCurves(input, options, error.needed);
    throw TooFewVertices(error.code, {error.target, enough, enough});
  }
}

RemeshOutcome remeshUncrossed(const TriangleMesh& input, Welding welding,
                              const PartOptions& options, const Progress& progress) {
  PartOptions isotropic = options;
  isotropic.prefer = Prefer::Even;
  return SurfaceCandidates(input, std::move(welding), isotropic, CrossingRule::Mend, progress)
      .chosen();
}

}  // namespace remesher
