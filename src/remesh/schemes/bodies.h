// SPDX-License-Identifier: MIT
// Several meshes of a file as one surface: a place is there once for each that has it.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

class Bodies {
 public:
  // ofGroup: per group of the input; empty: all are one. The arguments must outlive the object.
  Bodies(const TriangleMesh& input, const std::vector<Index>& ofGroup)
      : input_(input), ofGroup_(ofGroup) {}

  // The places of a mesh that was made of the input, each once in every body that has it.
  std::size_t countPlaces(const WorkingMesh& mesh) const;

 private:
  Index bodyOf(const WorkingMesh& mesh, Face face) const;

  const TriangleMesh& input_;
  const std::vector<Index>& ofGroup_;
};

}  // namespace remesher
