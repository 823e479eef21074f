// SPDX-License-Identifier: MIT
#include "jobs/thinned_parts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "geometry/distance_sampler.h"
#include "geometry/triangle.h"
#include "jobs/checks/repair_room.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_places.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "simplify/thin_out.h"

namespace remesher {
namespace {

// The most vertices of an original whose distance is measured.
constexpr std::size_t kMostSamples = 500'000;

// Whether what is remeshed is another surface, of which the size is not known yet.
bool isMended(const PartOptions& options) {
  return options.repair != Repair::Off || options.dropBelow || options.lengths.dropBelow ||
         options.dropFloaters || options.dropHidden;
}

// The option that needs the original itself; empty if none does.
std::string_view needingAll(const PartOptions& options) {
  struct Need {
    std::string_view name;
    bool isGiven;
  };
  const Need needs[] = {
      {"repair or what leaves triangles out", isMended(options)},
      {"maxError", options.maxError || options.lengths.maxError},
      {"fidelity", options.fidelity.has_value()},
      {"projection", options.projection == Projection::Current},
      {"density", !options.density.empty()},
      {"featureEdges", !options.featureEdges.empty()},
      {"region", !options.region.empty()},
      {"minEdge, maxEdge or minAngle", wantsOfEach(options)},
      {"quads", options.quads},
      {"conform", options.conform},
      {"baked textures", options.textures == Textures::Bake},
      {"the scheme rounds", options.scheme != Scheme::Best},
  };
  for (const Need& need : needs)
    if (need.isGiven) return need.name;
  return {};
}

// The vertices asked for; of an edge length and of no number it is not known yet.
std::optional<double> askedVertices(const PartOptions& options, double given) {
  std::optional<double> asked;
  if (options.ratio) asked = *options.ratio * given;
  if (options.faces) asked = double(*options.faces) / 2;
  if (options.vertices) asked = double(*options.vertices);
  if (!asked || options.edgeLength) return {};
  double finest = 1;
  if (options.lodsBy == LodsBy::Shares)
    for (const double share : options.lods) finest = std::max(finest, share);
  return *asked * finest;
}

bool isFine(const TriangleMesh& mesh, double asked, const ThinningLimits& limits) {
  const double triangles = double(mesh.triangleCount());
  return triangles > double(limits.triangles) && triangles > double(limits.perVertex) * asked;
}

// Bytes for each triangle: of reading, inspecting and thinning out; of a part that waits while
// another is remeshed; and of all work of remeshing.
constexpr double kBytesToThinOut = 75, kBytesToHold = 110, kBytesToRemesh = 600;

// A soup has more vertices than its surface, a mesh with doubled triangles more triangles.
double trianglesOf(const io::Part& part) {
  return std::min(double(part.mesh.triangleCount()), 2 * double(part.mesh.positions.size()));
}

// What parts need of which those of more triangles than `most` are thinned out to so many. What was
// given is gone when the rest is remeshed.
RoomNeeds needsOf(const std::vector<io::Part>& parts, double most) {
  double all = 0, left = 0, largest = 0;
  for (const io::Part& part : parts) {
    const double own = trianglesOf(part), kept = std::min(most, own);
    all += own;
    left += kept;
    largest = std::max(largest, kept);
  }
  const double toRemesh = kBytesToHold * left + (kBytesToRemesh - kBytesToHold) * largest;
  return {all, std::max(kBytesToThinOut * all, toRemesh)};
}

// Two triangles for each vertex that is left.
double trianglesLeft(double asked, const ThinningLimits& limits) {
  return 2 * std::max(double(limits.fewest), double(limits.kept) * asked);
}

// The most vertices of a result for which the largest part is thinned out, and all have room; below
// 1 if there are none.
double mostThinned(const std::vector<io::Part>& parts, const ThinningLimits& limits) {
  const auto fits = [&](double asked) {
    return haveRoom(needsOf(parts, trianglesLeft(asked, limits)), limits.addresses);
  };
  double largest = 0;
  for (const io::Part& part : parts) largest = std::max(largest, trianglesOf(part));
  double most = 0, tooMany = std::floor((largest - 1) / double(limits.perVertex)) + 1;
  if (!fits(most)) return 0;
  while (tooMany - most > 1) {
    const double middle = std::floor((most + tooMany) / 2);
    (fits(middle) ? most : tooMany) = middle;
  }
  return most;
}

std::string thinnedFor(double vertices) {
  return "For up to " + inMillions(vertices) + " vertices it is thinned out first";
}

[[noreturn]] void refuseToRemesh(const RoomNeeds& needs, const std::string& way, double addresses) {
  refuseSize(needs, "remesh", way + "Give it in parts, or remesh it with the native library.",
             addresses);
}

// Calls visit(first corner) for each triangle, with whether it has three different places.
template <class Visit>
void forEachTriangle(const TriangleMesh& mesh, Visit visit) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Index* const t = &mesh.indices[i];
    visit(i, !hasTwins(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
  }
}

std::size_t countWithoutPlaces(const TriangleMesh& mesh) {
  std::size_t count = 0;
  forEachTriangle(mesh, [&](std::size_t, bool hasThree) { count += hasThree ? 0 : 1; });
  return count;
}

std::vector<Vec3> someOf(const TriangleMesh& mesh) {
  const std::vector<Vec3>& positions = mesh.positions;
  std::vector<char> isUsed(positions.size(), 0);
  forEachTriangle(mesh, [&](std::size_t first, bool hasThree) {
    for (std::size_t k = 0; hasThree && k < 3; ++k) isUsed[mesh.indices[first + k]] = 1;
  });
  const std::size_t step = (positions.size() + kMostSamples - 1) / kMostSamples;
  std::vector<Vec3> some;
  for (std::size_t v = 0; v < positions.size(); v += step)
    if (isUsed[v]) some.push_back(positions[v]);
  return some;
}

// hindrance: the option that forbids thinning, or empty; asked: the vertices of the result, if it
// is allowed.
struct Thinning {
  std::string_view hindrance;
  std::optional<double> asked;
};

void requireRoomToRemesh(const std::vector<io::Part>& parts, const Thinning& thinning,
                         const ThinningLimits& limits) {
  const auto& [hindrance, asked] = thinning;
  const double most = asked ? trianglesLeft(*asked, limits) : kInfinity;
  const RoomNeeds needs = needsOf(parts, most);
  if (haveRoom(needs, limits.addresses)) return;
  const double fits = mostThinned(parts, limits);
  const std::string but = hindrance.empty() ? "" : ", but not with " + std::string(hindrance);
  const std::string way = fits >= 1 ? thinnedFor(fits) + but + ". " : "";
  refuseToRemesh(needs, way, limits.addresses);
}

void requireOneScan(const std::vector<io::Part>& parts, const PartOptions& options,
                    const ScanSlabs& slabs, bool isNumbered) {
  const bool isOther = options.ratio || options.weld || options.lengths.weld ||
                       slabs.only > slabs.count || (slabs.only > 0 && !options.lods.empty());
  if (isOther || !isNumbered || parts.size() != 1)
    throw Error(ErrorCode::InvalidOption,
                "Slabs need one mesh and a number of vertices or faces, and no option that needs "
                "the original, such as weld; slab is a number from 1 to slabs, without lods.");
}

}  // namespace

std::vector<Warning> roomWarnings(const std::vector<io::Part>& parts,
                                  const ThinningLimits& limits) {
  const RoomNeeds needs = needsOf(parts, kInfinity);
  if (haveRoom(needs, limits.addresses)) return {};
  const double fits = mostThinned(parts, limits);
  if (fits < 1) refuseToRemesh(needs, "", limits.addresses);
  std::vector<Warning> warnings = {
      {"NEEDS_THINNING",
       "To remesh this model as it is " + needsInWords(needs, limits.addresses) + " " +
           thinnedFor(fits) + ". Booleans of it and unwrapping it take as much.",
       std::size_t(needs.triangles)}};
  if (const std::optional<Warning> lacking = noRoomForFaults(parts, limits.addresses))
    warnings.push_back(*lacking);
  return warnings;
}

ThinnedParts::ThinnedParts(std::vector<io::Part>& parts, const PartOptions& options,
                           const ThinningLimits& limits, const ScanSlabs& slabs)
    : slabs_(slabs) {
  std::string_view hindrance = needingAll(options);
  if (hindrance.empty() && options.ratio && parts.size() > 1)
    hindrance = "a ratio of several meshes";
  double vertices = 0;
  for (const io::Part& part : parts) vertices += double(part.mesh.positions.size());
  std::optional<double> rough;
  if (hindrance.empty()) rough = askedVertices(options, vertices);
  const auto isFineFor = [&](double asked) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const io::Part& part) { return isFine(part.mesh, asked, limits); });
  };
  if (slabs.count > 0) requireOneScan(parts, options, slabs, rough.has_value());
  const bool isFineEnough = slabs.count > 0 || (rough && isFineFor(*rough));
  if (!isMended(options) && slabs.only == 0)
    requireRoomToRemesh(parts, {hindrance, isFineEnough ? rough : std::nullopt}, limits);
  if (isFineEnough) withinMemory([&] { thinOutFine(parts, options, limits); });
}

