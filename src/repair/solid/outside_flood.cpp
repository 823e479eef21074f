// SPDX-License-Identifier: MIT
#include "repair/solid/outside_flood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace remesher {

namespace {

using Place = std::array<std::size_t, 3>;

// Per point the distance from the nearest crossing. In two sweeps, each forwards and backwards, a
// point takes over the crossing of a neighbour if that is nearer than its own: nearly always the
// nearest of all; if not, the error is less than a cell.
class Distances {
 public:
  Distances(const Lattice& lattice, std::span<const EdgeCrossing> crossings)
      : lattice_(lattice), nearest_(lattice.size(), kNone) {
    for (const EdgeCrossing& c : crossings) places_.push_back(placeOf(lattice, c));
    for (Index i = 0; i < crossings.size(); ++i) {
      const std::size_t p = crossings[i].edge / 3;
      offer(p, i);
      offer(p + lattice.stride(crossings[i].edge % 3), i);
    }
    constexpr int kSweeps = 2;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      lattice.forEachPoint(
          [&](std::size_t p, const Place& place) { ask(p, place, Towards::Lower); });
      lattice.forEachPointBackwards(
          [&](std::size_t p, const Place& place) { ask(p, place, Towards::Upper); });
    }
  }

  const Lattice& lattice() const { return lattice_; }

  double at(std::size_t p, const Place& place) const {
    if (nearest_[p] == kNone) return kInfinity;
    return (lattice_.position(place) - places_[nearest_[p]]).norm();
  }

 private:
  enum class Towards { Lower, Upper };

  void offer(std::size_t p, Index crossing) {
    takeNearest(p, lattice_.position(p), {nearest_[p], crossing, kNone, kNone});
  }

  void ask(std::size_t p, const Place& place, Towards towards) {
    std::array<Index, 4> known{nearest_[p], kNone, kNone, kNone};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool isLower = towards == Towards::Lower;
      if (isLower ? place[axis] == 0 : place[axis] + 1 == lattice_.count(axis)) continue;
      const std::size_t stride = lattice_.stride(axis);
      known[axis + 1] = nearest_[isLower ? p - stride : p + stride];
    }
    takeNearest(p, lattice_.position(place), known);
  }

  // known: first the crossing that is the nearest so far.
  void takeNearest(std::size_t p, const Vec3& own, const std::array<Index, 4>& known) {
    double least = kInfinity;
    for (const Index crossing : known) {
      if (crossing == kNone || (crossing == nearest_[p] && least < kInfinity)) continue;
      const double distance = (own - places_[crossing]).squaredNorm();
      if (distance < least) nearest_[p] = crossing, least = distance;
    }
  }

  const Lattice& lattice_;
  std::vector<Vec3> places_;
  std::vector<Index> nearest_;  // per point
};

// visit(neighbour, whether a surface separates it from the point)
template <class Visit>
void forEachNeighbor(const Lattice& lattice, const std::vector<char>& crossed, std::size_t p,
                     Visit visit) {
  const auto place = lattice.place(p);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t stride = lattice.stride(axis);
    if (place[axis] > 0) visit(p - stride, (crossed[p - stride] >> axis & 1) != 0);
    if (place[axis] + 1 < lattice.count(axis)) visit(p + stride, (crossed[p] >> axis & 1) != 0);
  }
}

// Per point whether it is reached from the border through free points.
std::vector<char> flooded(const Lattice& lattice, const Distances& distances, double clearance) {
  std::vector<char> isKeptOut(lattice.size());
  lattice.forEachPoint([&](std::size_t p, const Place& place) {
    isKeptOut[p] = !(distances.at(p, place) >= clearance);
  });
  fillCavities(lattice, {}, isKeptOut);
  for (char& is : isKeptOut) is = !is;
  return isKeptOut;
}

// Whether the point is reached and a neighbour is not: the outside can grow only from such points.
bool isAtFront(const Lattice& lattice, const std::vector<char>& isReached, std::size_t p,
               const Place& place) {
  if (!isReached[p]) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t stride = lattice.stride(axis);
    if (place[axis] > 0 && !isReached[p - stride]) return true;
    if (place[axis] + 1 < lattice.count(axis) && !isReached[p + stride]) return true;
  }
  return false;
}

