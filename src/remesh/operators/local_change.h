// SPDX-License-Identifier: MIT
// A change that an operator proposes, as a value: proposing changes nothing. The fidelity gate
// judges the proposal, and only an accepted change is applied. One object serves many proposals and
// keeps its buffers.
#pragma once

#include <array>
#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

enum class Operation : char { Flip, Split, Collapse, Relocate };

// Stands for the moved or new vertex among the corners of coming triangles.
inline constexpr Vertex kMoved{};

struct LocalChange {
  Operation operation = Operation::Relocate;
  Halfedge halfedge;        // flip, split, collapse: where
  Vertex vertex;            // relocate: the vertex that moves
  Placement place;          // of the moved or new vertex; unused by a flip
  std::vector<Face> going;  // triangles that change; not the two that a collapse removes
  std::vector<std::array<Vertex, 3>> coming;  // what replaces them

  void reset(Operation what) {
    operation = what;
    going.clear();
    coming.clear();
  }
};

// The position of a corner of a coming triangle.
inline const Vec3& positionAfter(const WorkingMesh& mesh, const LocalChange& change, Vertex v) {
  return v == kMoved ? change.place.position : mesh.position(v);
}

// All triangles that the change takes away: those that change, and beside a collapsing edge those
// that vanish.
std::vector<Face> removedFaces(const HalfedgeMesh& mesh, const LocalChange& change);

// Carries out an accepted change. Returns the vertex it made, moved or kept; none for a flip.
Vertex apply(WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
