// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/formats.h"
#include "measure/self_intersections.h"
#include "remesher.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;
using shapes::volumeOf;

namespace {

double commonVolume(const TriangleMesh& a, const TriangleMesh& b) {
  return volumeOf(boolean(a, b, BooleanOperation::Intersect).mesh);
}

Error errorOf(const TriangleMesh& a, const TriangleMesh& b, BooleanOperation operation) {
  try {
    boolean(a, b, operation);
  } catch (const Error& error) {
    return error;
  }
  return {ErrorCode::Internal, "no error"};
}

bool says(const Error& error, const char* words) {
  return std::string(error.what()).find(words) != std::string::npos;
}

// The mesh with an attribute that is linear in the position.
TriangleMesh withTexcoords(TriangleMesh mesh) {
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : mesh.positions) {
    uv.values.push_back(float(0.3 * p.x() + 0.1 * p.y() - 0.2 * p.z()));
    uv.values.push_back(float(0.5 - 0.4 * p.z() + 0.2 * p.x()));
  }
  mesh.attributes.push_back(uv);
  return mesh;
}

// A box one of whose faces is cut at its middle on one side only.
TriangleMesh boxWithTJunctions() {
  TriangleMesh box = soups::cube(0, 1);
  const std::size_t last = box.indices.size() - 3;
  const Index a = box.indices[last], b = box.indices[last + 1], c = box.indices[last + 2];
  const Index middle = shapes::addVertex(box, (box.positions[a] + box.positions[b]) / 2);
  box.indices.resize(last);
  shapes::addTriangle(box, a, middle, c);
  shapes::addTriangle(box, middle, b, c);
  return box;
}

FileBundle fileOf(const TriangleMesh& mesh, const std::string& name,
                  const std::string& material = "") {
  io::Model model;
  model.parts = {{"body", mesh, {Transform::Identity()}}};
  if (!material.empty()) {
    io::GroupInfo group{material, {}};
    group.look.name = material, group.look.baseColor = {0.5, 0.25, 0.125, 1};
    group.painted = 0;
    model.parts.front().groups = {group};
    model.paintings = {group.look};
  }
  return {io::write(model, name).files.front(), {}};
}

// A 3MF's model: a cube that begins at the origin.
FileBundle threemfCube(const std::string& unit, double side) {
  const TriangleMesh cube = soups::cube(0, side);
  std::string text = "<?xml version=\"1.0\"?><model unit=\"" + unit +
                     "\" xmlns=\"core\"><resources><object id=\"1\"><mesh><vertices>";
  for (const Vec3& p : cube.positions)
    text += "<vertex x=\"" + std::to_string(p.x()) + "\" y=\"" + std::to_string(p.y()) + "\" z=\"" +
            std::to_string(p.z()) + "\"/>";
  text += "</vertices><triangles>";
  for (std::size_t i = 0; i < cube.indices.size(); i += 3)
    text += "<triangle v1=\"" + std::to_string(cube.indices[i]) + "\" v2=\"" +
            std::to_string(cube.indices[i + 1]) + "\" v3=\"" + std::to_string(cube.indices[i + 2]) +
            "\"/>";
  text += "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
  return {{"3D/3dmodel.model", {text.begin(), text.end()}}, {}};
}

}  // namespace

TEST_CASE("boolean: a file in another unit is brought to that of the first") {
  const auto unite = [](const FileBundle& a, const FileBundle& b) {
    File file = booleanFiles(a, b, BooleanOperation::Union, "a.3mf").files.front();
    file.name = "3D/3dmodel.model";
    const std::string text(file.bytes.begin(), file.bytes.end());
    CHECK(text.find("unit=\"inch\"") != std::string::npos);
    return volumeOf(io::read(file, {}).parts.front().mesh);
  };
  const FileBundle large = threemfCube("inch", 2), small = threemfCube("millimeter", 25.4);
  CHECK(unite(large, large) == doctest::Approx(8));
  CHECK(unite(large, small) == doctest::Approx(8));
  CHECK(unite(threemfCube("inch", 1), threemfCube("millimeter", 50.8)) == doctest::Approx(8));
}

