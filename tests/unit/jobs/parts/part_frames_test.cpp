// SPDX-License-Identifier: MIT
#include "jobs/parts/part_frames.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "remesher.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

io::Part placed(const TriangleMesh& mesh, double instanceScale) {
  return {"", mesh, {Transform(Eigen::Scaling(instanceScale))}};
}

// No turn takes it to itself. Its coordinates are whole steps.
TriangleMesh bentTorus() {
  TriangleMesh mesh = shapes::torus(24, 12);
  for (Vec3& p : mesh.positions)
    p += Vec3(0.1 * p.y() * p.y(), 0.2 * p.z() + 0.1 * p.x() * p.x(), 0.3 * p.x() * p.x());
  for (Vec3& p : mesh.positions) p = (1024 * p).array().round() / 1024;
  return mesh;
}

constexpr QuarterTurn kTurns[] = {
    {{1, 2, 0}, {1, 1, 1}}, {{0, 2, 1}, {1, 1, -1}}, {{0, 1, 2}, {-1, -1, 1}}};

TriangleMesh turned(TriangleMesh mesh, const QuarterTurn& turn) {
  for (Vec3& p : mesh.positions) p = turn.turned(p);
  return mesh;
}

}  // namespace

TEST_CASE("part_frames: what lies far away is brought near, however small it is") {
  io::Part part = placed(shapes::tetrahedron(), 1);
  part.instances[0].pretranslate(Vec3(0, 0, 1e300));
  const std::vector<io::Part> near = PartFrames({part}).applied({part});
  for (const Vec3& p : near[0].mesh.positions) CHECK((near[0].instances[0] * p).norm() < 1e70);
}

TEST_CASE("part_frames: what has no area has no say") {
  const auto isLarge = [](const io::Part& part) {
    return PartFrames({part}).applied({part})[0].mesh.positions[1].norm() < 1e-30;
  };
  io::Part part = placed(shapes::tetrahedron(), 1);
  part.mesh.positions.emplace_back(0, 3e38, 0);
  CHECK(!isLarge(part));
  part.mesh.indices.insert(part.mesh.indices.end(), {0, 4, 4});
  CHECK(!isLarge(part));
  part.mesh.indices.insert(part.mesh.indices.end(), {0, 1, 4});
  CHECK(isLarge(part));
}

TEST_CASE("part_frames: a stray vertex stays a number, however small the rest is") {
  io::Part part = placed(scaled(shapes::tetrahedron(), 1e-30), 1);
  part.mesh.positions.emplace_back(0, 1e300, 0);
  const std::vector<io::Part> parts = PartFrames({part}).applied({part});
  for (const Vec3& p : parts[0].mesh.positions) CHECK(p.allFinite());
}

TEST_CASE("part_frames: what was applied and undone is the same, digit by digit") {
  for (const int power : {-1060, -300, -40, 40, 300, 1020}) {
    const double size = std::ldexp(1, power);
    const std::vector<io::Part> parts = {placed(scaled(shapes::tetrahedron(), size), 1),
                                         placed(shapes::tetrahedron(), size)};
    const PartFrames scale(parts);
    CAPTURE(power);
    REQUIRE(scale.isNeeded());
    const std::vector<io::Part> unit = scale.applied(parts);
    for (const io::Part& part : unit) {
      const Vec3 corner = part.mesh.positions[0], place = part.instances[0] * corner;
      CHECK(corner.norm() > 1e-20);
      CHECK(corner.norm() < 10);
      CHECK(place.norm() > 1e-20);
      CHECK(place.norm() < 10);
    }
    const std::vector<io::Part> back = scale.undone(unit, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CHECK(back[i].mesh.positions == parts[i].mesh.positions);
      CHECK(back[i].instances[0].matrix() == parts[i].instances[0].matrix());
    }
  }
}

TEST_CASE("part_frames: a part far from the origin comes near it, and goes back digit by digit") {
  const TriangleMesh torus = shapes::torus(12, 8);
  for (const Vec3& by : {Vec3(5e5, 5.4e6, 300), Vec3(-1e8, 0, 0), Vec3(0, 50.1, -7)}) {
    io::Part part = placed(torus, 1);
    for (Vec3& p : part.mesh.positions) p += by;
    const PartFrames scale({part});
    REQUIRE(scale.isNeeded());
    const std::vector<io::Part> near = scale.applied({part});
    for (const Vec3& p : near[0].mesh.positions) {
      CHECK(p.norm() < 30);
      CHECK((near[0].instances[0] * p).norm() < 30);
    }
    CHECK(scale.inWorld(near[0], near[0].mesh.positions[0]) == part.mesh.positions[0]);
    const std::vector<io::Part> back = scale.undone(near, {part});
    CHECK(back[0].mesh.positions == part.mesh.positions);
    CHECK(back[0].instances[0].matrix() == part.instances[0].matrix());
    part.mesh.isSingle = true;  // rounded where it is
    CHECK(PartFrames({part}).applied({part})[0].mesh.positions == part.mesh.positions);
  }
}

