// SPDX-License-Identifier: MIT
#include "remesh/steps/apart.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "base/place.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

// What holds a vertex, the firmest first. Coincident boundaries may have been cut apart and are to
// be joined again: a boundary vertex has reason to move only if it lies on a fixed vertex, or if
// inner edges coincide, too.
enum class Tie { Fixed, Boundary, Curve, None };

bool isAtKeptJoint(const WorkingMesh& mesh, Vertex v) {
  bool isKept = false;
  if (mesh.surface().built().keepsJoints)
    mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { isKept = isKept || mesh.isKept(h); });
  return isKept;
}

Tie tieOf(const WorkingMesh& mesh, Vertex v) {
  if (isAtKeptJoint(mesh, v)) return Tie::Fixed;
  const VertexKind kind = mesh.kind(v);
  if (!mesh.mesh().isBoundary(v)) return kind == VertexKind::Interior ? Tie::None : Tie::Curve;
  if (kind == VertexKind::Corner) return Tie::Fixed;
  return mesh.surface().curves().chains()[mesh.on(v).chain].kept ? Tie::Fixed : Tie::Boundary;
}

struct Written {
  Vec3 position;
  Tie tie;
  Vertex vertex;

  auto key() const { return std::tuple(position[0], position[1], position[2], tie, vertex.index); }
};

Written writtenAt(const Run& run, Vertex v) {
  return {written(run.mesh.position(v), run.asked.rule.quantum), tieOf(run.mesh, v), v};
}

// The vertices that share their places with others.
std::vector<Written> inOnePlace(const Run& run) {
  std::vector<Vertex> vertices;
  std::vector<Vec3> places;
  for (Vertex v{0}; v.index < run.mesh.mesh().vertexCapacity(); ++v.index) {
    if (!run.mesh.mesh().isAlive(v)) continue;
    vertices.push_back(v);
    places.push_back(written(run.mesh.position(v), run.asked.rule.quantum));
  }
  const std::vector<Index> first = weld(places);
  std::vector<char> isShared(first.size(), 0);
  for (Index i = 0; i < first.size(); ++i)
    if (first[i] != i) isShared[i] = isShared[first[i]] = 1;
  std::vector<Written> result;
  for (Index i = 0; i < first.size(); ++i)
    if (isShared[i]) result.push_back(writtenAt(run, vertices[i]));
  return result;
}

// Whether inner edges lead from v and w, which coincide, to one place.
bool shareChord(const Run& run, Vertex v, Vertex w) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const auto forEachInside = [&](Vertex from, auto visit) {
    mesh.forEachOutgoing(from, [&](Halfedge h) {
      if (!mesh.isBoundary(h))
        visit(written(run.mesh.position(mesh.tip(h)), run.asked.rule.quantum));
    });
  };
  bool found = false;
  forEachInside(v, [&](const Vec3& to) {
    forEachInside(w, [&](const Vec3& other) { found = found || to == other; });
  });
  return found;
}

// Of the vertices at one place all but one of the firmest; of boundary vertices only those with
// reason to move, see Tie.
std::vector<Written> onOthers(const Run& run) {
  std::vector<Written> all = inOnePlace(run);
  std::sort(all.begin(), all.end(),
            [](const Written& a, const Written& b) { return a.key() < b.key(); });
  std::vector<Written> result;
  std::size_t first = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].position != all[first].position)
      first = i;
    else if (all[i].tie > Tie::Boundary || all[i].tie > all[first].tie ||
             (all[i].tie == Tie::Boundary && shareChord(run, all[i].vertex, all[first].vertex)))
      result.push_back(all[i]);
  }
  return result;
}

// Where the surface is folded onto itself, normals say nothing about a move within it.
FidelityRule ruleOfMoves(const Run& run) {
  FidelityRule rule = lenient(run);
  rule.mode = Fidelity::Fold;
  return rule;
}

// step: the share of the way to the next vertex along v's curve.
void moveAlong(Run& run, Vertex v, double step) {
  const auto [chain, own] = run.mesh.on(v);
  const double next = run.mesh.onChain(curveNeighbors(run.mesh, v).after, chain).arc;
  const CurvePoint to{chain, own + step * (next - own)};
  proposePlacement(run.mesh, v, run.mesh.onCurve(to), run.scratch.change);
  commit(run, ruleOfMoves(run));
}

// step: the share of the way to the middle of the edge opposite to v.
void moveInside(Run& run, Vertex v, double step) {
  const FidelityRule rule = ruleOfMoves(run);
  const Vec3 before = written(run.mesh.position(v), run.asked.rule.quantum);
  bool isDone = false;
  run.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    if (isDone) return;
    const StarPoint to{h, {1 - step, step / 2, step / 2}};
    isDone = proposeRelocation(run.mesh, run.projector, to, run.scratch.change) &&
             written(run.scratch.change.place.position, run.asked.rule.quantum) != before &&
             commit(run, rule);
  });
}

}  // namespace

std::size_t moveApart(Run& run) {
  // Vertices of sheets that are alike may move to one place again: steps halve, and one vertex of
  // each place stays.
  constexpr int kMostHalvings = 4;
  double step = 0.25;
  std::vector<Written> others = onOthers(run);
  for (int i = 0; i < kMostHalvings && !others.empty(); ++i, step /= 2) {
    for (const Written& one : others)
      if (one.tie == Tie::None) moveInside(run, one.vertex, step);
    // Looks again, since inner vertices have moved apart.
    for (const Written& one : onOthers(run))
      if (one.tie == Tie::Boundary) moveAlong(run, one.vertex, step);
    others = onOthers(run);
  }
  if (!others.empty()) fires("apart: vertices stay coincident");
  return others.size();
}

}  // namespace remesher
