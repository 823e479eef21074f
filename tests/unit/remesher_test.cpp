// SPDX-License-Identifier: MIT
// Whatever is given, there is a mesh or a sentence: see the table in tests/README.md.
#include "remesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "support/hostile_shapes.h"

using namespace remesher;

namespace {

std::set<std::string> codesOf(const Report& report) {
  std::set<std::string> codes;
  for (const Warning& warning : report.warnings) codes.insert(warning.code);
  return codes;
}

RemeshOptions toVertices(Index vertices, Scheme scheme = Scheme::Best) {
  RemeshOptions options;
  options.vertices = vertices;
  options.scheme = scheme;
  return options;
}

// What holds of every result: numbers, the count or a reason, and nothing worse unsaid.
RemeshResult checked(const TriangleMesh& mesh, const RemeshOptions& options) {
  RemeshResult result = remesh(mesh, options);
  const Report& report = result.report;
  CHECK(std::all_of(result.mesh.positions.begin(), result.mesh.positions.end(),
                    [](const Vec3& p) { return p.allFinite(); }));
  if (report.stopped == Stopped::Target && options.vertices && !options.splitObtuse)
    CHECK(report.output->vertices == *options.vertices);
  const std::set<std::string> codes = codesOf(report);
  if (report.output->nonManifoldEdges > report.input.nonManifoldEdges)
    CHECK(codes.count("NON_MANIFOLD_EDGES_MADE") == 1);
  if (report.input.boundaryEdges == 0 && report.output->boundaryEdges > 0)
    CHECK(codes.count("SURFACE_OPENED") == 1);
  return result;
}

struct Hostile {
  const char* name;
  TriangleMesh mesh;
};

}  // namespace

TEST_CASE("hostile: shapes without a sane triangle end in a mesh") {
  for (const Hostile& shape : {Hostile{"flat triangle", shapes::flatTriangle(1e-12)},
                               Hostile{"tube", shapes::tube(12, 2, 1e-3, 1e4)},
                               Hostile{"sheet", shapes::stretchedSheet(4, 1e9)},
                               Hostile{"on a line", shapes::nearlyOnALine(20, 1e-9)},
                               Hostile{"on a line", shapes::nearlyOnALine(20, 1e-15)},
                               Hostile{"needles", shapes::needles(16, 1e-9)},
                               Hostile{"mixed", shapes::mixedScales(3, 1e30)},
                               Hostile{"mixed", shapes::mixedScales(3, 1e-30)}})
    for (const Scheme scheme : {Scheme::Best, Scheme::Rounds}) {
      CAPTURE(shape.name);
      CAPTURE(int(scheme));
      checked(shape.mesh, toVertices(60, scheme));
      RemeshOptions own;
      own.scheme = scheme;
      own.prefer = Prefer::Even;
      checked(shape.mesh, own);
    }
}

TEST_CASE("hostile: without a number the search for one ends, too") {
  checked(shapes::needles(16, 1e-9), {});
  checked(shapes::nearlyOnALine(20, 1e-15), {});
}

TEST_CASE("hostile: a triangle without area is refused in a sentence") {
  CHECK_THROWS_WITH_AS(remesh(shapes::flatTriangle(0), {}),
                       doctest::Contains("No triangle has an area"), Error);
}

TEST_CASE("hostile: size and place do not matter") {
  const TriangleMesh sphere = shapes::icosphere(5);
  for (const double by : {1e-30, 1e-300, 1e30, 1e300}) {
    CAPTURE(by);
    const Report report = checked(shapes::scaled(sphere, by), toVertices(300)).report;
    CHECK(report.output->minAngle.worst > 30);
    CHECK(report.output->eulerCharacteristic == 2);
  }
  const Report far = checked(soups::moved(sphere, Vec3(1e8, -1e8, 1e8)), toVertices(300)).report;
  CHECK(far.output->minAngle.worst > 30);
}

