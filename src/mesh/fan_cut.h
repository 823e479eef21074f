// SPDX-License-Identifier: MIT
// Gives every fan of triangles around a vertex a vertex of its own.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

struct ManifoldCut {
  std::vector<Index> corners;  // as given, in the new vertices
  std::vector<Index> origins;  // per new vertex the given vertex it is a copy of
  std::vector<Index> twins;    // per corner, if known before the cut
  std::size_t edges = 0;       // edges cut because of more than two triangles
  std::size_t vertices = 0;    // vertices with several fans, away from cut edges
};

// Cuts where the twins are known (see plainTwins), so that only fans can need cutting. New vertices
// keep the order of the given ones; further copies follow after all of them.
ManifoldCut cutFans(std::span<const Index> corners, std::size_t vertexCount,
                    std::vector<Index> twins);

// Cuts fans where any pairs of halfedges stay joined: fills in the corners and the origins.
void splitFans(std::span<const Index> corners, std::size_t vertexCount,
               std::span<const Index> mates, ManifoldCut& cut);

// Counts the vertices with several fans, except those in `counted`.
void countVertices(std::vector<char> counted, ManifoldCut& cut);

}  // namespace remesher
