// SPDX-License-Identifier: MIT
#include "jobs/parts/part_joining.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

#include "jobs/inspected_parts.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("part joining: a model of loose triangles gets advice that joins them") {
  io::Part part;
  const TriangleMesh ball = shapes::icosphere(2);
  for (const Index v : ball.indices) {
    part.mesh.indices.push_back(Index(part.mesh.positions.size()));
    const double shift = 1e-8 * double(part.mesh.positions.size());
    part.mesh.positions.push_back(ball.positions[v] + Vec3(shift, -shift, shift));
  }
  const std::vector<io::Part> parts = {part};
  const std::vector<Warning> warnings = looseTriangles(inspectScaled(parts), parts);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "TRIANGLES_NOT_JOINED");
  const std::size_t at = warnings[0].message.find("--weld ");
  REQUIRE(at != std::string::npos);
  const double percent = std::stod(warnings[0].message.substr(at + 7));
  PartOptions options;
  options.weld = percent;
  const std::vector<io::Part> whole = joinedPlaces(parts, options);
  CHECK(inspectScaled(whole).boundaryEdges == 0);
  CHECK(looseTriangles(inspectScaled(whole), whole).empty());
}

TEST_CASE("part joining: cracks are joined, and walls thinner than the distance stay") {
  TriangleMesh plate = shapes::cube(4);
  for (Vec3& p : plate.positions) p.z() *= 0.01;
  PartOptions options;
  options.weld = 2;
  CHECK(joinedPlaces({{"", plate, {}}}, options)[0].mesh.positions == plate.positions);
  TriangleMesh cracked = plate;
  for (std::size_t i = 0; i < 3; ++i) {  // a triangle comes off
    cracked.positions.push_back(plate.positions[plate.indices[i]] + Vec3(0, 0, 1e-3));
    cracked.indices[i] = Index(plate.positions.size() + i);
  }
  CHECK(inspectScaled({{"", cracked, {}}}).boundaryEdges == 6);
  const MeshReport joined = inspectScaled(joinedPlaces({{"", cracked, {}}}, options));
  CHECK(joined.boundaryEdges == 0);
  CHECK(joined.nonManifoldEdges == 0);
}

TEST_CASE("part joining: triangles that are apart are reported without advice; a lone one is not") {
  io::Part part;
  for (Index i = 0; i < 6; ++i) {
    part.mesh.positions.push_back(Vec3(i < 3 ? 0 : 100, i % 3 == 1, i % 3 == 2));
    part.mesh.indices.push_back(i);
  }
  const std::vector<Warning> warnings = looseTriangles(inspectScaled({part}), {part});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].message.find("weld") == std::string::npos);
  part.mesh.indices.resize(3);
  CHECK(looseTriangles(inspectScaled({part}), {part}).empty());
}

TEST_CASE("part joining: values of attributes that are not finite become 0, and are counted") {
  io::Part part;
  part.mesh = shapes::icosphere(1);
  std::vector<float> values(3 * part.mesh.positions.size(), 1.0F);
  values[4] = std::numeric_limits<float>::quiet_NaN();
  values[7] = -std::numeric_limits<float>::infinity();
  part.mesh.attributes = {{"NORMAL", 3, values}, {"COLOR_0", 3, std::vector<float>(values.size())}};
  std::vector<io::Part> parts = {part};
  const std::vector<Warning> warnings = settleAttributes(parts);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].count == 2);
  CHECK(warnings[0].message.find("NORMAL") != std::string::npos);
  CHECK(parts[0].mesh.attributes[0].values[4] == 0);
  CHECK(parts[0].mesh.attributes[0].values[7] == 0);
  CHECK(parts[0].mesh.attributes[0].values[5] == 1);
  CHECK(settleAttributes(parts).empty());
}
