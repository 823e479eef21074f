// SPDX-License-Identifier: MIT
#include "textures/charts/unwrap.h"

#include "mesh/edge_groups.h"
#include "textures/charts/chart_growth.h"
#include "textures/charts/chart_joining.h"

namespace remesher {

namespace {

// Per corner the twin of the edge from it, if two triangles share the edge and it is not cut.
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

}  // namespace

Unwrapped unwrap(const UnwrapInput& mesh, const PackingRules& rules) {
  const std::vector<Index> twins = twinsOf(mesh);
  const ChartSurface surface{mesh.positions, mesh.indices, twins, mesh.faces};
  const std::vector<FlatChart> charts = layFlat(surface, growCharts(surface));
  std::vector<PlaneChart> flat;
  for (const FlatChart& chart : charts) flat.push_back(chart.plane);
  const Packing packing = packCharts(flat, rules);
  Unwrapped result{std::vector<Vec2>(mesh.indices.size(), Vec2::Zero()),
                   std::vector<char>(mesh.indices.size(), 1),
                   std::vector<Index>(mesh.indices.size() / 3, 0), charts.size(), packing.scale};
  for (Index c = 0; c < charts.size(); ++c)
    for (std::size_t i = 0; i < charts[c].triangles.size(); ++i) {
      const Index t = charts[c].triangles[i];
      result.charts[t] = c;
      if (packing.scale > 0)
        for (Index k = 0; k < 3; ++k) result.corners[3 * t + k] = packing.charts[c][i][k];
    }
  for (Index h = 0; h < twins.size(); ++h) result.rims[h] = twins[h] == kNone;
  return result;
}

}  // namespace remesher
