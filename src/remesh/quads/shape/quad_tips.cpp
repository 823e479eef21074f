// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/quad_tips.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/triangulated.h"
#include "remesh/quads/shape/quad_patch.h"
#include "remesh/quads/shape/smoothing.h"
#include "remesh/quads/shape/tip_distances.h"

namespace remesher {

namespace {

// In mean sides of quads: a vertex farther away is a tip.
constexpr double kTip = 0.3;

// The squared distance from p to the nearest triangle; to any, if that is `enough` or less.
double distanceFrom(const QuadMesh& mesh, const std::vector<Index>& triangles, const Vec3& p,
                    double enough) {
  double nearest = kInfinity;
  for (std::size_t i = 0; i < triangles.size() && nearest > enough; i += 3) {
    const Vec3 q = closestPoint(p, mesh.position(triangles[i]), mesh.position(triangles[i + 1]),
                                mesh.position(triangles[i + 2]));
    nearest = std::min(nearest, (q - p).squaredNorm());
  }
  return nearest;
}

// The squared distance to the original from p, which is on a quad.
double fromOriginal(const QuadMesh& mesh, const Four<Index>& quad, const Vec3& p,
                    const WorkingMesh& ground) {
  for (const Index v : quad)
    if (mesh.vertices[v].kind == VertexKind::Interior) {
      const SurfacePoint at = closestPointFrom(ground.surface(), mesh.vertices[v].at, p);
      return (ground.surface().position(at) - p).squaredNorm();
    }
  return 0;
}

// Those farther away than `least`, the farthest first: of each quad as many as it has corners.
std::vector<Tip> farthestFirst(std::vector<Tip> tips, std::size_t quads, double least) {
  std::erase_if(tips, [&](const Tip& tip) { return !(tip.distance > least); });
  std::stable_sort(tips.begin(), tips.end(),
                   [](const Tip& a, const Tip& b) { return a.distance > b.distance; });
  std::vector<int> ofQuad(quads, 0);
  std::erase_if(tips, [&](const Tip& tip) { return ++ofQuad[tip.quad()] > 4; });
  return tips;
}

class Reaching {
 public:
  Reaching(QuadMesh& mesh, const WorkingMesh& ground, double least, WorkBudget& work)
      : mesh_(mesh),
        least_(least),
        ground_(ground),
        work_(work),
        quads_(mesh.quads),
        sides_(mesh.vertices.size(), quads_),
        moving_(mesh, ground),
        isHeld_(mesh.vertices.size(), 0),
        ofQuad_(mesh.quads.size()) {}

  // Fits rectangles anew around the vertices moved to tips, which stay.
  void settle(int smoothings) {
    std::vector<char> isFixed(mesh_.vertices.size(), 1);
    for (const Index q : around_)
      for (const Index near : quadsNear(sides_, mesh_, q))
        for (const Index v : quads_[near]) isFixed[v] = isHeld_[v];
    around_.clear();
    smoothToRectangles(moving_, smoothings, isFixed);
    mendCorners(moving_, isFixed);
  }

  void run(const std::vector<Tip>& tips) {
    std::vector<std::vector<Tip>> before(quads_.size());
    ofQuad_.swap(before);
    std::set<Index> isNew;
    for (const Tip& tip : tips) isNew.insert(tip.vertex);
    for (std::size_t q = 0; q < before.size(); ++q)
      for (const Tip& tip : before[q])
        if (!isNew.contains(tip.vertex)) ofQuad_[q].push_back(tip);
    for (const Tip& tip : tips) ofQuad_[tip.quad()].push_back(tip);
    for (const Tip& tip : tips)
      if (!work_.isSpent()) reach(tip);
  }

 private:
  // Moves one of the corners of the nearest quad, the nearest first, to the tip.
  void reach(const Tip& tip) {
    const Vec3& p = position(tip);
    Four<Index> corners = quads_[tip.quad()];
    const auto distance = [&](Index v) { return (mesh_.position(v) - p).squaredNorm(); };
    std::sort(corners.begin(), corners.end(),
              [&](Index a, Index b) { return distance(a) < distance(b); });
    for (const Index v : corners) {
      if (moveTo(v, tip)) return;
    }
  }

