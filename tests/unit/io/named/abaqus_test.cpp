// SPDX-License-Identifier: MIT
#include "io/named/abaqus.h"

#include <doctest/doctest.h>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

TEST_CASE("abaqus: sets have labels that begin with a letter and differ without case") {
  const io::Model model =
      io::read(textFile("a.obj",
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nusemtl Wall 1\nf 1 2 5\n"
                        "usemtl wall_1\nf 2 3 5\nusemtl 9\nf 3 4 5\n"));
  const std::string text = textOf(io::write(model, "o.inp").files[0]);
  CHECK(text.find("\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n") != std::string::npos);
  CHECK(text.find("*ELEMENT, TYPE=S3, ELSET=WALL_1\n1, 1, 2, 5\n") != std::string::npos);
  CHECK(text.find("ELSET=WALL_1_2\n2, 2, 3, 5\n") != std::string::npos);
  CHECK(text.find("ELSET=S_9\n3, 3, 4, 5\n") != std::string::npos);
}

TEST_CASE("abaqus: is only written") {
  CHECK(readingFails(textFile("a.inp", "*HEADING\n*NODE\n1, 0, 0, 0\n"))
            .find("which is only written, not read") != std::string::npos);
}
