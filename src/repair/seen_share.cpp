// SPDX-License-Identifier: MIT
#include "repair/seen_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/mesh_triangle.h"
#include "geometry/ray_crossings.h"
#include "geometry/triangle.h"
#include "geometry/triangle_meeting.h"
#include "mesh/joining.h"

namespace remesher {

namespace {

constexpr std::size_t kMostSamples = 400;  // triangles
constexpr int kSightLines = 6;
constexpr double kAway = 1e-4;  // of the diagonal

double areaAt(const TriangleMesh& mesh, Index t) {
  const Triangle c = cornersOf(mesh, t);
  return area(c[0], c[1], c[2]);
}

Vec3 middleOf(const TriangleMesh& mesh, Index t) {
  const Triangle c = cornersOf(mesh, t);
  return (c[0] + c[1] + c[2]) / 3;
}

// That turns a direction, of several spread over half a sphere, to the x axis.
Eigen::Matrix3d turnedTo(int line) {
  const double height = (line + 0.5) / kSightLines, angle = 2.399963229728653 * line;
  const double radius = std::sqrt(1 - height * height);
  const Vec3 x(radius * std::cos(angle), radius * std::sin(angle), height);
  const Vec3 y = x.unitOrthogonal();
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), y.transpose(), x.cross(y).transpose();
  return rotation;
}

// Whether a line from p leads out of the triangles, one way or the other.
bool leadsOut(const Vec3& p, const TriangleTree& tree) {
  std::array<bool, 2> isBlocked{};
  Box line;
  line.extend(Vec3(tree.box().low.x(), p.y(), p.z()));
  line.extend(Vec3(tree.box().high.x(), p.y(), p.z()));
  tree.visitOverlapping(line, [&](Index t) {
    if (isBlocked[0] && isBlocked[1]) return;
    if (const int crossing = lineCrossing(p, tree.corners(t)); crossing != 0)
      isBlocked[crossing > 0 ? 0 : 1] = true;
  });
  return !isBlocked[0] || !isBlocked[1];
}

// Those of the triangles that are seen.
std::vector<Index> seenOf(const TriangleMesh& bodies, std::vector<Index> triangles) {
  std::vector<Index> seen;
  for (int line = 0; line < kSightLines && !triangles.empty(); ++line) {
    const Eigen::Matrix3d rotation = turnedTo(line);
    std::vector<Vec3> turned;
    for (const Vec3& p : bodies.positions) turned.emplace_back(rotation * p);
    const TriangleTree tree(turned, bodies.indices);
    std::erase_if(triangles, [&](Index t) {
      const Vec3 p = rotation * middleOf(bodies, t);
      if (!leadsOut(p, tree)) return false;
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
