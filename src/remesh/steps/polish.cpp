// SPDX-License-Identifier: MIT
#include "remesh/steps/polish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/fires.h"
#include "geometry/pattern_search.h"
#include "geometry/polar_map.h"
#include "geometry/triangle.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/shift.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/local_search.h"
#include "remesh/steps/relax.h"

namespace remesher {

namespace {

constexpr int kMeansByTurns = 2;  // see meansOf
// If this many bad triangles outlast the effort's patience, the surface allows no better: the rest
// are around handles no larger than a triangle.
constexpr std::size_t kManyBad = 200;
// The work on a triangle is the number of its corners' neighbours. Where few triangles are bad a
// twentieth of the limit, per wanted triangle, is needed; where all are, and valences high, more is
// in vain.
constexpr std::size_t kMostWork = 20;
constexpr double kByProjecting = radians(1);  // angles seldom grow by more
// The largest shift beside curves, in target edge lengths. Any angle there is better than a thin
// wall's, and larger steps would cut across its rims.
constexpr double kMostBesideCurves = 0.25;

// The limits of a change: the rule, and the largest shift of the surface in model units.
struct Limits {
  FidelityRule rule;
  double shift;
};

// By how much the proposal at hand enlarges the worst angle.
double wideningOf(const Run& run, const Limits& limits, double least) {
  const LocalChange& change = run.scratch.change;
  const Quantum& quantum = run.asked.rule.quantum;
  const double worst = smallestComingAngle(run.mesh, change, quantum, least);
  if (worst <= least) return 0;
  const double better = worst - smallestGoingAngle(run.mesh, change, quantum);
  if (better <= least || judge(run.mesh, change, limits.rule) != Verdict::Accepted) return 0;
  const bool mayShift = std::isinf(limits.shift);
  return mayShift || !shiftsBeyond(limits.shift, run.mesh, change) ? better : 0;
}

// Where a vertex may go: to projections of its polar map's plane onto the original or, where that
// is so crumpled that every projection folds the star over, to places on the mesh itself.
enum class Ground { Original, Mesh };

struct Wanted {
  Ground ground;
  AngleLimit angle;
};

// Proposes a move to `p` in the plane of a vertex's polar map; none if an angle is too small before
// projection, which costs most.
bool proposeMove(Run& run, const PolarMap& map, const Vec2& p, const Wanted& wanted) {
  const auto location = map.locate(p);
  if (!location) return false;
  const Vertex a = map.neighbor(location->triangle);
  const Vertex b = map.neighbor(map.after(location->triangle));
  const Vec3& w = location->barycentric;
  const Vec3 onMesh = w[0] * run.mesh.position(map.center()) + w[1] * run.mesh.position(a) +
                      w[2] * run.mesh.position(b);
  if (wanted.angle.isAboveAround(run.scratch.star, onMesh)) return false;
  const Halfedge h = run.mesh.mesh().find(map.center(), a);
  if (!proposeRelocation(run.mesh, run.projector, {h, w}, run.scratch.change)) return false;
  if (wanted.ground == Ground::Mesh && !run.mesh.surface().isFlatAt(run.scratch.change.place.at))
    run.scratch.change.place.position = onMesh;
  return true;
}

// Searches around v for a place where the worst angle of its star is largest.
void offerMove(Run& run, Vertex v, Ground ground, LocalSearch& search) {
  if (run.mesh.kind(v) != VertexKind::Interior) return;
  if (run.mesh.isPinned(v) && ground == Ground::Original) return;
  PolarMap map;
  map.build(run.mesh.mesh(), run.mesh.positions(), v);
  run.scratch.star.gather(run.mesh, v);
  const double spoke = map.meanSpoke();
  Vec2 at = Vec2::Zero();
  double angle = 0;
  Wanted wanted{ground, AngleLimit(0)};
  searchPattern([&, directions = planeDirections()](double step) {
    for (const Vec2& direction : directions) {
      const Vec2 to = at + step * spoke * direction;
      if (!proposeMove(run, map, to, wanted)) continue;
      const double worst =
          smallestComingAngle(run.mesh, run.scratch.change, run.asked.rule.quantum, angle);
      if (worst <= angle) continue;
      angle = worst;
      wanted.angle = AngleLimit(std::max(0.0, angle - kByProjecting));
      at = to;
      search.offer();
    }
    return false;  // as long steps once more cost a tenth of all time, and gain nothing
  });
}

bool isOnCurve(const WorkingMesh& mesh, Vertex v) {
  bool found = mesh.mesh().isBoundary(v);
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { found = found || mesh.isCurve(h); });
  return found;
}

// Whether the angles around v make a full turn: then a place on the surface is as good as one off
// it.
bool canBeRolledOut(const WorkingMesh& mesh, Vertex v) {
  double turn = 0;
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    const Vec3 &tip = mesh.position(mesh.mesh().tip(h)),
               &next = mesh.position(mesh.mesh().opposite(h));
    turn += angles(mesh.position(v), tip, next)[0];
  });
  return std::abs(2 * std::numbers::pi - turn) < kSingleRoundOff;
}

