// SPDX-License-Identifier: MIT
// The way to quads that always works: triangles are joined in pairs whose common edge is most like
// the diagonal of a square along the field; then pairs and left-over triangles are divided as
// Catmull and Clark do, into quads alone. The Euler characteristic, the boundaries and the curves
// of the triangle mesh always stay.
//
//     c-----b            c--m--b        m: middles of edges, on curves and boundaries along these
//     |\    |            |  |  |        o: the middle of a pair, or of a triangle
//     |  \  |     ->     m--o--m
//     |    \|            |  |  |
//     d-----a            d--m--a
#pragma once

#include "remesh/quads/field/cross_field.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The partner of each triangle, or none. The best pairs come first; alternating paths then add as
// many as they find. No pair spans a curve, and each pair is a convex quad.
FaceData<Face> pairTriangles(const WorkingMesh& mesh, const FaceFrames& frames,
                             const CrossField& field);

// Divides each pair into four quads, each other triangle into three. The mesh must be compact.
QuadMesh splitPairs(const WorkingMesh& mesh, const FaceData<Face>& pairs);

}  // namespace remesher
