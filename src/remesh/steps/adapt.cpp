// SPDX-License-Identifier: MIT
#include "remesh/steps/adapt.h"

#include <algorithm>
#include <cmath>

#include "base/fires.h"
#include "base/patience.h"
#include "mesh/edge_queue.h"
#include "remesh/gate/angles.h"
#include "remesh/ground/decimate.h"
#include "remesh/steps/coarsen.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/lengths.h"
#include "remesh/steps/sweeps.h"
#include "remesh/steps/valence.h"

namespace remesher {

namespace {

// A shorter edge collapses even at the price of a fold.
constexpr double kMustGo = 0.4;
// Beyond this length only the longest side of a triangle is halved [Rivara 1984]. Halving all sides
// of a triangle of such edges, whatever its shape, would pile vertices up beside its longest and
// make slivers without end.
constexpr double kOverlong = 3;

bool isLongestBeside(const HalfedgeMesh& mesh, Halfedge h, VertexSizes& sizes) {
  const double length = sizes.relativeLength(h);
  for (const Halfedge side : {h, mesh.twin(h)}) {
    if (!side) continue;
    for (const Halfedge other : {mesh.next(side), mesh.prev(side)})
      if (sizes.relativeLength(other) > length) return false;
  }
  return true;
}

// Splits the long edges there are, up to a limit of vertices. New edges wait for the next call, and
// so do overlong edges that are not the longest in their triangles. Returns the number of splits
// and of waiting overlong edges.
std::size_t splitLong(Run& run, std::size_t limit) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t count = 0;
  const Index present = Index(mesh.halfedgeCapacity());
  VertexSizes sizes(run);
  for (Index i = 0; i < present && mesh.vertexCount() < limit; ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    const double length = sizes.relativeLength(h);
    if (length <= kLong) continue;
    if (length > kOverlong && !isLongestBeside(mesh, h, sizes))
      ++count;
    else if (proposeSplit(run.mesh, run.projector, h, run.scratch.change))
      count += commit(run);
  }
  return count;
}

// Much too long edges need several halvings. Without Delaunay flips in between, slivers would be
// split into ever thinner ones.
void refine(Run& run, std::size_t limit) {
  while (run.mesh.mesh().vertexCount() < limit) {
    const std::size_t before = run.mesh.mesh().vertexCount();
    const std::size_t longOnes = splitLong(run, limit), vertices = run.mesh.mesh().vertexCount();
    if (vertices == before || longOnes * 10 < vertices) return;
    delaunayFlips(run.mesh, run.asked.rule);
  }
}

// Whether the collapse of h would make an edge that has to be split again.
bool makesLongEdge(const HalfedgeMesh& mesh, Halfedge h, VertexSizes& sizes) {
  const Vertex into = mesh.tip(h);
  bool found = false;
  mesh.forEachNeighbor(mesh.origin(h), [&](Vertex w) {
    found = found || (w != into && sizes.relativeLength(into, w) > kLong);
  });
  return found;
}

// Directions of a collapse, best first. The end with the smaller size, where the original bends
// more, should stay: it may be a tip.
std::array<Halfedge, 2> outermostFirst(const HalfedgeMesh& mesh, Halfedge h, VertexSizes& sizes) {
  if (sizes.at(mesh.origin(h)) < sizes.at(mesh.tip(h)) && mesh.twin(h)) return {mesh.twin(h), h};
  return {h, mesh.twin(h)};
}

// The vertex that remains of two stays in place. Returns the number of collapses.
std::size_t collapseShort(Run& run, double shortest) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t count = 0;
  VertexSizes sizes(run);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    const double length = sizes.relativeLength(h);
    if (length >= shortest) continue;
    FidelityRule rule = length < kMustGo ? lenient(run) : run.asked.rule;
    for (const Halfedge direction : outermostFirst(mesh, h, sizes)) {
      if (!direction || makesLongEdge(mesh, direction, sizes)) continue;
      if (!proposeCollapseInto(run.mesh, direction, run.scratch.change) || !commit(run, rule))
        continue;
      ++count;
      break;
    }
  }
  return count;
}

