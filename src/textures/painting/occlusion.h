// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of light from all sides, by Lambert's law, that reaches a place of a
// mesh past the mesh itself. Each texel casts a few rays of a fixed set; neighbours cast others,
// and the means over small squares of neighbours on the same surface are those of the whole set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/triangle_tree.h"
#include "io/model/material.h"

namespace remesher {

// Rays end after this share of the diagonal: surfaces farther away, such as the walls of a room,
// darkens nothing.
inline constexpr double kOcclusionReach = 0.25;

class OcclusionMap {
 public:
  OcclusionMap(std::span<const Vec3> positions, std::span<const Index> indices);

  // The share of the rays of a texel that nothing stops. normal: unit.
  double openness(const Vec3& place, const Vec3& normal, Index column, Index row) const;

 private:
  TriangleTree tree_;
  double reach_, lift_;
};

// A texel's openness, and the place where it is.
struct OccludedTexel {
  float open = 1;
  Eigen::Vector3f place = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
};

// Per texel the mean over its neighbours that lie on the same surface. owners: kNone where there is
// nothing.
std::vector<float> meansOver(std::span<const OccludedTexel> texels, std::span<const Index> owners,
                             Index size);

}  // namespace remesher
