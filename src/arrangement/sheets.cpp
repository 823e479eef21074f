// SPDX-License-Identifier: MIT
#include "arrangement/sheets.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/triangle_meeting.h"

namespace remesher {

namespace {

using Pair = std::pair<Index, Index>;
using Sides = std::array<int, 3>;

struct Meeting {
  Pair triangles;
  std::array<Index, 2> ends;  // the same point twice where they touch in a point
};

class SheetSearch {
 public:
  SheetSearch(PointPool& points, const ArrangedTriangles& triangles)
      : points_(points), triangles_(triangles), planes_(triangles.size()) {}

  std::optional<FoundSheets> run(std::size_t mostWork) {
    const std::vector<Pair> pairs = meetingPairs(mostWork);
    if (work_ > mostWork) return std::nullopt;
    for (const auto& [s, t] : pairs) {
      for (const Index triangle : {s, t})
        for (const Index corner : triangles_[triangle]) points_.enter(corner);
    }
    for (const auto& [s, t] : pairs) {
      if (meet(s, t); ++work_ > mostWork) return std::nullopt;
    }
    return collect(pairs);
  }

 private:
  NamedTriangle named(Index t) const {
    const GivenPlane v = triangles_[t];
    return {v, {points_.position(v[0]), points_.position(v[1]), points_.position(v[2])}};
  }

  std::vector<Pair> meetingPairs(std::size_t mostWork) {
    std::vector<Pair> pairs;
    const auto look = [&](Index s, Index t) {
      if (++work_ <= mostWork && trianglesMeet(named(s), named(t)))
        pairs.emplace_back(std::min(s, t), std::max(s, t));
    };
    const auto& [meeting, isEachSound] = triangles_.known;
    if (!meeting)
      triangles_.tree().visitPairs(look);
    else if (isEachSound)
      visitPairsOfOperands(*meeting, look);
    else
      visitPairs(*meeting, look);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  std::vector<Index> cornersOf(std::span<const Index> list) const {
    std::vector<Index> corners;
    for (const Index t : list)
      for (const Index corner : triangles_[t]) corners.push_back(corner);
    return corners;
  }

  // The pairs of triangles in the list whose boxes meet.
  template <class Look>
  void visitPairs(std::span<const Index> list, Look look) const {
    const std::vector<Index> corners = cornersOf(list);
    const TriangleTree tree(points_.positions(), corners);
    tree.visitPairs([&](Index s, Index t) { look(list[s], list[t]); });
  }

  // Those of a triangle of the first operand and one of the second.
  template <class Look>
  void visitPairsOfOperands(std::span<const Index> list, Look look) const {
    const auto isFirst = [&](Index t) { return triangles_.operands[t] == 0; };
    const auto end = std::partition_point(list.begin(), list.end(), isFirst);
    const auto count = std::size_t(end - list.begin());
    const std::span<const Index> others = list.subspan(count);
    const std::vector<Index> corners = cornersOf(others);
    const TriangleTree tree(points_.positions(), corners);
    for (const Index s : list.first(count)) {
      Box box;
      for (const Index corner : triangles_[s]) box.extend(points_.position(corner));
      tree.visitOverlapping(box, [&](Index t) { look(s, others[t]); });
    }
  }

  Sides sides(Index t, Index plane) const {
    const GivenPlane corners = triangles_[t], other = triangles_[plane];
    return {points_.above(other, corners[0]), points_.above(other, corners[1]),
            points_.above(other, corners[2])};
  }

  void meet(Index s, Index t) {
    const Sides ofS = sides(s, t), ofT = sides(t, s);
    if (ofT == Sides{0, 0, 0}) {
      planes_.unite(s, t);
      return;
    }
    std::vector<Index> found;
    addEnds(s, t, ofS, found);
    addEnds(t, s, ofT, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    if (!found.empty()) meetings_.push_back({{s, t}, {found.front(), found.back()}});
  }

  // The ends of the line along which s cuts the plane of t, those within t.
  void addEnds(Index s, Index t, const Sides& sides, std::vector<Index>& found) {
    const GivenPlane corners = triangles_[s], other = triangles_[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (sides[k] == 0 && contains(other, corners[k])) found.push_back(corners[k]);
      if (sides[k] * sides[next] >= 0) continue;
      if (passesThrough({corners[k], corners[next]}, other))
        found.push_back(meetOnce({corners[k], corners[next]}, t));
    }
  }

  // The two triangles at an edge have the same point.
  Index meetOnce(GivenLine line, Index t) {
    if (line[0] > line[1]) std::swap(line[0], line[1]);
    const auto [known, isNew] = met_.try_emplace({line[0], line[1], t}, kNone);
    if (isNew) known->second = points_.meet(line, triangles_[t]);
    return known->second;
  }

  bool contains(const GivenPlane& t, Index point) const {
    const FlatView view = points_.viewOf(t);
    const int a = points_.turn(t[0], t[1], point, view), b = points_.turn(t[1], t[2], point, view),
              c = points_.turn(t[2], t[0], point, view);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  }

  bool passesThrough(const GivenLine& line, const GivenPlane& t) const {
    const auto side = [&](Index p, Index q) { return points_.above({line[0], line[1], p}, q); };
    const int a = side(t[0], t[1]), b = side(t[1], t[2]), c = side(t[2], t[0]);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  }

  FoundSheets collect(const std::vector<Pair>& pairs) {
    FoundSheets result;
    std::vector<Index> sheetOf(triangles_.size(), kNone);
    std::vector<Index> touched;
    for (const auto& [s, t] : pairs) touched.insert(touched.end(), {s, t});
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const Index t : touched) {
      Index& sheet = sheetOf[planes_.find(t)];
      if (sheet == kNone) {
        sheet = static_cast<Index>(result.all.size());
        result.all.emplace_back();
      }
      result.all[sheet].triangles.push_back(t);
    }
    const auto add = [&](Index t, Index other, const std::array<Index, 2>& ends) {
      Sheet& sheet = result.all[sheetOf[planes_.find(t)]];
      sheet.points.insert(sheet.points.end(), ends.begin(), ends.end());
      if (ends[0] == ends[1]) return;
      const Index plane = planes_.find(other);  // one for all that are in it
      sheet.segments.push_back({ends[0], ends[1], {triangles_[plane]}});
    };
    for (const Meeting& m : meetings_) {
      add(m.triangles.first, m.triangles.second, m.ends);
      add(m.triangles.second, m.triangles.first, m.ends);
    }
    result.work = work_;
    return result;
  }

  PointPool& points_;
  const ArrangedTriangles& triangles_;
  DisjointSets planes_;
  std::map<std::array<Index, 3>, Index> met_;  // the points of edges in triangles
  std::vector<Meeting> meetings_;
  std::size_t work_ = 0;
};

}  // namespace

std::optional<FoundSheets> findSheets(PointPool& points, const ArrangedTriangles& triangles,
                                      std::size_t mostWork) {
  return SheetSearch(points, triangles).run(mostWork);
}

}  // namespace remesher
