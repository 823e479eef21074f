// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readVtu(Input input) {
  readAndWrite({{"made.vtu", Bytes(input.begin(), input.end())}, {}}, "made.msh");
}
