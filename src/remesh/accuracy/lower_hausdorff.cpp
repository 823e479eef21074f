// SPDX-License-Identifier: MIT
#include "remesh/accuracy/lower_hausdorff.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "remesh/accuracy/narrowest.h"
#include "remesh/accuracy/places.h"
#include "remesh/accuracy/star_search.h"
#include "remesh/accuracy/tips.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/smoothing.h"

namespace remesher {

namespace {

// A move must lower a distance to less than this share.
constexpr double kGain = 0.99;
// If the largest distance is stuck, distances below this share of it are not worth a try.
constexpr double kNearMaximum = 0.8;

// The least number of triangles to try, and the number of vertices to each try in a large mesh,
// where few triangles decide.
constexpr std::size_t kTries = 100;
// Of quads: a moved vertex bends two rows, and more tries hardly lower the largest distance.
constexpr std::size_t kTriesOfQuads = 30;
// A point between two shells is far from both, and about as near to one as to the other: a try
// there may look at millions of the original's triangles. If a mesh passes through itself all over,
// a try may look at as many of the mesh's own.
constexpr std::size_t kLooksPerTry = 12'000;

// The smallest angle that a move must leave, in radians, and the one asked of the last try, which
// was in vain, if there was one.
struct Kept {
  double angle;
  std::optional<double> last;
};

// Lowers the distances of the triangles where they are largest, until nothing more can be done.
class Descent {
 public:
  explicit Descent(Run& run)
      : run_(run),
        mesh_(run.mesh.mesh()),
        distances_(run),
        crossings_(run.mesh),
        tries_(std::max(run.asked.areQuads ? kTriesOfQuads : kTries, mesh_.vertexCount() / kTries)),
        mostLooks_(looked() + kLooksPerTry * tries_) {
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (mesh_.isAlive(Face(i))) push(Face(i));
  }

  void run() {
    // Moves nearby may free stuck triangles.
    while (descend())
      for (const Face f : std::exchange(stuck_, {})) push(f);
  }

 private:
  using Entry = std::pair<double, Face>;

  void push(Face f) {
    queue_.emplace_back(distances_.of(f), f);
    std::push_heap(queue_.begin(), queue_.end());
  }

  Entry pop() {
    std::pop_heap(queue_.begin(), queue_.end());
    const Entry entry = queue_.back();
    queue_.pop_back();
    return entry;
  }

  std::size_t looked() const { return distances_.looked() + crossings_.looked(); }

  bool mayTry() const { return tries_ > 0 && looked() < mostLooks_; }

  // Returns whether anything moved.
  bool descend() {
    bool moved = false;
    double worst = kPlainlyNear * run_.sizes.mean();
    while (!queue_.empty() && mayTry() && queue_.front().first >= worst) {
      const auto [distance, f] = pop();
      if (distance != distances_.of(f)) continue;
      --tries_;
      if (lower(f) && distances_.of(f) < distance) {
        moved = true;
        continue;
      }
      stuck_.push_back(f);
      worst = std::max(worst, kNearMaximum * distance);
    }
    return moved;
  }

  bool lower(Face f) {
    std::optional<double> last;
    for (const double angle : {kWideAngle, kGood, kSound}) {
      const Kept kept{angle, last};
      if (moveCorner(f, kept) || flipSide(f, angle) || makeWay(f, kept)) return true;
      if (!isBeyond(kDoubtful, f)) return false;  // a smaller distance is not worth good angles
      last = angle;
    }
    // Polishing widens the angles beside a tip afterwards.
    const Kept kept{kFair, last};
    return isBeyond(kLostTip, f) && (moveCorner(f, kept) || makeWay(f, kept));
  }

  // share: of the target edge length.
  bool isBeyond(double share, Face f) const {
    const Vertex v = mesh_.vertices(f)[0];
    return distances_.of(f) > share * run_.sizes.at(run_.mesh.at(v));
  }

