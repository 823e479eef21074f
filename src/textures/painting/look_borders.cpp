// SPDX-License-Identifier: MIT
#include "textures/painting/look_borders.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// The least jump that is a border, in levels of a map from 0 to 1: filters may mix smaller ones.
constexpr double kLeastJump = 0.1;
// In texels: the precision with which a jump is located, and its largest distance from the edge.
constexpr double kNarrow = 1.0 / 64, kAt = 0.5;
// The least height of a triangle above its edge, in new texels: in a lower one every texel touches
// the edge.
constexpr double kLowest = 1.5;
// Places along an edge.
constexpr std::array<double, 3> kPlaces = {0.2, 0.5, 0.8};

// The visible values at a place, in levels about as bytes have them.
using Shown = Eigen::Array<float, 8, 1>;
using Looks = std::array<Shown, kPlaces.size()>;

Shown shownBy(const Look& look) {
  Eigen::Array<double, 8, 1> result;
  result << look.baseColor.head<3>().array().max(0).sqrt(), look.emissive.array().max(0).sqrt(),
      look.surface.tail<2>();
  return result.cast<float>();
}

double apart(const Shown& a, const Shown& b) { return double((a - b).abs().maxCoeff()); }

class Borders {
 public:
  Borders(const NewSurface& surface, const PaintSource& source, double texel)
      : surface_(surface),
        source_(source),
        texel_(texel),
        finders_{SideFinder(source), SideFinder(source)} {}

  std::vector<char> run() {
    const Index count = Index(surface_.mesh().indices.size());
    std::vector<Index> corners;
    for (Index h = 0; h < count; ++h) {
      corners.push_back(surface_.welded(h));
      near_.push_back(isHigh(h) ? shownAlong(h, 1) : Looks());
    }
    std::vector<char> result(count, 0);
    const EdgeGroups edges(surface_.positions().size(), corners);
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].size() == 2)
        result[edges[e][0]] = result[edges[e][1]] = isBorder(edges[e][0], edges[e][1]);
    return result;
  }

 private:
  double length(Index h) const {
    return (surface_.position(nextCorner(h)) - surface_.position(h)).norm();
  }

  double twiceArea(Index h) const {
    const auto& [a, b, c] = surface_.onSource(h / 3).corners;
    return areaVector(a, b, c).norm();
  }

  bool isHigh(Index h) const { return twiceArea(h) > kLowest * texel_ * length(h); }

  bool isBorder(Index a, Index b) {
    if (areOneQuad(surface_.kind(), a / 3, b / 3)) return false;
    if (!isHigh(a) || !isHigh(b)) return false;
    const auto parts = [&](Index i, Index j) { return surface_.normal(i) != surface_.normal(j); };
    return parts(a, nextCorner(b)) || parts(nextCorner(a), b) || jumps(a, b);
  }

  // The two corners' edges run in opposite directions.
  bool jumps(Index a, Index b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kPlaces.size(); ++i)
      count += jumpsAt({a, b, kPlaces[i]}, {near_[a][i], near_[b][kPlaces.size() - 1 - i]});
    return 2 * count > kPlaces.size();
  }

  struct Across {
    Index a, b;
    double along;
  };

  // Whether what is visible jumps at the edge: bisects between a place on either side for the jump.
  bool jumpsAt(const Across& where, std::array<Shown, 2> seen) {
    if (!(apart(seen[0], seen[1]) > kLeastJump)) return false;
    double low = -1, high = 1;
    while (high - low > kNarrow) {
      const double middle = (low + high) / 2;
      const Shown shown = middle < 0 ? shownAt(where.a, where.along, -middle)
                                     : shownAt(where.b, 1 - where.along, middle);
      const bool isBelow = apart(seen[0], shown) > apart(shown, seen[1]);
      (isBelow ? high : low) = middle;
      seen[isBelow ? 1 : 0] = shown;
    }
    return apart(seen[0], seen[1]) > kLeastJump && std::abs(low + high) / 2 < kAt;
  }

  Looks shownAlong(Index h, double texels) {
    Looks looks;
    for (std::size_t i = 0; i < looks.size(); ++i) looks[i] = shownAt(h, kPlaces[i], texels);
    return looks;
  }

  // A finder that has entered the triangle. Entering is slow, so the two triangles at an edge have
  // a finder each.
  SideFinder& finderFor(Index triangle) {
    latest_ = triangle == entered_[latest_] ? latest_ : 1 - latest_;
    if (triangle != entered_[latest_]) finders_[latest_].enter(surface_.onSource(triangle));
    entered_[latest_] = triangle;
    return finders_[latest_];
  }

  // The visible values at this many texels from a corner's edge.
  Shown shownAt(Index h, double along, double texels) {
    SideFinder& finder = finderFor(h / 3);
    const double in = texels * texel_ * length(h) / twiceArea(h);
    const Vec3 weights((1 - in) * (1 - along), (1 - in) * along, in);
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) {
      point += weights[k] * surface_.position(h);
      normal += weights[k] * surface_.facing(h);
      h = nextCorner(h);
    }
    const InputPlace place = finder.find(point, normal.normalized());
    return shownBy(source_.at({&place, 1}));
  }

  const NewSurface& surface_;
  const PaintSource& source_;
  double texel_;
  std::array<SideFinder, 2> finders_;
  std::array<Index, 2> entered_ = {kNone, kNone};  // the triangle that each has entered
  std::size_t latest_ = 0;                         // the finder that was used last
  std::vector<Looks> near_;  // per corner: a texel beside the edge that begins there
};

}  // namespace

std::vector<char> lookBorders(const NewSurface& surface, const PaintSource& source, double texel) {
  return Borders(surface, source, texel).run();
}

}  // namespace remesher
