// SPDX-License-Identifier: MIT
// What is worse than given is said, and nothing else is.
#include "jobs/checks/result_check.h"

#include <doctest/doctest.h>

#include <string>

#include "measure/mesh_report.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

const std::vector<io::Part> kParts = {io::Part{"", shapes::sliverFan(3), {}}};

std::string codes(const MeshReport& before, const MeshReport& after) {
  std::string all;
  for (const Warning& warning : worseThanGiven({before, after}, kParts))
    all += warning.code + " " + std::to_string(warning.count) + ";";
  return all;
}

MeshReport withAngles(double worst, double mean) {
  MeshReport report;
  report.minAngle.worst = worst;
  report.minAngle.mean = mean;
  return report;
}

}  // namespace

TEST_CASE("result check: a place has as many digits as tell its parts, and no rounding") {
  std::vector<io::Part> parts = {io::Part{"", shapes::sliverFan(3), {}}};
  CHECK(placeInWords({1, 4e-18, -0.5}, parts) == "1, 0, -0.5");
  for (Vec3& p : parts[0].mesh.positions) p *= 1e-12;
  CHECK(placeInWords({1e-12, 4e-13, 0}, parts) == "1e-12, 4e-13, 0");
  for (Vec3& p : parts[0].mesh.positions) p = 1e12 * p + Vec3(500000, 0, 0);
  CHECK(placeInWords({500000.25, 1, 0}, parts) == "500000.25, 1, 0");
}

TEST_CASE("result check: places are the world's, in as many digits as tell them there") {
  std::vector<io::Part> parts = kParts;
  parts[0].instances = {Transform(Eigen::Translation3d(5e6, 0, 0))};
  const std::vector<Warning> found = worseThanGiven({withAngles(3, 34), withAngles(3, 17)}, parts);
  CHECK(found.front().at->x() > 5e6);
  CHECK(found.front().message.find("(5000000.6") != std::string::npos);
}

TEST_CASE("result check: what is as good as before, or good, needs no word") {
  CHECK(codes(withAngles(3, 34), withAngles(3, 34)) == "");
  CHECK(codes(withAngles(58, 59), withAngles(30, 55)) == "");
  MeshReport open, opener;
  open.boundaryEdges = 3;
  opener.boundaryEdges = 9;
  CHECK(codes(open, opener) == "");
}

TEST_CASE("result check: worse angles are said, with the figures and the place") {
  CHECK(codes(withAngles(3, 34), withAngles(3, 17)) == "ANGLES_WORSE 1;");
  CHECK(codes(withAngles(20, 50), withAngles(0.1, 55)) == "ANGLES_WORSE 1;");
  const auto message = [](const MeshReport& before, const MeshReport& after) {
    return worseThanGiven({before, after}, kParts).front().message;
  };
  const std::string both = message(withAngles(3, 34), withAngles(2, 17));
  for (const char* part : {"17° on average, not 34°", "2° in the worst, not 3°", "(0.6667, "})
    CHECK(both.find(part) != std::string::npos);
  CHECK(message(withAngles(2, 34), withAngles(3, 17)).find("in the worst") == std::string::npos);
  CHECK(message(withAngles(3, 17), withAngles(2, 34)).find("on average") == std::string::npos);
}

TEST_CASE("result check: new holes, joined sheets and lines are counted") {
  MeshReport before, after;
  before.nonManifoldEdges = 2;
  after.nonManifoldEdges = 5;
  after.boundaryEdges = 4;
  after.degenerateTriangles = 1;
  CHECK(codes(before, after) ==
        "DEGENERATE_TRIANGLES_MADE 1;NON_MANIFOLD_EDGES_MADE 3;SURFACE_OPENED 4;");
}

TEST_CASE("result check: edges of three triangles that were left are said, those made are not") {
  TriangleMesh fan;
  fan.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  fan.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4};
  const auto left = [&](std::size_t before, std::size_t after) {
    MeshReport given, result;
    given.nonManifoldEdges = before, result.nonManifoldEdges = after;
    return touchesLeft({given, result}, {io::Part{"", fan, {}}});
  };
  CHECK(left(3, 0).empty());
  CHECK(left(0, 1).empty());
  REQUIRE(left(3, 1).size() == 1);
  CHECK(left(3, 1).front().count == 1);
  CHECK(left(3, 1).front().at == Vec3(1, 0, 0));
}

