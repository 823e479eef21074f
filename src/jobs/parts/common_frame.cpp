// SPDX-License-Identifier: MIT
#include "jobs/parts/common_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "geometry/box.h"
#include "geometry/own_axes.h"
#include "geometry/triangle.h"

namespace remesher {
namespace {

// Whole numbers up to this are steps of decimals: hardly any other number is near to one by chance.
constexpr double kMostDecimal = 0x1p46;
// Whole numbers up to this have no fraction that a double could not hold, nor has their half.
constexpr double kMostWhole = 0x1p51;
constexpr int kMostPowers = 15;
// Coordinates beyond, and sides below its inverse, are extreme.
constexpr double kExtreme = 0x1p1000;
// Single precision numbers farther from the origin than this many diagonals stay there.
constexpr double kFarSingle = 4;

// Visits every coordinate of every vertex, until `visit` returns false.
template <class Visit>
bool allCoordinates(const std::vector<io::Part>& parts, Visit visit) {
  for (const io::Part& part : parts)
    for (const Vec3& p : part.mesh.positions)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (!visit(p[axis], axis)) return false;
  return true;
}

// The box of triangles that are no lines. Indices are not checked yet.
Box boxOfTriangles(const std::vector<io::Part>& parts) {
  Box box;
  for (const io::Part& part : parts) {
    const std::vector<Vec3>& positions = part.mesh.positions;
    for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
      const Index* const t = &part.mesh.indices[i];
      if (std::max({t[0], t[1], t[2]}) >= positions.size()) continue;
      if (hasTwins(positions[t[0]], positions[t[1]], positions[t[2]])) continue;
      for (std::size_t k = 0; k < 3; ++k) box.extend(positions[t[k]]);
    }
  }
  return box;
}

bool isExtreme(const std::vector<io::Part>& parts, const Box& box) {
  const double side = (box.high - box.low).maxCoeff();
  return !(side > 1 / kExtreme) ||
         !allCoordinates(parts, [](double x, Eigen::Index) { return std::abs(x) < kExtreme; });
}

// The power of ten of which all coordinates, times it, are whole numbers.
std::optional<double> decimalParts(const std::vector<io::Part>& parts) {
  double power = 1;
  int digits = 0;
  const auto isDecimal = [&](double x) {
    const double whole = std::round(x * power);
    return std::abs(whole) <= kMostDecimal && whole / power == x;
  };
  const bool areAll = allCoordinates(parts, [&](double x, Eigen::Index) {
    while (!isDecimal(x)) {
      if (++digits > kMostPowers || std::abs(x * power) > kMostDecimal) return false;
      power *= 10;
    }
    return true;
  });
  return areAll ? std::optional(power) : std::nullopt;
}

// The exponent of the lowest binary digit of x, which is not 0.
int lowestDigit(double x) {
  int exponent = 0;
  const auto digits = std::uint64_t(std::abs(std::frexp(x, &exponent)) * 0x1p53);
  return exponent - 53 + std::countr_zero(digits);
}

// The power of two of which all coordinates are multiples, if they have few digits.
std::optional<double> binaryStep(const std::vector<io::Part>& parts) {
  int lowest = 1024;
  double largest = 0;
  allCoordinates(parts, [&](double x, Eigen::Index) {
    if (x != 0) lowest = std::min(lowest, lowestDigit(x));
    largest = std::max(largest, std::abs(x));
    return true;
  });
  if (largest == 0) return std::nullopt;
  const double step = std::ldexp(1.0, lowest);
  return largest / step <= kMostWhole ? std::optional(step) : std::nullopt;
}

Vec3 inSteps(const Vec3& p, const Frame& frame) {
  return (p * frame.parts / frame.step).array().round();
}

// How many steps all differences of coordinates are multiples of.
double sharedSteps(const std::vector<io::Part>& parts, const Frame& frame, const Vec3& low) {
  std::int64_t shared = 0;
  allCoordinates(parts, [&](double x, Eigen::Index axis) {
    const double steps = std::round(x * frame.parts / frame.step) - low[axis];
    shared = std::gcd(shared, std::int64_t(steps));
    return shared != 1;
  });
  return double(std::max<std::int64_t>(shared, 1));
}

// The unit at which the longest side is between 1 and 2.
double unitFor(const Vec3& sides) { return std::ldexp(1.0, -std::ilogb(sides.maxCoeff())); }

// In whole steps, if all coordinates are.
std::optional<Frame> stepFrame(const std::vector<io::Part>& parts, const Box& box) {
  Frame frame;
  const std::optional<double> power = decimalParts(parts);
  const std::optional<double> binary = power ? std::nullopt : binaryStep(parts);
  if (!power && !binary) return std::nullopt;
  frame.parts = power.value_or(1);
  frame.step = binary.value_or(1);
  const Vec3 low = inSteps(box.low, frame), sides = inSteps(box.high, frame) - low;
  frame.shared = sharedSteps(parts, frame, low);
  frame.middle = low + sides / 2;
  frame.unit = unitFor(sides / frame.shared);
  return frame;
}

// Whether every coordinate is back what it was.
bool isExact(const std::vector<io::Part>& parts, const CommonFrame& frame) {
  for (const io::Part& part : parts)
    for (const Vec3& p : part.mesh.positions)
      if (frame.frame.written(frame.here(p)) != p) return false;
  return true;
}

// Whether rounding changes no edge by more than a small share of its length, and takes the area of
// no triangle.
bool keepsShape(const std::vector<io::Part>& parts, const CommonFrame& frame) {
  constexpr double kShare = 1e-6;
  for (const io::Part& part : parts) {
    const std::vector<Vec3>& positions = part.mesh.positions;
    if (!std::all_of(positions.begin(), positions.end(),
                     [&](const Vec3& p) { return frame.here(p).allFinite(); }))
      return false;
    for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
      const Index* const t = &part.mesh.indices[i];
      if (std::max({t[0], t[1], t[2]}) >= positions.size()) continue;
      const std::array<Vec3, 3> given = {positions[t[0]], positions[t[1]], positions[t[2]]};
      const std::array<Vec3, 3> here = {frame.here(given[0]), frame.here(given[1]),
                                        frame.here(given[2])};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 before = (given[(k + 1) % 3] - given[k]) * frame.frame.unit;
        if ((frame.frame.turn.turnedBack(Vec3(here[(k + 1) % 3] - here[k])) - before).norm() >
            kShare * before.norm())
          return false;
      }
      if (flatness(here[0], here[1], here[2]) <= kFlattest &&
          flatness(given[0], given[1], given[2]) > kFlattest)
        return false;
    }
  }
  return true;
}

