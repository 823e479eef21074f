// SPDX-License-Identifier: MIT
#include "repair/solid/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/triangle_mesh.h"
#include "geometry/triangle.h"
#include "geometry/triangle_meeting.h"
#include "repair/solid/cell_loops.h"

namespace remesher {

namespace {

// A segment on a face of the lattice, with the apex that it is joined to.
struct Step {
  std::size_t face;  // 3 × the point at its lowest corner + the axis
  Index from, to, apex;
  bool isAlone;  // whether its loop is the only one of its cell
  std::array<Index, 3> onFace() const { return {std::min(from, to), std::max(from, to), apex}; }
  bool operator<(const Step& other) const {
    return face != other.face ? face < other.face : onFace() < other.onFace();
  }
};

class Contourer {
 public:
  Contourer(const Lattice& lattice, const InsideField& field, const SolidSource& source,
            std::span<const EdgeCrossing> crossings)
      : lattice_(lattice), field_(field), source_(source), crossings_(crossings) {
    placeEdges();
  }

  // Returns the cells whose loops cannot be kept apart. The contour is complete if there are none.
  std::vector<std::size_t> run() {
    std::vector<std::size_t> bad;
    lattice_.forEachPoint([&](std::size_t cell, const std::array<std::size_t, 3>& place) {
      const unsigned corners = cornersOf(cell, place);
      if (corners != 0 && corners != 255 && !addCell(cell, corners)) bad.push_back(cell);
    });
    if (bad.empty()) addTriangles();
    return bad;
  }

  Contour take() { return std::move(result_); }

 private:
  Vec3 rounded(const Vec3& p) const { return source_.isSingle ? inSingle(p, source_.frame) : p; }

  Index addPoint(const Vec3& p, Index source) {
    result_.points.push_back(rounded(p));
    result_.pointSources.push_back(source);
    isSharp_.push_back(0);
    return Index(result_.points.size() - 1);
  }

  Triangle triangleOf(Index source) const {
    const Index* c = &source_.corners[3 * std::size_t{source}];
    return {source_.positions[c[0]], source_.positions[c[1]], source_.positions[c[2]]};
  }

  // The crossing of the edge that is nearest to its outer end. Crossings that face that end come
  // before all others.
  const EdgeCrossing* crossingOf(std::size_t edge, bool isUp) const {
    const auto begin =
        std::lower_bound(crossings_.begin(), crossings_.end(), edge,
                         [](const EdgeCrossing& c, std::size_t wanted) { return c.edge < wanted; });
    const EdgeCrossing* best = nullptr;
    for (auto it = begin; it != crossings_.end() && it->edge == edge; ++it) {
      const bool isRight = (it->up > 0) == isUp;
      const bool wasRight = best && (best->up > 0) == isUp;
      if (!best || (isRight && !wasRight) || (isUp && isRight == wasRight)) best = &*it;
    }
    return best;
  }

  void placeEdges() {
    edgePoints_.assign(3 * lattice_.size(), kNone);
    lattice_.forEachPoint([&](std::size_t p, const std::array<std::size_t, 3>& place) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (place[axis] + 1 == lattice_.count(axis)) continue;
        const std::size_t q = p + lattice_.stride(axis);
        if (field_.isInside[p] != field_.isInside[q]) placeEdge(3 * p + axis, p, q);
      }
    });
  }

  // Places the edge's point at the crossing; without one, where the inside share passes 0.5. An end
  // that is inside only to keep a thin wall has no share: the point comes to that end.
  void placeEdge(std::size_t edge, std::size_t p, std::size_t q) {
    const double margin = lattice_.margin(0.01);  // of the edge's length
    const auto axis = Eigen::Index(edge % 3);
    Vec3 at = lattice_.position(p);
    const double low = at[axis], high = lattice_.position(q)[axis];
    const EdgeCrossing* crossing = crossingOf(edge, field_.isInside[p]);
    const double a = field_.shares[p] - 0.5, b = field_.shares[q] - 0.5;
    double share = (a > 0) != (b > 0) ? a / (a - b) : field_.isInside[p] ? 0 : 1;
    if (crossing) share = (crossing->at - low) / (high - low);
    at[axis] = low + std::clamp(share, margin, 1 - margin) * (high - low);
    edgePoints_[edge] = addPoint(at, crossing ? crossing->triangle : kNone);
  }

