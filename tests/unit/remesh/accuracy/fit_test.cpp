// SPDX-License-Identifier: MIT
#include "remesh/accuracy/fit.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "measure/hausdorff.h"
#include "remesh/ground/decimate.h"
#include "remesh/steps/relax.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// Six times the volume within.
double volumeOf(const TriangleMesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    volume += mesh.positions[mesh.indices[i]].dot(
        mesh.positions[mesh.indices[i + 1]].cross(mesh.positions[mesh.indices[i + 2]]));
  return volume;
}

TriangleMesh trianglesOf(const WorkingMesh& mesh) {
  TriangleMesh result;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    result.positions.push_back(mesh.position(Vertex(i)));
  for (Index i = 0; i < mesh.mesh().faceCapacity(); ++i)
    for (const Vertex v : mesh.mesh().vertices(Face(i))) result.indices.push_back(v.index);
  return result;
}

// A fine surface, and on it a mesh of a tenth as many vertices, smoothed.
void thinOut(shapes::TestRun& test) {
  const VertexData<double> spacing(test.mesh.mesh().vertexCapacity(), 3.3 * test.sizes.mean());
  decimate(test.mesh, test.run.asked.rule, spacing);
  test.run.asked.scale = 3.3;
  relax(test.run, 10);
}

// Wider one way than the other, and bent inwards in the middle.
TriangleMesh waist() {
  TriangleMesh mesh = shapes::icosphere(24);
  for (Vec3& p : mesh.positions) {
    const double narrow = 0.5 + p.x() * p.x();
    p = {1.6 * p.x(), narrow * p.y(), 1.3 * narrow * p.z()};
  }
  return mesh;
}

}  // namespace

TEST_CASE("fit: what a mesh within a curved surface lacks of its volume comes back") {
  for (const TriangleMesh& original : {shapes::icosphere(24), waist()}) {
    shapes::TestRun test(original);
    thinOut(test);
    REQUIRE(test.mesh.mesh().vertexCount() < original.positions.size() / 8);
    const TriangleMesh before = trianglesOf(test.mesh);
    const double angle = shapes::worstAngle(test.mesh);
    fit(test.run, {});
    const TriangleMesh after = trianglesOf(test.mesh);
    const double whole = volumeOf(original);
    const double lost = whole - volumeOf(before), left = whole - volumeOf(after);
    CHECK(lost > 0.003 * whole);
    CHECK(std::abs(left) < 0.1 * lost);
    CHECK(measureFidelity(original, after).rms < 0.5 * measureFidelity(original, before).rms);
    CHECK(shapes::worstAngle(test.mesh) >= std::min(angle, radians(33)));
  }
}
