// SPDX-License-Identifier: MIT
#include "remesh/quads/map/near_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace remesher {

namespace {

// Coordinates are exact but for this, in quads.
constexpr double kHairline = 1e-6;
// A look along a line takes no more triangles.
constexpr std::size_t kMostPassed = 20000;

using SumPair = std::array<IntegerSum, 2>;

IntegerSum opposite(const IntegerSum& sum) { return plus({}, sum, -1); }

SumPair turnedSums(const SumPair& sums, int turn) {
  switch (turn) {
    case 0:
      return sums;
    case 1:
      return {opposite(sums[1]), sums[0]};
    case 2:
      return {opposite(sums[0]), opposite(sums[1])};
    default:
      return {sums[1], opposite(sums[0])};
  }
}

// u along a line, v to one side of it, in quads.
struct LinePoint {
  double u, v;
};

class PassSearch {
 public:
  PassSearch(const LineInput& input, const SeamlessMap& map, const PassReach& reach)
      : input_(input), m_(input.mesh.mesh()), map_(map), reach_(reach) {}

  std::vector<NearPass> run() {
    for (Index i = 0; i < m_.vertexCapacity(); ++i) {
      if (!m_.isAlive(Vertex(i)) || !isPlace(Vertex(i))) continue;
      m_.forEachOutgoing(Vertex(i), [&](Halfedge h) {
        for (int direction = 0; direction < 4; ++direction)
          if (isInside(h, direction))
            for (const int side : {1, -1}) follow({h, direction, side});
      });
    }
    std::vector<NearPass> found;
    for (auto& [sum, pass] : found_) found.push_back(std::move(pass));
    return found;
  }

 private:
  // A line leaves the origin of a halfedge into its triangle; vertices to one side of it are looked
  // at.
  struct Line {
    Halfedge start;
    int direction;  // quarter turns from u
    int side;       // 1 to its left
  };
  // A triangle on the way along a line.
  struct Step {
    Face face;
    Transition toLine;  // u along the line, from its start
    Index parent;
    Halfedge entered;
  };

  bool isPlace(Vertex v) const {
    return input_.singular[v] != 0 || input_.mesh.kind(v) == VertexKind::Corner;
  }

  // Whether a direction leads from the origin of h into its triangle.
  bool isInside(Halfedge h, int direction) const {
    const MapPoint& p = map_.corners[h];
    const MapPoint end = p + Transition{direction, {}}(MapPoint{kUnit, 0});
    return orientation(p, map_.corners[HalfedgeMesh::next(h)], end) >= 0 &&
           orientation(p, map_.corners[HalfedgeMesh::prev(h)], end) < 0;
  }

  LinePoint at(const Step& step, Halfedge corner, int side) const {
    const MapPoint p = step.toLine(map_.corners[corner]);
    return {double(p.u) / double(kUnit), side * double(p.v) / double(kUnit)};
  }

  // How far along the line the edge comes into the strip of this width beside it; beyond the reach
  // if it does not.
  double entryOf(const Step& step, Halfedge h, int side, double width) const {
    LinePoint a = at(step, h, side), b = at(step, HalfedgeMesh::next(h), side);
    if (a.v > b.v) std::swap(a, b);
    const double low = kHairline, high = width - kHairline;
    if (b.v < low || a.v > high) return reach_.along;
    const auto pointAt = [&](double v) { return a.u + (v - a.v) / (b.v - a.v) * (b.u - a.u); };
    const double first = a.v < low ? pointAt(low) : a.u, last = b.v > high ? pointAt(high) : b.u;
    if (std::max(first, last) <= 0) return reach_.along;
    return std::max(0.0, std::min(first, last));
  }

  // The triangles beside the line, the nearest first. Once a vertex is found, only the strip
  // between it and the line goes on.
  void follow(const Line& line) {
    const Transition turn{(4 - line.direction) % 4, {}};
    const MapPoint origin = turn(map_.corners[line.start]);
    std::vector<Step> steps = {
        {HalfedgeMesh::face(line.start), {turn.turn, MapPoint{} - origin}, kNone, {}}};
    double width = reach_.across + 2 * kHairline;
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::set<std::tuple<Index, int, MapPoint>> seen;
    queue.push({0, 0});
    while (!queue.empty() && steps.size() < kMostPassed) {
      const Index now = queue.top().second;
      queue.pop();
      const Step step = steps[now];
      if (step.entered &&
          entryOf(steps[step.parent], m_.twin(step.entered), line.side, width) >= reach_.along)
        continue;
      if (!seen.insert({step.face.index, step.toLine.turn, step.toLine.shift}).second) continue;
      if (!passVertices(line, steps, now, width)) return;
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge h = HalfedgeMesh::halfedge(step.face, corner), twin = m_.twin(h);
        if (!twin || h == step.entered) continue;
        const double entry = entryOf(step, h, line.side, width);
        if (entry >= reach_.along) continue;
        queue.push({entry, Index(steps.size())});
        steps.push_back(
            {HalfedgeMesh::face(twin), after(map_.across(m_, twin), step.toLine), now, twin});
      }
    }
  }

  // Adds the singular vertices of a triangle in the strip, which becomes narrower. False if the
  // line meets one.
  bool passVertices(const Line& line, const std::vector<Step>& steps, Index now, double& width) {
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge h = HalfedgeMesh::halfedge(steps[now].face, corner);
      if (!isPlace(m_.origin(h))) continue;
      const auto [u, v] = at(steps[now], h, line.side);
      if (u < 0.5 || u > reach_.along || v < -kHairline || v > width) continue;
      const double across = std::round(v);
      if (across >= width) continue;
      width = across;
      add(line, steps, now, {h, u});
      if (across == 0) return false;
    }
    return true;
  }

  struct Passed {
    Halfedge corner;
    double along;
  };

  // The coordinates of the vertex, taken back step by step to the triangle where the line starts.
  void add(const Line& line, const std::vector<Step>& steps, Index last, const Passed& passed) {
    SumPair sums = input_.system.corner(passed.corner);
    for (Index i = last; steps[i].parent != kNone; i = steps[i].parent) {
      const Halfedge h = steps[i].entered;
      if (!input_.cut.isCut[h]) continue;
      const SumPair& there = input_.system.corner(HalfedgeMesh::next(m_.twin(h)));
      const SumPair here = turnedSums(input_.system.corner(h), map_.turn[h]);
      sums = turnedSums(sums, map_.turn[h]);
      for (std::size_t axis = 0; axis < 2; ++axis)
        sums[axis] = plus(sums[axis], plus(there[axis], here[axis], -1), 1);
    }
    const std::size_t axis = line.direction % 2 == 0 ? 1 : 0;
    const SumPair& start = input_.system.corner(line.start);
    IntegerSum across = plus(sums[axis], start[axis], -1);
    if (across.empty()) return;
    if (across.front().second < 0) across = opposite(across);
    NearPass pass{across, plus(sums[1 - axis], start[1 - axis], -1), passed.along};
    found_.try_emplace(std::move(across), std::move(pass));
  }

  const LineInput& input_;
  const HalfedgeMesh& m_;
  const SeamlessMap& map_;
  const PassReach reach_;
  std::map<IntegerSum, NearPass> found_;  // one for each way across
};

}  // namespace

std::vector<NearPass> nearPasses(const LineInput& input, const SeamlessMap& map,
                                 const PassReach& reach) {
  return PassSearch(input, map, reach).run();
}

}  // namespace remesher
