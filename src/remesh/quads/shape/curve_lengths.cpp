// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/curve_lengths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "remesh/operators/smoothing.h"
#include "remesh/quads/shape/quad_star.h"
#include "remesh/quads/shape/side_places.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// Sides are clearly shorter than the best chords if they lose so many times as much of the curve's
// length, and this share of it more.
constexpr double kLengthLoss = 1.8, kLengthShare = 2.5e-3;
// Or only this share of it, where the best chords lose nothing but roundings.
constexpr double kExactShare = 1e-3, kRoundings = 1e-6;
// Of the way to the best chords, in as many steps.
constexpr int kSlides = 4;
// A curve is straight where it turns by less than this; straight pieces are about even if none is
// longer than another by this factor.
constexpr double kBend = radians(1), kAboutEven = 2;

// Sides that follow a chain one after another.
struct Path {
  Index chain;
  std::vector<Index> vertices;
  std::vector<double> arcs;  // increasing
  std::vector<double> best = {};

  double length() const { return arcs.back() - arcs.front(); }
};

// The sides along each chain, by the arc at which they begin.
std::vector<Path> pathsOf(const QuadMesh& mesh, const WorkingMesh& ground) {
  std::map<std::pair<Index, double>, std::pair<Index, Index>> sides;
  for (Index q = 0; q < mesh.quads.size(); ++q)
    for (Index i = 0; i < 4; ++i) {
      const Index chain = mesh.curves[q][i];
      if (chain == kNone) continue;
      Index a = mesh.quads[q][i], b = mesh.quads[q][(i + 1) % 4];
      const auto arcAt = [&](Index v) { return onChain(mesh.vertices[v], chain, ground).arc; };
      if (arcAt(b) < arcAt(a)) std::swap(a, b);
      sides[{chain, arcAt(a)}] = {a, b};
    }
  std::vector<Path> paths;
  for (const auto& [begin, ends] : sides) {
    const auto [chain, arc] = begin;
    const bool isNext =
        !paths.empty() && paths.back().chain == chain && paths.back().vertices.back() == ends.first;
    if (!isNext) paths.push_back({chain, {ends.first}, {arc}});
    paths.back().vertices.push_back(ends.second);
    paths.back().arcs.push_back(onChain(mesh.vertices[ends.second], chain, ground).arc);
  }
  return paths;
}

// The arcs at which the path's curve bends, between those of its ends.
std::vector<double> bendsOf(const Path& path, const OriginalSurface& surface) {
  const Chain& chain = surface.curves().chains()[path.chain];
  const double margin = kRoom * path.length() / double(path.arcs.size());
  std::vector<double> bends = {path.arcs.front()};
  for (std::size_t i = 1; i + 1 < chain.vertices.size(); ++i) {
    const double arc = chain.arcs[i];
    if (arc < path.arcs.front() + margin || arc > path.arcs.back() - margin) continue;
    const auto at = [&](std::size_t k) { return surface.positions()[chain.vertices[k]]; };
    const Vec3 in = at(i) - at(i - 1), out = at(i + 1) - at(i);
    if (std::atan2(in.cross(out).norm(), in.dot(out)) > kBend) bends.push_back(arc);
  }
  bends.push_back(path.arcs.back());
  return bends;
}

bool areAboutEven(const std::vector<double>& ends) {
  double shortest = kInfinity, longest = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    shortest = std::min(shortest, ends[i] - ends[i - 1]);
    longest = std::max(longest, ends[i] - ends[i - 1]);
  }
  return longest <= kAboutEven * shortest;
}

