// SPDX-License-Identifier: MIT
#include "io/model/near_origin.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/files.h"
#include "remesher.h"
#include "support/shapes.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// Where a survey puts a ball that is two metres wide: single precision is half a metre there.
const Vec3 kPlace(431234.5678, 5412345.6789, 312.25);

io::Model ballAt(const Vec3& place) {
  io::Part ball{"ball", shapes::icosphere(8), {Transform::Identity()}};
  for (Vec3& position : ball.mesh.positions) position += place;
  io::Model model;
  model.parts = {std::move(ball)};
  model.conventions = io::Conventions::Classic;
  return model;
}

// The vertices in the world, in their order.
std::vector<Vec3> shown(const io::Model& model) {
  std::vector<Vec3> points;
  for (const io::Part& part : model.parts)
    for (const Transform& place : part.instances)
      for (const Vec3& position : part.mesh.positions) points.push_back(place * position);
  return points;
}

double farthest(const std::vector<Vec3>& points, const std::vector<Vec3>& others) {
  REQUIRE(points.size() == others.size());
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, (points[i] - others[i]).norm());
  return largest;
}

FileBundle objOf(const io::Model& model) { return {io::write(model, "ball.obj").files[0], {}, {}}; }

}  // namespace

TEST_CASE("near origin: what doubles say far away, glTF says as exactly as near the origin") {
  const FileBundle obj = objOf(ballAt(kPlace));
  const std::vector<Vec3> asked = shown(io::read(obj.file));
  for (const std::string name : {"ball.glb", "ball.gltf"}) {
    const ConvertFileResult result = convertFile(obj, name);
    const io::Model written =
        io::read(result.files[0], {result.files.begin() + 1, result.files.end()});
    CHECK(farthest(shown(written), asked) <= 2 * std::numeric_limits<float>::epsilon());
  }
}

TEST_CASE("near origin: a part moves by what loses nothing, and only where it is far") {
  io::Model far = ballAt(kPlace), near = ballAt({1, 2, 3});
  const std::vector<Vec3> asked = shown(far);
  CHECK(io::isFarFromOrigin(far.parts[0].mesh));
  CHECK(!io::isFarFromOrigin(near.parts[0].mesh));
  io::prepare(far, "ball.glb");
  CHECK(shown(far) == asked);
  CHECK(far.parts[0].mesh.positions != asked);
  const Vec3 moved = far.parts[0].instances[0].translation();
  CHECK(moved.cast<float>().cast<double>() == moved);
  const std::vector<Vec3> before = near.parts[0].mesh.positions;
  io::prepare(near, "ball.glb");
  CHECK(near.parts[0].mesh.positions == before);
  io::Part point{"", {}, {Transform::Identity()}};
  point.mesh.positions = {kPlace, kPlace};
  io::moveToOrigin(point);  // without a size there is no shape to keep
  CHECK(point.mesh.positions[0] == kPlace);
}

TEST_CASE("near origin: a remeshed ball is a ball there, too") {
  RemeshOptions options;
  options.vertices = 300;
  const RemeshFileResult result = remeshFile(objOf(ballAt(kPlace)), "ball.glb", options);
  CHECK(result.report.warnings.empty());
  CHECK(result.report.output->vertices == 300);
  for (const Vec3& point : shown(io::read(result.files[0])))
    CHECK((point - kPlace).norm() == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("near origin: a format without places says in what steps it rounds there") {
  const auto said = [](const Vec3& place, const std::string& name) {
    io::Model model = ballAt(place);
    io::prepare(model, name);
    return model.warnings.empty() ? std::string() : model.warnings.front().message;
  };
  CHECK(said(kPlace, "ball.stl").find("steps of 0.5:") < kNone);
  CHECK(said({1, 2, 3}, "ball.stl").empty());
  for (const char* const name : {"ball.ply", "ball.obj", "ball.glb", "ball.3mf", "ball.vtu"})
    CHECK(said(kPlace, name).empty());
}
