// SPDX-License-Identifier: MIT
#include "jobs/part_run.h"

#include <algorithm>
#include <utility>

#include "base/legible.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "jobs/angle_number.h"
#include "jobs/checks/crossing_check.h"
#include "jobs/face_budget.h"
#include "jobs/fewest_vertices.h"
#include "jobs/open_number.h"
#include "jobs/part_repair.h"
#include "jobs/parts/part_lengths.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "remesh/schemes/chooser.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

using Run = RemeshOutcome (*)(const TriangleMesh&, Welding, const PartOptions&, const Progress&);

RemeshOutcome runOn(PartInput part, Run remeshed, const PartOptions& options,
                    const Progress& progress) {
  const auto stretch = stretchAt(part.place.toWorld);
  const auto inPercents = [&](const TriangleMesh& shown) {
    PartOptions own = withPercentsOf(shown, growthOf(part.place.toWorld), options);
    if (own.maxError) *own.maxError /= part.place.elsewhere;
    return own;
  };
  if (!stretch)
    return remeshed(part.mesh, std::move(part.welding), inPercents(part.mesh), progress);
  const TriangleMesh shown = stretched(part.mesh, *stretch);
  PartOptions own = inPercents(shown);
  for (Guide& guide : own.guides)
    for (Vec3& p : guide.points) p = *stretch * p;
  RemeshOutcome outcome = remeshed(shown, std::move(part.welding), own, progress);
  outcome.mesh = relaxed(std::move(outcome.mesh), *stretch, part.mesh);
  outcome.tree.reset();
  return outcome;
}

// Among several parts others make up for a raised number.
bool keepsCorners(const PartTarget& target) {
  return target.targets.order().size() == 1 && isBudget(target.targets.of(target.surface));
}

PartOptions optionsFor(const PartTarget& target) {
  PartOptions options = target.unions.optionsOf(target.surface, target.targets.of(target.surface));
  options.guides = target.guides;
  return options;
}

// Remeshes a part by the search that its options need. A budget too small for the surface is
// raised.
RemeshOutcome remeshPart(PartInput part, const PartOptions& options, bool isOfBudget,
                         const Progress& progress) {
  const bool isRaised = isOfBudget && !options.quads && !options.maxError && options.bodies.empty();
  const Run remeshed = asksForFewest(options)      ? Run(remeshToFewest)
                       : leadsByAngle(options)     ? Run(remeshToAngle)
                       : limitsAngle(options)      ? Run(remeshAtAngle)
                       : leavesNumberOpen(options) ? Run(remeshAtOpenNumber)
                       : isRaised                  ? Run(remeshToBudget)
                                                   : Run(remeshSurface);
  if (!isRaised) return runOn(std::move(part), remeshed, options, progress);
  try {
    return runOn(part, remeshed, options, progress);
  } catch (const TooFewVertices&) {
    PartOptions raised = options;
    raised.tooFew = TooFew::Raise;
    return runOn(std::move(part), remeshed, raised, progress);
  }
}

std::vector<Index> crossingsOf(const TriangleMesh& original, const RemeshOutcome& outcome,
                               bool* isCrossed = nullptr) {
  return crossingsMade(original, inPrecisionOf(original, outcome.mesh).mesh, isCrossed);
}

// Whether a result without self-intersections may replace one that has some: it is hardly farther
// away, and its triangles are of another kind or hardly worse.
bool mayReplace(const TriangleMesh& original, const RemeshOutcome& crossed,
                const RemeshOutcome& other) {
  constexpr double kFarther = 1.5, kWorse = 5;  // times as far, degrees on average
  if (other.stopped != crossed.stopped) return false;
  if (!crossingsOf(original, other).empty()) return false;
  const auto measured = [&](const RemeshOutcome& outcome) {
    return measureDeviation(original, outcome.mesh, Maximum::Sampled);
  };
  const DeviationBothWays before = measured(crossed), after = measured(other);
  const auto isNear = [&](const Deviation& then, const Deviation& now) {
    const double unseen = kSeen * after.diagonal;
    return now.maximum <= std::max(kFarther * then.maximum, unseen) &&
           now.rms <= std::max(kFarther * then.rms, unseen);
  };
  if (!isNear(before.toResult, after.toResult) || !isNear(before.toOriginal, after.toOriginal))
    return false;
  return other.prefer != crossed.prefer ||
         inspectMesh(other.mesh).minAngle.mean >= inspectMesh(crossed.mesh).minAngle.mean - kWorse;
}

}  // namespace