TEST_CASE("boolean: operands that are broken count as the bodies that they bound") {
  const TriangleMesh box = soups::cube(0, 1), other = soups::cube(0.5, 1.5);
  CHECK(std::abs(commonVolume(boxWithTJunctions(), other) - 0.125) < 1e-9);
  CHECK(std::abs(commonVolume(shapes::turnedOver(box), other) - 0.125) < 1e-9);
  CHECK(std::abs(commonVolume(soups::joined({box, soups::moved(box, {0.5, 0, 0})}), other) - 0.25) <
        1e-9);
  TriangleMesh open = box;
  open.indices.resize(open.indices.size() - 3);
  const BooleanResult closed = boolean(other, open, BooleanOperation::Intersect);
  CHECK(std::abs(volumeOf(closed.mesh) - 0.125) < 1e-9);
  REQUIRE(closed.report.repair);
  CHECK(closed.report.repair->holes == 1);
  CHECK_FALSE(boolean(box, other, BooleanOperation::Union).report.repair);
}

TEST_CASE("boolean: a triangle without an area, which joins others, may be in an operand") {
  TriangleMesh box = boxWithTJunctions();
  const std::size_t last = box.indices.size() - 6;
  shapes::addTriangle(box, box.indices[last], box.indices[last + 4], box.indices[last + 1]);
  CHECK(std::abs(commonVolume(box, soups::cube(0.5, 1.5)) - 0.125) < 1e-9);
}

TEST_CASE("boolean: the report counts both operands and what was cut") {
  const TriangleMesh a = soups::cube(0, 1), b = soups::cube(0.5, 1.5);
  const BooleanResult result = boolean(a, b, BooleanOperation::Union);
  CHECK(result.report.input.triangles == 24);
  CHECK(result.report.input.components == 2);
  REQUIRE(result.report.output);
  CHECK(result.report.output->components == 1);
  CHECK(result.report.output->boundaryEdges == 0);
  CHECK(result.boolean.cut == 12);
  CHECK(result.boolean.selfIntersections == 0);
  CHECK(boolean(a, soups::moved(a, {3, 0, 0}), BooleanOperation::Union).boolean.cut == 0);
}

TEST_CASE("boolean: one sentence says which operand is at fault, and where") {
  const TriangleMesh box = soups::cube(0, 1), sheet = shapes::grid(4, 4);
  const Error open = errorOf(box, sheet, BooleanOperation::Union);
  CHECK(open.code == ErrorCode::InvalidMesh);
  CHECK(says(open, "The second operand is no closed body"));
  CHECK(says(errorOf(sheet, box, BooleanOperation::Union), "The first operand"));
  // Holes are closed, and not what is at fault.
  TriangleMesh torn = shapes::icosphere(4);
  torn.indices.resize(torn.indices.size() - 3);
  const TriangleMesh beside = soups::joined({torn, soups::moved(sheet, {5, 0, 0})});
  CHECK(says(errorOf(box, beside, BooleanOperation::Union), "a sheet or a large opening near (5"));
  CHECK(says(errorOf(box, soups::joined({beside, soups::moved(sheet, {5, 0, 3})}),
                     BooleanOperation::Union),
             "2 sheets or large openings, the first near (5"));
  const TriangleMesh away = soups::moved(box, {3, 0, 0});
  CHECK(errorOf(box, away, BooleanOperation::Intersect).code == ErrorCode::NoTriangles);
  CHECK(errorOf(box, soups::cube(-1, 2), BooleanOperation::Subtract).code ==
        ErrorCode::NoTriangles);
  TriangleMesh wrong = box;
  wrong.indices.back() = 99;
  CHECK(says(errorOf(box, wrong, BooleanOperation::Union), "The second operand: "));
}

TEST_CASE("boolean: attributes stay linear on cut triangles; what one lacks has the default") {
  const TriangleMesh a = withTexcoords(shapes::icosphere(3));
  const TriangleMesh b = soups::cube(0.1, 1.2);
  const TriangleMesh cut = boolean(a, b, BooleanOperation::Subtract).mesh;
  REQUIRE(cut.attributes.size() == 1);
  const std::vector<float>& uv = cut.attributes.front().values;
  std::size_t ofA = 0;
  for (std::size_t v = 0; v < cut.positions.size(); ++v) {
    if (uv[2 * v] == 0 && uv[2 * v + 1] == 0) continue;
    const Vec3& p = cut.positions[v];
    CHECK(std::abs(uv[2 * v] - (0.3 * p.x() + 0.1 * p.y() - 0.2 * p.z())) < 1e-6);
    CHECK(std::abs(uv[2 * v + 1] - (0.5 - 0.4 * p.z() + 0.2 * p.x())) < 1e-6);
    ++ofA;
  }
  CHECK(ofA > 20);
  CHECK(ofA < cut.positions.size());

  TriangleMesh colored = b;
  colored.attributes = {{"COLOR_0", 3, std::vector<float>(3 * b.positions.size(), 0.5F)}};
  const TriangleMesh both = boolean(a, colored, BooleanOperation::Union).mesh;
  const Attribute* colors = findAttribute(both, "COLOR_0");
  REQUIRE(colors);
  for (const float value : colors->values) CHECK((value == 1.0F || value == 0.5F));
}

