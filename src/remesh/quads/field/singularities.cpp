// SPDX-License-Identifier: MIT
#include "remesh/quads/field/singularities.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace remesher {

namespace {

// Opposite singular vertices nearer than this, in sides of quads, cancel each other.
constexpr double kCancelWithin = 1.5;

// Shortest ways along edges from one vertex, as far as `reach`.
class Ways {
 public:
  Ways(const WorkingMesh& mesh, Vertex from, double reach) : mesh_(mesh) {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    found_[from] = {0, Halfedge()};
    open.push({0, from});
    while (!open.empty()) {
      const double far = open.top().first;
      const Vertex v = open.top().second;
      open.pop();
      if (far > found_.at(v).distance) continue;
      mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
        const Vertex next = mesh.mesh().tip(h);
        const double there = far + (mesh.position(next) - mesh.position(v)).norm();
        if (there > reach || mesh.kind(next) != VertexKind::Interior) return;
        const auto known = found_.find(next);
        if (known != found_.end() && known->second.distance <= there) return;
        found_[next] = {there, h};
        open.push({there, next});
      });
    }
  }

  struct Arrival {
    double distance;
    Halfedge by;  // the last edge of the way
  };
  const std::map<Vertex, Arrival>& found() const { return found_; }

  // From the start to v, last edge first.
  std::vector<Halfedge> wayTo(Vertex v) const {
    std::vector<Halfedge> way;
    for (Halfedge h = found_.at(v).by; h; h = found_.at(mesh_.mesh().origin(h)).by)
      way.push_back(h);
    return way;
  }

 private:
  const WorkingMesh& mesh_;
  std::map<Vertex, Arrival> found_;
};

using Pair = std::tuple<double, Vertex, Vertex>;  // distance, positive vertex, negative vertex

std::vector<Pair> nearPairs(const WorkingMesh& mesh, const VertexData<int>& indices, double reach,
                            WorkBudget& work) {
  std::vector<Pair> pairs;
  for (Index i = 0; i < indices.size(); ++i) {
    if (indices[Vertex(i)] <= 0 || mesh.kind(Vertex(i)) != VertexKind::Interior) continue;
    if (work.isSpent()) break;
    const Ways ways(mesh, Vertex(i), reach);
    work.spend(double(ways.found().size()));
    for (const auto& [v, arrival] : ways.found())
      if (indices[v] < 0) pairs.emplace_back(arrival.distance, Vertex(i), v);
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
bool partDoubles(CrossField& field, const WorkingMesh& mesh, VertexData<int>& indices, double reach,
                 WorkBudget& work) {
  bool isChanged = false;
  for (Index i = 0; i < indices.size(); ++i)
    for (const Vertex v(i); std::abs(indices[v]) > 1 && !work.isSpent();) {
      const Ways ways(mesh, v, reach);
      work.spend(double(ways.found().size()));
      const auto isNearer = [&](const auto& a, const auto& b) {
        return (indices[a.first] == 0 ? a.second.distance : -1) <
               (indices[b.first] == 0 ? b.second.distance : -1);
      };
      const auto farthest = std::max_element(ways.found().begin(), ways.found().end(), isNearer);
      if (indices[farthest->first] != 0) break;
      std::vector<Halfedge> way = ways.wayTo(farthest->first);
      const int sign = indices[v] > 0 ? 1 : -1;
      if (sign < 0)
        for (Halfedge& h : way) h = mesh.mesh().twin(h);
      turnAlong(field, mesh.mesh(), way);
      indices[v] -= sign;
      indices[farthest->first] += sign;
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
  bool isChanged = partDoubles(field, mesh, indices, reach, work);
  for (const auto& [distance, positive, negative] : nearPairs(mesh, indices, reach, work)) {
    if (indices[positive] <= 0 || indices[negative] >= 0) continue;
    if (work.isSpent()) break;
    const Ways ways(mesh, positive, reach);
    work.spend(double(ways.found().size()));
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
