// SPDX-License-Identifier: MIT
#include "remesh/steps/boundaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/triangle.h"
#include "original/surface/boundary_places.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/relax.h"

namespace remesher {

namespace {

// Of the tolerance: shorter moves are left out.
constexpr double kStill = 0.1;
// Of plans, and of slides within each plan.
constexpr int kMostRounds = 8;

struct Station {
  Index chain;
  double arc;
  Vertex vertex;

  auto operator<=>(const Station&) const = default;
};

using Row = std::vector<Station>;

// The vertices from origin(h), a corner, along its boundary to the next corner, by rising arc.
Row rowFrom(const Run& run, Halfedge h) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const Index chain = run.mesh.curve(h);
  Row row;
  const auto add = [&](Vertex v) { row.push_back({chain, run.mesh.onChain(v, chain).arc, v}); };
  add(mesh.origin(h));
  for (; run.mesh.kind(mesh.tip(h)) != VertexKind::Corner; h = mesh.outgoing(mesh.tip(h)))
    add(mesh.tip(h));
  add(mesh.tip(h));
  std::sort(row.begin(), row.end());
  return row;
}

// Per chain its vertices from corner to corner if it is a resampled boundary, else none.
std::vector<Row> rowsOf(const Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::vector<Row> rows(run.mesh.surface().curves().chains().size());
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v) || run.mesh.kind(v) != VertexKind::Corner) continue;
    const Halfedge h = mesh.outgoing(v);
    if (mesh.isBoundary(h) && !run.mesh.isKept(h)) rows[run.mesh.curve(h)] = rowFrom(run, h);
  }
  return rows;
}

bool isNear(const Run& run, Index chain, double from, double to) {
  const OriginalSurface& surface = run.mesh.surface();
  return chordDistance(surface, chain, from, to) <= kChordTolerance * surface.diagonal();
}

bool isNear(const Run& run, const Row& row) {
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
    if (!isNear(run, row[i].chain, row[i].arc, row[i + 1].arc)) return false;
  return true;
}

using Edges = std::vector<std::array<Vertex, 2>>;

struct BoundaryPlan {
  Edges far;      // whose chords are far from the curve
  Edges tooLong;  // whose chords stay far wherever their ends go
  Row moves;      // the vertices with their new places
};

// The best places found for a row, by its chain and its former places. If nothing has moved
// since, the search would find the same again.
using Known = std::map<std::pair<Index, std::vector<double>>, std::vector<double>>;

const std::vector<double>& placesFor(const Run& run, Index chain, const std::vector<double>& arcs,
                                     Known& known) {
  const OriginalSurface& surface = run.mesh.surface();
  const auto [at, isNew] = known.try_emplace({chain, arcs});
  if (isNew) at->second = placesAlong(surface, chain, arcs, kChordTolerance * surface.diagonal());
  return at->second;
}

BoundaryPlan planFor(const Run& run, Known& known) {
  const double tolerance = kChordTolerance * run.mesh.surface().diagonal();
  BoundaryPlan plan;
  for (const Row& row : rowsOf(run)) {
    if (isNear(run, row)) continue;
    const Index chain = row.front().chain;
    std::vector<double> arcs;
    for (const auto& place : row) arcs.push_back(place.arc);
    const std::vector<double>& to = placesFor(run, chain, arcs, known);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const Vertex v = row[i].vertex, next = row[i + 1].vertex;
      if (!isNear(run, chain, arcs[i], arcs[i + 1])) plan.far.push_back({v, next});
      if (!isNear(run, chain, to[i], to[i + 1])) plan.tooLong.push_back({v, next});
      if (std::abs(to[i] - arcs[i]) > kStill * tolerance) plan.moves.push_back({chain, to[i], v});
    }
  }
  return plan;
}

// Commits a change of an outline. If the loose rule refuses it, it need only not fold the mesh:
// outlines are more visible than normals that differ from the surface's.
bool commitOutline(Run& run) {
  FidelityRule rule = run.asked.rule;
  if (rule.mode == Fidelity::Loose) rule.mode = Fidelity::Fold;
  return commit(run) || commit(run, rule);
}

bool slideTo(Run& run, const Station& to) {
  proposePlacement(run.mesh, to.vertex, run.mesh.onCurve({to.chain, to.arc}), run.scratch.change);
  if (!commitOutline(run)) return false;
  run.mesh.unsettleStar(to.vertex);
  run.mesh.pin(to.vertex);
  return true;
}

// Slides a vertex as far as the triangles around it allow.
bool slideTowards(Run& run, const Station& to) {
  const double from = run.mesh.on(to.vertex).arc;
  for (const double share : {1.0, 0.5, 0.25})
    if (slideTo(run, {to.chain, from + share * (to.arc - from), to.vertex})) return true;
  return false;
}

// Returns whether anything moved. Interior vertices make way between the slides.
bool slide(Run& run, const Row& moves) {
  bool moved = false;
  for (int i = 0; i < kMostRounds; ++i) {
    bool again = false;
    for (const Station& to : moves)
      if (run.mesh.on(to.vertex).arc != to.arc) again = slideTowards(run, to) || again;
    if (!again) break;
    moved = true;
    relax(run, run.asked.effort.passes);
  }
  return moved;
}

