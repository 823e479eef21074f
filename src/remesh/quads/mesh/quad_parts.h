// SPDX-License-Identifier: MIT
// Splits meshes into connected parts, joins quads again, and puts quads around one.
#pragma once

#include <vector>

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Each connected part of a compact mesh as a mesh of its own, in the order of their lowest faces.
std::vector<WorkingMesh> connectedParts(const WorkingMesh& mesh);

// Per face of the surface the number of its connected part.
FaceData<Index> partNumbers(const HalfedgeMesh& mesh);

// Removes marked quads; the others keep their order.
void dropQuads(QuadMesh& mesh, const std::vector<char>& isGone);

// Removes vertices that no quad uses; the others keep their order.
void dropUnusedVertices(QuadMesh& mesh);

// Adds the vertices and quads of a mesh to another one.
void append(QuadMesh& mesh, const QuadMesh& other);

// The quad moves to vertices within it; four quads join it with where it was.
void surround(QuadMesh& mesh, Index quad, const Four<Index>& within);

// The quad becomes half as large; four quads join it with where it was. from: a point of the
// original near it.
void shrink(QuadMesh& mesh, Index quad, const SurfacePoint& from, const WorkingMesh& ground);

}  // namespace remesher
