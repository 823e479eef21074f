// SPDX-License-Identifier: MIT
#include "remesh/quads/map/seamless_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "mesh/topology.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/map/loop_search.h"
#include "remesh/quads/map/spacing.h"
#include "remesh/quads/map/untangle.h"

namespace remesher {

namespace {

// Dense work grows with the third power: this many variables take about a second per map.
constexpr Index kMostIntegers = 1500;
// Multiplications of all maps of a surface. A hundred integer variables take a thousandth of it: it
// limits surfaces of many curves and handles only.
constexpr double kMostMapWork = 4e9;

MapPoint turned(const MapPoint& p, int turn) {
  switch (turn) {
    case 0:
      return p;
    case 1:
      return {-p.v, p.u};
    case 2:
      return {-p.u, -p.v};
    default:
      return {p.v, -p.u};
  }
}

// Whether whole numbers hold the values, and sums of some: a system that is nearly singular has
// values without bounds.
bool areBounded(const Eigen::VectorXd& values) {
  constexpr double kMost = 0x1p34;
  return values.size() == 0 || (values.allFinite() && values.cwiseAbs().maxCoeff() < kMost);
}

// Whether all triangles are small enough for exact areas: where surfaces are wild, maps fold far.
bool isExact(const SeamlessMap& map) {
  for (Index i = 0; i < map.corners.size(); ++i) {
    const MapPoint edge = map.corners[HalfedgeMesh::next(Halfedge(i))] - map.corners[Halfedge(i)];
    if (std::max(std::abs(edge.u), std::abs(edge.v)) >= kLongest) return false;
  }
  return true;
}

}  // namespace

MapPoint Transition::operator()(const MapPoint& p) const { return turned(p, turn) + shift; }

Transition after(const Transition& first, const Transition& second) {
  return {(first.turn + second.turn) % 4, second(first.shift)};
}

Transition SeamlessMap::across(const HalfedgeMesh& mesh, Halfedge h) const {
  const MapPoint there = corners[HalfedgeMesh::next(mesh.twin(h))];
  return {turn[h], there - turned(corners[h], turn[h])};
}

MapMaker::MapMaker(const WorkingMesh& mesh, const CrossField& field, FaceData<double> sizes)
    : mesh_(mesh),
      frames_(mesh),
      sizes_(std::move(sizes)),
      singular_(quarterIndices(field, mesh, frames_)),
      cut_(cutOpen(mesh, field, singular_)),
      system_({mesh, frames_, cut_, singular_}) {
  if (!system_.isSolvable() || system_.count() - system_.realCount() > kMostIntegers) return;
  const auto [matrix, right] = system_.quadratic(sizes_);
  rounding_ = std::make_unique<Rounding>(matrix, right, system_.realCount());
  if (rounding_->isSolvable())
    rounding_->require(leastSpacings({mesh, frames_, cut_, singular_}, system_));
  else
    rounding_.reset();
}

void MapMaker::setSizes(FaceData<double> sizes) {
  sizes_ = std::move(sizes);
  rounding_->aim(system_.quadratic(sizes_).right);
}

std::optional<SeamlessMap> MapMaker::map(double length, std::span<const double> known) const {
  Eigen::VectorXd values = rounding_->rounded(1 / length);
  double mark = 0;  // no few integers make up for each other in a sum of roots
  for (Index i = system_.realCount(); i < Index(values.size()); ++i)
    mark += std::sqrt(double(i)) * values[i];
  if (std::find(known.begin(), known.end(), mark) != known.end()) return {};
  std::optional<SeamlessMap> map = unfolded(std::move(values), length);
  if (map) map->mark = mark;
  return map;
}

std::optional<SeamlessMap> MapMaker::mapOf(const Eigen::VectorXd& integers, double length) const {
  return unfolded(rounding_->withReals(integers, 1 / length), length);
}

std::vector<Eigen::VectorXd> MapMaker::withShorterLoops(const SeamlessMap& map, double vertices,
                                                        double slack) const {
  const auto mapOf = [&](const Eigen::VectorXd& values) { return inIntegers(values); };
  return searchShorterLoops({mesh_, singular_, cut_, system_}, *rounding_,
                            {map.integers, map.length, mapOf}, {vertices, slack});
}

std::optional<SeamlessMap> MapMaker::unfolded(Eigen::VectorXd values, double length) const {
  untangle(values, {mesh_, frames_, system_, sizes_, length});
  if (!areBounded(values)) return {};
  SeamlessMap map = inIntegers(values);
  if (!isExact(map)) return {};
  map.integers = values.tail(values.size() - Eigen::Index(system_.realCount()));
  map.length = length;
  return map;
}

// Real variables become odd integers, in units of 1/kUnit: then no corner is in the middle between
// two integers, where walks over the map begin.
SeamlessMap MapMaker::inIntegers(const Eigen::VectorXd& values) const {
  std::vector<Fixed> integers;
  for (Index i = 0; i < Index(values.size()); ++i)
    integers.push_back(i < system_.realCount()
                           ? 2 * Fixed(std::floor(values[i] * (double(kUnit) / 2))) + 1
                           : Fixed(std::llround(values[i])) * kUnit);
  const HalfedgeMesh& m = mesh_.mesh();
  SeamlessMap map;
  map.corners = HalfedgeData<MapPoint>(m.halfedgeCapacity());
  map.turn = cut_.turn;
  const auto valueOf = [&](const IntegerSum& sum) {
    Fixed value = 0;
    for (const auto& [variable, coefficient] : sum) value += coefficient * integers[variable];
    return value;
  };
  for (Index h = 0; h < m.halfedgeCapacity(); ++h) {
    const auto& [u, v] = system_.corner(Halfedge(h));
    map.corners[Halfedge(h)] = {valueOf(u), valueOf(v)};
  }
  return map;
}

bool MapMaker::isSpent() const { return rounding_->work() > kMostMapWork; }

std::size_t MapMaker::singularCount() const {
  std::size_t count = 0;
  for (Index v = 0; v < singular_.size(); ++v) count += singular_[Vertex(v)] != 0;
  return count;
}

// V = χ + F + B/2, B the number of edges on boundaries: from Euler's formula and 4F = 2E − B.
double MapMaker::countVertices(const SeamlessMap& map) const {
  const HalfedgeMesh& m = mesh_.mesh();
  double twiceArea = 0, boundary = 0;
  for (Index f = 0; f < m.faceCapacity(); ++f) twiceArea += double(map.area(Face(f)));
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    if (!m.isBoundary(Halfedge(i))) continue;
    const MapPoint edge = map.corners[HalfedgeMesh::next(Halfedge(i))] - map.corners[Halfedge(i)];
    boundary += std::abs(double(edge.u)) + std::abs(double(edge.v));
  }
  const double unit = double(kUnit);
  return double(eulerCharacteristic(m)) + twiceArea / (2 * unit * unit) + boundary / (2 * unit);
}

}  // namespace remesher
