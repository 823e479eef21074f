// SPDX-License-Identifier: MIT
#include "jobs/parts/common_frame.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace remesher;

namespace {

std::vector<io::Part> partsOf(const TriangleMesh& mesh) { return {{"", mesh, {}}}; }

// In decimals: a whole number of thousandths.
TriangleMesh inThousandths(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions)
    p = ((p * 1000).array().round() + (by * 1000).array().round()) / 1000;
  return mesh;
}

std::vector<Vec3> here(const TriangleMesh& mesh) {
  const std::optional<CommonFrame> frame = commonFrame(partsOf(mesh));
  REQUIRE(frame);
  std::vector<Vec3> places;
  for (const Vec3& p : mesh.positions) places.push_back(frame->here(p));
  return places;
}

}  // namespace

TEST_CASE("common_frame: the middle is zero, the longest side between 1 and 2") {
  for (const double size : {1e-200, 3e-5, 1.0, 7e4, 1e150}) {
    TriangleMesh mesh = shapes::torus(12, 8);
    for (Vec3& p : mesh.positions) p = p * size + Vec3(5, -7, 9) * size;
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    for (const Vec3& p : here(mesh)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    CHECK((high - low).maxCoeff() >= 1);
    CHECK((high - low).maxCoeff() < 2);
    CHECK((high + low).norm() < 1e-12);
  }
}

TEST_CASE("common_frame: decimals are the same wherever they lie, and in every decimal unit") {
  const TriangleMesh plain = inThousandths(shapes::torus(12, 8), Vec3::Zero());
  const std::vector<Vec3> places = here(plain);
  for (const Vec3& by : {Vec3(0.7, 0.1, -0.3), Vec3(500000.25, 5.4e6, 295)})
    CHECK(here(inThousandths(shapes::torus(12, 8), by)) == places);
  for (const double parts : {10.0, 1e3, 1e6}) {
    TriangleMesh smaller = plain, larger = plain;
    for (Vec3& p : smaller.positions) p = (p * 1000).array().round() / (1000 * parts);
    for (Vec3& p : larger.positions) p = (p * 1000).array().round() * parts;
    CHECK(here(smaller) == places);
    CHECK(here(larger) == places);
  }
}

TEST_CASE("common_frame: what has few binary digits is the same wherever it lies") {
  TriangleMesh mesh = shapes::torus(12, 8);
  for (Vec3& p : mesh.positions) p = (p * 0x1p20).array().round() * 0x1p-20;
  const std::vector<Vec3> places = here(mesh);
  for (const Vec3& by : {Vec3(1, 2, 3), Vec3(0x1p24, -5, 0.5)}) {
    TriangleMesh moved = mesh;
    for (Vec3& p : moved.positions) p += by;
    CHECK(here(moved) == places);
  }
}

TEST_CASE("common_frame: coordinates in steps come back digit by digit") {
  for (const Vec3& by : {Vec3(0, 0, 0), Vec3(0.1, 0.7, 12.003), Vec3(5e5, -5.4e6, 1e-3)}) {
    const TriangleMesh mesh = inThousandths(shapes::torus(12, 8), by);
    const std::optional<CommonFrame> frame = commonFrame(partsOf(mesh));
    REQUIRE(frame);
    CHECK(frame->isInSteps);
    for (const Vec3& p : mesh.positions) CHECK(frame->frame.written(frame->here(p)) == p);
  }
}

TEST_CASE("common_frame: details too small to be moved are not") {
  TriangleMesh mesh = shapes::tetrahedron();
  for (Vec3& p : mesh.positions) p += Vec3(1, 2, 3);
  CHECK(commonFrame(partsOf(mesh)));
  const std::size_t first = mesh.positions.size();
  // As small as a rounding of the tetrahedron's coordinates once they are moved.
  for (const Vec3& p : shapes::tetrahedron().positions) mesh.positions.push_back(1e-30 * p);
  for (const Index v : shapes::tetrahedron().indices) mesh.indices.push_back(Index(first) + v);
  CHECK(!commonFrame(partsOf(mesh)));
}

TEST_CASE("common_frame: single precision numbers far from the origin stay there") {
  TriangleMesh mesh = shapes::torus(12, 8);
  for (Vec3& p : mesh.positions) p = (p + Vec3(1000, 0, 0)).cast<float>().cast<double>();
  CHECK(commonFrame(partsOf(mesh)));
  mesh.isSingle = true;
  CHECK(!commonFrame(partsOf(mesh)));
}
