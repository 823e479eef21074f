// SPDX-License-Identifier: MIT
#include "mesh/joints.h"

#include <algorithm>

#include "base/fires.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// If more than one edge in kMostShare is a joint closed on all sides, the sheets coincide.
constexpr std::size_t kMostShare = 8;

// Per source the number of its copies.
std::vector<Index> countCopies(const BuiltMesh& built) {
  std::vector<Index> copies;
  for (const Index source : built.sources.values()) {
    if (copies.size() <= source) copies.resize(std::size_t{source} + 1, 0);
    ++copies[source];
  }
  return copies;
}

enum class Kind : char { None, Open, Closed };

Kind kindOf(const HalfedgeMesh& mesh, std::span<const Index> group) {
  if (group.size() < 2) return Kind::None;
  const bool isOpen = std::any_of(group.begin(), group.end(),
                                  [&](Index h) { return mesh.isBoundary(Halfedge(h)); });
  if (isOpen) return Kind::Open;
  return group.size() > 2 ? Kind::Closed : Kind::None;
}

}  // namespace

std::size_t countPlaces(const BuiltMesh& built) {
  const std::vector<Index> copies = countCopies(built);
  return std::size_t(
      std::count_if(copies.begin(), copies.end(), [](Index count) { return count > 0; }));
}

std::vector<Halfedge> findJoints(const BuiltMesh& built) {
  const std::vector<Index> copies = countCopies(built);
  if (std::all_of(copies.begin(), copies.end(), [](Index count) { return count < 2; })) return {};
  const HalfedgeMesh& mesh = built.mesh;
  std::vector<Index> corners;
  corners.reserve(mesh.halfedgeCapacity());
  for (Index h = 0; h < mesh.halfedgeCapacity(); ++h)
    corners.push_back(built.sources[mesh.origin(Halfedge(h))]);
  const EdgeGroups edges(copies.size(), corners);
  std::size_t closed = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    closed += kindOf(mesh, edges[e]) == Kind::Closed ? 1 : 0;
  const bool areSheets = !built.keepsJoints && kMostShare * closed > edges.size();
  if (areSheets) fires("joints: sheets that coincide");
  std::vector<Halfedge> joints;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Kind kind = kindOf(mesh, edges[e]);
    if (kind == Kind::None || (kind == Kind::Closed && areSheets)) continue;
    for (const Index h : edges[e]) joints.emplace_back(h);
  }
  return joints;
}

}  // namespace remesher
