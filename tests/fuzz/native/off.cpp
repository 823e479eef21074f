// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readOff(Input input) {
  readAndWrite({{"made.off", Bytes(input.begin(), input.end())}, {}}, "made.obj");
}
