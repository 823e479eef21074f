// SPDX-License-Identifier: MIT
// The way to quads that always holds: triangles are joined in pairs whose common edge is most like
// the diagonal of a square along the field; pairs and the triangles left over are then divided as
// Catmull and Clark do, into quads alone. Nothing that the triangle mesh is can be lost: not its
// Euler characteristic, nor its boundaries, nor a curve.
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

// Per triangle the one it is joined with, or none: the best pairs first, then, along alternating
// paths, as many as these find. Never across a curve, and only to convex quads.
FaceData<Face> pairTriangles(const WorkingMesh& mesh, const FaceFrames& frames,
                             const CrossField& field);

// Each pair into four quads, each other triangle into three. The mesh must be compact.
QuadMesh splitPairs(const WorkingMesh& mesh, const FaceData<Face>& pairs);

}  // namespace remesher
