// SPDX-License-Identifier: MIT
#include "remesh/steps/sweeps.h"

#include <algorithm>
#include <cmath>

#include "original/surface/surface_walk.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/smoothing.h"

namespace remesher {

CurveNeighbors curveNeighbors(const WorkingMesh& mesh, Vertex v) {
  CurveNeighbors result;
  const HalfedgeMesh& m = mesh.mesh();
  const auto add = [&](Vertex w) { (result.before ? result.after : result.before) = w; };
  m.forEachOutgoing(v, [&](Halfedge h) {
    if (mesh.isCurve(h)) add(m.tip(h));
    const Halfedge back = m.prev(h);
    if (m.isBoundary(back)) add(m.origin(back));
  });
  return result;
}

namespace {

// Proposes a move to `target` in the plane of v's polar map, if it lies inside the star.
bool proposeTarget(Run& run, const PolarMap& star, Vertex v, const Vec2& target) {
  const auto location = star.locate(target);
  if (!location) return false;
  const Halfedge h = run.mesh.mesh().find(v, star.neighbor(location->triangle));
  return proposeRelocation(run.mesh, run.projector, {h, location->barycentric}, run.scratch.change);
}

bool relocateTo(Run& run, const PolarMap& star, Vertex v, const Vec2& target) {
  return proposeTarget(run, star, v, target) && commit(run);
}

template <class Visit>
void forEachOfKind(const WorkingMesh& mesh, VertexKind kind, Visit visit) {
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (mesh.mesh().isAlive(Vertex(i)) && mesh.kind(Vertex(i)) == kind) visit(Vertex(i));
}

struct Stretch {
  Vertex before, after;
  double from, to;  // their places along the chain
};

// From the place `even`, which the sizes ask for, towards where v is level with the mean of all its
// neighbours.
double staggered(const Run& run, Vertex v, const Stretch& between, double even) {
  const Vec3 way = run.mesh.position(between.after) - run.mesh.position(between.before);
  const double length = between.to - between.from, squared = way.squaredNorm();
  if (length == 0 || squared == 0) return even;
  Vec3 sum = Vec3::Zero();
  run.mesh.mesh().forEachNeighbor(
      v, [&](Vertex w) { sum += run.mesh.position(w) - run.mesh.position(v); });
  const double ahead = way.dot(sum) / (run.mesh.mesh().valence(v) * squared) * length;
  const double arc = even + run.asked.stagger * (run.mesh.on(v).arc + ahead - even);
  return between.from + length * std::clamp((arc - between.from) / length, kRoom, 1 - kRoom);
}

// On an open boundary: the mean of the place that the sizes ask for, counted once for either
// neighbour there, and of the places level with each inner neighbour; these lie on one side only.
double besideInner(const Run& run, Vertex v, const Stretch& between, double even) {
  const double own = run.mesh.on(v).arc;
  const Vec3 way = run.mesh.position(between.after) - run.mesh.position(between.before);
  const double length = between.to - between.from, straight = way.norm();
  if (length == 0 || straight == 0) return even;
  const Vec3 ahead = way / (length > 0 ? straight : -straight);
  double sum = 2 * (even - own);
  run.mesh.mesh().forEachNeighbor(v, [&](Vertex w) {
    if (w == between.before || w == between.after) return;
    sum += (run.mesh.position(w) - run.mesh.position(v)).dot(ahead);
  });
  const double arc = own + sum / run.mesh.mesh().valence(v);
  return between.from + length * std::clamp((arc - between.from) / length, kRoom, 1 - kRoom);
}

// Slides v to where the lengths of its two edges along the chain are in proportion to the sizes at
// their ends; as far as the run staggers curves, towards the mean of its neighbours.
bool slide(Run& run, Vertex v) {
  if (run.mesh.isPinned(v)) return false;
  const auto [before, after] = curveNeighbors(run.mesh, v);
  const Index chain = run.mesh.on(v).chain;
  const double from = run.mesh.onChain(before, chain).arc, to = run.mesh.onChain(after, chain).arc;
  const double own = run.sizes.at(run.mesh.at(v));
  const double left = own + run.sizes.at(run.mesh.at(before));
  const double right = own + run.sizes.at(run.mesh.at(after));
  double arc = from + (to - from) * left / (left + right);
  const bool isBoundary = run.mesh.surface().curves().chains()[chain].boundary;
  if (run.asked.stagger > 0)
    arc = staggered(run, v, {before, after, from, to}, arc);
  else if (isBoundary && run.asked.boundaries == Boundaries::Staggered)
    arc = besideInner(run, v, {before, after, from, to}, arc);
  proposePlacement(run.mesh, v, run.mesh.onCurve({chain, arc}), run.scratch.change);
  return commit(run);
}

Vec2 areaTarget(const Run& run, const PolarMap& star, Vertex v, std::vector<double>& mu) {
  const auto size = [&](Vertex w) { return run.sizes.at(run.mesh.at(w)); };
  mu.clear();
  for (int i = 0; i < star.size(); ++i) {
    const double mean = size(v) + size(star.neighbor(i)) + size(star.neighbor(star.after(i)));
    mu.push_back(mean * mean);
  }
  return areaBasedTarget(star, mu);
}

// Moves v towards the mean of its neighbours, each laid into the mean plane of the star at its
// distance from v, and then walks to the surface. The original beneath the star does not tilt the
// plane: even where it is rough, a move does not lean towards one side.
bool walkToMean(Run& run, Vertex v, double part) {
  const Star& star = run.scratch.star;
  run.scratch.star.gather(run.mesh, v);
  const Vec3& at = run.mesh.position(v);
  const Vec3 normal = star.areaVector(at).normalized();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec3 spoke = star.position(i) - at;
    const Vec3 flat = spoke - normal * normal.dot(spoke);
    const double squared = flat.squaredNorm();
    if (squared > 0) sum += flat * std::sqrt(spoke.squaredNorm() / squared);
  }
  const Vec3 target = at + part / double(star.size()) * sum;
  const SurfacePoint to = closestPointFrom(run.mesh.surface(), run.mesh.at(v), target);
  return commitMove(run, v, run.mesh.onSurface(to));
}

}  // namespace

