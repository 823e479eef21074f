// SPDX-License-Identifier: MIT
#include "textures/charts/unwrap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/edge_groups.h"
#include "textures/charts/chart_growth.h"
#include "textures/charts/chart_joining.h"

namespace remesher {

namespace {

// The lengths of joined charts that are tried in turn while the square stays emptier than kFull, as
// multiples of the side of a square of the whole surface's area. Shorter charts, which are more,
// are taken only if they are drawn larger by kWorthMore.
constexpr std::array kLongest = {kInfinity, 1.3, 0.9};
constexpr double kFull = 0.58, kWorthMore = 1.03;

struct Layout {
  std::vector<FlatChart> charts;
  Packing packing = {{}, 0};

  double longest() const {
    double longest = 0;
    for (const FlatChart& chart : charts) longest = std::max(longest, chart.length);
    return longest;
  }
};

double areaOf(const UnwrapInput& mesh) {
  double area = 0;
  const auto corner = [&](std::size_t h) -> const Vec3& { return mesh.positions[mesh.indices[h]]; };
  for (std::size_t h = 0; h < mesh.indices.size(); h += 3)
    area += areaVector(corner(h), corner(h + 1), corner(h + 2)).norm() / 2;
  return area;
}

Layout laidOut(const ChartSurface& surface, double area, const PackingRules& rules) {
  const std::vector<Chart> grown = growCharts(surface);
  Layout best;
  for (const double longest : kLongest) {
    // A limit that no chart exceeds changes nothing.
    if (!best.charts.empty() && best.longest() <= longest * std::sqrt(area)) continue;
    Layout next{layFlat(surface, grown, longest * std::sqrt(area))};
    std::vector<PlaneChart> flat;
    for (const FlatChart& chart : next.charts) flat.push_back(chart.plane);
    next.packing = packCharts(flat, rules);
    if (best.charts.empty() || next.packing.scale > kWorthMore * best.packing.scale)
      best = std::move(next);
    const double side = best.packing.scale / rules.size;
    if (side * side * area >= kFull) break;
  }
  return best;
}

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
  const auto [charts, packing] = laidOut(surface, areaOf(mesh), rules);
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
