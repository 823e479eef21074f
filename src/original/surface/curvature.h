// SPDX-License-Identifier: MIT
// How strongly the original bends, and where: what sizes and the number of levels are decided by.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

// Per vertex the largest turn of the normal per length (radians per model unit) along an edge, on
// the vertex's own side of every curve, smoothed over a few rings.
// Smoothed, as for surfaces that bend everywhere.
VertexData<double> curvatures(const OriginalSurface& surface);
// As they are.
VertexData<double> sharpestBends(const OriginalSurface& surface);

// The share by which an area grows or shrinks per length that the surface is pushed out along its
// normals, on average over the area: twice the mean curvature there (Steiner's formula), 1/r on a
// tube and 2/r on a sphere of radius r.
double meanBend(const OriginalSurface& surface);

// Per vertex a third of the area of its triangles.
VertexData<double> vertexAreas(const OriginalSurface& surface);

}  // namespace remesher