// Even arcs; or where the curve has about even straight pieces, with as many sides for each, its
// bends and even arcs between these.
std::vector<double> bestArcs(const Path& path, const OriginalSurface& surface) {
  const std::size_t sides = path.arcs.size() - 1;
  std::vector<double> ends = bendsOf(path, surface);
  if (sides % (ends.size() - 1) != 0 || !areAboutEven(ends)) ends = {ends.front(), ends.back()};
  const std::size_t each = sides / (ends.size() - 1);
  std::vector<double> arcs;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t piece = i / each;
    const double share = double(i % each) / double(each);
    arcs.push_back(ends[piece] + share * (ends[piece + 1] - ends[piece]));
  }
  arcs.push_back(ends.back());
  return arcs;
}

// The length of chords so far on the way to the best: 0 where the vertices are, 1 for the best.
double chordsAt(const Path& path, double share, const WorkingMesh& ground) {
  double sum = 0;
  Vec3 last = Vec3::Zero();
  for (std::size_t i = 0; i < path.arcs.size(); ++i) {
    const double arc = path.arcs[i] + share * (path.best[i] - path.arcs[i]);
    const Vec3 p = ground.onCurve({path.chain, arc}).position;
    if (i > 0) sum += (p - last).norm();
    last = p;
  }
  return sum;
}

// 0 if the sides are long enough.
double shareToBest(const Path& path, const WorkingMesh& ground) {
  const double lost = path.length() - chordsAt(path, 1, ground);
  const bool isExact = lost < kRoundings * path.length();
  const double most =
      isExact ? kExactShare * path.length() : kLengthLoss * lost + kLengthShare * path.length();
  for (int i = 0; i < kSlides; ++i) {
    const double share = double(i) / kSlides;
    if (path.length() - chordsAt(path, share, ground) <= most) return share;
  }
  return 1;
}

// All vertices but the inner ones of the quads beside the path, and of those beside these.
std::vector<char> farFrom(const Path& path, const MovingQuads& quads) {
  constexpr std::size_t kRingsAround = 3;
  const std::vector<Placement>& vertices = quads.mesh().vertices;
  std::vector<Index> near = path.vertices;
  std::vector<char> isFar(vertices.size(), 1);
  for (std::size_t begin = 0, ring = 0; ring < kRingsAround; ++ring) {
    const std::size_t end = near.size();
    for (; begin < end; ++begin)
      quads.sides().forEachOutgoing(near[begin], [&](Index side) {
        for (const Index v : quads.mesh().quads[side / 4])
          if (vertices[v].kind == VertexKind::Interior && std::exchange(isFar[v], 0) != 0)
            near.push_back(v);
      });
  }
  return isFar;
}

// Slides the vertices along; whether all quads are as sound as before, or sound enough.
bool slide(QuadMesh& mesh, const Path& path, double share, const WorkingMesh& ground) {
  MovingQuads moving(mesh, ground);
  std::vector<double> before;
  for (Index q = 0; q < mesh.quads.size(); ++q) before.push_back(moving.quality(q));
  const std::vector<char> isFixed = farFrom(path, moving);
  for (int step = 1; step <= kSlides; ++step) {
    for (std::size_t i = 1; i + 1 < path.vertices.size(); ++i) {
      const double way = share * step / kSlides * (path.best[i] - path.arcs[i]);
      moving.move(path.vertices[i], ground.onCurve({path.chain, path.arcs[i] + way}));
    }
    smoothToRectangles(moving, kSmoothingSweeps / kSlides, isFixed);
  }
  mendCorners(moving, isFixed);
  for (Index q = 0; q < mesh.quads.size(); ++q)
    if (moving.quality(q) < std::min(before[q], kEnough)) return false;
  return true;
}

}  // namespace

void keepCurveLengths(QuadMesh& quads, const WorkingMesh& ground) {
  for (Path& path : pathsOf(quads, ground)) {
    path.best = bestArcs(path, ground.surface());
    double share = shareToBest(path, ground);
    const std::vector<Placement> before = quads.vertices;
    for (; share > 0 && !slide(quads, path, share, ground); share -= 1.0 / kSlides)
      quads.vertices = before;
  }
}

}  // namespace remesher
