// SPDX-License-Identifier: MIT
// Sweeps over all vertices, each relocated in turn, as both schemes make them.
#pragma once

#include "geometry/polar_map.h"
#include "remesh/steps/run.h"

namespace remesher {

// The chain's two edges at a curve vertex lead to these.
struct CurveNeighbors {
  Vertex before, after;
};
CurveNeighbors curveNeighbors(const WorkingMesh& mesh, Vertex v);

// Area-based relocation; the weights μ of a triangle follow the target area at its corners, so that
// grading is kept.
void areaBasedSweep(Run& run);

// Laplacian smoothing in the polar map.
void laplacianSweep(Run& run);

// The same for one vertex, of any kind; an interior one goes so large a part of the way. `star` is
// scratch space.
bool laplacianMove(Run& run, PolarMap& star, Vertex v, double part = 1);

// Moves an inner vertex to where the angles around it are widest, if on the surface, too, the
// smallest of them is larger there, or wide enough.
bool widenAround(Run& run, PolarMap& star, Vertex v);

// Curve vertices slide along their chain to where the target sizes want them between their two
// neighbours there, or, with run.stagger = 1, to abreast of the mean of all their neighbours. So
// the vertices of two curves side by side come to lie in gaps, as those of any two rows should.
void curveSweep(Run& run);

}  // namespace remesher
