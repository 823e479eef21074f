// SPDX-License-Identifier: MIT
#include "arrangement/facets.h"

#include <algorithm>
#include <utility>

#include "arrangement/sheet_triangulation.h"
#include "arrangement/sheets.h"
#include "base/sort_pairs.h"

namespace remesher {

namespace {

// The facets of one sheet.
class SheetCut {
 public:
  SheetCut(PointPool& points, const ArrangedTriangles& triangles, const Sheet& sheet)
      : points_(points),
        triangles_(triangles),
        sheet_(sheet),
        cut_(points, triangles[sheet.triangles.front()]) {}

  // Everything in the order of positions, so that the numbers of the triangles do not matter. False
  // if it would take more than so many steps.
  bool run(std::size_t mostWork) {
    std::vector<Index> inserted = sheet_.points;
    std::vector<Segment> segments = sheet_.segments;
    for (const Index t : sheet_.triangles) {
      const GivenPlane v = triangles_[t];
      inserted.insert(inserted.end(), v.begin(), v.end());
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = v[k], b = v[(k + 1) % 3];
        segments.push_back({a, b, {{std::min(a, b), std::max(a, b), kNone}}});
      }
    }
    const auto isBefore = [this](Index p, Index q) { return points_.isBefore(p, q); };
    std::sort(inserted.begin(), inserted.end(), isBefore);
    for (const Index point : inserted) {
      if (cut_.work() > mostWork) return false;
      cut_.insert(point);
    }
    for (Segment& s : segments)
      if (isBefore(s.to, s.from)) std::swap(s.from, s.to);
    std::stable_sort(segments.begin(), segments.end(), [&](const Segment& a, const Segment& b) {
      return a.from != b.from ? isBefore(a.from, b.from) : isBefore(a.to, b.to);
    });
    for (const Segment& segment : segments) {
      if (cut_.work() > mostWork) return false;
      cut_.force(segment);
    }
    cut_.widenAngles();
    for (const Index t : sheet_.triangles) fill(t);
    return true;
  }

  // Appends the facets that lie in a triangle.
  void addTo(Facets& facets) const {
    for (Index f = 0; f < cut_.triangleCount(); ++f) {
      if (parents_.size() <= f || parents_[f].empty()) continue;
      std::array<Index, 3> corners = cut_.triangle(f);
      std::vector<FacetParent> parents = parents_[f];
      if (parents.front().sign < 0) {
        std::swap(corners[1], corners[2]);
        for (FacetParent& p : parents) p.sign = -p.sign;
      }
      // A triangle that is only touched keeps the order of its corners.
      const GivenPlane whole = triangles_[parents.front().triangle];
      if (std::is_permutation(whole.begin(), whole.end(), corners.begin())) corners = whole;
      facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
      facets.parents.insert(facets.parents.end(), parents.begin(), parents.end());
      facets.firstParents.push_back(static_cast<Index>(facets.parents.size()));
    }
  }

  std::size_t work() const { return cut_.work(); }

 private:
  // Facets lie within the triangle or outside it; those within hang together.
  void fill(Index t) {
    const GivenPlane v = triangles_[t];
    const int sign = points_.turn(v[0], v[1], v[2], cut_.view());
    parents_.resize(cut_.triangleCount());
    std::vector<Index> found;
    for (Index f = cut_.triangleAt(v[0]); found.empty();) {
      if (isWithin(f, v, sign)) found.push_back(f);
      const std::array<Index, 3> corners = cut_.triangle(f);
      const auto k =
          static_cast<Index>(std::find(corners.begin(), corners.end(), v[0]) - corners.begin());
      f = cut_.neighbor(f, (k + 2) % 3);
    }
    const auto mark = [&](Index f) { parents_[f].push_back({t, sign}); };
    mark(found.front());
    for (std::size_t i = 0; i < found.size(); ++i)
      for (Index k = 0; k < 3; ++k) {
        const Index g = cut_.neighbor(found[i], k);
        if (g == kNone || (!parents_[g].empty() && parents_[g].back().triangle == t)) continue;
        if (cut_.isSegment(found[i], k) && !isWithin(g, v, sign)) continue;
        mark(g);
        found.push_back(g);
      }
  }

  bool isWithin(Index f, const GivenPlane& t, int sign) const {
    for (const Index p : cut_.triangle(f))
      for (std::size_t k = 0; k < 3; ++k)
        if (sign * points_.turn(t[k], t[(k + 1) % 3], p, cut_.view()) < 0) return false;
    return true;
  }

  PointPool& points_;
  const ArrangedTriangles& triangles_;
  const Sheet& sheet_;
  SheetTriangulation cut_;
  std::vector<std::vector<FacetParent>> parents_;  // per triangle of the sheet, ascending
};

Facets inOrderOfParents(const Facets& facets, std::size_t triangles) {
  std::vector<Index> firsts;
  for (Index f = 0; f < facets.size(); ++f) firsts.push_back(facets.parent(f));
  const std::vector<Index> order = orderByKeys(firsts, triangles);
  Facets result;
  result.corners.reserve(facets.corners.size());
  result.parents.reserve(facets.parents.size());
  result.firstParents.reserve(facets.firstParents.size());
  result.isCut = facets.isCut;
  result.cutTriangles = facets.cutTriangles, result.work = facets.work;
  for (const Index f : order) {
    const auto corners = facets.corners.begin() + std::ptrdiff_t{3} * f;
    result.corners.insert(result.corners.end(), corners, corners + 3);
    const std::span<const FacetParent> parents = facets.parentsOf(f);
    result.parents.insert(result.parents.end(), parents.begin(), parents.end());
    result.firstParents.push_back(static_cast<Index>(result.parents.size()));
  }
  return result;
}

}  // namespace

std::optional<Facets> cutTriangles(PointPool& points, const ArrangedTriangles& triangles,
                                   std::size_t mostWork) {
  const std::optional<FoundSheets> sheets = findSheets(points, triangles, mostWork);
  if (!sheets) return std::nullopt;
  Facets result;
  result.work = sheets->work;
  result.isCut.assign(triangles.size(), 0);
  for (const Sheet& sheet : sheets->all) {
    SheetCut cut(points, triangles, sheet);
    if (!cut.run(mostWork - result.work)) return std::nullopt;
    cut.addTo(result);
    result.work += cut.work();
    if (result.work > mostWork) return std::nullopt;
    for (const Index t : sheet.triangles) result.isCut[t] = 1;
    result.cutTriangles += sheet.triangles.size();
  }
  for (Index t = 0; t < triangles.size(); ++t) {
    if (result.isCut[t]) continue;
    for (const Index corner : triangles[t]) result.corners.push_back(corner);
    result.parents.push_back({t, 1});
    result.firstParents.push_back(static_cast<Index>(result.parents.size()));
  }
  return inOrderOfParents(result, triangles.size());
}

}  // namespace remesher
