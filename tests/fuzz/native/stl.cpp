// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readStl(Input input) {
  readAndWrite({{"made.stl", Bytes(input.begin(), input.end())}, {}}, "made.off");
}
