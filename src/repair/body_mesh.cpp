// SPDX-License-Identifier: MIT
#include "repair/body_mesh.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/triangle_meeting.h"

namespace remesher {

namespace {

// Joins the triangles at each edge of a closed surface across the inside of a body.
class InsidePairs {
 public:
  InsidePairs(const TriangleMesh& mesh, const Welding& welding)
      : positions_(mesh.positions), corners_(welding.corners), twins_(corners_.size(), kNone) {}

  // Per corner its twin; empty if triangles at an edge are not the sides of bodies in turn.
  std::vector<Index> run(std::size_t vertexCount) {
    const EdgeGroups edges(vertexCount, corners_);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      around_.assign(edges[e].begin(), edges[e].end());
      if (around_.size() % 2 != 0 || (around_.size() > 2 && !sortAround()) || !join()) return {};
    }
    return std::move(twins_);
  }

 private:
  struct Placed {
    int quarter;  // 1: within half a turn after the first triangle, 2: opposite to it, 3: beyond
    Index halfedge;
  };

  const Vec3& at(Index corner) const { return positions_[corners_[corner]]; }
  const Vec3& apex(Index h) const { return at(prevCorner(h)); }
  bool isUpward(Index h) const { return corners_[h] < corners_[nextCorner(h)]; }

  // 1 if g follows h within half a turn, counterclockwise as seen from the edge's larger vertex.
  int turn(Index h, Index g) const {
    const bool isUp = isUpward(h);
    const Vec3 &tail = at(isUp ? h : nextCorner(h)), &head = at(isUp ? nextCorner(h) : h);
    return -orient3d(tail, head, apex(h), apex(g));
  }

  bool areFolded(Index h, Index g) const { return trianglesMeet(named(h), named(g)); }

  NamedTriangle named(Index h) const {
    const Index t = h - h % 3;
    return {{corners_[t], corners_[t + 1], corners_[t + 2]}, {at(t), at(t + 1), at(t + 2)}};
  }

  // By the angle around the edge; false if two lie on each other.
  bool sortAround() {
    const Index first = around_.front();
    std::vector<Placed> placed;
    for (const Index h : std::span(around_).subspan(1)) {
      const int side = turn(first, h);
      if (side == 0 && areFolded(first, h)) return false;
      placed.push_back({2 - side, h});
    }
    std::sort(placed.begin(), placed.end(), [&](const Placed& one, const Placed& other) {
      if (one.quarter != other.quarter) return one.quarter < other.quarter;
      return turn(one.halfedge, other.halfedge) > 0;
    });
    for (std::size_t i = 0; i < placed.size(); ++i) {
      around_[i + 1] = placed[i].halfedge;
      if (i > 0 && placed[i].quarter == placed[i - 1].quarter &&
          turn(around_[i], around_[i + 1]) == 0)
        return false;
    }
    return true;
  }

  // The inside lies behind a triangle: after those that run downward.
  bool join() {
    const std::size_t count = around_.size(), begin = isUpward(around_[0]) ? count - 1 : 0;
    for (std::size_t i = 0; i < count; i += 2) {
      const Index down = around_[(begin + i) % count], up = around_[(begin + i + 1) % count];
      if (isUpward(down) || !isUpward(up)) return false;
      twins_[down] = up, twins_[up] = down;
    }
    return true;
  }

  const std::vector<Vec3>& positions_;
  const std::vector<Index>& corners_;
  std::vector<Index> twins_;
  std::vector<Index> around_;  // halfedges of an edge
};

}  // namespace

BuiltMesh buildBodies(const TriangleMesh& mesh) {
  requireValid(mesh);
  Welding welding(mesh);
  if (welding.twins.empty()) welding.twins = InsidePairs(mesh, welding).run(mesh.positions.size());
  return buildMesh(mesh, std::move(welding));
}

}  // namespace remesher
