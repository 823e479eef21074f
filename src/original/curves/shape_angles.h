// SPDX-License-Identifier: MIT
// The angles that decide what is a feature: the dihedral angle of an edge, and the missing angle
// around a vertex. All in radians.
#pragma once

#include "mesh/halfedge_mesh.h"

namespace remesher {

// Per face the face whose normal it takes: itself or, if it has no area, the face beyond its
// longest edge, or the next one beyond that.
FaceData<Face> bearingFaces(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// A face without area has the normal of the one that bears it.
FaceData<Vec3> faceNormals(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// Between the normals of the edge's two faces; 0 on a boundary.
double dihedralAngle(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals, Halfedge h);

// Per halfedge whether the dihedral angle is at least `angle`.
HalfedgeData<char> sharpEdges(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals,
                              double angle);

// The absolute angle defect: the difference of a full turn and the angles around a vertex; 0 on a
// boundary.
double missingAngle(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Vertex v);

// Per vertex whether `angle` may be missing. If all normals around it are within φ of one
// direction, at most 2π (1 − cos φ) is missing: projected along that direction, an angle is at
// least cos φ times as wide.
VertexData<char> mayMiss(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double angle);

// The tolerance of flatness, model units: the rounding of six digits, but always a small
// share of the edges, so that a finely divided round surface is not flat. More where some edges are
// hardly farther off and all others far.
double flatTolerance(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// The share of the area whose triangles lie in one plane with a neighbor, to that tolerance; in
// [0, 1].
double coplanarShare(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// One length per edge, in the order of the halfedges that name the edges.
std::vector<double> edgeLengths(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

}  // namespace remesher
