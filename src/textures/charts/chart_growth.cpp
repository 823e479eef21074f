// SPDX-License-Identifier: MIT
#include "textures/charts/chart_growth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/edge_groups.h"
#include "textures/charts/border_loops.h"
#include "textures/charts/chart_overlap.h"
#include "textures/charts/plane_frame.h"

namespace remesher {

namespace {

const double kLeastCosine = std::cos(kMostTilt);
// How much more a bent union costs than a flat one.
constexpr double kBending = 8;

// A set of triangles that grows to a chart.
struct Cluster {
  std::vector<Index> triangles;
  Vec3 areaVector = Vec3::Zero();  // twice the sum of the areas times the normals
  double area = 0;
  double perimeter = 0;
  std::map<Index, double> neighbours;  // by number: length of the common border
  Index version = 0;
};

// A pair of clusters that could be merged; stale if either has changed since.
struct Proposal {
  double cost;
  Index a, b;
  Index versionA, versionB;

  bool operator<(const Proposal& other) const {  // the cheapest on top of a heap
    return std::tie(other.cost, other.a, other.b) < std::tie(cost, a, b);
  }
};

class Growth {
 public:
  explicit Growth(const ChartSurface& surface)
      : surface_(surface),
        clusters_(surface.indices.size() / 3),
        clusterOf_(surface.indices.size() / 3) {
    for (Index t = 0; t < clusters_.size(); ++t) addTriangle(t);
    for (Index t = 0; t < surface.faces.size(); ++t)
      if (surface.faces[t] != t && mayJoin(surface.faces[t], t)) merge(surface.faces[t], t);
    for (Index t = 0; t < clusters_.size(); ++t)
      for (const auto& [other, length] : clusters_[t].neighbours)
        if (t < other) propose(t, other);
  }

  std::vector<Chart> run() {
    while (!heap_.empty()) {
      const Proposal next = heap_.top();
      heap_.pop();
      const bool isStale =
          clusters_[next.a].version != next.versionA || clusters_[next.b].version != next.versionB;
      if (!isStale && fits(next.a, next.b)) merge(next.a, next.b);
    }
    std::vector<Chart> charts;
    for (Cluster& cluster : clusters_)
      if (!cluster.triangles.empty())
        charts.push_back({std::move(cluster.triangles), axisOf(cluster.areaVector)});
    return charts;
  }

 private:
  Vec3 corner(Index h) const { return surface_.positions[surface_.indices[h]]; }
  double edgeLength(Index h) const { return (corner(nextCorner(h)) - corner(h)).norm(); }
  static Vec3 axisOf(const Vec3& areaVector) {
    const double length = areaVector.norm();
    return length > 0 ? Vec3(areaVector / length) : Vec3(Vec3::UnitZ());
  }

  void addTriangle(Index t) {
    Cluster& cluster = clusters_[t];
    clusterOf_[t] = t;
    cluster.triangles = {t};
    cluster.areaVector = areaVector(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2));
    cluster.area = cluster.areaVector.norm();
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      cluster.perimeter += edgeLength(h);
      const Index twin = surface_.twins[h];
      if (twin != kNone && twin / 3 != t) cluster.neighbours[twin / 3] += edgeLength(h);
    }
  }

  // Whether the triangles of a quad share an edge that is not cut, and neither is turned over as
  // seen from above the quad.
  bool mayJoin(Index first, Index second) const {
    const Cluster &x = clusters_[first], &y = clusters_[second];
    const Vec3 sum = x.areaVector + y.areaVector;
    return x.neighbours.contains(second) && x.areaVector.dot(sum) > 0 && y.areaVector.dot(sum) > 0;
  }

  void propose(Index a, Index b) {
    const Cluster &x = clusters_[a], &y = clusters_[b];
    const double perimeter = x.perimeter + y.perimeter - 2 * x.neighbours.at(b);
    const double area = std::max(x.area + y.area, 1e-300);
    const double compactness = perimeter * perimeter / (2 * std::numbers::pi * area);
    const double bend = 1 - (x.areaVector + y.areaVector).norm() / area;
    heap_.push({compactness * (1 + kBending * bend), std::min(a, b), std::max(a, b),
                clusters_[std::min(a, b)].version, clusters_[std::max(a, b)].version});
  }

  bool fits(Index a, Index b) {
    const Vec3 axis = axisOf(clusters_[a].areaVector + clusters_[b].areaVector);
    for (const Index cluster : {a, b})
      for (const Index t : clusters_[cluster].triangles) {
        const Vec3 normal = areaVector(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2));
        if (normal.dot(axis) < kLeastCosine * normal.norm()) return false;
      }
    const auto isOurs = [&](Index t) { return clusterOf_[t] == a || clusterOf_[t] == b; };
    return !coversTwice(border({a, b}, isOurs, PlaneFrame(axis)));
  }

  // The border loops of a union.
  template <class IsOurs>
  std::vector<std::vector<PlaneEdge>> border(std::array<Index, 2> clusters, const IsOurs& isOurs,
                                             const PlaneFrame& frame) {
    std::vector<Index> edges;
    const auto isBorder = [&](Index h) {
      return surface_.twins[h] == kNone || !isOurs(surface_.twins[h] / 3);
    };
    for (const Index cluster : clusters)
      for (const Index t : clusters_[cluster].triangles)
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
          if (isBorder(h)) edges.push_back(h);
    std::vector<std::vector<PlaneEdge>> loops;
    for (const std::vector<Index>& loop : borderLoops(std::move(edges), surface_.twins, isBorder)) {
      loops.emplace_back();
      for (const Index h : loop) {
        const Index end = nextCorner(h);
        loops.back().push_back({surface_.indices[h], surface_.indices[end],
                                frame.project(corner(h)), frame.project(corner(end))});
      }
    }
    return loops;
  }

  void merge(Index a, Index b) {
    if (clusters_[a].triangles.size() < clusters_[b].triangles.size()) std::swap(a, b);
    Cluster &x = clusters_[a], &y = clusters_[b];
    x.perimeter += y.perimeter - 2 * x.neighbours.at(b);
    x.area += y.area;
    x.areaVector += y.areaVector;
    for (const Index t : y.triangles) clusterOf_[t] = a;
    x.triangles.insert(x.triangles.end(), y.triangles.begin(), y.triangles.end());
    for (const auto& [other, length] : y.neighbours) {
      clusters_[other].neighbours.erase(b);
      if (other == a) continue;
      x.neighbours[other] += length;
      clusters_[other].neighbours[a] += length;
    }
    const Index version = y.version + 1;
    y = Cluster();
    y.version = version;
    ++x.version;
    for (const auto& [other, length] : x.neighbours) propose(a, other);
  }

  const ChartSurface& surface_;
  std::vector<Cluster> clusters_;
  std::vector<Index> clusterOf_;
  std::priority_queue<Proposal> heap_;
};

}  // namespace

std::vector<Chart> growCharts(const ChartSurface& surface) { return Growth(surface).run(); }

}  // namespace remesher
