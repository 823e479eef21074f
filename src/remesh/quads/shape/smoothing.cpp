// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace remesher {

namespace {

// Of the way to the mean of the rectangles, for all quads are fitted before any vertex moves; and
// of the vertex's last step, which it makes again [Polyak 1964].
constexpr double kStep = 0.8;
// Directions of a search for a better place, and searches in all.
constexpr int kDirections = 8, kSearches = 5;
// The least relative gain that is worth a step.
constexpr double kGain = 0.01;

// The place of each vertex that moves on average over the rectangles of its quads.
std::vector<Vec3> targetsOf(const MovingQuads& quads, std::span<const char> isFixed) {
  const QuadMesh& mesh = quads.mesh();
  std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
  std::vector<double> counts(mesh.vertices.size(), 0);
  for (Index q = 0; q < mesh.quads.size(); ++q) {
    const auto& [a, b, c, d] = mesh.quads[q];
    if (isFixed[a] && isFixed[b] && isFixed[c] && isFixed[d]) continue;
    const Quad target = fittedRectangle(quads.corners(q), kSquareness);
    for (std::size_t i = 0; i < 4; ++i) {
      sums[mesh.quads[q][i]] += target[i];
      ++counts[mesh.quads[q][i]];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= counts[v];
  return sums;
}

double reachOf(const MovingQuads& quads, Index v) {
  double sum = 0;
  int count = 0;
  quads.sides().forEachOutgoing(v, [&](Index side) {
    sum += (quads.mesh().position(quads.sides().tip(side)) - quads.mesh().position(v)).norm();
    ++count;
  });
  return sum / count;
}

// How much the quads around v lack to 30°, squared and summed up. Quads that follow once the sum is
// `most` or more do not count.
double missingAround(const MovingQuads& quads, Index v, double most = kInfinity) {
  double sum = 0;
  quads.sides().forEachOutgoing(v, [&](Index side) {
    if (sum >= most) return;
    const double missing = std::max(0.0, kEnough - quads.quality(side / 4));
    sum += missing * missing;
  });
  return sum;
}

// Directions that v may move in, of length 1: along the surface, or along a curve.
std::vector<Vec3> waysFrom(const MovingQuads& quads, Index v) {
  std::vector<Vec3> ways;
  const Placement& here = quads.mesh().vertices[v];
  if (here.kind == VertexKind::Curve) {
    quads.sides().forEachOutgoing(v, [&](Index side) {
      if (quads.mesh().curves[side / 4][side % 4] != here.on.chain) return;
      const Vec3 way = quads.mesh().position(quads.sides().tip(side)) - here.position;
      for (const double sign : {1.0, -1.0}) ways.push_back(sign * way.normalized());
    });
    return ways;
  }
  if (!(here.normal.squaredNorm() > 0)) return {};
  const Vec3 x = here.normal.unitOrthogonal(), y = here.normal.cross(x);
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    ways.push_back(std::cos(angle) * x + std::sin(angle) * y);
  }
  return ways;
}

// Moves v to where its quads lack less, nearer places once no farther place is better. False if v
// stays where it is.
bool searchLess(MovingQuads& quads, Index v, double missing, std::size_t& tried) {
  const double gain = kGain * missing;
  bool isMoved = false;
  double reach = reachOf(quads, v) / 2;
  for (int halving = 0; halving < kSearches && missing > 0;) {
    bool isBetter = false;
    const Vec3 from = quads.mesh().position(v);
    for (const Vec3& way : waysFrom(quads, v)) {
      const auto place = quads.placeNear(v, from + reach * way);
      ++tried;
      if (!place) return isMoved;
      const Placement before = quads.mesh().vertices[v];
      quads.move(v, *place);
      const double now = missingAround(quads, v, missing - gain);
      if (now < missing - gain) {
        missing = now;
        isBetter = isMoved = true;
        break;
      }
      quads.move(v, before);
    }
    if (isBetter) continue;
    reach /= 2;
    ++halving;
  }
  return isMoved;
}

}  // namespace

void smoothToRectangles(MovingQuads& quads, int passes, std::span<const char> isFixed) {
  std::vector<Vec3> before;
  for (const Placement& place : quads.mesh().vertices) before.push_back(place.position);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Vec3> targets = targetsOf(quads, isFixed);
    for (Index v = 0; v < targets.size(); ++v) {
      if (isFixed[v]) continue;
      const Vec3 p = quads.mesh().position(v);
      const Vec3 wanted = p + kStep * (targets[v] - before[v]);
      before[v] = p;
      if (const auto place = quads.placeNear(v, wanted)) quads.moveUnlessWorse(v, *place, kEnough);
    }
  }
}

// A search that found nothing finds nothing again until a vertex of its quads moves.
std::size_t mendCorners(MovingQuads& quads, std::span<const char> isFixed) {
  const QuadMesh& mesh = quads.mesh();
  std::vector<char> isOpen(mesh.vertices.size(), 1);
  bool isDone = false;
  std::size_t tried = 0;
  for (int search = 0; search < kSearches && !isDone; ++search) {
    isDone = true;
    for (Index v = 0; v < isOpen.size(); ++v) {
      if (!isOpen[v] || isFixed[v] || mesh.vertices[v].kind == VertexKind::Corner) continue;
      const double missing = missingAround(quads, v);
      if (!(missing > 0)) continue;
      isOpen[v] = 0;
      if (!searchLess(quads, v, missing, tried)) continue;
      isDone = false;
      quads.sides().forEachOutgoing(v, [&](Index side) {
        for (const Index w : mesh.quads[side / 4]) isOpen[w] = 1;
      });
    }
  }
  return tried;
}

}  // namespace remesher