TEST_CASE("part_frames: parts near the origin whose place is far away are near each other") {
  std::vector<io::Part> parts = {placed(shapes::torus(12, 8), 1), placed(shapes::cube(2), 1)};
  for (io::Part& part : parts) part.instances[0].pretranslate(Vec3(1e7, 0, 0));
  for (const io::Part& part : PartFrames(parts).applied(parts))
    CHECK(part.instances[0].translation().norm() < 30);
}

TEST_CASE("part_frames: a mesh of any size is remeshed as one of size one is") {
  const TriangleMesh torus = shapes::torus(12, 8);
  PartOptions options;
  for (const Scheme scheme : {Scheme::Best, Scheme::Rounds}) {
    options.scheme = scheme;
    options.edgeLength = 1.6;
    const RemeshResult one = remesh(torus, options);
    for (const int power : {-900, -40, 100, 900}) {
      const double size = std::ldexp(1, power);
      options.edgeLength = 1.6 * size;
      const RemeshResult other = remesh(scaled(torus, size), options);
      CAPTURE(power);
      CHECK(other.mesh.indices == one.mesh.indices);
      CHECK(other.mesh.positions == scaled(one.mesh, size).positions);
      CHECK(other.report.fidelity->hausdorff == one.report.fidelity->hausdorff);
      CHECK(other.report.output->minAngle.worst == one.report.output->minAngle.worst);
      CHECK(inspect(scaled(torus, size)).input.minAngle.mean == one.report.input.minAngle.mean);
    }
  }
}

TEST_CASE("part_frames: along axes of its own, a quarter turn of a surface changes nothing") {
  TriangleMesh mesh = bentTorus();
  mesh.attributes.push_back({"NORMAL", 3, {}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.attributes[0].values.insert(mesh.attributes[0].values.end(), {0.36F, 0.48F, 0.8F});
  const auto framesOf = [](const io::Part& part) {
    return PartFrames({part}, FrameRounding::Allowed, FrameAxes::Own);
  };
  const io::Part given = placed(mesh, 1);
  const io::Part one = framesOf(given).applied({given}).front();
  for (const QuarterTurn& turn : kTurns) {
    io::Part part = given;
    part.mesh = turned(part.mesh, turn);
    std::vector<float>& normals = part.mesh.attributes[0].values;
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      const Eigen::Vector3f turned = turn.turned(Eigen::Vector3f(0.36F, 0.48F, 0.8F));
      std::copy(turned.begin(), turned.end(), normals.begin() + std::ptrdiff_t(i));
    }
    const PartFrames frames = framesOf(part);
    const std::vector<io::Part> other = frames.applied({part});
    CHECK(other[0].mesh.positions == one.mesh.positions);
    CHECK(other[0].mesh.attributes[0].values == one.mesh.attributes[0].values);
    const Vec3 at = part.mesh.positions[5];
    CHECK(frames.inWorld(other[0], other[0].mesh.positions[5]) == at);
    CHECK(frames.undone(0, other[0].mesh.positions[5]) == at);
    const std::vector<io::Part> back = frames.undone(other, {part});
    CHECK(back[0].mesh.positions == part.mesh.positions);
    CHECK(back[0].mesh.attributes[0].values == normals);
  }
}

TEST_CASE("part_frames: a mesh turned by quarters is remeshed as the mesh is, and turned") {
  PartOptions options;
  options.vertices = 150;
  for (const bool quads : {false, true}) {
    options.quads = quads;
    const RemeshResult one = remesh(bentTorus(), options);
    for (const QuarterTurn& turn : kTurns) {
      const RemeshResult other = remesh(turned(bentTorus(), turn), options);
      CHECK(other.mesh.indices == one.mesh.indices);
      const TriangleMesh expected = turned(one.mesh, turn);
      REQUIRE(other.mesh.positions.size() == expected.positions.size());
      for (std::size_t v = 0; v < expected.positions.size(); ++v)
        CHECK((other.mesh.positions[v] - expected.positions[v]).norm() < 1e-12);
    }
  }
}
