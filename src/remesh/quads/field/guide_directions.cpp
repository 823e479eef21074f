// SPDX-License-Identifier: MIT
#include "remesh/quads/field/guide_directions.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_tree.h"

namespace remesher {

namespace {

// Triangles whose normals are further apart than this (60°) lie on another side of the surface.
constexpr double kSameSide = 0.5;

Vec3 middleOf(const WorkingMesh& mesh, Face f) {
  const auto [a, b, c] = mesh.corners(f);
  return (a + b + c) / 3;
}

double distanceTo(const Vec3& from, const Vec3& to, const Vec3& p) {
  const Vec3 side = to - from;
  const double t = std::clamp((p - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
  return (p - from - t * side).norm();
}

}  // namespace

FaceData<Complex> guideCrosses(const WorkingMesh& mesh, const FaceFrames& frames,
                               std::span<const Guide> guides, double length) {
  const auto count = Index(mesh.mesh().faceCapacity());
  FaceData<Complex> crosses(count);
  if (guides.empty()) return crosses;
  FaceData<double> sums(count, 0), most(count, 0);
  const MeshTree tree(mesh.mesh(), mesh.positions());
  for (const Guide& guide : guides) {
    const std::size_t points = guide.points.size();
    for (std::size_t i = 0; i + (guide.isClosed ? 0 : 1) < points; ++i) {
      const Vec3 &from = guide.points[i], &to = guide.points[(i + 1) % points];
      if (from == to) continue;
      const MeshTree::Nearest under = tree.nearest((from + to) / 2);
      if (under.distance > length) continue;
      Box box;
      for (const Vec3& end : {from, to})
        for (const double away : {-length, length}) box.extend(end + Vec3::Constant(away));
      tree.visitOverlapping(box, [&](Face f) {
        if (frames.normal(f).dot(frames.normal(under.face)) < kSameSide) return;
        const double near = 1 - distanceTo(from, to, middleOf(mesh, f)) / length;
        if (near <= 0) return;
        const Vec2 along = frames.inFrame(f, to - from);
        const double weight = near * near;
        crosses[f] += weight * std::polar(1.0, 4 * std::atan2(along.y(), along.x()));
        sums[f] += weight;
        most[f] = std::max(most[f], weight);
      });
    }
  }
  for (Index i = 0; i < count; ++i)
    if (sums[Face(i)] > 0) crosses[Face(i)] *= most[Face(i)] / sums[Face(i)];
  return crosses;
}

}  // namespace remesher
