// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "remesh/quads/extract/extraction.h"
#include "remesh/quads/extract/holes.h"
#include "remesh/quads/extract/mending.h"
#include "remesh/quads/field/sectors.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/shape/chords.h"
#include "remesh/quads/shape/collapse.h"
#include "remesh/quads/shape/quad_tips.h"
#include "remesh/quads/shape/rewiring.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// The map's triangles have as many vertices as the quads, but no fewer than this: fields and maps
// need so many to be smooth.
constexpr std::size_t kLeastForMap = 5000;
// Opposite singular vertices nearer than this, in sides of quads, cancel each other.
constexpr double kCancelWithin = 1.5;
constexpr int kTries = 12;
constexpr double kCountTolerance = 0.01, kNudge = 0.0015;
// So many scales are corrected by the count of the last map; later ones lie aside of the best.
constexpr int kSteps = 4;
// A map with a larger count error is no result. With 0.1 fixed_top at 3000 goes to pairs at 6 of 7
// neighboring counts, not at 1; five other models are the same.
constexpr double kFarthest = 0.2;
constexpr int kSmoothings = 12;
// At most so many maps have their quads shaped and judged.
constexpr int kShaped = 4;

double areaOf(const WorkingMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    sum += area(a, b, c);
  }
  return sum;
}

void settle(QuadMesh& quads, const WorkingMesh& ground) {
  MovingQuads moving(quads, ground);
  const std::vector<char> isFixed(quads.vertices.size(), 0);
  smoothToSquares(moving, kSmoothings, isFixed);
  mendCorners(moving, isFixed);
}

void shape(QuadMesh& quads, const WorkingMesh& ground) {
  settle(quads, ground);
  rewire(quads, ground);
}

// Counts quads that fold or have hardly any area.
std::size_t countFaults(QuadMesh& quads, const WorkingMesh& ground) {
  const MovingQuads moving(quads, ground);
  std::size_t count = 0;
  for (Index q = 0; q < quads.quads.size(); ++q) count += moving.quality(q) < kLeastSine;
  return count;
}

CrossField fieldOn(const WorkingMesh& mesh, const FaceFrames& frames, double length) {
  CrossField field = makeCrossField(mesh, frames, length);
  cancelPairs(field, mesh, frames, kCancelWithin * length);
  return field;
}

// The quads of a map, if they are a surface of the mesh's kind.
struct Extracted {
  QuadMesh quads;
  std::size_t faults;  // curves that are not followed, and unsound quads
};
std::optional<Extracted> extracted(const WorkingMesh& part, const SeamlessMap& map) {
  QuadMesh quads = extractQuads(part, map);
  dropUnsound(quads);
  if (quads.quads.empty()) return {};
  fillHoles(quads, part);
  const std::size_t faults = followCurves(quads, part);
  removeDoublets(quads);
  fillDoublets(quads, part);
  collapseFlatCorners(quads, part);
  if (!check(quads).empty() || kindOf(quads) != kindOf(part.mesh())) return {};
  return Extracted{std::move(quads), faults};
}

// Adding rows costs nothing, while each removed quad leaves irregular vertices.
double countError(double count, double wanted) {
  // Too many vertices are so many times as bad as too few. Of five models at 7 neighboring counts
  // each, 2 leaves featuretype 208 irregular vertices instead of 188, 8 takes angle_block from 1.3
  // to 2.6 % in the worst.
  constexpr double kTooMany = 4;
  const double off = count / wanted - 1;
  return off > kCountTolerance ? kTooMany * off : std::abs(off);
}

// Whether a is the better result: by faults, then by the count.
bool isBetter(const Extracted& a, const std::optional<Extracted>& b, double wanted) {
  if (!b) return true;
  if (a.faults != b->faults) return a.faults < b->faults;
  return countError(double(a.quads.vertices.size()), wanted) <
         countError(double(b->quads.vertices.size()), wanted);
}

// Rounding makes another map at each scale, and counts come in steps: tries scales on both sides of
// the nearest one, ever farther away, until a map is good.
std::optional<Extracted> searchScale(const WorkingMesh& part, const MapMaker& maker, double length,
                                     double vertices) {
  std::optional<Extracted> best;
  double nearest = length, least = kFarthest;
  int shaped = 0;
  for (int i = 0; i < kTries && shaped < kShaped && (!best || best->faults > 0); ++i) {
    const bool isFirst = i < kSteps;
    const double aside = 1 + kNudge * (i % 2 == 0 ? i - kSteps : kSteps - i);
    const double scale = isFirst ? length : nearest * aside;
    const SeamlessMap map = maker.map(scale);
    const double count = maker.countVertices(map), error = countError(count, vertices);
    if (error < least) {
      least = error;
      nearest = scale;
    }
    length *= std::sqrt(std::clamp(count / vertices, 0.25, 4.0));
    if (error >= (isFirst ? kCountTolerance : kFarthest)) continue;
    std::optional<Extracted> made = extracted(part, map);
    if (!made || countError(double(made->quads.vertices.size()), vertices) >= kFarthest) continue;
    shape(made->quads, part);
    made->faults += countFaults(made->quads, part);
    ++shaped;
    if (isBetter(*made, best, vertices)) best = std::move(made);
  }
  return best;
}

