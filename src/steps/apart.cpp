// SPDX-License-Identifier: MIT
#include "steps/apart.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace remesher {

namespace {

struct Written {
  Vec3 position;
  bool mayMove;
  Vertex vertex;

  auto key() const {
    return std::tuple(position[0], position[1], position[2], mayMove, vertex.index);
  }
};

std::vector<Vertex> verticesOnOthers(const Run& run) {
  std::vector<Written> all;
  for (Vertex v{0}; v.index < run.mesh.mesh().vertexCapacity(); ++v.index)
    if (run.mesh.mesh().isAlive(v))
      all.push_back({written(run.mesh.position(v), run.rule.grain),
                     run.mesh.kind(v) == VertexKind::Interior, v});
  std::sort(all.begin(), all.end(),
            [](const Written& a, const Written& b) { return a.key() < b.key(); });
  std::vector<Vertex> result;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].mayMove && all[i].position == all[i - 1].position) result.push_back(all[i].vertex);
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

void moveApart(Run& run) {
  // Sheets that are alike may take their vertices to one place again; steps halve, and one vertex
  // of each place stays.
  constexpr int kTries = 4;
  double step = 0.25;
  for (int i = 0; i < kTries; ++i, step /= 2) {
    const std::vector<Vertex> vertices = verticesOnOthers(run);
    if (vertices.empty()) return;
    for (const Vertex v : vertices) moveInside(run, v, step);
  }
}

}  // namespace remesher
