// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readPly(Input input) {
  readAndWrite({{"made.ply", Bytes(input.begin(), input.end())}, {}}, "made.glb");
}
