// SPDX-License-Identifier: MIT
#include "textures/charts/chart_joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/fires.h"
#include "mesh/edge_groups.h"
#include "textures/charts/border_loops.h"
#include "textures/charts/chart_overlap.h"
#include "textures/charts/chart_relaxing.h"
#include "textures/charts/plane_frame.h"

namespace remesher {

namespace {

// Limit on a union's triangles: each join visits all of them, and larger charts have little border.
constexpr std::size_t kMostTriangles = 6144;
// A union may be as long as this multiple of the longer of its charts, whatever the limit.
constexpr double kGrown = 1.1;
// Directions in which the length of a chart is measured.
constexpr int kDirections = 8;

// The longest extent of points in the plane, about.
class PlaneReach {
 public:
  void add(const Vec2& p) {
    for (int i = 0; i < kDirections; ++i) {
      const double along = p.dot(directions()[i]);
      low_[i] = std::min(low_[i], along);
      high_[i] = std::max(high_[i], along);
    }
  }

  double longest() const {
    double longest = 0;
    for (int i = 0; i < kDirections; ++i) longest = std::max(longest, high_[i] - low_[i]);
    return longest;
  }

 private:
  using Ends = std::array<double, kDirections>;

  static const std::array<Vec2, kDirections>& directions() {
    static const std::array<Vec2, kDirections> all = [] {
      std::array<Vec2, kDirections> turned;
      for (int i = 0; i < kDirections; ++i)
        turned[i] = Eigen::Rotation2Dd(i * std::numbers::pi / kDirections) * Vec2::UnitX();
      return turned;
    }();
    return all;
  }

  static Ends filled(double value) {
    Ends ends;
    ends.fill(value);
    return ends;
  }

  Ends low_ = filled(kInfinity), high_ = filled(-kInfinity);
};

struct Offer {
  Index from, into;
  std::vector<Index> seam;  // corners of `from`
  Index versions;           // sum of both charts' versions
};

class Joining {
 public:
  Joining(const ChartSurface& surface, std::vector<Chart> charts, double longest)
      : surface_(surface),
        longest_(longest),
        corners_(surface.indices.size()),
        isGlued_(surface.indices.size(), 0),
        chartOf_(surface.indices.size() / 3),
        versions_(charts.size(), 0) {
    for (Index c = 0; c < charts.size(); ++c) {
      for (const Index t : charts[c].triangles) chartOf_[t] = c;
      triangles_.push_back(std::move(charts[c].triangles));
    }
    for (Index h = 0; h < isGlued_.size(); ++h)
      isGlued_[h] = surface.twins[h] != kNone && chartOf_[surface.twins[h] / 3] == chartOf_[h / 3];
    for (Index c = 0; c < charts.size(); ++c) layDown(c, PlaneFrame(charts[c].axis));
  }

  std::vector<FlatChart> run() {
    for (Index c = 0; c < triangles_.size(); ++c) offer(c);
    while (!queue_.empty()) {
      const Offer next = std::move(offers_[queue_.top().second]);
      queue_.pop();
      if (versions_[next.from] + versions_[next.into] != next.versions) continue;
      if (!triangles_[next.from].empty() && !triangles_[next.into].empty() && join(next))
        offer(next.into);
    }
    std::vector<FlatChart> result;
    for (std::vector<Index>& triangles : triangles_) {
      if (triangles.empty()) continue;
      PlaneChart plane;
      PlaneReach reach;
      for (const Index t : triangles) {
        plane.push_back({corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]});
        for (const Vec2& p : plane.back()) reach.add(p);
      }
      result.push_back({std::move(triangles), std::move(plane), reach.longest()});
    }
    return result;
  }

 private:
  Vec3 position(Index h) const { return surface_.positions[surface_.indices[h]]; }
  double edgeLength(Index h) const { return (position(nextCorner(h)) - position(h)).norm(); }

