// SPDX-License-Identifier: MIT
#include "schemes/valence.h"

#include "operators/angles.h"
#include "operators/delaunay.h"
#include "schemes/sweeps.h"

namespace remesher {

namespace {

constexpr std::uint32_t kSeed = 2003;
constexpr double kStartProbability = 0.5;
constexpr double kSmallestAngle = radians(25);
constexpr int kDelaunayEvery = 5;

// How far each valence is from its ideal; kept up to date while flips are made.
class Excess {
 public:
  explicit Excess(const HalfedgeMesh& mesh) : mesh_(mesh), excess_(mesh.vertexCapacity(), 0) {
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (mesh.isAlive(v)) excess_[v] = mesh.valence(v) - (mesh.isBoundary(v) ? 4 : 6);
    }
  }

  // The change of Σ excess² by flipping h: the ends lose a neighbour, the opposite two gain one.
  int flipCost(Halfedge h) const {
    const int a = excess_[mesh_.origin(h)], b = excess_[mesh_.tip(h)];
    const int c = excess_[mesh_.opposite(h)], d = excess_[mesh_.opposite(mesh_.twin(h))];
    return 2 * (c + d - a - b) + 4;
  }

  void flipped(Halfedge edge) {
    ++excess_[mesh_.origin(edge)];
    ++excess_[mesh_.tip(edge)];
    --excess_[mesh_.opposite(edge)];
    --excess_[mesh_.opposite(mesh_.twin(edge))];
  }

 private:
  const HalfedgeMesh& mesh_;
  VertexData<int> excess_;
};

template <class Accept>
std::size_t flipsWhere(Run& run, double smallestAngle, Accept accept) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  Excess excess(mesh);
  std::size_t flips = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h) || mesh.isBoundary(h) || run.mesh.isCurve(h)) continue;
    if (!accept(excess.flipCost(h)) || !proposeFlip(run.mesh, h, run.change)) continue;
    if (smallestComingAngle(run.mesh, run.change) < smallestAngle) continue;
    if (!commit(run)) continue;
    excess.flipped(mesh.prev(h));
    ++flips;
  }
  return flips;
}

}  // namespace

std::size_t valenceFlips(Run& run) {
  return flipsWhere(run, 0, [](int cost) { return cost < 0; });
}

void annealValences(Run& run, int rounds, const Progress& progress) {
  Random random(kSeed);
  for (int i = 0; i < rounds; ++i) {
    progress.at(double(i) / rounds);
    const double probability = kStartProbability * (1 - double(i) / rounds);
    flipsWhere(run, kSmallestAngle,
               [&](int cost) { return cost < 0 || (cost == 0 && random.uniform() < probability); });
    laplacianSweep(run);
    flipsWhere(run, kSmallestAngle, [](int cost) { return cost < 0; });
    laplacianSweep(run);
    if ((i + 1) % kDelaunayEvery == 0) delaunayFlips(run.mesh, run.rule);
  }
  run.mesh.unsettleAll();
}

}  // namespace remesher
