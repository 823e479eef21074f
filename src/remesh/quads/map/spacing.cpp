// SPDX-License-Identifier: MIT
#include "remesh/quads/map/spacing.h"

#include <cmath>
#include <numbers>
#include <set>

namespace remesher {

namespace {

// How far the map goes along an edge of a curve: along the direction of the cross that follows it.
IntegerSum lengthOf(const MapInput& input, const SeamlessSystem& system, Halfedge h) {
  const double angle = input.frames.angle(h) - input.cut.angle[HalfedgeMesh::face(h)];
  const long quarters = std::lround(angle / (std::numbers::pi / 2));
  const std::size_t axis = quarters % 2 == 0 ? 0 : 1;
  const IntegerSum gone =
      plus(system.corner(HalfedgeMesh::next(h))[axis], system.corner(h)[axis], -1);
  return ((quarters % 4) + 4) % 4 < 2 ? gone : plus({}, gone, -1);
}

// The edge of the same chain that goes on where h ends.
Halfedge nextOnChain(const WorkingMesh& mesh, Halfedge h) {
  Halfedge next;
  mesh.mesh().forEachOutgoing(mesh.mesh().tip(h), [&](Halfedge out) {
    if (mesh.curve(out) == mesh.curve(h) && out != mesh.mesh().twin(h)) next = out;
  });
  return next;
}

}  // namespace

std::vector<IntegerSum> chainLengths(const MapInput& input, const SeamlessSystem& system) {
  const HalfedgeMesh& m = input.mesh.mesh();
  std::vector<IntegerSum> lengths;
  std::set<Index> seen;
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    Halfedge h(i);
    if (!input.mesh.isCurve(h) || input.mesh.kind(m.origin(h)) != VertexKind::Corner) continue;
    if (!seen.insert(input.mesh.curve(h)).second) continue;
    IntegerSum length = lengthOf(input, system, h);
    while (h && input.mesh.kind(m.tip(h)) != VertexKind::Corner) {
      h = nextOnChain(input.mesh, h);
      if (h) length = plus(length, lengthOf(input, system, h), 1);
    }
    const bool isWhole = !length.empty() && length.front().first >= system.realCount();
    if (h && isWhole) lengths.push_back(std::move(length));
  }
  return lengths;
}

}  // namespace remesher
