// SPDX-License-Identifier: MIT
#include "schemes/boundaries.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "operators/angles.h"
#include "operators/delaunay.h"
#include "schemes/relax.h"
#include "schemes/sweeps.h"

namespace remesher {

namespace {

constexpr int kRounds = 8;
constexpr int kPasses = 3;
constexpr int kSteps = 16;  // places tried between two neighbours, besides the bends there
constexpr double kProgress = 0.95;
// Of its star's worst angle: below, a vertex moves for its triangles' sake; and so much is kept
// when it moves for the curve's.
constexpr double kBadAngle = radians(35), kKeepAngle = radians(30);
// No split leaves a triangle with a smaller angle.
constexpr double kSplitAngle = radians(15);

// How far a chord may be from the curve. In coarse meshes more, by the square of the edges, as
// chords are.
double tolerance(const Run& run) {
  constexpr double kOfDiagonal = 9e-4, kOfSquare = 2.5;
  const double diagonal = run.mesh.surface().diagonal(), edge = run.sizes.mean();
  return std::max(kOfDiagonal * diagonal, kOfSquare * edge * edge / diagonal);
}

struct Bend {
  double distance = 0, arc = 0;
};

// Where a chain, between two of its places, is farthest from the chord.
Bend farthestBend(const WorkingMesh& mesh, Index chain, double from, double to) {
  const Chain& along = mesh.surface().curves().chains()[chain];
  if (from > to) std::swap(from, to);
  const Vec3 a = mesh.onCurve({chain, from}).position, b = mesh.onCurve({chain, to}).position;
  const auto& arcs = along.arcs;
  Bend bend;
  for (auto i = std::upper_bound(arcs.begin(), arcs.end(), from); i != arcs.end() && *i < to; ++i) {
    const Vec3& p = mesh.surface().positions()[along.vertices[i - arcs.begin()]];
    const double distance = (closestPoint(p, a, b, b) - p).norm();
    if (distance > bend.distance) bend = {distance, *i};
  }
  return bend;
}

// A vertex of a boundary and the places of its neighbours there.
struct Span {
  Vertex vertex;
  Index chain;
  double from, to;

  double distanceAt(const WorkingMesh& mesh, double arc) const {
    return std::max(farthestBend(mesh, chain, from, arc).distance,
                    farthestBend(mesh, chain, arc, to).distance);
  }
};

Span spanOf(const WorkingMesh& mesh, Vertex v) {
  const auto [before, after] = curveNeighbors(mesh, v);
  const Index chain = mesh.on(v).chain;
  return {v, chain, mesh.onChain(before, chain).arc, mesh.onChain(after, chain).arc};
}

std::vector<double> placesIn(const Chain& chain, const Span& span) {
  const double low = std::min(span.from, span.to), high = std::max(span.from, span.to);
  std::vector<double> arcs;
  for (int i = 1; i < kSteps; ++i) arcs.push_back(low + (high - low) * i / kSteps);
  const auto first = std::upper_bound(chain.arcs.begin(), chain.arcs.end(), low);
  arcs.insert(arcs.end(), first, std::lower_bound(first, chain.arcs.end(), high));
  return arcs;
}

// Of the places between v's neighbours where both chords are near enough, that with the best
// triangles; if there is none, that with the nearest chords.
bool slideToBend(Run& run, Vertex v) {
  const Span span = spanOf(run.mesh, v);
  const double near = tolerance(run), now = span.distanceAt(run.mesh, run.mesh.on(v).arc);
  const double present = smallestAngleAround(run.mesh, v, run.mesh.position(v));
  if (now <= near && present >= kBadAngle) return false;
  double least = now > near ? kProgress * now : near;
  double angle = now > near ? 0 : present / kProgress;
  double best = -1;
  for (const double arc : placesIn(run.mesh.surface().curves().chains()[span.chain], span)) {
    const double then = std::max(near, span.distanceAt(run.mesh, arc));
    if (then > least) continue;
    const Vec3 place = run.mesh.onCurve({span.chain, arc}).position;
    const double worst = smallestAngleAround(run.mesh, v, place);
    if (worst < std::min(kKeepAngle, present) || (then == least && worst <= angle)) continue;
    least = then;
    angle = worst;
    best = arc;
  }
  if (best < 0) return false;
  proposePlacement(run.mesh, v, run.mesh.onCurve({span.chain, best}), run.change);
  return commit(run);
}

// The vertices that boundaries may slide, those with the farthest chords first.
std::vector<Vertex> farthestFirst(const Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const auto& chains = run.mesh.surface().curves().chains();
  std::vector<std::pair<double, Vertex>> ranked;
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v) || run.mesh.kind(v) != VertexKind::Curve) continue;
    const CurvePoint& on = run.mesh.on(v);
    if (chains[on.chain].boundary)
      ranked.emplace_back(-spanOf(run.mesh, v).distanceAt(run.mesh, on.arc), v);
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<Vertex> vertices;
  for (const auto& [rank, v] : ranked) vertices.push_back(v);
  return vertices;
}

std::size_t splitAtBends(Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t splits = 0;
  const Index present = Index(mesh.halfedgeCapacity());
  for (Index i = 0; i < present; ++i) {
    const Halfedge h(i);
    if (!mesh.isAlive(h) || !mesh.isBoundary(h)) continue;
    const Index chain = run.mesh.curve(h);
    const Bend bend = farthestBend(run.mesh, chain, run.mesh.onChain(mesh.origin(h), chain).arc,
                                   run.mesh.onChain(mesh.tip(h), chain).arc);
    if (bend.distance <= tolerance(run)) continue;
    if (!proposeSplit(run.mesh, run.projector, h, run.change)) continue;
    run.change.place = run.mesh.onCurve({chain, bend.arc});
    if (smallestComingAngle(run.mesh, run.change) < kSplitAngle || !commit(run)) continue;
    run.mesh.pin(run.result);
    ++splits;
  }
  if (splits > 0) delaunayFlips(run.mesh, run.rule);
  return splits;
}

std::size_t slideOnce(Run& run) {
  std::size_t moves = 0;
  for (const Vertex v : farthestFirst(run)) {
    if (!slideToBend(run, v)) continue;
    run.mesh.pin(v);
    run.mesh.unsettleStar(v);
    ++moves;
  }
  return moves;
}

}  // namespace

std::size_t slideToBends(Run& run) {
  std::size_t moves = 0;
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t now = slideOnce(run);
    if (now == 0) break;
    moves += now;
    if (round + 1 < kRounds) relax(run, kPasses);
  }
  return moves;
}

void followBoundaries(Run& run) {
  for (int round = 0; round < kRounds; ++round) {
    if (slideOnce(run) == 0 && splitAtBends(run) == 0) return;
    if (round + 1 < kRounds) relax(run, kPasses);
  }
}

}  // namespace remesher
