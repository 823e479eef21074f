// SPDX-License-Identifier: MIT
#include "measure/edge_report.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// No edge that bends less is a feature.
constexpr double kLeastBend = 5;

struct BentEdge {
  Index halfedge;
  double bend;  // degrees
};

// The angle between the triangles of two halfedges of welded vertices.
double bendBetween(const TriangleMesh& mesh, const Welding& welding, Index h, Index g) {
  const auto normalAt = [&](Index corner) {
    const auto at = [&](Index c) { return mesh.positions[welding.corners[c]]; };
    return unitNormal(at(corner), at(nextCorner(corner)), at(prevCorner(corner)));
  };
  return degrees(std::acos(std::clamp(normalAt(h).dot(normalAt(g)), -1.0, 1.0)));
}

}  // namespace

EdgeReport reportEdges(const TriangleMesh& mesh, const Welding& welding) {
  EdgeReport report;
  report.first = welding.first;
  const auto add = [&](std::vector<Index>& edges, Index h) {
    edges.push_back(welding.corners[h]);
    edges.push_back(welding.corners[nextCorner(h)]);
  };
  std::vector<BentEdge> bent;
  welding.forEachEdge([&](std::span<const Index> halfedges) {
    const Index h = halfedges.front();
    if (halfedges.size() > 2) return add(report.nonManifold, h);
    if (halfedges.size() < 2) return add(report.boundary, h);
    const Index g = halfedges.back();
    if (welding.corners[h] == welding.corners[g]) return add(report.flipped, h);
    const double bend = bendBetween(mesh, welding, h, g);
    if (bend >= kLeastBend) bent.push_back({h, bend});
  });
  std::stable_sort(bent.begin(), bent.end(),
                   [](const BentEdge& a, const BentEdge& b) { return a.bend > b.bend; });
  for (const BentEdge& edge : bent) {
    add(report.bent, edge.halfedge);
    report.bends.push_back(edge.bend);
  }
  return report;
}

}  // namespace remesher
