// SPDX-License-Identifier: MIT
// Collapses edges, those first that change the shape least: for a result whose isotropic triangles
// would be larger than the original's details.
#pragma once

#include <optional>
#include <vector>

#include "mesh/halfedge_mesh.h"
#include "simplify/boundary_places.h"

namespace remesher {

// What an edge is the border of. Across a jump nothing changes but values such as colours.
enum Seam : char { kNoSeam, kJump, kSeam };

struct SimpleSurface {
  HalfedgeMesh mesh;
  VertexData<Vec3> positions;
  // Of both halfedges: a Seam. Without attributes, triangles between seams must remain.
  HalfedgeData<char> seams;
  VertexData<char> held = {};  // vertices that neither move nor go; empty: none
  // Per face the mesh of a file that it is of; empty: all are of one. Each mesh keeps a triangle.
  FaceData<Index> bodies = {};
  // Of the surface that was given first; set where vertices move.
  std::optional<BoundaryPlaces> boundary = {};
};

// Attributes that vertices keep, scaled to lengths: an attribute error of 1 is seen as much as a
// surface error of 1.
struct KeptAttributes {
  HalfedgeData<Index> wedges;  // per corner: the wedge whose attributes it has
  std::size_t itemSize = 0;    // values per wedge
  std::vector<double> values;  // of all wedges
};

// A vertex counts once for each body that has it.
std::size_t countVertices(const SimpleSurface& surface);

// Collapses vertices into their neighbours until no more than `vertices` are left or nothing more
// goes; with bodies, never fewer. The neighbour moves to the minimum of the squared distances from
// the planes of all triangles merged into it, and from sharp edges and borders [Garland & Heckbert
// 1997]; of a boundary, along the boundary loop that was given first. Boundaries and seams are only
// shortened along themselves; vertices where seams meet stay. With attributes no vertex moves, and
// collapses that change attributes more come later [Hoppe 1999]; edges across which attributes jump
// must be seams, and a jump is worth no more than the values differ. Vertices where seams meet go
// too then, along a seam, and those of a boundary along it: corners of charts on neither side keep
// their wedge, now at the place of another vertex.
void simplify(SimpleSurface& surface, std::size_t vertices, KeptAttributes* kept = nullptr);

// The costs of the collapses that simplify() does until nothing more goes, none below the one
// before: the sum of squared distances, each times the area that it stands for, times the square
// root of that area. Unit: the fifth power of a length. The surface is left simplified.
std::vector<double> collapseCosts(SimpleSurface& surface, KeptAttributes* kept = nullptr);

}  // namespace remesher
