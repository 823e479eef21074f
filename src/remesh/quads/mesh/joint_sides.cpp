// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/joint_sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace remesher {

namespace {

// By their places along a chain.
using OnSide = std::vector<std::pair<double, Vertex>>;

// Moves the vertices of a side to the places of others, if both are on the same line: else they
// belong to different borders. Both have as many vertices, the others in the order of the side.
void meet(WorkingMesh& mesh, Index chain, const OnSide& side, const OnSide& others) {
  constexpr double kSame = 1e-9;
  const double length = mesh.surface().curves().chains()[chain].length();
  std::vector<Placement> places;
  for (const auto& [arc, v] : others) {
    places.push_back(mesh.onCurve({chain, arc}));
    if (!((places.back().position - mesh.position(v)).norm() < kSame * length)) return;
    places.back().position = mesh.position(v);
  }
  for (std::size_t i = 0; i < side.size(); ++i) mesh.move(side[i].second, places[i]);
}

}  // namespace

void meetAtJoints(WorkingMesh& mesh) {
  const std::vector<Chain>& chains = mesh.surface().curves().chains();
  std::vector<OnSide> on(chains.size());
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (const Vertex v(i); mesh.kind(v) == VertexKind::Curve)
      on[mesh.on(v).chain].emplace_back(mesh.on(v).arc, v);
  using Ends = std::array<double, 6>;
  const auto endsOf = [&](const Chain& chain, bool isTurned) {
    Vec3 a = mesh.surface().positions()[chain.vertices.front()];
    Vec3 b = mesh.surface().positions()[chain.vertices.back()];
    if (isTurned) std::swap(a, b);
    return Ends{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
  };
  std::map<Ends, std::vector<Index>> known;
  for (Index c = 0; c < chains.size(); ++c) {
    if (!chains[c].boundary) continue;
    std::sort(on[c].begin(), on[c].end());
    for (const bool isTurned : {false, true})
      for (const Index other : known[endsOf(chains[c], isTurned)]) {
        if (on[other].size() != on[c].size()) continue;
        OnSide others = on[other];
        if (isTurned) std::reverse(others.begin(), others.end());
        for (auto& [arc, v] : others)
          if (isTurned) arc = chains[c].length() - arc;
        meet(mesh, c, on[c], others);
      }
    known[endsOf(chains[c], false)].push_back(c);
  }
}

}  // namespace remesher