TEST_CASE("boolean: groups of the second operand follow those of the first") {
  TriangleMesh a = soups::cube(0, 1), b = soups::cube(0.5, 1.5);
  CHECK(boolean(a, b, BooleanOperation::Union).mesh.groups.empty());
  a.groups.assign(a.triangleCount(), 0);
  a.groups.back() = 1;
  const TriangleMesh grouped = boolean(a, b, BooleanOperation::Union).mesh;
  CHECK(groupCount(grouped) == 3);
}

TEST_CASE("boolean: skins of one operand are left out, and normals of the other are flat") {
  TriangleMesh a = shapes::icosphere(2);
  a.attributes = {{"NORMAL", 3, {}}, {"JOINTS_0", 4, {}}, {"WEIGHTS_0", 4, {}}};
  for (const Vec3& p : a.positions)
    for (const double x : p.normalized()) a.attributes[0].values.push_back(float(x));
  a.attributes[1].values.assign(4 * a.positions.size(), 0);
  a.attributes[2].values.assign(4 * a.positions.size(), 0.25F);
  const BooleanResult result = boolean(a, soups::cube(0.1, 1.2), BooleanOperation::Union);
  CHECK_FALSE(findAttribute(result.mesh, "JOINTS_0"));
  REQUIRE(result.report.warnings.size() == 1);
  CHECK(result.report.warnings.front().code == "ATTRIBUTE_NOT_CARRIED");
  const std::vector<float>& normals = findAttribute(result.mesh, "NORMAL")->values;
  for (std::size_t v = 0; v < normals.size(); v += 3)
    CHECK(std::abs(std::hypot(normals[v], normals[v + 1], normals[v + 2]) - 1) < 1e-5);
}

TEST_CASE("boolean: the same input gives the same bytes, at any size") {
  const TriangleMesh a = shapes::icosphere(3), b = soups::moved(a, {0.4, 0.3, 0.2});
  const TriangleMesh once = boolean(a, b, BooleanOperation::Union).mesh;
  const TriangleMesh twice = boolean(a, b, BooleanOperation::Union).mesh;
  CHECK(once.positions == twice.positions);
  CHECK(once.indices == twice.indices);
  const double by = 0x1p60;
  const TriangleMesh large =
      boolean(shapes::scaled(a, by), shapes::scaled(b, by), BooleanOperation::Union).mesh;
  CHECK(large.triangleCount() == once.triangleCount());
  CHECK(std::abs(volumeOf(shapes::scaled(large, 1 / by)) - volumeOf(once)) < 1e-9);
}

TEST_CASE("boolean: files of any formats, in single precision closed as they are written") {
  const TriangleMesh a = shapes::icosphere(4), b = soups::moved(a, {0.4, 0.3, 0.2});
  for (const char* one : {"a.obj", "a.stl", "a.glb", "a.ply", "a.off"})
    for (const char* result : {"c.obj", "c.stl", "c.glb", "c.ply", "c.off"}) {
      const BooleanFilesResult run =
          booleanFiles(fileOf(a, one), fileOf(b, "b.stl"), BooleanOperation::Subtract, result);
      const CloseInspection close = inspectFileClosely({run.files.front(), {}});
      CHECK(close.report.input.boundaryEdges == 0);
      CHECK(close.report.input.triangles == run.report.output->triangles);
      REQUIRE(close.faults);
      CHECK(close.faults->selfIntersections == 0);
      CHECK(close.faults->insideOut == 0);
    }
}