  bool moveTo(Index v, const Tip& tip) {
    const Placement& here = mesh_.vertices[v];
    if (here.kind == VertexKind::Corner) return false;
    const bool isOnCurve = here.kind == VertexKind::Curve;
    if (isOnCurve && here.on.chain != tip.on.chain) return false;
    const std::vector<Index> near = quadsNear(sides_, mesh_, sides_.outgoing(v) / 4);
    const QuadPatch patch = patchOf(mesh_, sides_, near);
    const double near2 = least_ * least_;
    if (distanceFrom(patch.mesh, trianglesOf(patch.mesh), position(tip), near2) <= near2)
      return true;
    const Placement place = isOnCurve ? ground_.onCurve(tip.on)
                                      : ground_.onSurface(ground_.surface().at(Vertex(tip.vertex)));
    if (tryAt(patch, near, v, place)) return true;
    const Vec3 middle = (here.position + place.position) / 2;
    const auto half = moving_.placeNear(v, middle);
    return half && tryAt(patch, near, v, *half);
  }

  bool tryAt(QuadPatch patch, const std::vector<Index>& near, Index v, const Placement& place) {
    const double farthest = farthestFrom(patch.mesh, near, kInfinity);
    MovingQuads moving(patch.mesh, ground_);
    const double least = std::min(worst(moving), 2 * kLeastSine);
    for (std::size_t i = 0; i < patch.outer.size(); ++i) {
      patch.isRim[i] |= isHeld_[patch.outer[i]];
      if (patch.outer[i] != v) continue;
      moving.move(Index(i), place);
      patch.isRim[i] = 1;
    }
    work_.spend(double(2 * patch.mesh.quads.size()));
    if (farthestFrom(patch.mesh, near, farthest) >= farthest) return false;
    work_.spend(double(mendCorners(moving, patch.isRim)));
    if (worst(moving) < least || farthestFrom(patch.mesh, near, farthest) >= farthest) return false;
    for (std::size_t i = 0; i < patch.outer.size(); ++i)
      mesh_.vertices[patch.outer[i]] = patch.mesh.vertices[i];
    isHeld_[v] = 1;
    around_.insert(near.begin(), near.end());
    return true;
  }

  const Vec3& position(const Tip& tip) const {
    return ground_.surface().positions()[Vertex(tip.vertex)];
  }

  static double worst(const MovingQuads& quads) {
    double least = 1;
    for (Index q = 0; q < quads.mesh().quads.size(); ++q) least = std::min(least, quads.quality(q));
    return least;
  }

  // The largest squared distance from the patch to its tips, or from its quads to the original; any
  // that is `most` or more, if there is one.
  double farthestFrom(const QuadMesh& patch, const std::vector<Index>& quads, double most) const {
    const std::vector<Index> triangles = trianglesOf(patch);
    double farthest = 0;
    for (const Index q : quads)
      for (const Tip& tip : ofQuad_[q])
        if (farthest < most)
          farthest = std::max(farthest, distanceFrom(patch, triangles, position(tip), farthest));
    for (std::size_t q = 0; q < patch.quads.size() && farthest < most; ++q) {
      // The middle of the diagonal.
      const Vec3 p = (patch.position(triangles[6 * q]) + patch.position(triangles[6 * q + 2])) / 2;
      farthest = std::max(farthest, fromOriginal(patch, patch.quads[q], p, ground_));
    }
    return farthest;
  }

  QuadMesh& mesh_;
  const double least_;
  const WorkingMesh& ground_;
  WorkBudget& work_;
  const std::vector<Four<Index>> quads_;
  const QuadSides sides_;
  MovingQuads moving_;
  std::vector<char> isHeld_;
  std::set<Index> around_;  // quads whose vertices have moved since the last fit
  std::vector<std::vector<Tip>> ofQuad_;
};

}  // namespace

bool reachTips(QuadMesh& mesh, const WorkingMesh& ground, int smoothings, WorkBudget& work) {
  const double least = kTip * meanSide(mesh);
  std::vector<Tip> possible = possibleTips(ground.surface());
  Reaching reaching(mesh, ground, least, work);
  std::vector<Placement> best = mesh.vertices;
  double farthest = kInfinity;
  bool isMoved = false;
  for (;;) {
    measure(possible, QuadTree(mesh), ground.surface(), least);
    const std::vector<Tip> tips = farthestFirst(possible, mesh.quads.size(), least);
    if (tips.empty()) return isMoved;
    // A round that gains less than a hundredth is followed by others that gain nothing.
    if (!(tips.front().distance < 0.99 * farthest)) break;
    const bool isFirst = std::isinf(farthest);
    farthest = tips.front().distance;
    best = mesh.vertices;
    if (!isFirst) reaching.settle(smoothings);
    reaching.run(tips);
    isMoved = true;
  }
  mesh.vertices = std::move(best);
  return isMoved;
}

}  // namespace remesher
