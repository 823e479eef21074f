// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/finish.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/mesh_tree.h"
#include "remesh/quads/mesh/quad_distance.h"
#include "remesh/quads/shape/fairing.h"
#include "remesh/quads/shape/mending.h"
#include "remesh/quads/shape/quad_tips.h"
#include "remesh/quads/shape/rewiring.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// More would undo the fairing around tips; and these must bring all quads as much nearer.
constexpr int kSweepsAfterFairing = 2;
constexpr double kClearlyNearer = 0.85;

}  // namespace

void settle(QuadMesh& quads, const WorkingMesh& ground) {
  MovingQuads moving(quads, ground);
  const std::vector<char> isFixed(quads.vertices.size(), 0);
  smoothToRectangles(moving, kSmoothingSweeps, isFixed);
  mendCorners(moving, isFixed);
}

void shape(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work) {
  settle(quads, ground);
  rewire(quads, ground, work);
}

// Fairing draws some vertices off tips again, for the rows' sake: they go back where the largest
// distance clearly falls.
void finish(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work) {
  reachTips(quads, ground, kSmoothingSweeps, work);
  fair(quads, ground, work);
  const QuadMesh fairOnes = quads;
  if (!reachTips(quads, ground, kSweepsAfterFairing, work)) return;
  const OriginalDistance distance(ground);
  if (distance.farthest(quads) > kClearlyNearer * distance.farthest(fairOnes)) quads = fairOnes;
}

void turnBack(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work) {
  const MeshTree original(ground.surface().mesh(), ground.surface().positions());
  const QuadFacing facing(original.triangles());
  rewire(quads, ground, work, &facing);
}

double unsoundShare(QuadMesh& quads, const WorkingMesh& ground) {
  const MovingQuads moving(quads, ground);
  std::size_t count = 0;
  for (Index q = 0; q < quads.quads.size(); ++q) count += moving.quality(q) < kLeastSine;
  return double(count) / double(std::max<std::size_t>(quads.quads.size(), 1));
}

double faultsOf(QuadMesh& quads, const WorkingMesh& ground) {
  const MovingQuads moving(quads, ground);
  double sum = 0;
  for (Index q = 0; q < quads.quads.size(); ++q)
    sum += std::pow(std::max(0.0, 1 - moving.quality(q) / kLeastSine), 2);
  return sum;
}

}  // namespace remesher
