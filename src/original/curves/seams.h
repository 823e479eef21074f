// SPDX-License-Identifier: MIT
// Edges across which an attribute jumps, a texture turns back or a material changes. They must be
// feature curves, or textures would bleed over them.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct Seams {
  std::vector<Halfedge> edges;         // one halfedge of each
  std::vector<Halfedge> jumps;         // those where an attribute other than the shading jumps
  std::vector<Halfedge> borders;       // between groups, one halfedge of each
  std::vector<std::string> chartless;  // semantics that jump across most edges and get no curves
  std::vector<Warning> warnings;       // ATTRIBUTE_HAS_NO_CHARTS for each of those
};

// Across the edges around the pole of a sphere, whose texture coordinates are a grid's, these jump
// at the pole only, and no texture bleeds over more than the corner of one triangle. Left: they are
// among the jumps, but not among the edges.
enum class Poles { Followed, Left };

// hardNormalAngle: degrees. A jump of NORMAL or TANGENT counts only where the surface itself bends
// by this angle, or along lines by 5°; elsewhere the file is merely flat-shaded.
Seams findSeams(const BuiltMesh& built, const TriangleMesh& input, double hardNormalAngle,
                Poles poles = Poles::Followed);

}  // namespace remesher
