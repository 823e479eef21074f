// SPDX-License-Identifier: MIT
#include "reading.h"

void remesher::fuzz::readGltf(Input input) {
  auto [text, data] = splitAtZero(input);
  readAndWrite({{"made.gltf", std::move(text)}, {{"made.bin", std::move(data)}}}, "made.ply");
}
