// SPDX-License-Identifier: MIT
#include "remesh/steps/subdivide.h"

#include <doctest/doctest.h>

#include <vector>

#include "geometry/triangle.h"
#include "remesh/steps/adapt.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// Around the z axis at distance 2, with a tube a tenth as thick as that of shapes::torus.
TriangleMesh wireRing() {
  TriangleMesh mesh = shapes::torus(160, 24);
  for (Vec3& p : mesh.positions) {
    const Vec3 middle = 2 * Vec3(p.x(), p.y(), 0).normalized();
    p = middle + 0.1 * (p - middle);
  }
  return mesh;
}

// Per edge, as subdividing numbers them, where the triangles beside it face.
std::vector<Vec3> facings(const WorkingMesh& mesh) {
  std::vector<Vec3> result;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    if (!m.isEdge(Halfedge(i))) continue;
    Vec3 sum = Vec3::Zero();
    for (const Halfedge h : {Halfedge(i), m.twin(Halfedge(i))}) {
      const auto [a, b, c] = mesh.corners(m.face(h));
      sum += areaVector(a, b, c);
    }
    result.push_back(sum);
  }
  return result;
}

}  // namespace

TEST_CASE("subdivide: where a tube has three edges around, no middle lands on its far side") {
  constexpr double kAway = -0.1;  // where a tube lies flat, its rims face sideways
  const OriginalSurface surface = shapes::surfaceOf(wireRing());
  for (std::size_t vertices = 200; vertices <= 400; vertices += 50) {
    CAPTURE(vertices);
    SizeField sizes(surface, {.vertices = double(vertices), .adaptivity = 0});
    Projector projector(surface, Projection::Patches, 2 * sizes.mean());
    WorkingMesh mesh(surface);
    Run run{mesh, projector, sizes, {}};
    adaptToSizes(run, vertices, {});
    mesh.compact();
    const std::vector<Vec3> outward = facings(mesh);
    const std::size_t first = mesh.mesh().vertexCount();
    subdivide(run);
    REQUIRE(mesh.mesh().vertexCount() == first + outward.size());
    std::size_t facingAway = 0;
    for (std::size_t i = 0; i < outward.size(); ++i)
      facingAway += outward[i].normalized().dot(mesh.normal(Vertex(Index(first + i)))) < kAway;
    CHECK(facingAway == 0);
  }
}
