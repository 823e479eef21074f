// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/fairing.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/triangulated.h"
#include "remesh/quads/shape/fair_system.h"
#include "remesh/quads/shape/quad_star.h"
#include "remesh/quads/shape/smoothing.h"
#include "remesh/quads/shape/tip_distances.h"

namespace remesher {

namespace {

constexpr int kFairings = 12;
// Of its last step, which each vertex makes again [Polyak 1964].
constexpr double kMomentum = 0.6;
// Vertices of the original farther away than this share of the mean side draw the quads, in each
// step by kPull times what lacks more.
constexpr double kReach = 0.22, kPull = 0.6;
// A step that would spoil a quad is halved around it, up to so many times.
constexpr int kHalvings = 4;

// The rectangle that a quad should be like, bent as the quad is: only its angles are at fault.
Quad bentRectangle(const Quad& corners) {
  Quad rectangle = fittedRectangle(corners, kSquareness);
  const Vec3 normal = areaVector(corners).normalized();
  const Vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  for (std::size_t i = 0; i < 4; ++i) rectangle[i] += normal.dot(corners[i] - middle) * normal;
  return rectangle;
}

class Fairing {
 public:
  Fairing(QuadMesh& mesh, const WorkingMesh& ground, WorkBudget& work)
      : mesh_(mesh),
        ground_(ground),
        work_(work),
        moving_(mesh, ground),
        system_(mesh, moving_.sides()),
        reach_(kReach * meanSide(mesh)),
        last_(mesh.vertices),
        forces_(mesh.vertices.size(), Vec3::Zero()),
        possible_(possibleTips(ground.surface())) {
    for (Index q = 0; q < mesh.quads.size(); ++q) {
      qualities_.push_back(moving_.quality(q));
      middles_.push_back(mesh.vertices[startOf(q)].at);
    }
  }

  void run() {
    if (system_.count() == 0) return;
    for (int i = 0; i < kFairings && !work_.isSpent(); ++i) {
      pull();
      step();
    }
  }

 private:
  // A corner from which the quad's middle is reached.
  Index startOf(Index quad) const {
    for (const Index v : mesh_.quads[quad])
      if (system_.isFree(v)) return v;
    return mesh_.quads[quad][0];
  }

  // What lacks at tips is summed up over the steps, so that they are reached in the end, whatever
  // the smoothness of rows wants. Several tips draw a vertex by their mean.
  void pull() {
    const QuadTree tree(mesh_);
    measure(possible_, tree, ground_.surface(), reach_);
    std::vector<Vec3> ways(mesh_.vertices.size(), Vec3::Zero());
    std::vector<double> weights(mesh_.vertices.size(), 0);
    for (const Tip& tip : possible_) {
      if (tip.distance <= reach_) continue;
      const Vec3& p = ground_.surface().positions()[Vertex(tip.vertex)];
      const auto [a, b, c] = (*tree).corners(tip.triangle);
      const Vec3 shares = closestBarycentric(p, a, b, c);
      const Vec3 way = p - (shares[0] * a + shares[1] * b + shares[2] * c);
      const Vec3 lacking = (1 - reach_ / tip.distance) * way;
      const std::array<Index, 3> corners = tree.corners(tip.triangle);
      for (std::size_t i = 0; i < 3; ++i) {
        const double share = shares[Eigen::Index(i)];
        ways[corners[i]] += share * share / shares.squaredNorm() * lacking;
        weights[corners[i]] += share;
      }
    }
    for (Index v = 0; v < forces_.size(); ++v)
      if (weights[v] > 0) forces_[v] += kPull / weights[v] * ways[v];
  }

  // All wants are those of the places to which each vertex's last step would bring it again.
  void step() {
    system_.clear();
    std::vector<Vec3> ahead;
    for (Index v = 0; v < last_.size(); ++v) {
      const Vec3& p = mesh_.position(v);
      ahead.push_back(p + kMomentum * (p - last_[v].position));
      if (!system_.isFree(v)) continue;
      system_.wantVertex(v, ahead[v] + ground_.surface().position(mesh_.vertices[v].at) - p);
      system_.draw(v, forces_[v]);
    }
    for (Index q = 0; q < mesh_.quads.size(); ++q) {
      const auto& [a, b, c, d] = mesh_.quads[q];
      system_.wantShape(q, bentRectangle({ahead[a], ahead[b], ahead[c], ahead[d]}));
      const Vec3 middle = (ahead[a] + ahead[b] + ahead[c] + ahead[d]) / 4;
      middles_[q] = closestPointFrom(ground_.surface(), middles_[q], middle);
      system_.wantMiddle(q, ground_.surface().position(middles_[q]));
    }
    last_ = mesh_.vertices;
    const std::vector<Vec3> places = system_.solve();
    for (Index v = 0; v < places.size(); ++v) moveTo(v, places[v]);
    keepSound();
  }

  void moveTo(Index v, const Vec3& p) {
    if (!system_.isFree(v)) return;
    Placement place =
        ground_.onSurface(closestPointFrom(ground_.surface(), mesh_.vertices[v].at, p));
    if (!ground_.surface().isFlatAt(place.at)) place.position = p;
    moving_.move(v, place);
  }

  // Around quads that became worse than both before and 30° all vertices go back, first by halves,
  // and at once where no work is left.
  void keepSound() {
    std::vector<double> now(mesh_.quads.size());
    std::vector<Index> open(mesh_.quads.size()), bad;
    std::iota(open.begin(), open.end(), 0);
    for (int round = 0; !open.empty(); ++round) {
      work_.spend(double(open.size()));
      bad.clear();
      for (const Index q : open) {
        now[q] = moving_.quality(q);
        if (now[q] < std::min(kEnough, qualities_[q])) bad.push_back(q);
      }
      open.clear();
      for (const Index q : bad)
        for (const Index v : mesh_.quads[q]) {
          const Vec3 &here = mesh_.position(v), &before = last_[v].position;
          if (here == before) continue;
          if (round < kHalvings && !work_.isSpent())
            moveTo(v, (here + before) / 2);
          else
            moving_.move(v, last_[v]);
          moving_.sides().forEachOutgoing(v, [&](Index side) { open.push_back(side / 4); });
        }
    }
    qualities_ = std::move(now);
  }

  QuadMesh& mesh_;
  const WorkingMesh& ground_;
  WorkBudget& work_;
  MovingQuads moving_;
  FairSystem system_;
  const double reach_;
  std::vector<Placement> last_;  // before the last step
  std::vector<Vec3> forces_;     // per vertex
  std::vector<Tip> possible_;
  std::vector<double> qualities_;      // per quad
  std::vector<SurfacePoint> middles_;  // per quad: the place nearest to its middle
};

}  // namespace

void fair(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work) {
  Fairing(quads, ground, work).run();
}

}  // namespace remesher
