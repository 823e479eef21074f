// SPDX-License-Identifier: MIT
// From the edges that curves run along to the chains that they are: from corner to corner, which
// are where curves meet, end, bend, or a loop has to be divided.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Chain {
  std::vector<Vertex> vertices;     // of the original; the first and the last are corners
  std::vector<Halfedge> halfedges;  // one of each edge's halfedges: between vertices i and i + 1
  std::vector<double> arcs;         // length from the start to each vertex
  bool boundary = false;
  bool kept = false;  // stays as it is, edge by edge

  double length() const { return arcs.back(); }
};

struct CurveRules {
  std::vector<Halfedge> edges;  // the curves' edges besides the open boundaries, which always are
  std::vector<Vertex> tips;     // corners on no curve
  std::vector<Halfedge> kept;   // curves, too, each edge of which stays as it is
  std::vector<Vertex> corners;  // on curves or not
  double size = 0;            // target edge length: a bend is judged over half of it on both sides
  bool keepBoundary = false;  // every boundary vertex is a corner
};

struct TracedChains {
  std::vector<Chain> chains;
  VertexData<char> corners;  // whether a vertex is one
};

TracedChains traceChains(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                         const CurveRules& rules);

}  // namespace remesher