void ThinnedParts::thinOutFine(std::vector<io::Part>& parts, const PartOptions& options,
                               const ThinningLimits& limits) {
  ThinOut wanted;
  wanted.repeated = &repeated_;
  const auto wantFor = [&](double asked) {
    wanted.vertices = std::max(limits.fewest, std::size_t(std::ceil(double(limits.kept) * asked)));
  };
  const bool isSlab = slabs_.only > 0;
  if (isSlab) {
    // The report then describes the slab.
    TriangleMesh& mesh = parts.front().mesh;
    requireValid(mesh);
    wantFor(*askedVertices(options, 0));
    SlabToThin slab = slabToThin(mesh, slabs_.only - 1, slabs_.count, wanted);
    mesh = std::move(slab.mesh);
    wanted = std::move(slab.wanted);
  }
  std::vector<std::vector<Index>> first = inspect(parts);
  const double asked = *askedVertices(options, double(input_.vertices));
  if (!isSlab) wantFor(asked);
  // Parts may have borders in common.
  if (parts.size() > 1)
    wanted.borders = OpenBorders::Keep;
  else
    samples_ = someOf(parts.front().mesh);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TriangleMesh& mesh = parts[i].mesh;
    if (slabs_.count == 0 && !isFine(mesh, asked, limits)) continue;
    noteGiven(mesh);
    ThinOut own = wanted;
    own.first = std::move(first[i]);
    if (slabs_.count > 0 && !isSlab) {
      own.first.clear();
      mesh = thinnedBySlabs(mesh, slabs_.count, wanted);
    }
    if (isSlab || isFine(mesh, asked, limits)) mesh = thinnedOut(std::move(mesh), std::move(own));
    noteLeft(mesh);
  }
}