TEST_CASE("result check: points in which bodies touch are said, once for each") {
  const auto left = [](const TriangleMesh& mesh) {
    const MeshReport report = inspectMesh(mesh);
    return touchesLeft({report, report}, {io::Part{"", mesh, {}}});
  };
  CHECK(left(shapes::icosphere(2)).empty());
  CHECK(left(shapes::torus(8, 6)).empty());
  CHECK(left(soups::joined({soups::cube(0, 1), soups::cube(5, 6)})).empty());
  const std::vector<Warning> found =
      left(soups::joined({soups::cube(0, 1), soups::cube(1, 2), soups::cube(2, 3)}));
  REQUIRE(found.size() == 1);
  CHECK(found.front().code == "NON_MANIFOLD_VERTICES_LEFT");
  CHECK(found.front().count == 2);
  CHECK(found.front().at == Vec3(1, 1, 1));
}

TEST_CASE("result check: each says where") {
  const auto found = [](const MeshReport& after, const TriangleMesh& mesh) {
    return worseThanGiven({MeshReport{}, after}, {io::Part{"", mesh, {}}}).front();
  };
  const auto messageOf = [&](const auto&... args) { return found(args...).message; };
  MeshReport after;
  after.boundaryEdges = 3;
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 8, 0}, {0, -8, 0}, {0, 0, 8}};
  mesh.indices = {0, 1, 2};
  CHECK(messageOf(after, mesh).find("the first near (2, 0, 0)") != std::string::npos);
  CHECK(found(after, mesh).at == Vec3(2, 0, 0));
  after = {};
  after.nonManifoldEdges = 1;
  mesh.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  CHECK(messageOf(after, mesh).find("the first near (2, 0, 0)") != std::string::npos);
  after = {};
  after.degenerateTriangles = 1;
  mesh.indices = {0, 2, 3};
  CHECK(messageOf(after, mesh).find("as near (0, 0, 0)") != std::string::npos);
  // In coordinates of a survey, too, to less than its size.
  for (Vec3& p : mesh.positions) p += Vec3(431234.5, 5412345.75, 312.25);
  CHECK(messageOf(after, mesh).find("as near (431234.5, 5412345.75, 312.25)") != std::string::npos);
  CHECK(found(after, mesh).at == Vec3(431234.5, 5412345.75, 312.25));
}

TEST_CASE("result check: a model smaller than what it is rounded to is said, with the place") {
  TriangleMesh far = shapes::sliverFan(3);
  for (Vec3& p : far.positions) p = Vec3(1, 1e-30 * p.y(), 1e-30 * p.z());
  const std::vector<io::Part> speck = {io::Part{"", far, {}}};
  Report report;
  CHECK(lostToRounding(report, speck).empty());
  report.fidelity = FidelityReport{};
  report.fidelity->hausdorff = 100;
  CHECK(lostToRounding(report, speck).empty());
  report.fidelity->hausdorff = 250;
  const std::vector<Warning> warnings = lostToRounding(report, speck);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "SHAPE_LOST_TO_ROUNDING");
  CHECK(warnings[0].message.find("250 % of the diagonal") != std::string::npos);
  CHECK(warnings[0].message.find(" near (1, ") != std::string::npos);
  // As are triangles that rounding made flat, and only those.
  report.fidelity.reset();
  report.output = MeshReport{};
  report.output->degenerateTriangles = report.input.degenerateTriangles = 2;
  CHECK(lostToRounding(report, speck).empty());
  report.input.degenerateTriangles = 0;
  REQUIRE(lostToRounding(report, speck).size() == 1);
  CHECK(lostToRounding(report, speck)[0].message.find("no area, near (1, ") != std::string::npos);
  CHECK(lostToRounding(report, speck)[0].count == 2);
  // Of anything else rounding is not the reason.
  CHECK(lostToRounding(report, kParts).empty());
  CHECK(lostToRounding(report, {io::Part{}}).empty());
}

