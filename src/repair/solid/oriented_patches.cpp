// SPDX-License-Identifier: MIT
#include "repair/solid/oriented_patches.h"

#include "mesh/components.h"

namespace remesher {

namespace {

// Six times the signed volume of each patch, from the first vertex.
std::vector<double> volumesOf(const BuiltMesh& built, const OrientedPatches& patches) {
  std::vector<double> volumes(patches.count, 0);
  const Vec3 middle = built.positions[Vertex(0)];
  for (Index f = 0; f < patches.patches.size(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    volumes[patches.patches[f]] += (built.positions[a] - middle)
                                       .cross(built.positions[b] - middle)
                                       .dot(built.positions[c] - middle);
  }
  return volumes;
}

std::vector<char> closedPatches(const BuiltMesh& built, const OrientedPatches& patches) {
  std::vector<char> isClosed(patches.count, 1);
  for (Index h = 0; h < built.mesh.halfedgeCapacity(); ++h)
    if (built.mesh.isBoundary(Halfedge(h))) isClosed[patches.patches[h / 3]] = 0;
  return isClosed;
}

}  // namespace

OrientedPatches orientedPatches(const BuiltMesh& built, const Lattice& lattice,
                                std::span<const EdgeCrossing> crossings) {
  const FaceRegions components = componentsOfFaces(built.mesh);
  OrientedPatches result;
  result.patches = components.of.values();
  result.count = components.count;
  std::vector<long> votes(result.count, 0);
  result.isSeen.assign(result.count, 0);
  forEachCrossedLine(lattice, crossings, [&](const CrossedLine& line) {
    const EdgeCrossing &first = line.crossings.front(), &last = line.crossings.back();
    votes[result.patches[first.triangle]] -= first.up;
    votes[result.patches[last.triangle]] += last.up;
    result.isSeen[result.patches[first.triangle]] = result.isSeen[result.patches[last.triangle]] =
        1;
  });
  const std::vector<double> volumes = volumesOf(built, result);
  for (std::size_t p = 0; p < result.count; ++p)
    result.turn.push_back(votes[p] != 0 ? votes[p] < 0 : volumes[p] < 0);
  result.isClosed = closedPatches(built, result);
  for (std::size_t p = 0; p < result.count; ++p)
    result.isCavity.push_back(result.isClosed[p] && !result.isSeen[p] && result.turn[p]);
  return result;
}

OrientedPatches withCavitiesKept(OrientedPatches patches) {
  for (std::size_t p = 0; p < patches.count; ++p)
    if (patches.isCavity[p]) patches.turn[p] = 0;
  return patches;
}

void turnCrossings(std::vector<EdgeCrossing>& crossings, const OrientedPatches& patches) {
  for (EdgeCrossing& crossing : crossings)
    if (patches.turn[patches.patches[crossing.triangle]]) crossing.up = -crossing.up;
}

}  // namespace remesher
