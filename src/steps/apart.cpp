// SPDX-License-Identifier: MIT
#include "steps/apart.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace remesher {

namespace {

// Boundaries may have been cut apart where they lie on each other, and are to be joined again.
enum class Tie { Boundary, Curve, None };

Tie tieOf(const WorkingMesh& mesh, Vertex v) {
  if (mesh.mesh().isBoundary(v)) return Tie::Boundary;
  return mesh.kind(v) == VertexKind::Interior ? Tie::None : Tie::Curve;
}

struct Written {
  Vec3 position;
  Tie tie;
  Vertex vertex;

  auto key() const { return std::tuple(position[0], position[1], position[2], tie, vertex.index); }
};

Written writtenAt(const Run& run, Vertex v) {
  return {written(run.mesh.position(v), run.rule.grain), tieOf(run.mesh, v), v};
}

// Those beside others in one coordinate: few, mostly.
std::vector<Written> inOnePlane(const Run& run) {
  std::vector<std::pair<double, Vertex>> all;
  for (Vertex v{0}; v.index < run.mesh.mesh().vertexCapacity(); ++v.index)
    if (run.mesh.mesh().isAlive(v))
      all.emplace_back(written(run.mesh.position(v), run.rule.grain).x(), v);
  std::sort(all.begin(), all.end());
  std::vector<Written> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double x = all[i].first;
    if ((i > 0 && all[i - 1].first == x) || (i + 1 < all.size() && all[i + 1].first == x))
      result.push_back(writtenAt(run, all[i].second));
  }
  return result;
}

// Of those at one place all but the first of the least free; of boundaries none.
std::vector<Written> onOthers(const Run& run) {
  std::vector<Written> all = inOnePlane(run);
  std::sort(all.begin(), all.end(),
            [](const Written& a, const Written& b) { return a.key() < b.key(); });
  std::vector<Written> result;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].tie != Tie::Boundary && all[i].position == all[i - 1].position)
      result.push_back(all[i]);
  return result;
}

// step: of the way to the middle of the edge opposite to v. Where the surface is folded onto itself
// normals say nothing of a move within it.
void moveInside(Run& run, Vertex v, double step) {
  FidelityRule rule = lenient(run);
  rule.mode = Fidelity::Fold;
  const Vec3 before = written(run.mesh.position(v), run.rule.grain);
  bool isDone = false;
  run.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    if (isDone) return;
    const StarPoint to{h, {1 - step, step / 2, step / 2}};
    isDone = proposeRelocation(run.mesh, run.projector, to, run.change) &&
             written(run.change.place.position, run.rule.grain) != before && commit(run, rule);
  });
}

}  // namespace

std::size_t moveApart(Run& run) {
  // Sheets that are alike may take their vertices to one place again; steps halve, and one vertex
  // of each place stays.
  constexpr int kTries = 4;
  double step = 0.25;
  std::vector<Written> others = onOthers(run);
  for (int i = 0; i < kTries && !others.empty(); ++i, step /= 2) {
    for (const Written& one : others)
      if (one.tie == Tie::None) moveInside(run, one.vertex, step);
    others = onOthers(run);
  }
  return others.size();
}

}  // namespace remesher