TEST_CASE("result check: a bound that was asked for and is not kept is said, with both figures") {
  Report report;
  RemeshOptions options;
  CHECK(fartherThanAsked(report, options).empty());
  options.maxError = 0.5;
  CHECK(fartherThanAsked(report, options).empty());
  report.fidelity = FidelityReport{};
  report.fidelity->hausdorff = 0.5;
  CHECK(fartherThanAsked(report, options).empty());
  report.fidelity->hausdorff = 0.75;
  const std::vector<Warning> warnings = fartherThanAsked(report, options);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "MAX_ERROR_EXCEEDED");
  CHECK(warnings[0].message.find("0.75 % of the diagonal") != std::string::npos);
  CHECK(warnings[0].message.find("not 0.5 % at most") != std::string::npos);
}

TEST_CASE("result check: a part of facets that is dented is said, with what its shape takes") {
  const TriangleMesh box = shapes::cube(2);
  TriangleMesh made = shapes::tetrahedron();
  const auto said = [&](const std::vector<TriangleMesh>& given, double hausdorff, TooFew tooFew) {
    std::vector<io::Part> before, after;
    for (const TriangleMesh& mesh : given) {
      before.push_back(io::Part{"", mesh, {}});
      after.push_back(io::Part{"", before.size() == given.size() ? made : mesh, {}});
    }
    Report report;
    report.output = inspectMesh(made);
    report.fidelity = FidelityReport{hausdorff, 0};
    PartOptions options;
    options.tooFew = tooFew;
    const std::vector<Warning> warnings = dentedPart(report, {before, after, {}}, options);
    if (warnings.empty()) return std::string();
    CHECK(warnings[0].code == "SHAPE_TAKES_MORE");
    CHECK(warnings[0].at.has_value());
    return warnings[0].message;
  };
  const auto has = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const std::string plain = said({box}, 1.5, TooFew::Refuse);
  CHECK(has(plain, "1.5 % of the diagonal"));
  CHECK(has(plain, "As many as 8 vertices"));
  CHECK(said({shapes::icosphere(3), box}, 1.5, TooFew::Refuse) == plain);
  CHECK(said({box}, 0.9, TooFew::Refuse).empty());
  CHECK(said({box}, 1.5, TooFew::Raise).empty());
  CHECK(said({shapes::icosphere(3)}, 1.5, TooFew::Refuse).empty());
  TriangleMesh drawn = box;
  drawn.attributes.push_back({"COLOR_0", 3, std::vector<float>(3 * box.positions.size())});
  CHECK(has(said({drawn}, 1.5, TooFew::Refuse), "More vertices keep its shape."));
  made.isQuads = true;
  CHECK(has(said({box}, 1.5, TooFew::Refuse), "More quads keep its shape."));
  CHECK(has(said({shapes::tetrahedron()}, 1.5, TooFew::Refuse), "More quads keep its shape."));
  CHECK(said({shapes::icosphere(3)}, 1.5, TooFew::Refuse).empty());
}

TEST_CASE("result check: more vertices than asked for of a repaired surface are said, and why") {
  RemeshOptions options;
  options.vertices = 500;
  Report report;
  report.output = MeshReport{};
  report.output->vertices = 976;
  report.output->components = 3;
  report.output->eulerCharacteristic = -156;  // 2 for each piece, −2 for each handle
  CHECK(moreThanAsked(report, options).empty());
  options.repair = Repair::Solid;
  const std::vector<Warning> warnings = moreThanAsked(report, options);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "TOO_FEW_VERTICES");
  CHECK(warnings[0].message ==
        "500 vertices are too few to keep the repaired surface (pieces: 3, handles: 81) closed and "
        "free of crossings: the result has 976.");
  options.vertices = 976;
  CHECK(moreThanAsked(report, options).empty());
}

TEST_CASE("result check: where quads missed the number for more of them, that is said") {
  RemeshOptions options;
  options.vertices = 500;
  Report report;
  report.output = MeshReport{};
  report.output->quads.emplace();
  report.output->vertices = 505;
  CHECK(moreThanAsked(report, options).empty());
  report.stopped = Stopped::Fidelity;
  const std::vector<Warning> warnings = moreThanAsked(report, options);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "TOO_FEW_VERTICES");
  CHECK(warnings[0].message.find("500 vertices are too few for quads") == 0);
  CHECK(warnings[0].message.find("the result has 505.") != std::string::npos);
  report.output->vertices = 400;
  CHECK(moreThanAsked(report, options).empty());
}
