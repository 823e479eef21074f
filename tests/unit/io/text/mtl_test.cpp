// SPDX-License-Identifier: MIT
#include "io/text/mtl.h"

#include <doctest/doctest.h>

#include "io/model/conventions.h"

using namespace remesher;
using namespace remesher::io;

namespace {

std::vector<std::string> imagesIn(const std::string& text) {
  return imagesOf({"m.mtl", {text.begin(), text.end()}});
}

}  // namespace

TEST_CASE("mtl: images are found behind every statement that has one") {
  const std::vector<std::string> expected = {"a.png", "b c.png", "d.png", "n.png", "../e.png"};
  CHECK(imagesIn("newmtl red\nKd 1 0 0\nmap_Kd a.png\r\n\tmap_Ks  b c.png \nbump d.png\n"
                 "norm n.png\nmap_Ke ../e.png\nmap_aat on\n# map_Kd no.png\nmap_Kd a.png\nmap_d") ==
        expected);
}

TEST_CASE("mtl: options before the name are passed over") {
  const std::vector<std::string> expected = {"a.png", "2 b.png", "c.png"};
  CHECK(imagesIn("map_Kd -s 1 2 3 -o 0.5 -clamp on -mm 0 1 a.png\n"
                 "map_Kd -t 1 1 1 2 b.png\nbump -imfchan r -bm 2 c.png\n") == expected);
}

TEST_CASE("mtl: options without end have no name behind them") {
  CHECK(imagesIn("map_Kd -s\nmap_Kd -bm\nmap_Kd -mm 1\nmap_Kd\n").empty());
}

TEST_CASE("mtl: materials as glTF says them") {
  const std::string text =
      "newmtl dark red\nKd 0.5 0.25 0\nNs 250\nPm 0.5\nKe 0 0 1\nmap_Kd -s 2 3 -o 0.1 0.2 -clamp "
      "on "
      "a b.png\nmap_Bump x.png\nnorm n.png\nnewmtl glass\nd 0.25\nmap_Ke e.png\n"
      "newmtl broken\nKd red\nd\nNs nan\n";
  const auto materials = materialsOf({"m.mtl", {text.begin(), text.end()}});
  REQUIRE(materials.size() == 3);
  const Material& red = materials.at("dark red");
  CHECK(red.baseColor == Eigen::Vector4d(linearFromSrgb(0.5), linearFromSrgb(0.25), 0, 1));
  CHECK(red.roughness == 0.5);
  CHECK(red.metallic == 0.5);
  CHECK(red.emissive == Vec3(0, 0, 1));
  CHECK(red.baseColorMap.image == "a b.png");
  CHECK(red.baseColorMap.wrap[0] == Wrap::Clamp);
  // At (x, y) from the bottom lies what OBJ looks up at (2 x + 0.1, 3 y + 0.2).
  const Vec2 at(0.3, 0.1), fromTop(at.x(), 1 - at.y());
  const Vec2 looked =
      red.baseColorMap.transform.leftCols<2>() * fromTop + red.baseColorMap.transform.col(2);
  CHECK(looked.isApprox(Vec2(0.7, 1 - 0.5)));
  CHECK(red.normalMap.image == "n.png");
  CHECK(red.unpaintable == std::vector<std::string>{"map_Bump"});
  const Material& glass = materials.at("glass");
  CHECK(glass.baseColor[3] == 0.25);
  CHECK(!glass.isOpaque);
  CHECK(glass.rest != red.rest);
  CHECK(glass.emissive == Vec3(1, 1, 1));
  CHECK(materials.at("broken").baseColor == Eigen::Vector4d::Ones());
}
