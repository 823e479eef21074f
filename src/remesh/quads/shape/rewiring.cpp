// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/rewiring.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include "base/fires.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/shape/mending.h"
#include "remesh/quads/shape/quad_patch.h"
#include "remesh/quads/shape/side_places.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// So many quads are tried, and one more for each kQuadsPerTry of the mesh: a try takes as long as
// hundreds of sound quads do. Meshes of this many faults come of curves nearer to each other than
// sides are long, and stay unsound.
constexpr std::size_t kMostTried = 80, kQuadsPerTry = 50;
// Of the many wirings that change quads beside the bad one, these are mended: those with the least
// faults before.
constexpr std::size_t kMended = 28;

// How much the quads lack to be sound, as squares over what they have, for several narrow quads are
// better than one without area; and how irregular they are.
struct Fault {
  double missing = 0;
  int irregular = 0;
  // A small gain is not worth another irregular vertex; without small gains the rounds end.
  bool isClearlyBelow(const Fault& other) const { return missing < other.missing - 0.05; }
  double cost() const { return missing + 0.1 * irregular; }
};

Fault faultOf(const MovingQuads& quads, const QuadPatch& patch) {
  Fault fault;
  for (Index q = 0; q < patch.mesh.quads.size(); ++q) {
    const double share = quads.quality(q) / kLeastSine, missing = std::max(0.0, 1 - share);
    fault.missing += missing * missing / std::max(share, 0.1);
  }
  for (Index v = 0; v < patch.isRim.size(); ++v)
    if (!patch.isRim[v] && !quads.sides().isBoundary(v))
      fault.irregular += std::abs(quads.sides().valence(v) - 4);
  return fault;
}

// Turns the edge of a side by one corner of the hexagon around it, either way.
std::optional<QuadPatch> turned(const QuadPatch& patch, const QuadSides& sides, Index side,
                                bool isLeft) {
  const Index other = sides.across(side);
  if (other == kNone || patch.mesh.curves[side / 4][side % 4] != kNone) return {};
  // Sides around the hexagon, from the tip of the edge on.
  const std::array<Index, 6> around = {nextSide(side),  nextSide(nextSide(side)),  prevSide(side),
                                       nextSide(other), nextSide(nextSide(other)), prevSide(other)};
  QuadPatch result = patch;
  const std::size_t first = isLeft ? 1 : 2;
  for (const std::size_t half : {0, 1}) {
    const Index quad = (half == 0 ? side : other) / 4;
    for (std::size_t i = 0; i < 4; ++i) {
      const Index from = around[(first + 3 * half + i) % 6];
      result.mesh.quads[quad][i] = sides.origin(from);
      result.mesh.curves[quad][i] = i == 3 ? kNone : patch.mesh.curves[from / 4][from % 4];
    }
  }
  return result;
}

// Merges the corner that a side leaves with the opposite corner.
std::optional<QuadPatch> collapsed(const QuadPatch& patch, const QuadSides& sides, Index side,
                                   const WorkingMesh& ground) {
  Index a = sides.origin(side), c = sides.tip(nextSide(side));
  const auto isFree = [&](Index v) {
    return !patch.isRim[v] && patch.mesh.vertices[v].kind == VertexKind::Interior;
  };
  if (isFree(a)) std::swap(a, c);
  if (!isFree(c)) return {};
  QuadPatch result = patch;
  QuadMesh& mesh = result.mesh;
  for (const Index one : {side, nextSide(nextSide(side))}) {
    const Index two = one == side ? nextSide(side) : prevSide(side);
    const Index x = sides.across(one), y = sides.across(two);
    if (x == kNone || y == kNone) return {};
    Index &curveX = mesh.curves[x / 4][x % 4], &curveY = mesh.curves[y / 4][y % 4];
    if (curveX != kNone && curveY != kNone) return {};
    if (curveX == kNone) curveX = curveY;
    curveY = curveX;
  }
  const Placement &from = patch.mesh.vertices[c], &to = patch.mesh.vertices[a];
  if (isFree(a))
    mesh.vertices[a] = ground.onSurface(
        closestPointFrom(ground.surface(), to.at, (from.position + to.position) / 2));
  for (Four<Index>& quad : mesh.quads) std::replace(quad.begin(), quad.end(), c, a);
  std::vector<char> isGone(mesh.quads.size(), 0);
  isGone[side / 4] = 1;
  dropQuads(mesh, isGone);
  return result;
}

