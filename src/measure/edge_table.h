// SPDX-License-Identifier: MIT
// Connectivity for the judge, which takes any bag of triangles as it is: corners at one place
// are one vertex, and an edge lists however many triangles it has. Nothing is repaired.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Triangles over distinct places; only those that a triangle uses.
struct WeldedMesh {
  std::vector<Vec3> positions;
  std::vector<Index> indices;

  std::size_t triangleCount() const { return indices.size() / 3; }
  std::array<Index, 3> triangle(std::size_t t) const {
    return {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
  }
};

WeldedMesh weld(const TriangleMesh& mesh);

// Every edge once, with the corners opposite to it: corner 3t + k is vertex k of triangle t.
class EdgeTable {
 public:
  struct Edge {
    Index low, high;                   // the two vertices, low < high
    std::span<const Index> opposites;  // ascending
  };

  // Triangles with fewer than three distinct vertices have no edges.
  explicit EdgeTable(const WeldedMesh& mesh);

  std::size_t size() const { return begins_.size() - 1; }
  Edge operator[](std::size_t e) const;

 private:
  using Side = std::pair<Index, Index>;  // the higher vertex, and the corner opposite

  std::vector<Index> lows_;     // per edge
  std::vector<Index> highs_;    // per edge
  std::vector<Index> begins_;   // per edge and one more: the first of its opposites
  std::vector<Index> corners_;  // opposites, edge after edge
};

bool hasDistinctVertices(const std::array<Index, 3>& triangle);

}  // namespace remesher
