// SPDX-License-Identifier: MIT
#include "remesh/quads/map/integer_rows.h"

#include <doctest/doctest.h>

#include "support/soups.h"

using namespace remesher;

TEST_CASE("integer_rows: sums are added term by term, and nothing is left of opposites") {
  CHECK(plus({{0, 1}, {2, 3}}, {{1, 5}, {2, -1}}, 3) == IntegerSum{{0, 1}, {1, 15}});
  CHECK(plus({{4, 2}}, {{4, 1}}, -2).empty());
}

TEST_CASE("integer_rows: whatever the free variables are, all equations hold") {
  soups::Random random(11);
  for (int run = 0; run < 40; ++run) {
    constexpr Index kWhole = 8, kAll = 20;
    IntegerRows rows(kAll, kWhole);
    std::vector<IntegerSum> equations;
    for (int i = 0; i < 9; ++i) {
      IntegerSum equation;
      for (int k = 0; k < 3; ++k)
        equation = plus(equation, {{Index(double(kAll) * random.number()), 1}},
                        random.number() < 0.5 ? 1 : -1);
      if (rows.add(equation)) equations.push_back(equation);
    }
    REQUIRE(equations.size() > 4);
    rows.resolve();
    for (const IntegerSum& equation : equations) CHECK(rows.reduced(equation).empty());
  }
}

TEST_CASE("integer_rows: what is to be whole is named by whole variables alone") {
  IntegerRows rows(4, 2);  // 0 and 1 are to be whole, 2 and 3 need not
  CHECK(rows.add({{0, 1}, {1, 1}, {2, -1}, {3, 1}}));
  CHECK(rows.add({{0, 1}, {1, -1}}));
  rows.resolve();
  for (Index i = 0; i < 2; ++i)
    for (const auto& [variable, coefficient] : rows.reduced({{i, 1}})) CHECK(variable < 2);
}

TEST_CASE("integer_rows: what no variable can be named by is refused") {
  IntegerRows rows(3, 3);
  CHECK_FALSE(rows.add({{0, 2}, {1, 3}}));
  CHECK(rows.add({{0, 2}, {1, 4}, {2, -2}}));  // halved
}
