// SPDX-License-Identifier: MIT
#include "remesh/quads/pair/pairing.h"

#include <doctest/doctest.h>

#include "mesh/topology.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/triangulated.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct Paired {
  explicit Paired(const TriangleMesh& input)
      : surface(shapes::surfaceOf(input)),
        mesh(surface),
        frames(mesh),
        pairs(pairTriangles(mesh, frames, makeCrossField(mesh, frames, 0.5))),
        quads(splitPairs(mesh, pairs)) {}

  OriginalSurface surface;
  WorkingMesh mesh;
  FaceFrames frames;
  FaceData<Face> pairs;
  QuadMesh quads;
};

}  // namespace

TEST_CASE("pairing: pairs are mutual, of neighbours, and never across a curve") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const Paired paired(shape.mesh);
    for (Index i = 0; i < paired.pairs.size(); ++i) {
      const Face f(i), other = paired.pairs[f];
      if (!other) continue;
      CHECK(paired.pairs[other] == f);
      bool isBeside = false;
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge h = HalfedgeMesh::halfedge(f, corner), twin = paired.mesh.mesh().twin(h);
        isBeside |= twin && HalfedgeMesh::face(twin) == other && !paired.mesh.isCurve(h);
      }
      CHECK(isBeside);
    }
  }
}

TEST_CASE("pairing: quads are sound, and a surface of the same kind, whatever the triangles are") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const Paired paired(shape.mesh);
    CHECK(check(paired.quads) == "");
    CHECK(kindOf(paired.quads) == kindOf(paired.mesh.mesh()));
  }
}

TEST_CASE("pairing: a vertex for each of the triangles' vertices, and two for each edge left") {
  // V' = V + E' + F' of the mixed mesh, and V − E' + F' = χ.
  const Paired paired(shapes::torus(20, 12));
  std::size_t alone = 0;
  for (const Face f : paired.pairs.values()) alone += !f;
  const std::size_t pairs = (paired.pairs.size() - alone) / 2;
  const std::size_t edges = edgeCount(paired.mesh.mesh()) - pairs;
  CHECK(paired.quads.vertices.size() == 2 * edges);
  CHECK(paired.quads.quads.size() == 4 * pairs + 3 * alone);
  CHECK(alone <= 2);
}

TEST_CASE("pairing: as triangles the quads keep every law of a working mesh") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const Paired paired(shape.mesh);
    const WorkingMesh mesh = triangulated(paired.quads, paired.surface);
    CHECK(shapes::checkWorkingMesh(mesh) == "");
    CHECK(mesh.mesh().faceCount() == 2 * paired.quads.quads.size());
    for (Index f = 0; f + 1 < mesh.mesh().faceCapacity(); f += 2) {
      CHECK(mesh.mesh().vertices(Face(f))[0] == mesh.mesh().vertices(Face(f + 1))[0]);
      CHECK(mesh.mesh().vertices(Face(f))[2] == mesh.mesh().vertices(Face(f + 1))[1]);
      if (f > 0) CHECK(mesh.mesh().vertices(Face(f))[0] != mesh.mesh().vertices(Face(f - 1))[0]);
    }
  }
}
