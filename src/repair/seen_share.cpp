// SPDX-License-Identifier: MIT
#include "repair/seen_share.h"

#include <algorithm>
#include <vector>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"
#include "mesh/joining.h"
#include "repair/sight.h"

namespace remesher {

namespace {

constexpr std::size_t kMostSamples = 400;  // triangles
constexpr Index kSightLines = 6;
constexpr double kAway = 1e-4;  // of the diagonal

double areaAt(const TriangleMesh& mesh, Index t) {
  const Triangle c = cornersOf(mesh, t);
  return area(c[0], c[1], c[2]);
}

Vec3 middleOf(const TriangleMesh& mesh, Index t) {
  const Triangle c = cornersOf(mesh, t);
  return (c[0] + c[1] + c[2]) / 3;
}

// Those of the triangles that are seen.
std::vector<Index> seenOf(const TriangleMesh& bodies, std::vector<Index> triangles) {
  std::vector<Index> seen;
  for (Index line = 0; line < kSightLines && !triangles.empty(); ++line) {
    const Eigen::Matrix3d rotation = sightRotation(line, kSightLines);
    std::vector<Vec3> turned;
    for (const Vec3& p : bodies.positions) turned.emplace_back(rotation * p);
    const TriangleTree tree(turned, bodies.indices);
    std::erase_if(triangles, [&](Index t) {
      const Vec3 p = rotation * middleOf(bodies, t);
      if (!leadsOut(p, tree, [t](Index other) { return other == t; })) return false;
      seen.push_back(t);
      return true;
    });
  }
  return seen;
}

}  // namespace

double seenShareLost(const TriangleMesh& bodies, const TriangleMesh& outside,
                     std::span<const Index> parents) {
  std::vector<char> isUsed(bodies.triangleCount(), 0);
  for (const Index parent : parents) isUsed[parent] = 1;
  std::vector<Index> dropped;
  double all = 0, without = 0;
  for (Index t = 0; t < bodies.triangleCount(); ++t) {
    const double own = areaAt(bodies, t);
    all += own;
    if (isUsed[t] || !hasArea(cornersOf(bodies, t))) continue;
    without += own;
    dropped.push_back(t);
  }
  if (without == 0) return 0;
  std::vector<Index> samples;
  double sampled = 0;
  const std::size_t step = 1 + dropped.size() / kMostSamples;
  for (std::size_t i = 0; i < dropped.size(); i += step) {
    sampled += areaAt(bodies, dropped[i]);
    samples.push_back(dropped[i]);
  }
  const TriangleTree tree(outside.positions, outside.indices);
  const double away = kAway * diagonalOf(bodies);
  std::erase_if(samples, [&](Index t) {
    return tree.nearest(middleOf(bodies, t)).squaredDistance <= away * away;
  });
  double lost = 0;
  for (const Index t : seenOf(bodies, std::move(samples))) lost += areaAt(bodies, t);
  return lost / sampled * without / all;
}

}  // namespace remesher
