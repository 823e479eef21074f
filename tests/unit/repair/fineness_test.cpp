// SPDX-License-Identifier: MIT
#include "repair/fineness.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "mesh/joining.h"
#include "repair/repair.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

PartOptions asked(Repair repair) {
  PartOptions options;
  options.repair = repair;
  return options;
}

// Triangles as large as the box of all of them.
TriangleMesh largeTriangles(std::size_t count) {
  soups::Random random(5);
  TriangleMesh mesh;
  for (std::size_t i = 0; i < count; ++i)
    soups::addTriangle(mesh, random.point(), random.point(), random.point());
  return mesh;
}

}  // namespace

TEST_CASE("fineness: half the edge length that is asked for, within bounds") {
  const TriangleMesh ball = shapes::icosphere(40);
  const double diagonal = diagonalOf(ball);
  PartOptions options;
  options.edgeLength = diagonal / 80;
  CHECK(ruleFor(ball, options, InsideBy::Enclosure).spacing == doctest::Approx(diagonal / 160));
  options.edgeLength = diagonal;
  CHECK(ruleFor(ball, options, InsideBy::Enclosure).spacing == doctest::Approx(diagonal / 128));
  options.edgeLength = diagonal / 1e6;
  CHECK(ruleFor(ball, options, InsideBy::Enclosure).spacing == doctest::Approx(diagonal / 400));
}

TEST_CASE("fineness: a finer lattice takes more memory and time, and a wrap more than a solid") {
  const TriangleMesh ball = shapes::icosphere(40);
  PartOptions fine = asked(Repair::Solid);
  fine.edgeLength = diagonalOf(ball) / 400;
  const RepairNeeds holes = needsOf(ball, asked(Repair::Holes));
  const RepairNeeds solid = needsOf(ball, asked(Repair::Solid));
  const RepairNeeds wrap = needsOf(ball, asked(Repair::Wrap));
  const RepairNeeds finer = needsOf(ball, fine);
  CHECK(holes.bytes < solid.bytes);
  CHECK(holes.seconds < solid.seconds);
  CHECK(solid.bytes < wrap.bytes);
  CHECK(2 * solid.bytes < finer.bytes);
}

TEST_CASE("fineness: what a surface of many walls becomes counts, not only the lattice around it") {
  const auto plates = [](int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
      TriangleMesh plate = shapes::cube(1);
      for (Vec3& p : plate.positions) p.z() = (i + 0.1 * p.z()) / (count - 0.9);
      mesh = soups::joined({mesh, plate});
    }
    return mesh;
  };
  const RepairNeeds few = needsOf(plates(2), asked(Repair::Solid));
  CHECK(4 * few.bytes < needsOf(plates(40), asked(Repair::Solid)).bytes);
}

TEST_CASE("fineness: the lattice is coarser where memory asks for it, down to the coarsest") {
  const TriangleMesh few = shapes::icosphere(60), many = largeTriangles(3000);
  PartOptions options = asked(Repair::Wrap);
  options.edgeLength = diagonalOf(few) / 1e6;
  const double finest = ruleFor(few, options, InsideBy::Reach).spacing;
  const double coarser = ruleFor(many, options, InsideBy::Reach).spacing;
  CHECK(finest == doctest::Approx(diagonalOf(few) / 400));
  CHECK(coarser > 1.2 * finest * diagonalOf(many) / diagonalOf(few));
  CHECK(coarser <= doctest::Approx(diagonalOf(many) / 128));
}

TEST_CASE("fineness: few triangles do not get a surface of very many") {
  PartOptions options = asked(Repair::Wrap);
  options.edgeLength = 1e-6;
  const TriangleMesh few = largeTriangles(10), more = largeTriangles(400);
  CHECK(ruleFor(few, options, InsideBy::Reach).spacing > 1.5 * diagonalOf(few) / 400);
  CHECK(ruleFor(few, options, InsideBy::Reach).mostPoints <
        ruleFor(more, options, InsideBy::Reach).mostPoints);
}

TEST_CASE("fineness: what no memory can hold is refused in a sentence, before the work") {
  const TriangleMesh ball = shapes::icosphere(6);
  const PartOptions options = asked(Repair::Solid);
  const double bytes = needsOf(ball, options).bytes;
  CHECK_NOTHROW(requireMemory(ball, options));
  CHECK_NOTHROW(requireMemory(ball, options, bytes));
  try {
    requireMemory(ball, options, 0.9 * bytes);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::OutOfMemory);
    CHECK(std::string(error.what()).find(" MB of memory for this mesh") != std::string::npos);
  }
}