TEST_CASE("remesher: a surface is remeshed alike wherever it is and however its axes lie") {
  const TriangleMesh given = shapes::globe(32, 16);
  const Report own = remesh(given, toVertices(300)).report;
  const auto isAlike = [&](const TriangleMesh& mesh) {
    const Report report = remesh(mesh, toVertices(300)).report;
    CHECK(report.prefer == own.prefer);
    CHECK(report.output->minAngle.worst > own.output->minAngle.worst - 3);
    CHECK(report.fidelity->hausdorff < 1.5 * own.fidelity->hausdorff);
  };
  for (const Vec3& by : {Vec3(0, 0, 40), Vec3(5e5, 5.4e6, 300), Vec3(1e7, -1e7, 1e7)})
    isAlike(soups::moved(given, by));
  for (const double by : {1e-3, 10.0, 1e4}) isAlike(shapes::scaled(given, by));
  TriangleMesh turned = given;
  for (Vec3& p : turned.positions) p = Vec3(p.y(), p.z(), p.x());
  isAlike(turned);
}

TEST_CASE("remesher: flat sides get the same quads wherever they are and in every unit of length") {
  const auto quadsOf = [](const TriangleMesh& mesh, Index vertices) {
    RemeshOptions options = toVertices(vertices);
    options.quads = true;
    return remesh(mesh, options).mesh;
  };
  const auto areSame = [](const TriangleMesh& one, const TriangleMesh& other) {
    REQUIRE(one.positions.size() == other.positions.size());
    CHECK(one.indices == other.indices);
    for (std::size_t v = 0; v < one.positions.size(); ++v)
      CHECK((one.positions[v] - other.positions[v]).norm() < 1e-6);
  };
  const TriangleMesh cube = shapes::cube(1);
  const Vec3 by(-123, -1398712, 191);
  areSame(quadsOf(cube, 20), soups::moved(quadsOf(soups::moved(cube, by), 20), -by));
  TriangleMesh finer = shapes::cube(3);
  for (Vec3& p : finer.positions) p = (1e6 * p).array().round() / 1e6;
  TriangleMesh smaller = finer;
  for (Vec3& p : smaller.positions) p = (1e6 * p).array().round() / 1e10;
  areSame(quadsOf(finer, 26), shapes::scaled(quadsOf(smaller, 26), 1e4));
}

TEST_CASE("remesher: the outline of a flat sheet is not cut off, whatever the number") {
  TriangleMesh sheet;  // a square with a round hole
  shapes::addSheet(sheet, 16, 1, [](int k, int row) {
    const Vec3 out = shapes::onCircle(k, 16);
    return row == 0 ? Vec3(0.4 * out) : Vec3(out / out.cwiseAbs().maxCoeff());
  });
  for (Index vertices = 32; vertices < 40; ++vertices) {
    CAPTURE(vertices);
    CHECK(remesh(sheet, toVertices(vertices)).report.fidelity->hausdorff < 0.051);
  }
}

TEST_CASE("hostile: a wild point takes nothing from the rest, and is said") {
  for (const double radii : {10.0, 1e6}) {
    CAPTURE(radii);
    const Report report = checked(shapes::spikedSphere(10, radii), toVertices(1002)).report;
    CHECK(codesOf(report).count("SPIKES_LEFT_COARSE") == 1);
    CHECK(report.output->vertices == 1002);
    CHECK(report.output->minAngle.mean > 55);
    CHECK(report.fidelity->hausdorff < 1);
  }
}

TEST_CASE("hostile: small spikes all over come out no worse than given, or where and why is said") {
  for (const double radii : {3.0, 100.0}) {
    CAPTURE(radii);
    const TriangleMesh mesh = shapes::urchin(4, 8, radii);
    const Report report = checked(mesh, toVertices(120)).report;
    const std::set<std::string> codes = codesOf(report);
    CHECK(codes.count("SPIKES_LEFT_COARSE") + codes.count("ANGLES_WORSE") > 0);
    if (report.output->minAngle.mean >= report.input.minAngle.mean - 0.5) continue;
    const auto isAnswer = [](const Warning& warning) {
      return warning.code == "ANGLES_WORSE" && warning.message.find("near (") != std::string::npos;
    };
    CHECK(std::any_of(report.warnings.begin(), report.warnings.end(), isAnswer));
  }
}

