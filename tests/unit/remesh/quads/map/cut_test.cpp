// SPDX-License-Identifier: MIT
#include "remesh/quads/map/cut.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "remesh/quads/field/singularities.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("cut: crosses agree but over the cut, which ends nowhere but at singular vertices") {
  for (const TriangleMesh& shape :
       {shapes::icosphere(8), shapes::torus(30, 14), shapes::cube(4), shapes::grid(6, 5)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh mesh(surface);
    const FaceFrames frames(mesh);
    const CrossField field = makeCrossField(mesh, frames, 0.5);
    const VertexData<int> singular = quarterIndices(field, mesh, frames);
    const CutField cut = cutOpen(mesh, field, singular);
    const HalfedgeMesh& m = mesh.mesh();
    VertexData<int> ends(m.vertexCapacity(), 0);
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      const Halfedge h(i), twin = m.twin(h);
      if (!twin) continue;
      CHECK(cut.isCut[h] == cut.isCut[twin]);
      ends[m.origin(h)] += cut.isCut[h];
      if (!cut.isCut[h]) CHECK(cut.turn[h] == 0);
      // The same crosses as before, by other names.
      const double there = cut.angle[HalfedgeMesh::face(twin)] + cut.turn[h] * std::numbers::pi / 2;
      const double gone = there - cut.angle[HalfedgeMesh::face(h)] - frames.between(h);
      CHECK(std::cos(gone - field.bend(frames, m, h)) == doctest::Approx(1));
    }
    for (Index i = 0; i < m.vertexCapacity(); ++i) {
      if (m.isBoundary(Vertex(i))) continue;
      if (singular[Vertex(i)] != 0) CHECK(ends[Vertex(i)] >= 1);
      if (singular[Vertex(i)] == 0) CHECK(ends[Vertex(i)] != 1);
    }
  }
}
