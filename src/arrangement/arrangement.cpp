// SPDX-License-Identifier: MIT
#include "arrangement/arrangement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "arrangement/facets.h"
#include "arrangement/merge.h"
#include "arrangement/parted_fans.h"
#include "arrangement/points.h"
#include "arrangement/rounding.h"
#include "arrangement/snapping.h"
#include "base/fires.h"
#include "base/place.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

using Outcome = ArrangementResult::Outcome;

// Rounding may make triangles meet anew, which another arrangement parts. So many may follow each
// other without a gain: all but the first after parts that nearly lie on each other were brought
// together, twice as far in each.
constexpr int kPatience = 4;

// In steps of written coordinates: thinner facets have the shape that rounding gave.
constexpr double kThin = 8;

// Points are brought together within so much of the usual edge, else whole triangles would be.
constexpr double kMostSnapped = 0.25;

bool isClosed(const ArrangementInput& input) {
  const EdgeGroups edges(input.positions.size(), input.indices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> around = edges[e];
    for (const Index h : around) {
      int sum = 0;
      for (const Index g : around)
        if (input.operands[g / 3] == input.operands[h / 3])
          sum += input.indices[g] == input.indices[h] ? 1 : -1;
      if (sum != 0) return false;
    }
  }
  return true;
}

// The power of two that brings all coordinates to at most 1.
double normalScale(std::span<const Vec3> positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, -exponent);
}

class Run {
 public:
  Run(const ArrangementInput& input, const ArrangementOptions& options)
      : input_(input),
        options_(options),
        toNormal_(normalScale(input.positions)),
        normal_(scaled(input.positions, toNormal_)),
        points_(normal_),
        triangles_{input.indices, input.operands,
                   [this]() -> const TriangleTree& { return tree(); }, input.known} {}

  ArrangementResult run() {
    ArrangementResult result;
    const std::optional<Facets> facets = cutTriangles(points_, triangles_, options_.mostWork);
    if (!facets) {
      result.outcome = Outcome::GaveUp;
      return result;
    }
    InsideBoundary boundary = boundaryOfInside(points_, triangles_, *facets, options_.isInside);
    result.isOutsideDropped = boundary.isOutsideDropped;
    result.work = facets->work + boundary.work;
    KeptFacets kept =
        mergedFacets(points_, triangles_, input_.classes, *facets, std::move(boundary));
    result.cut = facets->cutTriangles;
    roundTo(result, kept, facets->isCut);
    return result;
  }

 private:
  static std::vector<Vec3> scaled(std::vector<Vec3> positions, double by) {
    for (Vec3& p : positions) p *= by;
    return positions;
  }

  const TriangleTree& tree() {
    if (!tree_) tree_.emplace(normal_, input_.indices);
    return *tree_;
  }

  // The new points that are used follow the given ones.
  void roundTo(ArrangementResult& result, KeptFacets& kept, std::span<const std::uint8_t> isCut) {
    result.positions = input_.positions;
    const std::size_t given = input_.positions.size();
    std::vector<Index> numbers(points_.size(), kNone), pointOf;
    for (Index& corner : kept.corners) {
      if (corner < given) continue;
      if (numbers[corner] == kNone) {
        numbers[corner] = static_cast<Index>(result.positions.size());
        result.positions.push_back(rounded(points_.position(corner)));
        pointOf.push_back(corner);
      }
      corner = numbers[corner];
    }
    mendRounded(result.positions, given, kept);
    result.indices = std::move(kept.corners);
    std::vector<std::uint8_t> isUsed(triangles_.size(), 0);
    result.triangles.reserve(kept.from.size());
    for (Index f = 0; f < kept.from.size(); ++f) {
      const FacetParent& from = kept.from[f];
      isUsed[from.triangle] = 1;
      ArrangedTriangle triangle{from.triangle, from.sign < 0, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        const Index corner = result.indices[std::size_t{3} * f + k];
        triangle.weights[k] =
            weights(from.triangle, corner < given ? corner : pointOf[corner - given]);
      }
      const auto corners = result.indices.begin() + std::ptrdiff_t{3} * f;
      triangle.isUntouched = !isCut[from.triangle] &&
                             std::equal(corners, corners + 3,
                                        input_.indices.begin() + std::ptrdiff_t{3} * from.triangle);
      result.triangles.push_back(triangle);
    }
    result.dropped =
        static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), std::uint8_t{0}));
  }

  Vec3 rounded(const Vec3& normal) const {
    const Vec3 p = canonicalPlace(normal / toNormal_);
    return options_.isSingle ? inSingle(p, options_.frame) : p;
  }

  Vec3 weights(Index triangle, Index point) const {
    const GivenPlane corners = triangles_[triangle];
    for (Eigen::Index k = 0; k < 3; ++k)
      if (corners[std::size_t(k)] == point) return Vec3::Unit(k);
    if (!options_.wantsWeights) return Vec3::Zero();
    return points_.barycentric(corners, point);
  }

  const ArrangementInput& input_;
  const ArrangementOptions& options_;
  const double toNormal_;
  const std::vector<Vec3> normal_;
  std::optional<TriangleTree> tree_;
  PointPool points_;
  const ArrangedTriangles triangles_;
};

