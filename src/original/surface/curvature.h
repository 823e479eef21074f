// SPDX-License-Identifier: MIT
// How strongly the original bends, and where: decides sizes and the number of levels.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

// Per vertex the largest turn of the normal per length (radians per model unit) along an edge, on
// the vertex's own side of every curve. Smoothed over a few rings, for surfaces that bend
// everywhere.
VertexData<double> curvatures(const OriginalSurface& surface);
// The same without smoothing.
VertexData<double> sharpestBends(const OriginalSurface& surface);

// The share by which area grows or shrinks per length when the surface is pushed out along its
// normals, averaged over the area: twice the mean curvature (Steiner's formula), 1/r on a tube and
// 2/r on a sphere of radius r.
double meanBend(const OriginalSurface& surface);

// Per vertex a third of the area of its triangles.
VertexData<double> vertexAreas(const OriginalSurface& surface);

}  // namespace remesher