// Along the own axes of the parts' corners.
QuarterTurn ownTurn(const std::vector<io::Part>& parts, const Box& box) {
  SpreadOfPoints spread(box);
  for (const io::Part& part : parts)
    for (const Index v : part.mesh.indices)
      if (v < part.mesh.positions.size()) spread.add(part.mesh.positions[v]);
  return spread.ownAxes();
}

}  // namespace

std::optional<CommonFrame> commonFrame(const std::vector<io::Part>& parts, FrameAxes axes) {
  const Box box = boxOfTriangles(parts);
  if (!(box.low.x() <= box.high.x()) || isExtreme(parts, box)) return std::nullopt;
  const bool isAnySingle = std::any_of(parts.begin(), parts.end(),
                                       [](const io::Part& part) { return part.mesh.isSingle; });
  const Vec3 sides = box.high - box.low;
  const double farthest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  if (isAnySingle && farthest > kFarSingle * sides.norm()) return std::nullopt;
  const QuarterTurn turn = axes == FrameAxes::Own ? ownTurn(parts, box) : QuarterTurn{};
  if (const std::optional<Frame> steps = stepFrame(parts, box)) {
    CommonFrame whole = {*steps, true};
    whole.frame.turn = turn;
    if (isExact(parts, whole)) return whole;
  }
  CommonFrame rounded;
  rounded.frame.middle = box.low / 2 + box.high / 2;
  rounded.frame.unit = unitFor(sides);
  rounded.frame.turn = turn;
  if (!keepsShape(parts, rounded)) return std::nullopt;
  return rounded;
}

}  // namespace remesher
