// SPDX-License-Identifier: MIT
#include "remesh/gate/excess.h"

#include <algorithm>
#include <cmath>

#include "remesh/gate/nearness.h"

namespace remesher {

namespace {

// A proof takes a few hundred pieces, but one large triangle may lie under thousands of small ones.
constexpr std::size_t kMostPiecesOfAll = 100'000;

// The place farthest from the mesh, of the triangle's corners and the place where the proof failed.
Lost farthest(Index triangle, const Vec3& failure, const TriangleTree& original,
              const TriangleTree& mesh) {
  const Triangle whole = original.corners(triangle);
  Lost lost{{}, -1};
  for (const Vec3& p : {failure, whole[0], whole[1], whole[2]}) {
    const double distance = std::sqrt(mesh.nearest(p).squaredDistance);
    if (distance <= lost.distance) continue;
    lost = {{Face(triangle), closestBarycentric(p, whole[0], whole[1], whole[2])}, distance};
  }
  return lost;
}

}  // namespace

ExcessSearch::ExcessSearch(const ErrorBound& bound)
    : bound_(bound),
      limits_{kSmallestPiece * bound.distance(), kMostPiecesOfAll},
      isDoubtful_(bound.original().order().size(), 1) {}

// Proofs relied on mesh triangles within the distance only: those near `gone` are in doubt.
void ExcessSearch::doubtAround(const Triangle& gone) {
  const Vec3 margin = Vec3::Constant(bound_.distance());
  Box box;
  for (const Vec3& p : gone) box.extend(p);
  bound_.original().visitOverlapping({box.low - margin, box.high + margin},
                                     [&](Index triangle) { isDoubtful_[triangle] = 1; });
}

bool ExcessSearch::isStray(const WorkingMesh& mesh, Face f) const {
  const SurfacePoint& start = mesh.at(mesh.mesh().vertices(f)[0]);
  NearTree toOriginal(bound_.original(), bound_.distance(), start.face.index);
  return findFailure(mesh.corners(f), limits_, toOriginal).has_value();
}

std::vector<Face> ExcessSearch::findStray(const WorkingMesh& mesh) {
  std::vector<Face> stray;
  seen_.resize(mesh.mesh().faceCapacity());
  for (Index i = 0; i < seen_.size(); ++i) {
    const Face f(i);
    const bool isAlive = mesh.mesh().isAlive(f);
    const auto now = isAlive ? std::optional(mesh.corners(f)) : std::nullopt;
    if (now != seen_[i].corners) {
      if (seen_[i].corners) doubtAround(*seen_[i].corners);
      seen_[i] = {now, isAlive && isStray(mesh, f)};
    }
    if (seen_[i].isStray) stray.push_back(f);
  }
  return stray;
}

std::vector<Lost> ExcessSearch::findLost(const WorkingMesh& mesh) {
  const std::vector<Index> triangles = mesh.mesh().triangles();
  const TriangleTree tree(mesh.positions().values(), triangles);
  NearTree toMesh(tree, bound_.distance());
  std::vector<Lost> lost;
  for (const Index t : bound_.original().order()) {
    if (!isDoubtful_[t]) continue;
    const auto failure = findFailure(bound_.original().corners(t), limits_, toMesh);
    isDoubtful_[t] = failure.has_value();
    if (failure) lost.push_back(farthest(t, failure->centre(), bound_.original(), tree));
  }
  std::stable_sort(lost.begin(), lost.end(),
                   [](const Lost& a, const Lost& b) { return a.distance > b.distance; });
  return lost;
}

Excess ExcessSearch::find(const WorkingMesh& mesh) {
  Excess excess;
  excess.stray = findStray(mesh);
  excess.lost = findLost(mesh);
  return excess;
}

}  // namespace remesher
