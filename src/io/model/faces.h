// SPDX-License-Identifier: MIT
// The faces that polygon formats write: quads if the mesh is made of quads, else triangles.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher::io {

class Faces {
 public:
  explicit Faces(const TriangleMesh& mesh) : mesh_(mesh) {}

  std::size_t count() const { return mesh_.triangleCount() / triangles(); }
  std::size_t corners() const { return mesh_.isQuads ? 4 : 3; }

  // The place of a face's corner in the mesh's indices; a quad's fourth corner is the last of its
  // two triangles.
  std::size_t place(std::size_t face, std::size_t corner) const {
    return 3 * triangle(face) + (corner == 3 ? 5 : corner);
  }
  std::size_t triangle(std::size_t face) const { return triangles() * face; }  // its first

 private:
  std::size_t triangles() const { return mesh_.isQuads ? 2 : 1; }

  const TriangleMesh& mesh_;
};

}  // namespace remesher::io