// isApart: per triangle; those do not meet each other.
std::vector<Index> crossingsOf(const ArrangementResult& result,
                               std::span<const std::uint8_t> isApart) {
  TriangleMesh mesh;
  const double toNormal = normalScale(result.positions);
  for (const Vec3& p : result.positions) mesh.positions.emplace_back(toNormal * p);
  mesh.indices = result.indices;
  return selfIntersectionsBeside(mesh, isApart);
}

std::vector<Index> crossingsOf(const ArrangementResult& result) {
  std::vector<std::uint8_t> isUntouched;
  for (const ArrangedTriangle& t : result.triangles) isUntouched.push_back(t.isUntouched);
  return crossingsOf(result, isUntouched);
}

// Whether more triangles intersect others than were cut: where many edges pass each other at
// nearly one point, as on the axis of a ring that reaches beyond it, thousands of facets are
// smaller than a step. Another arrangement would only make more of them.
bool isDense(const ArrangementResult& result) {
  return result.selfIntersections.size() > result.cut;
}

// The step of written coordinates.
double stepOf(std::span<const Vec3> positions, const ArrangementOptions& options) {
  double largest = 0;
  for (const Vec3& p : positions)
    largest =
        std::max(largest, (options.isSingle ? options.frame.written(p) : p).cwiseAbs().maxCoeff());
  return options.isSingle ? largest * 0x1p-23 * options.frame.scale() : largest * 0x1p-52;
}

// How near to each other points may be brought together. Far from the origin steps of single
// precision may be as long as edges.
double mostTolerance(const ArrangementInput& input) {
  std::vector<double> lengths;
  lengths.reserve(input.indices.size());
  for (std::size_t i = 0; i < input.indices.size(); ++i) {
    const Index next = input.indices[i % 3 == 2 ? i - 2 : i + 1];
    lengths.push_back((input.positions[next] - input.positions[input.indices[i]]).norm());
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return kMostSnapped * *middle;
}

// The weights at the first's parent of a point in one of the first's triangles.
Vec3 weightsIn(const ArrangementResult& first, Index triangle, const Vec3& p) {
  const ArrangedTriangle& t = first.triangles[triangle];
  const auto at = [&](std::size_t k) {
    return first.positions[first.indices[3 * std::size_t{triangle} + k]];
  };
  const Vec3 own = closestBarycentric(p, at(0), at(1), at(2));
  return own[0] * t.weights[0] + own[1] * t.weights[1] + own[2] * t.weights[2];
}

// The new facets that are so thin: rounding made their shapes.
std::vector<Index> thinFacets(const ArrangementResult& result, double height) {
  std::vector<Index> found;
  for (Index f = 0; f < result.triangles.size(); ++f) {
    if (result.triangles[f].isUntouched) continue;
    const auto at = [&](std::size_t k) {
      return result.positions[result.indices[3 * std::size_t{f} + k % 3]];
    };
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (at(k + 1) - at(k)).norm());
    if (2 * area(at(0), at(1), at(2)) <= height * longest) found.push_back(f);
  }
  return found;
}

std::function<Vec3(const Vec3&)> roundingOf(const ArrangementOptions& options) {
  return [&options](const Vec3& p) {
    const Vec3 place = canonicalPlace(p);
    return options.isSingle ? inSingle(place, options.frame) : place;
  };
}

struct Snapped {
  ArrangementResult result;
  std::vector<std::uint8_t> isSame;  // per triangle whether it is as it was
};

// The result with parts brought together that are so near to each other, around those facets; none
// if that would take too much work.
std::optional<Snapped> snapped(const ArrangementResult& first, std::span<const Index> around,
                               const ArrangementOptions& options, double tolerance) {
  Snapped snap;
  ArrangementResult& result = snap.result;
  result.positions = first.positions;
  KeptFacets facets{first.indices, {}};
  facets.from.reserve(first.triangles.size());
  for (Index t = 0; t < first.triangles.size(); ++t) facets.from.push_back({t, 1});
  if (!snapTogether(result.positions, facets, around,
                    {tolerance, roundingOf(options), options.mostWork})) {
    fires("arrangement: bringing parts together takes too much work");
    return std::nullopt;
  }
  mendRounded(result.positions, 0, facets);
  result.indices = std::move(facets.corners);
  result.triangles.reserve(facets.from.size());
  for (std::size_t f = 0; f < facets.from.size(); ++f) {
    const Index from = facets.from[f].triangle;
    ArrangedTriangle triangle = first.triangles[from];
    const auto own = std::span(first.indices).subspan(3 * std::size_t{from}, 3);
    const bool isSame =
        std::equal(own.begin(), own.end(), result.indices.begin() + std::ptrdiff_t(3 * f));
    snap.isSame.push_back(isSame);
    triangle.isUntouched = triangle.isUntouched && isSame;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index corner = result.indices[3 * f + k];
      const auto same = std::find(own.begin(), own.end(), corner);
      triangle.weights[k] = same != own.end()
                                ? first.triangles[from].weights[std::size_t(same - own.begin())]
                                : weightsIn(first, from, result.positions[corner]);
    }
    result.triangles.push_back(triangle);
  }
  result.cut = first.cut, result.work = first.work, result.dropped = first.dropped;
  result.isOutsideDropped = first.isOutsideDropped;
  return snap;
}

