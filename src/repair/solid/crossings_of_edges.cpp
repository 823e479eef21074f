// SPDX-License-Identifier: MIT
#include "repair/solid/crossings_of_edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/predicates.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Along one axis; u and v are the other two.
class Scan {
 public:
  Scan(const Lattice& lattice, std::size_t axis)
      : lattice_(lattice), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {}

  void add(const Triangle& t, Index number, std::vector<EdgeCrossing>& crossings) const {
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    const std::size_t uEnd = lattice_.count(u_), vEnd = lattice_.count(v_);
    for (std::size_t i = lattice_.firstFrom(u_, low[Eigen::Index(u_)]);
         i < uEnd && lattice_.at(u_, i) <= high[Eigen::Index(u_)]; ++i)
      for (std::size_t k = lattice_.firstFrom(v_, low[Eigen::Index(v_)]);
           k < vEnd && lattice_.at(v_, k) <= high[Eigen::Index(v_)]; ++k) {
        const Vec2 line(lattice_.at(u_, i), lattice_.at(v_, k));
        const int up = passes(t, line);
        if (up == 0) continue;
        const auto a = Eigen::Index(axis_);
        const double at = std::clamp(height(t, line), low[a], high[a]);
        std::array<std::size_t, 3> place{};
        place[u_] = i, place[v_] = k;
        place[axis_] = lattice_.firstFrom(axis_, at);
        if (lattice_.at(axis_, place[axis_]) > at) --place[axis_];
        crossings.push_back({3 * lattice_.number(place) + axis_, at, number, up});
      }
  }

 private:
  Vec2 flat(const Vec3& p) const { return {p[Eigen::Index(u_)], p[Eigen::Index(v_)]}; }

  // How a triangle faces along a line through it; 0 if the line misses it. Sums the edges that the
  // half line towards larger u crosses. On which side of an edge the line lies is the same for both
  // triangles at the edge.
  int passes(const Triangle& t, const Vec2& line) const {
    int up = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 from = flat(t[k]), to = flat(t[(k + 1) % 3]);
      const bool isBelow = from[1] <= line[1];
      if (isBelow == (to[1] <= line[1])) continue;
      const Vec2 &lower = isBelow ? from : to, &upper = isBelow ? to : from;
      if (orient2d(lower, upper, line) > 0) up += isBelow ? 1 : -1;
    }
    return up;
  }

  double height(const Triangle& t, const Vec2& line) const {
    const Vec3 normal = areaVector(t[0], t[1], t[2]);
    const auto a = Eigen::Index(axis_), u = Eigen::Index(u_), v = Eigen::Index(v_);
    const double slope = normal[u] * (line[0] - t[0][u]) + normal[v] * (line[1] - t[0][v]);
    return normal[a] == 0 ? t[0][a] : t[0][a] - slope / normal[a];
  }

  const Lattice& lattice_;
  std::size_t axis_, u_, v_;
};

// Sorts by line and coordinate: first into lines, because each line holds few crossings.
void sortAlong(const Lattice& lattice, std::size_t axis, std::vector<EdgeCrossing>& crossings) {
  std::vector<std::size_t> lines;  // per crossing
  const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  for (const EdgeCrossing& c : crossings) {
    const auto place = lattice.place(c.edge / 3);
    lines.push_back(place[first] * lattice.count(second) + place[second]);
  }
  std::vector<std::size_t> ends(lattice.count(first) * lattice.count(second) + 1, 0);
  for (const std::size_t line : lines) ++ends[line + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<EdgeCrossing> sorted(crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i) sorted[ends[lines[i]]++] = crossings[i];
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    std::sort(sorted.begin() + std::ptrdiff_t(begin), sorted.begin() + std::ptrdiff_t(end),
              [](const EdgeCrossing& a, const EdgeCrossing& b) {
                return a.at != b.at ? a.at < b.at : a.triangle < b.triangle;
              });
    begin = end;
  }
  crossings = std::move(sorted);
}

}  // namespace

std::vector<EdgeCrossing> crossingsOfEdges(const Lattice& lattice, std::span<const Vec3> positions,
                                           std::span<const Index> corners) {
  std::vector<EdgeCrossing> all;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Scan scan(lattice, axis);
    std::vector<EdgeCrossing> along;
    for (std::size_t c = 0; c < corners.size(); c += 3)
      scan.add({positions[corners[c]], positions[corners[c + 1]], positions[corners[c + 2]]},
               Index(c / 3), along);
    sortAlong(lattice, axis, along);
    all.insert(all.end(), along.begin(), along.end());
  }
  return all;
}

}  // namespace remesher
