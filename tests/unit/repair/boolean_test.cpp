// SPDX-License-Identifier: MIT
#include "repair/boolean.h"

#include <doctest/doctest.h>

#include <cmath>

#include "measure/self_intersections.h"
#include "repair/stitch.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;
using shapes::volumeOf;

namespace {

TriangleMesh meshOf(const TriangleMesh& a, const TriangleMesh& b, BooleanOperation operation) {
  TriangleMesh both = soups::joined({a, b});
  both.isSingle = a.isSingle;
  std::optional<United> found = booleanOf(both, a.triangleCount(), operation);
  REQUIRE(found);
  CHECK(countUnbalancedEdges(found->mesh) == 0);
  CHECK(found->crossings.empty());
  CHECK(selfIntersections(found->mesh).empty());
  return found->mesh;
}

TriangleMesh turned(TriangleMesh mesh, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd turn(angle, axis.normalized());
  for (Vec3& p : mesh.positions) p = turn * p;
  return mesh;
}

// Both ways round, the volumes of all that can be made of a and b agree.
void checkVolumes(const TriangleMesh& a, const TriangleMesh& b) {
  const double inA = volumeOf(a), inB = volumeOf(b), size = std::max(inA, inB);
  const double common = volumeOf(meshOf(a, b, BooleanOperation::Intersect));
  const auto isNear = [&](double one, double other) { return std::abs(one - other) < 1e-9 * size; };
  CHECK(isNear(volumeOf(meshOf(a, b, BooleanOperation::Union)) + common, inA + inB));
  CHECK(isNear(volumeOf(meshOf(a, b, BooleanOperation::Subtract)), inA - common));
  CHECK(isNear(volumeOf(meshOf(b, a, BooleanOperation::Subtract)), inB - common));
  CHECK(isNear(volumeOf(meshOf(b, a, BooleanOperation::Intersect)), common));
}

}  // namespace

TEST_CASE("boolean: the volumes of boxes, spheres and tori add up in any position") {
  const std::vector<TriangleMesh> bodies = {soups::cube(-0.7, 0.7), shapes::icosphere(4),
                                            shapes::torus(24, 12)};
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i; j < bodies.size(); ++j) {
      const TriangleMesh &a = bodies[j], &b = bodies[i];
      checkVolumes(a, b);  // on one middle: identical, nested, or crossing
      checkVolumes(a, soups::moved(b, {0.5, 0, 0}));
      checkVolumes(a, soups::moved(turned(b, 0.7, {1, 2, 3}), {0.3, 0.2, 0.41}));
      checkVolumes(a, soups::moved(b, {5, 0, 0}));
    }
}

TEST_CASE("boolean: of sound operands, no triangles of one operand need be compared") {
  const TriangleMesh a = shapes::torus(24, 12),
                     b = soups::moved(turned(soups::cube(-0.7, 0.7), 0.7, {1, 2, 3}), {0.5, 0, 0});
  const TriangleMesh both = soups::joined({a, b});
  for (const auto operation :
       {BooleanOperation::Union, BooleanOperation::Subtract, BooleanOperation::Intersect}) {
    const auto any = booleanOf(both, a.triangleCount(), operation),
               sound = booleanOf(both, a.triangleCount(), operation, Each::Sound);
    REQUIRE((any && sound));
    CHECK(sound->cut > 0);
    CHECK(sound->cut == any->cut);
    CHECK(sound->mesh.indices == any->mesh.indices);
    CHECK(sound->mesh.positions == any->mesh.positions);
  }
}

TEST_CASE("boolean: boxes that share faces, edges or a corner, or are one inside the other") {
  const TriangleMesh box = soups::cube(0, 1);
  for (const Vec3& by : {Vec3(1, 0, 0), Vec3(1, 0.25, 0.5), Vec3(1, 1, 0), Vec3(1, 1, 1),
                         Vec3(0.5, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0, 0, 0)})
    checkVolumes(box, soups::moved(box, by));
  checkVolumes(box, soups::cube(0.25, 0.75));
  checkVolumes(box, soups::cube(0, 0.5));
  checkVolumes(box, soups::cube(-1, 2));
}

