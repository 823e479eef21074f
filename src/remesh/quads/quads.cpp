// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/fires.h"
#include "mesh/topology.h"
#include "remesh/quads/base_meshes.h"
#include "remesh/quads/counting.h"
#include "remesh/quads/field/sectors.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/mesh/quad_distance.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/pair/box_quads.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/shape/curve_lengths.h"
#include "remesh/quads/shape/finish.h"
#include "remesh/quads/shape/plane_sides.h"

namespace remesher {

namespace {

// The map's triangles have so many vertices per vertex of the quads.
constexpr double kOfQuads = 0.7;
// But no fewer than this: fields and maps need so many to be smooth.
constexpr std::size_t kLeastForMap = 5000;
// And no more than so many per vertex of the quads, so that work stays in proportion: of few quads
// each has a hundred triangles then.
constexpr std::size_t kMostForMap = 50;
// Of one of many parts: together they take hardly more than a whole.
constexpr std::size_t kMostForPart = 12;
// A part that is not the last may miss its share by this much before single quads go: the parts
// after it make up for it.
constexpr double kFreeOfPart = 0.25;
// The work on the quads of a run: many times as much as models need of which maps can be made.
// Where pieces and handles of a soup make many times the quads asked for, hardly any work mends
// them. A part has its share of it, and a little for each vertex asked for, so that a small one is
// done as well.
constexpr double kWorkOfRun = 1e7, kWorkPerVertex = 2000;
constexpr double kWorkOfFew = 5e5, kWorkOfFewPerVertex = 5e4, kMostWorkOfFew = 3e6;

// Few vertices are finished at each number that is tried, and taken by their distance. In sides:
// nearer quads are near, those farther away have lost a part of the shape.
constexpr double kNearQuads = 0.3, kLostQuads = 0.6;

// The share of a part in the vertices, by area or, where triangles are graded, by their number.
struct PartShare {
  std::size_t part;  // of the first mesh's
  Index number;      // of the original's connected part below
  double vertices;
};

std::vector<PartShare> sharesOf(const std::vector<WorkingMesh>& parts, double vertices,
                                bool isGraded) {
  const FaceData<Index> numbers = partNumbers(parts.front().surface().mesh());
  const auto weightOf = [&](const WorkingMesh& part) {
    return isGraded ? double(part.mesh().faceCount()) : areaOf(part);
  };
  double whole = 0;
  for (const WorkingMesh& part : parts) whole += weightOf(part);
  std::vector<PartShare> shares;
  for (std::size_t i = 0; i < parts.size(); ++i)
    shares.push_back(
        {i, numbers[parts[i].at(Vertex(0)).face], vertices * weightOf(parts[i]) / whole});
  return shares;
}

// The vertices that a mesh gets of the whole's, if all quads are squares of one size: of those on
// planes a half only is its own.
double ownVertices(const WorkingMesh& mesh, const QuadGoal& goal) {
  const auto images = double(std::size_t{1} << goal.mirrors.planes.size());
  const double length = std::sqrt(images * areaOf(mesh) / double(goal.vertices));
  const auto isOn = [&](Vertex v, const MirrorPlane& plane) {
    return std::abs(plane.distance(mesh.position(v))) <= goal.mirrors.slack;
  };
  double onPlanes = 0;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Vertex a = mesh.mesh().origin(Halfedge(i)), b = mesh.mesh().tip(Halfedge(i));
    for (const MirrorPlane& plane : goal.mirrors.planes)
      if (mesh.mesh().isBoundary(Halfedge(i)) && isOn(a, plane) && isOn(b, plane))
        onPlanes += (mesh.position(b) - mesh.position(a)).norm() / length;
  }
  return double(goal.vertices) / images + onPlanes / 2;
}

// The meshes that maps of a part are tried on, from `level` on, and then again with torn borders
// closed.
struct MapStart {
  std::size_t level = 0;
  Tears tears = Tears::Refused;
};

// The quads of a part, mapped on the first mesh that has a map; no quads if no mesh has one.
// `start` becomes the one used, or the last one tried.
QuadMesh mapOn(BaseMeshes& bases, MapStart& start, const PartShare& share, const QuadGoal& goal,
               WorkBudget& work) {
  SizeMaker& sizes = goal.isGraded ? gradedSizes : evenSizes;
  for (;;) {
    bool isOpen = false;
    while (const WorkingMesh* part = bases.part(start.level, share.number)) {
      QuadMesh quads =
          mapToQuads(*part, share.vertices, sizes, work, start.tears, {goal.guides, goal.mirrors});
      if (!quads.quads.empty()) return quads;
      isOpen = isOpen || boundaryLoopCount(part->mesh()) > 0;
      ++start.level;
      if (work.isSpent()) break;
    }
    if (start.tears == Tears::Closed || !isOpen || work.isSpent()) break;
    start = {0, Tears::Closed};
  }
  if (start.level > 0) --start.level;
  return {};
}

QuadMesh pairsOf(const WorkingMesh& mesh, double length, WorkBudget& work,
                 std::span<const Guide> guides = {}) {
  const FaceFrames frames(mesh);
  const CrossField field = makeSmoothField(mesh, frames, length, work, {guides});
  return splitPairs(mesh, pairTriangles(mesh, frames, field));
}

// A part of more vertices that has no map is hardly like a box; nor is one that the sides of the
// box leave by more than this, in sides of quads.
constexpr double kMostOfBox = 64, kFarBox = 1.1;

// As many vertices as a triangle has that is divided into quads at its middle.
constexpr std::size_t kFewestOfPairs = 7;

void appendPairs(MadeQuads& made, const QuadMesh& pairs) {
  if (!pairs.quads.empty())
    made.paired.push_back({pairs.position(pairs.quads.front()[0]), pairs.quads.size()});
  append(made.mesh, pairs);
}

// Makes quads by pairs, not yet shaped, of the parts that get too few vertices for fewer triangles
// to do; they leave the shares. What they take beyond theirs is taken from the others' shares.
MadeQuads pairTiny(std::vector<PartShare>& shares, const std::vector<WorkingMesh>& parts,
                   WorkBudget& work) {
  MadeQuads quads{{}, parts.size()};
  std::vector<PartShare> others;
  double whole = 0, left = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    whole += shares[i].vertices;
    const bool isTiny =
        shares[i].vertices < kFewestOfPairs && parts[i].mesh().vertexCount() <= kFewestOfPairs;
    if (isTiny) {
      appendPairs(quads, pairsOf(parts[i], std::sqrt(areaOf(parts[i]) / shares[i].vertices), work));
      continue;
    }
    left += shares[i].vertices;
    others.push_back(shares[i]);
  }
  const double rest = std::max(whole - double(quads.mesh.vertices.size()), left / 2);
  for (PartShare& share : others) share.vertices *= rest / left;
  shares = std::move(others);
  return quads;
}

