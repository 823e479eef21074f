// SPDX-License-Identifier: MIT
#include "base/bracket.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace remesher;

TEST_CASE("bracket: from any number on either side the search ends at the smallest that suffices") {
  for (const double least : {1.0, 2.0, 3.0, 100.0, 997.0, 12345.0})
    for (const double first : {1.0, 50.0, 2000.0}) {
      Bracket bracket;
      int tries = 0;
      for (double next = first; !bracket.isEmpty() && bracket.does != 1;
           next = std::ceil(bracket.next(2))) {
        REQUIRE(++tries < 40);
        (next >= least ? bracket.does : bracket.fails) = next;
        CHECK(!bracket.isWithin(1));
      }
      CHECK(bracket.does == least);
    }
}
