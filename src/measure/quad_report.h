// SPDX-License-Identifier: MIT
// Quality figures of quads for the report, over any number of meshes.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/welding.h"

namespace remesher {

class QuadStatistics {
 public:
  // mesh: made of quads.
  void add(const TriangleMesh& mesh, const Welding& welding);
  QuadReport report() const;

 private:
  std::size_t count_ = 0, irregular_ = 0;
  std::size_t loops_ = 0, longest_ = 0, edges_ = 0, selfCrossing_ = 0;
  std::vector<double> deviations_;  // of each corner, degrees
  std::vector<double> worstSines_;  // of each quad
  std::vector<double> lengths_;     // of each side
};

}  // namespace remesher
