// SPDX-License-Identifier: MIT
#include "arrangement/cells.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/disjoint_sets.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Facet f has the sides 2f, where its corners turn left, and 2f + 1. A cell is a set of sides that
// face each other.
constexpr Index front(Index facet) { return 2 * facet; }
constexpr Index back(Index facet) { return 2 * facet + 1; }

class Cells {
 public:
  Cells(PointPool& points, const ArrangedTriangles& triangles, const Facets& facets)
      : points_(points),
        triangles_(triangles),
        facets_(facets),
        operandCount_(std::size_t{1} +
                      *std::max_element(triangles.operands.begin(), triangles.operands.end())) {
    for (Index f = 0; f < facets.size(); ++f)
      if (separates(f)) walls_.push_back(f);
    for (const Index f : walls_)
      for (std::size_t k = 0; k < 3; ++k)
        corners_.push_back(facets.corners[std::size_t{3} * f + k]);
  }

  InsideBoundary run(const InsideRule& isInside) {
    joinSides();
    windAll();
    InsideBoundary boundary;
    KeptFacets& kept = boundary.kept;
    boundary.isOutsideDropped = walls_.size() < facets_.size();  // those cancel, wherever they are
    for (Index wall = 0; wall < walls_.size(); ++wall) {
      const bool isFrontInside = isInside(winding(front(wall)));
      if (isFrontInside == isInside(winding(back(wall)))) {
        boundary.isOutsideDropped |= !isFrontInside;
        continue;
      }
      std::array<Index, 3> c = {corners_[3 * wall], corners_[3 * wall + 1], corners_[3 * wall + 2]};
      if (isFrontInside) std::swap(c[1], c[2]);
      kept.corners.insert(kept.corners.end(), c.begin(), c.end());
      boundary.facets.push_back(walls_[wall]);
      kept.from.push_back(bestParent(walls_[wall], isFrontInside ? -1 : 1));
    }
    boundary.work = work_;
    return boundary;
  }

 private:
  // How the winding numbers grow from the facet's front to its back.
  std::vector<int> rise(Index facet) const {
    std::vector<int> rise(operandCount_, 0);
    for (const FacetParent& p : facets_.parentsOf(facet))
      rise[triangles_.operands[p.triangle]] += p.sign;
    return rise;
  }

  bool separates(Index facet) const {
    if (facets_.parentsOf(facet).size() == 1) return true;
    const std::vector<int> all = rise(facet);
    return std::any_of(all.begin(), all.end(), [](int r) { return r != 0; });
  }

  FacetParent bestParent(Index facet, int sign) const {
    const std::span<const FacetParent> parents = facets_.parentsOf(facet);
    const auto alike = std::find_if(parents.begin(), parents.end(),
                                    [&](const FacetParent& p) { return p.sign == sign; });
    const FacetParent& best = alike == parents.end() ? parents.front() : *alike;
    return {best.triangle, best.sign * sign};
  }

  GivenPlane planeOf(Index wall) const { return triangles_[facets_.parent(walls_[wall])]; }

