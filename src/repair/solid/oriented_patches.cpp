// SPDX-License-Identifier: MIT
#include "repair/solid/oriented_patches.h"

#include "base/disjoint_sets.h"

namespace remesher {

namespace {

OrientedPatches patchesOf(const BuiltMesh& built) {
  const std::size_t faces = built.mesh.faceCapacity();
  DisjointSets sets(faces);
  for (Index h = 0; h < built.mesh.halfedgeCapacity(); ++h)
    if (const Halfedge twin = built.mesh.twin(Halfedge(h)))
      sets.unite(h / 3, HalfedgeMesh::face(twin).index);
  OrientedPatches result;
  result.patches.resize(faces);
  for (Index f = 0; f < faces; ++f)
    result.patches[f] = sets.find(f) == f ? Index(result.count++) : result.patches[sets.find(f)];
  return result;
}

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
  OrientedPatches result = patchesOf(built);
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
