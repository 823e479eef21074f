// SPDX-License-Identifier: MIT
#include "io/model/bake.h"

#include <doctest/doctest.h>

#include "base/place.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

TEST_CASE("bake: places that are one up to noise around zero are one in the world") {
  const TriangleMesh cube = soups::moved(shapes::cube(2), {0, 0, 1});
  Transform place = Transform::Identity();
  place.linear() << 0.6, -0.8, 0.1, 0.8, 0.6, 0, 0.3, 0, -1.1;
  place.translation() << 3, 1, 2;
  for (const double noise : {-0x1p-52, 0x1p-25}) {  // of programs in double and in single precision
    TriangleMesh loose;                             // each triangle with corners of its own
    loose.isSingle = true;
    bool isNoisy = false;
    for (const Index v : cube.indices) {
      loose.indices.push_back(Index(loose.positions.size()));
      loose.positions.push_back(cube.positions[v]);
      for (double& c : loose.positions.back())
        if (c == 0 && (isNoisy = !isNoisy)) c = noise;
    }
    io::Model model;
    model.parts.push_back({"", loose, {place, Transform::Identity()}});
    io::makeBodies(model);
    REQUIRE(model.parts.size() == 2);
    CHECK(countPlaces(model.parts[0].mesh.positions) == countPlaces(cube.positions));
    CHECK(model.parts[1].mesh.positions == loose.positions);
  }
}

TEST_CASE("bake: attributes that one of the merged parts lacks are filled in there") {
  TriangleMesh bare;
  bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  bare.indices = {0, 1, 2};
  TriangleMesh full = bare;
  full.attributes = {{"NORMAL", 3, {1, 0, 0, 1, 0, 0, 1, 0, 0}},
                     {"TEXCOORD_0", 2, {1, 2, 3, 4, 5, 6}},
                     {"COLOR_0", 3, {0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  const TriangleMesh merged = io::mergeParts({{"", bare, {}}, {"", full, {}}});
  CHECK(merged.groups == std::vector<Index>{0, 1});
  const auto values = [&](const char* semantic) { return findAttribute(merged, semantic)->values; };
  CHECK(values("NORMAL") ==
        std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0});
  CHECK(values("TEXCOORD_0") == std::vector<float>{0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6});
  CHECK(values("COLOR_0") ==
        std::vector<float>{1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
}
