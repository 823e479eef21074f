// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/quad.h"
#include "mesh/quad_loops.h"
#include "remesh/quads/extract/closing.h"
#include "remesh/quads/extract/extraction.h"
#include "remesh/quads/extract/holes.h"
#include "remesh/quads/extract/opening.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/mesh/quad_borders.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_distance.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/quads.h"
#include "remesh/quads/shape/collapse.h"
#include "remesh/quads/shape/finish.h"
#include "remesh/quads/shape/mending.h"
#include "remesh/quads/shape/rewiring.h"
#include "remesh/quads/shape/thin_protrusions.h"

namespace remesher {

namespace {

// As many scales are corrected by the count of the map before; 2 kSteps beside the best follow, the
// farthest off by kCountTolerance.
constexpr int kSteps = 4;
// The largest count error of a result: half as many vertices again as wanted, for each of these
// counts kTooMany times.
constexpr double kFarthest = 2;
// A vertex too many is as bad as kTooMany too few, and kTooMany of them as bad as a fault: adding
// rows costs nothing, removing a quad leaves irregular vertices.
constexpr double kTooMany = 4;
// Of fewer vertices maps take no time, and singular vertices may fall together.
constexpr double kFew = 100;
// Quads that leave a part of the surface by as many sides are worse than pairs.
constexpr double kMostAway = 1.4;
// Where more than this share of the quads is unsound, curves are nearer to each other than sides
// are long. Mending them would take a second for each map, and most would stay.
constexpr double kHopeless = 0.2;
// Where the longest loop crosses more than this share of the edges, so many more maps are looked
// at, whose scales differ by kMoreStep, for one whose longest loop is clearly shorter.
constexpr double kLongLoop = 0.25, kMoreStep = 0.002, kShorter = 0.9;
constexpr int kMoreMaps = 24;
// Where loops wind farther than this, other integers are looked for; so many maps of these are
// extracted at most.
constexpr double kWinding = 0.3;
constexpr std::size_t kMostClosed = 6;
// Of these so many are finished, to be compared with the quads before. Corners and distances may be
// worse by these factors; and corners have at least this sine, or that of the worst one before.
constexpr std::size_t kMostFinished = 3;
constexpr double kCornersWorse = 1.05, kFarther = 1.1, kSoundSine = 0.45;

// A connected part, and the mesh that its map is made on.
struct Domain {
  const WorkingMesh& part;
  const Simpler& simpler;
  Tears tears;
  const FieldWishes& wishes;
  WorkBudget& work;
  const QuadDistance distance = QuadDistance(part);
};

struct Extracted {
  QuadMesh quads;
  Eigen::VectorXd integers = {};  // the map's integer variables
  double length = 0;              // and its scale
  double faults = 0;              // curves that are not followed, and unsound quads
  double grown = 0;               // vertices of thin protrusions that the map lacks
  // By how much χ differs, and 1 if the kind of surface does, and 1 if the border is torn.
  std::size_t lost = 1;
  bool isRewired = false;
};
// The quads of a map.
Extracted extracted(const Domain& domain, const SeamlessMap& map) {
  const WorkingMesh& part = domain.part;
  Extracted made{extractQuads(domain.simpler.mesh, map), map.integers, map.length};
  QuadMesh& quads = made.quads;
  dropUnsound(quads);
  if (quads.quads.empty()) return made;
  keepLargestPiece(quads);
  fillHoles(quads, part);
  openAgain(quads, part, domain.simpler);
  if (domain.tears == Tears::Closed) closeToBorder(quads, part);
  made.faults = double(followCurves(quads, part));
  removeDoublets(quads);
  dropUnusedVertices(quads);
  fillDoublets(quads, part);
  collapseFlatCorners(quads, part);
  if (!check(quads).empty()) return made;
  const SurfaceKind kind = kindOf(quads), wanted = kindOf(part.mesh());
  made.lost = std::size_t(std::abs(kind.eulerCharacteristic - wanted.eulerCharacteristic));
  made.lost += kind != wanted;
  made.lost += !sidesOffBorder(quads, part.surface()).empty();
  const std::size_t before = quads.vertices.size();
  if (made.lost == 0) growThinProtrusions(quads, part);
  made.grown = double(quads.vertices.size() - before);
  return made;
}

double countError(double count, double wanted) {
  const double off = count / wanted - 1;
  return off > kCountTolerance ? kTooMany * off : std::abs(off);
}

// The cost of a result: its faults, and vertices to be taken out or added.
double costOf(const Extracted& made, double wanted) {
  const double count = double(made.quads.vertices.size()), most = (1 + kCountTolerance) * wanted;
  return made.faults + std::max(0.0, count - most) / kTooMany + countError(count, wanted);
}

// Rewires quads that have too many faults for each map of a search to be rewired: that takes a
// second, and most faults stay.
void rewireLate(std::optional<Extracted>& made, const Domain& domain) {
  const WorkingMesh& part = domain.part;
  if (!made || made->isRewired) return;
  fires("quads: only the last map is rewired");
  made->faults -= kTooMany * faultsOf(made->quads, part);
  rewire(made->quads, part, domain.work);
  made->faults += kTooMany * faultsOf(made->quads, part);
}

// Searches for a scale whose map is good. Each scale gives another map, because integers are
// rounded anew, and counts come in steps: so scales on both sides of the best one are tried, ever
// farther away. Where a larger scale gives the same map, no map has fewer quads. most: as many maps
// are shaped and judged, or fail, before the search ends.
std::optional<Extracted> searchScale(const Domain& domain, const MapMaker& maker, double vertices,
                                     int most) {
  const WorkingMesh& part = domain.part;
  std::optional<Extracted> best;
  double length = std::sqrt(areaOf(part) / vertices);
  double nearest = length, least = kFarthest;
  int shaped = 0, failed = 0;
  std::vector<double> known;          // the marks of the maps that were extracted
  std::optional<SeamlessMap> passed;  // the nearest one, if it was not
  std::optional<double> last;         // the mark of the map before
  double grown = 0;                   // vertices of thin protrusions that maps lack
  for (int i = 0; i < 3 * kSteps && std::max(shaped, failed) < most; ++i) {
    if (maker.isSpent() || (best && domain.work.isSpent())) {
      fires("quads: no more maps");
      break;
    }
    const bool isFirst = i < kSteps;
    if (best ? best->faults == 0 : !isFirst && least == kFarthest) break;
    const int beside = i % 2 == 0 ? i - kSteps : kSteps - i;
    const double aside = 1 + kCountTolerance * beside / (2 * kSteps);
    const double scale = isFirst ? length : nearest * aside;
    const auto map = i == kSteps ? std::exchange(passed, {}) : maker.map(scale, known);
    if (!map) continue;
    const double count = maker.countVertices(*map) + double(domain.simpler.added) + grown;
    const double error = countError(count, vertices);
    if (error < least) {
      least = error;
      nearest = scale;
      passed = map;
    }
    length *= std::sqrt(std::clamp(count / vertices, 0.25, 4.0));
    if (isFirst && last == map->mark && count > vertices && vertices > kFew) i = kSteps - 1;
    last = map->mark;
    if (error >= (isFirst ? kCountTolerance : best ? costOf(*best, vertices) : kFarthest)) continue;
    Extracted made = extracted(domain, *map);
    // Other maps will lack about as many.
    if (isFirst && grown == 0 && made.grown > kCountTolerance * vertices) {
      grown = made.grown;
      length = scale * std::sqrt((count + grown) / vertices);
      least = kFarthest;
      passed.reset();
      i = -1;
      continue;
    }
    known.push_back(map->mark);
    passed.reset();
    if (made.lost > 0 || countError(double(made.quads.vertices.size()), vertices) >= kFarthest) {
      failed += made.lost > kSteps ? most : 1;  // others lose as much, or nearly
      continue;
    }
    // Shaping lessens neither the faults so far nor, by much, the distance from the number.
    if (best && costOf(made, vertices) >= costOf(*best, vertices)) {
      ++shaped;
      continue;
    }
    if (domain.distance.sidesAway(made.quads) > kMostAway) {
      fires("quads: the map leaves the surface");
      ++failed;
      continue;
    }
    settle(made.quads, part);
    const double unsound = unsoundShare(made.quads, part);
    if (vertices > kFew && unsound > kHopeless) {
      fires("quads: too many unsound to be mended");
      ++failed;
      continue;
    }
    const double worthwhile = double(mostRewired(made.quads)) / 2;
    made.isRewired = unsound * double(made.quads.quads.size()) <= worthwhile;
    if (made.isRewired) rewire(made.quads, part, domain.work);
    made.faults += kTooMany * faultsOf(made.quads, part);
    ++shaped;
    if (!best || costOf(made, vertices) < costOf(*best, vertices)) best = std::move(made);
  }
  return best;
}

std::size_t irregularCount(const QuadMesh& mesh) {
  return countIrregular(mesh.vertices.size(), sidesByEdge(mesh.quads));
}

// The share of all edges that the loop crosses which crosses most.
double longestLoop(const QuadMesh& mesh) {
  const QuadLoops loops = loopsOf(mesh.quads.size(), sidesByEdge(mesh.quads));
  return double(loops.longest) / double(loops.edges);
}

// Looks among scales beside the one that was found for a map whose longest loop is shorter. Where
// the lines of two singular vertices pass each other a quad or two apart, loops spiral along the
// surface, and a small change of scale moves them.
void shortenLoops(Extracted& made, const Domain& domain, const MapMaker& maker, double vertices) {
  const std::size_t irregular = irregularCount(made.quads);
  double shortest = longestLoop(made.quads);
  if (made.faults > 0 || shortest <= kLongLoop) return;
  const double grown = std::min(made.grown, vertices / 2);
  const double added = double(domain.simpler.added) + grown;
  const double length = std::sqrt(areaOf(domain.part) / (vertices - grown));
  std::vector<double> known;
  std::optional<Extracted> best;
  for (int i = 0; i < kMoreMaps && !maker.isSpent(); ++i) {
    const int beside = i % 2 == 0 ? (i + 1) / 2 : -(i + 1) / 2;
    const auto map = maker.map(length * (1 + kMoreStep * beside), known);
    if (!map) continue;
    known.push_back(map->mark);
    const double count = maker.countVertices(*map) + added;
    if (std::abs(count / vertices - 1) > kCountTolerance) continue;
    Extracted one = extracted(domain, *map);
    const bool isSame = one.lost == 0 && one.faults == 0;
    if (!isSame || irregularCount(one.quads) > irregular) continue;
    const double longest = longestLoop(one.quads);
    if (longest >= kShorter * shortest) continue;
    shape(one.quads, domain.part, domain.work);
    if (faultsOf(one.quads, domain.part) > 0 || irregularCount(one.quads) > irregular) continue;
    shortest = longest;
    best = std::move(one);
    if (shortest <= kLongLoop) break;
  }
  if (best) made = std::move(*best);
}

// How far loops wind: the share of the longest, and that of the quads in which one crosses itself.
double windingOf(const QuadMesh& mesh) {
  const QuadLoops loops = loopsOf(mesh.quads.size(), sidesByEdge(mesh.quads));
  return double(loops.longest) / double(loops.edges) +
         double(loops.selfCrossing) / double(mesh.quads.size());
}

// The quality of quads: how far corners are from right angles, by the mean cosine and by the sine
// of the worst one, and the largest distance from the original, both ways.
struct Quality {
  double meanCosine = 0, leastSine = 1, distance = 0;
};

Quality qualityOf(const QuadMesh& mesh, const OriginalDistance& distance) {
  Quality found;
  for (const Four<Index>& quad : mesh.quads) {
    Quad corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.position(quad[i]);
    found.leastSine = std::min(found.leastSine, leastSine(corners));
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 out = corners[(i + 1) % 4] - corners[i], in = corners[(i + 3) % 4] - corners[i];
      found.meanCosine += std::abs(out.dot(in)) / (kTie + out.norm() * in.norm());
    }
  }
  found.meanCosine /= 4 * double(mesh.quads.size());
  found.distance = distance.farthest(mesh);
  return found;
}

// Of the finished quads: before, tips are lost in any map.
Quality finishedQuality(QuadMesh mesh, const Domain& domain, const OriginalDistance& distance) {
  finish(mesh, domain.part, domain.work);
  return qualityOf(mesh, distance);
}

bool isHardlyWorse(const Quality& one, const Quality& other) {
  return one.meanCosine <= kCornersWorse * other.meanCosine &&
         one.distance <= kFarther * other.distance &&
         one.leastSine >= std::min(other.leastSine, kSoundSine);
}

// Looks for a map of the same scale with other integers whose loops are clearly shorter, and whose
// quads are about as good in the end.
void closeLoops(Extracted& made, const Domain& domain, const MapMaker& maker, double vertices) {
  const double winding = windingOf(made.quads);
  if (made.faults > 0 || winding <= kWinding || maker.isSpent()) return;
  const std::size_t irregular = irregularCount(made.quads);
  SeamlessMap start;
  start.integers = made.integers;
  start.length = made.length;
  const double mapped = vertices - double(domain.simpler.added) - made.grown;
  const std::vector<Eigen::VectorXd> found = maker.withShorterLoops(start, mapped, kCountTolerance);
  std::optional<OriginalDistance> distance;
  std::optional<Quality> before;
  std::size_t finished = 0;
  for (std::size_t i = 0; i < std::min(found.size(), kMostClosed) && finished < kMostFinished;
       ++i) {
    const auto map = maker.mapOf(found[i], made.length);
    if (!map) continue;
    Extracted one = extracted(domain, *map);
    const bool isSame = one.lost == 0 && one.faults == 0;
    if (!isSame || irregularCount(one.quads) > irregular) continue;
    if (countError(double(one.quads.vertices.size()), vertices) > kCountTolerance) continue;
    if (windingOf(one.quads) >= kShorter * winding) continue;
    shape(one.quads, domain.part, domain.work);
    if (faultsOf(one.quads, domain.part) > 0 || irregularCount(one.quads) > irregular) continue;
    if (windingOf(one.quads) >= kShorter * winding) continue;
    if (!before) {
      distance.emplace(domain.part);
      before = finishedQuality(made.quads, domain, *distance);
    }
    ++finished;
    const Quality now = finishedQuality(one.quads, domain, *distance);
    if (!isHardlyWorse(now, *before)) continue;
    made = std::move(one);
    return;
  }
}

QuadMesh quadsOf(const Domain& domain, double vertices, SizeMaker& sizesOn) {
  const WorkingMesh &part = domain.part, &closed = domain.simpler.mesh;
  const WorkBudget& work = domain.work;
  const double length = std::sqrt(areaOf(part) / vertices);
  const FaceFrames frames(closed);
  const CrossField field = makeSmoothField(closed, frames, length, domain.work, domain.wishes);
  if (work.isSpent()) {
    fires("quads: no work left for a map");
    return {};
  }
  FaceData<double> sizes = sizesOn(closed), turned = crossSizes(closed, frames, field);
  for (Index f = 0; f < sizes.size(); ++f) turned[Face(f)] *= sizes[Face(f)];
  MapMaker maker(closed, field, scaledToMean(std::move(turned), closed));
  if (!maker.isPossible()) return {};
  const auto least = double(maker.singularCount() + domain.simpler.added);
  if (vertices > kFew && least > vertices) {
    fires("quads: more singular vertices than asked for");
    return {};
  }
  // Loops that are opened again are unsound at every scale, and mending them takes a second: one
  // map must do.
  const bool isTorn = closed.mesh().faceCount() > part.mesh().faceCount();
  std::optional<Extracted> found = searchScale(domain, maker, vertices, isTorn ? 1 : kSteps / 2);
  // Where curves are hardly farther apart than sides are long, larger quads have no room. A number
  // that is nearly met can be reached by whole rows.
  const auto isGood = [&](const Extracted& made) {
    const double count = double(made.quads.vertices.size());
    const bool isSound = isTorn || made.faults == 0;
    return isSound && countError(count, vertices) <= 2 * kCountTolerance;
  };
  if (!found || !isGood(*found)) {
    maker.setSizes(scaledToMean(std::move(sizes), closed));
    std::optional<Extracted> even = searchScale(domain, maker, vertices, kSteps);
    if (even && (!found || found->faults > 0 || isGood(*even) ||
                 costOf(*even, vertices) < costOf(*found, vertices)))
      found = std::move(even);
  }
  rewireLate(found, domain);
  if (found && domain.distance.quadsAway(found->quads) > kMostAway) {
    fires("quads: mended quads leave the surface");
    return {};
  }
  if (found && !isTorn && !work.isSpent()) {
    shortenLoops(*found, domain, maker, vertices);
    closeLoops(*found, domain, maker, vertices);
  }
  return found ? std::move(found->quads) : QuadMesh{};
}

}  // namespace

// A loop whose length rounds to four sides or fewer is a missing quad, and a handle as thin has no
// room for lines of quads along it. Near holes of two to four quads may become one in a map: where
// it fails, they are closed as well.
QuadMesh mapToQuads(const WorkingMesh& part, double vertices, SizeMaker& sizesOn, WorkBudget& work,
                    Tears tears, const FieldWishes& wishes) {
  const double side = std::sqrt(areaOf(part) / vertices), small = 4.5 * side;
  Index faces = 0;
  for (const double most : {small, 2 * small}) {
    Simpler simpler = withoutSmall(part, side, most);
    if (wishes.mirrors.planes.empty()) smoothBorders(simpler.mesh, side);
    const auto now = Index(simpler.mesh.mesh().faceCount());
    if (now == faces) break;
    faces = now;
    QuadMesh quads = quadsOf({part, simpler, tears, wishes, work}, vertices, sizesOn);
    if (!quads.quads.empty()) return quads;
  }
  return {};
}

}  // namespace remesher
