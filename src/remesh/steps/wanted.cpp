// SPDX-License-Identifier: MIT
#include "remesh/steps/wanted.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/fires.h"
#include "geometry/pattern_search.h"
#include "geometry/triangle.h"
#include "remesh/gate/angles.h"
#include "remesh/gate/sharp_tips.h"
#include "remesh/operators/shift.h"
#include "remesh/operators/smoothing.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/local_search.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

// Rounds over all that is not as wanted, and changes in a row around one triangle.
constexpr int kRoundsForWanted = 12, kChangesInARow = 8;
// The most triangles that are looked at, in triangles of the mesh.
constexpr std::size_t kLooksPerTriangle = 4;
// How far a change may move the surface, in target edge lengths.
constexpr double kMostMoved = 1;
// If more than one vertex in so many is new, flips follow.
constexpr std::size_t kManySplits = 20;
// The weight of angles where no limit of them is asked for: lengths are not to be kept by slivers.
constexpr double kUnasked = 0.25;
// With a number of vertices: the share of triangles not as wanted from which on it is the number.
constexpr double kFarShare = 0.2;
// Costs that differ by less are equal.
constexpr double kSameCost = 1e-9;

// An edge of two triangles counts half for each.
double costOfEdge(double length, const WantedLimits& wanted) {
  if (length < wanted.shortest) return 0.5 * (2 - length / wanted.shortest);
  // Two halves of an edge must cost less than the edge.
  if (length > wanted.longest) return 0.5 * length * length / (wanted.longest * wanted.longest);
  return 0;
}

// 0 if the triangle is as wanted; else one for each edge and angle that is not, and more the worse.
double costOf(const Triangle& t, const WantedLimits& wanted) {
  double cost = 0;
  for (std::size_t i = 0; i < 3; ++i) cost += costOfEdge((t[(i + 1) % 3] - t[i]).norm(), wanted);
  const bool isWanted = wanted.angle > 0;
  const double least = isWanted ? wanted.angle : kPoor;
  const double angle = minAngle(t[0], t[1], t[2]);
  return angle < least ? cost + (isWanted ? 1 : kUnasked) * (2 - angle / least) : cost;
}

double costOf(const Run& run, Face f, const WantedLimits& wanted) {
  return costOf(run.mesh.corners(f), wanted);
}

// The triangles that a change replaces, with those that a collapse removes.
double costGoing(const Run& run, const LocalChange& change, const WantedLimits& wanted) {
  double cost = 0;
  for (const Face f : change.going) cost += costOf(run, f, wanted);
  if (change.operation != Operation::Collapse) return cost;
  for (const Halfedge side : {change.halfedge, run.mesh.mesh().twin(change.halfedge)})
    if (side) cost += costOf(run, HalfedgeMesh::face(side), wanted);
  return cost;
}

double costComing(const Run& run, const LocalChange& change, const WantedLimits& wanted) {
  double cost = 0;
  for (const auto& [a, b, c] : change.coming)
    cost += costOf({positionAfter(run.mesh, change, a), positionAfter(run.mesh, change, b),
                    positionAfter(run.mesh, change, c)},
                   wanted);
  return cost;
}

// Among many long edges fewer and longer ones would cost less: no collapse makes an edge too long.
bool makesTooLong(const Run& run, const LocalChange& change, const WantedLimits& wanted) {
  const Vec3& to = change.place.position;
  const auto isTooFar = [&](Vertex v) {
    return v != kMoved && (run.mesh.position(v) - to).norm() > wanted.longest;
  };
  return std::any_of(change.coming.begin(), change.coming.end(), [&](const auto& corners) {
    return std::any_of(corners.begin(), corners.end(), isTooFar);
  });
}

