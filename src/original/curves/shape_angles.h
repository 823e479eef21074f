// SPDX-License-Identifier: MIT
// The angles that tell what a feature is: between the faces of an edge, and what is missing around
// a vertex. All in radians.
#pragma once

#include "mesh/halfedge_mesh.h"

namespace remesher {

// What files leave of places: an edge or a height below this is one of rounding.
double coordinateStep(const VertexData<Vec3>& positions);

// Per face the one whose normal it bears: itself, or, where it has no area, what lies beyond its
// longest edge, or beyond that.
FaceData<Face> bearingFaces(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// A face without area has the normal of the one that bears it.
FaceData<Vec3> faceNormals(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// Between the normals of the edge's two faces; 0 on a boundary.
double dihedralAngle(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals, Halfedge h);

// Per halfedge whether that is at least so large.
HalfedgeData<char> sharpEdges(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals,
                              double angle);

// What the angles around a vertex leave of a full turn, in size; 0 on a boundary.
double missingAngle(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Vertex v);

// Per vertex whether so much may be missing. At most 2π (1 − cos φ) is, where all normals around it
// are within φ of one: seen against that, an angle is wider at least by cos φ.
VertexData<char> mayMiss(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double angle);

// The share of the area whose triangles lie in one plane with a neighbor, to the precision of the
// coordinates; in [0, 1].
double coplanarShare(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// Per edge, in the order of the halfedges that name them.
std::vector<double> edgeLengths(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

}  // namespace remesher
