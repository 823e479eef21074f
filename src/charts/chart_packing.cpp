// SPDX-License-Identifier: MIT
#include "charts/chart_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace remesher {

namespace {

constexpr int kTurns = 32;           // of a right angle, that are tried
constexpr Index kColumns = 512;      // of the skyline, at most
constexpr double kScaleStep = 0.98;  // from one try to the next

struct Bounds {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;

  explicit Bounds(const PlaneChart& chart) {
    for (const PlaneTriangle& triangle : chart)
      for (const Vec2& p : triangle) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
  }
  Vec2 size() const { return high - low; }
};

PlaneChart turned(const PlaneChart& chart, double angle) {
  const Eigen::Rotation2Dd rotation(angle);
  PlaneChart result = chart;
  for (PlaneTriangle& triangle : result)
    for (Vec2& p : triangle) p = rotation * p;
  return result;
}

// Turned to its smallest box, wider than high, the box's corner at the origin.
PlaneChart laidOut(const PlaneChart& chart) {
  double least = std::numeric_limits<double>::infinity(), best = 0;
  for (int i = 0; i < kTurns; ++i) {
    const double angle = i * std::numbers::pi / 2 / kTurns;
    const Vec2 size = Bounds(turned(chart, angle)).size();
    if (size.prod() >= least) continue;
    least = size.prod();
    best = angle + (size.y() > size.x() ? std::numbers::pi / 2 : 0);
  }
  PlaneChart result = turned(chart, best);
  const Vec2 low = Bounds(result).low;
  for (PlaneTriangle& triangle : result)
    for (Vec2& p : triangle) p -= low;
  return result;
}

// How far a chart reaches down and up in each column of cells, padding included.
struct Outline {
  std::vector<int> low, high;
};

class Packer {
 public:
  Packer(std::span<const PlaneChart> charts, const PackingRules& rules)
      : rules_(rules), cell_(std::max<Index>(1, rules.size / kColumns)) {
    for (const PlaneChart& chart : charts) {
      charts_.push_back(laidOut(chart));
      sizes_.push_back(Bounds(charts_.back()).size());
    }
    order_.resize(charts_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return sizes_[a].y() > sizes_[b].y(); });
  }

  Packing run() {
    double scale = largestThinkable();
    const double least = scale * 1e-4;
    while (scale > least) {
      if (std::optional<std::vector<Vec2>> places = tryScale(scale)) return placed(*places, scale);
      scale *= kScaleStep;
    }
    return {{}, 0};
  }

 private:
  // By area, and by the longest chart.
  double largestThinkable() const {
    double area = 0, longest = 0;
    for (std::size_t i = 0; i < charts_.size(); ++i) {
      longest = std::max(longest, sizes_[i].maxCoeff());
      for (const PlaneTriangle& t : charts_[i]) {
        const Vec2 a = t[1] - t[0], b = t[2] - t[0];
        area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
      }
    }
    const double free = std::max(1.0, double(rules_.size) - 2.0 * rules_.padding);
    return std::min(area > 0 ? free / std::sqrt(area) : 1e300,
                    longest > 0 ? free / longest : 1e300);
  }

  Outline outlineOf(const PlaneChart& chart, double scale) const {
    const double pad = rules_.padding;
    const double width = scale * Bounds(chart).high.x() + 2 * pad;
    const int columns = int(std::ceil((width + 1) / cell_));
    Outline outline{std::vector<int>(columns, std::numeric_limits<int>::max()),
                    std::vector<int>(columns, 0)};
    for (const PlaneTriangle& t : chart)
      for (int k = 0; k < 3; ++k) addEdge(outline, scale * t[k], scale * t[(k + 1) % 3]);
    return outline;
  }

  // The columns that a padded edge comes into, each with how far the edge reaches there.
  void addEdge(Outline& outline, Vec2 a, Vec2 b) const {
    if (a.x() > b.x()) std::swap(a, b);
    const double pad = rules_.padding;
    const int first = int(std::floor(a.x() / cell_));
    const int last = int(std::floor((b.x() + 2 * pad) / cell_));
    const auto height = [&](double x) {
      const double t = b.x() > a.x() ? std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) : 0;
      return a.y() + t * (b.y() - a.y());
    };
    for (int i = first; i <= last && i < int(outline.low.size()); ++i) {
      const double left = i * double(cell_) - 2 * pad, right = (i + 1) * double(cell_);
      const bool isSteep = b.x() - a.x() < 1e-9;
      const double y0 = isSteep ? a.y() : height(left), y1 = isSteep ? b.y() : height(right);
      const auto [low, high] = std::minmax(y0, y1);
      outline.low[i] = std::min(outline.low[i], int(std::floor(low / cell_)));
      outline.high[i] = std::max(outline.high[i], int(std::floor((high + 2 * pad) / cell_)) + 1);
    }
  }

  std::optional<std::vector<Vec2>> tryScale(double scale) const {
    const int cells = int(rules_.size / cell_);
    std::vector<int> skyline(cells, 0);
    std::vector<Vec2> places(charts_.size());
    for (const std::size_t i : order_) {
      const Outline outline = outlineOf(charts_[i], scale);
      const int width = int(outline.low.size());
      int bestX = -1, bestY = 0, bestTop = std::numeric_limits<int>::max();
      const int highest = *std::max_element(outline.high.begin(), outline.high.end());
      for (int x = 0; x + width <= cells; ++x) {
        int y = 0;
        for (int k = 0; k < width; ++k) y = std::max(y, skyline[x + k] - outline.low[k]);
        if (y + highest >= bestTop) continue;
        bestTop = y + highest;
        bestX = x;
        bestY = y;
      }
      if (bestX < 0 || bestTop > cells) return std::nullopt;
      for (int k = 0; k < width; ++k)
        skyline[bestX + k] = std::max(skyline[bestX + k], bestY + outline.high[k]);
      places[i] = Vec2(double(bestX) * cell_, double(bestY) * cell_);
    }
    return places;
  }

  Packing placed(const std::vector<Vec2>& places, double scale) {
    const Vec2 pad = Vec2::Constant(rules_.padding);
    for (std::size_t i = 0; i < charts_.size(); ++i)
      for (PlaneTriangle& triangle : charts_[i])
        for (Vec2& p : triangle) p = scale * p + places[i] + pad;
    return {std::move(charts_), scale};
  }

  PackingRules rules_;
  Index cell_;  // texels
  std::vector<PlaneChart> charts_;
  std::vector<Vec2> sizes_;
  std::vector<std::size_t> order_;
};

}  // namespace

Packing packCharts(std::span<const PlaneChart> charts, const PackingRules& rules) {
  return Packer(charts, rules).run();
}

}  // namespace remesher
