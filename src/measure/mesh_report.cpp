// SPDX-License-Identifier: MIT
#include "measure/mesh_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/fast_trigonometry.h"
#include "geometry/triangle.h"
#include "measure/edge_table.h"

namespace remesher {

namespace {

// How far beyond 180° two opposite angles may go by rounding (radians).
constexpr double kAngleRounding = 1e-7;

Triangle cornersOf(const WeldedMesh& mesh, std::size_t t) {
  const std::array<Index, 3> v = mesh.triangle(t);
  return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

// The place of a vertex of the edge opposite to a corner, as a corner of the same triangle.
Index cornerAt(const WeldedMesh& mesh, Index opposite, Index vertex) {
  const Index triangle = opposite / 3, next = 3 * triangle + (opposite + 1) % 3;
  return mesh.indices[next] == vertex ? next : 3 * triangle + (opposite + 2) % 3;
}

// How many fans of triangles, each joined by edges, stand around all vertices together: one per
// vertex but where the surface is pinched.
std::size_t countFans(const WeldedMesh& mesh, const EdgeTable& edges) {
  DisjointSets fans(mesh.indices.size());
  std::size_t count = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    count += hasDistinctVertices(mesh.triangle(t)) ? 3 : 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeTable::Edge edge = edges[e];
    for (const Index vertex : {edge.low, edge.high})
      for (const Index opposite : edge.opposites.subspan(1))
        count -=
            fans.unite(cornerAt(mesh, edge.opposites[0], vertex), cornerAt(mesh, opposite, vertex));
  }
  return count;
}

// Fills in what only connectivity decides.
void reportConnectivity(const WeldedMesh& mesh, MeshReport& report) {
  const EdgeTable edges(mesh);
  std::size_t faces = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) faces += hasDistinctVertices(mesh.triangle(t));
  report.components = faces;  // less one for each two that are found to be joined
  DisjointSets components(mesh.triangleCount());
  std::vector<Index> valence(mesh.positions.size(), 0);
  std::vector<std::uint8_t> isInterior(mesh.positions.size(), 1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeTable::Edge edge = edges[e];
    ++valence[edge.low], ++valence[edge.high];
    report.boundaryEdges += edge.opposites.size() == 1;
    report.nonManifoldEdges += edge.opposites.size() > 2;
    if (edge.opposites.size() != 2) isInterior[edge.low] = isInterior[edge.high] = 0;
    for (const Index corner : edge.opposites.subspan(1))
      report.components -= components.unite(edge.opposites[0] / 3, corner / 3);
  }
  std::size_t interior = 0, regular = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    interior += valence[v] > 0 && isInterior[v];
    regular += valence[v] == 6 && isInterior[v];
  }
  report.eulerCharacteristic = static_cast<long>(countFans(mesh, edges)) -
                               static_cast<long>(edges.size()) + static_cast<long>(faces);
  if (interior > 0)
    report.valence6 = 100.0 * static_cast<double>(regular) / static_cast<double>(interior);
}

// What the angles of a triangle follow from.
struct Sides {
  double shortest, longest, all;  // squared lengths, and their sum
  double twiceArea;

  explicit Sides(const Triangle& t) : twiceArea(areaVector(t[0], t[1], t[2]).norm()) {
    const double a = (t[1] - t[0]).squaredNorm(), b = (t[2] - t[1]).squaredNorm();
    const double c = (t[0] - t[2]).squaredNorm();
    shortest = std::min({a, b, c});
    longest = std::max({a, b, c});
    all = a + b + c;
  }

  double flatness() const { return longest > 0 ? twiceArea / longest : 0; }
  // The cosine and the sine of an angle, times the same length, are this and twiceArea.
  double cosineOpposite(double side) const { return 0.5 * (all - 2 * side); }
  double angleOpposite(double side) const { return angleOf(twiceArea, cosineOpposite(side)); }
};

void reportAngles(const WeldedMesh& mesh, MeshReport& report) {
  const std::size_t n = mesh.triangleCount();
  if (n == 0) return;
  std::array<std::size_t, 6> counts{};
  double sum = 0, worst = std::numbers::pi, largest = 0;
  // Above it a cosine is too large, for its sine, for the angle to be the largest yet.
  double leastRatio = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < n; ++t) {
    const Triangle corners = cornersOf(mesh, t);
    const Sides sides(corners);
    report.degenerateTriangles += sides.flatness() <= kFlattest;
    const double smallest = sides.angleOpposite(sides.shortest);
    worst = std::min(worst, smallest);
    const double cosine = sides.cosineOpposite(sides.longest);
    if (!(cosine >= leastRatio * sides.twiceArea)) {
      const double own = sides.angleOpposite(sides.longest), ratio = cosine / sides.twiceArea;
      if (own > largest) leastRatio = ratio + kAngleRounding * (1 + ratio * ratio);
      largest = std::max(largest, own);
    }
    sum += smallest;
    ++counts[static_cast<std::size_t>(std::clamp(degrees(smallest) / 10, 0.0, 5.0))];
  }
  report.minAngle.worst = degrees(worst);
  report.minAngle.mean = degrees(sum / static_cast<double>(n));
  report.maxAngle = degrees(largest);
  for (std::size_t k = 0; k < counts.size(); ++k)
    report.minAngle.histogram[k] = 100.0 * static_cast<double>(counts[k]) / static_cast<double>(n);
}

}  // namespace

MeshReport inspectMesh(const TriangleMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  MeshReport report;
  report.vertices = welded.positions.size();
  report.triangles = welded.triangleCount();
  reportConnectivity(welded, report);
  reportAngles(welded, report);
  return report;
}

double nonDelaunayPercentage(const TriangleMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const EdgeTable edges(welded);
  std::size_t inner = 0, bad = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeTable::Edge edge = edges[e];
    if (edge.opposites.size() != 2) continue;
    double sum = 0;
    for (const Index corner : edge.opposites) {
      const Vec3& apex = welded.positions[welded.indices[corner]];
      const Vec3 a = welded.positions[edge.low] - apex, b = welded.positions[edge.high] - apex;
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    ++inner;
    bad += sum > std::numbers::pi + kAngleRounding;
  }
  return inner > 0 ? 100.0 * static_cast<double>(bad) / static_cast<double>(inner) : 0;
}

std::size_t countBoundaryLoops(const TriangleMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const EdgeTable edges(welded);
  DisjointSets pieces(welded.positions.size());
  std::vector<std::uint8_t> isOnBoundary(welded.positions.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeTable::Edge edge = edges[e];
    if (edge.opposites.size() != 1) continue;
    isOnBoundary[edge.low] = isOnBoundary[edge.high] = 1;
    pieces.unite(edge.low, edge.high);
  }
  std::size_t loops = 0;
  for (Index v = 0; v < isOnBoundary.size(); ++v) loops += isOnBoundary[v] && pieces.find(v) == v;
  return loops;
}

}  // namespace remesher
