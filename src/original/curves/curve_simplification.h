// SPDX-License-Identifier: MIT
// Which curves a mesh of a given edge length can follow. Real files are full of seams much closer
// together than that: bevels between two hard edges, texture islands of a few triangles, short
// bridges from seam to seam. Where two curves pin vertices nearer than an edge is long, nothing can
// make good triangles, so such curves are let go. What lies between them is taken over by a larger
// neighbour, whose attributes extend over it (see ChartKeeper).
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"
#include "original/curves/flat_regions.h"

namespace remesher {

struct CurveEdges {
  std::vector<Halfedge> free;   // may be let go; one halfedge of each, or both
  std::vector<Halfedge> fixed;  // stay: given by the caller, borders of materials
  FlatRegions flats = {};       // what takes over others last, the larger the later
};

struct SimplifiedCurves {
  std::vector<Halfedge> edges;  // the free ones that stay, one halfedge of each
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

// An edge with a face on both sides as a border between them.
Border borderAlong(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h);

// What lies between curves is let go if it is narrower than this; a wall between wide surfaces may
// be narrower still. All in model units; size: the target edge length; bend: the mean one of its
// border.
double narrowestWidth(double size, double bend);

// And so is a chain between junctions that is shorter than this; bend: its mean.
double shortestChain(double size, double bend);

// size: the target edge length, model units.
SimplifiedCurves simplifyCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                const CurveEdges& curves, double size);

}  // namespace remesher
