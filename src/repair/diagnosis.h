// SPDX-License-Identifier: MIT
// The faults of a surface, decided exactly on its triangles. Repair and inspection share it.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/mesh_builder.h"
#include "repair/pieces.h"

namespace remesher {

struct Diagnosis {
  BuiltMesh built;
  Pieces pieces;
  std::vector<Index> crossings;  // triangles of the mesh that intersect others, ascending
  std::size_t unbalanced = 0;    // edges, see countUnbalancedEdges
};

// Throws Error as buildMesh does.
Diagnosis diagnose(const TriangleMesh& mesh);

// Whether the mesh is closed, without self-intersections, and faces outwards all over: cavities
// face into the volume, and no shell lies hidden in a body.
bool isSound(const Diagnosis& diagnosis);

// The share of the area in open pieces.
double openShare(const Diagnosis& diagnosis);

// Per kind of fault of the pieces, a corner of each piece that has it.
std::vector<Vec3> cornersOf(const Diagnosis& diagnosis, bool (*hasFault)(const SurfacePiece&));
bool isShell(const SurfacePiece& piece);
bool isInsideOut(const SurfacePiece& piece);
bool isCavity(const SurfacePiece& piece);
bool isSheet(const SurfacePiece& piece);  // open
bool isCard(const SurfacePiece& piece);   // a flat sheet of several triangles

// The triangles of the mesh in pieces with a fault, ascending.
std::vector<Index> trianglesOf(const Diagnosis& diagnosis, bool (*hasFault)(const SurfacePiece&));

struct Opening {
  double length = 0;
  Vec3 at = Vec3::Zero();  // a vertex
};

// The loops of the boundary.
std::vector<Opening> openingsOf(const BuiltMesh& built);

// A corner of each open piece, not of sheets, that encloses a negative volume once cones close its
// loops. The cones have few triangles: their sign tells as much as that of smooth lids.
std::vector<Vec3> facingInwards(const Diagnosis& diagnosis);

}  // namespace remesher
