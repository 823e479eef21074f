// SPDX-License-Identifier: MIT
// Vertices that stick out so far that the skin between them and their neighbours is a needle: the
// wild points of scans. Of even triangles that skin would take a share by its area, which may be
// nearly all of them, and make slivers of them, for few fit around it. So it is left to few
// triangles.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Spikes {
  VertexData<double> lengths;   // from a spike's foot to its tip; 0 for other vertices; empty: none
  std::vector<Vertex> corners;  // tips, and their feet: smoothing would draw these up the spike
  Vertex longest;
  std::size_t count = 0;
  double restOfArea = 0;  // of the surface without the skin of spikes

  bool empty() const { return count == 0; }
  // Whether the face is skin.
  bool covers(const HalfedgeMesh& mesh, Face f) const;
};

struct SpikeRules {
  double size;      // the edge length that even triangles would have, model units
  double vertices;  // that the result is to have
};

// None where spikes take no share of the area worth a word, or would take most of the vertices.
Spikes findSpikes(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                  const SpikeRules& rules);

}  // namespace remesher
