// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readGmsh(Input input) {
  readAndWrite({{"made.msh", Bytes(input.begin(), input.end())}, {}}, "made.vtu");
}
