// SPDX-License-Identifier: MIT
#include "io/model/named_bodies.h"

#include <doctest/doctest.h>

#include "io/files.h"
#include "io/formats.h"

using namespace remesher;
using namespace remesher::test;

namespace {

using Names = std::vector<std::pair<std::string, std::size_t>>;  // with numbers of triangles

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0\n";

// Of the parts of a file that an OBJ became.
Names partsOf(const std::string& faces, const std::string& output, bool areUnited = false) {
  io::Model model = io::read(textFile("a.obj", kPoints + faces));
  if (areUnited) io::uniteAll(model, output);
  const io::WrittenFiles written = io::write(model, output);
  Names names;
  for (const io::Part& part : io::read(written.files.at(0)).parts)
    names.emplace_back(part.name, part.mesh.triangleCount());
  return names;
}

}  // namespace

TEST_CASE("named bodies: objects of an OBJ become meshes of glTF, of their names") {
  const std::string faces = "o left\nf 1 2 3\no right\ng top\nf 4 5 6\nusemtl red\nf 5 7 6\n";
  CHECK(partsOf(faces, "b.glb") == Names{{"left", 1}, {"right", 2}});
  CHECK(partsOf("g one\nf 1 2 3\n", "b.glb") == Names{{"one", 1}});
  CHECK(partsOf("f 1 2 3\n", "b.glb") == Names{{"a.obj", 1}});
  CHECK(partsOf(faces, "b.glb", true).size() == 1);
}

TEST_CASE("named bodies: no border opens between objects that hang together") {
  const std::string faces = "o left\nf 1 2 3\no right\nf 4 5 6\no next\nf 5 7 6\n";
  CHECK(partsOf(faces, "b.glb") == Names{{"left", 1}, {"a.obj", 2}});
  CHECK(partsOf(faces, "b.ply").size() == 1);
}
