// SPDX-License-Identifier: MIT
#include "remesh/steps/valence.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "remesh/gate/angles.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/relax.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

constexpr std::uint32_t kSeed = 2003;
constexpr double kStartProbability = 0.5;
constexpr double kSmallestAngle = radians(25);
// Rounds.
constexpr int kDelaunayEvery = 5;
// The weight of a boundary vertex: it has fewer neighbours to even out an irregular valence, which
// is better inside. Not on kept boundaries, whose edges are as long as they happen to be.
constexpr int kAtBoundary = 2;

// At a boundary, the number of edges that divides the angle there into parts of about 60°.
int idealValence(const WorkingMesh& mesh, Vertex v) {
  const HalfedgeMesh& m = mesh.mesh();
  if (!m.isBoundary(v)) return 6;
  if (mesh.isKept(m.outgoing(v))) return 4;
  double angle = 0;
  const Vec3& at = mesh.position(v);
  m.forEachOutgoing(v, [&](Halfedge h) {
    const Vec3 a = mesh.position(m.tip(h)) - at;
    const Vec3 b = mesh.position(m.opposite(h)) - at;
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
  });
  return 1 + std::max(1, int(std::lround(angle / radians(60))));
}

// How far each valence is from its ideal; kept up to date while flips are made.
class ValenceExcess {
 public:
  explicit ValenceExcess(const WorkingMesh& working)
      : working_(working),
        mesh_(working.mesh()),
        excess_(working.mesh().vertexCapacity(), 0),
        weight_(working.mesh().vertexCapacity(), 1) {
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh_.isAlive(v)) continue;
      count(v);
      if (!mesh_.isBoundary(v)) continue;
      onBoundary_.push_back(v);
      if (!working.isKept(mesh_.outgoing(v))) weight_[v] = kAtBoundary;
    }
  }

  // To be called when vertices have moved: only boundary ideals depend on positions.
  void moved() {
    for (const Vertex v : onBoundary_) count(v);
  }

  // The change of Σ weight·excess² by flipping h: the ends lose a neighbour, the opposite two gain
  // one.
  int flipCost(Halfedge h) const {
    return cost(mesh_.origin(h), -1) + cost(mesh_.tip(h), -1) + cost(mesh_.opposite(h), 1) +
           cost(mesh_.opposite(mesh_.twin(h)), 1);
  }

  void flipped(Halfedge edge) {
    ++excess_[mesh_.origin(edge)];
    ++excess_[mesh_.tip(edge)];
    --excess_[mesh_.opposite(edge)];
    --excess_[mesh_.opposite(mesh_.twin(edge))];
  }

 private:
  void count(Vertex v) { excess_[v] = mesh_.valence(v) - idealValence(working_, v); }
  int cost(Vertex v, int change) const { return weight_[v] * (1 + 2 * change * excess_[v]); }

  const WorkingMesh& working_;
  const HalfedgeMesh& mesh_;
  VertexData<int> excess_;
  VertexData<int> weight_;
  std::vector<Vertex> onBoundary_;
};

template <class Accept>
std::size_t flipsWhere(Run& run, ValenceExcess& excess, double smallestAngle, Accept accept) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t flips = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h) || mesh.isBoundary(h) || run.mesh.isCurve(h)) continue;
    if (!accept(excess.flipCost(h)) || !proposeFlip(run.mesh, h, run.scratch.change)) continue;
    if (smallestComingAngle(run.mesh, run.scratch.change) < smallestAngle) continue;
    if (!commit(run)) continue;
    excess.flipped(mesh.prev(h));
    ++flips;
  }
  return flips;
}

// Where patches are needed, vertices are few, and a sweep over all of them is worth its time.
void giveWay(Run& run) {
  if (run.projector.walks())
    relax(run, 1);
  else
    laplacianSweep(run);
}

}  // namespace

std::size_t valenceFlips(Run& run) {
  ValenceExcess excess(run.mesh);
  return flipsWhere(run, excess, 0, [](int cost) { return cost < 0; });
}

void annealValences(Run& run, int rounds, const Progress& progress) {
  Random random(kSeed);
  std::optional<ValenceExcess> excess(run.mesh);
  for (int i = 0; i < rounds; ++i) {
    progress.at(double(i) / rounds);
    const double probability = kStartProbability * (1 - double(i) / rounds);
    flipsWhere(run, *excess, kSmallestAngle,
               [&](int cost) { return cost < 0 || (cost == 0 && random.uniform() < probability); });
    giveWay(run);
    excess->moved();
    flipsWhere(run, *excess, kSmallestAngle, [](int cost) { return cost < 0; });
    giveWay(run);
    excess->moved();
    if ((i + 1) % kDelaunayEvery != 0) continue;
    if (delaunayFlips(run.mesh, run.asked.rule) > 0) excess.emplace(run.mesh);
  }
  run.mesh.unsettleAll();
}

}  // namespace remesher
