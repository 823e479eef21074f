// SPDX-License-Identifier: MIT
#include "measure/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "geometry/distance_sampler.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "measure/distance_bound.h"
#include "measure/salient_vertices.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// How many points to spread by area per side: one per trianglesEach triangles, within limits. The
// rms of N points has a relative error of about 1/√N.
struct Spread {
  std::size_t trianglesEach, fewest, most;

  std::size_t points(std::size_t triangles) const {
    return std::clamp(triangles / trianglesEach, fewest, most);
  }
};
constexpr Spread kGlimpsed = {32, 2000, 10'000}, kSampled = {4, 5000, 50'000},
                 kProven = {1, 20'000, 200'000};
// Points are set denser in the kSearchedTriangles triangles with the largest distances found: a
// grid of kSearchGrid steps along an edge.
constexpr std::size_t kSearchedTriangles = 64;
constexpr int kSearchGrid = 6;
// The steps in which a border edge is looked at.
constexpr int kBorderSteps = 4;
// Distances below this share of the maximum found so far are not measured further if only the
// maximum counts.
constexpr double kFarBelow = 0.5, kBelow = 0.9;
// The maximum may be too small by this share of the diagonal.
constexpr double kTolerance = 1e-5;

struct Triangles {
  std::span<const Vec3> positions;
  std::span<const Index> indices;

  explicit Triangles(const TriangleMesh& mesh) : positions(mesh.positions), indices(mesh.indices) {}

  std::size_t size() const { return indices.size() / 3; }
  Triangle operator[](Index t) const {
    const Index* const v = &indices[std::size_t{3} * t];
    return {positions[v[0]], positions[v[1]], positions[v[2]]};
  }
};

bool isSame(const Triangle& t, const Triangle& other) {
  for (std::size_t k = 0; k < 3; ++k)
    if (t[0] == other[k] && t[1] == other[(k + 1) % 3] && t[2] == other[(k + 2) % 3]) return true;
  return false;
}

// A surface without copies of triangles: copies are equally near to a point, so no box would rule
// one out.
class Surface {
 public:
  explicit Surface(const TriangleMesh& mesh)
      : triangles(mesh), tree(triangles.positions, triangles.indices) {
    if (!hasCopies()) return;
    triangles.indices = distinct_;
    tree = TriangleTree(triangles.positions, triangles.indices);
  }
  Surface(const TriangleMesh& mesh, ListedTree known)
      : triangles(mesh), tree(std::move(known.tree)), distinct_(std::move(known.indices)) {
    triangles.indices = distinct_;
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  Triangles triangles;
  TriangleTree tree;

 private:
  // Looks for copies near each other in the tree's order, where they are if they are many. Lists
  // the distinct triangles.
  bool hasCopies() {
    constexpr std::size_t kClose = 4;
    const std::span<const Index> order = tree.order();
    std::vector<char> isCopy(order.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = i - std::min(i, kClose); k < i; ++k)
        if (tree.haveSameBox(i, k) && isSame(triangles[order[i]], triangles[order[k]]))
          isCopy[order[i]] = 1;
    if (std::find(isCopy.begin(), isCopy.end(), 1) == isCopy.end()) return false;
    for (std::size_t i = 0; i < triangles.indices.size(); ++i)
      if (isCopy[i / 3] == 0) distinct_.push_back(triangles.indices[i]);
    return true;
  }

  std::vector<Index> distinct_;
};

double areaOf(const Triangle& t) { return area(t[0], t[1], t[2]); }

double pointsPerArea(const Triangles& triangles, const Spread& spread) {
  double total = 0;
  for (Index t = 0; t < triangles.size(); ++t) total += areaOf(triangles[t]);
  return total > 0 ? static_cast<double>(spread.points(triangles.size())) / total : 0;
}

Vec3 at(const Vec3& barycentric, const Triangle& t) {
  return barycentric[0] * t[0] + barycentric[1] * t[1] + barycentric[2] * t[2];
}

// One direction. Visits `from` in its tree's order, so that the answer for one point is a good
// start for the next point.
class Measurement {
 public:
  Measurement(const Surface& from, const Surface& to, double diagonal)
      : from_(from),
        to_(to),
        sampler_(to.tree),
        atVertices_(from.triangles.positions.size(), kUnknown),
        starts_(from.triangles.size(), 0),
        largest_(from.triangles.size(), 0),
        diagonal_(diagonal),
        isBorder_(bordersOf(from.triangles)) {}

  Deviation run(Maximum maximum) {
    sample(maximum);
    search();
    double squaredMaximum = sampler_.squaredFarthest();
    if (maximum == Maximum::Proven)
      squaredMaximum = provenSquaredMaximum({from_.tree, to_.tree, starts_, kTolerance * diagonal_},
                                            squaredMaximum);
    return {std::sqrt(squaredMaximum), sampler_.rms()};
  }

