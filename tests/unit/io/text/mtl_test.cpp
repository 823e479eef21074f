// SPDX-License-Identifier: MIT
#include "io/text/mtl.h"

#include <doctest/doctest.h>

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
