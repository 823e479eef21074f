// SPDX-License-Identifier: MIT
#include "jobs/checks/quad_checks.h"

#include <doctest/doctest.h>

#include <utility>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("quad checks: a part of the shape that quads lack is said, with the place") {
  const auto part = [](const TriangleMesh& mesh) {
    return std::vector<io::Part>{io::Part{"", mesh, {}}};
  };
  TriangleMesh quads = shapes::grid(8, 8), tip = quads;
  quads.isQuads = true;
  CHECK(lostToQuads(part(quads), part(quads)).empty());
  Vec3& top = tip.positions[tip.indices[90]];
  top.z() += 0.5;
  CHECK(lostToQuads(part(tip), part(quads)).empty());
  top.z() += 0.2;
  const std::vector<Warning> warnings = lostToQuads(part(tip), part(quads));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "QUADS_TOO_FEW");
  CHECK(warnings[0].at == top);
  CHECK(lostToQuads(part(tip), part(shapes::grid(8, 8))).empty());  // not of quads
}

TEST_CASE("quad checks: quads that face away from the part given are counted, with a place") {
  const auto part = [](const TriangleMesh& mesh) {
    return std::vector<io::Part>{io::Part{"", mesh, {}}};
  };
  const TriangleMesh given = shapes::grid(4, 4);
  TriangleMesh quads = given;
  quads.isQuads = true;
  CHECK(turnedFromGiven(part(given), part(quads)).empty());
  for (const std::size_t first : {0, 6})
    std::swap(quads.indices[first + 1], quads.indices[first + 5]);
  const std::vector<Warning> warnings = turnedFromGiven(part(given), part(quads));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "QUADS_TURNED_AWAY");
  CHECK(warnings[0].count == 2);
  CHECK(warnings[0].at == Vec3(0.5, 0.5, 0));
  quads.isQuads = false;
  CHECK(turnedFromGiven(part(given), part(quads)).empty());
}

TEST_CASE("quad checks: a border that is not the one given is said, with the place") {
  const auto part = [](const TriangleMesh& mesh) {
    return std::vector<io::Part>{io::Part{"", mesh, {}}};
  };
  TriangleMesh quads = shapes::grid(4, 4);
  quads.isQuads = true;
  CHECK(bordersOffGiven(part(shapes::grid(8, 8)), part(quads)).size() == 1);
  CHECK(bordersOffGiven(part(shapes::grid(4, 4)), part(quads)).empty());
  TriangleMesh notched = quads;  // without the quad at the origin
  notched.indices.erase(notched.indices.begin(), notched.indices.begin() + 6);
  const std::vector<Warning> warnings = bordersOffGiven(part(quads), part(notched));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "QUADS_OFF_BORDER");
  CHECK(warnings[0].count == 1);
  CHECK(warnings[0].message.find("near (1, 1, 0)") != std::string::npos);
  TriangleMesh opened = quads;  // one inner quad is missing, which the result fills
  opened.indices.erase(opened.indices.begin() + 30, opened.indices.begin() + 36);
  const std::vector<Warning> closed = bordersOffGiven(part(opened), part(quads));
  REQUIRE(closed.size() == 1);
  CHECK(closed[0].message.find("1 of its open loops are closed") != std::string::npos);
  CHECK(bordersOffGiven(part(opened), part(opened)).empty());
}

TEST_CASE("quad checks: what is said is the same of any size") {
  const auto saidOf = [](double unit) {
    const auto part = [&](TriangleMesh mesh) {
      for (Vec3& p : mesh.positions) p *= unit;
      return std::vector<io::Part>{io::Part{"", std::move(mesh), {}}};
    };
    TriangleMesh given = shapes::grid(8, 8), quads = given;
    quads.isQuads = true;
    given.positions[given.indices[90]].z() += 0.7;
    std::swap(quads.indices[1], quads.indices[5]);
    std::vector<Warning> all;
    for (const auto check : {lostToQuads, turnedFromGiven, bordersOffGiven})
      for (Warning& warning : check(part(given), part(quads))) {
        *warning.at /= unit;
        all.push_back(std::move(warning));
      }
    return all;
  };
  const std::vector<Warning> usual = saidOf(1);
  CHECK(usual.size() == 2);
  for (const double unit : {0x1p-80, 0x1p66, 0x1p300}) {
    const std::vector<Warning> found = saidOf(unit);
    REQUIRE(found.size() == usual.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].code == usual[i].code);
      CHECK(found[i].count == usual[i].count);
      CHECK(found[i].at == usual[i].at);
    }
  }
}