  // Boundaries are near enough already (see followBoundaries), and hubs take too long.
  bool isFixed(Vertex v) const {
    return run_.mesh.kind(v) == VertexKind::Corner || mesh_.isBoundary(v) ||
           distances_.hubs().contains(v);
  }

  // Curves show as outlines: for a vertex on one a sound angle is always enough.
  double keptAt(Vertex v, double angle) const {
    return run_.mesh.kind(v) == VertexKind::Curve ? kSound : angle;
  }

  // Whether a search from v would repeat the last one, which was in vain: the angles of v's star
  // set the same limit for both.
  bool wasTried(Vertex v, const Kept& kept) const {
    if (!kept.last) return false;
    const double own = narrowestAround(run_, v, run_.mesh.position(v));
    return std::min(keptAt(v, kept.angle), own) == std::min(keptAt(v, *kept.last), own);
  }

  bool moveCorner(Face f, const Kept& kept) {
    const double before = distances_.of(f);
    double lowest = kGain * before;
    Vertex mover;
    Placement to;
    for (const Vertex v : mesh_.vertices(f)) {
      if (isFixed(v) || wasTried(v, kept) || distances_.onRim(v) > lowest) continue;
      StarSearch search(run_, crossings_, distances_, {v, keptAt(v, kept.angle)});
      search.descend();
      if (search.distance() >= lowest) continue;
      lowest = search.distance();
      mover = v;
      to = search.best();
    }
    if (!mover) return false;
    move(mover, to);
    return true;
  }

  void move(Vertex v, const Placement& to) {
    proposePlacement(run_.mesh, v, to, run_.scratch.change);
    std::vector<double> before;
    for (const Face f : run_.scratch.change.going) before.push_back(distances_.of(f));
    apply(run_.mesh, run_.scratch.change);
    distances_.update(v);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Face f = run_.scratch.change.going[i];
      crossings_.update(f);
      if (distances_.of(f) != before[i]) push(f);
    }
  }

  // If the largest distance is on the rim of v's star, only a neighbour can lower it. The other
  // distances around v may be what holds the neighbour in place: v lowers them.
  bool makeWay(Face f, const Kept& kept) {
    const double before = distances_.of(f);
    bool moved = false;
    for (const Vertex v : mesh_.vertices(f)) {
      if (isFixed(v) || wasTried(v, kept) || distances_.onRim(v) < before) continue;
      StarSearch search(run_, crossings_, distances_, {v, keptAt(v, kept.angle)});
      const double own = search.distance();
      search.descend();
      if (search.distance() > kGain * own) continue;
      move(v, search.best());
      moved = true;
    }
    return moved;
  }

  bool flipSide(Face f, double angle) {
    if (run_.asked.areQuads) return false;
    for (int i = 0; i < 3; ++i) {
      const Halfedge h = HalfedgeMesh::halfedge(f, i);
      if (!proposeFlip(run_.mesh, h, run_.scratch.change)) continue;
      const Face across = mesh_.face(mesh_.twin(h));
      const double before = std::max(distances_.of(f), distances_.of(across));
      if (smallestComingAngle(run_.mesh, run_.scratch.change) < angle) continue;
      if (distances_.ifFlipped(h) > kGain * before) continue;
      if (judge(run_.mesh, run_.scratch.change, lenient(run_)) != Verdict::Accepted) continue;
      if (crossings_.grow(run_.scratch.change)) continue;
      distances_.update(run_.mesh.flip(h));
      for (const Face changed : {f, across}) {
        crossings_.update(changed);
        push(changed);
      }
      return true;
    }
    return false;
  }

  Run& run_;
  const HalfedgeMesh& mesh_;
  TwoSidedDistance distances_;
  Crossings crossings_;
  std::vector<Entry> queue_;
  std::vector<Face> stuck_;
  std::size_t tries_, mostLooks_;
};

}  // namespace

void lowerHausdorff(Run& run) { Descent(run).run(); }

}  // namespace remesher
