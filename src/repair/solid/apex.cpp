// SPDX-License-Identifier: MIT
#include "repair/solid/apex.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

// How far the planes are likely to be noise: 1 if each is another triangle's, as of scans; little
// if triangles are larger than cells, so that several planes are of the same one.
double doubtIn(const std::vector<Plane>& planes) {
  std::vector<Index> sources;
  for (const Plane& plane : planes) sources.push_back(plane.source);
  std::sort(sources.begin(), sources.end());
  const auto count = std::unique(sources.begin(), sources.end()) - sources.begin();
  const double share = double(count) / double(planes.size());
  return share * share * share;
}

// Least squares of the distances from the planes, with a small weight on the distance from the
// previous place. After two rounds 1/600 of the way to a right-angled edge is left. Towards edges
// that only the noise of scans makes (planes within 5° of each other), at most a seventh of the way
// is gone.
Vec3 nearestToPlanes(const std::vector<Plane>& planes, const Vec3& middle, double doubt) {
  constexpr double kHold = 0.05;  // of the number of planes
  constexpr int kRounds = 2;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity() * (kHold * doubt * double(planes.size()));
  for (const Plane& plane : planes) matrix += plane.normal * plane.normal.transpose();
  const Eigen::Matrix3d inverse = matrix.inverse();
  Vec3 at = middle;
  for (int round = 0; round < kRounds; ++round) {
    Vec3 pull = Vec3::Zero();
    for (const Plane& plane : planes) pull += plane.normal.dot(plane.at - at) * plane.normal;
    at += inverse * pull;
  }
  return at;
}

bool haveEdge(const std::vector<Plane>& planes, double doubt) {
  const double bend = std::cos(doubt * radians(25));
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (planes[i].normal.dot(planes[k].normal) < bend) return true;
  return false;
}

// The planes of facets meet above those that no edge of the lattice crosses.
Vec3 nearestOnTriangles(const std::vector<Plane>& planes, const Vec3& p) {
  Vec3 nearest = p;
  double least = kInfinity;
  for (const Plane& plane : planes) {
    const auto& [a, b, c] = plane.triangle;
    const Vec3 at = closestPoint(p, a, b, c);
    if ((at - p).squaredNorm() < least) least = (at - p).squaredNorm(), nearest = at;
  }
  return nearest;
}

}  // namespace

Apex apexOf(const std::vector<Plane>& planes, const Vec3& middle, const CellBox& cell,
            Ridges ridges) {
  Apex apex{middle};
  const double doubt = ridges == Ridges::Sharp || planes.empty() ? 1 : doubtIn(planes);
  if (!planes.empty()) apex.at = nearestToPlanes(planes, middle, doubt);
  if (!apex.at.allFinite()) apex.at = middle;
  apex.isSharp = haveEdge(planes, doubt);
  const auto bringIn = [&] { apex.at = apex.at.cwiseMax(cell.low).cwiseMin(cell.high); };
  bringIn();
  apex.at = nearestOnTriangles(planes, apex.at);
  bringIn();
  double nearest = 0;
  for (const Plane& plane : planes) {
    const double distance = std::abs(plane.normal.dot(apex.at - plane.at));
    if (apex.source == kNone || distance < nearest) apex.source = plane.source, nearest = distance;
  }
  return apex;
}

}  // namespace remesher
