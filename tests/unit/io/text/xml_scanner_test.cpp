// SPDX-License-Identifier: MIT
#include "io/text/xml_scanner.h"

#include <doctest/doctest.h>

using namespace remesher;
using namespace remesher::io;

TEST_CASE("xml: tags, attributes with entities, text; comments and CDATA are passed over") {
  XmlScanner xml(
      "<?xml version='1.0'?><!DOCTYPE a><!-- <b/> --><p:a x:k = 'a &lt; &#x41;&#66; > b'>in"
      "<![CDATA[<c/>]]></p:a><d e=\"\"/>",
      "t.xml");
  const auto open = xml.next();
  REQUIRE(open);
  CHECK(open->name == "a");
  CHECK(open->get("k") == "a < AB > b");
  CHECK((open->opens && !open->closes));
  CHECK(xml.text() == "in");
  const auto close = xml.next();
  REQUIRE(close);
  CHECK((close->closes && !close->opens));
  const auto empty = xml.next();
  REQUIRE(empty);
  CHECK((empty->closes && empty->opens));
  CHECK(empty->find("e") != nullptr);
  CHECK(empty->find("f") == nullptr);
  CHECK(!xml.next());
}

TEST_CASE("xml: a tag without an end is refused with its line") {
  XmlScanner xml("<a>\n<b c='", "t.xml");
  xml.next();
  try {
    xml.next();
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::ParseError);
    CHECK(std::string(error.what()).find("t.xml, line 2") == 0);
  }
}
