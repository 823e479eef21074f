// SPDX-License-Identifier: MIT
#include "mesh/joining.h"

#include <doctest/doctest.h>

#include "base/place.h"
#include "measure/mesh_report.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// Every corner of every triangle a vertex of its own.
TriangleMesh soupOf(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Index v : mesh.indices) {
    soup.indices.push_back(Index(soup.positions.size()));
    soup.positions.push_back(mesh.positions[v]);
  }
  return soup;
}

// Moved by so much in turn, this way and that.
TriangleMesh shaken(TriangleMesh mesh, double by) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] += by * Vec3(double(i % 3) - 1, double(i % 5) - 2, double(i % 7) - 3) / 4;
  return mesh;
}

}  // namespace

TEST_CASE("joining: what rounding leaves of zero is nothing beside the model's size") {
  for (const bool isSingle : {false, true})
    for (const double size : {1e-6, 1.0, 1e6}) {
      TriangleMesh box = soupOf(shapes::cube(2));  // a corner of it is the origin
      Vec3 low = box.positions[0];
      for (const Vec3& p : box.positions) low = low.cwiseMin(p);
      for (Vec3& p : box.positions) p = (p - low) * size;
      const MeshReport plain = inspectMesh(box);
      int sign = 0;
      for (Vec3& p : box.positions)
        for (double& c : p)
          if (c == 0) c = (sign++ % 3 - 1) * size * (isSingle ? 1e-8 : 1e-16);
      box.isSingle = isSingle;
      // What double precision leaves is told apart beside the origin alone.
      if (isSingle) CHECK(inspectMesh(box).vertices > plain.vertices);
      joinNoise(box);
      CHECK(inspectMesh(box).vertices == plain.vertices);
      CHECK(inspectMesh(box).boundaryEdges == 0);
    }
}

TEST_CASE("joining: what is small on purpose stays, to the last digit") {
  TriangleMesh tiny = shapes::icosphere(2);
  const std::size_t own = countPlaces(tiny.positions);
  for (Vec3& p : tiny.positions) p *= 1e-20;
  for (int i = 0; i < 1000; ++i) {
    tiny.positions.push_back(Vec3(1 + i, 1, 1));
    const auto v = Index(tiny.positions.size() - 1);
    tiny.indices.insert(tiny.indices.end(), {v, v, v});
  }
  const TriangleMesh before = tiny;
  joinNoise(tiny);  // all of it is nothing beside the rest, and would be one place
  CHECK(tiny.positions == before.positions);
  CHECK(countPlaces(tiny.positions) == own + 1000);
  TriangleMesh plane = shapes::grid(4, 4);
  for (Vec3& p : plane.positions) p.z() = 1e-17;
  const TriangleMesh flat = plane;
  joinNoise(plane);
  CHECK(plane.positions == flat.positions);
}

TEST_CASE("joining: corners that lie apart are joined by the distance that is named") {
  const TriangleMesh ball = shapes::icosphere(3);
  for (const double apart : {3e-8, 1e-6, 1e-4, 1e-3}) {
    TriangleMesh loose = shaken(soupOf(ball), apart);
    REQUIRE(isLoose(loose));
    const auto percent = percentThatJoins(loose);
    REQUIRE(percent);
    joinNear(loose, *percent / 100 * diagonalOf(loose));
    CHECK(inspectMesh(loose).vertices == inspectMesh(ball).vertices);
    CHECK(inspectMesh(loose).boundaryEdges == 0);
  }
  CHECK(!isLoose(ball));
}

TEST_CASE("joining: vertices come to the first within the distance, and no farther") {
  TriangleMesh line;
  for (int i = 0; i < 30; ++i) line.positions.push_back(Vec3(0.4 * i, 0, 0));
  for (Index i = 0; i < 30; i += 3) line.indices.insert(line.indices.end(), {i, i + 1, i + 2});
  const TriangleMesh before = line;
  joinNear(line, 1);
  for (std::size_t i = 0; i < line.positions.size(); ++i)
    CHECK((line.positions[i] - before.positions[i]).norm() <= 1);
  CHECK(countPlaces(line.positions) == 10);
  TriangleMesh far = before;
  joinNear(far, 0.3);
  CHECK(far.positions == before.positions);
}
