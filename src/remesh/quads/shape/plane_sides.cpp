// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/plane_sides.h"

#include <array>
#include <cmath>
#include <vector>

#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

bool isOnPlane(const QuadMesh& mesh, Index v, const MirrorPlane& plane, double slack) {
  return mesh.vertices[v].kind != VertexKind::Interior &&
         std::abs(plane.distance(mesh.position(v))) <= slack;
}

void shrinkAt(QuadMesh& mesh, Index quad, const WorkingMesh& ground) {
  shrink(mesh, quad, mesh.vertices[mesh.quads[quad].front()].at, ground);
}

// Makes the quad of a side smaller, and turns the side to end at the smaller quad's corner.
void turnOff(QuadMesh& mesh, Index side, Index other, const WorkingMesh& ground) {
  const Index near = side / 4, far = other / 4;
  shrinkAt(mesh, near, ground);
  // Between the side and the smaller quad: a, b, and the corners beside b and a.
  const Index ring = Index(mesh.quads.size()) - 4 + side % 4;
  const auto [a, b, besideB, besideA] = mesh.quads[ring];
  std::array<Index, 3> curves{};
  for (Index i = 0; i < 3; ++i) curves[i] = mesh.curves[far][(other + 1 + i) % 4];
  const Index e = mesh.quads[far][(other + 2) % 4], f = mesh.quads[far][(other + 3) % 4];
  mesh.quads[far] = {besideA, a, e, f};
  mesh.curves[far] = {kNone, curves[0], curves[1], kNone};
  mesh.quads[ring] = {f, b, besideB, besideA};
  mesh.curves[ring] = {curves[2], kNone, kNone, kNone};
}

// Each quad changes once at most.
std::size_t partAt(QuadMesh& mesh, const Mirrors& mirrors, const WorkingMesh& ground) {
  std::size_t count = 0;
  for (const MirrorPlane& plane : mirrors.planes) {
    const auto isOn = [&](Index v) { return isOnPlane(mesh, v, plane, mirrors.slack); };
    const std::vector<Four<Index>> quads = mesh.quads;
    const QuadSides sides(mesh.vertices.size(), quads);
    std::vector<char> isChanged(quads.size(), 0);
    for (Index side = 0; side < sides.size(); ++side) {
      const Index other = sides.across(side);
      if (isChanged[side / 4] || !isOn(sides.origin(side)) || !isOn(sides.tip(side))) continue;
      if (other == kNone) {
        const Index next = nextSide(side);
        if (sides.across(next) != kNone || !isOn(sides.tip(next))) continue;
        shrinkAt(mesh, side / 4, ground);
      } else {
        if (isChanged[other / 4] || mesh.curves[side / 4][side % 4] != kNone) continue;
        turnOff(mesh, side, other, ground);
        isChanged[other / 4] = 1;
      }
      isChanged[side / 4] = 1;
      ++count;
    }
  }
  return count;
}

}  // namespace

std::size_t partFromImages(QuadMesh& mesh, const Mirrors& mirrors, const WorkingMesh& ground) {
  constexpr int kRounds = 4;  // quads beside each other take turns
  std::size_t count = 0, now = 1;
  for (int round = 0; round < kRounds && now > 0; ++round)
    count += now = partAt(mesh, mirrors, ground);
  return count;
}

}  // namespace remesher