// Bodies that overlap by a rounding, as balls that touch do, get a ring of facets around the common
// point; edges that pass each other so nearly get needles between them. Their corners become the
// same points, and divide the same edges, where this makes nothing intersect.
void dropThinFacets(ArrangementResult& result, const ArrangementOptions& options, double height) {
  const std::vector<Index> around = thinFacets(result, height);
  if (around.empty()) return;
  std::optional<Snapped> snap = snapped(result, around, options, 2 * height);  // a ring's width
  if (!snap) return;
  auto& [other, isSame] = *snap;
  other.selfIntersections =
      result.selfIntersections.empty() ? crossingsOf(other, isSame) : crossingsOf(other);
  if (other.selfIntersections.size() > result.selfIntersections.size()) return;
  fires("arrangement: facets of a few roundings dropped");
  result = std::move(other);
}

// The rounded result is arranged like any closed surface; its parents are those of the first.
ArrangementResult arrangedAgain(const ArrangementInput& input, const ArrangementOptions& options,
                                const ArrangementResult& first) {
  ArrangementInput again{
      first.positions, first.indices, std::vector<Index>(first.triangles.size(), 0), {}, {}};
  for (const ArrangedTriangle& t : first.triangles)
    if (!input.classes.empty()) again.classes.push_back(input.classes[t.parent]);
  ArrangementOptions plain = options;
  plain.isInside = isWound;
  ArrangementResult result = Run(again, plain).run();
  std::vector<std::uint8_t> isUsed(input.operands.size(), 0);
  for (ArrangedTriangle& t : result.triangles) {
    const ArrangedTriangle& parent = first.triangles[t.parent];
    for (Vec3& w : t.weights)
      w = Vec3(w[0] * parent.weights[0] + w[1] * parent.weights[1] + w[2] * parent.weights[2]);
    t.parent = parent.parent;
    t.isTurned = t.isTurned != parent.isTurned;
    isUsed[t.parent] = 1;
  }
  result.cut = first.cut;
  result.work += first.work;
  result.isOutsideDropped |= first.isOutsideDropped;
  result.dropped =
      static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), std::uint8_t{0}));
  return result;
}

}  // namespace

bool isWound(std::span<const int> windings) { return windings[0] > 0; }

ArrangementResult arrange(const ArrangementInput& input, const ArrangementOptions& options) {
  ArrangementResult best;
  best.positions = input.positions;
  if (input.indices.empty()) return best;
  if (!isClosed(input)) {
    best.outcome = Outcome::NotClosed;
    return best;
  }
  best = Run(input, options).run();
  if (best.outcome != Outcome::Done) return best;
  best.selfIntersections = crossingsOf(best);
  const double step = stepOf(input.positions, options);
  const double most = mostTolerance(input);
  if (2 * kThin * step <= most) dropThinFacets(best, options, kThin * step);
  ArrangementResult last = best;
  for (int left = kPatience; left > 0 && !best.selfIntersections.empty(); --left) {
    fires("arrangement: arranged again after rounding");
    const int doublings = isDense(best) ? 2 * kPatience - left : kPatience - left;
    if (const double tolerance = std::ldexp(step, doublings); doublings > 0) {
      if (tolerance > most) {
        fires("arrangement: steps of coordinates are as long as edges");
        break;
      }
      std::optional<Snapped> snap = snapped(best, best.selfIntersections, options, tolerance);
      if (!snap) break;
      last = std::move(snap->result);
    }
    ArrangementResult next = arrangedAgain(input, options, last);
    if (next.outcome != Outcome::Done || next.indices.empty()) break;
    last = std::move(next);
    last.selfIntersections = crossingsOf(last);
    if (last.selfIntersections.size() >= best.selfIntersections.size()) continue;
    best = last;
    left = kPatience;
  }
  partFans(best, input,
           {roundingOf(options), [](const ArrangementResult& r) { return crossingsOf(r); }});
  return best;
}

}  // namespace remesher
