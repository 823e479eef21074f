// SPDX-License-Identifier: MIT
#include "remesh/ground/decimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/star_passes.h"
#include "remesh/operators/local_operators.h"

namespace remesher {

namespace {

// Lengths in units of the spacing. A vertex that rises more than kFlat above the plane of a
// triangle around it is a tip or on a ridge, and stays. No edge may become longer than kTooLong.
constexpr double kFlat = 0.07;
constexpr double kTooLong = 1.7;
constexpr double kStep = 1.2;  // from pass to pass; this removes a third of the vertices
constexpr int kLargestValence = 9;
// When fewer vertices than this share have gone, the next pass notes where others go, and the one
// after it looks only there.
constexpr double kFewGone = 1.0 / 12;

class Decimation {
 public:
  Decimation(WorkingMesh& mesh, const FidelityRule& rule, const VertexData<double>& spacing)
      : working_(mesh),
        mesh_(mesh.mesh()),
        rule_(rule),
        spacing_(spacing),
        passes_(mesh_),
        into_(mesh_.vertexCapacity()),
        noted_(mesh_.vertexCapacity(), 0) {}

  void run() {
    for (share_ = std::max(kRoundOff, kStep * meanShare()); share_ < 1; share_ *= kStep) pass();
    share_ = 1;
    std::size_t gone = pass();
    while (gone > 0) {
      ++number_;
      isNoted_ = isNoting_;
      isNoting_ = isNoting_ || double(gone) < kFewGone * double(mesh_.vertexCount());
      gone = pass();
    }
  }

  // By the numbers that the vertices will have after compaction.
  VertexData<Vertex> collapseMap() const {
    VertexData<Vertex> result(into_.size());
    Index count = 0;
    for (Index i = 0; i < into_.size(); ++i)
      if (mesh_.isAlive(Vertex(i))) result[Vertex(i)] = Vertex(count++);
    std::vector<Vertex> way;
    for (Index i = 0; i < into_.size(); ++i) {
      Vertex v(i);
      for (; !result[v] && into_[v]; v = into_[v]) way.push_back(v);
      for (const Vertex passed : way) result[passed] = result[v];
      way.clear();
    }
    return result;
  }

 private:
  struct Spoke {
    Vertex tip;
    Vec3 way;  // from the centre to the tip
  };

  double squaredLength(Vertex a, Vertex b) const {
    return (working_.position(b) - working_.position(a)).squaredNorm();
  }

  // The mean length of edges, in units of the spacing.
  double meanShare() const {
    double sum = 0;
    std::size_t count = 0;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh_.isEdge(h)) continue;
      sum += std::sqrt(squaredLength(mesh_.origin(h), mesh_.tip(h))) / spacing_[mesh_.origin(h)];
      ++count;
    }
    return count > 0 ? sum / double(count) : 1;
  }

  // Returns how many vertices went.
  std::size_t pass() {
    return passes_.run([&](Vertex v) {
      const bool mayGo = working_.kind(v) == VertexKind::Interior && !isUnchanged(v);
      return mayGo ? takeOut(v) : Vertex();
    });
  }

  // Whether v, at this share, would stay for what it stayed for in the pass before: neither its
  // star nor any of its neighbours' has changed since.
  bool isUnchanged(Vertex v) const { return isNoted_ && noted_[v] + 1 < number_; }

  // Removes v if it may go. Returns the vertex that it has gone into, or none.
  Vertex takeOut(Vertex v) {
    gather(v);
    const double size = share_ * spacing_[v];
    const Spoke* const spoke = shortestSpoke(v, size);
    if (!spoke || !isFlat(spoke->way, size) || !staysEven(spoke->tip, size)) return {};
    return collapse(mesh_.find(v, spoke->tip));
  }

  // Walks around the star once for all later looks at it.
  void gather(Vertex v) {
    spokes_.clear();
    const Vec3& at = working_.position(v);
    mesh_.forEachNeighbor(v, [&](Vertex w) { spokes_.push_back({w, working_.position(w) - at}); });
  }

  // The shortest spoke of v below `size`, if any, to a vertex that this pass has not touched. If
  // edges at v are to be shorter than at the other end, v stays: it may be a tip.
  const Spoke* shortestSpoke(Vertex v, double size) const {
    double shortest = size * size;
    const Spoke* best = nullptr;
    for (const Spoke& spoke : spokes_) {
      const double length = spoke.way.squaredNorm();
      if (length >= shortest || passes_.isTouched(spoke.tip) || spacing_[spoke.tip] > spacing_[v])
        continue;
      shortest = length;
      best = &spoke;
    }
    return best;
  }

  // Whether the tip of `way`, from the centre, is near the planes of all triangles of the star.
  bool isFlat(const Vec3& way, double size) const {
    const double height = kFlat * size;
    const Vec3* before = &spokes_.back().way;
    for (const Spoke& spoke : spokes_) {
      const Vec3 normal = before->cross(spoke.way);
      before = &spoke.way;
      const double rise = normal.dot(way);
      if (!(rise * rise <= height * height * normal.squaredNorm())) return false;
    }
    return true;
  }

  // Whether the star that w would get has neither long edges nor too many.
  bool staysEven(Vertex w, double size) const {
    const double limit = kTooLong * size;
    for (const Spoke& spoke : spokes_)
      if (squaredLength(spoke.tip, w) > limit * limit) return false;
    return int(spokes_.size()) + mesh_.valence(w) - 4 <= kLargestValence;
  }

  Vertex collapse(Halfedge h) {
    if (!proposeCollapseInto(working_, h, change_)) return {};
    if (judge(working_, change_, rule_) != Verdict::Accepted) return {};
    const Vertex gone = mesh_.origin(h), remaining = apply(working_, change_);
    if (isNoting_) note(remaining);
    return into_[gone] = remaining;
  }

  void note(Vertex centre) {
    mesh_.forEachNeighbor(centre, [&](Vertex v) {
      mesh_.forEachNeighbor(v, [&](Vertex w) { noted_[w] = number_; });
    });
  }

  WorkingMesh& working_;
  const HalfedgeMesh& mesh_;
  const FidelityRule& rule_;
  const VertexData<double>& spacing_;
  double share_ = 1;  // of the spacing, in the present pass
  StarPasses passes_;
  VertexData<Vertex> into_;  // the vertex it went into, which may be gone since; or none
  VertexData<int> noted_;    // the last pass that noted a change near it
  int number_ = 1;           // of the present pass at the full spacing
  bool isNoting_ = false, isNoted_ = false;  // of the present pass, and of the one before
  std::vector<Spoke> spokes_;                // of the vertex that is looked at, counterclockwise
  LocalChange change_;
};

}  // namespace

VertexData<Vertex> decimate(WorkingMesh& mesh, const FidelityRule& rule,
                            const VertexData<double>& spacing) {
  Decimation decimation(mesh, rule, spacing);
  decimation.run();
  VertexData<Vertex> collapseMap = decimation.collapseMap();
  mesh.compact();
  return collapseMap;
}

}  // namespace remesher
