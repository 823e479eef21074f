// SPDX-License-Identifier: MIT
// The result as plain arrays, with the attributes of the original at every vertex's place on it.
#pragma once

#include <string>
#include <vector>

#include "base/input_place.h"
#include "base/triangle_mesh.h"
#include "mesh/attribute_mix.h"
#include "remesh/transfer/chart_keeper.h"

namespace remesher {

struct TransferRules {
  std::vector<std::string> chartless;  // attributes whose seams are not kept: see AttributeMix
  ChartRules charts;
  bool areQuads = false;  // two triangles in a row are the halves of a quad, which has one chart
};

// A vertex on a seam comes out once per side; everything else once. Triangles keep the group of the
// original triangle they lie on.
TriangleMesh extractMesh(const WorkingMesh& mesh, const TriangleMesh& input,
                         const TransferRules& rules);

// The place on the input of each corner of extractMesh's triangles, each on its own side of the
// curves.
std::vector<InputPlace> cornerPlaces(const WorkingMesh& mesh, const TriangleMesh& input);

// A point of the surface, as `mix` takes it; the mesh that it mixes is the surface's input.
AttributeMix::Point mixPoint(const OriginalSurface& surface, const SurfacePoint& point,
                             const AttributeMix& mix);

// A point of the surface built from the input, as a place on the input.
InputPlace inputPlace(const SurfacePoint& point, const BuiltMesh& built, const TriangleMesh& input);

}  // namespace remesher