bool split(Run& run, const Edges& edges) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  bool done = false;
  for (const auto& [a, b] : edges) {
    const Halfedge h = mesh.find(a, b) ? mesh.find(a, b) : mesh.find(b, a);
    // Vertices at one place of the chain, up to rounding, may be no neighbours in the mesh.
    if (!h || !proposeSplit(run.mesh, run.projector, h, run.scratch.change)) continue;
    done = commitOutline(run) || done;
  }
  if (!done) return false;
  delaunayFlips(run.mesh, run.asked.rule);
  relax(run, run.asked.effort.passes);
  return true;
}

// Pins the vertices without which the chord between their neighbours would be far from the curve.
void pinNeeded(Run& run) {
  for (const Row& row : rowsOf(run))
    for (std::size_t i = 1; i + 1 < row.size(); ++i)
      if (!isNear(run, row[i].chain, row[i - 1].arc, row[i + 1].arc)) run.mesh.pin(row[i].vertex);
}

// Rates the triangles around v if it were at `place`: the mean of their smallest angles plus the
// smallest of all where it is bad. If the quality does not exceed `most`, any value up to `most`
// may be returned.
double starQuality(const WorkingMesh& mesh, Vertex v, const Vec3& place, double most) {
  constexpr double kLargest = radians(60.001);  // of smallest angles, rounding included
  const HalfedgeMesh& m = mesh.mesh();
  int count = 0;
  m.forEachOutgoing(v, [&](Halfedge) { ++count; });
  double sum = 0, worst = kFine, quality = 0;
  int rest = count;
  for (Halfedge h = m.outgoing(v); rest > 0; h = m.twin(m.prev(h))) {
    const double angle = minAngle(place, mesh.position(m.tip(h)), mesh.position(m.opposite(h)));
    sum += angle;
    worst = std::min(worst, angle);
    --rest;
    quality = (sum + rest * kLargest) / count + worst;
    if (quality <= most) break;
  }
  return quality;
}

// Whether the star of v has not moved: a search that was in vain there would be again.
bool isAsBefore(const WorkingMesh& mesh, Vertex v, const VertexData<Vec3>& before) {
  bool isSame = mesh.position(v) == before[v];
  mesh.mesh().forEachNeighbor(v,
                              [&](Vertex w) { isSame = isSame && mesh.position(w) == before[w]; });
  return isSame;
}

// Slides a vertex to the place between its neighbours where its triangles are best and both chords
// are near the curve.
bool mend(Run& run, const Station& before, Station& at, const Station& after) {
  const OriginalSurface& surface = run.mesh.surface();
  const auto qualityAt = [&](double arc, double most) {
    return starQuality(run.mesh, at.vertex, positionAt(surface, at.chain, arc), most);
  };
  double most = qualityAt(at.arc, 0);
  Station best = at;
  for (int i = 1; i < kPlacesBetween; ++i) {
    const double arc = before.arc + (after.arc - before.arc) * i / kPlacesBetween;
    const double quality = qualityAt(arc, most);
    if (quality <= most || !isNear(run, at.chain, before.arc, arc) ||
        !isNear(run, at.chain, arc, after.arc))
      continue;
    most = quality;
    best.arc = arc;
  }
  if (best == at || !slideTo(run, best)) return false;
  at = best;
  return true;
}

// before: the positions of all vertices at the previous call.
bool mendStars(Run& run, const VertexData<Vec3>& before) {
  bool moved = false;
  for (Row& row : rowsOf(run))
    for (std::size_t i = 1; i + 1 < row.size(); ++i)
      if (!isAsBefore(run.mesh, row[i].vertex, before))
        moved = mend(run, row[i - 1], row[i], row[i + 1]) || moved;
  if (moved) relax(run, run.asked.effort.passes);
  return moved;
}

}  // namespace

void followBoundaries(Run& run) {
  Known known;
  bool changed = true;
  for (int i = 0; i < kMostRounds && changed; ++i) {
    BoundaryPlan plan = planFor(run, known);
    changed = split(run, plan.tooLong);
    if (changed) plan = planFor(run, known);
    changed = slide(run, plan.moves) || changed || split(run, plan.far);
  }
  if (changed) fires("boundaries: most rounds");
  pinNeeded(run);
}

void settleBoundaries(Run& run) {
  Known known;
  for (int i = 0; i < kMostRounds && slide(run, planFor(run, known).moves); ++i) {
  }
  VertexData<Vec3> before(run.mesh.mesh().vertexCapacity(), Vec3::Constant(kInfinity));
  for (int i = 0; i < kMostRounds; ++i) {
    const VertexData<Vec3> now = run.mesh.positions();
    if (!mendStars(run, before)) break;
    before = now;
  }
  for (const Row& row : rowsOf(run))
    for (const Station& station : row) run.mesh.pin(station.vertex);
}

}  // namespace remesher
