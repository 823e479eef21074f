// SPDX-License-Identifier: MIT
// A wild point of a scan is a spike; what a designer draws to a point is none.
#include "original/curves/spikes.h"

#include <doctest/doctest.h>

#include <numbers>

#include "mesh/mesh_builder.h"
#include "support/hostile_shapes.h"
#include "support/parts.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// At a size at which as many isotropic triangles fit on the surface as it has.
Spikes spikesOf(const TriangleMesh& input) {
  const BuiltMesh built = buildMesh(input);
  double whole = 0;
  for (std::size_t t = 0; t < input.triangleCount(); ++t) {
    const auto at = [&](std::size_t k) { return input.positions[input.indices[3 * t + k]]; };
    whole += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  const double vertices = double(built.mesh.vertexCount());
  return findSpikes(built.mesh, built.positions, {std::sqrt(1.1547 * whole / vertices), vertices});
}

}  // namespace

TEST_CASE("spikes: sound shapes have none, pointed or not") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    CHECK(spikesOf(shape.mesh).empty());
  }
  TriangleMesh spire = shapes::cone(32);
  for (Vec3& p : spire.positions) p.z() *= 10;
  CHECK(spikesOf(spire).empty());
}

TEST_CASE("spikes: a coarse body beside a fine one is none") {
  TriangleMesh scene = shapes::icosphere(24);
  const Index first = Index(scene.positions.size());
  const TriangleMesh box = soups::cube(3, 4);
  scene.positions.insert(scene.positions.end(), box.positions.begin(), box.positions.end());
  for (const Index i : box.indices) scene.indices.push_back(first + i);
  CHECK(spikesOf(scene).empty());
}

TEST_CASE("spikes: a fan in a plane is none, however fine the hole that it ends at") {
  for (const Index n : {Index{6}, Index{24}, Index{60}})
    for (const double thickness : {0.02, 0.5, 4.0}) {
      CAPTURE(n);
      CAPTURE(thickness);
      CHECK(spikesOf(shapes::drilledPlate(n, thickness)).empty());
    }
}

TEST_CASE("spikes: one far vertex is one, its length the way out, its skin not counted") {
  for (const double radii : {10.0, 100.0, 1e6}) {
    const TriangleMesh mesh = shapes::spikedSphere(12, radii);
    const BuiltMesh built = buildMesh(mesh);
    const Spikes spikes = spikesOf(mesh);
    REQUIRE(spikes.count == 1);
    CHECK(built.positions[spikes.longest].x() == radii);
    CHECK(spikes.lengths[spikes.longest] == doctest::Approx(radii - 1).epsilon(0.01));
    CHECK(spikes.corners.size() == 1 + std::size_t(built.mesh.valence(spikes.longest)));
    CHECK(spikes.restOfArea == doctest::Approx(4 * std::numbers::pi).epsilon(0.03));
  }
}

TEST_CASE("spikes: on a boundary only what is far beyond all else is one") {
  for (const double out : {3.0, 9.0, 20.0, 1e30}) {
    CAPTURE(out);
    TriangleMesh sheet = shapes::grid(10, 10);
    for (Vec3& p : sheet.positions)
      if (p == Vec3(10, 5, 0)) p.x() = 10 * out;
    const Spikes spikes = spikesOf(sheet);
    CHECK(spikes.count == (out > 11 ? 1 : 0));
    if (spikes.empty()) continue;
    CHECK(spikes.lengths[spikes.longest] == doctest::Approx(10 * out - 10).epsilon(0.02));
    CHECK(spikes.restOfArea == doctest::Approx(97).epsilon(0.02));
  }
}

TEST_CASE("spikes: none where they would take most of the vertices") {
  const BuiltMesh built = buildMesh(shapes::spikedSphere(12, 100));
  CHECK(findSpikes(built.mesh, built.positions, {0.2, 12}).empty());
}

TEST_CASE("spikes: tips side by side are one spike") {
  TriangleMesh mesh = shapes::spikedSphere(12, 50);
  // The vertex nearest to the first tip's place follows it.
  Vec3 second(-1, 0, 0);
  for (const Vec3& p : mesh.positions)
    if (p.x() < 2 && p.x() > second.x()) second = p;
  for (Vec3& p : mesh.positions)
    if (p == second) p *= 50;
  const Spikes spikes = spikesOf(mesh);
  REQUIRE(spikes.count == 1);
  std::size_t tips = 0;
  for (const double length : spikes.lengths.values()) tips += length > 0;
  CHECK(tips == 2);
}
