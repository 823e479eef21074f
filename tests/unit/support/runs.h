// SPDX-License-Identifier: MIT
// What a step of a scheme works with, on a surface of one's choice.
#pragma once

#include "remesh/steps/run.h"
#include "support/working_meshes.h"

namespace remesher::shapes {

// A copy of the surface, to be remeshed with even sizes for as many vertices as it has.
struct TestRun {
  explicit TestRun(const TriangleMesh& input)
      : surface(surfaceOf(input)),
        sizes(surface, {.vertices = double(input.positions.size()), .adaptivity = 0}),
        projector(surface, Projection::Patches, 2 * sizes.mean()),
        mesh(surface),
        run{mesh, projector, sizes, {}} {}

  OriginalSurface surface;
  SizeField sizes;
  Projector projector;
  WorkingMesh mesh;
  Run run;
};

}  // namespace remesher::shapes
