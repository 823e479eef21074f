// SPDX-License-Identifier: MIT
// Some triangles of a mesh as a mesh of their own, and meshes put together again.
#pragma once

#include <span>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct Submesh {
  TriangleMesh mesh;
  std::vector<Index> vertices;  // per vertex: of the whole, ascending
};

// Takes submeshes of one mesh, each in a time of its own size: a mesh may have thousands.
class Submeshes {
 public:
  // whole: must outlive the object.
  explicit Submeshes(const TriangleMesh& whole);

  // The triangles come in the order in which they are listed, with their groups and attributes.
  Submesh of(std::span<const Index> triangles);

 private:
  std::vector<Index> verticesOf(std::span<const Index> triangles);

  const TriangleMesh& whole_;
  std::vector<Index> numbers_;  // per vertex: its number in the submesh, kNone between calls
};

inline Submesh submeshOf(const TriangleMesh& whole, std::span<const Index> triangles) {
  return Submeshes(whole).of(triangles);
}

// Both with the same attributes, and both with groups or without.
void append(TriangleMesh& mesh, const TriangleMesh& more);

}  // namespace remesher