TEST_CASE("boolean: a glTF keeps the materials of both files") {
  const FileBundle a = fileOf(soups::cube(0, 1), "a.glb", "steel"),
                   b = fileOf(soups::cube(0.5, 1.5), "b.glb", "brass");
  const BooleanFilesResult run = booleanFiles(a, b, BooleanOperation::Subtract, "c.glb");
  const io::Model model = io::read(run.files.front());
  REQUIRE(model.parts.size() == 1);
  REQUIRE(model.parts.front().groups.size() == 2);
  for (std::size_t g = 0; g < 2; ++g) {
    const io::GroupInfo& group = model.parts.front().groups[g];
    CHECK(group.material == (g == 0 ? "steel" : "brass"));
    CHECK(group.look.baseColor == Eigen::Vector4d(0.5, 0.25, 0.125, 1));
  }
}

TEST_CASE("boolean: parts are united in the world first") {
  io::Model scene;
  Transform place = Transform::Identity();
  place.translate(Vec3(0.5, 0, 0));
  scene.parts = {{"box", soups::cube(0, 1), {Transform::Identity(), place}}};
  const FileBundle a{io::write(scene, "a.glb").files.front(), {}};
  const BooleanFilesResult run =
      booleanFiles(a, fileOf(soups::cube(0, 4), "b.stl"), BooleanOperation::Intersect, "c.off");
  const io::Model result = io::read(run.files.front());
  CHECK(std::abs(volumeOf(result.parts.front().mesh) - 1.5) < 1e-9);
}

TEST_CASE("boolean: far from the origin a glTF moves its mesh, not its shape") {
  io::Model scene;
  Transform place = Transform::Identity();
  place.translate(Vec3(4e6, 0, 0.125));
  scene.parts = {{"ball", shapes::icosphere(3), {place}}};
  const FileBundle a{io::write(scene, "a.glb").files.front(), {}};
  place.translate(Vec3(0.5, 0, 0));
  scene.parts.front().instances = {place};
  const FileBundle b{io::write(scene, "b.glb").files.front(), {}};
  const BooleanFilesResult run = booleanFiles(a, b, BooleanOperation::Intersect, "c.glb");
  const io::Model result = io::read(run.files.front());
  const TriangleMesh ball = shapes::icosphere(3);
  const double common = commonVolume(ball, soups::moved(ball, {0.5, 0, 0}));
  CHECK(std::abs(volumeOf(result.parts.front().mesh) - common) < 1e-5);
}

TEST_CASE("boolean: bodies that touch share an edge or a corner, which is said") {
  const TriangleMesh cube = soups::cube(0, 1);
  const auto codesOf = [&](const Vec3& by, const TriangleMesh& other) {
    std::vector<std::string> codes;
    const BooleanResult result = boolean(cube, soups::moved(other, by), BooleanOperation::Union);
    for (const Warning& warning : result.report.warnings) codes.push_back(warning.code);
    return codes;
  };
  CHECK(codesOf({1, 1, 0}, cube) == std::vector<std::string>{"NON_MANIFOLD_EDGES_MADE"});
  CHECK(codesOf({1, 1, 1}, cube) == std::vector<std::string>{"NON_MANIFOLD_VERTICES_LEFT"});
  CHECK(codesOf({1, 0, 0}, cube).empty());
  CHECK(codesOf({0.5, 0.5, 0}, cube).empty());
  CHECK(codesOf({9, 0, 0}, shapes::cubesSharingAnEdge(1)) ==
        std::vector<std::string>{"NON_MANIFOLD_EDGES_LEFT"});
}

TEST_CASE("boolean: intersections are those of the numbers that are written") {
  soups::Random random(4);
  for (int trial = 0; trial < 24; ++trial) {
    const Eigen::AngleAxisd turn(3 * random.number(), random.point().normalized());
    const Eigen::AngleAxisd little(2e-8 * random.number(), Vec3::UnitX());
    TriangleMesh one = trial % 2 == 0 ? shapes::icosphere(3 + trial % 5) : shapes::torus(16, 8),
                 other = one;
    for (Vec3& p : one.positions)
      p = Vec3(turn * p + Vec3(0.3, -0.7, 0.5)).cast<float>().cast<double>();
    for (Vec3& p : other.positions)
      p = Vec3(little * (turn * p + Vec3(0.3, -0.7, 0.5))).cast<float>().cast<double>();
    try {
      const BooleanResult result = boolean(one, other, BooleanOperation::Subtract);
      CHECK(result.boolean.selfIntersections == selfIntersections(result.mesh).size());
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::NoTriangles);
    }
  }
}
