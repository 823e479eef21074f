// SPDX-License-Identifier: MIT
// Sweeps over all vertices, each relocated in turn, as both schemes make them.
#pragma once

#include "geometry/polar_map.h"
#include "remesh/steps/run.h"

namespace remesher {

// The neighbours of a curve vertex along its chain.
struct CurveNeighbors {
  Vertex before, after;
};
CurveNeighbors curveNeighbors(const WorkingMesh& mesh, Vertex v);

// Area-based relocation; the weights μ of a triangle follow the target area at its corners, so that
// grading is kept.
void areaBasedSweep(Run& run);

// Laplacian smoothing in the polar map.
void laplacianSweep(Run& run);

// The same for one vertex of any kind; an interior one goes the share `part` of the way. `star` is
// scratch space.
bool laplacianMove(Run& run, PolarMap& star, Vertex v, double part = 1);

// Moves an interior vertex to where the angles around it are widest, if after projection the
// smallest one has grown or is wide enough.
bool widenAround(Run& run, PolarMap& star, Vertex v);

// Slides curve vertices along their chain to where the target sizes want them between their two
// neighbours there or, with run.asked.stagger = 1, level with the mean of all their neighbours. So
// the vertices of two adjacent curves come to face each other's gaps, as in any two rows.
void curveSweep(Run& run);

}  // namespace remesher