// Makes quads by pairs, not yet shaped, for the parts with these numbers. How many triangles stay
// single is not known before: so the number of triangles is corrected, up to three meshes in all.
MadeQuads pairParts(const std::vector<PartShare>& wanted, std::size_t vertices,
                    const TriangleMaker& triangles, const QuadGoal& goal, WorkBudget& work) {
  double share = 0;
  for (const PartShare& one : wanted) share += one.vertices;
  std::size_t coarse = std::max<std::size_t>(vertices / 4, 4);
  MadeQuads quads;
  for (int i = 0; i < 3; ++i) {
    WorkingMesh mesh = triangles(coarse);
    openSectors(mesh, goal.mirrors);
    const FaceData<Index> numbers = partNumbers(mesh.surface().mesh());
    quads = {};
    for (const WorkingMesh& part : connectedParts(mesh)) {
      const Index number = numbers[part.at(Vertex(0)).face];
      const auto isIt = [&](const PartShare& one) { return one.number == number; };
      const auto found = std::find_if(wanted.begin(), wanted.end(), isIt);
      if (found == wanted.end()) continue;
      appendPairs(quads,
                  pairsOf(part, std::sqrt(areaOf(part) / found->vertices), work, goal.guides));
    }
    const auto count = double(quads.mesh.vertices.size());
    if (std::abs(count / share - 1) <= kCountTolerance / 2) break;
    const double factor = share / count;
    const auto next = std::size_t(std::max(4.0, std::round(double(coarse) * factor)));
    if (next == coarse) break;
    coarse = next;
  }
  return quads;
}

// The sides of a box, shaped, if they are sound and near; only of few vertices.
QuadMesh boxed(const WorkingMesh& part, double vertices, WorkBudget& work) {
  if (vertices > kMostOfBox) return {};
  QuadMesh box = boxQuads(part, vertices);
  if (box.quads.empty()) return {};
  shape(box, part, work);
  const bool isGood = faultsOf(box, part) == 0 && QuadDistance(part).sidesAway(box) <= kFarBox;
  return isGood ? std::move(box) : QuadMesh{};
}

