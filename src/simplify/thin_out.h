// SPDX-License-Identifier: MIT
// Thins out a mesh of millions of triangles in plain arrays, before anything larger is built of it:
// about 90 bytes per vertex beside the mesh, for as many triangles as are thinned out at once.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Whether vertices of open borders may go along them.
enum class OpenBorders : char { Shorten, Keep };

struct ThinOut {
  std::size_t vertices = 0;  // wanted; more are left where no more may go
  OpenBorders borders = OpenBorders::Shorten;
  std::vector<Index> first = {};   // per vertex the first at its place (see weld); empty if unknown
  std::size_t atOnce = 4'000'000;  // triangles; a larger mesh is thinned out in slabs, then whole
  std::size_t* repeated = nullptr;  // counts triangles that went because they repeat others, if set
};

// Vertices go into neighbours, which stay where they are, those first that change the shape least
// [Garland & Heckbert 1997]: all that is left is the mesh's own, with its attributes. Open borders
// and borders of groups are only shortened along themselves; vertices where they meet, at edges of
// more than two triangles, and at places with several attributes stay. No triangle turns by 60° or
// more at once, and the topology stays. Vertices equal in everything become one; triangles without
// three different vertices go, and those that repeat others exactly. Two that have the same corners
// in opposite orders, a sheet given from both sides, are thinned out alike. The mesh must be valid
// (see requireValid).
TriangleMesh thinnedOut(TriangleMesh mesh, ThinOut wanted);

// The work that a large mesh is divided into, for several machines: each slab is thinned out by
// itself, with its borders kept.
struct SlabToThin {
  TriangleMesh mesh;
  ThinOut wanted;
};

// Slab `number`, from 0 on, of `count`, 1 to 256, where the whole mesh is to be left with as many
// vertices as wanted. The mesh has triangles.
SlabToThin slabToThin(const TriangleMesh& mesh, std::size_t number, std::size_t count,
                      const ThinOut& wanted);

// All of them, thinned out one after another and put together in their order.
TriangleMesh thinnedBySlabs(const TriangleMesh& mesh, std::size_t count, const ThinOut& wanted);

}  // namespace remesher