// Grows the outside back to the surface, by as much as the flood kept away from it, but not through
// the surface. Where the flood ended, the surface is a clearance away; along the way back this
// distance and the way add up to the clearance, in corners to at most the reach: the clearance and
// 1.75 cells. Behind a crack both grow, so that the outside gets half as deep into it.
void growBack(const Distances& distances, const std::vector<char>& crossed, double reach,
              std::vector<char>& isOutside) {
  const Lattice& lattice = distances.lattice();
  std::vector<std::size_t> front;
  std::vector<float> ways(isOutside.size(), std::numeric_limits<float>::infinity());
  std::vector<std::size_t> origins(isOutside.size());
  lattice.forEachPoint([&](std::size_t p, const Place& place) {
    if (isOutside[p]) ways[p] = 0, origins[p] = p;
    if (isAtFront(lattice, isOutside, p, place)) front.push_back(p);
  });
  for (std::size_t i = 0; i < front.size(); ++i) {
    const std::size_t p = front[i], origin = origins[p];
    forEachNeighbor(lattice, crossed, p, [&](std::size_t q, bool isParted) {
      if (isParted) return;
      // Measured straight from where the flood ended: paths along lattice edges are longer.
      const auto way = float((lattice.position(q) - lattice.position(origin)).norm());
      if (!(way < ways[q]) || double(way) + distances.at(q, lattice.place(q)) > reach) return;
      ways[q] = way, origins[q] = origin, isOutside[q] = 1;
      front.push_back(q);
    });
  }
}

// The end of the lattice edge that is nearer to a place between two crossings of it.
std::size_t nearerEnd(const Lattice& lattice, const EdgeCrossing& one, const EdgeCrossing& other) {
  const std::size_t p = one.edge / 3, axis = one.edge % 3;
  const auto place = lattice.place(p);
  const double above = (one.at + other.at) / 2 - lattice.at(axis, place[axis]);
  return above < lattice.width(axis, place) / 2 ? p : p + lattice.stride(axis);
}

// A sheet is thickened behind the side that is seen. Of two on one edge that face away from each
// other only one end is inside: with both there would be nothing left between them.
void findSheets(const Lattice& lattice, std::span<const EdgeCrossing> crossings, Sheets sheets,
                InsideField& field) {
  const std::vector<char> before = field.isInside;
  for (std::size_t i = 0, next = 0; i < crossings.size(); i = next) {
    const EdgeCrossing& first = crossings[i];
    const std::size_t p = first.edge / 3, q = p + lattice.stride(first.edge % 3);
    while (next < crossings.size() && crossings[next].edge == first.edge) ++next;
    if (before[p] || before[q]) continue;
    const std::span<const EdgeCrossing> own = crossings.subspan(i, next - i);
    for (const EdgeCrossing& c : own) field.sheets.push_back(c.triangle);
    if (sheets == Sheets::Drop) continue;
    const auto up = std::size_t(
        std::count_if(own.begin(), own.end(), [](const EdgeCrossing& c) { return c.up > 0; }));
    field.isInside[up == own.size() ? p : up == 0 ? q : nearerEnd(lattice, first, own.back())] = 1;
  }
}

}  // namespace

bool keepThinWalls(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                   InsideField& field) {
  const std::vector<char> before = field.isInside;
  bool isAny = false;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const EdgeCrossing &in = crossings[i], &out = crossings[i + 1];
    if (in.edge != out.edge || in.up > 0 || out.up < 0) continue;
    const std::size_t p = in.edge / 3, q = p + lattice.stride(in.edge % 3);
    if (before[p] || before[q]) continue;
    field.isInside[nearerEnd(lattice, in, out)] = 1;
    isAny = true;
  }
  return isAny;
}

InsideField outsideFlood(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                         const Reach& reach) {
  std::vector<char> crossed(lattice.size(), 0);  // bit by axis
  for (const EdgeCrossing& c : crossings)
    crossed[c.edge / 3] = char(crossed[c.edge / 3] | (1 << (c.edge % 3)));
  const double clearance = reach.gap / 2;
  const Distances distances(lattice, crossings);
  std::vector<char> isOutside = flooded(lattice, distances, clearance);
  growBack(distances, crossed, clearance + 1.75 * lattice.spacing(), isOutside);
  InsideField field;
  for (const char outside : isOutside) field.isInside.push_back(!outside);
  fillCavities(lattice, {}, field.isInside);
  findSheets(lattice, crossings, reach.sheets, field);
  for (const char inside : field.isInside) field.shares.push_back(inside ? 1.0F : 0.0F);
  return field;
}

}  // namespace remesher
