// SPDX-License-Identifier: MIT
// The numbers that tell one surface from another; no legal operator may change them.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

std::size_t edgeCount(const HalfedgeMesh& mesh);
long eulerCharacteristic(const HalfedgeMesh& mesh);  // vertices − edges + faces
std::size_t componentCount(const HalfedgeMesh& mesh);
// The halfedges of each loop in order, with the surface on their left; loops by their first ones.
std::vector<std::vector<Halfedge>> boundaryLoops(const HalfedgeMesh& mesh);
std::size_t boundaryLoopCount(const HalfedgeMesh& mesh);

}  // namespace remesher
