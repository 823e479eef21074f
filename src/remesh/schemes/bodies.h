// SPDX-License-Identifier: MIT
// Several meshes of a file as one surface: a place counts once for each mesh that has it.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

class Bodies {
 public:
  // ofGroup: the body of each input group; empty: all groups are one body. The arguments must
  // outlive the object.
  Bodies(const TriangleMesh& input, const std::vector<Index>& ofGroup)
      : input_(input), ofGroup_(ofGroup) {}

  // The number of places of a mesh made from the input; a place counts once in every body that has
  // it.
  std::size_t countPlaces(const WorkingMesh& mesh) const;

 private:
  Index bodyOf(const WorkingMesh& mesh, Face face) const;

  const TriangleMesh& input_;
  const std::vector<Index>& ofGroup_;
};

}  // namespace remesher
