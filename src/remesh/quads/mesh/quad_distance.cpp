// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_distance.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

// Where quads leave the surface, many do.
constexpr std::size_t kSomeQuads = 500;

// Distances of places, each near the one before, from a tree; those below a side are of no
// interest.
class Farthest {
 public:
  Farthest(const TriangleTree& tree, double side) : tree_(tree), side_(side) {}

  void add(const Vec3& p) {
    const TriangleTree::Nearest found = tree_.nearestBeyond(side_, p, near_);
    near_ = found.triangle;
    distance_ = std::max(distance_, std::sqrt(found.squaredDistance));
  }
  double inSides() const { return distance_ < side_ ? 0 : distance_ / side_; }

 private:
  const TriangleTree& tree_;
  const double side_;
  Index near_ = 0;
  double distance_ = 0;
};

}  // namespace

QuadDistance::QuadDistance(const WorkingMesh& mesh)
    : mesh_(mesh), corners_(mesh.mesh().triangles()), tree_(mesh.positions().values(), corners_) {}

double QuadDistance::sidesAway(const QuadMesh& quads) const {
  std::vector<Vec3> positions;
  for (const Placement& place : quads.vertices) positions.push_back(place.position);
  std::vector<Index> corners;
  double twiceArea = 0;
  for (const auto& [a, b, c, d] : quads.quads) {
    corners.insert(corners.end(), {a, b, c, a, c, d});
    twiceArea += (positions[c] - positions[a]).cross(positions[d] - positions[b]).norm();
  }
  if (!(twiceArea > 0)) return 0;
  const double side = std::sqrt(twiceArea / 2 / double(quads.quads.size()));
  const TriangleTree tree(positions, corners);
  Farthest ofMesh(tree, side), ofQuads(tree_, side);
  for (const Vec3& p : mesh_.positions().values()) ofMesh.add(p);
  for (std::size_t q = 0; q < quads.quads.size(); q += 1 + quads.quads.size() / kSomeQuads) {
    const auto& [a, b, c, d] = quads.quads[q];
    ofQuads.add((positions[a] + positions[b] + positions[c] + positions[d]) / 4);
  }
  return std::max(ofMesh.inSides(), ofQuads.inSides());
}

}  // namespace remesher