// Offers places up and down the mean normal of the star: around a sharp tip no place on the surface
// is better, but a place a little off it is.
void offerLifts(Run& run, Vertex v, LocalSearch& search) {
  if (run.mesh.kind(v) != VertexKind::Interior || canBeRolledOut(run.mesh, v)) return;
  if (run.mesh.surface().isFlatAt(run.mesh.at(v))) return;
  const Vec3& at = run.mesh.position(v);
  const Vec3 normal = run.mesh.areaVectorAround(v);
  const double spoke = run.mesh.meanSpoke(v);
  if (!(normal.norm() > 0)) return;
  Placement place = run.mesh.placement(v);
  const Vec3 ground = run.mesh.surface().position(place.at);
  searchPattern([&](double step) {
    for (const double way : {step, -step}) {
      place.position = at + way * kSmallShift * spoke * normal.normalized();
      if ((place.position - ground).norm() > kSmallShift * spoke) continue;
      proposePlacement(run.mesh, v, place, run.scratch.change);
      search.offer();
    }
    return false;  // all lifts are from one place
  });
}

// The vertices whose search was in vain, until their stars change: adjacent triangles share
// corners. Only noted where a step's shift is not limited, for else the limit depends on the
// triangle.
class InVain {
 public:
  // Whether a search from v will gain no more than `gain`.
  bool knows(Vertex v, double gain) const { return v.index < most_.size() && most_[v] <= gain; }

  void note(Vertex v, double gain) {
    if (v.index >= most_.size()) most_.resize(v.index + 1, kInfinity);
    most_[v] = std::min(most_[v], gain);
  }

  void forget(const HalfedgeMesh& mesh, const LocalChange& change) {
    for (const Face f : change.going)
      for (const Vertex v : mesh.vertices(f))
        if (v.index < most_.size()) most_[v] = kInfinity;
  }

 private:
  VertexData<double> most_;
};

enum class Means { KeepCount, ChangeCount, LeaveSurface };

struct Attempt {
  const Hubs& hubs;  // their places are not searched either
  Means means;
  double shift;    // see PolishGoal
  InVain& inVain;  // of the same means
};

// The approximate cost of an attempt to mend f. A hub, which stays, still costs as a neighbour.
std::size_t workOf(const Run& run, Face f, const Hubs& hubs) {
  std::size_t work = 0;
  for (const Vertex v : run.mesh.mesh().vertices(f))
    work += hubs.contains(v) ? Hubs::kFewestSpokes : std::size_t(run.mesh.mesh().valence(v));
  return work;
}

// Returns whether a change has enlarged the worst angle around f.
bool mend(Run& run, Face f, const Attempt& attempt) {
  const Means means = attempt.means;
  const auto corners = run.mesh.mesh().vertices(f);
  const bool isBesideCurve =
      std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return isOnCurve(run.mesh, v); });
  const double shift = isBesideCurve ? std::min(attempt.shift, kMostBesideCurves) : attempt.shift;
  const double size = run.asked.scale * run.sizes.at(run.mesh.at(corners[0]));
  const Limits limits{means == Means::KeepCount ? run.asked.rule : lenient(run), shift * size};
  LocalSearch search(
      run, [&](double least) { return wideningOf(run, limits, least); }, &attempt.hubs);
  search.offerAtEdges(f, {EdgeMove::Flip});
  const Ground ground = means == Means::LeaveSurface ? Ground::Mesh : Ground::Original;
  for (const Vertex v : corners) {
    const double before = search.best().gain;
    if (attempt.hubs.contains(v) || attempt.inVain.knows(v, before)) continue;
    offerMove(run, v, ground, search);
    if (search.best().gain == before && !std::isfinite(shift)) attempt.inVain.note(v, before);
  }
  // Beside a curve a lift off the surface would show, and be in vain. Without patches onto the
  // original nothing says how far off it a vertex already is.
  const bool mayLift =
      means == Means::LeaveSurface && !isBesideCurve && run.projector.mode() == Projection::Patches;
  for (const Vertex v : corners)
    if (mayLift && !attempt.hubs.contains(v)) offerLifts(run, v, search);
  if (means == Means::ChangeCount) {
    search.offerAtEdges(f, {EdgeMove::Collapse});
    search.offerAtEdges(f, {EdgeMove::Split});
  }
  if (search.best().gain <= 0) return false;
  attempt.inVain.forget(run.mesh.mesh(), search.best().change);
  return search.carryOut();
}

