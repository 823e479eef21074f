// SPDX-License-Identifier: MIT
// Traces chains of curve edges from corner to corner. Corners are where curves meet, end or bend,
// and where a loop has to be divided.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Chain {
  std::vector<Vertex> vertices;     // of the original; the first and the last are corners
  std::vector<Halfedge> halfedges;  // one of each edge's halfedges: between vertices i and i + 1
  std::vector<double> arcs;         // length from the start to each vertex
  bool boundary = false;
  bool kept = false;  // every edge stays as it is

  double length() const { return arcs.back(); }
};

struct CurveRules {
  std::vector<Halfedge> edges;  // curve edges; open boundaries are curves anyway
  std::vector<Vertex> tips;     // corners on no curve
  std::vector<Halfedge> kept;   // further curve edges; each of these stays as it is
  std::vector<Vertex> corners;  // on curves or not
  double size = 0;            // target edge length: bends are measured over half of it on each side
  bool keepBoundary = false;  // every boundary vertex is a corner
};

struct TracedChains {
  std::vector<Chain> chains;
  VertexData<char> corners;  // per vertex whether it is a corner
};

TracedChains traceChains(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                         const CurveRules& rules);

}  // namespace remesher
