// SPDX-License-Identifier: MIT
// Which way the pieces of a surface face, decided by what is seen of them from outside [the idea of
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
  // Per patch: the wall of a cavity, for it is closed, not seen, and faces into what it encloses.
  std::vector<char> isCavity;
};

// Patches hang together across edges of two triangles. What is not seen faces away from the volume
// that it encloses, cavities too.
OrientedPatches orientedPatches(const BuiltMesh& built, const Lattice& lattice,
                                std::span<const EdgeCrossing> crossings);

// The same, but that walls of cavities stay as they are given.
OrientedPatches withCavitiesKept(OrientedPatches patches);

// Turns crossings with their triangles.
void turnCrossings(std::vector<EdgeCrossing>& crossings, const OrientedPatches& patches);

}  // namespace remesher
