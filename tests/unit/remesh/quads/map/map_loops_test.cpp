// SPDX-License-Identifier: MIT
#include "remesh/quads/map/map_loops.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/quad_loops.h"
#include "remesh/quads/extract/extraction.h"
#include "remesh/quads/field/singularities.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("map loops: they are the loops of the map's quads") {
  for (const auto& [shape, length] :
       {std::pair{shapes::icosphere(8), 0.2}, std::pair{shapes::torus(36, 16), 0.2},
        std::pair{shapes::cube(6), 0.5}}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh mesh(surface);
    const HalfedgeMesh& m = mesh.mesh();
    const FaceFrames frames(mesh);
    const CrossField field = makeCrossField(mesh, frames, length);
    const VertexData<int> singular = quarterIndices(field, mesh, frames);
    const CutField cut = cutOpen(mesh, field, singular);
    const SeamlessSystem system({mesh, frames, cut, singular});
    const MapMaker maker(mesh, field, FaceData<double>(m.faceCapacity(), 1.0));
    const SeamlessMap map = maker.map(length).value();
    std::vector<std::array<double, 2>> places(system.copyCount());
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      const MapPoint& p = map.corners[Halfedge(i)];
      places[system.copy(Halfedge(i))] = {double(p.u) / double(kUnit), double(p.v) / double(kUnit)};
    }
    const MapLoops found = LoopMeter(m, system, cut).measure(places);
    const QuadMesh quads = extractQuads(mesh, map);
    const QuadLoops loops = loopsOf(quads.quads.size(), sidesByEdge(quads.quads));
    const auto count = double(quads.quads.size());
    CHECK(found.longest ==
          doctest::Approx(double(loops.longest) / double(loops.edges)).epsilon(0.05));
    CHECK(found.selfCrossing == doctest::Approx(double(loops.selfCrossing) / count));
    CHECK(found.area == doctest::Approx(count));
    CHECK(found.squares <= found.longest + 1e-9);
  }
}
