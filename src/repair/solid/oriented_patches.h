// SPDX-License-Identifier: MIT
// Which way the pieces of a surface face, decided by their triangles seen from outside [the idea of
// ray votes: Takayama et al., A Simple Method for Correcting Facet Orientations in Polygon Meshes
// Based on Ray Casting, JCGT 2014]. The rays are the lines of a lattice: the first and the last
// triangle on each is seen.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"
#include "repair/solid/crossings_of_edges.h"

namespace remesher {

struct OrientedPatches {
  std::vector<Index> patches;  // per face of the built mesh: which piece it belongs to
  std::size_t count = 0;
  std::vector<char> turn;      // per patch: whether it faces the wrong way
  std::vector<char> isSeen;    // per patch: from outside
  std::vector<char> isClosed;  // per patch
  // Per patch: whether it is the wall of a cavity: closed, not seen, and facing into the volume
  // that it encloses.
  std::vector<char> isCavity;
};

// Patches are connected across edges of two triangles. A patch that is not seen is turned to face
// away from the volume that it encloses, also the wall of a cavity.
OrientedPatches orientedPatches(const BuiltMesh& built, const Lattice& lattice,
                                std::span<const EdgeCrossing> crossings);

// The same patches, but walls of cavities face as given.
OrientedPatches withCavitiesKept(OrientedPatches patches);

// Turns the crossings of turned patches.
void turnCrossings(std::vector<EdgeCrossing>& crossings, const OrientedPatches& patches);

}  // namespace remesher
