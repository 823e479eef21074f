// SPDX-License-Identifier: MIT
#include "base/phase_clock.h"

#include <doctest/doctest.h>

using namespace remesher;

TEST_CASE("phase_clock: phases come in the order in which they began, each name once") {
  PhaseClock clock;
  for (const char* name : {"read", "adapt", "fit", "adapt", "fit", "write"}) clock.enter(name);
  const std::vector<Phase> phases = clock.finish();
  REQUIRE(phases.size() == 4);
  const char* const names[] = {"read", "adapt", "fit", "write"};
  for (std::size_t i = 0; i < phases.size(); ++i) {
    CHECK(phases[i].name == names[i]);
    CHECK(phases[i].milliseconds >= 0);
  }
}

TEST_CASE("phase_clock: time that passes belongs to the phase it passes in") {
  PhaseClock clock;
  clock.enter("none");
  clock.enter("work");
  volatile double sum = 0;
  for (int i = 0; i < 2000000; ++i) sum = sum + i;
  clock.enter("rest");
  const std::vector<Phase> phases = clock.finish();
  CHECK(phases[1].milliseconds > phases[0].milliseconds);
  CHECK(phases[1].milliseconds > phases[2].milliseconds);
}

TEST_CASE("phase_clock: no phase was entered, none is reported") {
  CHECK(PhaseClock().finish().empty());
}

TEST_CASE("phase_clock: the four times are sums of phases, those of judging left out") {
  const Timings timings = timingsOf({{"read", 1},
                                     {"inspect", 2},
                                     {"build", 4},
                                     {"curves", 8},
                                     {"surface", 16},
                                     {"adapt", 32},
                                     {"fit", 64},
                                     {"measure", 128},
                                     {"write", 256}});
  CHECK(timings.read == 1);
  CHECK(timings.build == 4 + 8 + 16);
  CHECK(timings.remesh == 32 + 64);
  CHECK(timings.write == 256);
}