// Returns the first vertices at all places. The rest of the weldings, which is larger, goes.
std::vector<std::vector<Index>> ThinnedParts::inspect(const std::vector<io::Part>& parts) {
  PlainInspection inspection(parts);
  input_ = inspection.report;
  std::vector<std::vector<Index>> first;
  for (Welding& welding : inspection.weldings) first.push_back(std::move(welding.first));
  return first;
}

void ThinnedParts::noteGiven(const TriangleMesh& mesh) {
  given_ += mesh.positions.size();
  removed_ += countWithoutPlaces(mesh);
}

void ThinnedParts::noteLeft(const TriangleMesh& mesh) {
  left_ += mesh.positions.size();
  removed_ -= countWithoutPlaces(mesh);
}

PartOptions ThinnedParts::applied(PartOptions options) const {
  if (!isThinned() || !options.ratio || options.vertices) return options;
  options.vertices = Index(std::max(1LL, std::llround(*options.ratio * double(input_.vertices))));
  options.ratio.reset();
  return options;
}

FidelityReport ThinnedParts::measured(const SceneRun& run) const {
  FidelityReport fidelity = run.report.fidelity.value_or(FidelityReport{});
  if (samples_.empty() || !(input_.diagonal > 0)) return fidelity;
  const TriangleMesh& made = run.parts.front().mesh;
  const TriangleTree tree(made.positions, made.indices);
  DistanceSampler sampler(tree);
  for (const Vec3& p : samples_) sampler.add(p);
  const double percent = 100 * longestOf(run.parts.front()) / input_.diagonal;
  fidelity.hausdorff = std::max(fidelity.hausdorff, percent * sampler.farthest());
  fidelity.rms = std::max(fidelity.rms, percent * sampler.rms());
  return fidelity;
}

std::unique_ptr<const ThinnedParts> thinnedParts(std::vector<io::Part>& parts,
                                                 const PartOptions& options,
                                                 const ScanSlabs& slabs) {
  auto thinned = std::make_unique<const ThinnedParts>(parts, options, ThinningLimits{}, slabs);
  return thinned->isThinned() ? std::move(thinned) : nullptr;
}

void ThinnedParts::note(std::vector<SceneRun>& runs) const {
  if (!isThinned()) return;
  const auto describe = [&](Report& report, const FidelityReport& fidelity) {
    report.input = input_;
    if (report.fidelity) report.fidelity = fidelity;
  };
  std::vector<Report>& levels = runs.front().report.lods;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const FidelityReport fidelity = measured(runs[i]);
    describe(runs[i].report, fidelity);
    if (i > 0 && i <= levels.size()) describe(levels[i - 1], fidelity);
  }
  std::vector<Warning>& warnings = runs.front().report.warnings;
  const auto add = [&](const char* code, const char* message, std::size_t count) {
    if (count > 0) warnings = mergedByCode(std::move(warnings), {{code, message, count}});
  };
  add("DEGENERATE_TRIANGLES_REMOVED", "Triangles without three distinct corners were removed.",
      removed_);
  add("DUPLICATE_TRIANGLES_REMOVED", "Triangles that repeat another one exactly were removed.",
      repeated_);
  const std::string samples =
      samples_.empty() ? "The distances are those from the thinned-out surface."
                       : "The distances are those of " + std::to_string(samples_.size()) +
                             " of its vertices and of the thinned-out surface.";
  warnings.push_back({"THINNED_OUT",
                      "The model is far finer than the result: it was thinned out first, from " +
                          std::to_string(given_) + " to " + std::to_string(left_) + " vertices. " +
                          samples,
                      given_ - left_});
}

}  // namespace remesher