// Puts a smaller quad into the quad, and four around it.
void fill(QuadMesh& mesh, Index quad, const WorkingMesh& ground) {
  Vec3 middle = Vec3::Zero();
  for (const Index v : mesh.quads[quad]) middle += mesh.position(v) / 4;
  shrink(mesh, quad, placeWithin(mesh, quad, middle, ground).at, ground);
}

QuadPatch filled(QuadPatch patch, Index quad, const WorkingMesh& ground) {
  fill(patch.mesh, quad, ground);
  patch.outer.resize(patch.mesh.vertices.size(), kNone);
  patch.isRim.resize(patch.mesh.vertices.size(), 0);
  return patch;
}

// With `facing` only those that face away.
std::vector<Index> unsoundOf(QuadMesh& mesh, const WorkingMesh& ground, const QuadFacing* facing) {
  const MovingQuads moving(mesh, ground);
  std::vector<Index> found;
  for (Index q = 0; q < mesh.quads.size(); ++q)
    if (facing ? facing->isAway(moving.corners(q)) : moving.quality(q) < kLeastSine)
      found.push_back(q);
  return found;
}

class Rewiring {
 public:
  Rewiring(const QuadPatch& patch, const WorkingMesh& ground, WorkBudget& work,
           const QuadFacing* facing)
      : ground_(ground),
        work_(work),
        facing_(facing),
        sides_(patch.mesh.vertices.size(), patch.mesh.quads),
        kind_(kindOf(patch.mesh)),
        start_(patch) {}

  // The best wiring found for the patch, if it is clearly better. The bad quad is the first one;
  // quads beside it may change too, or the two quads at an edge of it that was turned before.
  std::optional<QuadPatch> run() {
    mend(start_, before_ = faultOfStart());
    consider(filled(start_, 0, ground_));
    mergeIn(start_, sides_, 0);
    turnAround(0);
    mendAll();
    if (isMended()) return std::move(best_);
    std::set<Index> beside;
    for (Index i = 0; i < 4; ++i)
      if (sides_.across(i) != kNone) beside.insert(sides_.across(i) / 4);
    for (const Index quad : beside) {
      mergeIn(start_, sides_, quad);
      turnAround(quad);
    }
    mendBest();
    if (isMended()) return std::move(best_);
    changeTwice();
    mendBest();
    return std::move(best_);
  }

 private:
  // Whether no quad is left without area, or nearly.
  bool isMended() const { return best_ && least_.missing < 0.5; }

  void mergeIn(const QuadPatch& patch, const QuadSides& sides, Index quad) {
    for (Index i = 0; i < 2; ++i) consider(collapsed(patch, sides, sideOf(quad, i), ground_));
  }

  void turnAround(Index quad) {
    for (Index i = 0; i < 4; ++i)
      for (const bool isLeft : {false, true})
        consider(turned(start_, sides_, sideOf(quad, i), isLeft));
  }

  void changeTwice() {
    for (Index side = 0; side < 4; ++side)
      for (const bool isLeft : {false, true}) {
        const std::optional<QuadPatch> once = turned(start_, sides_, side, isLeft);
        if (!once || !isSound(*once)) continue;
        const QuadSides sides(once->mesh.vertices.size(), once->mesh.quads);
        for (const Index quad : {Index(0), sides_.across(side) / 4}) {
          consider(filled(*once, quad, ground_));
          mergeIn(*once, sides, quad);
        }
      }
  }

  bool isSound(const QuadPatch& patch) const {
    return check(patch.mesh).empty() && kindOf(patch.mesh) == kind_;
  }

  // A wiring, and its faults before its vertices have moved.
  struct Candidate {
    QuadPatch patch;
    Fault unmended;
  };

