// SPDX-License-Identifier: MIT
#include "io/model/conventions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;
using io::Conventions;

namespace {

TriangleMesh withColors(std::vector<float> values) {
  TriangleMesh mesh;
  mesh.attributes = {{"COLOR_0", 4, std::move(values)}};
  return mesh;
}

}  // namespace

TEST_CASE("conventions: every byte of an sRGB colour survives the way to glTF and back") {
  for (int byte = 0; byte < 256; ++byte) {
    const float fraction = static_cast<float>(byte) / 255;
    const TriangleMesh mesh = withColors({fraction, fraction, fraction, fraction});
    const TriangleMesh linear = converted(mesh, Conventions::Classic, Conventions::Gltf);
    CHECK(linear.attributes[0].values[3] == fraction);  // alpha
    const TriangleMesh back = converted(linear, Conventions::Gltf, Conventions::Classic);
    for (const float value : back.attributes[0].values) CHECK(std::lround(value * 255) == byte);
  }
}

TEST_CASE("conventions: middle grey of sRGB is about a fifth of the light") {
  // 18 % of the light is the photographer's grey card; its byte is 118.
  const auto linear =
      converted(withColors({118.0F / 255, 0, 1, 1}), Conventions::Classic, Conventions::Gltf);
  CHECK(linear.attributes[0].values[0] == doctest::Approx(0.18).epsilon(0.01));
  CHECK(linear.attributes[0].values[1] == 0);
  CHECK(linear.attributes[0].values[2] == 1);
}

TEST_CASE("conventions: a glTF's texture is turned over in every other format") {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nf 1/1 2/1 3/1\n";
  const io::Model model = io::read(io::write(io::read(textFile("a.obj", obj)), "a.glb").files[0]);
  CHECK(findAttribute(model.parts[0].mesh, "TEXCOORD_0")->values[1] == 0.75F);
  const io::Model off = io::read(io::write(model, "a.off").files[0]);
  CHECK(findAttribute(off.parts[0].mesh, "TEXCOORD_0")->values[1] == 0.25F);
}

TEST_CASE("conventions: colours stay numbers, and are none beyond white in glTF") {
  const float most = std::numeric_limits<float>::max();
  const TriangleMesh wild = withColors({most, -most, 0, 1});
  for (const bool isRead : {false, true}) {
    const auto [from, to] = isRead ? std::pair(Conventions::Classic, Conventions::Gltf)
                                   : std::pair(Conventions::Gltf, Conventions::Classic);
    const TriangleMesh mesh = converted(wild, from, to);
    for (const float value : mesh.attributes[0].values) CHECK(std::isfinite(value));
  }
  const std::string obj = "v 0 0 0 -1 0.5 1e9\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n";
  const io::Model model = io::read(io::write(io::read(textFile("a.obj", obj)), "a.glb").files[0]);
  for (const float value : findAttribute(model.parts[0].mesh, "COLOR_0")->values) {
    CHECK(value >= 0);
    CHECK(value <= 1);
  }
}