  // Lays a chart down as seen from above, enlarged so that areas are as far above their true size
  // as below. Relaxes it if the relaxed chart is true to the surface.
  void layDown(Index chart, const PlaneFrame& frame) {
    const double enlarged = std::sqrt(std::sqrt(1 / std::cos(kMostTilt)));
    for (const Index t : triangles_[chart])
      for (Index h = 3 * t; h < 3 * t + 3; ++h) corners_[h] = enlarged * frame.project(position(h));
    PlaneMesh mesh = meshOf(triangles_[chart]);
    if (relax(mesh) && !coversTwice(borderOf(triangles_[chart], mesh)))
      keep(triangles_[chart], mesh);
  }

  void keep(const std::vector<Index>& triangles, const PlaneMesh& mesh) {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (Index k = 0; k < 3; ++k)
        corners_[3 * triangles[i] + k] = mesh.vertices[mesh.triangles[i][k]];
  }

  // The chart's triangles with glued corners as one vertex, at the mean of the corners' places.
  PlaneMesh meshOf(const std::vector<Index>& triangles) {
    place_.resize(chartOf_.size());
    for (Index i = 0; i < triangles.size(); ++i) place_[triangles[i]] = i;
    const auto local = [&](Index h) { return 3 * place_[h / 3] + h % 3; };
    DisjointSets same(3 * triangles.size());
    for (const Index t : triangles)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        if (!isGlued_[h]) continue;
        same.unite(local(h), local(nextCorner(surface_.twins[h])));
        same.unite(local(nextCorner(h)), local(surface_.twins[h]));
      }
    PlaneMesh mesh;
    std::vector<Index> numbers(3 * triangles.size(), kNone);
    std::vector<double> counts;
    for (const Index t : triangles) {
      mesh.wanted.push_back(laidDown(position(3 * t), position(3 * t + 1), position(3 * t + 2)));
      mesh.triangles.emplace_back();
      for (Index k = 0; k < 3; ++k) {
        Index& number = numbers[same.find(local(3 * t + k))];
        if (number == kNone) {
          number = Index(mesh.vertices.size());
          mesh.vertices.push_back(Vec2::Zero());
          counts.push_back(0);
        }
        mesh.triangles.back()[k] = number;
        mesh.vertices[number] += corners_[3 * t + k];
        ++counts[number];
      }
    }
    for (std::size_t v = 0; v < counts.size(); ++v) mesh.vertices[v] /= counts[v];
    return mesh;
  }

  // The border loops, each as the corners of its edges.
  std::vector<std::vector<Index>> loopsOf(const std::vector<Index>& triangles) const {
    const auto isBorder = [&](Index h) { return !isGlued_[h]; };
    std::vector<Index> edges;
    for (const Index t : triangles)
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (isBorder(h)) edges.push_back(h);
    return borderLoops(std::move(edges), surface_.twins, isBorder);
  }

  std::vector<std::vector<PlaneEdge>> borderOf(const std::vector<Index>& triangles,
                                               const PlaneMesh& mesh) const {
    std::vector<std::vector<PlaneEdge>> border;
    const auto vertex = [&](Index h) { return mesh.triangles[place_[h / 3]][h % 3]; };
    for (const std::vector<Index>& loop : loopsOf(triangles)) {
      border.emplace_back();
      for (const Index h : loop) {
        const Index a = vertex(h), b = vertex(nextCorner(h));
        border.back().push_back({a, b, mesh.vertices[a], mesh.vertices[b]});
      }
    }
    return border;
  }

  Index beyond(Index h) const {
    return surface_.twins[h] == kNone ? kNone : chartOf_[surface_.twins[h] / 3];
  }

  double perimeter(Index chart) const {
    double sum = 0;
    for (const Index t : triangles_[chart])
      for (Index h = 3 * t; h < 3 * t + 3; ++h) sum += isGlued_[h] ? 0 : edgeLength(h);
    return sum;
  }

  // Offers every piece of border that a chart shares with a neighbour.
  void offer(Index chart) {
    const double own = perimeter(chart);
    for (std::vector<Index>& loop : loopsOf(triangles_[chart])) {
      const auto isBreak = [&](std::size_t i) {
        return beyond(loop[i]) != beyond(loop[i == 0 ? loop.size() - 1 : i - 1]);
      };
      std::size_t first = 0;
      while (first < loop.size() && !isBreak(first)) ++first;
      if (first < loop.size()) std::rotate(loop.begin(), loop.begin() + first, loop.end());
      for (std::size_t begin = 0, end = 0; begin < loop.size(); begin = end) {
        double length = 0;
        const Index other = beyond(loop[begin]);
        for (; end < loop.size() && beyond(loop[end]) == other; ++end)
          length += edgeLength(loop[end]);
        if (other == kNone || other == chart) continue;
        add(chart, other, {loop.begin() + begin, loop.begin() + end},
            length / std::min(own, perimeter(other)));
      }
    }
  }

