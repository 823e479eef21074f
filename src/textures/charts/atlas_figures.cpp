// SPDX-License-Identifier: MIT
// Stretch: Sander, Snyder, Gortler, Hoppe: Texture Mapping Progressive Meshes, SIGGRAPH 2001.
#include "textures/charts/atlas_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/disjoint_sets.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Texels along a side for counting what is covered twice.
constexpr int kRaster = 1024;
// Triangles that should be less high than this in the square show nothing, and the roundings of
// single coordinates stretch them: it is sixteen of these.
constexpr double kLeastHeight = 1.0 / (1 << 20);
// How far outside of the square texture coordinates may be, by rounding.
constexpr double kOutside = 1e-4;

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

class FigureTaker {
 public:
  explicit FigureTaker(const AtlasCorners& atlas) : atlas_(atlas) {}

  AtlasFigures run() {
    const std::size_t count = atlas_.texcoords.size() / 3;
    for (std::size_t t = 0; t < count; ++t) add(t);
    AtlasFigures result;
    result.charts = countCharts();
    result.coverage = inSquare_;
    result.unusable = onSurface_ > 0 ? unusable_ / onSurface_ : 1;
    const double even = used_ > 0 ? std::sqrt(inSquare_ / used_) : 0;
    result.stretch = used_ > 0 ? even * std::sqrt(squares_ / used_) : 0;
    for (std::size_t t = 0; t < count; ++t)
      if (isUsable(t) && even * heightOf(t) >= kLeastHeight)
        result.worstStretch = std::max(result.worstStretch, even * stretchOf(t));
    result.overlap = overlap();
    return result;
  }

 private:
  std::array<Vec2, 3> plane(std::size_t t) const {
    const Vec2* const corners = &atlas_.texcoords[3 * t];
    const Vec2 tile = tileOf(corners[0], corners[1], corners[2]);
    return {corners[0] - tile, corners[1] - tile, corners[2] - tile};
  }

  double flatArea(std::size_t t) const {
    const auto [p, q, r] = plane(t);
    return cross2(q - p, r - p);
  }

  bool isUsable(std::size_t t) const {
    const std::array<Vec2, 3> corners = plane(t);
    return std::abs(flatArea(t)) > 0 &&
           std::all_of(corners.begin(), corners.end(), [](const Vec2& uv) {
             return uv.minCoeff() >= -kOutside && uv.maxCoeff() <= 1 + kOutside;
           });
  }

  Triangle surface(std::size_t t) const {
    return {atlas_.positions[3 * t], atlas_.positions[3 * t + 1], atlas_.positions[3 * t + 2]};
  }

  // Above the longest edge.
  double heightOf(std::size_t t) const {
    const auto [a, b, c] = surface(t);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest > 0 ? areaVector(a, b, c).norm() / longest : 0;
  }

  // The squared lengths on the surface per length along u and v, and their product with each other.
  std::array<double, 3> metricOf(std::size_t t) const {
    const auto [p, q, r] = plane(t);
    const auto [a, b, c] = surface(t);
    const double flat = flatArea(t);
    const Vec3 perU = ((r.y() - p.y()) * (b - a) - (q.y() - p.y()) * (c - a)) / flat;
    const Vec3 perV = ((q.x() - p.x()) * (c - a) - (r.x() - p.x()) * (b - a)) / flat;
    return {perU.squaredNorm(), perV.squaredNorm(), perU.dot(perV)};
  }

  double stretchOf(std::size_t t) const {
    const auto [u, v, mixed] = metricOf(t);
    return std::sqrt((u + v + std::hypot(u - v, 2 * mixed)) / 2);
  }

  void add(std::size_t t) {
    const auto [a, b, c] = surface(t);
    const double area = areaVector(a, b, c).norm() / 2;
    onSurface_ += area;
    if (!isUsable(t)) {
      unusable_ += area;
      return;
    }
    inSquare_ += std::abs(flatArea(t)) / 2;
    used_ += area;
    const auto [u, v, mixed] = metricOf(t);
    squares_ += area * (u + v) / 2;
  }

  std::size_t countCharts() const {
    const std::size_t corners = atlas_.texcoords.size();
    DisjointSets charts(corners / 3);
    const Index places =
        corners == 0 ? 0 : *std::max_element(atlas_.welded.begin(), atlas_.welded.end()) + 1;
    const EdgeGroups edges(places, atlas_.welded);
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const Index b : edges[e]) {
        const Index a = edges[e][0];
        const bool isTurned = atlas_.welded[a] != atlas_.welded[b];
        const Index from = isTurned ? nextCorner(b) : b, to = isTurned ? b : nextCorner(b);
        if (atlas_.texcoords[a] == atlas_.texcoords[from] &&
            atlas_.texcoords[nextCorner(a)] == atlas_.texcoords[to])
          charts.unite(a / 3, b / 3);
      }
    std::size_t count = 0;
    for (Index t = 0; t < corners / 3; ++t) count += charts.find(t) == t;
    return count;
  }

  // Of the covered texels of a raster: the share whose middles are inside several triangles.
  double overlap() const {
    std::vector<std::uint8_t> covers(std::size_t{kRaster} * kRaster, 0);
    for (std::size_t t = 0; t < atlas_.texcoords.size() / 3; ++t) cover(t, covers);
    std::size_t covered = 0, twice = 0;
    for (const std::uint8_t count : covers) {
      covered += count > 0;
      twice += count > 1;
    }
    return covered > 0 ? double(twice) / double(covered) : 0;
  }

  void cover(std::size_t t, std::vector<std::uint8_t>& covers) const {
    std::array<Vec2, 3> c = plane(t);
    for (Vec2& corner : c) corner *= kRaster;
    if (cross2(c[1] - c[0], c[2] - c[0]) < 0) std::swap(c[1], c[2]);
    const Vec2 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]).cwiseMax(0);
    const Vec2 high = c[0].cwiseMax(c[1]).cwiseMax(c[2]).cwiseMin(kRaster);
    if (!low.allFinite() || !high.allFinite()) return;
    for (int y = int(low.y()); y < std::min(kRaster, int(high.y()) + 1); ++y)
      for (int x = int(low.x()); x < std::min(kRaster, int(high.x()) + 1); ++x) {
        const Vec2 middle(x + 0.5, y + 0.5);
        bool isInside = true;
        for (std::size_t k = 0; k < 3; ++k)
          isInside &= cross2(c[(k + 1) % 3] - c[k], middle - c[k]) > 0;
        std::uint8_t& count = covers[std::size_t(y) * kRaster + std::size_t(x)];
        if (isInside && count < 2) ++count;
      }
  }

  AtlasCorners atlas_;
  double onSurface_ = 0, used_ = 0, inSquare_ = 0, unusable_ = 0, squares_ = 0;
};

}  // namespace

Vec2 tileOf(const Vec2& a, const Vec2& b, const Vec2& c) {
  return ((a + b + c) / 3).array().floor();
}

AtlasFigures figuresOf(const AtlasCorners& atlas) { return FigureTaker(atlas).run(); }

}  // namespace remesher
