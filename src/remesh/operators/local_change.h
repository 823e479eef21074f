// SPDX-License-Identifier: MIT
// What an operator wants to do, as a value: nothing is changed by proposing. The fidelity gate
// judges it; only an accepted change is applied. One object serves many proposals and keeps its
// buffers.
#pragma once

#include <array>
#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

enum class Operation : char { Flip, Split, Collapse, Relocate };

// The corner of a coming triangle that is the moved or the new vertex is written as kMoved.
inline constexpr Vertex kMoved{};

struct LocalChange {
  Operation operation = Operation::Relocate;
  Halfedge halfedge;                          // flip, split, collapse: where
  Vertex vertex;                              // relocate: who
  Placement place;                            // of the moved or new vertex; unused by a flip
  std::vector<Face> going;                    // triangles that vanish or change
  std::vector<std::array<Vertex, 3>> coming;  // what they become

  void reset(Operation what) {
    operation = what;
    going.clear();
    coming.clear();
  }
};

// Where a corner of a coming triangle will be.
inline const Vec3& positionAfter(const WorkingMesh& mesh, const LocalChange& change, Vertex v) {
  return v == kMoved ? change.place.position : mesh.position(v);
}

// Carries out an accepted change. Returns the vertex it made, moved or kept; none for a flip.
Vertex apply(WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
