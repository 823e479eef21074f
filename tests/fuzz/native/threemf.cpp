// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readThreemf(Input input) {
  readAndWrite({{"made.3mf", Bytes(input.begin(), input.end())}, {}}, "made.obj");
}
