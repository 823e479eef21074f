// SPDX-License-Identifier: MIT
#include "measure/mesh_report.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/soups.h"

using namespace remesher;

TEST_CASE("mesh_report: a cube of loose corners is one closed surface of right triangles") {
  const MeshReport report = inspectMesh(soups::cube(-1, 1));
  CHECK(report.vertices == 8);
  CHECK(report.triangles == 12);
  CHECK(report.components == 1);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.nonManifoldEdges == 0);
  CHECK(report.eulerCharacteristic == 2);
  CHECK(report.degenerateTriangles == 0);
  CHECK(report.minAngle.worst == doctest::Approx(45));
  CHECK(report.minAngle.mean == doctest::Approx(45));
  CHECK(report.maxAngle == doctest::Approx(90));
}

TEST_CASE("mesh_report: an open square has its outline as boundary and regular vertices inside") {
  const MeshReport report = inspectMesh(soups::square(7));
  CHECK(report.vertices == 64);
  CHECK(report.boundaryEdges == 28);
  CHECK(report.eulerCharacteristic == 1);
  CHECK(report.valence6 == 100);
}

TEST_CASE("mesh_report: a refined octahedron is regular but at its six corners") {
  const MeshReport report = inspectMesh(soups::sphere(5));
  CHECK(report.vertices == 102);  // Euler: 200 triangles of a sphere have 100 + 2 vertices
  CHECK(report.eulerCharacteristic == 2);
  CHECK(report.valence6 == doctest::Approx(100.0 * 96 / 102));
}

TEST_CASE("mesh_report: positions no triangle uses do not count, and -0 is 0, as roundings are") {
  TriangleMesh mesh;
  soups::addTriangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  soups::addTriangle(mesh, {1, -2.4e-16, 0}, {-0.0, 0, -0.0}, {0, -1, 0});
  mesh.positions.emplace_back(5, 5, 5);
  const MeshReport report = inspectMesh(mesh);
  CHECK(report.vertices == 4);
  CHECK(report.boundaryEdges == 4);
  CHECK(report.components == 1);
}

TEST_CASE("mesh_report: an edge of three triangles is non-manifold, a shared corner no bridge") {
  TriangleMesh book;
  for (const double angle : {0.0, 2.0, 4.0})
    soups::addTriangle(book, {0, 0, 0}, {0, 0, 1}, {std::cos(angle), std::sin(angle), 0.5});
  MeshReport report = inspectMesh(book);
  CHECK(report.nonManifoldEdges == 1);
  CHECK(report.boundaryEdges == 6);
  CHECK(report.components == 1);

  TriangleMesh bowTie;
  soups::addTriangle(bowTie, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  soups::addTriangle(bowTie, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0});
  report = inspectMesh(bowTie);
  CHECK(report.components == 2);
  CHECK(report.vertices == 5);
  CHECK(report.eulerCharacteristic == 2);  // of two disks
}

TEST_CASE("mesh_report: pinching a surface changes its vertices, not its Euler characteristic") {
  TriangleMesh mesh = soups::joined({soups::sphere(3), soups::moved(soups::sphere(3), {2, 0, 0})});
  const MeshReport report = inspectMesh(mesh);  // they touch in one vertex
  CHECK(report.vertices == 2 * (9 * 4 + 2) - 1);
  CHECK(report.eulerCharacteristic == 4);
  CHECK(report.components == 2);
}

TEST_CASE("mesh_report: triangles without area are counted and have an angle of 0") {
  TriangleMesh mesh;
  soups::addTriangle(mesh, {0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0});
  soups::addTriangle(mesh, {0, 0, 0}, {1, 1, 1}, {3, 3, 3});
  soups::addTriangle(mesh, {0, 0, 0}, {0, 0, 0}, {3, 3, 3});
  const MeshReport report = inspectMesh(mesh);
  CHECK(report.degenerateTriangles == 2);
  CHECK(report.minAngle.worst == 0);
  CHECK(report.minAngle.mean == doctest::Approx(20));
  CHECK(report.minAngle.histogram[0] == doctest::Approx(200.0 / 3));
  CHECK(report.minAngle.histogram[5] == doctest::Approx(100.0 / 3));
}

TEST_CASE("mesh_report: the extreme angles are those of single triangles") {
  const TriangleMesh soup = soups::randomSoup(300, 0.5, 5);
  double smallest = 180, largest = 0;
  TriangleMesh part, own;
  part.positions = own.positions = soup.positions;
  for (std::size_t i = 0; i < soup.indices.size(); i += 3) {
    own.indices = {soup.indices[i], soup.indices[i + 1], soup.indices[i + 2]};
    part.indices.insert(part.indices.end(), own.indices.begin(), own.indices.end());
    smallest = std::min(smallest, inspectMesh(own).minAngle.worst);
    largest = std::max(largest, inspectMesh(own).maxAngle);
    CHECK(inspectMesh(part).minAngle.worst == smallest);
    CHECK(inspectMesh(part).maxAngle == largest);
  }
}

TEST_CASE("mesh_report: nothing at all is reported as nothing") {
  const MeshReport report = inspectMesh({});
  CHECK(report.vertices == 0);
  CHECK(report.components == 0);
  CHECK(report.minAngle.mean == 0);
}

TEST_CASE("mesh_report: an edge is not Delaunay when a vertex lies in the other's circle") {
  const auto kite = [](double halfWidth) {
    TriangleMesh mesh;  // around the edge from (0, -1) to (0, 1)
    soups::addTriangle(mesh, {0, -1, 0}, {halfWidth, 0, 0}, {0, 1, 0});
    soups::addTriangle(mesh, {0, 1, 0}, {-halfWidth, 0, 0}, {0, -1, 0});
    return mesh;
  };
  CHECK(nonDelaunayPercentage(kite(1)) == 0);  // on the circle
  CHECK(nonDelaunayPercentage(kite(1.01)) == 0);
  CHECK(nonDelaunayPercentage(kite(0.99)) == 100);
}

TEST_CASE("mesh_report: boundary loops are counted once each, closed surfaces have none") {
  CHECK(countBoundaryLoops(soups::sphere(3)) == 0);
  CHECK(countBoundaryLoops(soups::square(4)) == 1);
  TriangleMesh annulus = soups::square(3);
  annulus.indices.erase(annulus.indices.begin() + 6 * 4, annulus.indices.begin() + 6 * 5);
  CHECK(countBoundaryLoops(annulus) == 2);
}
