// SPDX-License-Identifier: MIT
#include "charts/unwrap.h"

#include <cmath>

#include "charts/chart_growth.h"
#include "charts/plane_frame.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Per corner the one across the edge from it, where two triangles share it and nothing cuts it.
std::vector<Index> twinsOf(const UnwrapInput& mesh) {
  std::vector<Index> twins(mesh.indices.size(), kNone);
  const EdgeGroups groups(mesh.positions.size(), mesh.indices);
  for (std::size_t e = 0; e < groups.size(); ++e) {
    const auto edge = groups[e];
    if (edge.size() != 2) continue;
    const Index a = edge[0], b = edge[1];
    if (mesh.indices[a] == mesh.indices[b] || mesh.cuts[a] || mesh.cuts[b]) continue;
    twins[a] = b;
    twins[b] = a;
  }
  return twins;
}

// Seen along its axis, and as large in the plane as on the surface.
PlaneChart flattened(const UnwrapInput& mesh, const Chart& chart) {
  const PlaneFrame frame(chart.axis);
  PlaneChart result;
  double seen = 0, real = 0;
  for (const Index t : chart.triangles) {
    std::array<Vec3, 3> corners;
    PlaneTriangle triangle;
    for (Index k = 0; k < 3; ++k) {
      corners[k] = mesh.positions[mesh.indices[3 * t + k]];
      triangle[k] = frame.project(corners[k]);
    }
    const Vec3 normal = areaVector(corners[0], corners[1], corners[2]);
    seen += normal.dot(chart.axis);
    real += normal.norm();
    result.push_back(triangle);
  }
  const double enlarged = seen > 0 ? std::sqrt(real / seen) : 1;
  for (PlaneTriangle& triangle : result)
    for (Vec2& p : triangle) p *= enlarged;
  return result;
}

}  // namespace

Unwrapped unwrap(const UnwrapInput& mesh, const PackingRules& rules) {
  const std::vector<Index> twins = twinsOf(mesh);
  const std::vector<Chart> charts = growCharts({mesh.positions, mesh.indices, twins});
  std::vector<PlaneChart> flat;
  for (const Chart& chart : charts) flat.push_back(flattened(mesh, chart));
  const Packing packing = packCharts(flat, rules);
  Unwrapped result{std::vector<Vec2>(mesh.indices.size(), Vec2::Zero()),
                   std::vector<Index>(mesh.indices.size() / 3, 0), charts.size(), packing.scale};
  for (Index c = 0; c < charts.size(); ++c)
    for (std::size_t i = 0; i < charts[c].triangles.size(); ++i) {
      const Index t = charts[c].triangles[i];
      result.charts[t] = c;
      if (packing.scale > 0)
        for (Index k = 0; k < 3; ++k) result.corners[3 * t + k] = packing.charts[c][i][k];
    }
  return result;
}

}  // namespace remesher
