// SPDX-License-Identifier: MIT
// Meshes in bytes, so that every input is one: a byte for the number of vertices, three floats of
// four bytes for each as they are in memory, then a byte for each corner of a triangle.
#pragma once

#include "base/triangle_mesh.h"
#include "targets.h"

namespace remesher::fuzz {

// Bytes from the front; zeros where none are left.
class ByteSource {
 public:
  explicit ByteSource(Input input) : rest_(input) {}

  bool isEmpty() const { return rest_.empty(); }
  unsigned byte();
  float real();

 private:
  Input rest_;
};

// Takes all bytes that are left, up to this number of triangles.
TriangleMesh takeMesh(ByteSource& bytes, std::size_t mostTriangles);

}  // namespace remesher::fuzz
