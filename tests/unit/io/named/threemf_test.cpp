// SPDX-License-Identifier: MIT
#include "io/named/threemf.h"

#include <doctest/doctest.h>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

const std::string kBegin =
    "<?xml version=\"1.0\"?><model unit=\"inch\" xmlns=\"core\" xmlns:p=\"production\"><resources>";
const std::string kTetrahedronXml =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\" pid=\"1\" p1=\"1\"/><triangle v1=\"0\" v2=\"1\" "
    "v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"2\" v2=\"0\" v3=\"3\"/>"
    "</triangles></mesh>";
const std::string kMaterials =
    "<basematerials id=\"1\"><base name=\"grey &amp; dull\" displaycolor=\"#808080\"/>"
    "<base name=\"red\" displaycolor=\"#FF0000FF\"/></basematerials>";

std::string wholeModel() {
  return kBegin + kMaterials + "<object id=\"2\" name=\"tip\" pid=\"1\" pindex=\"0\">" +
         kTetrahedronXml + "</object><object id=\"3\"><components><component objectid=\"2\"/>" +
         "<component objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 5 0 "
         "0\"/></components></object>" +
         "</resources><build><item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 0 7\"/></build>" +
         "</model>";
}

}  // namespace

TEST_CASE("3mf: components are instances, materials are groups with colours") {
  const io::Model model = io::read(textFile("3D/3dmodel.model", wholeModel()));
  REQUIRE(model.parts.size() == 1);
  const io::Part& part = model.parts[0];
  CHECK(part.name == "tip");
  REQUIRE(part.instances.size() == 2);
  CHECK((part.instances[0] * Vec3(1, 0, 0)).isApprox(Vec3(1, 0, 7)));
  CHECK((part.instances[1] * Vec3(1, 0, 0)).isApprox(Vec3(5, 1, 7)));
  REQUIRE(part.groups.size() == 2);
  CHECK(part.groups[0].material == "red");
  CHECK(part.groups[0].look.baseColor.isApprox(Eigen::Vector4d(1, 0, 0, 1)));
  CHECK(part.groups[1].material == "grey & dull");
  CHECK(part.mesh.groups == std::vector<Index>{0, 1, 1, 1});
}

TEST_CASE("3mf: a model written has the unit, the names and the colours of the one read") {
  io::Model model = io::read(textFile("a.3mf", wholeModel()));
  io::prepare(model, "o.3mf");
  const File written = io::write(model, "o.3mf").files[0];
  CHECK(textOf(written).find("unit=\"inch\"") != std::string::npos);
  io::Model again = io::read({"o.3mf", written.bytes});
  REQUIRE(again.parts.size() == 2);
  CHECK(again.parts[1].name == "tip");
  CHECK(again.parts[1].groups[1].material == "grey & dull");
  CHECK(again.parts[1].groups[1].look.baseColor.isApprox(model.parts[1].groups[1].look.baseColor,
                                                         0.01));
  CHECK(again.parts[1].mesh.positions == model.parts[1].mesh.positions);
  io::prepare(again, "o.3mf");
  CHECK(textOf(io::write(again, "o.3mf").files[0]) == textOf(written));
}

TEST_CASE("3mf: objects in other models of the package are found by their paths") {
  const std::string main = kBegin +
                           "<object id=\"1\"><components><component p:path=\"/3D/Objects/a.model\" "
                           "objectid=\"2\"/></components></object></resources><build><item "
                           "objectid=\"1\"/></build></model>";
  const File other = textFile("3D/Objects/a.model", kBegin + "<object id=\"2\">" + kTetrahedronXml +
                                                        "</object></resources></model>");
  CHECK(io::read(textFile("a.3mf", main), {other}).parts[0].mesh.triangleCount() == 4);
  CHECK(readingFails(textFile("a.3mf", main)).find("MISSING_RESOURCE") == 0);
}

TEST_CASE("3mf: bad models are refused with the line and what is wrong") {
  const auto check = [](const std::string& from, const std::string& to, std::string_view part) {
    std::string text = wholeModel();
    text.replace(text.find(from), from.size(), to);
    const std::string failure = readingFails(textFile("bad.3mf", text));
    CAPTURE(failure);
    CHECK(failure.find(part) != std::string::npos);
  };
  check("v1=\"2\"", "v1=\"9\"", "names vertex 9");
  check("x=\"1\"", "x=\"one\"", "has no number x");
  check("x=\"1\"", "x=\"inf\"", "not finite");
  check("<item", "<none", "shows no triangles");
}