bool isBad(const Run& run, Face f, const AngleLimit& limit) {
  return run.mesh.mesh().isAlive(f) && limit.isAbove(run.mesh, f, run.asked.rule.quantum);
}

std::vector<Face> badTriangles(const Run& run, double angle) {
  const AngleLimit limit(angle);
  return worstFirst(run.mesh.mesh(), [&](Face f) {
    return isBad(run, f, limit) ? std::optional(-smallestAngle(run.mesh, f, run.asked.rule.quantum))
                                : std::nullopt;
  });
}

// Gentle and drastic means take turns. In the last round gentle ones mend what the drastic left,
// and vertices may leave the surface.
Means meansOf(int round, int rounds) {
  if (round + 1 == rounds) return Means::LeaveSurface;
  return round % 2 == 1 ? Means::ChangeCount : Means::KeepCount;
}

// The small moves of the last round go on while they gain.
int triesOf(const Run& run, Means means) {
  return means == Means::LeaveSurface ? std::numeric_limits<int>::max()
                                      : run.asked.effort.polishTries;
}

// Triangles beyond the wanted number, among needles, do not raise the limit.
std::size_t mostWork(const Run& run) {
  const double wanted = std::min(double(run.mesh.mesh().faceCount()), 2 * run.sizes.vertices());
  return kMostWork * std::size_t(wanted);
}

}  // namespace

bool areFewBelow(const Run& run, double angle) {
  constexpr double kFew = 0.02;
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const AngleLimit limit(angle);
  std::size_t below = 0;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) below += isBad(run, Face(i), limit) ? 1 : 0;
  return double(below) <= kFew * double(mesh.faceCount());
}

void polish(Run& run, const PolishGoal& goal, const Progress& progress) {
  const std::size_t vertices = run.mesh.mesh().vertexCount();
  const int rounds = run.asked.effort.polishRounds;
  double before = kInfinity;
  const Hubs hubs(run.mesh.mesh());
  std::size_t work = mostWork(run);
  const auto mayTry = [&](Face f) {
    const bool isFull = double(run.mesh.mesh().vertexCount()) > kMostGrowth * double(vertices) + 16;
    const std::size_t own = isFull ? work + 1 : workOf(run, f, hubs);
    if (isFull) fires("polish: most vertices");
    if (!isFull && own > work) fires("polish: most work");
    if (own > work || areProofsSpent(run)) return false;
    work -= own;
    return true;
  };
  const AngleLimit limit(goal.angle);
  std::vector<Face> bad;
  int inVainSince = 0;  // rounds; once both means are in vain, only the last round is left to try
  for (int round = 0; round < rounds; ++round) {
    progress.at(double(round) / rounds);
    if (inVainSince == 0) bad = badTriangles(run, goal.angle);
    if (bad.empty()) break;
    if (bad.size() > kManyBad && double(bad.size()) > before) {
      fires("polish: bad triangles do not get fewer");
      break;
    }
    if ((round + 1) % run.asked.effort.polishPatience == 0) before = double(bad.size());
    if (inVainSince++ >= kMeansByTurns && round + 1 < rounds) continue;
    InVain inVain;
    const Attempt attempt{hubs, meansOf(round, rounds), goal.shift, inVain};
    const int tries = triesOf(run, attempt.means);
    const bool isAny = mendEach(
        bad, tries, [&](Face f) { return isBad(run, f, limit) && mayTry(f); },
        [&](Face f) { return mend(run, f, attempt); });
    if (isAny) inVainSince = 0;
    if (run.mesh.mesh().vertexCount() == vertices) continue;
    matchCount(run, vertices);
    relax(run, 2);
  }
}

}  // namespace remesher
