// SPDX-License-Identifier: MIT
#include "base/patience.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

// The number of rounds that follow if each leaves what `next` makes of what there was.
template <class Next>
int roundsFrom(double left, int most, Next next) {
  Prospect prospect(most);
  int rounds = 0;
  for (; prospect.isGood(left); ++rounds) left = next(left);
  return rounds;
}

}  // namespace

TEST_CASE("prospect: as many rounds as are granted follow while the goal stays in reach") {
  CHECK(roundsFrom(100, 10, [](double left) { return left - 10; }) == 10);
  CHECK(roundsFrom(0, 10, [](double left) { return left; }) == 10);
  CHECK(roundsFrom(5, 0, [](double left) { return left; }) == 0);
}

TEST_CASE("prospect: rounds that would leave some at their rate end early") {
  CHECK(roundsFrom(1000, 10, [](double left) { return left - 10; }) == 2);
  CHECK(roundsFrom(1000, 10, [](double left) { return left; }) == 2);
  CHECK(roundsFrom(1000, 10, [](double left) { return left + 1; }) == 2);
}

TEST_CASE("prospect: one round that leaves more than there was does not end them") {
  int round = 0;
  const auto next = [&](double left) { return ++round == 2 ? left + 10 : left - 40; };
  CHECK(roundsFrom(100, 10, next) > 3);
}
