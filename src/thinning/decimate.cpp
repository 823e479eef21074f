// SPDX-License-Identifier: MIT
#include "thinning/decimate.h"

#include <algorithm>
#include <cmath>

#include "operators/local_operators.h"

namespace remesher {

namespace {

// All in units of the spacing. A vertex that rises this far above the plane of a triangle around it
// is a tip or on a ridge, and stays; and no edge may become so long.
constexpr double kFlat = 0.07;
constexpr double kTooLong = 1.7;
constexpr double kStep = 1.2;  // from pass to pass; a third of the vertices go for it
constexpr double kFinest = 1e-3;
constexpr int kLargestValence = 9;

class Decimation {
 public:
  Decimation(WorkingMesh& mesh, const FidelityRule& rule, const VertexData<double>& spacing)
      : working_(mesh),
        mesh_(mesh.mesh()),
        rule_(rule),
        spacing_(spacing),
        into_(mesh_.vertexCapacity()) {}

  void run(double worthwhile) {
    for (share_ = std::max(kFinest, kStep * meanShare()); share_ < 1; share_ *= kStep) pass();
    share_ = 1;
    while (double(pass()) > worthwhile * double(mesh_.vertexCount())) {
    }
  }

  // By the numbers that the vertices will have when the holes are closed.
  VertexData<Vertex> heirs() const {
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
  double squaredLength(Vertex a, Vertex b) const {
    return (working_.position(b) - working_.position(a)).squaredNorm();
  }

  // Of edges' lengths, in units of the spacing.
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
    std::size_t gone = 0;
    touched_.assign(mesh_.vertexCapacity(), 0);
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (touched_[v] || !mesh_.isAlive(v) || working_.kind(v) != VertexKind::Interior) continue;
      const Halfedge h = shortestWay(v);
      if (!h || !isFlat(v, mesh_.tip(h)) || !staysEven(h) || !collapse(h)) continue;
      ++gone;
    }
    return gone;
  }

  // The shortest edge from v that is too short, if any, to where nothing has changed in this pass.
  // The end where edges are to be shorter had better stay: it may be a tip.
  Halfedge shortestWay(Vertex v) const {
    const double limit = share_ * spacing_[v];
    double shortest = limit * limit;
    Halfedge best;
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      const Vertex w = mesh_.tip(h);
      const double length = squaredLength(v, w);
      if (length >= shortest || touched_[w] || spacing_[w] > spacing_[v]) return;
      shortest = length;
      best = h;
    });
    return best;
  }

  // Whether the way from v to w stays near the planes of all triangles around v.
  bool isFlat(Vertex v, Vertex w) const {
    const Vec3& at = working_.position(v);
    const Vec3 way = working_.position(w) - at;
    const double height = kFlat * share_ * spacing_[v];
    bool result = true;
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      if (!result) return;
      const Vec3 normal =
          areaVector(at, working_.position(mesh_.tip(h)), working_.position(mesh_.opposite(h)));
      const double rise = normal.dot(way);
      result = rise * rise <= height * height * normal.squaredNorm();
    });
    return result;
  }

  // Whether the star that comes has neither long edges nor many.
  bool staysEven(Halfedge h) const {
    const Vertex v = mesh_.origin(h), w = mesh_.tip(h);
    const double limit = kTooLong * share_ * spacing_[v];
    int neighbors = 0;
    bool anyLong = false;
    mesh_.forEachNeighbor(v, [&](Vertex n) {
      ++neighbors;
      anyLong = anyLong || squaredLength(n, w) > limit * limit;
    });
    return !anyLong && neighbors + mesh_.valence(w) - 4 <= kLargestValence;
  }

  bool collapse(Halfedge h) {
    if (!proposeCollapseInto(working_, h, change_)) return false;
    if (judge(working_, change_, rule_) != Verdict::Accepted) return false;
    const Vertex gone = mesh_.origin(h), remaining = apply(working_, change_);
    into_[gone] = remaining;
    touched_[remaining] = 1;
    mesh_.forEachNeighbor(remaining, [&](Vertex w) { touched_[w] = 1; });
    return true;
  }

  WorkingMesh& working_;
  const HalfedgeMesh& mesh_;
  const FidelityRule& rule_;
  const VertexData<double>& spacing_;
  double share_ = 1;          // of the spacing, in the present pass
  VertexData<char> touched_;  // whether the star has changed in the present pass
  VertexData<Vertex> into_;   // what a vertex has gone into, which may be gone since; or none
  LocalChange change_;
};

}  // namespace

VertexData<Vertex> decimate(WorkingMesh& mesh, const FidelityRule& rule,
                            const VertexData<double>& spacing, double worthwhile) {
  Decimation decimation(mesh, rule, spacing);
  decimation.run(worthwhile);
  VertexData<Vertex> heirs = decimation.heirs();
  mesh.compact();
  return heirs;
}

}  // namespace remesher