TEST_CASE("hostile: a body without a volume gets its vertices, and no triangle without area") {
  // Three squares around a triangular hole, each with both its sides: at the edges between them
  // four triangles meet, and each is a tetrahedron.
  TriangleMesh ring;
  shapes::addSheet(ring, 3, 2, [](int i, int k) {
    return Vec3((k == 1 ? 1 : 2.5) * shapes::onCircle(i % 3, 3));
  });
  for (const Index vertices : {12U, 13U, 40U}) {
    CAPTURE(vertices);
    const Report report = checked(ring, toVertices(vertices)).report;
    CHECK(report.input.degenerateTriangles == 0);
    CHECK(report.output->degenerateTriangles == 0);
    CHECK(report.output->vertices == vertices);
  }
}

TEST_CASE("hostile: parts that touch touch still, and nothing opens") {
  struct Case {
    const char* name;
    TriangleMesh mesh;
    Index vertices;
  };
  for (const Case& touching : {Case{"cubes at an edge", shapes::cubesSharingAnEdge(4), 500},
                               Case{"cubes at a corner", shapes::cubesSharingACorner(4), 500},
                               Case{"doubled sheet", shapes::doubledSheet(6), 200},
                               Case{"Möbius strip", shapes::moebiusStrip(40), 300},
                               Case{"Klein bottle", shapes::kleinBottle(24, 12), 700},
                               Case{"book", shapes::book(10, 4), 600}}) {
    CAPTURE(touching.name);
    const Report report = checked(touching.mesh, toVertices(touching.vertices)).report;
    CHECK(report.stopped == Stopped::Target);
    CHECK(report.output->components == report.input.components);
    CHECK((report.output->boundaryEdges == 0) == (report.input.boundaryEdges == 0));
    if (touching.name == std::string("doubled sheet"))
      continue;  // inside, both sides had the same edges
    CHECK(report.output->eulerCharacteristic == report.input.eulerCharacteristic);
    CHECK(report.output->nonManifoldEdges == report.input.nonManifoldEdges);
  }
}

TEST_CASE("hostile: parts that touch and have textures are said to meet no more") {
  TriangleMesh mesh = shapes::cubesSharingAnEdge(4);
  mesh.attributes.push_back({"TEXCOORD_0", 2, std::vector<float>(2 * mesh.positions.size(), 0.5F)});
  CHECK(codesOf(checked(mesh, toVertices(500)).report).count("JOINTS_RELEASED") == 1);
  mesh.attributes.clear();
  CHECK(codesOf(checked(mesh, toVertices(500)).report).count("JOINTS_RELEASED") == 0);
}

TEST_CASE("hostile: what is too much is refused, and the next run works") {
  RemeshOptions options;
  options.edgeLength = 1e-9;
  CHECK_THROWS_WITH_AS(remesh(shapes::icosphere(3), options),
                       doctest::Contains("has memory for about"), Error);
  CHECK(remesh(shapes::icosphere(3), {}).report.stopped == Stopped::Target);
}

TEST_CASE("hostile: an error bound finer than any mesh keeps the original, splits and all") {
  RemeshOptions options;
  options.maxError = 1e-9;
  options.splitObtuse = true;
  const TriangleMesh sphere = shapes::icosphere(4);
  const Report report = checked(sphere, options).report;
  CHECK(report.output->vertices < 2 * report.input.vertices);
  CHECK(report.fidelity->hausdorff <= 1e-9);
}