void thinOut(Run& run) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double share = kShort * run.asked.scale;
  VertexData<double> spacing(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    if (mesh.isAlive(Vertex(i))) spacing[Vertex(i)] = share * run.sizes.at(run.mesh.at(Vertex(i)));
  decimate(run.mesh, run.asked.rule, spacing);
}

// Where the new vertex of an edge goes: onto the original, or on the edge itself.
enum class Middle { Projected, Straight };

// Splits an edge at its own middle: no point of the surface moves, so that nothing can fold over.
bool commitStraight(Run& run, const RankedEdge& edge) {
  run.scratch.change.place.position =
      0.5 * (run.mesh.position(edge.from) + run.mesh.position(edge.to));
  if (run.asked.rule.mode != Fidelity::Fold) return commit(run);
  return commitUnlessFlat(run);
}

// What halves may be: needles are taken for want of anything better.
enum class Halves { Any, NoNeedles };

bool makesNeedle(const Run& run) {
  return isNeedle(smallestComingAngle(run.mesh, run.scratch.change, run.asked.rule.quantum));
}

// Returns the number of splits.
std::size_t splitLongest(Run& run, std::size_t vertices, Middle middle, Halves halves) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t splits = 0;
  VertexSizes sizes(run);
  EdgeQueue edges(mesh, [&](Halfedge h) { return sizes.relativeLength(h); });
  while (!edges.empty() && mesh.vertexCount() < vertices) {
    const RankedEdge edge = edges.pop();
    const Halfedge h = mesh.find(edge.from, edge.to);
    if (!h || !proposeSplit(run.mesh, run.projector, h, run.scratch.change)) continue;
    if (halves == Halves::NoNeedles && makesNeedle(run)) continue;
    if (middle == Middle::Straight && !run.mesh.isCurve(h))
      splits += commitStraight(run, edge);
    else
      splits += commit(run);
  }
  return splits;
}

bool splitUpTo(Run& run, std::size_t vertices, Middle middle) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  // Where repair has mended a needle by a collapse, the longest edge is often the one that made it.
  if (run.asked.rule.guard) splitLongest(run, vertices, middle, Halves::NoNeedles);
  Patience patience;
  while (mesh.vertexCount() < vertices) {
    const std::size_t splits = splitLongest(run, vertices, middle, Halves::Any);
    if (!patience.after(splits, vertices - mesh.vertexCount())) {
      if (mesh.vertexCount() < vertices) fires("adapt: splits gain too little");
      break;
    }
  }
  return mesh.vertexCount() == vertices;
}

}  // namespace

void adaptToSizes(Run& run, std::size_t vertices, const Progress& progress) {
  if (run.mesh.mesh().vertexCount() > run.asked.effort.thinAbove * vertices) thinOut(run);
  // Slivers can ask for splits without end, and collapses then do not remove the vertices.
  const std::size_t most = 4 * std::max(vertices, run.mesh.mesh().vertexCount());
  const int rounds = run.asked.effort.adaptRounds;
  for (int i = 0; i < rounds; ++i) {
    progress.at(double(i) / rounds);
    const bool isFirstOrLast = i == 0 || i + 1 == rounds;
    // Among far too many vertices refinement waits: a long edge is still long when most have gone.
    const bool isCrowded = run.mesh.mesh().vertexCount() > kUsual.thinAbove * vertices;
    if (!isCrowded) refine(run, most);
    collapseShort(run, kShort);
    // Otherwise all later loops would visit the holes as well.
    if (isFirstOrLast) run.mesh.compact();
    valenceFlips(run);
    if (isFirstOrLast) delaunayFlips(run.mesh, run.asked.rule);
    for (int k = 0; k < run.asked.effort.adaptSweeps; ++k) laplacianSweep(run);
    const double ratio = double(run.mesh.mesh().vertexCount()) / double(vertices);
    if (i > 0) run.asked.scale *= std::sqrt(ratio);
  }
}

bool matchCount(Run& run, std::size_t vertices) {
  coarsen(run, vertices, MeetingPlace::Middle);
  return splitUpTo(run, vertices, Middle::Projected);
}

bool fillUp(Run& run, std::size_t vertices) { return splitUpTo(run, vertices, Middle::Straight); }

}  // namespace remesher
