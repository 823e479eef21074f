// SPDX-License-Identifier: MIT
#include "textures/charts/chart_packing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

namespace remesher {

namespace {

// Tried angles within a right angle.
constexpr int kTurns = 32;
// Quarter turns in which a chart may lie.
constexpr std::size_t kQuarters = 4;
// Most cells along a side of the square.
constexpr Index kCells = 512;
// How many of the largest charts are tried as the first one, and how many charts are placed in all
// orders of one kind at most, if there are several.
constexpr std::size_t kStarts = 12, kMostPlaced = 1024;
// The ratio between a scale at which all fits and one at which not.
constexpr double kNearEnough = 1.01;

struct Bounds {
  Vec2 low = Vec2::Constant(kInfinity);
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

// The chart turned to its smallest box, wider than high, with the box's corner at the origin.
PlaneChart laidOut(const PlaneChart& chart) {
  double least = kInfinity, best = 0;
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

// The chart turned by a right angle.
PlaneChart upright(const PlaneChart& chart) {
  PlaneChart result = chart;
  const double height = Bounds(chart).high.y();
  for (PlaneTriangle& triangle : result)
    for (Vec2& p : triangle) p = Vec2(height - p.y(), p.x());
  return result;
}

// A run of adjacent cells in a row; shorter runs sort first.
struct CellRun {
  int length = 0, row = 0, begin = 0;

  auto operator<=>(const CellRun&) const = default;
  int end() const { return begin + length; }
};

// The cells that a chart touches, padding included.
struct Mask {
  std::vector<CellRun> runs;  // the longest first: it rules out most places
  int width = 0, height = 0, cells = 0;
};

// A row of the square, one bit per cell.
class Row {
 public:
  void fill(const CellRun& run) {
    for (int i = run.begin; i < run.end();) {
      const int count = std::min(kBits - i % kBits, run.end() - i);
      words_[i / kBits] |= kAll >> (kBits - count) << (i % kBits);
      i += count;
    }
  }

  // Sets bit x wherever the other row has bit x + distance, at least for x ≥ from.
  void add(const Row& other, int distance, int from) {
    const std::size_t whole = distance / kBits;
    const int rest = distance % kBits;
    for (std::size_t i = from / kBits; i + whole < kWords; ++i) {
      words_[i] |= other.words_[i + whole] >> rest;
      if (rest > 0 && i + whole + 1 < kWords)
        words_[i] |= other.words_[i + whole + 1] << (kBits - rest);
    }
  }

  // The first cell from `from` on whose bit is set, or not set; kCells if there is none.
  int firstSet(int from) const { return first(from, 0); }
  int firstFree(int from) const { return first(from, kAll); }

  // The length of the longest run of cells without a bit.
  int longestFree(int cells) const {
    int longest = 0;
    for (int begin = firstFree(0); begin < cells;) {
      const int end = firstSet(begin);
      longest = std::max(longest, std::min(end, cells) - begin);
      begin = firstFree(end);
    }
    return longest;
  }

 private:
  static constexpr int kBits = 64;
  static constexpr std::size_t kWords = kCells / kBits;
  static constexpr std::uint64_t kAll = ~std::uint64_t{};

  int first(int from, std::uint64_t flipped) const {
    std::uint64_t mask = kAll << (from % kBits);
    for (std::size_t i = from / kBits; i < kWords; ++i, mask = kAll)
      if (const std::uint64_t word = (words_[i] ^ flipped) & mask)
        return int(i) * kBits + std::countr_zero(word);
    return kCells;
  }

  std::array<std::uint64_t, kWords> words_{};
};

// The taken cells of a row of the square. It is queried far more often than it changes.
class TakenRow {
 public:
  explicit TakenRow(int cells) : cells_(cells), longestFree_(cells) {}

  void fill(const CellRun& run) {
    for (std::size_t i = 0; i < blocked_.size(); ++i) {
      const int begin = std::max(0, run.begin - (1 << i) + 1);
      blocked_[i].fill({run.end() - begin, 0, begin});
    }
    longestFree_ = blocked_[0].longestFree(cells_);
  }

  // The length of the longest free run.
  int longestFree() const { return longestFree_; }

  // Adds, from cell `from` on, the places where a mask cannot begin because its run would meet
  // taken cells. The run is the union of two runs of 2^i cells that overlap.
  void addBlocked(Row& to, const CellRun& run, int from) const {
    const int power = std::bit_width(unsigned(run.length)) - 1, rest = run.length - (1 << power);
    to.add(blocked_[power], run.begin, from);
    if (rest > 0) to.add(blocked_[power], run.begin + rest, from);
  }

 private:
  int cells_, longestFree_;
  std::array<Row, std::bit_width(kCells)> blocked_;  // [i]: where no run of 2^i begins
};

// The range of cells that something touches in a row.
struct Reach {
  int begin = kCells, end = 0;
};

// The place of a chart: its quarter turns, and its box's corner in cells.
struct ChartPosition {
  int x = 0, y = 0;
  std::size_t turn = 0;
};

class Packer {
  template <class T>
  using Turns = std::array<T, kQuarters>;

 public:
  Packer(std::span<const PlaneChart> charts, const PackingRules& rules)
      : rules_(rules), cell_((rules.size + kCells - 1) / kCells), cells_(int(rules.size / cell_)) {
    std::vector<std::pair<double, Index>> bySize, byLength;
    for (const PlaneChart& chart : charts) {
      const PlaneChart flat = laidOut(chart);
      const Vec2 size = Bounds(flat).size();
      bySize.push_back({-size.sum(), Index(charts_.size())});
      byLength.push_back({-size.maxCoeff(), Index(charts_.size())});
      longest_ = std::max(longest_, size.maxCoeff());
      charts_.push_back({flat});
      for (std::size_t turn = 1; turn < kQuarters; ++turn)
        charts_.back()[turn] = upright(charts_.back()[turn - 1]);
    }
    addOrders(std::move(bySize));
    addOrders(std::move(byLength));
  }

  Packing run() {
    double low = largestThinkable(), high = low;
    std::optional<std::vector<ChartPosition>> best = tryScale(low);
    // Where no chart is longer than a texel, smaller ones take no less room.
    for (; !best && low * longest_ > 1; best = tryScale(low)) {
      high = low;
      low /= 2;
    }
    if (!best) return {{}, 0};
    while (high > kNearEnough * low) {
      const double scale = std::sqrt(low * high);
      std::optional<std::vector<ChartPosition>> positions = tryScale(scale);
      (positions ? low : high) = scale;
      if (positions) best = std::move(positions);
    }
    return placed(*best, low);
  }

 private:
  // The largest first, but for the first one: where few are large, much depends on that.
  void addOrders(std::vector<std::pair<double, Index>> keys) {
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    for (const auto& [key, i] : keys) order.push_back(i);
    for (std::size_t i = 0; i < std::min(kStarts, order.size()); ++i) {
      if (orders_.size() > 0 && (i + 1) * order.size() > kMostPlaced) return;
      std::vector<Index>& next = orders_.emplace_back(order);
      std::rotate(next.begin(), next.begin() + i, next.begin() + i + 1);
    }
  }

  // An upper bound on the scale, by total area and by the longest chart.
  double largestThinkable() const {
    double area = 0;
    for (const Turns<PlaneChart>& turns : charts_)
      for (const PlaneTriangle& t : turns.front()) {
        const Vec2 a = t[1] - t[0], b = t[2] - t[0];
        area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
      }
    const double free = std::max(1.0, double(rules_.size) - 2.0 * rules_.padding);
    return std::min(area > 0 ? free / std::sqrt(area) : 1e300,
                    longest_ > 0 ? free / longest_ : 1e300);
  }

  Mask maskOf(const PlaneChart& chart, double scale) const {
    const double height = scale * Bounds(chart).high.y() + 2.0 * rules_.padding;
    std::vector<Row> rows(std::size_t(std::ceil((height + 1) / cell_)));
    std::vector<Reach> reaches(rows.size());
    for (const PlaneTriangle& t : chart) {
      for (int k = 0; k < 3; ++k) addEdge(reaches, scale * t[k], scale * t[(k + 1) % 3]);
      const double low = scale * std::min({t[0].y(), t[1].y(), t[2].y()});
      for (auto i = std::size_t(low / cell_); i < rows.size() && reaches[i].end > 0; ++i) {
        rows[i].fill({reaches[i].end - reaches[i].begin, 0, reaches[i].begin});
        reaches[i] = {};
      }
    }
    Mask mask;
    mask.height = int(rows.size());
    for (int r = 0; r < mask.height; ++r)
      for (int i = rows[r].firstSet(0); i < int(kCells);) {
        const int begin = i, end = rows[r].firstFree(begin);
        mask.width = std::max(mask.width, end);
        mask.cells += end - begin;
        mask.runs.push_back({end - begin, r, begin});
        i = rows[r].firstSet(end);
      }
    std::sort(mask.runs.rbegin(), mask.runs.rend());
    return mask;
  }

  // Extends the rows that a padded edge touches by the edge's range in each.
  void addEdge(std::vector<Reach>& rows, Vec2 a, Vec2 b) const {
    if (a.y() > b.y()) std::swap(a, b);
    const double pad = rules_.padding;
    const int first = int(std::floor(a.y() / cell_));
    const int last = std::min(int(rows.size()) - 1, int(std::floor((b.y() + 2 * pad) / cell_)));
    const auto across = [&](double y) {
      const double t = b.y() > a.y() ? std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) : 0;
      return a.x() + t * (b.x() - a.x());
    };
    for (int i = first; i <= last; ++i) {
      const bool isLevel = b.y() - a.y() < 1e-9;
      const double x0 = isLevel ? a.x() : across(i * double(cell_) - 2 * pad);
      const double x1 = isLevel ? b.x() : across((i + 1) * double(cell_));
      const auto [low, high] = std::minmax(x0, x1);
      rows[i].begin = std::min(rows[i].begin, int(std::floor(low / cell_)));
      // A chart as long as the square touches the cell behind its last one, in no more than a line.
      const int end = std::min(int(kCells), int(std::floor((high + 2 * pad) / cell_)) + 1);
      rows[i].end = std::max(rows[i].end, end);
    }
  }

  // Masks of all charts in their turns; none if the charts have more cells than the square.
  std::optional<std::vector<Turns<Mask>>> masksAt(double scale) const {
    std::vector<Turns<Mask>> masks;
    int free = cells_ * cells_;
    for (const Turns<PlaneChart>& turns : charts_) {
      int fewest = free + 1;
      masks.emplace_back();
      for (std::size_t turn = 0; turn < kQuarters; ++turn) {
        masks.back()[turn] = maskOf(turns[turn], scale);
        fewest = std::min(fewest, masks.back()[turn].cells);
      }
      free -= fewest;
      if (free < 0) return {};
    }
    return masks;
  }

  // The lowest free place of a mask that ends at or below row `top`; among equally low places the
  // leftmost.
  std::optional<ChartPosition> positionFor(const Mask& mask, const std::vector<TakenRow>& square,
                                           int top) const {
    for (int y = 0; y + mask.height <= top; ++y) {
      const bool isHopeless = std::any_of(
          mask.runs.begin(), mask.runs.end(),
          [&](const CellRun& run) { return run.length > square[y + run.row].longestFree(); });
      if (isHopeless) continue;
      Row blocked;
      int x = 0;
      for (const CellRun& run : mask.runs) {
        square[y + run.row].addBlocked(blocked, run, x);
        x = blocked.firstFree(x);
        if (x + mask.width > cells_) break;
      }
      if (x + mask.width <= cells_) return ChartPosition{x, y, 0};
    }
    return {};
  }

  std::optional<std::vector<ChartPosition>> tryScale(double scale) const {
    const auto masks = masksAt(scale);
    if (!masks) return {};
    for (const std::vector<Index>& order : orders_)
      if (auto positions = tryOrder(*masks, order)) return positions;
    return {};
  }

  std::optional<std::vector<ChartPosition>> tryOrder(const std::vector<Turns<Mask>>& masks,
                                                     const std::vector<Index>& order) const {
    std::vector<TakenRow> square(cells_, TakenRow(cells_));
    std::vector<ChartPosition> positions(charts_.size());
    for (const Index i : order) {
      std::optional<ChartPosition> best;
      int top = cells_;
      for (std::size_t turn = 0; turn < kQuarters; ++turn) {
        const std::optional<ChartPosition> position = positionFor(masks[i][turn], square, top);
        if (!position) continue;
        best = {position->x, position->y, turn};
        top = position->y + masks[i][turn].height - 1;
      }
      if (!best) return {};
      for (const CellRun& run : masks[i][best->turn].runs)
        square[best->y + run.row].fill({run.length, run.row, best->x + run.begin});
      positions[i] = *best;
    }
    return positions;
  }

  Packing placed(const std::vector<ChartPosition>& positions, double scale) {
    const Vec2 pad = Vec2::Constant(rules_.padding);
    Packing packing{{}, scale};
    for (std::size_t i = 0; i < charts_.size(); ++i) {
      PlaneChart chart = std::move(charts_[i][positions[i].turn]);
      const Vec2 corner = double(cell_) * Vec2(positions[i].x, positions[i].y) + pad;
      for (PlaneTriangle& triangle : chart)
        for (Vec2& p : triangle) p = scale * p + corner;
      packing.charts.push_back(std::move(chart));
    }
    return packing;
  }

  PackingRules rules_;
  Index cell_;  // texels
  int cells_;   // along a side
  std::vector<Turns<PlaneChart>> charts_;
  double longest_ = 0;
  std::vector<std::vector<Index>> orders_;  // in which they are placed
};

}  // namespace

Packing packCharts(std::span<const PlaneChart> charts, const PackingRules& rules) {
  return Packer(charts, rules).run();
}

}  // namespace remesher
