// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readGlb(Input input) {
  readAndWrite({{"made.glb", Bytes(input.begin(), input.end())}, {}}, "made.obj");
}