 private:
  // Per corner whether no other triangle shares the edge from it.
  static std::vector<char> bordersOf(const Triangles& triangles) {
    std::vector<char> isBorder(triangles.indices.size(), 0);
    const EdgeGroups edges(triangles.positions.size(), triangles.indices);
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].size() == 1) isBorder[edges[e][0]] = 1;
    return isBorder;
  }

  // The largest squared distance at a few points of a border edge. An edge that cuts a bend of the
  // other border is farthest away there, where points spread by area seldom come.
  double alongBorder(const Vec3& a, const Vec3& b) {
    double largest = 0;
    for (int i = 1; i < kBorderSteps; ++i)
      largest = std::max(largest, lookBeyond(kFarBelow, a + (b - a) * i / kBorderSteps));
    return largest;
  }

  // The squared distance of a point of which only the maximum counts: below share × maximum it may
  // come out too large, but stays below that.
  double lookBeyond(double share, const Vec3& p) {
    return sampler_.addBeyond(share * sampler_.farthest(), p);
  }

  void sample(Maximum maximum) {
    const double perArea =
        pointsPerArea(from_.triangles, maximum == Maximum::Sampled ? kSampled : kProven);
    for (const Index t : from_.tree.order()) {
      const Triangle corners = from_.tree.corners(t);
      double largest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        float& own = atVertices_[from_.triangles.indices[std::size_t{3} * t + k]];
        if (own == kUnknown) own = static_cast<float>(lookBeyond(kFarBelow, corners[k]));
        largest = std::max(largest, double{own});
        if (isBorder_[std::size_t{3} * t + k])
          largest = std::max(largest, alongBorder(corners[k], corners[(k + 1) % 3]));
      }
      for (due_ += areaOf(corners) * perArea; due_ >= 1; due_ -= 1)
        largest = std::max(largest, sampler_.add(at(evenPoint(++points_), corners)));
      largest_[t] = static_cast<float>(largest);
      starts_[t] = sampler_.near();
    }
  }

  // Between two points the distance changes by at most their separation, so the largest is likely
  // in a triangle where a large one was found. Searches a grid over each such triangle, then an
  // equally fine grid around the grid's largest distance.
  void search() {
    const double worthIt = kFarBelow * kFarBelow * sampler_.squaredFarthest();
    std::vector<Index> triangles;
    for (const Index t : from_.tree.order())
      if (largest_[t] >= worthIt) triangles.push_back(t);
    const std::size_t count = std::min(kSearchedTriangles, triangles.size());
    std::partial_sort(triangles.begin(), triangles.begin() + count, triangles.end(),
                      [this](Index s, Index t) {
                        return largest_[s] > largest_[t] || (largest_[s] == largest_[t] && s < t);
                      });
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle whole = from_.tree.corners(triangles[i]);
      const Vec3 best = searchGrid(whole);
      Triangle part;
      for (std::size_t k = 0; k < 3; ++k) part[k] = best + (whole[k] - best) / kSearchGrid;
      searchGrid(part);
    }
  }

  Vec3 searchGrid(const Triangle& t) {
    Vec3 best = t[0];
    double largest = 0;
    for (int i = 0; i <= kSearchGrid; ++i)
      for (int k = 0; i + k <= kSearchGrid; ++k) {
        const Vec3 p = at(Vec3(kSearchGrid - i - k, i, k) / kSearchGrid, t);
        const double squaredDistance = lookBeyond(kBelow, p);
        if (squaredDistance <= largest) continue;
        largest = squaredDistance;
        best = p;
      }
    return best;
  }

  const Surface& from_;
  const Surface& to_;
  DistanceSampler sampler_;
  static constexpr float kUnknown = -1;
  std::vector<float> atVertices_;  // per vertex of `from`: the squared distance
  std::vector<Index> starts_;      // per triangle of `from`: a near one of `to`
  std::vector<float> largest_;     // per triangle of `from`: the largest squared distance sampled
  double diagonal_;
  const std::vector<char> isBorder_;
  std::size_t points_ = 0;  // spread by area so far
  double due_ = 0;          // samples owed to the area passed
};

// Measures from a few points, too far apart for one search of the surroundings to serve several,
// and from the most salient vertices, a quarter as many: the largest distance is mostly at one of
// them. The surface `from` needs no tree.
Deviation glimpse(const Triangles& from, const TriangleTree& to) {
  const double perArea = pointsPerArea(from, kGlimpsed);
  std::size_t points = 0;
  DistanceSampler sampler(to);
  double due = 0;
  for (Index t = 0; t < from.size(); ++t) {
    const Triangle corners = from[t];
    for (due += areaOf(corners) * perArea; due >= 1; due -= 1)
      sampler.add(at(evenPoint(++points), corners));
  }
  const std::size_t most = kGlimpsed.points(from.size()) / 4;
  for (const Index v : salientVertices(from.positions, from.indices, most))
    sampler.addBeyond(kBelow * sampler.farthest(), from.positions[v]);
  return {sampler.farthest(), sampler.rms()};
}

double diagonalOf(const Box& box) { return (box.high - box.low).norm(); }

double diagonalOf(const TriangleMesh& mesh) {
  Box box;
  for (const Index v : mesh.indices) box.extend(mesh.positions[v]);
  return diagonalOf(box);
}

}  // namespace

DeviationBothWays measureDeviation(const TriangleMesh& original, const TriangleMesh& result,
                                   Maximum maximum, std::optional<ListedTree> tree) {
  if (maximum == Maximum::Glimpsed)
    return {glimpse(Triangles(original), TriangleTree(result.positions, result.indices)),
            {},
            diagonalOf(original)};
  const Surface first = tree ? Surface(original, *std::move(tree)) : Surface(original);
  const Surface second(result);
  const double diagonal = diagonalOf(first.tree.box());
  return {Measurement(first, second, diagonal).run(maximum),
          Measurement(second, first, diagonal).run(maximum), diagonal};
}

FidelityReport measureFidelity(const TriangleMesh& original, const TriangleMesh& result,
                               Maximum maximum, std::optional<ListedTree> tree) {
  const DeviationBothWays d = measureDeviation(original, result, maximum, std::move(tree));
  if (d.diagonal == 0) return {};
  return {100 * d.maximum() / d.diagonal,
          100 * std::max(d.toResult.rms, d.toOriginal.rms) / d.diagonal};
}

}  // namespace remesher
