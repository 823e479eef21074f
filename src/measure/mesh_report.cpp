// SPDX-License-Identifier: MIT
#include "measure/mesh_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/extremes.h"
#include "geometry/fast_trigonometry.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Tolerance for rounding of two opposite angles beyond 180° (radians).
constexpr double kAngleRounding = 1e-7;

// Counts positions that triangles use.
std::size_t countVertices(const TriangleMesh& mesh, const Welding& welding) {
  std::vector<char> isUsed(mesh.positions.size(), 0);
  for (const Index v : mesh.indices) isUsed[welding.first[v]] = 1;
  return static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), 1));
}

// Fills in what depends on connectivity only. Counts fans of triangles joined by edges around
// vertices: one per vertex, more where the surface is pinched.
void reportConnectivity(const Welding& welding, MeshReport& report) {
  const std::vector<Index>& corners = welding.corners;
  const std::size_t faces = corners.size() / 3;
  // Fan count and component count fall by one whenever two sets turn out to be joined.
  std::size_t edges = 0, fanCount = corners.size();
  report.components = faces;
  DisjointSets components(faces), fans(corners.size());
  std::vector<Index> valence(welding.first.size(), 0);
  std::vector<char> isInterior(valence.size(), 1);
  welding.forEachEdge([&](std::span<const Index> edge) {
    const Index h = edge[0], next = nextCorner(h), from = corners[h], to = corners[next];
    ++edges;
    ++valence[from], ++valence[to];
    report.boundaryEdges += edge.size() == 1;
    report.nonManifoldEdges += edge.size() > 2;
    if (edge.size() != 2) isInterior[from] = isInterior[to] = 0;
    for (const Index other : edge.subspan(1)) {
      report.components -= components.unite(h / 3, other / 3);
      const bool isSameWay = corners[other] == from;
      const Index beyond = nextCorner(other);
      fanCount -= fans.unite(h, isSameWay ? other : beyond);
      fanCount -= fans.unite(next, isSameWay ? beyond : other);
    }
  });
  std::size_t interior = 0, regular = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    interior += valence[v] > 0 && isInterior[v];
    regular += valence[v] == 6 && isInterior[v];
  }
  report.eulerCharacteristic =
      static_cast<long>(fanCount) - static_cast<long>(edges) + static_cast<long>(faces);
  if (interior > 0)
    report.valence6 = 100.0 * static_cast<double>(regular) / static_cast<double>(interior);
}

// The measures of a triangle from which its angles are computed.
struct Sides {
  double shortest, longest, all;  // squared lengths, and their sum
  double twiceArea;

  explicit Sides(const Triangle& t) : twiceArea(areaVector(t[0], t[1], t[2]).norm()) {
    const double a = (t[1] - t[0]).squaredNorm(), b = (t[2] - t[1]).squaredNorm();
    const double c = (t[0] - t[2]).squaredNorm();
    shortest = least(a, b, c);
    longest = greatest(a, b, c);
    all = a + b + c;
  }

  double flatness() const { return longest > 0 ? twiceArea / longest : 0; }
  // This and twiceArea are the angle's cosine and sine times a common length.
  double cosineOpposite(double side) const { return 0.5 * (all - 2 * side); }
  double angleOpposite(double side) const { return angleOf(twiceArea, cosineOpposite(side)); }
};

void reportAngles(const TriangleMesh& mesh, const Welding& welding, MeshReport& report) {
  const std::size_t n = mesh.triangleCount();
  if (n == 0) return;
  std::array<std::size_t, 6> counts{};
  double sum = 0, worst = std::numbers::pi, largest = 0;
  // An angle whose cosine exceeds leastRatio × its sine cannot be the largest so far.
  double leastRatio = kInfinity;
  for (std::size_t t = 0; t < n; ++t) {
    const auto at = [&](std::size_t i) -> const Vec3& {
      return mesh.positions[welding.first[mesh.indices[i]]];
    };
    const Triangle corners = {at(3 * t), at(3 * t + 1), at(3 * t + 2)};
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

MeshReport inspectMesh(const TriangleMesh& mesh, const Welding& welding) {
  MeshReport report;
  report.vertices = countVertices(mesh, welding);
  report.triangles = mesh.triangleCount();
  reportConnectivity(welding, report);
  reportAngles(mesh, welding, report);
  return report;
}

std::vector<Index> touchingVertices(const Welding& welding) {
  const std::vector<Index>& twins = welding.twins;
  std::vector<char> isSeen(twins.size(), 0), hasFan(welding.first.size(), 0);
  std::vector<Index> touching;
  const auto walk = [&](Index from) {
    const Index v = welding.corners[from];
    if (std::exchange(hasFan[v], 1)) touching.push_back(v);
    for (Index c = from; c != kNone && !isSeen[c]; c = twins[prevCorner(c)]) isSeen[c] = 1;
  };
  for (Index c = 0; c < twins.size(); ++c)
    if (twins[c] == kNone) walk(c);  // where open fans begin
  for (Index c = 0; c < twins.size(); ++c)
    if (!isSeen[c]) walk(c);
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

double nonDelaunayPercentage(const TriangleMesh& mesh) {
  const Welding welding(mesh);
  const auto at = [&](Index corner) -> const Vec3& {
    return mesh.positions[welding.corners[corner]];
  };
  std::size_t inner = 0, bad = 0;
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 2) return;
    double sum = 0;
    for (const Index h : edge) {
      const Vec3& apex = at(prevCorner(h));
      const Vec3 a = at(h) - apex, b = at(nextCorner(h)) - apex;
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    ++inner;
    bad += sum > std::numbers::pi + kAngleRounding;
  });
  return inner > 0 ? 100.0 * static_cast<double>(bad) / static_cast<double>(inner) : 0;
}

std::size_t countBoundaryLoops(const TriangleMesh& mesh) {
  const Welding welding(mesh);
  DisjointSets pieces(mesh.positions.size());
  std::vector<char> isOnBoundary(mesh.positions.size(), 0);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    const Index from = welding.corners[edge[0]], to = welding.corners[nextCorner(edge[0])];
    isOnBoundary[from] = isOnBoundary[to] = 1;
    pieces.unite(from, to);
  });
  std::size_t loops = 0;
  for (Index v = 0; v < isOnBoundary.size(); ++v) loops += isOnBoundary[v] && pieces.find(v) == v;
  return loops;
}

}  // namespace remesher