  void joinSides() {
    const EdgeGroups edges(points_.size(), corners_);
    bodies_ = DisjointSets(walls_.size());
    cells_ = DisjointSets(2 * walls_.size());
    std::vector<Index> around;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      around.assign(edges[e].begin(), edges[e].end());
      if (around.size() > 2) sortAround(around);
      const Index tail = corners_[around.front()];
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Index h = around[i], g = around[(i + 1) % around.size()];
        bodies_.unite(h / 3, g / 3);
        cells_.unite(corners_[h] == tail ? front(h / 3) : back(h / 3),
                     corners_[g] == tail ? back(g / 3) : front(g / 3));
      }
    }
  }

  // By the angle round the edge, counterclockwise seen from its head: a facet that runs along the
  // edge as the first one does has its front on the counterclockwise side.
  void sortAround(std::vector<Index>& around) {
    const Index first = around.front(), tail = corners_[first];
    const auto side = [&](Index h, Index g) {  // of g, seen from h
      ++work_;
      const int above = points_.above(planeOf(h / 3), corners_[prevCorner(g)]);
      return corners_[h] == tail ? above : -above;
    };
    std::vector<std::pair<int, Index>> byHalf;  // 0: the first half turn, 1: opposite, 2: the rest
    for (std::size_t i = 1; i < around.size(); ++i)
      byHalf.emplace_back(1 - side(first, around[i]), around[i]);
    std::sort(byHalf.begin(), byHalf.end(), [&](const auto& h, const auto& g) {
      return h.first != g.first ? h.first < g.first : side(h.second, g.second) > 0;
    });
    for (std::size_t i = 1; i < around.size(); ++i) around[i] = byHalf[i - 1].second;
  }

  std::span<const int> winding(Index side) {
    return std::span(windings_).subspan(cells_.find(side) * operandCount_, operandCount_);
  }

  // One ray for each body of facets that hang together; from there across the facets.
  void windAll() {
    const std::size_t sides = 2 * walls_.size();
    std::vector<Index> starts(sides + 1, 0), sorted(sides);
    for (Index s = 0; s < sides; ++s) ++starts[cells_.find(s) + 1];
    for (std::size_t c = 0; c < sides; ++c) starts[c + 1] += starts[c];
    std::vector<Index> next(starts.begin(), starts.end() - 1);
    for (Index s = 0; s < sides; ++s) sorted[next[cells_.find(s)]++] = s;
    windings_.assign(sides * operandCount_, 0);
    std::vector<std::uint8_t> isKnown(sides, 0);
    std::vector<Index> open;
    for (Index wall = 0; wall < walls_.size(); ++wall) {
      if (bodies_.find(wall) != wall) continue;
      const auto [side, around] = windingBeside(wall);
      const Index start = cells_.find(side);
      std::copy(around.begin(), around.end(),
                windings_.begin() + std::ptrdiff_t(start * operandCount_));
      isKnown[start] = 1;
      open.push_back(start);
      while (!open.empty()) {
        const Index cell = open.back();
        open.pop_back();
        for (Index i = starts[cell]; i < starts[cell + 1]; ++i) {
          const Index across = cells_.find(sorted[i] ^ 1);
          if (isKnown[across]) continue;
          isKnown[across] = 1;
          const std::vector<int> grows = rise(walls_[sorted[i] / 2]);
          for (std::size_t o = 0; o < operandCount_; ++o)
            windings_[across * operandCount_ + o] =
                windings_[cell * operandCount_ + o] + (sorted[i] % 2 == 0 ? grows[o] : -grows[o]);
          open.push_back(across);
        }
      }
    }
  }

  // The winding numbers on one side of a facet. A ray that meets an edge is replaced by one from
  // another point of the facet.
  std::pair<Index, std::vector<int>> windingBeside(Index wall) {
    const FlatView view = points_.viewOf(planeOf(wall));
    const std::array<Index, 3> c = {corners_[3 * wall], corners_[3 * wall + 1],
                                    corners_[3 * wall + 2]};
    const bool facesAhead = points_.turn(c[0], c[1], c[2], view) > 0;
    for (int attempt = 0;; ++attempt) {
      const Index start = points_.mean(c, {7 + 5 * attempt, 11 + 2 * attempt, 13 + 9 * attempt});
      const std::optional<std::vector<int>> found = windingAhead(wall, start, view);
      if (found) return {facesAhead ? front(wall) : back(wall), *found};
    }
  }

  // The sum over the triangles that a ray along the axis meets.
  std::optional<std::vector<int>> windingAhead(Index wall, Index start, FlatView view) {
    std::vector<int> sum(operandCount_, 0);
    bool isClear = true;
    constexpr double kRounding = 1e-15, kBeyondAll = 2;
    Box ray;
    ray.low = points_.position(start).array() - kRounding;
    ray.high = points_.position(start).array() + kRounding;
    ray.high[view.left] = kBeyondAll;
    const std::span<const FacetParent> own = facets_.parentsOf(walls_[wall]);
    visitOverlapping(ray, [&](Index t) {
      ++work_;
      if (std::any_of(own.begin(), own.end(),
                      [t](const FacetParent& p) { return p.triangle == t; }))
        return;
      const GivenPlane v = triangles_[t];
      const int a = points_.turn(v[0], v[1], start, view),
                b = points_.turn(v[1], v[2], start, view),
                d = points_.turn(v[2], v[0], start, view);
      const bool isLeft = a >= 0 && b >= 0 && d >= 0, isRight = a <= 0 && b <= 0 && d <= 0;
      if (!isLeft && !isRight) return;
      if (a == 0 || b == 0 || d == 0) {
        isClear = false;
        return;
      }
      const int sign = isLeft ? 1 : -1;
      if (points_.above(v, start) == -sign) sum[triangles_.operands[t]] += sign;
    });
    return isClear ? std::optional(sum) : std::nullopt;
  }

  // For a few boxes all triangles are looked at, which takes less than a tree.
  template <class Visit>
  void visitOverlapping(const Box& box, Visit visit) {
    constexpr int kFew = 8;
    if (++boxes_ > kFew) return triangles_.tree().visitOverlapping(box, visit);
    for (Index t = 0; t < triangles_.size(); ++t) {
      Box own;
      for (const Index corner : triangles_[t]) own.extend(points_.position(corner));
      if (own.overlaps(box)) visit(t);
    }
  }

  PointPool& points_;
  const ArrangedTriangles& triangles_;
  const Facets& facets_;
  const std::size_t operandCount_;
  std::vector<Index> walls_;    // the facets that separate different winding numbers
  std::vector<Index> corners_;  // theirs
  DisjointSets bodies_{0};      // of walls
  DisjointSets cells_{0};       // of their sides
  std::vector<int> windings_;   // per cell, by its lowest side, and operand
  int boxes_ = 0;               // for which triangles were looked at
  std::size_t work_ = 0;
};

}  // namespace

InsideBoundary boundaryOfInside(PointPool& points, const ArrangedTriangles& triangles,
                                const Facets& facets, const InsideRule& isInside) {
  return Cells(points, triangles, facets).run(isInside);
}

}  // namespace remesher