  Fault faultOfStart() const {
    QuadPatch copy = start_;
    return faultOf(MovingQuads(copy.mesh, ground_, facing_), copy);
  }

  void consider(std::optional<QuadPatch> patch) {
    if (!patch) return;
    removeDoublets(patch->mesh);
    patch->dropUnusedVertices();
    if (!isSound(*patch)) return;
    work_.spend(double(patch->mesh.quads.size()));
    const Fault unmended = faultOf(MovingQuads(patch->mesh, ground_, facing_), *patch);
    waiting_.push_back({std::move(*patch), unmended});
  }

  void mendAll() {
    for (Candidate& one : waiting_) mend(std::move(one.patch), one.unmended);
    waiting_.clear();
  }

  void mendBest() {
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const Candidate& a, const Candidate& b) {
      return a.unmended.cost() < b.unmended.cost();
    });
    if (waiting_.size() > kMended) waiting_.erase(waiting_.begin() + kMended, waiting_.end());
    mendAll();
  }

  void mend(QuadPatch patch, const Fault& unmended) {
    if (best_ && least_.cost() <= 0.1 * unmended.irregular) return;
    MovingQuads quads(patch.mesh, ground_, facing_);
    work_.spend(double(mendCorners(quads, patch.isRim)));
    const Fault fault = faultOf(quads, patch);
    if (!fault.isClearlyBelow(before_)) return;
    if (best_ && fault.cost() >= least_.cost()) return;
    least_ = fault;
    best_ = std::move(patch);
  }

  const WorkingMesh& ground_;
  WorkBudget& work_;
  const QuadFacing* facing_;
  const QuadSides sides_;
  const SurfaceKind kind_;
  const QuadPatch& start_;
  std::vector<Candidate> waiting_;
  std::optional<QuadPatch> best_;
  Fault before_, least_;
};

}  // namespace

std::size_t mostRewired(const QuadMesh& mesh) {
  return kMostTried + mesh.quads.size() / kQuadsPerTry;
}

void rewire(QuadMesh& mesh, const WorkingMesh& ground, WorkBudget& work, const QuadFacing* facing) {
  const std::size_t most = mostRewired(mesh);
  std::set<Four<Index>> tried;
  for (bool isDone = false; !isDone;) {
    isDone = true;
    const std::vector<Four<Index>> quads = mesh.quads;
    const QuadSides sides(mesh.vertices.size(), quads);
    std::vector<char> isChanged(quads.size(), 0);
    std::vector<QuadPatch> better;
    for (const Index q : unsoundOf(mesh, ground, facing)) {
      if (tried.contains(quads[q])) continue;
      if (tried.size() == most || work.isSpent()) {
        fires("quads: rewiring ends early");
        break;
      }
      const std::vector<Index> near = quadsNear(sides, mesh, q);
      if (std::any_of(near.begin(), near.end(), [&](Index n) { return isChanged[n]; })) continue;
      tried.insert(quads[q]);
      std::optional<QuadPatch> found =
          Rewiring(patchOf(mesh, sides, near), ground, work, facing).run();
      if (!found) continue;
      for (const Index n : near) isChanged[n] = 1;
      better.push_back(std::move(*found));
      isDone = false;
    }
    dropQuads(mesh, isChanged);
    for (const QuadPatch& patch : better) putBack(mesh, patch);
  }
  dropUnusedVertices(mesh);
}

void fillDoublets(QuadMesh& mesh, const WorkingMesh& ground) {
  const std::vector<Four<Index>> quads = mesh.quads;
  const QuadSides sides(mesh.vertices.size(), quads);
  if (!sides.isManifold()) return;
  std::vector<char> isFilled(quads.size(), 0);
  for (Index v = 0; v < sides.vertexCount(); ++v) {
    if (sides.isBoundary(v) || sides.valence(v) != 2) continue;
    const Index one = sides.outgoing(v) / 4, two = sides.across(sides.outgoing(v)) / 4;
    if (isFilled[one] || isFilled[two]) continue;
    isFilled[one] = 1;
    fill(mesh, one, ground);
  }
}

}  // namespace remesher
