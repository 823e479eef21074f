// SPDX-License-Identifier: MIT
#include "original/surface/accurate_sizes.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/components.h"
#include "original/surface/curvature.h"

namespace remesher {

namespace {

// The common distance is searched between this share of the even length and the even length itself,
// by this many bisections of the ratio.
constexpr double kLeastError = 1e-4;
constexpr int kHalvings = 10;

// Longest edge along a strip, in units of the strip's width: longer edges make needles across it.
constexpr double kLongestAcross = 2.5;
// Longest edge around a circle, in units of its radius: eight edges, since some come out a third
// longer.
constexpr double kLongestAround = 0.75;

// Per face the width of the region between curves that holds the face: twice the region's area over
// the length of its border.
FaceData<double> widthsBetweenCurves(const OriginalSurface& surface) {
  const HalfedgeMesh& mesh = surface.mesh();
  const VertexData<Vec3>& p = surface.positions();
  const FaceRegions regions =
      regionsOf(mesh, [&](Halfedge h) { return !surface.curves().isCurve(h); });
  std::vector<double> areas(regions.count, 0), rims(regions.count, 0);
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = mesh.vertices(Face(i));
    areas[regions.of[Face(i)]] += area(p[a], p[b], p[c]);
  }
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (surface.curves().isCurve(h))
      rims[regions.of[mesh.face(h)]] += distance(p[mesh.origin(h)], p[mesh.tip(h)]);
  }
  FaceData<double> widths(mesh.faceCapacity());
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const Index region = regions.of[Face(i)];
    widths[Face(i)] = rims[region] > 0 ? 2 * areas[region] / rims[region] : kInfinity;
  }
  return widths;
}

class Accuracy {
 public:
  Accuracy(const OriginalSurface& surface, const RefinedFaces& faces, const AccuracyRules& rules)
      : faces_(faces),
        rules_(rules),
        bends_(faces.positions().size(), 0),
        widths_(faces.leastAround(widthsBetweenCurves(surface))) {
    const VertexData<double> own = sharpestBends(surface);
    for (Index i = 0; i < own.size(); ++i) bends_[Vertex(i)] = own[Vertex(i)];
    // A middle on a strip that is curved lengthwise bends like the ends of its edge; inside a plane
    // not at all.
    Vertex middle(Index(own.size()));
    for (const RefinedFaces::Middle& at : faces.middles()) {
      if (!at.isInFlat) bends_[middle] = 0.5 * (bends_[at.ends[0]] + bends_[at.ends[1]]);
      ++middle.index;
    }
  }

  // Finds the distance that takes as many vertices as wanted, or uses the requested error if that
  // is smaller.
  VertexData<double> run() const {
    const double wanted = countOf(VertexData<double>(bends_.size(), rules_.mean));
    double low = kLeastError * rules_.mean, high = rules_.mean;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = std::sqrt(low * high);
      (countOf(sizesFor(middle)) > wanted ? low : high) = middle;
    }
    if (rules_.error > 0 && rules_.error < high) return sizesFor(rules_.error);
    VertexData<double> sizes = sizesFor(high);
    const double scale = std::sqrt(countOf(sizes) / wanted);
    for (double& size : sizes.values()) size *= scale;
    return sizes;
  }

 private:
  // A chord of length h leaves a circle of radius r by e = r - √(r² - h²/4). A circle that is small
  // against e keeps kLongestAround, so that it remains a circle.
  static double chordFor(double radius, double error) {
    const double most = kLongestAround * radius;
    return error < radius ? std::min(most, 2 * std::sqrt(error * (2 * radius - error))) : most;
  }

  VertexData<double> sizesFor(double error) const {
    const double strength = rules_.adaptivity * (1.25 - rules_.adaptivity / 2);
    // Rims and rods may be as many times finer again as what is merely curved.
    const double smallest = rules_.mean * std::pow(kFinest * kFinest, strength);
    const double largest = rules_.mean * std::pow(kCoarsest, strength);
    VertexData<double> sizes(bends_.size());
    for (Index i = 0; i < sizes.size(); ++i) {
      const double bend = bends_[Vertex(i)];
      const double chord = bend > 0 ? chordFor(1 / bend, error) : largest;
      const double most = std::min(chord, kLongestAcross * widths_[Vertex(i)]);
      sizes[Vertex(i)] = std::clamp(most, smallest, largest);
    }
    limitSlopes(sizes);
    return sizes;
  }

  void limitSlopes(VertexData<double>& sizes) const {
    const VertexData<Vec3>& p = faces_.positions();
    for (bool isLimited = true; isLimited;) {
      isLimited = false;
      for (const auto& [a, b] : faces_.edges()) {
        const Vertex small = sizes[a] < sizes[b] ? a : b, large = small == a ? b : a;
        if (sizes[large] - sizes[small] <= 0) continue;
        const double limit = sizes[small] + rules_.slope * (p[a] - p[b]).norm();
        if (sizes[large] <= limit * (1 + 1e-9)) continue;
        sizes[large] = limit;
        isLimited = true;
      }
    }
  }

  // Proportional to the number of vertices of a mesh of these sizes.
  double countOf(const VertexData<double>& sizes) const {
    double count = 0;
    for (Index i = 0; i < sizes.size(); ++i)
      count += faces_.areas()[Vertex(i)] / (sizes[Vertex(i)] * sizes[Vertex(i)]);
    return count;
  }

  const RefinedFaces& faces_;
  const AccuracyRules& rules_;
  VertexData<double> bends_;
  VertexData<double> widths_;  // of the narrowest region at each place
};

}  // namespace

VertexData<double> accurateSizes(const OriginalSurface& surface, const RefinedFaces& faces,
                                 const AccuracyRules& rules) {
  return Accuracy(surface, faces, rules).run();
}

}  // namespace remesher