// Brings the count to the goal, or as near as allowed. Adding whole rows of quads makes no vertex
// irregular; removing single quads does.
void matchCount(MadeQuads& made, const QuadGoal& goal, const WorkingMesh& ground) {
  const double slack = goal.isExact ? 0 : kCountTolerance;
  const auto most = std::size_t(double(goal.vertices) * (1 + slack));
  const auto least = std::size_t(std::ceil(double(goal.vertices) * (1 - slack)));
  QuadMesh& mesh = made.mesh;
  const std::size_t before = mesh.vertices.size();
  if (before < least) divideChords(mesh, ground, goal.vertices);
  if (mesh.vertices.size() < least) divideShortestChord(mesh, ground, least - mesh.vertices.size());
  // Leaves room for vertices that rewiring may add.
  const std::size_t enough = mesh.vertices.size() > most ? (goal.vertices + most) / 2 : most;
  made.collapsed = collapseTo(mesh, ground, {std::max<std::size_t>(enough, 8), goal.isExact});
  if (mesh.vertices.size() == before && made.collapsed == 0) return;
  settle(mesh, ground);
  const std::size_t faults = countFaults(mesh, ground);
  if (faults == 0) return;
  MadeQuads rewired = made;
  rewire(rewired.mesh, ground);
  rewired.collapsed += collapseTo(rewired.mesh, ground, {std::max<std::size_t>(most, 8), false});
  settle(rewired.mesh, ground);
  const std::size_t count = rewired.mesh.vertices.size();
  if (count < least || count > most) return;
  if (countFaults(rewired.mesh, ground) < faults) made = std::move(rewired);
}

// The share of a part in the vertices, by area.
struct PartShare {
  Index number;  // of the original's connected part below
  double vertices;
};

std::vector<PartShare> sharesOf(const std::vector<WorkingMesh>& parts, double vertices) {
  const FaceData<Index> numbers = partNumbers(parts.front().surface().mesh());
  double whole = 0;
  for (const WorkingMesh& part : parts) whole += areaOf(part);
  std::vector<PartShare> shares;
  for (const WorkingMesh& part : parts)
    shares.push_back({numbers[part.at(Vertex(0)).face], vertices * areaOf(part) / whole});
  return shares;
}

// Quads by pairs, for the parts with these numbers. The number of vertices depends on how many
// triangles stay single, so that a second mesh has the right number.
QuadMesh pairParts(const std::vector<PartShare>& wanted, std::size_t vertices,
                   const TriangleMaker& triangles) {
  double share = 0;
  for (const PartShare& one : wanted) share += one.vertices;
  std::size_t coarse = std::max<std::size_t>(vertices / 4, 4);
  QuadMesh quads;
  for (int i = 0; i < 3; ++i) {
    WorkingMesh mesh = triangles(coarse);
    openSectors(mesh);
    const FaceData<Index> numbers = partNumbers(mesh.surface().mesh());
    quads = {};
    for (const WorkingMesh& part : connectedParts(mesh)) {
      const Index number = numbers[part.at(Vertex(0)).face];
      const auto isIt = [&](const PartShare& one) { return one.number == number; };
      const auto found = std::find_if(wanted.begin(), wanted.end(), isIt);
      if (found == wanted.end()) continue;
      append(quads, pairToQuads(part, std::sqrt(areaOf(part) / found->vertices)));
    }
    if (std::abs(double(quads.vertices.size()) / share - 1) <= kCountTolerance / 2) break;
    const double factor = share / double(quads.vertices.size());
    const auto next = std::size_t(std::max(4.0, std::round(double(coarse) * factor)));
    if (next == coarse) break;
    coarse = next;
  }
  return quads;
}

}  // namespace

QuadMesh mapToQuads(const WorkingMesh& part, double vertices) {
  const FaceFrames frames(part);
  const double length = std::sqrt(areaOf(part) / vertices);
  const CrossField field = fieldOn(part, frames, length);
  const MapMaker maker(part, field);
  if (!maker.isPossible()) return {};
  std::optional<Extracted> found = searchScale(part, maker, length, vertices);
  if (!found) return {};
  return std::move(found->quads);
}

QuadMesh pairToQuads(const WorkingMesh& mesh, double length) {
  const FaceFrames frames(mesh);
  const CrossField field = fieldOn(mesh, frames, length);
  QuadMesh quads = splitPairs(mesh, pairTriangles(mesh, frames, field));
  shape(quads, mesh);
  return quads;
}

MadeQuads makeQuads(const QuadGoal& goal, const TriangleMaker& triangles) {
  WorkingMesh base = triangles(std::max(goal.vertices, kLeastForMap));
  openSectors(base);
  const std::vector<WorkingMesh> parts = connectedParts(base);
  const auto made = [&](double share) {
    const double vertices = share * double(goal.vertices);
    const std::vector<PartShare> shares = sharesOf(parts, vertices);
    MadeQuads result{{}, parts.size(), 0};
    std::vector<PartShare> failed;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const QuadMesh quads = mapToQuads(parts[i], shares[i].vertices);
      quads.quads.empty() ? failed.push_back(shares[i]) : append(result.mesh, quads);
    }
    result.paired = failed.size();
    if (!failed.empty())
      append(result.mesh, pairParts(failed, std::size_t(std::ceil(vertices)), triangles));
    matchCount(result, goal, base);
    reachTips(result.mesh, base, kSmoothings);
    return result;
  };
  if (!goal.isExact) return made(1);
  // Tries a slightly smaller count first, to which rows are added; if that does not do, a slightly
  // larger one, from which quads are removed.
  MadeQuads fromBelow = made(1 - kCountTolerance);
  if (fromBelow.collapsed == 0 && fromBelow.mesh.vertices.size() == goal.vertices) return fromBelow;
  MadeQuads fromAbove = made(1 + kCountTolerance);
  const auto order = [&](const MadeQuads& one) {
    return std::tuple(one.mesh.vertices.size() != goal.vertices, one.paired, one.collapsed);
  };
  return order(fromAbove) < order(fromBelow) ? fromAbove : fromBelow;
}

}  // namespace remesher
