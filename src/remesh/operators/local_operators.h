// SPDX-License-Identifier: MIT
// The four operators [DGP 2016, "Primitive Strategies"]. Each function checks legality, which
// depends on connectivity and on the vertices' kinds, computes the new place and describes the
// change in `change`. It returns whether there is a proposal. The mesh is not modified.
//
// The operators that may touch each kind of vertex:
//             interior          curve                          corner
//   relocate  on the surface    along its curve                never
//   collapse  into any          along a curve edge, into       never; takes the other end in
//                               a curve vertex or a corner     along any edge
//   flip      edges off the curves only
//   split     any edge but of a kept boundary; the new vertex of a curve edge is a curve vertex
#pragma once

#include "remesh/operators/local_change.h"
#include "remesh/operators/projection.h"

namespace remesher {

bool proposeFlip(const WorkingMesh& mesh, Halfedge h, LocalChange& change);

// Splits the edge at its midpoint.
bool proposeSplit(const WorkingMesh& mesh, Projector& projector, Halfedge h, LocalChange& change);

// Both ends meet at the edge's midpoint if they are of one kind and the tip is not pinned, else at
// the tip. A pinned vertex neither moves nor vanishes.
bool proposeCollapse(const WorkingMesh& mesh, Projector& projector, Halfedge h,
                     LocalChange& change);

// Both ends meet at the tip, which stays as it is, without projection.
bool proposeCollapseInto(const WorkingMesh& mesh, Halfedge h, LocalChange& change);

// Whether v is an inner vertex and lies on no curve that is kept as it is.
bool mayBeReleased(const WorkingMesh& mesh, Vertex v);

// The same as before for any vertex that may be released, whatever curves lie there: it has to be
// released before the change is carried out.
bool proposeUnion(const WorkingMesh& mesh, Halfedge h, LocalChange& change);

// A point of face(h) by its barycentric weights, the first one for origin(h).
struct StarPoint {
  Halfedge h;
  Vec3 weights;
};

// Moves the interior vertex origin(to.h) to the projection of `to`.
bool proposeRelocation(const WorkingMesh& mesh, Projector& projector, const StarPoint& to,
                       LocalChange& change);

// Moves any vertex to a place that the caller has found.
void proposePlacement(const WorkingMesh& mesh, Vertex v, const Placement& place,
                      LocalChange& change);

// The place halfway between the two ends of an edge: on its curve or on the surface.
Placement midpoint(const WorkingMesh& mesh, Projector& projector, Halfedge h);

}  // namespace remesher
