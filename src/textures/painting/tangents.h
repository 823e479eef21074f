// SPDX-License-Identifier: MIT
// Tangents as MikkTSpace makes them [Mikkelsen 2008, Simulation of Wrinkled Surfaces Revisited],
// for normal maps are painted and read by them: at each corner the mean, weighted by angle, of the
// directions in which u grows on the triangles that share the corner's position, normal and texture
// coordinates, hang together there by edges, and are mirrored alike.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Corner after corner, three to a triangle; v grows downwards, as in glTF.
struct TangentCorners {
  std::span<const Vec3> positions;
  std::span<const Vec3> normals;  // unit
  std::span<const Vec2> texcoords;
};

// Per corner a unit tangent at right angles to the normal; w is the side that the bitangent
// w (normal × tangent) lies on: 1 or -1.
std::vector<Eigen::Vector4d> computeTangents(const TangentCorners& corners);

}  // namespace remesher
