// SPDX-License-Identifier: MIT
#include "remesh/quads/field/singularities.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <tuple>
#include <vector>

#include "mesh/shortest_paths.h"

namespace remesher {

namespace {

// Opposite singular vertices nearer than this, in sides of quads, cancel each other.
constexpr double kCancelWithin = 1.5;

// Shortest paths along edges from one vertex, as far as `reach`.
class Ways {
 public:
  Ways(const WorkingMesh& mesh, double reach, WorkBudget& work)
      : mesh_(mesh),
        reach_(reach),
        work_(work),
        paths_(mesh.mesh().vertexCapacity()),
        by_(mesh.mesh().vertexCapacity()) {}

  // The vertices within reach, in the order of their numbers.
  std::vector<Vertex> from(Vertex start) {
    paths_.clear();
    paths_.reach(start, 0);
    by_[start] = {};
    for (Vertex v; (v = paths_.leave());)
      mesh_.mesh().forEachOutgoing(v, [&](Halfedge h) {
        const Vertex next = mesh_.mesh().tip(h);
        const double there = paths_[v] + (mesh_.position(next) - mesh_.position(v)).norm();
        if (there > reach_ || mesh_.kind(next) != VertexKind::Interior) return;
        if (paths_.reach(next, there)) by_[next] = h;
      });
    std::vector<Vertex> found = paths_.reached();
    work_.spend(double(found.size()));
    std::sort(found.begin(), found.end());
    return found;
  }

  double distance(Vertex v) const { return paths_[v]; }

  // From the start to v, last edge first.
  std::vector<Halfedge> wayTo(Vertex v) const {
    std::vector<Halfedge> way;
    for (Halfedge h = by_[v]; h; h = by_[mesh_.mesh().origin(h)]) way.push_back(h);
    return way;
  }

 private:
  const WorkingMesh& mesh_;
  const double reach_;
  WorkBudget& work_;
  ShortestPaths paths_;
  VertexData<Halfedge> by_;  // per vertex the last edge of the path to it
};

using Pair = std::tuple<double, Vertex, Vertex>;  // distance, positive vertex, negative vertex

std::vector<Pair> nearPairs(const WorkingMesh& mesh, const VertexData<int>& indices, Ways& ways,
                            const WorkBudget& work) {
  std::vector<Pair> pairs;
  for (Index i = 0; i < indices.size(); ++i) {
    if (indices[Vertex(i)] <= 0 || mesh.kind(Vertex(i)) != VertexKind::Interior) continue;
    if (work.isSpent()) break;
    for (const Vertex v : ways.from(Vertex(i)))
      if (indices[v] < 0) pairs.emplace_back(ways.distance(v), Vertex(i), v);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Turns a quarter more across each edge of the way: the index falls by one quarter at the start and
// rises by one at the end.
void turnAlong(CrossField& field, const HalfedgeMesh& mesh, const std::vector<Halfedge>& way) {
  for (const Halfedge h : way) {
    ++field.turn[h];
    --field.turn[mesh.twin(h)];
  }
}

// Moves all but one quarter of a vertex with a larger index to the farthest regular vertices within
// reach: a vertex of two quads is not allowed, and one of six becomes two of five.
bool partDoubles(CrossField& field, const WorkingMesh& mesh, VertexData<int>& indices, Ways& ways,
                 const WorkBudget& work) {
  bool isChanged = false;
  for (Index i = 0; i < indices.size(); ++i)
    for (const Vertex v(i); std::abs(indices[v]) > 1 && !work.isSpent();) {
      const std::vector<Vertex> found = ways.from(v);
      const auto freedom = [&](Vertex w) { return indices[w] == 0 ? ways.distance(w) : -1; };
      const Vertex farthest = *std::max_element(
          found.begin(), found.end(), [&](Vertex a, Vertex b) { return freedom(a) < freedom(b); });
      if (indices[farthest] != 0) break;
      std::vector<Halfedge> way = ways.wayTo(farthest);
      const int sign = indices[v] > 0 ? 1 : -1;
      if (sign < 0)
        for (Halfedge& h : way) h = mesh.mesh().twin(h);
      turnAlong(field, mesh.mesh(), way);
      indices[v] -= sign;
      indices[farthest] += sign;
      isChanged = true;
    }
  return isChanged;
}

}  // namespace

VertexData<int> quarterIndices(const CrossField& field, const WorkingMesh& mesh,
                               const FaceFrames& frames) {
  const HalfedgeMesh& m = mesh.mesh();
  VertexData<int> indices(m.vertexCapacity(), 0);
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!m.isAlive(v) || m.isBoundary(v)) continue;
    double turn = 2 * std::numbers::pi;  // less the angles around v: the angle defect
    m.forEachOutgoing(v, [&](Halfedge h) {
      const Halfedge back = m.prev(h);
      const double angle = frames.angle(back) + std::numbers::pi - frames.angle(h);
      turn -= angle - 2 * std::numbers::pi * std::floor(angle / (2 * std::numbers::pi));
      turn += field.bend(frames, m, back);
    });
    indices[v] = int(std::lround(turn / (std::numbers::pi / 2)));
  }
  return indices;
}

void cancelPairs(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames, double reach,
                 WorkBudget& work) {
  VertexData<int> indices = quarterIndices(field, mesh, frames);
  Ways ways(mesh, reach, work);
  bool isChanged = partDoubles(field, mesh, indices, ways, work);
  for (const auto& [distance, positive, negative] : nearPairs(mesh, indices, ways, work)) {
    if (indices[positive] <= 0 || indices[negative] >= 0) continue;
    if (work.isSpent()) break;
    ways.from(positive);
    turnAlong(field, mesh.mesh(), ways.wayTo(negative));
    --indices[positive];
    ++indices[negative];
    isChanged = true;
  }
  if (isChanged) smoothAngles(field, mesh, frames);
}

CrossField makeSmoothField(const WorkingMesh& mesh, const FaceFrames& frames, double length,
                           WorkBudget& work, const FieldWishes& wishes) {
  CrossField field = makeCrossField(mesh, frames, length, wishes);
  cancelPairs(field, mesh, frames, kCancelWithin * length, work);
  return field;
}

}  // namespace remesher