// The quads of a whole, part by part.
class QuadMaking {
 public:
  QuadMaking(const QuadGoal& goal, const TriangleMaker& triangles)
      : goal_(goal),
        triangles_(triangles),
        work_(budgetOf(goal)),
        bases_(triangles, firstCount(goal), goal.vertices >> goal.mirrors.planes.size(),
               goal.mirrors),
        expected_(ownVertices(bases_.first(), goal)),
        starts_(bases_.parts().size()) {}

  // An exact number is reached by adding rows to a slightly smaller one, else by removing quads
  // from a slightly larger one. Of a half fewer numbers can be had: rows are added to several.
  MadeQuads run() {
    std::vector<double> shares = {1};
    if (goal_.isExact) shares = {1 - kCountTolerance, 1 + kCountTolerance};
    const bool isHalf = !goal_.mirrors.planes.empty();
    for (int i = 1; i < 4 && isHalf; ++i) shares.push_back(1 - 3 * i * kCountTolerance);
    // Where rows are too long to be added, a larger number can be lessened quad by quad.
    const double above = 1 + 2 * kCountTolerance;
    if (!isHalf) shares.push_back(above);
    const std::size_t usual = shares.size();
    // Few quads may lose a part of the shape at one number, and keep it at the next ones.
    if (goal_.vertices <= kFewToFinish && !goal_.isExact)
      for (const int step : {-2, 3, -4, 4}) shares.push_back(1 + step * kCountTolerance);
    std::optional<MadeQuads> best;
    bool isCompleted = false;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double share = shares[i];
      if (best && work_.isSpent()) {
        fires("quads: no work left for more numbers");
        break;
      }
      if (i >= usual && best->away < kLostQuads) break;
      // A part without a map at one share has none at others. The whole may, where its half has
      // none.
      const bool isLast = best && share == above && goal_.isExact;
      const bool isMet = best && missedBy(*best) <= (goal_.isExact ? 0 : kCountTolerance) &&
                         best->away < kLostQuads;
      if (isMet && (isLast || !best->paired.empty() || best->collapsed == 0)) break;
      if (best && !best->paired.empty() &&
          (share == above || (isHalf && best->paired.size() == best->parts)))
        break;
      MadeQuads one = made(share);
      const bool isFew = areFew(one);
      if (isFew) {
        complete(one);
        one.away = QuadDistance(bases_.first()).sidesAway(one.mesh, kNearQuads);
      }
      if (best && !(lackOf(one) < lackOf(*best))) continue;
      best = std::move(one);
      isCompleted = isFew;
    }
    if (!isCompleted) complete(*best);
    return std::move(*best);
  }

 private:
  struct Mapped {
    PartShare share;
    QuadMesh quads;
  };

  static WorkBudget budgetOf(const QuadGoal& goal) {
    const auto vertices = double(goal.vertices);
    const double own = goal.share * kWorkOfRun + kWorkPerVertex * vertices;
    const double few = std::min(kWorkOfFew + kWorkOfFewPerVertex * vertices, kMostWorkOfFew);
    return WorkBudget(goal.isPart ? own + few : own);
  }

  static std::size_t firstCount(const QuadGoal& goal) {
    const std::size_t dense = goal.vertices >> goal.mirrors.planes.size();
    const std::size_t least = std::min(kLeastForMap >> goal.mirrors.planes.size(),
                                       (goal.isPart ? kMostForPart : kMostForMap) * dense);
    return std::max(std::size_t(double(dense) * (goal.isDraft ? 0.5 : kOfQuads)), least);
  }

  // Surfaces of many handles get far more quads than were asked for.
  bool areFew(const MadeQuads& made) const {
    return goal_.vertices <= kFewToFinish && made.mesh.vertices.size() <= 2 * kFewToFinish;
  }

  void complete(MadeQuads& made) {
    if (goal_.isForced && partFromImages(made.mesh, goal_.mirrors, bases_.first()) > 0)
      settle(made.mesh, bases_.first());
    if (!goal_.isGraded) keepCurveLengths(made.mesh, bases_.first());
    if (goal_.isDraft) return;
    finish(made.mesh, bases_.first(), work_);
    turnBack(made.mesh, bases_.first(), work_);
  }

  // The share by which the number is missed.
  double missedBy(const MadeQuads& made) const {
    const auto count = double(wholeCount(made.mesh, goal_.mirrors));
    return std::abs(count / double(goal_.vertices) - 1);
  }

  // A number that is too far off is worse than any pairs, these than a lost part of the shape, this
  // than any number of quads taken out, these than a number that is nearly met, and this than a
  // distance.
  std::array<double, 6> lackOf(const MadeQuads& made) const {
    const double missed = missedBy(made);
    const bool isFar = missed > (goal_.isExact ? 0 : kFreeTolerance);
    return {
        double(isFar),          double(made.paired.size()),        std::max(made.away, kLostQuads),
        double(made.collapsed), std::max(missed, kCountTolerance), made.away};
  }

  // Parts that get too few vertices for a map, and those that have none, come first: how many
  // vertices their pairs take is known only then, and the others share the rest.
  MadeQuads made(double share) {
    std::vector<PartShare> shares = sharesOf(bases_.parts(), share * expected_, goal_.isGraded);
    MadeQuads result = pairTiny(shares, bases_.parts(), work_);
    shape(result.mesh, bases_.first(), work_);
    std::vector<PartShare> failed;
    std::vector<Mapped> mapped;
    for (const PartShare& one : shares) {
      QuadMesh quads = mapOn(bases_, starts_[one.part], one, goal_, work_);
      QuadMesh box;
      if (quads.quads.empty() || faultsOf(quads, bases_.first()) > 0)
        box = boxed(bases_.parts()[one.part], one.vertices, work_);
      if (!box.quads.empty())
        append(result.mesh, box);
      else if (!quads.quads.empty())
        mapped.push_back({one, std::move(quads)});
      else
        failed.push_back(one);
    }
    if (!failed.empty()) {
      const auto vertices = std::size_t(std::ceil(share * expected_));
      MadeQuads pairs = pairParts(failed, vertices, triangles_, goal_, work_);
      shape(pairs.mesh, bases_.first(), work_);
      append(result.mesh, pairs.mesh);
      result.paired.insert(result.paired.end(), pairs.paired.begin(), pairs.paired.end());
    }
    if (mapped.empty()) {
      const CountGoal count{goal_.vertices, goal_.isExact, goal_.mirrors, 0};
      result.collapsed = matchCount(result.mesh, count, bases_.first(), work_);
    }
    addMapped(result, std::move(mapped), share);
    return result;
  }

  // Each part is brought to its own share of the vertices that are left, the smallest first: where
  // a part misses its share, the larger ones make up for it, in which rows are a smaller step.
  void addMapped(MadeQuads& result, std::vector<Mapped> mapped, double share) {
    const auto isLess = [](const Mapped& a, const Mapped& b) {
      return a.share.vertices < b.share.vertices;
    };
    std::stable_sort(mapped.begin(), mapped.end(), isLess);
    double rest = 0;
    for (const Mapped& one : mapped) rest += one.share.vertices;
    for (Mapped& one : mapped) {
      const double part = one.share.vertices / rest, own = one.share.vertices;
      rest -= own;
      const bool isLast = &one == &mapped.back();
      const double fair = own / (share * expected_) * double(goal_.vertices);
      const double left = double(goal_.vertices) - double(wholeCount(result.mesh, goal_.mirrors));
      const double whole = std::max(left * part, fair / 2);
      if (std::abs(whole / fair - 1) > kCountTolerance / 2) {
        one.share.vertices = own * whole / fair;
        QuadMesh again = mapOn(bases_, starts_[one.share.part], one.share, goal_, work_);
        if (!again.quads.empty()) one.quads = std::move(again);
      }
      const CountGoal count{std::size_t(std::lround(whole)), goal_.isExact && isLast, goal_.mirrors,
                            isLast ? kFreeTolerance : kFreeOfPart};
      result.collapsed += matchCount(one.quads, count, bases_.first(), work_);
      append(result.mesh, one.quads);
    }
  }

  const QuadGoal& goal_;
  const TriangleMaker& triangles_;
  WorkBudget work_;
  BaseMeshes bases_;
  const double expected_;         // vertices of the mesh itself, which may be a half
  std::vector<MapStart> starts_;  // of each part: the mesh that its map is made on
};

}  // namespace

std::size_t wholeCount(const QuadMesh& mesh, const Mirrors& mirrors) {
  std::size_t sum = 0;
  for (const Placement& place : mesh.vertices) {
    std::size_t images = std::size_t{1} << mirrors.planes.size();
    if (place.kind != VertexKind::Interior)
      for (const MirrorPlane& plane : mirrors.planes)
        if (std::abs(plane.distance(place.position)) <= mirrors.slack) images /= 2;
    sum += images;
  }
  return sum;
}

MadeQuads makeQuads(const QuadGoal& goal, const TriangleMaker& triangles) {
  return QuadMaking(goal, triangles).run();
}

}  // namespace remesher