  // The larger chart takes in the smaller one.
  void add(Index chart, Index other, std::vector<Index> seam, double shared) {
    if (triangles_[chart].size() + triangles_[other].size() > kMostTriangles) {
      fires("chart joining: most triangles");
      return;
    }
    const bool isSmaller = triangles_[chart].size() < triangles_[other].size();
    if (!isSmaller)
      for (Index& h : seam) h = surface_.twins[h];
    queue_.push({shared, Index(offers_.size())});
    offers_.push_back({isSmaller ? chart : other, isSmaller ? other : chart, std::move(seam),
                       versions_[chart] + versions_[other]});
  }

  bool join(const Offer& next) {
    std::vector<Vec2> from, to;
    for (const Index h : next.seam) {
      const Index twin = surface_.twins[h];
      from.insert(from.end(), {corners_[h], corners_[nextCorner(h)]});
      to.insert(to.end(), {corners_[nextCorner(twin)], corners_[twin]});
    }
    const PlaneMotion motion(from, to);
    const double longest =
        std::max(longest_, kGrown * std::max(lengthOf(next.from), lengthOf(next.into)));
    std::vector<Index>&own = triangles_[next.from], &others = triangles_[next.into];
    const std::vector<Vec2> before = moved(own, motion);
    glue(next.seam, 1);
    std::vector<Index> all = others;
    all.insert(all.end(), own.begin(), own.end());
    PlaneMesh mesh = meshOf(all);
    if (!relax(mesh) || lengthOf(mesh) > longest || coversTwice(borderOf(all, mesh))) {
      glue(next.seam, 0);
      for (std::size_t i = 0; i < before.size(); ++i) corners_[3 * own[i / 3] + i % 3] = before[i];
      return false;
    }
    keep(all, mesh);
    for (const Index t : own) chartOf_[t] = next.into;
    others = std::move(all);
    own.clear();
    ++versions_[next.into];
    ++versions_[next.from];
    return true;
  }

  double lengthOf(Index chart) const {
    PlaneReach reach;
    for (const Index t : triangles_[chart])
      for (Index h = 3 * t; h < 3 * t + 3; ++h) reach.add(corners_[h]);
    return reach.longest();
  }

  static double lengthOf(const PlaneMesh& mesh) {
    PlaneReach reach;
    for (const Vec2& p : mesh.vertices) reach.add(p);
    return reach.longest();
  }

  // Moves the triangles; returns where their corners were.
  std::vector<Vec2> moved(const std::vector<Index>& triangles, const PlaneMotion& motion) {
    std::vector<Vec2> before;
    for (const Index t : triangles)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        before.push_back(corners_[h]);
        corners_[h] = motion(corners_[h]);
      }
    return before;
  }

  void glue(const std::vector<Index>& seam, char isGlued) {
    for (const Index h : seam) isGlued_[h] = isGlued_[surface_.twins[h]] = isGlued;
  }

  const ChartSurface& surface_;
  double longest_;              // of a union of short charts
  std::vector<Vec2> corners_;   // in the plane of their chart
  std::vector<char> isGlued_;   // per corner: whether the chart continues across the edge from it
  std::vector<Index> chartOf_;  // per triangle
  std::vector<Index> versions_;
  std::vector<std::vector<Index>> triangles_;  // per chart
  std::vector<Index> place_;                   // per triangle its number in the current chart
  std::vector<Offer> offers_;
  // By the shared length, as a share of the shorter border of the two charts.
  std::priority_queue<std::pair<double, Index>> queue_;
};

}  // namespace

std::vector<FlatChart> layFlat(const ChartSurface& surface, std::vector<Chart> charts,
                               double longest) {
  return Joining(surface, std::move(charts), longest).run();
}

}  // namespace remesher
