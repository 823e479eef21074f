// SPDX-License-Identifier: MIT
// Spikes: vertices that stick out so far that the skin between them and their neighbours is a
// needle, such as the wild points of scans. Isotropic triangles would be spent on the skin by its
// area, which may be most of the surface, and would be slivers, because few fit around a needle. So
// the skin gets few triangles.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Spikes {
  VertexData<double> lengths;   // from a spike's foot to its tip; 0 for other vertices; empty: none
  std::vector<Vertex> corners;  // tips and feet: smoothing would draw feet up the spike
  Vertex longest;
  std::size_t count = 0;
  double restOfArea = 0;  // of the surface without the skin of spikes

  bool empty() const { return count == 0; }
  // Whether the face is part of a spike's skin.
  bool covers(const HalfedgeMesh& mesh, Face f) const;
};

struct SpikeRules {
  double size;      // edge length of isotropic triangles, model units
  double vertices;  // the result's number of vertices
};

// Empty if spikes take a negligible share of the area, or would take most of the vertices.
Spikes findSpikes(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                  const SpikeRules& rules);

}  // namespace remesher
