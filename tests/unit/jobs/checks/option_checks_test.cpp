// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include <doctest/doctest.h>

#include "base/error.h"

using namespace remesher;

TEST_CASE("option checks: options that name vertices exclude repair, which makes others") {
  RemeshOptions options;
  options.density = {1, 2, 3};
  CHECK_NOTHROW(checkTogether(options));
  options.repair = Repair::Holes;
  CHECK_THROWS_AS(checkTogether(options), Error);
  options.density.clear();
  CHECK_NOTHROW(checkTogether(options));
  options.featureEdges = {{0, 1}};
  CHECK_THROWS_AS(checkTogether(options), Error);
}
