// SPDX-License-Identifier: MIT
// Decides which curves a mesh of a given edge length can follow. Real files are full of seams much
// closer together than that: bevels between two hard edges, texture islands of a few triangles,
// short bridges from seam to seam. Where two curves pin vertices nearer than an edge is long, good
// triangles are impossible, so such curves are released. A region between released curves is taken
// over by a larger neighbour, whose attributes extend over it (see ChartKeeper).
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"
#include "original/curves/flat_regions.h"

namespace remesher {

struct CurveEdges {
  std::vector<Halfedge> free;   // may be released; one halfedge of each, or both
  std::vector<Halfedge> fixed;  // stay: given by the caller, borders of materials
  FlatRegions flats = {};       // flat regions take over others last, the largest at the very end
};

struct SimplifiedCurves {
  std::vector<Halfedge> edges;  // the free edges that stay, one halfedge of each
  FaceData<char> absorbed;      // faces in regions that a larger one has taken over
};

struct Border {
  double length = 0;
  double bend = 0;  // (1 - cos) / 2 of the dihedral angle, summed along the length

  void add(const Border& other) {
    length += other.length;
    bend += other.bend;
  }

  double meanBend() const { return length > 0 ? bend / length : 0; }
};

// The border along one edge, which must have a face on both sides.
Border borderAlong(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h);

// A region narrower than this is merged into a neighbour; a wall between wide surfaces may be
// narrower still. Result and size (the target edge length) in model units; bend: mean bend of the
// region's border.
double narrowestWidth(double size, double bend);

// A chain between junctions is released if shorter than this; bend: the chain's mean bend.
double shortestChain(double size, double bend);

// size: the target edge length, model units.
SimplifiedCurves simplifyCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                const CurveEdges& curves, double size);

}  // namespace remesher