  // One bit per corner; 0 where no cell begins.
  unsigned cornersOf(std::size_t cell, const std::array<std::size_t, 3>& place) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (place[axis] + 1 == lattice_.count(axis)) return 0;
    unsigned corners = 0;
    for (unsigned c = 0; c < 8; ++c)
      if (field_.isInside[cornerOf(cell, c)]) corners |= 1u << c;
    return corners;
  }

  std::size_t cornerOf(std::size_t cell, unsigned c) const {
    return cell + (c & 1) * lattice_.stride(0) + (c >> 1 & 1) * lattice_.stride(1) +
           (c >> 2 & 1) * lattice_.stride(2);
  }

  std::vector<Index> pointsOf(std::size_t cell, const CellLoop& loop) const {
    std::vector<Index> points;
    for (const LoopStep& step : loop) {
      const CellEdge& edge = cellEdges()[step.edge];
      const std::size_t low = cornerOf(cell, unsigned(edge.corners[0]));
      points.push_back(edgePoints_[3 * low + edge.axis]);
    }
    return points;
  }

  std::vector<Plane> planesAt(const std::vector<Index>& points) const {
    std::vector<Plane> planes;
    for (const Index p : points) {
      const Index source = result_.pointSources[p];
      if (source == kNone) continue;
      const Triangle triangle = triangleOf(source);
      planes.push_back(
          {result_.points[p], unitNormal(triangle[0], triangle[1], triangle[2]), triangle, source});
    }
    return planes;
  }

  Vec3 middleOf(const std::vector<Index>& points) const {
    Vec3 sum = Vec3::Zero();
    for (const Index p : points) sum += result_.points[p];
    return sum / double(points.size());
  }

  // The box whose points stay within the cell when they are written.
  CellBox innerBox(std::size_t cell) const {
    const Vec3 low = lattice_.position(cell), high = lattice_.position(cornerOf(cell, 7));
    const Vec3 margin = lattice_.margin(0.02) * (high - low);  // of the cell's width
    return {low + margin, high - margin};
  }

  // Whether no triangle that joins a loop to its apex meets one of another loop.
  bool areApart(const std::vector<std::vector<Index>>& loops,
                const std::vector<Vec3>& apexes) const {
    std::vector<std::vector<NamedTriangle>> fans(loops.size());
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t i = 0; i < loops[l].size(); ++i) {
        const Index a = loops[l][i], b = loops[l][(i + 1) % loops[l].size()];
        const Index name = kNone - Index(l) - 1;
        fans[l].push_back({{a, b, name}, {result_.points[a], result_.points[b], apexes[l]}});
      }
    for (std::size_t l = 0; l < fans.size(); ++l)
      for (std::size_t m = 0; m < l; ++m)
        for (const NamedTriangle& s : fans[l])
          for (const NamedTriangle& t : fans[m])
            if (trianglesMeet(s, t)) return false;
    return true;
  }

  bool addCell(std::size_t cell, unsigned corners) {
    const std::vector<CellLoop> loops = cellLoops(corners);
    const CellBox box = innerBox(cell);
    std::vector<std::vector<Index>> points;
    std::vector<Apex> apexes;
    std::vector<Vec3> places, middles;
    for (const CellLoop& loop : loops) {
      points.push_back(pointsOf(cell, loop));
      const Vec3 middle = middleOf(points.back()).cwiseMax(box.low).cwiseMin(box.high);
      apexes.push_back(apexOf(planesAt(points.back()), middle, box, source_.ridges));
      places.push_back(rounded(apexes.back().at));
      middles.push_back(rounded(middle));
    }
    if (loops.size() > 1 && !areApart(points, places)) {
      places = middles;
      if (!areApart(points, places)) return false;
    }
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const Index apex = addPoint(places[l], apexes[l].source);
      isSharp_[apex] = apexes[l].isSharp;
      addSteps(cell, loops[l], points[l], {0, 0, 0, apex, loops.size() == 1});
    }
    return true;
  }

  void addSteps(std::size_t cell, const CellLoop& loop, const std::vector<Index>& points,
                Step step) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t axis = loop[i].face / 2;
      step.face = 3 * (cell + loop[i].face % 2 * lattice_.stride(axis)) + axis;
      step.from = points[i], step.to = points[(i + 1) % points.size()];
      steps_.push_back(step);
    }
  }

  // The point where the segment between two sharp apexes crosses the face; none if it misses the
  // face.
  std::optional<Vec3> sharpPlace(const Step& s, const Step& t) const {
    const double margin = lattice_.margin(0.02);  // of the face's width
    if (!s.isAlone || !t.isAlone || !isSharp_[s.apex] || !isSharp_[t.apex]) return std::nullopt;
    const auto axis = Eigen::Index(s.face % 3);
    const std::array<std::size_t, 3> place = lattice_.place(s.face / 3);
    const Vec3 low = lattice_.position(place);
    const Vec3 &a = result_.points[s.apex], &b = result_.points[t.apex];
    Vec3 at = a + (low[axis] - a[axis]) / (b[axis] - a[axis]) * (b - a);
    at[axis] = low[axis];
    for (Eigen::Index u = 0; u < 3; ++u)
      if (const double share = (at[u] - low[u]) / lattice_.width(std::size_t(u), place);
          u != axis && !(share > margin && share < 1 - margin))
        return std::nullopt;
    return at;
  }

  void addTriangle(Index a, Index b, Index c) {
    result_.corners.insert(result_.corners.end(), {a, b, c});
    Index source = result_.pointSources[a];
    for (const Index v : {b, c})
      if (source == kNone) source = result_.pointSources[v];
    result_.triangleSources.push_back(source);
  }

  // Both cells of a face have the same segments on it, so sorting puts equal ones in pairs.
  void addTriangles() {
    std::sort(steps_.begin(), steps_.end());
    for (std::size_t i = 0; i + 1 < steps_.size(); i += 2) {
      const Step &s = steps_[i], &t = steps_[i + 1];
      const bool isOnly = (i < 2 || steps_[i - 1].face != s.face) &&
                          (i + 2 >= steps_.size() || steps_[i + 2].face != s.face);
      const std::optional<Vec3> sharp = isOnly ? sharpPlace(s, t) : std::nullopt;
      const Index middle = sharp ? addPoint(*sharp, result_.pointSources[s.apex]) : kNone;
      for (const Step* step : {&s, &t}) {
        if (middle == kNone) {
          addTriangle(step->from, step->to, step->apex);
        } else {
          addTriangle(step->from, middle, step->apex);
          addTriangle(middle, step->to, step->apex);
        }
      }
    }
  }

  const Lattice& lattice_;
  const InsideField& field_;
  const SolidSource& source_;
  std::span<const EdgeCrossing> crossings_;  // ascending by edge
  std::vector<Index> edgePoints_;            // per edge of the lattice
  std::vector<char> isSharp_;                // per point
  std::vector<Step> steps_;
  Contour result_;
};

}  // namespace

Contour contourOf(const Lattice& lattice, InsideField& field, const SolidSource& source,
                  std::vector<EdgeCrossing> crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const EdgeCrossing& a, const EdgeCrossing& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    return a.at != b.at ? a.at < b.at : a.triangle < b.triangle;
  });
  for (;;) {  // ends, because filled points stay filled
    Contourer contourer(lattice, field, source, crossings);
    const std::vector<std::size_t> bad = contourer.run();
    if (bad.empty()) return contourer.take();
    for (const std::size_t cell : bad)
      for (unsigned c = 0; c < 8; ++c)
        field.isInside[cell + (c & 1) * lattice.stride(0) + (c >> 1 & 1) * lattice.stride(1) +
                       (c >> 2 & 1) * lattice.stride(2)] = 1;
  }
}

}  // namespace remesher
