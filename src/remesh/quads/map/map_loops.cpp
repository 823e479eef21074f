// SPDX-License-Identifier: MIT
#include "remesh/quads/map/map_loops.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/disjoint_sets.h"

namespace remesher {

// Lines are numbered: line k is at k + ½ of an axis. Where a line crosses an edge is a point;
// points of an edge are numbered along it.
class LoopMeter::Lines {
 public:
  Lines(const LoopMeter& meter, std::span<const std::array<double, 2>> places)
      : meter_(meter), places_(places), above_(places.size()), first_(meter.edges_.size()) {
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        above_[i][axis] = int(std::floor(places[i][axis] + 0.5));
    for (std::size_t i = 0; i < first_.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto [a, b] = meter.edges_[i];
        first_[i][axis] = count_;
        count_ += Index(std::abs(above_[b][axis] - above_[a][axis]));
      }
  }

  MapLoops measure() {
    DisjointSets lines(count_);
    MapLoops found;
    for (std::size_t i = 0; i < meter_.triangles_.size(); ++i) {
      follow(i, lines);
      found.area += areaOf(meter_.triangles_[i]);
    }
    for (const auto& [a, b] : meter_.boundary_)
      for (std::size_t axis = 0; axis < 2; ++axis)
        found.boundary += std::abs(places_[b][axis] - places_[a][axis]);
    std::vector<std::size_t> lengths(count_, 0);
    std::size_t longest = 0, crossings = 0;
    for (const auto& [a, b] : middles_) {
      const Index one = lines.find(a), two = lines.find(b);
      longest = std::max({longest, ++lengths[one], ++lengths[two]});
      crossings += one == two;
    }
    const double all = std::max(1.0, 2 * double(middles_.size()));
    found.longest = double(longest) / all;
    found.selfCrossing = 2 * double(crossings) / all;
    for (const std::size_t length : lengths)
      found.squares += double(length) / all * (double(length) / all);
    return found;
  }

 private:
  struct Line {
    int k;
    Index point;
    std::size_t one, two;  // sides of the triangle
  };

  // The point where line k crosses a side, whose ends are on both sides of it.
  Index pointAt(std::size_t triangle, std::size_t side, std::size_t axis, int k) const {
    const std::array<Index, 3>& corners = meter_.triangles_[triangle];
    const int a = above_[corners[side]][axis], b = above_[corners[(side + 1) % 3]][axis];
    const Side& at = meter_.sides_[triangle][side];
    const bool isForward = (b > a) != at.isTwin;
    const int along = isForward ? k - std::min(a, b) : std::max(a, b) - 1 - k;
    const Index point = first_[at.edge][at.isTurned ? 1 - axis : axis] + Index(along);
    return std::min(point, count_ - 1);
  }

  // Where line k crosses a side, along the other axis.
  double otherAt(std::size_t triangle, std::size_t side, std::size_t axis, int k) const {
    const std::array<Index, 3>& corners = meter_.triangles_[triangle];
    const std::array<double, 2>&a = places_[corners[side]], &b = places_[corners[(side + 1) % 3]];
    const double share = (k + 0.5 - a[axis]) / (b[axis] - a[axis]);
    return a[1 - axis] + share * (b[1 - axis] - a[1 - axis]);
  }

  double areaOf(const std::array<Index, 3>& corners) const {
    const std::array<double, 2>&a = places_[corners[0]], &b = places_[corners[1]],
                             &c = places_[corners[2]];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }

  // Joins the points of each line that crosses the triangle.
  void follow(std::size_t triangle, DisjointSets& lines) {
    const std::array<Index, 3>& corners = meter_.triangles_[triangle];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      found_[axis].clear();
      const int a = above_[corners[0]][axis], b = above_[corners[1]][axis],
                c = above_[corners[2]][axis];
      for (int k = std::min({a, b, c}); k < std::max({a, b, c}); ++k) {
        // The corner that is alone on one side of the line.
        const bool isA = a <= k, isB = b <= k, isC = c <= k;
        const std::size_t alone = isB == isC ? 0 : isA == isC ? 1 : 2, before = (alone + 2) % 3;
        const Index point = pointAt(triangle, alone, axis, k);
        lines.unite(point, pointAt(triangle, before, axis, k));
        found_[axis].push_back({k, point, alone, before});
      }
    }
    for (const Line& u : found_[0])
      for (const Line& v : found_[1]) {
        const auto [from, to] =
            std::minmax({otherAt(triangle, u.one, 0, u.k), otherAt(triangle, u.two, 0, u.k)});
        if (from < v.k + 0.5 && v.k + 0.5 < to) middles_.emplace_back(u.point, v.point);
      }
  }

  const LoopMeter& meter_;
  const std::span<const std::array<double, 2>> places_;
  std::vector<std::array<int, 2>> above_;    // per copy: the first line not below it
  std::vector<std::array<Index, 2>> first_;  // per edge: its first point for each axis
  Index count_ = 0;
  std::array<std::vector<Line>, 2> found_;        // of one triangle
  std::vector<std::pair<Index, Index>> middles_;  // of quads: a point on each line
};

LoopMeter::LoopMeter(const HalfedgeMesh& mesh, const SeamlessSystem& system, const CutField& cut) {
  HalfedgeData<Index> edges(mesh.halfedgeCapacity(), kNone);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    edges[h] = Index(edges_.size());
    edges_.push_back({system.copy(h), system.copy(HalfedgeMesh::next(h))});
    if (mesh.isBoundary(h)) boundary_.push_back(edges_.back());
  }
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    if (!mesh.isAlive(Face(f))) continue;
    std::array<Index, 3>& corners = triangles_.emplace_back();
    std::array<Side, 3>& sides = sides_.emplace_back();
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge h = HalfedgeMesh::halfedge(Face(f), corner);
      const bool isTwin = !mesh.isEdge(h);
      corners[std::size_t(corner)] = system.copy(h);
      sides[std::size_t(corner)] = {edges[isTwin ? mesh.twin(h) : h], isTwin,
                                    isTwin && cut.turn[h] % 2 != 0};
    }
  }
}

MapLoops LoopMeter::measure(std::span<const std::array<double, 2>> places) const {
  return Lines(*this, places).measure();
}

}  // namespace remesher
