// SPDX-License-Identifier: MIT
// Every fan of triangles around a vertex gets a vertex of its own.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

struct ManifoldCut {
  std::vector<Index> corners;  // as given, in the new vertices
  std::vector<Index> origins;  // per new vertex the given one it stands for
  std::vector<Index> twins;    // of the corners, where they were known before
  std::size_t edges = 0;       // edges cut because of more than two triangles
  std::size_t vertices = 0;    // vertices with several fans, away from cut edges
};

// Where it is known which halfedges lie across from which (see plainTwins), so that only fans can
// need to be parted. New vertices are numbered in the order of the given ones, further copies after
// all of them.
ManifoldCut cutFans(std::span<const Index> corners, std::size_t vertexCount,
                    std::vector<Index> twins);

// The same for any pairs of halfedges that stay joined: fills in the corners and the origins.
void splitFans(std::span<const Index> corners, std::size_t vertexCount,
               std::span<const Index> mates, ManifoldCut& cut);

// Those with several fans, but for those that count already.
void countVertices(std::vector<char> counted, ManifoldCut& cut);

}  // namespace remesher
