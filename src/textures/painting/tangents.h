// SPDX-License-Identifier: MIT
// Tangents as MikkTSpace makes them [Mikkelsen 2008, Simulation of Wrinkled Surfaces Revisited],
// because normal maps are painted and read with them. At each corner: the mean, weighted by angle,
// of the directions in which u grows on the triangles that share the corner's position, normal and
// texture coordinates, are connected there by edges, and have the same mirroring.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Corner after corner, three per triangle; v grows downwards, as in glTF.
struct TangentCorners {
  std::span<const Vec3> positions;
  std::span<const Vec3> normals;  // unit
  std::span<const Vec2> texcoords;
};

// Per corner a unit tangent perpendicular to the normal. w is 1 or -1: the bitangent is w (normal ×
// tangent).
std::vector<Eigen::Vector4d> computeTangents(const TangentCorners& corners);

}  // namespace remesher
