// SPDX-License-Identifier: MIT
// An order of vertices and triangles that depends on the surface alone, not on the order in which a
// file lists them: vertices along Hilbert's curve, those of one place by their attributes;
// triangles by their corners. Neighbours in space are neighbours in the lists.
#pragma once

#include <cstdint>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct CanonicalOrder {
  std::vector<Index> vertices;      // in the new order, by their given numbers
  std::vector<Index> numbers;       // per given vertex its new one: the first that is just the same
  std::vector<Index> triangles;     // likewise
  std::vector<std::uint8_t> turns;  // per triangle in the new order: which given corner is first
};

// The mesh must be valid. Triangles that nothing tells apart stay in the given order. The halves of
// a quad stay together.
CanonicalOrder canonicalOrder(const TriangleMesh& mesh);

TriangleMesh inOrder(const TriangleMesh& mesh, const CanonicalOrder& order);

}  // namespace remesher
