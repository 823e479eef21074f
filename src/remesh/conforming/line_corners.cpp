// SPDX-License-Identifier: MIT
#include "remesh/conforming/line_corners.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace remesher {

namespace {

double distanceToChord(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 chord = to - from;
  const double squared = chord.squaredNorm();
  const double share = squared > 0 ? std::clamp((p - from).dot(chord) / squared, 0.0, 1.0) : 0;
  return (p - from - share * chord).norm();
}

class LineTracer {
 public:
  LineTracer(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double tolerance)
      : positions_(positions),
        tolerance_(tolerance),
        neighbors_(mesh.vertexCapacity()),
        isCorner_(mesh.vertexCapacity(), 0),
        isWalked_(mesh.vertexCapacity(), 0) {}

  void add(Vertex a, Vertex b) {
    neighbors_[a].push_back(b);
    neighbors_[b].push_back(a);
  }

  std::vector<Vertex> run() {
    std::vector<Vertex> corners;
    for (Index i = 0; i < neighbors_.size(); ++i) {
      const std::size_t lines = neighbors_[Vertex(i)].size();
      isCorner_[Vertex(i)] = lines != 0 && lines != 2;
      if (isCorner_[Vertex(i)]) corners.emplace_back(i);
    }
    for (const Vertex corner : corners)
      for (const Vertex next : neighbors_[corner]) walk(corner, next);
    // The rest are loops without a corner.
    for (Index i = 0; i < neighbors_.size(); ++i) {
      const Vertex v(i);
      if (neighbors_[v].empty() || isCorner_[v] || isWalked_[v]) continue;
      isCorner_[v] = 1;
      walk(v, neighbors_[v][0]);
    }
    std::vector<Vertex> result;
    for (Index i = 0; i < neighbors_.size(); ++i)
      if (isCorner_[Vertex(i)]) result.emplace_back(i);
    return result;
  }

 private:
  // Goes on as far as one chord follows the line, then begins another.
  void walk(Vertex anchor, Vertex next) {
    std::vector<Vertex> passed;
    Vertex before = anchor;
    while (!isCorner_[next] && !isWalked_[next]) {
      isWalked_[next] = 1;
      const auto& [one, other] = std::pair(neighbors_[next][0], neighbors_[next][1]);
      const Vertex beyond = one == before ? other : one;
      passed.push_back(next);
      if (isFar(passed, anchor, beyond)) {
        isCorner_[next] = 1;
        anchor = next;
        passed.clear();
      }
      before = next;
      next = beyond;
    }
  }

  bool isFar(const std::vector<Vertex>& passed, Vertex from, Vertex to) const {
    return std::any_of(passed.begin(), passed.end(), [&](Vertex v) {
      return distanceToChord(positions_[v], positions_[from], positions_[to]) > tolerance_;
    });
  }

  const VertexData<Vec3>& positions_;
  double tolerance_;
  VertexData<std::vector<Vertex>> neighbors_;  // along lines
  VertexData<char> isCorner_, isWalked_;
};

}  // namespace

std::vector<Vertex> cornersOfLines(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                   const HalfedgeData<char>& lines, double tolerance) {
  LineTracer tracer(mesh, positions, tolerance);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (mesh.isEdge(h) && (lines[h] || mesh.isBoundary(h))) tracer.add(mesh.origin(h), mesh.tip(h));
  }
  return tracer.run();
}

}  // namespace remesher
