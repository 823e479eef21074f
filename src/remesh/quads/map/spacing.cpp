// SPDX-License-Identifier: MIT
#include "remesh/quads/map/spacing.h"

#include <cmath>
#include <set>

namespace remesher {

namespace {

// The quarter turns from direction 0 of the cross to the curve edge.
int quartersOf(const MapInput& input, Halfedge h) {
  const double angle = input.frames.angle(h) - input.cut.angle[HalfedgeMesh::face(h)];
  return int((std::lround(angle / kQuarterTurn) % 4 + 4) % 4);
}

// The length of a curve edge in the map, along the direction of the cross that follows it.
IntegerSum lengthOf(const MapInput& input, const SeamlessSystem& system, Halfedge h) {
  const int quarters = quartersOf(input, h);
  const IntegerSum covered =
      plus(system.corner(HalfedgeMesh::next(h))[quarters % 2], system.corner(h)[quarters % 2], -1);
  return quarters < 2 ? covered : plus({}, covered, -1);
}

// The edge of the same chain that goes on where h ends.
Halfedge nextOnChain(const WorkingMesh& mesh, Halfedge h) {
  Halfedge next;
  mesh.mesh().forEachOutgoing(mesh.mesh().tip(h), [&](Halfedge out) {
    if (mesh.curve(out) == mesh.curve(h) && out != mesh.mesh().twin(h)) next = out;
  });
  return next;
}

// Whether only integer variables occur: sums ascend, and reals are numbered before integers.
bool isWholeSum(const IntegerSum& sum, const SeamlessSystem& system) {
  return sum.empty() || sum.front().first >= system.realCount();
}

// Adds the length of each part of a curve between two neighbouring places with integer coordinates.
void addCurves(std::set<IntegerSum>& lengths, const MapInput& input, const SeamlessSystem& system) {
  for (Index i = 0; i < input.mesh.mesh().halfedgeCapacity(); ++i) {
    Halfedge h(i);
    if (!input.mesh.isCurve(h)) continue;
    if (!isWholeSum(system.corner(h)[quartersOf(input, h) % 2], system)) continue;
    IntegerSum length = lengthOf(input, system, h);
    while (!isWholeSum(length, system)) {
      h = nextOnChain(input.mesh, h);
      if (!h) break;
      length = plus(length, lengthOf(input, system, h), 1);
    }
    if (isWholeSum(length, system)) lengths.insert(std::move(length));
  }
}

// Adds, of each edge whose length along a direction of the cross is a sum of integers, that length,
// if the edge runs within 60° of the direction.
void addEdges(std::set<IntegerSum>& lengths, const MapInput& input, const SeamlessSystem& system) {
  constexpr double kAlong = 0.5;  // of the edge's length
  for (Index i = 0; i < input.mesh.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const double angle = input.frames.angle(h) - input.cut.angle[HalfedgeMesh::face(h)];
    const double along[] = {std::cos(angle), std::sin(angle)};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (std::abs(along[axis]) < kAlong) continue;
      const IntegerSum covered =
          plus(system.corner(HalfedgeMesh::next(h))[axis], system.corner(h)[axis], -1);
      if (isWholeSum(covered, system)) lengths.insert(plus({}, covered, along[axis] > 0 ? 1 : -1));
    }
  }
}

}  // namespace

std::vector<IntegerSum> leastSpacings(const MapInput& input, const SeamlessSystem& system) {
  std::set<IntegerSum> lengths;
  addCurves(lengths, input, system);
  addEdges(lengths, input, system);
  lengths.erase(IntegerSum());
  return {lengths.begin(), lengths.end()};
}

}  // namespace remesher
