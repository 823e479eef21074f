// SPDX-License-Identifier: MIT
#include "io/model/resources.h"

#include <doctest/doctest.h>

using namespace remesher;
using namespace remesher::io;

TEST_CASE("resources: a file is found by its name, decoded or without its folder") {
  const std::vector<File> files = {
      {"a b.bin", {1}}, {"folder/c.png", {2}}, {"x/d", {3}}, {"y/d", {4}}};
  const Resources resources(files);
  CHECK(resources.find("a b.bin") == &files[0]);
  CHECK(resources.find("a%20b.bin") == &files[0]);
  CHECK(resources.find("textures\\c.png") == &files[1]);
  CHECK(resources.find("y/d") == &files[3]);
  CHECK(resources.find("z/d") == nullptr);  // two could be meant
  CHECK(resources.find("e") == nullptr);
}

TEST_CASE("resources: percent encoding and base64 are undone by decoding") {
  const std::string odd = "ä b/%#?.bin";
  CHECK(percentDecoded(percentEncoded(odd)) == odd);
  CHECK(percentDecoded("100%") == "100%");
  std::vector<std::uint8_t> bytes;
  for (int length = 0; length < 9; ++length) {
    CHECK(decodeDataUri(encodeDataUri("image/png", bytes)) == bytes);
    bytes.push_back(static_cast<std::uint8_t>(251 * length + 7));
  }
}

TEST_CASE("resources: data URIs may be plain text, and may be malformed") {
  CHECK(decodeDataUri("data:,A%20B") == std::vector<std::uint8_t>{'A', ' ', 'B'});
  CHECK_FALSE(decodeDataUri("data:;base64,A*BC").has_value());
  CHECK_FALSE(decodeDataUri("data:nothing").has_value());
  CHECK_FALSE(decodeDataUri("file.bin").has_value());
}