// By how much the proposal at hand lowers the cost. shift: the largest one, in model units.
double savingOf(const Run& run, const WantedLimits& wanted, double shift, double least) {
  const LocalChange& change = run.scratch.change;
  const double gain = costGoing(run, change, wanted) - costComing(run, change, wanted);
  if (gain <= least + kSameCost) return 0;
  if (change.operation == Operation::Collapse && makesTooLong(run, change, wanted)) return 0;
  if (blunts(run.mesh, change, wanted.angle)) return 0;
  if (judge(run.mesh, change, lenient(run)) != Verdict::Accepted) return 0;
  return shiftsBeyond(shift, run.mesh, change) ? 0 : gain;
}

// Offers to move v over the surface.
void offerMoves(Vertex v, LocalSearch& search) {
  searchPattern([&](double step) {
    search.offerSteps(v, step);
    return false;
  });
}

// Offers to slide v along its curve, between its neighbours there.
void offerSlides(Run& run, Vertex v, LocalSearch& search) {
  const auto [before, after] = curveNeighbors(run.mesh, v);
  const CurvePoint on = run.mesh.on(v);
  const double from = run.mesh.onChain(before, on.chain).arc;
  const double to = run.mesh.onChain(after, on.chain).arc;
  searchPattern([&](double step) {
    for (const double end : {from, to}) {
      const double arc = on.arc + step * (end - on.arc);
      proposePlacement(run.mesh, v, run.mesh.onCurve({on.chain, arc}), run.scratch.change);
      search.offer();
    }
    return false;
  });
}

bool maySlide(const Run& run, Vertex v) {
  if (run.mesh.kind(v) != VertexKind::Curve || run.mesh.isPinned(v)) return false;
  return !run.mesh.surface().curves().chains()[run.mesh.on(v).chain].kept;
}

void offerAtCorner(Run& run, Vertex v, LocalSearch& search) {
  if (run.mesh.kind(v) == VertexKind::Interior && !run.mesh.isPinned(v))
    offerMoves(v, search);
  else if (maySlide(run, v))
    offerSlides(run, v, search);
}

bool changeAround(Run& run, Face f, const WantedLimits& wanted, Number number, const Hubs& hubs) {
  const auto corners = run.mesh.mesh().vertices(f);
  const double size = run.asked.scale * run.sizes.at(run.mesh.at(corners[0]));
  LocalSearch search(
      run, [&](double least) { return savingOf(run, wanted, kMostMoved * size, least); }, &hubs);
  if (number == Number::Kept)
    search.offerAtEdges(f, {EdgeMove::Flip});
  else
    search.offerAtEdges(
        f, {EdgeMove::Flip, EdgeMove::Split, EdgeMove::Collapse, EdgeMove::CollapseInto});
  for (const Vertex v : corners)
    if (!hubs.contains(v)) offerAtCorner(run, v, search);
  return search.carryOut();
}

bool isLongestAround(const Run& run, Halfedge h) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double length = run.mesh.edgeLength(h);
  for (const Halfedge side : {h, mesh.twin(h)})
    if (side && std::max(run.mesh.edgeLength(mesh.next(side)),
                         run.mesh.edgeLength(mesh.prev(side))) > length)
      return false;
  return true;
}

// Divides edges that are too long and the longest of their triangles [Rivara 1984], unless halves
// would be too short. Returns the number of splits.
std::size_t divideLong(Run& run, const WantedLimits& wanted) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t splits = 0;
  const Index present = Index(mesh.halfedgeCapacity());
  for (Index i = 0; i < present; ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    const double length = run.mesh.edgeLength(h);
    if (length <= wanted.longest || length < 2 * wanted.shortest) continue;
    if (!isLongestAround(run, h)) continue;
    if (proposeSplit(run.mesh, run.projector, h, run.scratch.change))
      splits += commit(run, lenient(run)) ? 1 : 0;
  }
  return splits;
}

