// SPDX-License-Identifier: MIT
#include "simplify/thin_out.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "mesh/submesh.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A wavy sheet of so many cells along a side, each vertex with its place as an attribute.
TriangleMesh wavySheet(int cells) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, cells, cells, [&](int i, int k) {
    const double x = double(i) / cells, y = double(k) / cells;
    return Vec3(x, y, 0.05 * std::sin(9 * x) * std::cos(7 * y));
  });
  Attribute places = {"_PLACE", 3, {}};
  for (const Vec3& p : mesh.positions)
    for (Eigen::Index axis = 0; axis < 3; ++axis) places.values.push_back(float(p[axis]));
  mesh.attributes.push_back(places);
  return mesh;
}

double lengthOfBorder(const TriangleMesh& mesh, double side) {
  double length = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Vec3& p = mesh.positions[mesh.indices[i]];
    const Vec3& q = mesh.positions[mesh.indices[next]];
    if (p.x() == side && q.x() == side) length += std::abs(p.y() - q.y());
  }
  return length;
}

}  // namespace

TEST_CASE("thin out: every shape keeps its topology, and vertices their places") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const MeshReport before = inspectMesh(shape.mesh);
    const TriangleMesh thin = thinnedOut(shape.mesh, {before.vertices / 4});
    const MeshReport after = inspectMesh(thin);
    CHECK(after.vertices <= before.vertices);
    CHECK(after.eulerCharacteristic == before.eulerCharacteristic);
    CHECK(after.components == before.components);
    CHECK(after.nonManifoldEdges == before.nonManifoldEdges);
    CHECK(after.degenerateTriangles == 0);
    std::vector<Vec3> both = shape.mesh.positions;
    both.insert(both.end(), thin.positions.begin(), thin.positions.end());
    CHECK(countPlaces(both) == countPlaces(shape.mesh.positions));
  }
}

