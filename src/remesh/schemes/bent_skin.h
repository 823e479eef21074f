// SPDX-License-Identifier: MIT
// A skinned mesh as it moves: a collapse that hardly shows at rest may show where a joint bends.
#pragma once

#include <map>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Poses in which each joint is bent by a quarter turn about one of the three axes, neighbours about
// others. Each bends about the middle of the vertices that it shares with other joints.
class BentSkin {
 public:
  static constexpr int kPoses = 3;

  // The mesh has JOINTS_0 and WEIGHTS_0 of four; it must outlive the object.
  explicit BentSkin(const TriangleMesh& mesh);

  // Whether this is such a mesh.
  static bool has(const TriangleMesh& mesh);

  // How far a pose moves a vertex.
  Vec3 movement(std::size_t vertex, int pose) const;

 private:
  struct Joint {
    Vec3 middle = Vec3::Zero();
    double share = 0;
    int number = 0;
  };

  const TriangleMesh& mesh_;
  const std::vector<float>&joints_, &weights_;  // four per vertex
  std::map<float, Joint> bends_;
};

}  // namespace remesher