// Rounded to single precision, flat faces are no longer quite so.
TEST_CASE("boolean: turned boxes with faces on each other, or flush ones, intersect nowhere") {
  soups::Random random(12);
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const Vec3 axis = random.point(), size = Vec3(0.5, 0.5, 0.5) + random.point(),
               low = 0.5 * random.point(), at = random.point();
    const double angle = 3 * random.number();
    const auto box = [&](const Vec3& from, const Vec3& to) {
      TriangleMesh mesh = soups::cube(0, 1);
      for (Vec3& p : mesh.positions) p = from + p.cwiseProduct(to - from);
      mesh = turned(mesh, angle, axis);
      for (Vec3& p : mesh.positions) p = (p + at).cast<float>().cast<double>();
      mesh.isSingle = true;
      return mesh;
    };
    const Vec3 from = low.cwiseProduct(size);
    const TriangleMesh a = box(Vec3::Zero(), size);
    const TriangleMesh on = box({from.x(), from.y(), size.z()}, size + from),
                       pocket = box(from, {size.x(), 0.75 * size.y(), size.z()});
    const double inA = volumeOf(a), close = 1e-5 * inA;
    const auto volume = [&](const TriangleMesh& b, BooleanOperation operation) {
      return volumeOf(meshOf(a, b, operation));
    };
    CHECK(std::abs(volume(on, BooleanOperation::Union) - inA - volumeOf(on)) < close);
    CHECK(std::abs(volume(pocket, BooleanOperation::Subtract) - inA + volumeOf(pocket)) < close);
    CHECK(std::abs(volume(pocket, BooleanOperation::Union) - inA) < close);
  }
}

TEST_CASE("boolean: bodies that touch have nothing in common, and a body less itself is nothing") {
  const TriangleMesh box = soups::cube(0, 1);
  for (const Vec3& by : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(3, 0, 0)})
    CHECK(meshOf(box, soups::moved(box, by), BooleanOperation::Intersect).indices.empty());
  CHECK(meshOf(box, box, BooleanOperation::Subtract).indices.empty());
}

TEST_CASE("boolean: what nothing cuts stays bit for bit, and what is subtracted is turned over") {
  const TriangleMesh a = shapes::icosphere(3), b = soups::moved(a, {5, 0, 0});
  CHECK(meshOf(a, b, BooleanOperation::Subtract).indices == a.indices);
  CHECK(meshOf(a, b, BooleanOperation::Subtract).positions == a.positions);
  const TriangleMesh both = meshOf(a, b, BooleanOperation::Union);
  CHECK(both.positions == soups::joined({a, b}).positions);
  CHECK(both.indices == soups::joined({a, b}).indices);

  TriangleMesh tool = shapes::icosphere(2);
  for (Vec3& p : tool.positions) p *= 0.25;
  Attribute normals{"NORMAL", 3, {}};
  for (const Vec3& p : soups::joined({a, tool}).positions)
    for (const double x : p.normalized()) normals.values.push_back(float(x));
  TriangleMesh input = soups::joined({a, tool});
  input.attributes.push_back(normals);
  const std::optional<United> hollow =
      booleanOf(input, a.triangleCount(), BooleanOperation::Subtract);
  REQUIRE(hollow);
  const std::vector<float>& values = hollow->mesh.attributes.front().values;
  for (std::size_t v = 0; v < hollow->mesh.positions.size(); ++v) {
    const Vec3& p = hollow->mesh.positions[v];
    const double along = p.dot(Vec3(values[3 * v], values[3 * v + 1], values[3 * v + 2]));
    CHECK((along > 0) == (p.norm() > 0.5));
  }
}