TEST_CASE("remesher: a mesh without area keeps no other from being remeshed, and is named") {
  TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}};
  line.indices = {0, 1, 2, 1, 2, 3};
  const TriangleMesh ball = shapes::icosphere(6);
  RemeshOptions triangles = toVertices(100), quads = toVertices(200), mended = toVertices(300);
  quads.quads = true;
  mended.repair = Repair::Holes;
  for (const RemeshOptions& options : {triangles, quads, mended}) {
    const RemeshSceneResult result = remeshScene({{line, {}}, {ball, {}}, {line, {}}}, options);
    CHECK(result.meshes[0].positions == line.positions);
    CHECK(result.meshes[0].indices == line.indices);
    CHECK(result.meshes[2].indices == line.indices);
    CHECK(result.meshes[1].positions != ball.positions);
    CHECK(codesOf(result.report).count("PASSED_ON") == 1);
  }
  CHECK_THROWS_WITH_AS(remeshScene({{line, {}}, {line, {}}}, triangles),
                       doctest::Contains("No triangle has an area"), Error);
}

TEST_CASE("remesher: the report is of the coordinates of the format that is written") {
  const std::string obj =  // two triangles that single precision makes one
      "v 1e6 0 0\nv 1e6 1 0\nv 1e6 0 1\nv 1000000.000001 0 0\nv 1000000.000001 0 1\n"
      "v 1000000.000001 1 0\nf 1 2 3\nf 4 5 6\n";
  FileBundle input;
  input.file = {"near.obj", {obj.begin(), obj.end()}};
  RemeshOptions options;
  options.vertices = 12;
  for (const std::string name : {"near.obj", "near.stl", "near.glb"}) {
    CAPTURE(name);
    const RemeshFileResult result = remeshFile(input, name, options);
    const MeshReport found = inspectFile({result.files[0], {}}).input;
    CHECK(found.vertices == result.report.output->vertices);
    CHECK(found.boundaryEdges == result.report.output->boundaryEdges);
  }
}

TEST_CASE("remesher: a mesh is the same in every format of file") {
  std::string obj;
  const TriangleMesh boxes = soups::joined({soups::cube(0.1, 2.3), soups::cube(1.2, 3.7)});
  for (const Vec3& p : boxes.positions)
    obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
           std::to_string(p.z() + 0.1 * p.x()) + "\n";
  for (std::size_t i = 0; i < boxes.indices.size(); i += 3)
    obj += "f " + std::to_string(boxes.indices[i] + 1) + " " +
           std::to_string(boxes.indices[i + 1] + 1) + " " +
           std::to_string(boxes.indices[i + 2] + 1) + "\n";
  FileBundle input;
  input.file = {"boxes.obj", {obj.begin(), obj.end()}};
  RemeshOptions options = toVertices(300);
  for (const Repair repair : {Repair::Off, Repair::Auto}) {
    options.repair = repair;
    const Report own = remeshFile(input, "boxes.obj", options).report;
    for (const std::string name : {"boxes.off", "boxes.ply", "boxes.stl", "boxes.glb"}) {
      CAPTURE(name);
      const Report other = remeshFile(input, name, options).report;
      CHECK(other.output->triangles == own.output->triangles);
      CHECK(other.output->minAngle.worst ==
            doctest::Approx(own.output->minAngle.worst).epsilon(1e-4));
      CHECK(other.output->minAngle.mean ==
            doctest::Approx(own.output->minAngle.mean).epsilon(1e-4));
    }
  }
}

TEST_CASE("remesher: distances are those of the surface, wherever it is shown") {
  const TriangleMesh ball = shapes::icosphere(4);
  RemeshOptions options;
  options.vertices = Index(ball.positions.size());
  const double usual = remesh(ball, options).report.fidelity->hausdorff;
  const Transform away(Eigen::Translation3d(1e30, 0, 1e-3));
  CHECK(remeshScene({{ball, {away}}}, options).report.fidelity->hausdorff ==
        doctest::Approx(usual).epsilon(0.1));
  const Transform pressed(Eigen::Scaling(1.0, 0.0, 0.0));
  CHECK(remeshScene({{ball, {pressed}}}, options).report.fidelity->hausdorff == usual);
  TriangleMesh withLine = ball;  // which is no surface
  withLine.positions.emplace_back(3, 0, 0);
  const Index far = Index(withLine.positions.size() - 1);
  withLine.indices.insert(withLine.indices.end(), {0, far, far});
  CHECK(remesh(withLine, options).report.fidelity->hausdorff < 2 * usual);
}
