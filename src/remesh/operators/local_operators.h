// SPDX-License-Identifier: MIT
// The four operators [report, "Primitive Strategies"]. Each proposes: it checks legality, which
// depends on connectivity and on the vertices' kinds, works out the new place, and describes the
// change in `change`. It returns whether there is anything to propose. Nothing is modified.
//
// What may happen to which kind of vertex:
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

// At the middle of the edge.
bool proposeSplit(const WorkingMesh& mesh, Projector& projector, Halfedge h, LocalChange& change);

// At that place: needs no projection.
bool proposeSplitAt(const WorkingMesh& mesh, const Placement& place, Halfedge h,
                    LocalChange& change);

// At the middle of the edge between equals, else at the end that may not move. A pinned vertex
// neither moves nor goes.
bool proposeCollapse(const WorkingMesh& mesh, Projector& projector, Halfedge h,
                     LocalChange& change);

// At the far end, which stays as it is: needs no projection.
bool proposeCollapseInto(const WorkingMesh& mesh, Halfedge h, LocalChange& change);

// A point of the triangle of h, by the weights of its corners, first that at origin(h).
struct StarPoint {
  Halfedge h;
  Vec3 weights;
};

// To the point with `weights` in the triangle of h, which leaves the vertex. For interior vertices.
bool proposeRelocation(const WorkingMesh& mesh, Projector& projector, const StarPoint& to,
                       LocalChange& change);

// Of any vertex, to a place that the caller has found.
void proposePlacement(const WorkingMesh& mesh, Vertex v, const Placement& place,
                      LocalChange& change);

// The place halfway between the two ends of an edge: on its curve or on the surface.
Placement midpoint(const WorkingMesh& mesh, Projector& projector, Halfedge h);

}  // namespace remesher
