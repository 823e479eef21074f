// SPDX-License-Identifier: MIT
#include "original/curves/shape_angles.h"

#include <doctest/doctest.h>

#include <numbers>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

TEST_CASE("shape_angles: an edge is sharp exactly where its angle is that large") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const auto built = buildMesh(shape.mesh);
    const FaceData<Vec3> normals = faceNormals(built.mesh, built.positions);
    for (const double degree : {0.0, 0.01, 20.0, 45.0, 90.0, 120.0, 180.0, 400.0}) {
      const HalfedgeData<char> sharp = sharpEdges(built.mesh, normals, radians(degree));
      for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
        const double angle = dihedralAngle(built.mesh, normals, Halfedge(i));
        CHECK(bool(sharp[Halfedge(i)]) == (angle >= radians(degree)));
      }
    }
  }
}

TEST_CASE("shape_angles: of a closed surface 2π χ is missing") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    if (shape.loops > 0) continue;
    CAPTURE(shape.name);
    const auto built = buildMesh(shape.mesh);
    double sum = 0;
    for (Index i = 0; i < built.mesh.vertexCapacity(); ++i)
      sum += missingAngle(built.mesh, built.positions, Vertex(i));
    CHECK(sum == doctest::Approx(2 * std::numbers::pi * double(shape.chi)).epsilon(1e-4));
  }
}

TEST_CASE("shape_angles: where much is missing the normals say that it may be") {
  soups::Random random(4);
  std::size_t spared = 0;
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    TriangleMesh mesh = shape.mesh;
    for (Vec3& p : mesh.positions) p += 0.2 * random.number() * random.point();
    const auto built = buildMesh(mesh);
    for (const double degree : {20.0, 60.0, 120.0}) {
      const VertexData<char> may = mayMiss(built.mesh, built.positions, radians(degree));
      for (Index i = 0; i < built.mesh.vertexCapacity(); ++i) {
        const double missing = missingAngle(built.mesh, built.positions, Vertex(i));
        spared += !may[Vertex(i)];
        if (missing >= radians(degree)) CHECK(may[Vertex(i)]);
      }
    }
  }
  CHECK(spared > 0);
}