void areaBasedSweep(Run& run) {
  PolarMap star;
  std::vector<double> mu;
  forEachOfKind(run.mesh, VertexKind::Interior, [&](Vertex v) {
    star.build(run.mesh.mesh(), run.mesh.positions(), v);
    relocateTo(run, star, v, areaTarget(run, star, v, mu));
  });
  curveSweep(run);
}

bool laplacianMove(Run& run, PolarMap& star, Vertex v, double part) {
  if (run.mesh.kind(v) == VertexKind::Corner || run.mesh.isPinned(v)) return false;
  if (run.mesh.kind(v) == VertexKind::Curve) return slide(run, v);
  if (run.projector.walks()) return walkToMean(run, v, part);
  star.build(run.mesh.mesh(), run.mesh.positions(), v);
  return relocateTo(run, star, v, part * laplacianTarget(star));
}

bool widenAround(Run& run, PolarMap& star, Vertex v) {
  if (run.mesh.kind(v) != VertexKind::Interior || run.mesh.isPinned(v)) return false;
  star.build(run.mesh.mesh(), run.mesh.positions(), v);
  const Vec2 target = wideTarget(star);
  if (target == Vec2::Zero() || !proposeTarget(run, star, v, target)) return false;
  const Quantum& quantum = run.asked.rule.quantum;
  const double kept =
      std::min(smallestGoingAngle(run.mesh, run.scratch.change, quantum), kWideAngle);
  return smallestComingAngle(run.mesh, run.scratch.change, quantum, kept) > kept && commit(run);
}

void laplacianSweep(Run& run) {
  PolarMap star;
  forEachOfKind(run.mesh, VertexKind::Interior, [&](Vertex v) { laplacianMove(run, star, v); });
  curveSweep(run);
}

void curveSweep(Run& run) {
  forEachOfKind(run.mesh, VertexKind::Curve, [&](Vertex v) { slide(run, v); });
}

}  // namespace remesher
