// SPDX-License-Identifier: MIT
#include "io/model/companions.h"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include "io/model/resources.h"

using namespace remesher;
using namespace remesher::io;

namespace {

// Names that would lead out of a folder, to a device, or to what is hidden, on some system.
const std::vector<std::string> kTricks = {
    "",
    "..",
    "../a.png",
    "../../etc/passwd",
    "a/../../b.png",
    "./../a.png",
    "/etc/passwd",
    "//host/share/a.png",
    "a//b.png",
    "a/",
    "..\\a.png",
    "a\\b.png",
    "C:\\a.png",
    "C:a.png",
    "c:/a.png",
    "file:///etc/passwd",
    "http://host/a.png",
    "a.png:stream",
    "%2e%2e%2fa.png",
    "%2E%2E/a.png",
    "..%2fa.png",
    "..%5ca.png",
    "%252e%252e%252fa.png",
    "%25252e%25252e/a.png",
    "%2fetc%2fpasswd",
    "a%00.png",
    std::string("a\0.png", 6),
    "a\n.png",
    "a\x1b[2J.png",
    "%1b.png",
    "a\xe2\x80\xae.png",
    "\xc0\xae\xc0\xae/a.png",
    "%c0%ae%c0%ae%c0%afa.png",
    ".bashrc",
    ".git/hooks/post-commit",
    "%2ebashrc",
    "con",
    "NUL.png",
    "com1.bin",
    "a/aux.png",
    "a.png.",
    " a.png",
    "a.png ",
    "*",
    std::string(300, 'a') + ".png",
};

}  // namespace

TEST_CASE("companions: what leads nowhere but below is plain") {
  for (const char* name : {"a.png", "a b.bin", "textures/wood.png", "ä/日本.png", "100%.png", "-",
                           "a..b.png", "a.b.c", "100%25.png"})
    CHECK_MESSAGE(isPlainName(name), name);
  for (const std::string& name : kTricks) CHECK_FALSE_MESSAGE(isPlainName(name), name);
}

TEST_CASE("companions: every name given is plain, whatever was asked for, and is there once") {
  CompanionNames names("result.gltf");
  std::set<std::string> given = {"result.gltf"};
  for (const std::string& trick : kTricks) {
    for (const std::string& name :
         {names.nameFor(trick), names.nameForFile(trick), names.nameFor(percentEncoded(trick))}) {
      CHECK_MESSAGE(isPlainName(name), name);
      CHECK_MESSAGE(given.insert(name).second, name);
    }
    CHECK(isPlainName(plainName(trick)));
  }
}

TEST_CASE("companions: names that are plain are kept, and those from above lose their folders") {
  CompanionNames names("result.gltf");
  CHECK(names.nameFor("textures/wood%20floor.png") == "textures/wood floor.png");
  CHECK(names.nameForFile("100%25.mtl") == "100%25.mtl");
  CHECK(names.nameFor("../other/wood.png") == "wood.png");
  CHECK(names.nameFor("..%2Fother%2fMetal.png") == "Metal.png");
  CHECK(names.nameFor("..\\other\\stone.png") == "stone.png");
}

TEST_CASE("companions: a name given before, in any case, gets a number") {
  CompanionNames names("result.gltf");
  CHECK(names.nameFor("a/wood.png") == "a/wood.png");
  CHECK(names.nameFor("A/Wood.png") == "A/Wood-2.png");
  CHECK(names.nameFor("a/wood.png") == "a/wood-3.png");
  CHECK(names.nameFor("../result.gltf") == "result-2.gltf");
  CHECK(names.nameFor("../wood-2") == "wood-2");
  CHECK(names.nameFor("../x/wood") == "wood");
  CHECK(names.nameFor("../y/wood") == "wood-3");  // wood-2 is taken
}

TEST_CASE("companions: a reference leads back to the name") {
  for (const std::string name : {"textures/wood floor.png", "100%.png", "ä#?.png"})
    CHECK(percentDecoded(referenceTo(name)) == name);
  CHECK(referenceTo("a b/c d.png") == "a%20b/c%20d.png");
}
