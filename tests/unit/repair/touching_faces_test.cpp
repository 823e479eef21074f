// SPDX-License-Identifier: MIT
#include "repair/touching_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/body_union.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

constexpr double kVolume = 27 + 1 + 1.0 / 8;

// A cube with two smaller ones on it, turned, in single precision: their common planes are apart
// by roundings.
TriangleMesh turnedStack(double angle) {
  TriangleMesh smaller = shapes::cube(2), smallest = shapes::cube(1);
  for (Vec3& p : smaller.positions) p *= 0.5;
  for (Vec3& p : smallest.positions) p *= 0.5;
  TriangleMesh stack = soups::joined({shapes::cube(3), soups::moved(smaller, {0.3, 0.7, 3}),
                                      soups::moved(smallest, {1.9, 1.1, 3})});
  const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 3).normalized());
  for (Vec3& p : stack.positions) p = (turn * p).cast<float>().cast<double>();
  stack.isSingle = true;
  return stack;
}

// Linear in the place.
Vec2 texcoordAt(const Vec3& p) { return {0.3 * p.x() - 0.1 * p.z(), 0.2 * p.y() + 0.25 * p.z()}; }

TriangleMesh withTexcoords(TriangleMesh mesh) {
  mesh.attributes.push_back({"TEXCOORD_0", 2, {}});
  for (const Vec3& p : mesh.positions)
    for (const double x : texcoordAt(p)) mesh.attributes.back().values.push_back(float(x));
  return mesh;
}

// The largest difference from that.
double texcoordError(const TriangleMesh& mesh) {
  double worst = 0;
  for (const Index v : mesh.indices)
    for (std::size_t k = 0; k < 2; ++k)
      worst = std::max(worst, std::abs(texcoordAt(mesh.positions[v])[Eigen::Index(k)] -
                                       mesh.attributes[0].values[2 * v + k]));
  return worst;
}

}  // namespace

TEST_CASE("touching faces: turned bodies on each other are united without self-intersections") {
  for (const double angle : {0.2, 0.3, 1.2, 1.8}) {
    CAPTURE(angle);
    const TriangleMesh stack = turnedStack(angle);
    const auto outside = unionOf(stack, selfIntersections(stack));
    REQUIRE(outside);
    CHECK(outside->undecided.empty());
    CHECK(selfIntersections(outside->mesh).empty());
    CHECK(inspectMesh(outside->mesh).boundaryEdges == 0);
    CHECK(shapes::volumeOf(outside->mesh) == doctest::Approx(kVolume).epsilon(1e-5));
    CHECK(outside->mesh.triangleCount() < 2 * stack.triangleCount());
  }
}

TEST_CASE("touching faces: joined faces have common corners, where any touch") {
  const TriangleMesh stack = turnedStack(0.9);
  const auto joined = withFacesJoined(stack, 4, SharedFaces::Dropped);
  REQUIRE(joined);
  CHECK(joined->parents.size() == joined->mesh.triangleCount());
  CHECK(selfIntersections(joined->mesh).empty());
  CHECK(inspectMesh(joined->mesh).boundaryEdges == 0);
  const TriangleMesh apart =
      soups::joined({shapes::cube(1), soups::moved(shapes::cube(1), {2, 0, 0})});
  CHECK_FALSE(withFacesJoined(apart, 4, SharedFaces::Dropped));
}

TEST_CASE("touching faces: three points of a face's side, on a line when rounded, hinder nothing") {
  const auto box = [](const Vec3& low, double height) {
    TriangleMesh mesh = shapes::cube(2);
    for (Vec3& p : mesh.positions) p = low + p.cwiseProduct(Vec3(0.5, 0.5, 0.5 * height));
    return mesh;
  };
  for (const int k : {3, 23, 28}) {
    TriangleMesh boxes =
        soups::joined({box({0, 0, 0}, 1), box({1, 0, 0}, 1.25), box({0, 1, 0}, 1.5)});
    const Eigen::AngleAxisd turn(0.1 + 0.05 * k, Vec3(1, 2, 3).normalized());
    for (Vec3& p : boxes.positions)
      p = (turn * p + Vec3(0.3, -0.7, 0.5)).cast<float>().cast<double>();
    boxes.isSingle = true;
    const auto joined = withFacesJoined(boxes, 4, SharedFaces::Dropped);
    REQUIRE(joined);
    CHECK(joined->parents.size() == joined->mesh.triangleCount());
    CHECK(inspectMesh(joined->mesh).boundaryEdges == 0);
    CHECK(shapes::volumeOf(joined->mesh) == doctest::Approx(3.75).epsilon(1e-5));
  }
}

TEST_CASE("touching faces: linear attributes stay so, and others are left alone") {
  for (const double angle : {0.2, 0.3, 1.2, 1.8}) {
    CAPTURE(angle);
    const TriangleMesh stack = withTexcoords(turnedStack(angle));
    const auto outside = unionOf(stack, selfIntersections(stack));
    REQUIRE(outside);
    CHECK(selfIntersections(outside->mesh).empty());
    CHECK(shapes::volumeOf(outside->mesh) == doctest::Approx(kVolume).epsilon(1e-5));
    CHECK(texcoordError(outside->mesh) < 1e-5);
  }
  TriangleMesh bent = withTexcoords(turnedStack(0.9));
  CHECK(withFacesJoined(bent, 4, SharedFaces::Dropped));
  for (float& u : bent.attributes[0].values) u *= u;
  CHECK_FALSE(withFacesJoined(bent, 4, SharedFaces::Dropped));
}

TEST_CASE("touching faces: each body may keep its own of those that are shared") {
  const TriangleMesh stack = turnedStack(0.9);
  const auto joined = withFacesJoined(stack, 4, SharedFaces::Kept);
  REQUIRE(joined);
  CHECK(shapes::volumeOf(joined->mesh) == doctest::Approx(shapes::volumeOf(stack)).epsilon(1e-6));
  CHECK(inspectMesh(joined->mesh).nonManifoldEdges > 0);
}
