// SPDX-License-Identifier: MIT
// The curve is walked by tables, after Hamilton: Compact Hilbert Indices, 2006 (section 2: entry
// points, directions and the Gray code).
#include "mesh/space_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace remesher {

namespace {

constexpr int kBits = 10;  // of a cell's coordinate
constexpr Index kCells = Index{1} << kBits;

// Per way that the curve runs through a cube (where it enters and along which axis it leaves, 24
// ways): the place of each eighth along the curve, and the way through that eighth.
struct Eighths {
  struct Step {
    std::uint8_t place, way;
  };
  std::array<std::array<Step, 8>, 24> steps{};

  static constexpr unsigned rotatedLeft(unsigned x, unsigned by) {
    return ((x << by) | (x >> (3 - by))) & 7;
  }
  static constexpr unsigned gray(unsigned i) { return i ^ (i >> 1); }
  static constexpr unsigned entry(unsigned i) { return i == 0 ? 0 : gray((i - 1) & ~1u); }
  static constexpr unsigned direction(unsigned i) {
    if (i == 0) return 0;
    return unsigned(std::countr_one(i % 2 == 0 ? i - 1 : i)) % 3;
  }

  constexpr Eighths() {
    for (unsigned from = 0; from < 8; ++from)
      for (unsigned along = 0; along < 3; ++along)
        for (unsigned i = 0; i < 8; ++i) {
          const unsigned turn = (along + 1) % 3;
          const unsigned eighth = rotatedLeft(gray(i), turn) ^ from;
          const unsigned enters = from ^ rotatedLeft(entry(i), turn);
          const unsigned leaves = (along + direction(i) + 1) % 3;
          steps[3 * from + along][eighth] = {std::uint8_t(i), std::uint8_t(3 * enters + leaves)};
        }
  }
};
constexpr Eighths kEighths;

struct Placed {
  Index place, number;
};

using Points = std::span<const std::array<float, 3>>;

// By place; stable among points of one place.
void sortByPlace(std::span<Placed> points, std::vector<Placed>& spare) {
  if (points.size() < kCells)
    return std::sort(points.begin(), points.end(), [](const Placed& a, const Placed& b) {
      return a.place < b.place || (a.place == b.place && a.number < b.number);
    });
  std::array<std::array<Index, kCells>, 3> begins{};
  for (const Placed& p : points)
    for (std::size_t digit = 0; digit < 3; ++digit)
      ++begins[digit][(p.place >> (kBits * digit)) % kCells];
  spare.resize(points.size());
  std::span<Placed> from = points, to = spare;
  for (std::size_t digit = 0; digit < 3; ++digit) {
    Index sum = 0;
    for (Index& begin : begins[digit]) sum += std::exchange(begin, sum);
    for (const Placed& p : from) to[begins[digit][(p.place >> (kBits * digit)) % kCells]++] = p;
    std::swap(from, to);
  }
  std::copy(from.begin(), from.end(), points.begin());
}

// Orders points along the curve through their box, then those that share a cell, again.
void order(Points points, std::span<Placed> own, std::vector<Placed>& spare) {
  using Floats = Eigen::Array3f;
  const auto at = [&](const Placed& p) { return Floats(points[p.number].data()); };
  Floats low = at(own[0]), high = low;
  for (const Placed& p : own) {
    low = low.min(at(p));
    high = high.max(at(p));
  }
  const double side = (high.cast<double>() - low.cast<double>()).maxCoeff();
  if (!(side > 0) || !std::isfinite(side)) return;
  const double scale = kCells * (1 - 0x1p-20) / side;
  for (Placed& p : own) {
    std::array<Index, 3> cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = Index(scale * (double(points[p.number][axis]) - double(low[axis])));
    p.place = placeOnCurve(cell, kBits);
  }
  sortByPlace(own, spare);
  for (std::size_t begin = 0, end = 0; begin < own.size(); begin = end) {
    while (end < own.size() && own[end].place == own[begin].place) ++end;
    if (end - begin > 1) order(points, own.subspan(begin, end - begin), spare);
  }
}

}  // namespace

Index placeOnCurve(const std::array<Index, 3>& cell, int bits) {
  Index place = 0;
  unsigned way = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    const unsigned eighth =
        (cell[0] >> bit & 1) | (cell[1] >> bit & 1) << 1 | (cell[2] >> bit & 1) << 2;
    const Eighths::Step step = kEighths.steps[way][eighth];
    place = place << 3 | step.place;
    way = step.way;
  }
  return place;
}

std::vector<Index> orderInSpace(Points points) {
  std::vector<Placed> own(points.size()), spare;
  for (Index i = 0; i < own.size(); ++i) own[i].number = i;
  if (!own.empty()) order(points, own, spare);
  std::vector<Index> result(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) result[i] = own[i].number;
  return result;
}

}  // namespace remesher