// Simplification does not look for self-intersections, which a surface that repair has made sound
// must not have.
RemeshOutcome remeshAsShown(PartInput part, const PartTarget& target, const Progress& progress) {
  const TriangleMesh& mesh = part.mesh;
  try {
    PartOptions options = optionsFor(target);
    RemeshOutcome outcome = remeshPart(part, options, keepsCorners(target), progress);
    if (options.repair == Repair::Off) return outcome;
    const Rule& rule = choose(Decision::Repaired, [&](Fact fact) {
      if (fact == Fact::SimplifiedTaken) return outcome.prefer == Prefer::Shape;
      if (fact == Fact::ResultUnsound) return !isSound(outcome.mesh);
      return fact == Fact::OriginalSound && isSound(part.mesh);
    });
    if (rule.taken == Candidate::AsMade) return outcome;
    if (leavesNumberOpen(options)) options.vertices = Index(outcome.vertices);
    const bool isAsked = std::exchange(options.prefer, Prefer::Even) == Prefer::Shape;
    outcome = remeshPart(std::move(part), options, keepsCorners(target), progress);
    outcome.chosen = inReport(rule);
    if (isAsked)
      outcome.warnings.push_back(
          {"SHAPE_NOT_PREFERRED",
           "Simplification would make the repaired surface intersect itself: isotropic triangles "
           "were made instead.",
           1});
    return outcome;
  } catch (const TooFewVertices& error) {
    const std::size_t corners = cornersOfPart(mesh, target.targets.of(target.surface));
    target.targets.refuse(target.surface, {error.code,
                                           {error.target, std::max(error.needed, corners),
                                            std::max(error.enough, corners)}});
  }
}

UncrossedOutcome uncrossedAsShown(const ShownMesh& part, const PartTarget& target,
                                  RemeshOutcome made, const Progress& progress) {
  PartOptions options = optionsFor(target);
  // After repair, inSoundPrecisionOf looks for crossings in the rounded mesh.
  if (options.repair != Repair::Off) return {std::move(made), {}};
  bool isCrossed = false;
  std::vector<Index> crossings = crossingsOf(part.mesh, made, &isCrossed);
  RemeshOutcome other;
  if (leavesNumberOpen(options) || keepsCorners(target)) {
    options.vertices = Index(made.vertices);
    options.ratio.reset();
  }
  const auto isReplacedBy = [&](Run run, Prefer prefer) {
    options.prefer = prefer;
    other = runOn({part.mesh, Welding(part.mesh), part.place}, run, options, progress);
    const bool isFree = leadsByEdges(options) || (options.edgeLength && wantsOfEach(options));
    const bool isOfNumber = isFree || other.vertices == made.vertices;
    return isOfNumber && mayReplace(part.mesh, made, other);
  };
  const Prefer asked = options.prefer;
  const Rule& rule = choose(Decision::Crossings, [&](Fact fact) {
    if (fact == Fact::CrossingsMade)
      return !crossings.empty() && !options.quads && !asksForFewest(options) && !isCrossed;
    if (fact == Fact::ShapeAsked) return asked == Prefer::Shape;
    if (fact == Fact::IsotropicAsked) return asked == Prefer::Even;
    if (fact == Fact::SimplifiedTaken) return made.prefer == Prefer::Shape;
    if (fact == Fact::UncrossedReplaces) return isReplacedBy(remeshUncrossed, asked);
    return fact == Fact::SimplifiedReplaces && isReplacedBy(remeshSurface, Prefer::Shape);
  });
  if (rule.taken == Candidate::AsMade) return {std::move(made), std::move(crossings)};
  other.chosen = inReport(rule);
  return {std::move(other), {}};
}

RoundedMesh roundedOutcome(const TriangleMesh& original, RemeshOutcome& outcome, Repair repair) {
  if (repair != Repair::Off) return inSoundPrecisionOf(original, outcome);
  return inPrecisionOf(original, std::move(outcome.mesh));
}

bool isSurface(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    if (flatness(a, b, c) > kFlattest) return true;
  }
  return false;
}

Warning passedOn(const io::Part& part, const std::string& reason) {
  const std::string name = part.name.empty() ? "A mesh" : legible(part.name);
  return {"PASSED_ON", name + " is passed on as it came: " + reason, 1};
}

std::vector<InputPlace> ownPlaces(const TriangleMesh& mesh) {
  std::vector<InputPlace> places;
  for (Index i = 0; i < mesh.indices.size(); ++i)
    places.push_back({InputTriangle(i / 3), Vec3::Unit(Eigen::Index(i % 3))});
  return places;
}

io::Part withoutMesh(const io::Part& part) {
  return {part.name, {},          part.instances, part.groups,
          part.lods, part.source, part.finer,     part.hidden};
}

}  // namespace remesher