TEST_CASE("thin out: a fine sheet is as many vertices as wanted, and near") {
  const TriangleMesh sheet = wavySheet(120);
  const TriangleMesh thin = thinnedOut(sheet, {1500});
  CHECK(thin.positions.size() == 1500);
  CHECK(measureFidelity(sheet, thin).hausdorff < 0.1);
  CHECK(lengthOfBorder(thin, 0) == doctest::Approx(1));
  CHECK(inspectMesh(thin).boundaryEdges < 4 * 120);
  for (std::size_t v = 0; v < thin.positions.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(thin.attributes[0].values[3 * v + axis] ==
            float(thin.positions[v][Eigen::Index(axis)]));
}

TEST_CASE("thin out: borders that are to be kept stay") {
  const TriangleMesh thin = thinnedOut(wavySheet(40), {500, OpenBorders::Keep});
  CHECK(inspectMesh(thin).boundaryEdges == 4 * 40);
  CHECK(thin.positions.size() == 500);
}

TEST_CASE("thin out: borders of groups stay where they are") {
  TriangleMesh sheet = wavySheet(60);
  for (std::size_t i = 0; i < sheet.indices.size(); i += 3)
    sheet.groups.push_back(sheet.positions[sheet.indices[i]].x() < 0.5 ? 0 : 1);
  const TriangleMesh thin = thinnedOut(sheet, {600});
  REQUIRE(thin.groups.size() == thin.triangleCount());
  for (std::size_t i = 0; i < thin.indices.size(); ++i) {
    const double x = thin.positions[thin.indices[i]].x();
    CHECK((thin.groups[i / 3] == 0 ? x <= 0.5 : x >= 0.5));
  }
  CHECK(thin.positions.size() == 600);
}

TEST_CASE("thin out: triangles with vertices of their own are one surface") {
  const TriangleMesh sheet = wavySheet(40);
  TriangleMesh loose;
  for (const Index v : sheet.indices) {
    loose.indices.push_back(Index(loose.positions.size()));
    loose.positions.push_back(sheet.positions[v]);
  }
  const TriangleMesh thin = thinnedOut(loose, {400});
  CHECK(thin.positions.size() == 400);
  CHECK(inspectMesh(thin).components == 1);
}

TEST_CASE("thin out: a mesh of several slabs is as many vertices as wanted, whole, and near") {
  TriangleMesh sheet = wavySheet(120);
  for (std::size_t i = 0; i < sheet.indices.size(); i += 3)
    sheet.groups.push_back(sheet.positions[sheet.indices[i]].x() < 0.5 ? 0 : 1);
  ThinOut wanted{1500};
  wanted.atOnce = sheet.triangleCount() / 5;
  const TriangleMesh thin = thinnedOut(sheet, wanted);
  CHECK(thin.positions.size() == 1500);
  CHECK(thin.groups.size() == thin.triangleCount());
  CHECK(inspectMesh(thin).components == 1);
  CHECK(inspectMesh(thin).eulerCharacteristic == 1);
  CHECK(lengthOfBorder(thin, 0) == doctest::Approx(1));
  CHECK(measureFidelity(sheet, thin).hausdorff < 0.1);
  for (std::size_t v = 0; v < thin.positions.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(thin.attributes[0].values[3 * v + axis] ==
            float(thin.positions[v][Eigen::Index(axis)]));
}

TEST_CASE("thin out: triangles that repeat others exactly are in nobody's way") {
  const TriangleMesh sheet = wavySheet(40);
  TriangleMesh doubled = sheet;
  append(doubled, sheet);
  std::rotate(doubled.indices.end() - 3, doubled.indices.end() - 2, doubled.indices.end());
  std::size_t repeated = 0;
  ThinOut wanted{400};
  wanted.repeated = &repeated;
  const TriangleMesh thin = thinnedOut(doubled, wanted);
  CHECK(repeated == sheet.triangleCount());
  CHECK(thin.positions == thinnedOut(sheet, {400}).positions);
}

TEST_CASE("thin out: both sides of a sheet are thinned out alike, whatever repeats them") {
  const TriangleMesh sheet = wavySheet(40);
  TriangleMesh back = sheet;
  for (std::size_t i = 0; i < back.indices.size(); i += 3)
    std::swap(back.indices[i], back.indices[i + 1]);
  TriangleMesh both = sheet;
  append(both, back);
  append(both, back);
  std::size_t repeated = 0;
  ThinOut wanted{400};
  wanted.repeated = &repeated;
  const TriangleMesh thin = thinnedOut(both, wanted), one = thinnedOut(sheet, {400});
  CHECK(repeated == sheet.triangleCount());
  CHECK(thin.positions == one.positions);
  REQUIRE(thin.triangleCount() == 2 * one.triangleCount());
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < thin.indices.size(); i += 3) {
    const Vec3 *const a = &thin.positions[thin.indices[i]],
                      *const b = &thin.positions[thin.indices[i + 1]],
                      *const c = &thin.positions[thin.indices[i + 2]];
    sum += (*b - *a).cross(*c - *a);
  }
  CHECK(sum.norm() == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("thin out: slabs thinned out each by itself are those of the whole") {
  const TriangleMesh sheet = wavySheet(120);
  ThinOut wanted{1500};
  wanted.atOnce = 3300;
  const std::size_t count = sheet.triangleCount() / wanted.atOnce + 1;
  TriangleMesh joined;
  for (std::size_t i = 0; i < count; ++i) {
    auto [slab, own] = slabToThin(sheet, i, count, wanted);
    CHECK(slab.triangleCount() < 2 * sheet.triangleCount() / count);
    slab = thinnedOut(std::move(slab), std::move(own));
    if (i == 0)
      joined = std::move(slab);
    else
      append(joined, slab);
  }
  const TriangleMesh bySlabs = thinnedBySlabs(sheet, count, wanted);
  CHECK(joined.positions == bySlabs.positions);
  CHECK(joined.indices == bySlabs.indices);
  CHECK(joined.attributes[0].values == bySlabs.attributes[0].values);
  CHECK(joined.positions.size() < sheet.positions.size() / 3);
  // More than are thinned out at once, and still not divided again.
  REQUIRE(joined.triangleCount() > wanted.atOnce);
  const TriangleMesh fromJoined = thinnedOut(joined, wanted), fromAll = thinnedOut(sheet, wanted);
  CHECK(fromJoined.positions == fromAll.positions);
  CHECK(fromJoined.indices == fromAll.indices);
}
