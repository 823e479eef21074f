// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readObj(Input input) {
  auto [text, library] = splitAtZero(input);
  readAndWrite({{"made.obj", std::move(text)}, {{"made.mtl", std::move(library)}}}, "made.glb");
}
