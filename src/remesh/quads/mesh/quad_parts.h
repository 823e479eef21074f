// SPDX-License-Identifier: MIT
// Meshes by their connected parts, and quads put together again.
#pragma once

#include <vector>

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Each connected part of a compact mesh as a mesh of its own, in the order of their lowest faces.
std::vector<WorkingMesh> connectedParts(const WorkingMesh& mesh);

// Per face of the surface the number of its connected part.
FaceData<Index> partNumbers(const HalfedgeMesh& mesh);

// Quads that are marked go; the others keep their order.
void dropQuads(QuadMesh& mesh, const std::vector<char>& isGone);

// Vertices that no quad names go; the others keep their order.
void dropUnusedVertices(QuadMesh& mesh);

// Adds the vertices and quads of a mesh to another one.
void append(QuadMesh& mesh, const QuadMesh& other);

}  // namespace remesher