// Halving goes on until nothing is too long that may be halved.
void divideAllLong(Run& run, const WantedLimits& wanted) {
  constexpr int kMostHalvings = 64;
  for (int i = 0; i < kMostHalvings; ++i) {
    const std::size_t splits = divideLong(run, wanted);
    if (splits == 0 || areProofsSpent(run)) return;
    if (kManySplits * splits > run.mesh.mesh().vertexCount())
      delaunayFlips(run.mesh, run.asked.rule);
  }
}

// The triangles that are not as wanted, the worst first.
std::vector<Face> notAsWanted(const Run& run, const WantedLimits& wanted) {
  return worstFirst(run.mesh.mesh(), [&](Face f) {
    const double cost = costOf(run, f, wanted);
    return cost > 0 ? std::optional(cost) : std::nullopt;
  });
}

// Whether so many triangles are not as wanted that no single changes help.
bool isFarFrom(const Run& run, const WantedLimits& wanted) {
  return double(notAsWanted(run, wanted).size()) > kFarShare * double(run.mesh.mesh().faceCount());
}

// Whether no change of the mesh between its curves brings the ends of an edge apart.
bool isHeldByCurves(const Run& run, Halfedge h) {
  const auto isHeld = [&](Vertex v) { return run.mesh.kind(v) != VertexKind::Interior; };
  return isHeld(run.mesh.mesh().origin(h)) && isHeld(run.mesh.mesh().tip(h));
}

// Whether the smallest angle of f lies between two curves, or between curves that are too near.
bool isBetweenCurves(const Run& run, Face f) {
  const auto corners = run.mesh.mesh().vertices(f);
  return std::all_of(corners.begin(), corners.end(),
                     [&](Vertex v) { return run.mesh.kind(v) != VertexKind::Interior; });
}

// Whether f is at a tip that is too sharp for the angle.
bool isAtSharpTip(const Run& run, Face f, double angle) {
  const auto corners = run.mesh.mesh().vertices(f);
  return std::any_of(corners.begin(), corners.end(),
                     [&](Vertex v) { return isSharpTip(run.mesh, v, angle); });
}

}  // namespace

void keepWanted(Run& run, const WantedLimits& wanted, Number number) {
  if (number != Number::Free && isFarFrom(run, wanted)) {
    fires("wanted: the number of vertices is far from what is wanted");
    return;
  }
  grantProofs(run);
  if (number != Number::Kept) divideAllLong(run, wanted);
  const Hubs hubs(run.mesh.mesh());
  std::size_t looks = kLooksPerTriangle * run.mesh.mesh().faceCount();
  const auto mayMend = [&](Face f) {
    if (!run.mesh.mesh().isAlive(f) || costOf(run, f, wanted) == 0) return false;
    if (looks == 0 || areProofsSpent(run)) return false;
    if (--looks == 0) fires("wanted: most looks");
    return true;
  };
  for (int round = 0; round < kRoundsForWanted; ++round)
    if (!mendEach(notAsWanted(run, wanted), kChangesInARow, mayMend,
                  [&](Face f) { return changeAround(run, f, wanted, number, hubs); }))
      return;
  fires("wanted: most rounds");
}

Unmet unmetOf(const Run& run, const WantedLimits& wanted) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  Unmet unmet;
  const auto count = [](UnmetCount& counted, bool isFixed) {
    ++counted.all;
    counted.byCurves += isFixed ? 1 : 0;
  };
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    const double length = run.mesh.edgeLength(h);
    if (length < wanted.shortest) count(unmet.shortEdges, isHeldByCurves(run, h));
    if (length > wanted.longest) count(unmet.longEdges, run.mesh.isKept(h));
  }
  for (Face f(0); f.index < mesh.faceCapacity(); ++f.index)
    if (mesh.isAlive(f) && smallestAngle(run.mesh, f) < wanted.angle &&
        !isAtSharpTip(run, f, wanted.angle))
      count(unmet.smallAngles, isBetweenCurves(run, f));
  return unmet;
}

}  // namespace remesher
