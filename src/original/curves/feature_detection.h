// SPDX-License-Identifier: MIT
// Decides which sharp edges are features: curves that are intended and worth keeping at the target
// size. An eyelid or scan noise is sharp here and there. The edges of a machine part form a network
// with hardly a loose end, between smooth faces.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct FeatureRules {
  double angle = 40;  // degrees between the normals of an edge's two faces
  double size = 0;    // the target edge length, model units
};

// One halfedge of each feature edge.
std::vector<Halfedge> detectFeatures(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                     const FeatureRules& rules);

// Vertices off the given features that are corners by themselves, such as the apex of a cone: a
// large angle is missing around them, and hardly any around their neighbours.
std::vector<Vertex> detectTips(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                               const std::vector<Halfedge>& features);

}  // namespace remesher
